"""`judge list`, `show` and `help`: the katas that there are, one of them, and the manual."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from contextlib import suppress
from itertools import chain
from pathlib import Path
from typing import Any

import click
from msgspec import Struct

from judge import manual
from judge.cli.options import Common, command, opt
from judge.cli.resolve import current, history_at, this_folder
from judge.cli.table import COMMANDS
from judge.errors import ExitCode, ProblemError, StoreError, UsageError, meant, nearest
from judge.manual import Page, SearchHit
from judge.practice.progress import levels_passed, solved, tried
from judge.practice.syllabus import USUAL, Pack, first_sets, read_pack, sound_sets
from judge.problem.find import find_problem, folders_within, listed_problems, problem_roots, shipped_problems
from judge.problem.model import Listed
from judge.report.published_look import Document, KataInFull, KataList, KataRow, KataShown, Mentions, Topics
from judge.report.screen import note
from judge.report.views import copied
from judge.schema import files, schema_of, schema_of_file

_OTHERS = "others"  # the set of the katas that are in none


class ListAsk(Struct, frozen=True):
    """What to list."""

    todo: bool = opt("--todo", "Only the katas that you have not solved.")
    whole: bool = opt("--all", "Every set, or all katas of the SET.")


@command("list", KataRow, ask=ListAsk)
@click.argument("name", metavar="[SET]", required=False)
def list_katas(name: str | None, ask: ListAsk, common: Common) -> KataList:
    """List the katas by set.

    ✓ is solved, ★ the interview level of a kata, ★★ its production level too, > your current kata. Without a
    SET you see the katas of the set you are in.

    Exit status: 0, 2 usage, 3 a kata cannot be read (the others are listed).
    """
    return listed(name, ask, common)


def listed(name: str | None, ask: ListAsk, common: Common) -> KataList:
    """The katas by set, one set open. Raises UsageError for a name that no set has."""
    problems, faults = listed_problems(common.problems, Listed)
    sets, broken = sound_sets(problems, common.problems)
    rows, at = _rows(problems, common.db)
    faults += broken
    for fault in faults:
        note(str(fault), bad=True)
    shelves: dict[str, list[KataRow]] = {}
    taken: dict[str, Path] = {}
    packs: dict[str, str] = {}
    for root in problem_roots(common.problems):  # what is not the judge's own comes first
        own = folders_within([root])
        for each in own:
            if (first := taken.setdefault(each.name, each)) != each:
                note(f"two katas are called {each.name!r}: {first} and {each}; the first is taken")
        if root == shipped_problems():
            continue
        try:
            pack = read_pack(root)
        except ProblemError as fault:
            note(str(fault), bad=True)
            pack = Pack(root.name)
        packs[pack.title] = pack.about or f"The katas in {root}."
        shelves[pack.title] = [rows[each.name] for each in own if each.name in rows]
    about = packs | {each.name: each.about for each in sets} | {_OTHERS: "Katas that are in no set."}
    shelves |= {each.name: [rows[problem.id] for problem in each.problems] for each in sets}
    inside = {row.problem for katas in shelves.values() for row in katas}
    if others := [row for row in rows.values() if row.problem not in inside]:
        shelves[_OTHERS] = others
    if name is not None and name not in shelves:
        raise UsageError(f"There is no set {name!r}", remedy=meant(name, list(shelves)))
    if name != USUAL:
        shelves.pop(USUAL, None)
    named = next(iter(packs), "") if common.problems else ""
    opened = named or _opened({**{key: shelves[key] for key in shelves if key not in packs}, **shelves}, at)
    shown = name or ("" if common.json or ask.whole else opened)
    status = ExitCode.FAULT if faults else ExitCode.ACCEPTED
    every = [*rows.values()]
    firsts = first_sets(sets)
    return KataList(every, shelves, shown, about.get(shown, ""), at, ask.todo, ask.whole, firsts, status)


def _rows(problems: Sequence[Listed], db: Path | None) -> tuple[dict[str, KataRow], str]:
    """Each problem's row, and the current kata; a history that cannot be read counts as empty."""
    try:
        with history_at(db, reading=True) as history:
            runs, taken_up = history.runs(), current(this_folder(), history)
    except StoreError as fault:
        note(str(fault))
        runs, taken_up = [], None
    done, own = solved(runs), tried(runs)
    rows = {
        each.id: copied(
            KataRow,
            each,
            problem=each.id,
            solved=each.id in done,
            stars=len(levels_passed(each, own.get(each.id, ()))),
        )
        for each in problems
    }
    return rows, taken_up.problem if taken_up else ""


def _opened(sets: Mapping[str, Sequence[KataRow]], at: str) -> str:
    """The set of the current kata; failing that, the first with something to do; "" where there is none."""
    current = (name for name, katas in sets.items() if at in [row.problem for row in katas])
    todo = (name for name, katas in sets.items() if not all(row.solved for row in katas))
    return next(chain(current, todo, sets), "")


class ShowAsk(Struct, frozen=True):
    """What to show of a kata."""

    groups: bool = opt("--groups", "What each test group tests, and the mistakes that it finds.")


@command("show", KataInFull, ask=ShowAsk)
@click.argument("name", metavar="KATA")
def show(name: str, ask: ShowAsk, common: Common) -> KataShown:
    """Show a kata: its statement, its examples and what it allows.

    With --groups you see its test groups instead, each with the names of the mistakes that it finds.
    """
    return KataShown(find_problem(name, common.problems), ask.groups)


class HelpAsk(Struct, frozen=True):
    """What to read, besides the manual."""

    schema: str | None = opt("--schema COMMAND", "The JSON Schema of what it writes with --json.")


@command("help", Page, SearchHit, ask=HelpAsk)
@click.argument("words", metavar="[TOPIC|WORDS]...", nargs=-1)
@click.pass_context
def read(context: click.Context, words: tuple[str, ...], ask: HelpAsk, common: Common) -> Struct:
    """Read the manual, or search it.

    Without words you see its topics. Words that name no topic and no command are searched for. A page that is
    longer than the terminal is shown by your pager ($PAGER); into a pipe it goes as Markdown.

    Exit status: 0, 1 no page has the words, 2 usage.
    """
    app: Any = context.find_root().command
    if ask.schema is not None:
        return _schema(app, ask.schema)
    if not words:
        return Topics(manual.pages())
    name = "-".join(words).lower()
    with suppress(KeyError):
        page = manual.page(name)
        return Document(page.text, (page,), paged=True)
    if name in COMMANDS and not common.json:
        made = app.get_command(None, name)
        with click.Context(made, info_name=f"judge {name}", **app.context_settings) as shown:
            return Document(made.get_help(shown), ())
    near = nearest(name, [*manual.topics(), *COMMANDS]) or ""
    return Mentions(" ".join(words), manual.search(words), near)


def _schema(app: Any, name: str) -> Document:
    """The schema of a command's JSON, or of a file that a setter writes. Raises UsageError."""
    if name in files():
        schema = schema_of_file(name)
    elif name in COMMANDS:
        schema = schema_of(app.get_command(None, name))
    else:
        near = nearest(name, [*COMMANDS, *files()])
        remedy = f"did you mean {near}?" if near else f"name a command, or {' or '.join(files())}"
        raise UsageError(f"There is no schema of {name!r}", remedy=remedy)
    return Document("", (schema,), plain=json.dumps(schema, indent=2) + "\n")

"""`judge list` and `judge show`: the katas that there are, and one of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import chain
from pathlib import Path

import click
from msgspec import Struct

from judge.cli.files import opened_in_browser
from judge.cli.options import Common, command, opt
from judge.cli.resolve import current, history_at, this_folder
from judge.errors import ExitCode, ProblemError, StoreError, UsageError
from judge.practice.progress import levels_passed, solved, tried
from judge.practice.syllabus import USUAL, Pack, first_sets, read_pack, sound_sets
from judge.problem.find import find_problem, folders_within, listed_problems, problem_roots, shipped_problems
from judge.problem.model import Listed
from judge.report.published_look import KataInFull, KataList, KataRow, KataShown
from judge.report.screen import note
from judge.report.views import copied
from judge.report.words import shown_name

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
        from judge.errors import meant  # hardly ever

        raise UsageError(f"There is no set {name!r}", remedy=meant(name, list(shelves)))
    if name != USUAL:
        shelves.pop(USUAL, None)
    shown = name or ("" if common.json or ask.whole else next(iter(packs), "") or _opened(shelves, at))
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
    opened: bool = opt("--open", "Open the statement's figure in the browser.")


@command("show", KataInFull, ask=ShowAsk)
@click.argument("name", metavar="KATA")
def show(name: str, ask: ShowAsk, common: Common) -> KataShown:
    """Show a kata: its statement, its examples and what it allows.

    With --groups you see its test groups instead, each with the names of the mistakes that it finds.
    """
    problem = find_problem(name, common.problems)
    if ask.opened:
        figure = problem.folder / "figure.svg"
        if not figure.is_file():
            remedy = f"leave out --open: judge show {problem.id}"
            raise UsageError(f"{problem.id} has no figure", remedy=remedy)
        if not opened_in_browser(str(figure)):
            note(f"No browser here. Open {shown_name(str(figure))}")
    return KataShown(problem, ask.groups)

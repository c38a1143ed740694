"""The screens of `judge try` and `judge hack`: a case and what a file answers; wrong programs to break."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from itertools import islice
from typing import Any

from rich.console import Group, RenderableType

from judge.data.parse import call_of, line_of
from judge.drawing import Picture
from judge.drawing.braille import LEAST_ROWS
from judge.problem import Verdict
from judge.problem.find import typed
from judge.problem.formats import input_of
from judge.problem.transcripts import typed_lines
from judge.report.entry import entry_text
from judge.report.parts import (
    Cell,
    bad,
    blocks,
    commands,
    facts,
    good,
    head,
    indented,
    joined,
    label,
    text,
    under,
)
from judge.report.picture import case_picture, has_room, made, picture_rows
from judge.report.published_cases import CaseTried, HackTurn, PageWritten
from judge.report.screen import Screen, drawn
from judge.report.words import arguments, counted, shown_name
from judge.run.result import EntryKind, Failure
from judge.run.tried import OneCase
from judge.values import show
from judge.values.answers import Target
from judge.values.atoms import RealType, Type
from judge.values.letters import texts_of
from judge.values.types import Composite, lasting

_MOST = 12  # numbers whose interval is shown
_PRINTED = 10  # lines
_ANSWERS = 3  # of several that are right, which are shown


def case_tried(found: CaseTried, screen: Screen) -> RenderableType:
    """The case in both forms and its answer, the picture, and the verdict on the file's answer."""
    tried, said = found.tried, found.tried.said
    if said is None:
        return _fitted(tried, head(tried.problem.id, tried.problem.title), None, screen)
    above = joined(
        label(said.verdict), f"  {said.verdict.meaning.capitalize()}  {shown_name(said.submission)}"
    )
    last = joined(label(said.verdict), f"  this case {'fails' if tried.failed else 'passes'}")
    return _fitted(tried, above, last, screen)


def page_written(found: PageWritten, _screen: Screen) -> RenderableType:
    """What was written, and of which kata."""
    return text(f"Wrote {shown_name(found.file)}: {found.problem}")


def _fitted(
    tried: OneCase, above: RenderableType | None, below: RenderableType | None, screen: Screen
) -> RenderableType:
    """The case between what is above and below it, with its picture; on a low screen less is said of it."""
    found = made(partial(picture_of, tried), "the case")
    picture = partial(picture_rows, found, screen) if found and has_room(screen) else None
    fit: list[RenderableType] = []
    for brief in (False, True):
        middle = indented(facts(_facts(tried, getattr(found, "why", ""), brief)))
        laid = blocks(above, middle, below)
        rows = (screen.rows or 0) - drawn(laid, screen).count("\n")
        if picture is not None and rows - 2 >= LEAST_ROWS:  # an empty one, the prompt
            return blocks(above, middle, Group(*picture(rows - 2)), below)
        fit += [laid] if rows > 0 or not screen.rows else []
    return fit[0] if fit else laid


def _facts(tried: OneCase, why: str, brief: bool) -> Iterator[tuple[Cell, Cell]]:
    """What is known of the case; `why` is what it turns on, and `brief` leaves out its other forms."""
    problem, said = tried.problem, tried.said
    if tried.case:
        plain = arguments(problem.named(tried.case))
        yield from under("case", typed_lines(problem, tried.case) if problem.methods else [plain])
    if tried.case and not brief and not (problem.methods or problem.talks):
        own = tried.module.format
        given = input_of(problem, own, tried.case).rstrip() if own else line_of(problem, tried.case)
        yield from under("as program input", given.split("\n"))
    as_given = problem.methods or texts_of(problem.answer) or "{" in problem.answer.text
    shown = tried.expected if as_given else _plain(show.exact_text(tried.exact))
    if not problem.talks:
        yield "exact answer", good(shown)
    ends = list(islice(_intervals(problem.answer, tried.target), _MOST + 1))
    if ends and not brief:
        yield "in doubles", good(tried.expected)
        more = ["and so on for the other numbers"] if len(ends) > _MOST else []
        yield from under("accepted", ends[:_MOST] + more)
    if said is None:
        why = tried.no_case or why
        yield from [("why", why)] if why else []
        return
    if not problem.talks:
        yield "got", (bad if tried.failed else text)(said.got)
    if said.hurdle is not None:
        line = said.hurdle.line if said.hurdle.kind in (EntryKind.ARITY, EntryKind.MODULE) else 0
        why = entry_text(said.hurdle, problem, said.submission, said.verdict, said.message)
        yield "why", f"{f'line {line}: ' if line else ''}{why}"
    elif said.message or why:
        yield "why", said.message or why
    if problem.talks:
        yield from under("dialogue", said.printed.splitlines())
    else:
        yield from under("printed", said.printed.splitlines()[:_PRINTED])


def _intervals(type_: Type, target: Target, place: str = "") -> Iterator[str]:
    """Every real number's place in the answer, with the least and the greatest that is accepted there."""
    inner = lasting(type_)
    if type(target) is dict:
        several = target.get("any", [])  # other orders of a list have the same ends
        for each in several[:1] if isinstance(inner, Composite) else several:
            yield from _intervals(type_, each, place)
    elif isinstance(inner, Composite):
        for at, (part, each) in enumerate(inner.pairs(target) if target is not None else ()):
            yield from _intervals(part, each, f"{place}[{at}]")
    elif isinstance(inner, RealType) and target is not None:
        yield f"{f'{place}  ' if place else ''}{target[0]!r} to {target[1]!r}"


def _plain(exact: Any) -> str:
    """An exact answer as it would be written in Python, its numbers in up to 40 digits."""
    if isinstance(exact, dict):
        if "such as" in exact:
            return f"such as {_plain(exact['such as'])}"
        answers = exact["any"]
        deep = isinstance(answers[0], list) and isinstance(next(iter(answers[0]), None), list)
        most = 1 if deep else _ANSWERS
        return " or ".join([*map(_plain, answers[:most]), *["…"] * (len(answers) > most)])
    if isinstance(exact, list):
        listed = ", ".join(map(_plain, exact))
        is_point = 2 <= len(exact) <= 3 and all(isinstance(each, str) for each in exact)
        return f"({listed})" if is_point else f"[{listed}]"
    return str(exact)


def picture_of(tried: OneCase) -> Picture | None:
    """The case drawn with its answer and, where that is rejected, the file's; None where nothing can be."""
    got, given = (tried.failed.got, tried.failed.given) if tried.failed else (None, None)
    values = tried.problem.named(tried.case)
    case = Failure("", input=values, expected=tried.expected, got=got, given=given)
    return case_picture(tried.problem, tried.module, case, tried.group.name)


def hack_turn(found: HackTurn, screen: Screen) -> RenderableType:
    """The program and what is asked; or whether a case breaks it."""
    if found.outcome == "shown":
        return _program(found)
    ended = _ended(found)
    return _fitted(found.tried, None, ended, screen) if found.tried else ended


def _program(found: HackTurn) -> RenderableType:
    name, number = found.problem.id, found.puzzle.number
    aside = f"wrong program {number} of {len(found.puzzles)}, {found.done} broken"
    rows = map(text, found.puzzle.source.decode().splitlines())
    asked = text("This program is wrong for at least one valid input. Find one:")
    command = text(f'  judge hack {typed(found.problem)} {number} "{call_of(found.problem)}"')
    more = f"All are broken. {found.more} more: judge hack {typed(found.problem)} --all"
    ended = text(more) if found.more and not found.following else None
    return blocks(head(name, aside), Group(*rows), Group(asked, command), ended)


def _ended(found: HackTurn) -> RenderableType:
    """The mistake, once it may be named, and what came of the case."""
    name, puzzle = found.problem.id, found.puzzle
    if found.outcome == "lost":
        lost = facts([(label(Verdict.WA, "LOST"), found.why)])
        again = f"judge hack {typed(found.problem)} {puzzle.number}"
        more = [(again, "shows the program again"), (f"{again} --give-up", "names the mistake")]
        return lost if found.goes_on else blocks(lost, indented(commands(more)))
    mistake = Group(indented(bad(puzzle.mistake)), indented(text(puzzle.advice), 4))
    if found.outcome == "given-up":
        return mistake
    said = f"broken, {found.done} of {counted(len(found.puzzles), 'program')} of {name}"
    if found.following:
        said += f"; next: judge hack {typed(found.problem)} {found.following.number}"
    elif found.more:
        said += f"; {found.more} more: judge hack {typed(found.problem)} --all"
    return blocks(mistake, facts([(label(Verdict.AC, "WON"), said)]))

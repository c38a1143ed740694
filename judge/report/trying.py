"""The screen of `judge try`: a case, its exact answer, what is accepted, and what a file answered."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import islice
from typing import Any

from rich.console import Group, RenderableType
from rich.text import Text

from judge.data.parse import line_of
from judge.drawing.braille import LEAST_ROWS, to_braille
from judge.drawing.shapes import Picture, Role
from judge.errors import told
from judge.problem import Verdict
from judge.problem.declare import Shown
from judge.report.parts import BAD, FAINT, GOOD, STRONG, Cell, facts, indented, joined, text, verdict
from judge.report.picture import has_room
from judge.report.published_cases import CaseTried, PageWritten
from judge.report.screen import Screen, drawn, note
from judge.report.tell import obstacle_text
from judge.report.words import arguments, shown_name
from judge.run.result import Failure, Obstacle, Result
from judge.run.tried import Said, Tried
from judge.values import show

Interval = tuple[str, float, float]  # a number's place in the answer, and the least and greatest accepted

_MOST = 12  # numbers whose interval is shown
_ANSWERS = 3  # of several that are right, which are shown
_COLOURS = {Role.WANTED: GOOD, Role.GOT: BAD, Role.CASE: STRONG, Role.BEYOND: FAINT}


def case_tried(found: CaseTried, screen: Screen) -> RenderableType:
    """The case in both forms and its answer, the picture, and the verdict on the file's answer."""
    tried, said = found.tried, found.said
    head = joined(text(tried.problem.id, STRONG), f"  {tried.problem.title}")
    if said is None:
        return fitted(tried, said, "your case", [head, Text()], [], screen)
    head = joined(verdict(said.verdict), f"  {shown_name(said.name)}")
    ended = "this case passes" if said.verdict is Verdict.AC else "this case fails"
    colour = GOOD if said.verdict is Verdict.AC else BAD
    last = joined(text(said.verdict.value, f"{STRONG} {colour}"), f"  {ended}")
    return fitted(tried, said, "your case", [head, Text()], [Text(), last], screen)


def page_written(found: PageWritten, _screen: Screen) -> RenderableType:
    """What was written, and of which kata."""
    return text(f"Wrote {shown_name(found.file)}: {found.problem}")


def fitted(
    tried: Tried,
    said: Said | None,
    heading: str,
    above: list[RenderableType],
    below: list[RenderableType],
    screen: Screen,
) -> RenderableType:
    """The case between what is above and below it, with its picture; on a low screen less is said of it."""
    picture = _picture(tried, said, heading, screen)
    whole, short = ([*above, indented(facts(_facts(tried, said, brief))), *below] for brief in (False, True))
    for parts in (whole, short):
        rows = (screen.rows or 0) - drawn(Group(*parts), screen).count("\n") - 2  # an empty one, the prompt
        if picture is not None and rows >= LEAST_ROWS:
            rest = [Text(), *below] if below and below[0] != Text() else below
            return Group(*parts[: len(above) + 1], Text(), _braille(picture, rows), *rest)
    too_long = screen.rows and drawn(Group(*whole), screen).count("\n") >= screen.rows
    return Group(*(short if too_long else whole))


def _facts(tried: Tried, said: Said | None, brief: bool) -> Iterator[tuple[Cell, Cell]]:
    """What is known of the case; `brief` leaves out its other forms and what is accepted."""
    problem = tried.problem
    exact = show.exact_text(tried.exact)
    ends = list(islice(_intervals(exact, show.accepted(problem.answer, tried.target), ""), _MOST + 1))
    if tried.case:
        yield "case", arguments(problem.named(tried.case))
    if tried.case and not brief:
        yield "as program input", line_of(problem, tried.case)
    yield "exact answer", text(_plain(exact), GOOD)
    if ends and not brief:
        yield "in doubles", text(tried.expected, GOOD)
        rows = [f"{f'{place}  ' if place else ''}{low!r} to {high!r}" for place, low, high in ends[:_MOST]]
        rows += ["and so on for the other numbers"] if len(ends) > _MOST else []
        yield from zip(("accepted", *[""] * len(rows)), rows, strict=False)
    if said is None:
        return
    yield "got", text(said.got, "" if said.verdict is Verdict.AC else BAD)
    if said.hurdle is not None:
        result = Result(
            problem=problem.id,
            submission=said.name,
            verdict=said.verdict,
            failure=Failure(said.message),
        )
        line = said.hurdle.line if said.hurdle.kind is not Obstacle.STUB else 0  # whose sentence has it
        yield "why", f"{f'line {line}: ' if line else ''}{obstacle_text(result, said.hurdle, problem)}"
    elif said.message:
        yield "why", said.message
    yield from zip(("printed", *[""] * 9), said.printed.splitlines(), strict=False)


def _intervals(exact: Any, accepted: Any, place: str) -> Iterator[Interval]:
    """Every real number's place and ends; an exact one is decimal text, and its ends are a pair."""
    if isinstance(exact, str):
        if isinstance(accepted, list) and len(accepted) == 2:
            yield place, accepted[0], accepted[1]
    elif isinstance(exact, dict) and isinstance(accepted, dict):
        if "any" in exact and "any" in accepted:  # those of the first; other orders have the same
            several, ends = exact["any"], accepted["any"]
            if isinstance(several[0], list):
                yield from _intervals(several[0], ends[0], place)
            else:
                yield from _intervals(several, ends, f"{place} or ")
    elif isinstance(exact, list) and isinstance(accepted, list):
        for at, (one, ends) in enumerate(zip(exact, accepted, strict=True)):
            yield from _intervals(one, ends, f"{place}[{at}]")


def _plain(exact: Any) -> str:
    """An exact answer as it would be written in Python, its numbers in up to 40 digits."""
    if isinstance(exact, dict):
        if "such as" in exact:
            return f"such as {_plain(exact['such as'])}"
        answers = exact["any"]
        most = (
            1 if isinstance(answers[0], list) and isinstance(next(iter(answers[0]), None), list) else _ANSWERS
        )
        return " or ".join([*map(_plain, answers[:most]), *["…"] * (len(answers) > most)])
    if isinstance(exact, list):
        point = 2 <= len(exact) <= 3 and all(isinstance(each, str) for each in exact)
        return f"({_listed(exact)})" if point else f"[{_listed(exact)}]"
    return str(exact)


def _listed(parts: Iterable[Any]) -> str:
    return ", ".join(map(_plain, parts))


def _picture(tried: Tried, said: Said | None, heading: str, screen: Screen) -> Picture | None:
    """The picture, where the screen has room for one."""
    if not has_room(screen):
        return None
    try:
        return picture_of(tried, said, heading)
    except Exception as fault:  # the answer is known, and worth more
        note(f"the case is not drawn: {told(fault)}")
        return None


def picture_of(tried: Tried, said: Said | None, heading: str) -> Picture | None:
    """The case drawn with its answer and, where that is rejected, the file's; None where nothing can be."""
    draw = tried.data.module.hooks.picture
    if draw is None:
        return None
    wrong = said if said is not None and said.verdict is not Verdict.AC else None
    got, given = (wrong.got, wrong.given) if wrong else (None, None)
    values = tried.problem.named(tried.case)
    return draw(Shown(tried.problem, values, tried.exact, tried.expected, got, given, heading))


def _braille(picture: Picture, rows: int) -> RenderableType:
    lines = (
        Text.assemble(*((piece.text, _COLOURS.get(piece.role, "")) for piece in row))  # type: ignore[arg-type]
        for row in to_braille(picture, rows)
    )
    return Text("\n").join(lines)

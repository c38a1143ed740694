"""A case of a person's own for the screen: the exact answer, what is accepted, what a file says of it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice
from typing import Any

from judge.data.given import line_of
from judge.problem import Verdict
from judge.report.layout import Line, Span, Style, beside, hanging, line
from judge.report.names import shown_name
from judge.report.results import verdict_span
from judge.report.values import arguments
from judge.run.tried import Said, Tried
from judge.values import show

Interval = tuple[str, float, float]  # a number's place in the answer, and the least and greatest accepted

_LABELS = 14  # the column where what follows a label begins
_MOST = 12  # numbers whose interval is shown


def tried_lines(tried: Tried, width: int | None) -> Iterator[Line]:
    """The case in both forms, its exact answer, the nearest doubles, and from where to where one may be."""
    problem = tried.problem
    yield from beside(Span(problem.id, Style.STRONG), problem.title, width)
    yield line()
    exact = show.exact_text(problem.answer, tried.exact)
    intervals = list(islice(_intervals(exact, show.accepted(problem.answer, tried.target), ""), _MOST + 1))
    rows = [
        ("input", arguments(problem.named(tried.case)), Style.PLAIN),
        ("as a line", line_of(problem, tried.case), Style.PLAIN),
        ("exact", _plain(exact), Style.GOOD),
    ]
    if intervals:
        rows.append(("in doubles", tried.wanted, Style.GOOD))
    for label, text, style in rows:
        yield from _labelled(label, text, width, style)
    yield from _accepted_lines(intervals, width)


def said_lines(said: Said, name: str, width: int | None) -> Iterator[Line]:
    """What the file says of it; the verdict is last."""
    yield from _labelled("got", said.got, width, Style.PLAIN if said.verdict is Verdict.AC else Style.BAD)
    if said.message:
        yield from _labelled("why", said.message, width)
    yield line()
    label = verdict_span(said.verdict)
    text = f"{said.verdict.meaning}, {shown_name(name)}"
    yield from hanging(label, Span(text), width, indent=0, column=len(label.text) + 2)


def _accepted_lines(intervals: Sequence[Interval], width: int | None) -> Iterator[Line]:
    """A row for each real number of the answer: its place in the answer, and the ends of its interval."""
    label = "accepted"
    for place, low, high in intervals[:_MOST]:
        where = f"{place}  " if place else ""
        yield from _labelled(label, f"{where}{low!r} to {high!r}", width)
        label = ""
    if len(intervals) > _MOST:
        yield from _labelled("", "and so on for the other numbers", width)


def _intervals(exact: Any, accepted: Any, place: str) -> Iterator[Interval]:
    """Every real number's place and ends; an exact one is decimal text, and its ends are a pair."""
    if isinstance(exact, str):
        if isinstance(accepted, list) and len(accepted) == 2:
            yield place, accepted[0], accepted[1]
    elif isinstance(exact, dict) and isinstance(accepted, dict):
        if "enclosed" in exact:
            yield f"{place}[0]".strip(), float("-inf"), accepted["lo"]
            yield f"{place}[1]".strip(), accepted["hi"], float("inf")
        for key in ("run", "any"):
            if key in exact and key in accepted:
                yield from _intervals(exact[key], accepted[key], f"{place}{' or ' if key == 'any' else ''}")
    elif isinstance(exact, list) and isinstance(accepted, list):
        for at, (one, ends) in enumerate(zip(exact, accepted, strict=True)):
            yield from _intervals(one, ends, f"{place}[{at}]")


def _plain(exact: Any) -> str:
    """An exact answer as it would be written in Python, its numbers in up to 40 digits."""
    if isinstance(exact, dict):
        if "enclosed" in exact:
            return f"{exact['enclosed']}, enclosed within {exact['width']}"
        if "such as" in exact:
            return f"such as {_plain(exact['such as'])}"
        if "any" in exact:
            return " or ".join(map(_plain, exact["any"]))
        return f"{', '.join(map(_plain, exact['run']))} (in any order)"
    if isinstance(exact, list):
        inner = ", ".join(map(_plain, exact))
        point = 2 <= len(exact) <= 3 and all(isinstance(each, str) for each in exact)
        return f"({inner})" if point else f"[{inner}]"
    return str(exact)


def _labelled(label: str, text: str, width: int | None, style: Style = Style.PLAIN) -> list[Line]:
    return hanging(Span(label, Style.FAINT), Span(text, style), width, indent=2, column=_LABELS)

"""Reading hints.md: the hints to a problem, one step after another, from a nudge to nearly everything.

    # Anything                  a title, which nobody is shown
    ## What stays the same      the first step
    Its text, in Markdown.
    ## …                        the next one

Placeholders are those of the statement.
"""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct

from judge.errors import ProblemError
from judge.problem.load import words_beside
from judge.problem.model import Problem
from judge.problem.statement import filled
from judge.problem.text import read_text

HINTS = "hints.md"
_STEP = "## "


class Hint(Struct, frozen=True):
    """One step; `number` counts from 1."""

    number: int
    title: str
    text: str


def read_hints(problem: Problem) -> tuple[Hint, ...]:
    """The steps of a problem; none where there is no hints.md.

    Raises:
        ProblemError: the file is there and wrong.
    """
    path = problem.folder / HINTS
    if not path.exists():
        return ()
    name = f"{problem.id}/{HINTS}"
    words = words_beside(problem.folder)
    lines = [
        filled(line, words, f"{name}:{number}")
        for number, line in enumerate(read_text(path).splitlines(), start=1)
    ]
    starts = list(_steps(lines))
    _check_head(lines[: starts[0]] if starts else lines, name)
    if not starts:
        raise ProblemError("it has no step", where=name, remedy="begin each with a line '## Its title'")
    ends = [*starts[1:], len(lines)]
    return tuple(
        _hint(number, lines[start:end], f"{name}:{start + 1}")
        for number, (start, end) in enumerate(zip(starts, ends, strict=True), start=1)
    )


def _steps(lines: list[str]) -> Iterator[int]:
    """Where steps begin; a comment in a code block is none."""
    fenced = False
    for at, line in enumerate(lines):
        if line.startswith("```"):
            fenced = not fenced
        elif not fenced and f"{line} ".startswith(_STEP):
            yield at


def _check_head(lines: list[str], name: str) -> None:
    for number, line in enumerate(lines, start=1):
        if line.strip() and not line.startswith("# "):
            what = "this text belongs to no step"
            raise ProblemError(what, where=f"{name}:{number}", remedy="put a line '## Its title' above it")


def _hint(number: int, lines: list[str], where: str) -> Hint:
    title, text = lines[0][len(_STEP) :].strip(), "\n".join(lines[1:]).strip("\n")
    if not title:
        raise ProblemError("the step has no title", where=where, remedy="write '## Its title'")
    if not text.strip():
        raise ProblemError(f"the step {title!r} says nothing", where=where, remedy="write it, or remove it")
    return Hint(number, title, text)

"""Katas for the screen: one that was taken up, the next one, what comes after an accepted submission."""

from __future__ import annotations

from collections.abc import Iterator

from judge.problem import Problem
from judge.report.layout import Line, Span, Style, beside, hanging, line
from judge.report.names import shown_name
from judge.report.screen import Screen, is_terminal
from judge.report.values import counted

_ROOM = 12  # columns that a sentence wants beside a command


def pointer_lines(problem: str, screen: Screen) -> list[Line]:
    """After an accepted submission, on a terminal: where to go from there."""
    if not is_terminal(screen.stream):
        return []
    text = f"judge solution {problem} explains a model solution, judge next goes on"
    return hanging(Span("then", Style.FAINT), Span(text), screen.width, indent=2, column=8)


def writing_lines(problem: Problem, file: str, width: int | None) -> list[Line]:
    """Which file is about to be written, said before that is done."""
    text = f"Writing {shown_name(file)}, which is not there yet: the stub of {problem.id}."
    return [*hanging(Span(""), Span(text, Style.FAINT), width, indent=0, column=0), line()]


def begun_lines(problem: Problem, file: str, width: int | None) -> Iterator[Line]:
    """A kata whose stub was written, or that is there already, and the commands to go on with."""
    yield from beside(
        Span(shown_name(file), Style.STRONG), f"{problem.id}: {problem.title}, {problem.tier.value}", width
    )
    yield line()
    yield from command_lines(
        {
            "judge watch": "judges it on every save",
            "judge run": "judges it once",
            "judge hint": "gives the next hint",
            f"judge show {problem.id}": "shows the statement",
        },
        width,
    )


def waiting_lines(due: int, width: int | None) -> Iterator[Line]:
    """That cards are due, beside a kata."""
    if due:
        yield line()
        text = f"{counted(due, 'card')} {'is' if due == 1 else 'are'} due: judge quiz"
        yield from hanging(Span(""), Span(text, Style.FAINT), width, indent=0, column=0)


def next_lines(problem: Problem, width: int | None) -> Iterator[Line]:
    """The kata that is next, whose file is still to be written."""
    head = f"{problem.id}: {problem.title}"
    yield from beside(Span(head, Style.STRONG), problem.tier.value, width)
    yield from hanging(Span(""), Span(problem.summary), width, indent=2, column=2)
    yield line()
    commands = {
        f"judge init {problem.id}": "writes its file, to begin with",
        f"judge show {problem.id}": "shows the statement",
    }
    yield from command_lines(commands, width)


def finished_lines(width: int | None) -> list[Line]:
    """There is no next kata."""
    text = "Every other kata of the path is passed. 'judge progress --due' says what to do again."
    return hanging(Span(""), Span(text, Style.GOOD), width, indent=0, column=0)


def command_lines(commands: dict[str, str], width: int | None) -> Iterator[Line]:
    """Commands, each with what it does: beside it, or below it where there is no room."""
    column = 2 + max(map(len, commands)) + 2
    for command, about in commands.items():
        if width is not None and width - column < _ROOM:
            yield line("  ", Span(command))
            yield from hanging(Span(""), Span(about, Style.FAINT), width, indent=4, column=4)
        else:
            yield from hanging(Span(command), Span(about, Style.FAINT), width, indent=2, column=column)

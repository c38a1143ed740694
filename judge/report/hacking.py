"""Wrong programs that a person is to break, for the screen: the source, what came of a case, the list."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from judge.data.given import call_of, line_of
from judge.kata.hacks import HackShare, HackState
from judge.mistakes.puzzles import Puzzle
from judge.problem import Problem
from judge.report.layout import Cell, Column, Line, Span, Style, Table, beside, hanging, line, wrap
from judge.report.values import arguments, counted
from judge.run.tried import Said, Tried

_LABELS = 14  # the column where what follows a label begins, as in `judge try`
_SAID = {
    HackState.BROKEN: Span("broken", Style.GOOD),
    HackState.GIVEN_UP: Span("given up", Style.FAINT),
    HackState.OPEN: Span("open"),
}


def puzzle_lines(
    problem: Problem, puzzle: Puzzle, standing: tuple[int, int], width: int | None
) -> Iterator[Line]:
    """The program, whose lines are never broken, and what is asked; `standing` is how many of how many
    are broken.
    """
    done, programs = standing
    aside = f"wrong program {puzzle.number} of {programs}, {done} broken"
    yield from beside(Span(problem.id, Style.STRONG), aside, width)
    yield line()
    for row in puzzle.source.decode().splitlines():
        yield line(Span(row))
    yield line()
    text = "It answers some case wrongly. Give one that keeps the statement's bounds and promise:"
    yield from _prose(text, width)
    yield line(f'  judge hack {problem.id} {puzzle.number} "{call_of(problem)}"')


def answer_lines(tried: Tried, said: Said, width: int | None) -> Iterator[Line]:
    """The case, the exact answer and the program's."""
    problem = tried.problem
    rows = [
        ("input", arguments(problem.named(tried.case)), Style.PLAIN),
        ("as a line", line_of(problem, tried.case), Style.PLAIN),
        ("wanted", tried.wanted, Style.GOOD),
        ("got", said.got, Style.PLAIN if not said.message else Style.BAD),
    ]
    for label, text, style in rows:
        yield from hanging(Span(label, Style.FAINT), Span(text, style), width, indent=2, column=_LABELS)
    if said.message:
        yield from hanging(Span("why", Style.FAINT), Span(said.message), width, indent=2, column=_LABELS)


def won_lines(
    problem: Problem, puzzle: Puzzle, standing: tuple[int, int], following: Puzzle | None, width: int | None
) -> Iterator[Line]:
    """That it is broken, its mistake's name and what is said of it, and how many are."""
    done, programs = standing
    yield from told_lines(puzzle, width)
    text = f"broken, {done} of {counted(programs, 'program')} of {problem.id}"
    if following is not None:
        text += f"; next: judge hack {problem.id} {following.number}"
    yield line()
    yield from hanging(Span("WON", Style.GOOD), Span(text), width, indent=0, column=5)


def told_lines(puzzle: Puzzle, width: int | None) -> Iterator[Line]:
    """The mistake's name, and what is wrong."""
    yield line("  ", Span(puzzle.mistake, Style.BAD))
    for row in wrap(puzzle.advice, None if width is None else width - 4):
        yield line(f"    {row}")


def lost_lines(why: str, problem: Problem, puzzle: Puzzle, width: int | None) -> Iterator[Line]:
    """Why the case does not break it, and what may help."""
    text = f"not broken: {why}"
    yield from hanging(Span("LOST", Style.BAD), Span(text), width, indent=0, column=6)
    more = f"judge hack {problem.id} {puzzle.number} shows it again, with --give-up a case and its name"
    yield from hanging(Span("more", Style.FAINT), Span(more), width, indent=2, column=_LABELS)


def list_lines(
    problem: Problem, puzzles: Sequence[Puzzle], states: Mapping[str, HackState], width: int | None
) -> Iterator[Line]:
    """A row for each program that was broken or given up, with its mistake; the open ones by number."""
    done = sum(state is HackState.BROKEN for state in states.values())
    yield from beside(
        Span(problem.id, Style.STRONG), f"{done} of {len(puzzles)} wrong programs broken", width
    )
    yield line()
    told = [puzzle for puzzle in puzzles if states[puzzle.mistake] is not HackState.OPEN]
    rows: list[list[Cell]] = [
        [str(puzzle.number), _SAID[states[puzzle.mistake]], Span(puzzle.mistake, Style.FAINT)]
        for puzzle in told
    ]
    columns = (Column("program", right=True), Column("state"), Column("mistake", flexible=True))
    if rows:
        yield from Table(columns, rows).lines(width)
        yield line()
    left = [puzzle.number for puzzle in puzzles if states[puzzle.mistake] is HackState.OPEN]
    if left:
        yield from hanging(Span("open", Style.FAINT), Span(_runs(left)), width, indent=2, column=8)
        text = f"judge hack {problem.id} {left[0]} shows the first of them"
        yield from hanging(Span("next", Style.FAINT), Span(text), width, indent=2, column=8)


def _runs(numbers: Sequence[int]) -> str:
    """`1, 3 to 8, 10`: whole numbers in their order, those in a row told by the first and the last."""
    runs: list[list[int]] = []
    for number in numbers:
        if runs and number == runs[-1][-1] + 1:
            runs[-1].append(number)
        else:
            runs.append([number])
    said = (f"{run[0]} to {run[-1]}" if len(run) > 2 else ", ".join(map(str, run)) for run in runs)
    return ", ".join(said)


def share_lines(shares: Sequence[HackShare], width: int | None) -> Iterator[Line]:
    """The share of the wrong programs that were broken, of each problem that was tried."""
    if shares:
        text = ", ".join(f"{each.problem} {len(each.broken)} of {each.programs}" for each in shares)
        label = Span("hacks", Style.FAINT)
        yield from hanging(label, Span(f"wrong programs broken: {text}"), width, indent=2, column=12)


def _prose(text: str, width: int | None) -> Iterator[Line]:
    for row in wrap(text, width):
        yield line(row)

"""The screens of `judge hack`: a wrong program, what came of a case, and how all of them stand."""

from __future__ import annotations

from collections.abc import Sequence

from rich.console import Group, RenderableType
from rich.text import Text

from judge.data.parse import call_of
from judge.practice.progress import HackState
from judge.report.parts import BAD, FAINT, GOOD, STRONG, commands, facts, indented, joined, table, text
from judge.report.published_cases import HackStanding, HackTurn
from judge.report.screen import Screen
from judge.report.trying import fitted
from judge.report.words import counted

_STATES = {
    HackState.BROKEN: text("broken", GOOD),
    HackState.GIVEN_UP: text("given up", FAINT),
}


def hack_turn(found: HackTurn, screen: Screen) -> RenderableType:
    """The program and what is asked; or what it answers to a case, and whether that breaks it."""
    if found.outcome == "shown":
        return _program(found)
    below = _ended(found)
    if found.tried is None:
        return Group(*below)
    return fitted(found.tried, found.said, "smallest case", [], [Text(), *below], screen)


def _program(found: HackTurn) -> RenderableType:
    name, number = found.problem.id, found.puzzle.number
    aside = f"  wrong program {number} of {len(found.puzzles)}, {found.done} broken"
    rows = (text(row) for row in found.puzzle.source.decode().splitlines())
    asked = "This program is wrong for at least one valid input. Find one:"
    command = f'  judge hack {name} {number} "{call_of(found.problem)}"'
    return Group(joined(text(name, STRONG), aside), Text(), *rows, Text(), text(asked), text(command))


def _ended(found: HackTurn) -> list[RenderableType]:
    """The mistake, once it may be named, and what came of the case."""
    name, puzzle = found.problem.id, found.puzzle
    if found.outcome == "lost":
        lost = facts([(text("LOST", f"{STRONG} {BAD}"), found.why)])
        again = f"judge hack {name} {puzzle.number}"
        more = [(again, "shows the program again"), (f"{again} --give-up", "names the mistake")]
        return [lost] if found.goes_on else [lost, Text(), indented(commands(more))]
    mistake = [indented(text(puzzle.mistake, BAD)), indented(text(puzzle.advice), 4)]
    if found.outcome == "given-up":
        return [*mistake]
    said = f"broken, {found.done} of {counted(len(found.puzzles), 'program')} of {name}"
    if found.following:
        said += f"; next: judge hack {name} {found.following.number}"
    return [*mistake, Text(), facts([(text("WON", f"{STRONG} {GOOD}"), said)])]


def hack_standing(found: HackStanding, _screen: Screen) -> RenderableType:
    """A row for each program that was broken or given up, with its mistake; the open ones by number."""
    name, puzzles, states = found.turn.problem.id, found.turn.puzzles, found.turn.states
    said = f"  {found.turn.done} of {len(puzzles)} wrong programs broken"
    parts: list[RenderableType] = [joined(text(name, STRONG), said)]
    left = [each.number for each in puzzles if states[each.mistake] is HackState.OPEN]
    rows = [
        (str(each.number), _STATES[states[each.mistake]], text(each.mistake, FAINT))
        for each in puzzles
        if each.number not in left
    ]
    if rows:
        parts += [Text(), indented(table(("program", "state", "mistake"), rows, right=[0]))]
    if left:
        parts += [Text(), indented(facts([("open", _runs(left)), ("next", f"judge hack {name} {left[0]}")]))]
    return Group(*parts)


def _runs(numbers: Sequence[int]) -> str:
    """`1, 3 to 8, 10`: whole numbers in their order, three or more in a row by the first and the last."""
    runs: list[list[int]] = []
    for number in numbers:
        if runs and number == runs[-1][-1] + 1:
            runs[-1].append(number)
        else:
            runs.append([number])
    said = (f"{run[0]} to {run[-1]}" if len(run) > 2 else ", ".join(map(str, run)) for run in runs)
    return ", ".join(said)

"""`judge hack`: break a wrong program with one case."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click
from msgspec.structs import replace

from judge.cli.judging_options import isolation_option
from judge.cli.kept import history_at
from judge.cli.options import db_option, json_option, problems_option, write_json
from judge.data.given import line_of, read_case
from judge.errors import ExitCode, HistoryError, UsageError, told
from judge.kata.events import Hack, Outcome
from judge.kata.hacks import HackState, hack_states, was_shown
from judge.mistakes.puzzles import Puzzle, puzzle_called, read_puzzles
from judge.problem.find import find_problem
from judge.report.hacking import answer_lines, list_lines, lost_lines, puzzle_lines, told_lines, won_lines
from judge.report.layout import Line, line
from judge.report.screen import Notes, Screen, is_terminal, note, out

if TYPE_CHECKING:
    from judge.problem import Case, Problem
    from judge.run.tried import Hacked, Said, Tried

SCHEMA = 1
_AROUND = 4  # rows of a terminal beside a picture: one above it, one below, the verdict and the prompt


@click.command("hack", context_settings={"ignore_unknown_options": True})
@click.argument("name", metavar="PROBLEM")
@click.argument("words", metavar="[MISTAKE] [CASE]", nargs=-1, type=click.UNPROCESSED)
@click.option("--list", "listed", is_flag=True, help="List the wrong programs, and which ones you broke.")
@click.option(
    "--give-up", "giving_up", is_flag=True, help="Name the mistake, and show a smallest case that breaks it."
)
@json_option
@isolation_option
@db_option
@problems_option
def command(
    name: str,
    words: tuple[str, ...],
    listed: bool,
    giving_up: bool,
    as_json: bool,
    level: str | None,
    db: Path | None,
    folders: tuple[Path, ...],
) -> ExitCode:
    """Break a wrong program with one case.

    You see its source. Find a valid case that it answers wrongly. MISTAKE is the program's number or the
    name of its mistake; without it you get the next one that you have not broken, the easiest first. Write
    CASE as for 'judge try': as Python arguments, "0, 0, 1, (-1, 1), (1, 1)", or as the line that a program
    reads. - reads it from standard input, and a terminal asks for it. You learn the name of the mistake
    when you win or give up.

    Exit status: 0 won, or no case given, 1 not won, 2 usage, or a case that cannot be read, 3 a fault of
    the judge or of the problem.
    """
    problem = find_problem(name, folders)
    if not problem.parameters:
        remedy = "its function is called with nothing, so there is no case to give; take another problem"
        raise UsageError(f"{problem.id} has no wrong programs to break", remedy=remedy)
    puzzles = read_puzzles(problem)
    if not puzzles:
        remedy = "its solutions/ folder, with mistakes.py or wrong/, is not here"
        raise UsageError(f"no wrong programs of {problem.id} are known", remedy=remedy)
    word, text = _words(problem, words)
    hacking = _Hacking(problem, puzzles, db, level, as_json=as_json)
    if listed:
        return hacking.show_all()
    puzzle = hacking.next() if word is None else puzzle_called(puzzles, word, problem.id)
    if giving_up:
        return hacking.give_up(puzzle)
    if text is not None:
        return hacking.attempt(puzzle, read_case(problem, _typed() if text == "-" else text))
    return hacking.show(puzzle)


def _words(problem: Problem, words: Sequence[str]) -> tuple[str | None, str | None]:
    """The program that is meant, and the case; None for what was not given. Raises UsageError."""
    for word in words:
        if word.startswith("--"):  # which a negative number never does
            raise UsageError(f"no such option '{word}'", remedy="see 'judge hack --help'")
    if not words:
        return None, None
    first, *rest = words
    if any(sign in first for sign in ",=([ ") or first == "-":
        return None, " ".join(words)
    if rest:
        try:
            read_case(problem, " ".join(words))
        except UsageError:
            return first, " ".join(rest)
        return None, " ".join(words)
    return first, None


def _typed() -> str:
    import sys

    return sys.stdin.read(1 << 16)


class _Hacking:
    """What the command does, once it is known what is asked for."""

    def __init__(
        self,
        problem: Problem,
        puzzles: Sequence[Puzzle],
        db: Path | None,
        level: str | None,
        *,
        as_json: bool,
    ) -> None:
        self._problem = problem
        self._puzzles = puzzles
        self._db = db
        self._level = level
        self._as_json = as_json

    def next(self) -> Puzzle:
        """The first one that is open; then the first that was given up; when all are broken, the first."""
        return self._open() or self._puzzles[0]

    def show_all(self) -> ExitCode:
        """All of them, with how each stands."""
        states = self._states()
        if self._as_json:
            programs = [
                {
                    "number": each.number,
                    "state": states[each.mistake].value,
                    "mistake": None if states[each.mistake] is HackState.OPEN else each.mistake,
                }
                for each in self._puzzles
            ]
            write_json({"schema": SCHEMA, "problem": self._problem.id, "programs": programs})
        else:
            screen = out()
            screen.show(list_lines(self._problem, self._puzzles, states, screen.width))
        return ExitCode.ACCEPTED

    def show(self, puzzle: Puzzle) -> ExitCode:
        """The source; on a terminal cases are asked for, until one breaks it or nothing is typed."""
        import sys

        if self._as_json:
            self._write(puzzle, "shown")
            return ExitCode.ACCEPTED
        screen = out()
        screen.show(puzzle_lines(self._problem, puzzle, self._standing(), screen.width))
        if not (is_terminal(sys.stdin) and is_terminal(screen.stream)):
            return ExitCode.ACCEPTED
        status = ExitCode.ACCEPTED
        while text := _asked_for(screen):
            try:
                status = self.attempt(puzzle, read_case(self._problem, text))
            except UsageError as fault:
                note(str(fault))
                continue
            if status is ExitCode.ACCEPTED:
                break
        return status

    def attempt(self, puzzle: Puzzle, case: Case) -> ExitCode:
        """Try to break it with that case, and keep what came of it."""
        from judge.judging.hacking import hack

        hacked = hack(self._problem, puzzle, case, self._level)
        text = line_of(self._problem, case)
        if hacked.won and was_shown(puzzle.mistake, text, self._hacks()):
            hacked = replace(hacked, why="this is the case that was shown when it was given up")
        if hacked.tried is not None:  # a case that is none says nothing of the person
            self._keep(puzzle, text, Outcome.WON if hacked.won else Outcome.LOST)
        Notes().say(hacked.notes)
        if self._as_json:
            self._write(puzzle, "won" if hacked.won else "lost", hacked.tried, hacked.said, hacked.why)
        else:
            self._tell(puzzle, hacked)
        return ExitCode.ACCEPTED if hacked.won else ExitCode.NOT_ACCEPTED

    def give_up(self, puzzle: Puzzle) -> ExitCode:
        """Tell what is wrong, and show a smallest case."""
        from judge.judging.hacking import smallest
        from judge.report.progress import progress

        found = smallest(self._problem, puzzle, self._level, progress)
        tried, said = found or (None, None)
        self._keep(puzzle, line_of(self._problem, tried.case) if tried else "", Outcome.GIVEN_UP)
        if self._as_json:
            self._write(puzzle, "given-up", tried, said)
            return ExitCode.NOT_ACCEPTED
        screen = out()
        lines = [line(), *told_lines(puzzle, screen.width)]
        if tried and said:
            above = list(answer_lines(tried, said, screen.width))
            lines = [*above, *_drawn(tried, said, screen, len(above) + len(lines)), *lines]
        screen.show(lines)
        return ExitCode.NOT_ACCEPTED

    def _tell(self, puzzle: Puzzle, hacked: Hacked) -> None:
        screen = out()
        lines: list[Line] = []
        if hacked.tried and hacked.said:
            lines = [*answer_lines(hacked.tried, hacked.said, screen.width), line()]
        if hacked.won:
            standing, following = self._standing(), self._open()
            lines += won_lines(self._problem, puzzle, standing, following, screen.width)
        else:
            lines += lost_lines(hacked.why, self._problem, puzzle, screen.width)
        screen.show(lines)

    def _write(
        self,
        puzzle: Puzzle,
        outcome: str,
        tried: Tried | None = None,
        said: Said | None = None,
        why: str = "",
    ) -> None:
        state = self._states()[puzzle.mistake]
        known = state is not HackState.OPEN
        case = None
        if tried is not None and said is not None:
            case = {
                "input": self._problem.named(tried.case),
                "line": line_of(self._problem, tried.case),
                "expected": tried.wanted,
                "got": said.got,
                "message": said.message,
                "verdict": said.verdict.value,
                "isolation": said.isolation or None,
            }
        write_json(
            {
                "schema": SCHEMA,
                "problem": self._problem.id,
                "number": puzzle.number,
                "outcome": outcome,
                "state": state.value,
                "why": why,
                "mistake": puzzle.mistake if known else None,
                "advice": puzzle.advice if known else None,
                "source": puzzle.source.decode(),
                "case": case,
            }
        )

    def _keep(self, puzzle: Puzzle, case: str, outcome: Outcome) -> None:
        try:
            with history_at(self._db) as history:
                history.keep(Hack(self._problem.id, puzzle.mistake, case, outcome))
        except HistoryError as fault:  # what came of it is worth more
            note(f"this is not kept: {fault}")

    def _hacks(self) -> list[Hack]:
        with history_at(self._db, reading=True) as history:
            return history.events(Hack, self._problem.id)

    def _states(self) -> dict[str, HackState]:
        return hack_states([puzzle.mistake for puzzle in self._puzzles], self._hacks())

    def _standing(self) -> tuple[int, int]:
        done = sum(state is HackState.BROKEN for state in self._states().values())
        return done, len(self._puzzles)

    def _open(self) -> Puzzle | None:
        states = self._states()
        for wanted in (HackState.OPEN, HackState.GIVEN_UP):
            for puzzle in self._puzzles:
                if states[puzzle.mistake] is wanted:
                    return puzzle
        return None


def _asked_for(screen: Screen) -> str:
    """What is typed at the prompt; nothing at the end of the input."""
    screen.show([line()])
    try:
        return input("case> ").strip()
    except EOFError:
        screen.show([line()])
        return ""


def _drawn(tried: Tried, said: Said, screen: Screen, beside: int) -> list[Line]:
    """The picture of the case, where the screen has room for it."""
    from judge.problem.declare import Shown
    from judge.report.picture import has_room, picture_lines
    from judge.report.terminal import height

    draw = tried.data.module.hooks.picture
    if draw is None or not has_room(screen):
        return []
    values = tried.problem.named(tried.case)
    try:
        picture = draw(
            Shown(tried.problem, values, tried.exact, tried.wanted, said.got, said.given, "smallest case")
        )
    except Exception as fault:  # what is told of it is worth more
        note(f"the case is not drawn: {told(fault)}")
        return []
    if picture is None:
        return []
    return [line(), *picture_lines(picture, height(screen) - beside - _AROUND)]

"""`judge try` and `judge hack`: one case answered exactly, and wrong programs to break with one case."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from msgspec import Struct
from msgspec.structs import replace

from judge.cli.files import OutFile, read_submissions, svg_target
from judge.cli.options import Common, command, opt
from judge.cli.resolve import history_at, kata_meant, keep, problem_of_file, shown, usual_file
from judge.data.parse import example_of, line_of, read_case
from judge.diagnose.regression import MARK, with_case
from judge.diagnose.replay import decode, problem_name
from judge.errors import UsageError
from judge.files import read_ordinary_text
from judge.judging.api import RunOptions
from judge.judging.cases import ask as ask_file
from judge.judging.cases import hack as attack
from judge.judging.cases import smallest, try_case
from judge.judging.session import Session
from judge.languages import is_program
from judge.mistakes.puzzles import Puzzle, puzzle_called, read_puzzles
from judge.practice.events import Hack, Outcome
from judge.practice.progress import hack_states, was_shown
from judge.problem import Case, Problem, Verdict
from judge.problem.find import find_problem
from judge.problem.model import Mode, case_of
from judge.problem.module import load_module
from judge.report import published_cases as published
from judge.report.screen import Notes, is_terminal, note
from judge.report.tell import shown_failure

if TYPE_CHECKING:
    from judge.run.tried import Said, Tried

_PAGE = Path("judge-try.html")
_PAGE_MARK = b'name="generator" content="judge try"'


class TryAsk(Struct, frozen=True):
    """What to make of the case."""

    opened: bool = opt("--open", "Drag the figure in the browser.")
    page: Path | None = opt("--out FILE", f"Write that page; {_PAGE} with --open alone.")
    svg: Path | None = opt("--svg FILE", "Draw the case into an SVG file.")
    test: Path | None = opt("--pytest FILE", "Add the case as a pytest test of your file.")


@command("try", published.CaseLine, published.PageWritten, numbers=True, ask=TryAsk)
@click.argument("words", metavar="[KATA] [CASE|ID] [FILE]", nargs=-1, type=click.UNPROCESSED)
def try_(words: tuple[str, ...], ask: TryAsk, common: Common) -> Iterator[Struct]:
    """See the exact answer to one case, and what your file answers.

    Write CASE as Python arguments, "0, 0, 1, (-1, 1), (1, 1)", with or without names, as a whole call, or as
    the line that a program reads, 0 0 1 -1 1 1 1. An ID is what judge run shows with a failing case. Without
    a case you get the last one that failed; without a KATA, that of this folder.

    Exit status: 0 accepted or no FILE, 1 not accepted, 2 usage or an invalid case, 3 a fault of the judge.
    """
    problem, case, group, file = _meant(_arguments(words), common)
    page = ask.page or (_PAGE if ask.opened else None)
    wanted: list[tuple[OutFile, Callable[[Path, Problem, published.CaseTried | None], str]]] = [
        (OutFile(page, "--out", "a page of judge try", lambda start: _PAGE_MARK in start), _page),
        (svg_target(ask.svg), _svg),
        (OutFile(ask.test, "--pytest", "a file of such tests", lambda start: start.startswith(MARK)), _test),
    ]
    found = None
    if case is not None:
        tried = try_case(problem, case, group)
        found = published.CaseTried(tried, _said(tried, file, common) if file else None)
    elif not page or ask.svg or ask.test:
        raise UsageError(f'Give a case: judge try {problem.id} "{example_of(problem)}"')
    written = [
        (target, target.path, make(target.path, problem, found)) for target, make in wanted if target.path
    ]
    if found:
        yield found
    for target, path, text in written:
        target.write(text.encode())
        yield published.PageWritten(problem=problem.id, file=str(path))
    if ask.opened and page:
        import webbrowser  # hardly ever

        if not webbrowser.open(page.absolute().as_uri()):
            note(f"No browser was found. Open {page} yourself")


def _arguments(words: Sequence[str]) -> list[str]:
    """The words, none of which is an option that there is not."""
    for word in words:
        if word.startswith("--"):  # which a negative number never does
            raise click.NoSuchOption(word, ctx=click.get_current_context())
    return list(words)


def _meant(words: list[str], common: Common) -> tuple[Problem, Case | None, str, str | None]:
    """The kata, the case, None where none is named and none has failed, its group, and the file."""
    is_file = words and (is_program(words[-1]) or words[-1].startswith(("/", "./", "../")))
    file = words.pop() if is_file else None
    named = words and words[0][:1].isalpha() and not any(sign in words[0] for sign in ",=([:")
    name = words.pop(0) if named else None
    problem, group = find_problem(name, common.problems) if name else None, ""
    if words and ":" in words[0]:
        if len(words) > 1:
            raise UsageError("an ID is a case already", where=words[1], remedy="leave one of them out")
        problem = find_problem(problem_name(words[0]), common.problems)
        if name not in (None, problem.id):
            raise UsageError(f"this ID is a case of {problem.id}, not of {name}")
        found = decode(words[0], problem, load_module(problem))
        case, group = found.case, found.group.name
    else:
        if problem is None and file is not None:
            problem = problem_of_file(read_submissions([file])[0], "try", common)
        if not words:
            return _last_failed(problem, file, common)
        problem = problem or kata_meant(None, common)
        case = read_case(problem, " ".join(words))
    if file is None:
        with suppress(UsageError):
            file = usual_file(problem.id, common.db)
    return problem, case, group, file


def _last_failed(
    problem: Problem | None, file: str | None, common: Common
) -> tuple[Problem, Case | None, str, str | None]:
    """The case on which a file of that kata failed last; without a kata, one of this folder."""
    with history_at(common.db, reading=True) as history:
        runs = history.runs(problem.id if problem else None)
    for run in reversed(runs):
        near, failed = shown(run.path), run.verdict not in (Verdict.AC, Verdict.JE)
        if failed and (problem or near == Path(near).name):
            problem = problem or find_problem(run.problem, common.problems)
            failure = shown_failure(run.result)
            if failure is not None and failure.input is not None:
                own = file or (near if near and Path(near).is_file() else None)
                return problem, case_of(failure.input), failure.group or "", own
            break
    return problem or kata_meant(None, common), None, "", None


def _said(tried: Tried, file: str, common: Common) -> Said:
    submission, *more = read_submissions([file])
    if more:
        raise UsageError("this folder holds several submissions", where=file, remedy="name one file")
    with Session(tried.problem, RunOptions(isolation=common.isolation)) as session:
        said = ask_file(session, tried, submission.source, submission.name)
        Notes().say(session.notes(said.isolation))
    return said


def _page(_path: Path, problem: Problem, found: published.CaseTried | None) -> str:
    explore = load_module(problem).hooks.explore
    page = explore(problem, problem.named(found.tried.case) if found else None) if explore else None
    if page is None:
        raise UsageError(f"No page for {problem.id} yet", remedy="leave out --open and --out")
    return page


def _svg(_path: Path, _problem: Problem, found: published.CaseTried | None) -> str:
    from judge.drawing.svg import to_svg
    from judge.report.cases import picture_of

    picture = picture_of(found.tried, found.said) if found else None
    if picture is None:
        raise UsageError("there is no picture of this case", remedy="leave out --svg")
    return to_svg(picture)


def _test(path: Path, _problem: Problem, found: published.CaseTried | None) -> str:
    said = found.said if found else None
    if not found or not said or said.mode is not Mode.FUNCTION or not Path(said.name).is_file():
        raise UsageError("--pytest tests a function", remedy="name a file that defines it")
    try:
        content = read_ordinary_text(path) if path.exists() else ""
    except (OSError, ValueError) as fault:
        raise UsageError("this file cannot be read", where=str(path)) from fault
    return with_case(content, path, Path(said.name), found.tried)


class HackAsk(Struct, frozen=True):
    """What to do about the wrong programs, other than break one."""

    listed: bool = opt("--list", "List the programs, and which ones you broke.")
    give_up: bool = opt("--give-up", "Name the mistake, and show a smallest case.")


@command("hack", published.HackLine, published.HackList, numbers=True, ask=HackAsk)
@click.argument("name", metavar="KATA")
@click.argument("words", metavar="[N] [CASE]", nargs=-1, type=click.UNPROCESSED)
def hack(name: str, words: tuple[str, ...], ask: HackAsk, common: Common) -> Iterator[Struct]:
    """Find a case on which a wrong program fails.

    N is the program's number, or the name of its mistake. Without it you get the first one that you have not
    broken; the easiest come first. Write CASE as for judge try; - reads it from standard input, and a
    terminal asks for it. You learn the name of the mistake when you win or give up.

    Exit status: 0 won, or no case given, 1 not won, 2 usage, or a case that cannot be read, 3 a fault of
    the judge.
    """
    problem = find_problem(name, common.problems)
    puzzles = read_puzzles(problem) if problem.parameters else ()
    if not puzzles:
        raise UsageError(f"{problem.id} has no wrong programs to break", remedy="judge list shows all katas")
    number, text = _number_and_case(problem, _arguments(words))
    hacking = _Hacking(problem, puzzles, common)
    if number:
        puzzle = puzzle_called(puzzles, number, problem.id)
    else:
        puzzle = hacking.turn(puzzles[0], "shown").following or puzzles[0]
    if ask.give_up and not ask.listed:
        yield hacking.given_up(puzzle)
    elif text is not None and not ask.listed:
        yield hacking.attempted(puzzle, sys.stdin.read(1 << 16) if text == "-" else text)
    else:
        turn = hacking.turn(puzzle, "listed" if ask.listed else "shown")
        yield turn
        asked = not (common.json or ask.listed) and is_terminal(sys.stdin) and is_terminal(sys.stdout)
        while asked and (typed := _typed()):
            try:
                turn = hacking.attempted(puzzle, typed)
            except UsageError as fault:
                note(str(fault))
                continue
            yield replace(turn, goes_on=True)
            asked = turn.outcome == "lost"


def _typed() -> str:
    """What is typed at the prompt; nothing at the end of the input."""
    try:
        return input("\ncase> ").strip()
    except EOFError:
        sys.stdout.write("\n")
        return ""


def _number_and_case(problem: Problem, words: list[str]) -> tuple[str | None, str | None]:
    """The program that is meant, and the case; None for what was not given."""
    first, text = words[0] if words else "", " ".join(words)
    if first == "-" or any(sign in first for sign in ",=([ "):
        return None, text
    if len(words) > 1:
        with suppress(UsageError):
            read_case(problem, text)
            return None, text
    return first or None, " ".join(words[1:]) or None


class _Hacking(Struct, frozen=True):
    """A person and the wrong programs of a kata; what is tried is kept in the history."""

    problem: Problem
    puzzles: tuple[Puzzle, ...]
    common: Common

    def attempted(self, puzzle: Puzzle, text: str) -> published.HackTurn:
        """What the program answers to the case, and whether that breaks it."""
        found = attack(self.problem, puzzle, read_case(self.problem, text), self.common.isolation)
        why = found.why
        if found.tried is not None:  # an invalid case says nothing of the person
            line = line_of(self.problem, found.tried.case)
            if not why and was_shown(puzzle.mistake, line, self._hacks()):
                why = "this is the case that you saw when you gave up"
            self._keep(puzzle, line, Outcome.LOST if why else Outcome.WON)
        Notes().say(found.notes)
        return self.turn(puzzle, "lost" if why else "won", why, found.tried, found.said)

    def given_up(self, puzzle: Puzzle) -> published.HackTurn:
        """The mistake, and a smallest case."""
        from judge.report.wait import progress

        tried, said = smallest(self.problem, puzzle, self.common.isolation, progress) or (None, None)
        self._keep(puzzle, line_of(self.problem, tried.case) if tried else "", Outcome.GIVEN_UP)
        return self.turn(puzzle, "given-up", "", tried, said)

    def turn(self, puzzle: Puzzle, outcome: str, *found: Any) -> published.HackTurn:
        """What is shown of the program, as all of them stand now; `found` is the rest of a HackTurn."""
        states = hack_states([each.mistake for each in self.puzzles], self._hacks())
        return published.HackTurn(self.problem, self.puzzles, states, puzzle, outcome, *found)

    def _keep(self, puzzle: Puzzle, case: str, outcome: Outcome) -> None:
        keep(Hack(self.problem.id, puzzle.mistake, case, outcome), self.common.db)

    def _hacks(self) -> list[Hack]:
        with history_at(self.common.db, reading=True) as history:
            return history.events(Hack, self.problem.id)

"""`judge try` and `judge hack`: one case answered exactly, and wrong programs to break with one case."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import click
from msgspec import Struct
from msgspec.structs import replace

from judge.cli.kept import history_at
from judge.cli.options import Common, command, opt, takes
from judge.cli.resolve import kata_meant, problem_of_file, shown, usual_file
from judge.cli.submissions import read_submissions
from judge.cli.target import OutFile, svg_target
from judge.data.parse import example_of, line_of, read_case
from judge.diagnose.regression import MARK, with_case
from judge.diagnose.replay import decode, problem_name
from judge.errors import StoreError, UsageError
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
from judge.report.published_cases import (
    CaseLine,
    CaseTried,
    HackLine,
    HackList,
    HackStanding,
    HackTurn,
    PageWritten,
)
from judge.report.screen import Notes, is_terminal, note

if TYPE_CHECKING:
    from judge.run.tried import Said, Tried

_PAGE = Path("judge-try.html")
_PAGE_MARK = b'name="generator" content="judge try"'


class TryAsk(Struct, frozen=True):
    """What to make of the case."""

    opened: Annotated[bool, opt("--open", help="Drag the figure in the browser.")] = False
    page: Annotated[
        Path | None, opt("--out", metavar="FILE", help=f"Write that page; {_PAGE} with --open alone.")
    ] = None
    svg: Annotated[Path | None, opt("--svg", metavar="FILE", help="Draw the case into an SVG file.")] = None
    test: Annotated[
        Path | None,
        opt("--pytest", metavar="FILE", help="Add the case as a pytest test of your file."),
    ] = None


class _Meant(Struct, frozen=True):
    """What the words mean; `case` is None where none is named and none has failed."""

    problem: Problem
    case: Case | None
    group: str = ""
    file: str | None = None


@command("try", CaseLine, PageWritten, numbers=True)
@click.argument("words", metavar="[KATA] [CASE|ID] [FILE]", nargs=-1, type=click.UNPROCESSED)
@takes(TryAsk, "ask")
def try_(words: tuple[str, ...], ask: TryAsk, common: Common) -> Iterator[Struct]:
    """See the exact answer to one case, and what your file answers.

    Write CASE as Python arguments, "0, 0, 1, (-1, 1), (1, 1)", with or without names, as a whole call, or as
    the line that a program reads, 0 0 1 -1 1 1 1. An ID is what judge run shows with a failing case. Without
    a case you get the last one that failed; without a KATA, that of this folder.

    Exit status: 0 accepted or no FILE, 1 not accepted, 2 usage or an invalid case, 3 a fault of the judge.
    """
    meant = _meant(_arguments(words), common)
    problem, page = meant.problem, ask.page or (_PAGE if ask.opened else None)
    wanted: list[tuple[OutFile, Callable[[CaseTried | None], str]]] = []
    if page:
        target = OutFile(page, "--out", "page of judge try", lambda start: _PAGE_MARK in start)
        wanted.append((target, partial(_page, problem)))
    if ask.svg:
        wanted.append((svg_target(ask.svg), _svg))
    if ask.test:
        target = OutFile(ask.test, "--pytest", "file of such tests", lambda start: start.startswith(MARK))
        wanted.append((target, partial(_test, ask.test)))
    for target, _ in wanted:
        target.check()
    found = None
    if meant.case is not None:
        tried = try_case(problem, meant.case, meant.group)
        found = CaseTried(tried, _said(tried, meant.file, common) if meant.file else None)
    elif not page or ask.svg or ask.test:
        raise UsageError(f'Give a case: judge try {problem.id} "{example_of(problem)}"')
    content = [make(found) for _, make in wanted]
    if found:
        yield found
    for (target, _), text in zip(wanted, content, strict=True):
        target.write(text.encode())
        yield PageWritten(problem=problem.id, file=str(target.path))
    if ask.opened and page:
        _open(page)


def _open(page: Path) -> None:
    import webbrowser  # hardly ever

    if not webbrowser.open(page.absolute().as_uri()):
        note(f"No browser was found. Open {page} yourself")


def _arguments(words: Sequence[str]) -> list[str]:
    """The words, none of which is an option that there is not."""
    for word in words:
        if word.startswith("--"):  # which a negative number never does
            raise click.NoSuchOption(word, ctx=click.get_current_context())
    return list(words)


def _meant(words: list[str], common: Common) -> _Meant:
    is_file = words and (is_program(words[-1]) or words[-1].startswith(("/", "./", "../")))
    file = words.pop() if is_file else None
    named = words and words[0][:1].isalpha() and not any(sign in words[0] for sign in ",=([:")
    name = words.pop(0) if named else None
    if words and ":" in words[0]:
        if len(words) > 1:
            raise UsageError("an ID is a case already", where=words[1], remedy="leave one of them out")
        problem = find_problem(problem_name(words[0]), common.problems)
        if name not in (None, problem.id):
            raise UsageError(f"this ID is a case of {problem.id}, not of {name}")
        found = decode(words[0], problem, load_module(problem))
        return _Meant(problem, found.case, found.group.name, file or _own_file(problem, common))
    known = find_problem(name, common.problems) if name else None
    if known is None and file is not None:
        known = problem_of_file(read_submissions([file])[0], "try", common.problems, common.db)
    if not words:
        return _last_failed(known, file, common)
    problem = known or kata_meant(None, common)
    return _Meant(problem, read_case(problem, " ".join(words)), "", file or _own_file(problem, common))


def _own_file(problem: Problem, common: Common) -> str | None:
    """The usual file of the kata in this folder, if it is there."""
    with suppress(UsageError):
        return usual_file(problem.id, common.db)
    return None


def _last_failed(problem: Problem | None, file: str | None, common: Common) -> _Meant:
    """The case on which a file of that kata failed last; without a kata, one of this folder."""
    with history_at(common.db, reading=True) as history:
        runs = history.runs(problem.id if problem else None)
    for run in reversed([run for run in runs if run.verdict not in (Verdict.AC, Verdict.JE)]):
        near = shown(run.path)
        if problem or near == Path(near).name:
            problem = problem or find_problem(run.problem, common.problems)
            smallest, first = run.result.counterexample, run.result.failure
            failure = smallest if smallest is not None and smallest.input is not None else first
            if failure is None or failure.input is None:
                break
            own = file or (near if near and Path(near).is_file() else None)
            return _Meant(problem, case_of(failure.input), failure.group or "", own)
    return _Meant(problem or kata_meant(None, common), None)


def _said(tried: Tried, file: str, common: Common) -> Said:
    submission, *more = read_submissions([file])
    if more:
        raise UsageError("this folder holds several submissions", where=file, remedy="name one file")
    with Session(tried.problem, RunOptions(isolation=common.isolation)) as session:
        said = ask_file(session, tried, submission.source, submission.name)
        Notes().say(session.notes(said.isolation))
    return said


def _page(problem: Problem, found: CaseTried | None) -> str:
    explore = load_module(problem).hooks.explore
    page = explore(problem, problem.named(found.tried.case) if found else None) if explore else None
    if page is None:
        raise UsageError(f"No page for {problem.id} yet", remedy="leave out --open and --out")
    return page


def _svg(found: CaseTried | None) -> str:
    from judge.drawing.svg import to_svg
    from judge.report.trying import picture_of

    picture = picture_of(found.tried, found.said, "your case") if found else None
    if picture is None:
        raise UsageError("there is no picture of this case", remedy="leave out --svg")
    return to_svg(picture)


def _test(path: Path, found: CaseTried | None) -> str:
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

    listed: Annotated[bool, opt("--list", help="List the programs, and which ones you broke.")] = False
    give_up: Annotated[bool, opt("--give-up", help="Name the mistake, and show a smallest case.")] = False


@command("hack", HackLine, HackList, numbers=True)
@click.argument("name", metavar="KATA")
@click.argument("words", metavar="[N] [CASE]", nargs=-1, type=click.UNPROCESSED)
@takes(HackAsk, "ask")
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
    puzzle = (
        puzzle_called(puzzles, number, problem.id) if number else hacking.turn(puzzles[0], "shown").following
    )
    puzzle = puzzle or puzzles[0]
    if ask.listed:
        yield HackStanding(hacking.turn(puzzle, "shown"))
    elif ask.give_up:
        yield hacking.given_up(puzzle)
    elif text is not None:
        yield hacking.attempted(puzzle, sys.stdin.read(1 << 16) if text == "-" else text)
    else:
        yield hacking.turn(puzzle, "shown")
        asked = not common.json and is_terminal(sys.stdin) and is_terminal(sys.stdout)
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
    if not words:
        return None, None
    first, text = words[0], " ".join(words)
    if first == "-" or any(sign in first for sign in ",=([ "):
        return None, text
    if len(words) == 1:
        return first, None
    with suppress(UsageError):
        read_case(problem, text)
        return None, text
    return first, " ".join(words[1:])


class _Hacking(Struct, frozen=True):
    """A person and the wrong programs of a kata; what is tried is kept in the history."""

    problem: Problem
    puzzles: tuple[Puzzle, ...]
    common: Common

    def attempted(self, puzzle: Puzzle, text: str) -> HackTurn:
        """What the program answers to the case, and whether that breaks it."""
        found = attack(self.problem, puzzle, read_case(self.problem, text), self.common.isolation)
        why = found.why
        if found.tried is not None:  # an invalid case says nothing of the person
            line = line_of(self.problem, found.tried.case)
            if not why and was_shown(puzzle.mistake, line, self._hacks()):
                why = "this is the case that you saw when you gave up"
            self._keep(puzzle, line, Outcome.LOST if why else Outcome.WON)
        Notes().say(found.notes)
        return self.turn(puzzle, "lost" if why else "won", found.tried, found.said, why)

    def given_up(self, puzzle: Puzzle) -> HackTurn:
        """The mistake, and a smallest case."""
        from judge.report.wait import progress

        tried, said = smallest(self.problem, puzzle, self.common.isolation, progress) or (None, None)
        self._keep(puzzle, line_of(self.problem, tried.case) if tried else "", Outcome.GIVEN_UP)
        return self.turn(puzzle, "given-up", tried, said)

    def turn(
        self,
        puzzle: Puzzle,
        outcome: str,
        tried: Tried | None = None,
        said: Said | None = None,
        why: str = "",
    ) -> HackTurn:
        """What is shown of the program, as all of them stand now."""
        states = hack_states([each.mistake for each in self.puzzles], self._hacks())
        return HackTurn(self.problem, self.puzzles, states, puzzle, outcome, why, tried, said)

    def _keep(self, puzzle: Puzzle, case: str, outcome: Outcome) -> None:
        try:
            with history_at(self.common.db) as history:
                history.keep(Hack(self.problem.id, puzzle.mistake, case, outcome))
        except StoreError as fault:  # what came of it is worth more
            note(f"this is not kept: {fault}")

    def _hacks(self) -> list[Hack]:
        with history_at(self.common.db, reading=True) as history:
            return history.events(Hack, self.problem.id)

"""`judge try` and `judge hack`: one case answered exactly, and wrong programs to break with one case."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path

import click
from msgspec import Struct
from msgspec.structs import replace

from judge.cli.files import OutFile, explore_page, opened_in_browser, read_submission
from judge.cli.options import Common, command, opt
from judge.cli.resolve import history_at, is_problem, kata_meant, keep, problem_of_file, shown, usual_file
from judge.data.parse import example_of, line_of, read_case
from judge.diagnose.replay import begun, decode, has_form, problem_name
from judge.errors import JudgeError, UsageError
from judge.judging import RunOptions
from judge.judging.cases import ask as ask_file
from judge.judging.cases import hack as attack
from judge.judging.cases import smallest, try_case
from judge.judging.session import Session
from judge.languages import is_program
from judge.mistakes.puzzles import HACKED, puzzle_called, read_puzzles
from judge.practice.events import Hack, Outcome
from judge.practice.progress import was_shown
from judge.practice.syllabus import read_checklist
from judge.problem import Problem, Verdict
from judge.problem.find import find_problem
from judge.problem.model import case_of
from judge.problem.module import load_module
from judge.report import published_exercises as published
from judge.report.screen import Notes, is_terminal, note
from judge.report.tell import shown_failure
from judge.report.wait import progress
from judge.run.tried import OneCase

_PAGE = Path("judge-try.html")
_PAGE_MARK = b'name="generator" content="judge try"'


class TryAsk(Struct, frozen=True):
    """What to make of the case."""

    opened: bool = opt("--open", f"Drag the figure in the browser: writes {_PAGE} and opens it.")


@command("try", published.CaseLine, published.PageWritten, numbers=True, ask=TryAsk)
@click.argument("words", metavar="[KATA] [CASE|ID] [FILE]", nargs=-1, type=click.UNPROCESSED)
def try_(words: tuple[str, ...], ask: TryAsk, common: Common) -> Iterator[Struct]:
    """See the exact answer to one case, and what your file answers.

    Write CASE as Python arguments, "0, 0, 1, (-1, 1), (1, 1)", with or without names, as a whole call, or as
    the line that a program reads, 0 0 1 -1 1 1 1. An ID is what judge run shows with a failing case. Without
    a case you get the last one that failed; without a KATA, that of this folder.

    Exit status: 0 accepted or no FILE, 1 not accepted, 2 usage or an invalid case, 3 a fault of the judge.
    """
    problem, tried, file = _meant(_arguments(words), common)
    if tried is None and not ask.opened:
        raise UsageError(f'Give a case: judge try {problem.id} "{example_of(problem)}"')
    if tried and file and not tried.broken:
        tried = _answered(tried, file, common)
    page = None
    if ask.opened:
        page = explore_page(problem, problem.named(tried.case) if tried else None)
    if tried:
        yield published.CaseTried(tried)
    if page:
        OutFile(_PAGE, "--open", "a page of judge try", lambda start: _PAGE_MARK in start).write(
            page.encode()
        )
        yield published.PageWritten(problem=problem.id, file=str(_PAGE))
        if not opened_in_browser(str(_PAGE)):
            note(f"No browser here. Open {_PAGE}")


def _arguments(words: Sequence[str]) -> list[str]:
    """The words, none of which is an option that there is not."""
    for word in words:
        if word.startswith("--"):  # which a negative number never does
            raise click.NoSuchOption(word, ctx=click.get_current_context())
    return list(words)


def _is_case(word: str) -> bool:
    """Whether a word is a case, or a part of one, by its signs alone."""
    return any(sign in word for sign in ",=([{: ")


def _meant(words: list[str], common: Common) -> tuple[Problem, OneCase | None, str | None]:
    """The kata, its case, None where none is named and none has failed, and the file."""
    is_file = words and (is_program(words[-1]) or words[-1].startswith(("/", "./", "../")))
    file = words.pop() if is_file else None
    named = words and words[0][:1].isalpha() and not _is_case(words[0])
    problem = find_problem(words.pop(0), common.problems) if named else None
    # A damaged id begins with the name of a kata; a case may have colons too.
    if words and (has_form(words[0]) or is_problem(begun(words[0]), common)):
        own = find_problem(problem_name(" ".join(words)), common.problems)
        if problem and problem.id != own.id:
            raise UsageError(f"this ID is a case of {own.id}, not of {problem.id}")
        found = decode(words[0], own, load_module(own))
        tried = try_case(own, found.case, found.group.name)
    else:
        if problem is None and file is not None:
            problem = problem_of_file(read_submission(file), "try", common)
        if not words:
            return _last_failed(problem, file, common)
        problem = problem or kata_meant(None, common)
        tried = try_case(problem, read_case(problem, " ".join(words)))
    if file is None:
        with suppress(JudgeError):
            file = usual_file(tried.problem.id, common.db)
    return tried.problem, tried, file


def _last_failed(
    problem: Problem | None, file: str | None, common: Common
) -> tuple[Problem, OneCase | None, str | None]:
    """The case on which a file of that kata failed last; without a kata, one of this folder."""
    with history_at(common.db, reading=True) as history:
        runs = history.runs(problem.id if problem else None)
    failed = (run for run in reversed(runs) if run.verdict not in (Verdict.AC, Verdict.JE))
    last = next((run for run in failed if problem or shown(run.path) == Path(run.path).name), None)
    if problem is None:
        problem = find_problem(last.problem, common.problems) if last else kata_meant(None, common)
    failure = shown_failure(last.result) if last else None
    if last is None or failure is None or failure.input is None:
        return problem, None, None
    if file is None and Path(shown(last.path)).is_file():
        file = shown(last.path)
    return problem, try_case(problem, case_of(failure.input), failure.group or ""), file


def _answered(tried: OneCase, file: str, common: Common) -> OneCase:
    """The case with what the file says to it."""
    submission = read_submission(file)
    with Session(tried.problem, RunOptions(isolation=common.isolation)) as session:
        said = ask_file(session, tried, submission.source, submission.name)
        Notes().say(session.notes(said.isolation))
    return replace(tried, said=said)


class HackAsk(Struct, frozen=True):
    """What to do about the wrong programs, other than break one."""

    give_up: bool = opt("--give-up", "Name the mistake, and show a smallest case.")
    whole: bool = opt("--all", f"More programs than {HACKED}: one for each known mistake.")


@command("hack", published.HackLine, numbers=True, ask=HackAsk)
@click.argument("name", metavar="KATA")
@click.argument("words", metavar="[N] [CASE]", nargs=-1, type=click.UNPROCESSED)
def hack(name: str, words: tuple[str, ...], ask: HackAsk, common: Common) -> Iterator[Struct]:
    """Find a case on which a wrong program fails.

    N is the program's number, or the name of its mistake. Without it you get the first one that you have not
    broken, of 12. Those of a topic that judge drill plans come first, then the easiest. Write CASE as for
    judge try; - reads it from standard input, and a terminal asks for it. You learn the name of the mistake
    when you win or give up.

    Exit status: 0 won, or no case given, 1 not won, 2 usage, or a case that cannot be read, 3 a fault of
    the judge.
    """
    problem = find_problem(name, common.problems)
    drilled = read_checklist(common.problems).drilled()
    puzzles = read_puzzles(problem, drilled) if problem.parameters else ()
    if not puzzles:
        raise UsageError(f"{problem.id} has no wrong programs to break", remedy="judge list shows all katas")
    with history_at(common.db, reading=True) as history:
        hacks = tuple(history.events(Hack, problem.id))
    number, text = _number_and_case(problem, _arguments(words))
    asked = puzzle_called(puzzles, number, problem.id) if number else puzzles[0]
    shown = puzzles if ask.whole or asked.number > HACKED else puzzles[:HACKED]
    turn = published.HackTurn(problem, shown, hacks, asked, "shown", more=len(puzzles) - len(shown))
    turn = turn if number else replace(turn, puzzle=turn.following or asked)
    if ask.give_up:
        tried = smallest(problem, turn.puzzle, common.isolation, progress)
        yield _kept(turn, Outcome.GIVEN_UP, "", tried, common)
    elif text is not None:
        yield _attempted(turn, sys.stdin.read(1 << 16) if text == "-" else text, common)
    else:
        yield turn
        asks = not common.json and is_terminal(sys.stdin) and is_terminal(sys.stdout)
        while asks and turn.outcome != "won" and (typed := _typed()):
            try:
                turn = _attempted(turn, typed, common)
            except UsageError as fault:
                note(str(fault))
            else:
                yield replace(turn, goes_on=True)


def _typed() -> str:
    """What is typed at the prompt; nothing at the end of the input."""
    with suppress(EOFError):
        return input("\ncase> ").strip()
    sys.stdout.write("\n")
    return ""


def _number_and_case(problem: Problem, words: list[str]) -> tuple[str | None, str | None]:
    """The program that is meant, and the case; None for what was not given."""
    text = " ".join(words)
    if not words or words[0] == "-" or _is_case(words[0]):
        return None, text or None
    if len(words) > 1:
        with suppress(UsageError):
            read_case(problem, text)
            return None, text
    return words[0], " ".join(words[1:]) or None


def _attempted(turn: published.HackTurn, text: str, common: Common) -> published.HackTurn:
    """What the program answers to the case, and whether that breaks it."""
    problem, puzzle = turn.problem, turn.puzzle
    case = read_case(problem, text)
    try:
        tried = try_case(problem, case, puzzle.group.name)
        if tried.broken:
            raise UsageError(tried.no_case)
    except UsageError as fault:  # an invalid case says nothing of the person
        return replace(turn, outcome=Outcome.LOST.value, why=fault.what, tried=None)
    with Session(problem, RunOptions(isolation=common.isolation)) as session:
        said, why = attack(session, puzzle, tried)
        Notes().say(session.notes(said.isolation))
    if not why and was_shown(puzzle.mistake, line_of(problem, case), turn.hacks):
        why = "this is the case that you saw when you gave up"
    return _kept(turn, Outcome.LOST if why else Outcome.WON, why, replace(tried, said=said), common)


def _kept(
    turn: published.HackTurn, outcome: Outcome, why: str, tried: OneCase | None, common: Common
) -> published.HackTurn:
    """The turn after an attempt, which is kept in the history."""
    case = line_of(turn.problem, tried.case) if tried else ""
    made = Hack(turn.problem.id, turn.puzzle.mistake, case, outcome)
    keep(made, common.db)
    return replace(turn, outcome=outcome.value, why=why, tried=tried, hacks=(*turn.hacks, made))

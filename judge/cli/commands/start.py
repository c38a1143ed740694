"""`judge start`: create the file of a kata or go on with it, and judge it on every save."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

import click
from msgspec import Struct

from judge.cli.files import read_submissions
from judge.cli.home import next_kata, solved_katas
from judge.cli.options import Common, command, opt
from judge.cli.resolve import current, history_at, is_problem, problem_of, problem_of_file, shown, this_folder
from judge.cli.watching import Kata, take_up
from judge.errors import UsageError
from judge.languages import file_name, is_program
from judge.practice.stub import write_stub
from judge.problem import Problem
from judge.problem.find import find_problem, sound_problems
from judge.problem.fit import id_of
from judge.problem.model import LEVELS
from judge.report.published_start import Begun
from judge.report.screen import is_terminal, out
from judge.report.terminal import draws


class StartAsk(Struct, frozen=True):
    """How to start."""

    language: str | None = opt("--language L", "Its language: c, cpp, go, java, javascript, rust, pypy.")
    once: bool = opt("--no-watch", "Only create the file.")
    reset: bool = opt("--reset", "Start the file over; the old text is kept as FILE.bak.")
    level: str | None = opt("--level", "Judge only this level.", choices=LEVELS)


@command("start", Begun, ask=StartAsk)
@click.argument("words", metavar="[KATA] [FILE]", nargs=-1)
def start(words: tuple[str, ...], ask: StartAsk, common: Common) -> Iterator[Begun]:
    """Start or resume a kata, and judge it on every save.

    Its file is created where there is none. Without a KATA: the file of this folder that you worked on last
    or, once that is solved, the next kata that you have not solved. The end of FILE says its language, or
    --language does. In a pipe, and with --no-watch, the file is created and no more.
    """
    kata = _meant(words, ask, common)
    created = ask.reset or not os.path.exists(kata.path)  # noqa: PTH110 - of any name
    kept = write_stub(kata.problem, kata.path, over=ask.reset) if created else None
    take_up(kata, common.db)
    if ask.once or common.json or not (draws(out()) and is_terminal(sys.stdin)):
        problem, beside = kata.problem, shown(kept) if kept else ""
        yield Begun(problem.id, problem.title, problem.entry, kata.name, created, beside)
        return
    from judge.cli.watch_screen import loop  # what draws and reads keys, for who sits there

    loop(kata, ask.level, common)


def _meant(words: Sequence[str], ask: StartAsk, common: Common) -> Kata:
    """The kata and the file that the words mean. Raises JudgeError."""
    if len(words) > 2:
        raise UsageError(f"one KATA and one FILE are expected; {len(words)} words are given")
    problem: Problem | None = None
    if words:
        first = words[0]
        is_file = len(words) == 1 and not is_problem(first, common)
        if is_file and (is_program(first) or os.path.exists(first)):  # noqa: PTH110 - of any name
            return _checked(_problem_of(first, common), first)
        problem = find_problem(first, common.problems)
        if words[1:] or ask.language:
            return _checked(problem, words[1] if words[1:] else _named(problem, ask.language))
    with history_at(common.db, reading=True) as history:
        here, places, solved = current(this_folder(), history), history.places(), solved_katas(history)
    if problem is not None:
        if here and here.problem == problem.id and not os.path.exists(_named(problem)):  # noqa: PTH110 - of any name
            return Kata(problem, Path(here.path))
    elif here is not None and (here.problem not in solved or ask.reset):
        problem = problem_of(here, common.problems)
        if ask.language is None:
            return Kata(problem, Path(here.path))
    else:
        last = here or next(iter(places), None)
        problems, _ = sound_problems(common.problems)
        problem = next_kata(last.problem if last else "", problems, common.problems, solved)
        if problem is None:
            raise UsageError("All katas are solved. judge progress shows what you can do")
    return _checked(problem, _named(problem, ask.language))


def _problem_of(file: str, common: Common) -> Problem:
    """The kata that a file is for; of one that is not there yet, the kata of its name."""
    if os.path.exists(file):  # noqa: PTH110 - of any name
        _check_ordinary(Path(file), file)
        (submission,) = read_submissions([file])
        return problem_of_file(submission, "start", common)
    name = id_of(Path(file).name.partition(".")[0])
    if is_problem(name, common):
        return find_problem(name, common.problems)
    what = f"{file} is not there, and I cannot tell which kata it is for"
    raise UsageError(f"{what}. Say it: judge start KATA {file}")


def _named(problem: Problem, language: str | None = None) -> str:
    """The usual name of the problem's file. Raises UsageError for a language that nobody knows."""
    from judge.languages.model import named_language  # only where a language is named

    return file_name(problem.id.replace("-", "_"), named_language(language) if language else None)


def _checked(problem: Problem, file: str) -> Kata:
    path = Path(file).absolute()
    if os.path.exists(path):  # noqa: PTH110 - of any name
        _check_ordinary(path, file)
    return Kata(problem, path)


def _check_ordinary(path: Path, file: str) -> None:
    """Refuse what is never saved again: a folder, a pipe. Raises UsageError."""
    if not path.is_file():
        what = "this is a folder" if path.is_dir() else "this is not an ordinary file"
        raise UsageError(what, where=file or "''", remedy="name a file")

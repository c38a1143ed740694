"""`judge start`: create the file of a kata or go on with it, and judge it on every save."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Annotated

import click
from msgspec import Struct

from judge.cli.kept import history_at
from judge.cli.options import Common, command, opt, takes
from judge.cli.resolve import current, is_problem, problem_of, problem_of_file, shown, this_folder
from judge.cli.submissions import read_submissions
from judge.cli.watching import Kata, take_up
from judge.errors import UsageError
from judge.languages import file_name, is_program
from judge.practice.progress import solved
from judge.practice.stub import write_stub
from judge.practice.syllabus import next_kata, sound_sets
from judge.problem import Problem
from judge.problem.find import find_problem, id_of, sound_problems
from judge.problem.model import LEVELS
from judge.report.published_start import Begun
from judge.report.screen import is_terminal, out
from judge.report.terminal import draws


class StartAsk(Struct, frozen=True):
    """How to start."""

    language: Annotated[
        str | None,
        opt("--language", metavar="L", help="Its language: c, cpp, go, java, javascript, rust, pypy."),
    ] = None
    once: Annotated[bool, opt("--no-watch", help="Only create the file.")] = False
    reset: Annotated[bool, opt("--reset", help="Start the file over; the old text is kept as FILE.bak.")] = (
        False
    )
    level: Annotated[
        str | None,
        opt("--level", metavar="|".join(LEVELS), type=click.Choice(LEVELS), help="Judge only this level."),
    ] = None


@command("start", Begun)
@click.argument("words", metavar="[KATA] [FILE]", nargs=-1)
@takes(StartAsk, "ask")
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
    folders, db = common.problems, common.db
    if not words:
        return _usual(ask, common)
    first, file = words[0], words[1] if len(words) > 1 else None
    if file is None and not is_problem(first, folders) and (is_program(first) or os.path.exists(first)):  # noqa: PTH110 - of any name
        return _checked(_problem_of(first, common), first)
    problem = find_problem(first, folders)
    if file is not None:
        return _checked(problem, file)
    if ask.language is None:
        with history_at(db, reading=True) as history:
            here = current(this_folder(), history)
        if here and here.problem == problem.id and not os.path.exists(_named(problem)):  # noqa: PTH110 - of any name
            return Kata(problem, Path(here.path))
    return _checked(problem, _named(problem, ask.language))


def _usual(ask: StartAsk, common: Common) -> Kata:
    """The current file, as long as its kata is not solved; else the usual file of the next kata."""
    problems, _ = sound_problems(common.problems)
    with history_at(common.db, reading=True) as history:
        here, places, runs = current(this_folder(), history), history.places(), history.runs()
    done = solved(runs)
    if here is not None and (here.problem not in done or ask.reset):
        problem = problem_of(here, common.problems)
        if ask.language is None:
            return Kata(problem, Path(here.path))
        return _checked(problem, _named(problem, ask.language))
    last = here or next(iter(places), None)
    following = next_kata(
        last.problem if last else "", problems, sound_sets(problems, common.problems)[0], done
    )
    if following is None:
        raise UsageError("All katas are solved. judge progress shows what you can do")
    return _checked(following, _named(following, ask.language))


def _problem_of(file: str, common: Common) -> Problem:
    """The kata that a file is for; of one that is not there yet, the kata of its name."""
    if os.path.exists(file):  # noqa: PTH110 - of any name
        _check_ordinary(Path(file), file)
        (submission,) = read_submissions([file])
        return problem_of_file(submission, "start", common.problems, common.db)
    name = id_of(Path(file).name.partition(".")[0])
    if is_problem(name, common.problems):
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

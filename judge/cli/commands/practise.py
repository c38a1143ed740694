"""`judge start`, `hint` and `solution`: a kata's file, its hints, and its model solution once solved."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

import click
from msgspec import Struct
from msgspec.structs import replace

from judge.cli.aid import HintAsk, admit, hints, note_seen
from judge.cli.files import read_submission
from judge.cli.options import Common, command, exclusive, opt
from judge.cli.resolve import (
    KATAS,
    Kata,
    current,
    history_at,
    is_problem,
    kata_meant,
    problem_of_file,
    shown,
    take_up,
    this_folder,
)
from judge.data.libraries import LibraryTable, library_table
from judge.errors import UsageError
from judge.languages import file_name, is_program, language_of
from judge.practice.progress import solved
from judge.practice.review import read_learner
from judge.practice.solutions import approaches, chosen_approach
from judge.practice.stub import write_stub
from judge.problem import Problem
from judge.problem.find import find_problem, id_of
from judge.problem.model import LEVELS
from judge.report.published_look import Begun, HintShown, SolutionShown, Yours
from judge.report.screen import draws, is_terminal, out
from judge.run.result import Taken

_ROUNDS = 3
_PROJECT = (".git", "pyproject.toml", "setup.py", "package.json")  # what a folder of one's own work has


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

    Its file is created where there is none, in a project of yours in its folder katas/. Without a KATA: the
    file of this folder that you worked on last or, once that is solved, the next kata that you have not
    solved. The end of FILE says its language, or --language does. In a pipe, and with --no-watch, the file is
    created and no more.
    """
    kata = _meant(words, ask, common)
    created = ask.reset or not os.path.exists(kata.path)  # noqa: PTH110 - of any name
    hidden = kata.path.parent.name == KATAS
    kept = write_stub(kata.problem, kata.path, over=ask.reset, hidden=hidden) if created else None
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
            place = _place(first)
            return Kata(_problem_of(first, common), place)
        problem = find_problem(first, common.problems)
        if words[1:]:
            return Kata(problem, _place(words[1]))
    with history_at(common.db, reading=True) as history:
        here, places, runs = current(this_folder(), history), history.places(), history.runs()
    done = solved(runs)
    if problem is not None:
        own = here and here.problem == problem.id and not ask.language
        if here and own and not os.path.exists(_named(problem)):  # noqa: PTH110 - of any name
            return Kata(problem, Path(here.path))
    elif here is not None and (here.problem not in done or ask.reset):
        problem = find_problem(here.problem, common.problems)
        if ask.language is None:
            return Kata(problem, Path(here.path))
    else:
        last = here or next(iter(places), None)
        with history_at(common.db, reading=True) as history:
            problem = read_learner(history, common.problems).next(last.problem if last else "")
        if problem is None:
            raise UsageError("All katas are solved. judge progress shows what you can do")
    name = _named(problem, ask.language)
    if os.path.exists(name):  # noqa: PTH110 - of any name
        return Kata(problem, _place(name))
    mine = any((this_folder() / each).exists() for each in _PROJECT)
    folder = Path(here.path).parent if here else this_folder() / KATAS if mine else this_folder()
    return Kata(problem, _place(str(folder / name)))


def _problem_of(file: str, common: Common) -> Problem:
    """The kata that a file is for; of one that is not there yet, the kata of its name."""
    if os.path.exists(file):  # noqa: PTH110 - of any name
        submission = read_submission(file)
        return problem_of_file(submission, "start", common)
    return find_problem(id_of(Path(file).name.partition(".")[0]), common.problems)


def _named(problem: Problem, language: str | None = None) -> str:
    """The usual name of the problem's file. Raises UsageError for a language that nobody knows."""
    from judge.languages.model import named_language  # only where a language is named

    return file_name(problem.id.replace("-", "_"), named_language(language) if language else None)


def _place(file: str) -> Path:
    """The file from the root. Raises UsageError for what is never saved again: a folder, a pipe."""
    path = Path(file).absolute()
    if os.path.exists(path) and not path.is_file():  # noqa: PTH110 - of any name
        what = "this is a folder" if path.is_dir() else "this is not an ordinary file"
        raise UsageError(what, where=file or "''", remedy="name a file")
    return path


@command("hint", HintShown, ask=HintAsk)
@click.argument("name", metavar="[KATA|FILE]", required=False)
def hint(name: str | None, ask: HintAsk, common: Common) -> Iterator[HintShown]:
    """Give one more hint.

    The hint is for that kata, for the kata of a file, or for your current kata. The first hint is a nudge,
    the last is nearly the whole solution. The judge remembers which ones you have seen.
    """
    exclusive(ask, "step", "whole")
    chosen = hints(kata_meant(name, common), ask, common.db)
    try:
        note_seen(chosen[-1], common.db)  # first: what was shown counts as seen, whatever happens then
    finally:
        yield from chosen


class SolutionAsk(Struct, frozen=True):
    """Which solution, and whether to measure."""

    giving_up: bool = opt("--give-up", "Show it before you have solved the kata; this is remembered.")
    language: str | None = opt("--language L", "The one in this language: go, cpp, java …")
    times: bool = opt("--times", "Measure all approaches and yours, in each language; takes a minute.")
    libraries: bool = opt("--libraries", "What real libraries answer: a table, measured beforehand.")


@command("solution", SolutionShown, LibraryTable, ask=SolutionAsk)
@click.argument("name", metavar="[KATA", required=False)
@click.argument("approach", metavar="[APPROACH]]", required=False)
def solution(
    name: str | None, approach: str | None, ask: SolutionAsk, common: Common
) -> SolutionShown | LibraryTable:
    """Show the model solution, and why it works.

    Without KATA: that of your current kata. It is shown once yours is accepted, or with --give-up; the kata
    then comes back sooner. Below it are the other approaches by name.

    With --times you see what each approach takes for one case, beside the first one and your own.
    """
    problem = kata_meant(name, common)
    if ask.libraries:
        return library_table(problem)
    models = approaches(problem)
    model = chosen_approach(problem, models, approach, ask.language)
    yours = admit(problem, common.db, giving_up=ask.giving_up)
    programs = [(each.file, each.program.encode()) for each in models]
    if yours:
        programs.append((yours[0].submission, yours[1]))
    taken: Sequence[Taken | None] = [None] * len(programs)
    if ask.times:
        taken = _measured(problem, programs, common)
    return SolutionShown(
        problem=problem.id,
        file=model.file,
        approaches=tuple(replace(each, taken=its) for each, its in zip(models, taken, strict=False)),
        yours=Yours(yours[0].id, yours[0].submission, taken[-1]) if yours else None,
    )


def _measured(problem: Problem, programs: Sequence[tuple[str, bytes]], common: Common) -> Sequence[Taken]:
    """What each program takes for a case; why not, where its language is not installed."""
    from judge.judging import RunOptions
    from judge.judging.session import Session
    from judge.languages.find import why_not
    from judge.report.wait import progress
    from judge.run.times import TimedProgram, measure

    entries = []
    for name, source in programs:
        language = language_of(name)
        missing, warms = (why_not(language), language.factor > 1) if language else ("", False)
        entries.append(TimedProgram(name, source, missing, warms))
    with Session(problem, RunOptions(isolation=common.isolation, timed=False), bars=progress) as session:
        data = session.data
        with progress("measuring") as advance:
            return measure(data, entries, session.open_box, _ROUNDS, advance)

"""Which kata, and which files, the words of a command mean.

    judge run                  the file last started or judged in this folder
    judge run count            count.py in this folder, or another file here that was judged as count
    judge run count a.py b.py  these files, as count
    judge run a.py homework    each file says its kata: by its function, its first line, its name, or
                               its folder in solutions/

The first word is a kata where there is one of that name, even where a file is called so; `./count` is the
file. Nothing points to the current kata: it is read from the history, so looking never moves it.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from itertools import pairwise
from pathlib import Path
from shlex import quote
from typing import TYPE_CHECKING

import click
from msgspec import Struct

from judge.cli.files import SubmissionFile, Unjudged, gathered, read_submission
from judge.errors import JudgeError, StoreError, UnknownKataError, UsageError
from judge.languages import file_name, is_program
from judge.problem import Problem
from judge.problem.find import find_problem, problem_folders, shipped_problems
from judge.problem.model import is_name
from judge.report.screen import note
from judge.report.words import counted, shown_command, shown_name

if TYPE_CHECKING:
    from judge.cli.options import Common
    from judge.practice.events import Event, Started
    from judge.practice.history import History
    from judge.practice.review import Learner, Review


class Kata(Struct, frozen=True):
    """A kata and the file that is to solve it, from the root."""

    problem: Problem
    path: Path

    @property
    def name(self) -> str:
        """The file as a person would name it from here."""
        return shown(self.path)


KATAS = "katas"  # the folder for them beside a person's own project
Tasks = list[tuple[Problem, list[SubmissionFile]]]  # submissions by their kata


def resolve(words: Sequence[str], common: Common) -> tuple[Tasks, list[Unjudged]]:
    """The files that are meant, by kata in the order of their first files; and those that fit none.

    Raises JudgeError: no file is meant, or the only one cannot be read or fits none.
    """
    problem, files = _meant(words, common)
    submissions, unjudged = gathered(files, problem.id if problem else "")
    tasks: dict[str, tuple[Problem, list[SubmissionFile]]] = {}
    for each in submissions:
        try:
            kata = problem or problem_of_file(each, "run", common)
        except JudgeError as fault:
            if len(submissions) == 1:
                raise
            unjudged.append(Unjudged(each.name, fault.what))
        else:
            tasks.setdefault(kata.id, (kata, []))[1].append(each)
    return [*tasks.values()], unjudged


def kata_meant(word: str | None, common: Common) -> Problem:
    """The kata of that name, or that the file of that name is for; the current one without a word.

    Raises JudgeError.
    """
    if word is None:
        return find_problem(here(common.db).problem, common.problems)
    if is_problem(word, common) or not (is_program(word) or _is_file(word)):
        return find_problem(word, common.problems)
    return problem_of_file(read_submission(word), "hint", common)


# -- the history, and the current kata -----------------------------------------------------------------------


@contextmanager
def history_at(path: Path | None, *, reading: bool = False) -> Iterator[History]:
    """As `History`; afterwards a note says what was left out or set aside, each once a command."""
    from judge.practice.history import History

    with History(path, reading=reading) as history:
        try:
            yield history
        finally:
            context = click.get_current_context(silent=True)
            said: set[object] = set() if context is None else context.meta.setdefault(__name__, set())
            if found := len(history.left_out - said):
                note(f"{counted(found, 'damaged row')} left out of the history")
            said |= history.left_out
            if history.set_aside is not None:
                name = shown_name(str(history.set_aside))
                note(f"the history was damaged: it is kept as {name}, and a new one is begun")


def take_up(kata: Kata, db: Path | None) -> None:
    """Note that the kata was started; the folder of one that every judge finds by itself is not kept."""
    from judge.practice.events import Started

    folder = kata.problem.folder.parent.absolute()
    keep(Started(kata.problem.id, str(kata.path), "" if folder == shipped_problems() else str(folder)), db)


def keep(event: Event, db: Path | None) -> None:
    """Keep it in the history; one that fails does not stand in the way of what came of it."""
    try:
        with history_at(db) as history:
            history.keep(event)
    except StoreError as fault:
        note(f"not kept in the history: {fault}")


def current(folder: Path, history: History) -> Started | None:
    """The file last started or judged in that folder or its katas/, of those that are there; or None."""
    return next(filter(is_there, _in(folder, history.places())), None)


def here(db: Path | None, problem: str = "") -> Started:
    """The current file of this folder, or the last one of that kata here.

    Raises UsageError, which says where the last one is; StoreError.
    """
    with history_at(db, reading=True) as history:
        places = [each for each in history.places() if problem in ("", each.problem)]
    mine, there = _in(this_folder(), places), list(filter(is_there, places))
    for each in filter(is_there, mine):
        return each
    gone, remedy = "You have not started a kata here", "Type: judge start"
    if kata := problem or (mine[0].problem if mine else ""):
        name = shown(mine[0].path) if mine else file_name(kata.replace("-", "_"))
        gone, remedy = f"{name} is not in this folder", f"Create it: judge start {kata}"
    last = f" The last one is {there[0].path}." if there else ""
    raise UsageError(f"{gone}.{last} {remedy}")


def this_folder() -> Path:
    """The current folder; one that is gone stands for no folder at all."""
    try:
        return Path.cwd()
    except OSError:
        return Path()


def shown(path: str | Path) -> str:
    """An absolute path as a person in the current folder would write it."""
    try:
        return str(Path(path).relative_to(this_folder()))
    except ValueError:  # it is elsewhere, or the current folder is gone
        return str(path)


def _in(folder: Path, places: Sequence[Started]) -> list[Started]:
    """Those in the folder, or in its katas/."""
    both = (str(folder), str(folder / KATAS))
    return [each for each in places if os.path.normpath(os.path.dirname(each.path)) in both]  # noqa: PTH120


def is_there(place: Started) -> bool:
    """Whether its file still is."""
    return os.path.isfile(place.path)  # noqa: PTH113


def _places(db: Path | None) -> list[Started]:
    """All files that were started or judged; none where the history fails: whoever needs it says so."""
    with suppress(StoreError), history_at(db, reading=True) as history:
        return history.places()
    return []


# -- words ---------------------------------------------------------------------------------------------------


def _meant(words: Sequence[str], common: Common) -> tuple[Problem | None, Sequence[str]]:
    """The kata, None where each file tells its own, and the files, at least one.

    Raises JudgeError: the first word is neither a kata nor a file, or there is no file.
    """
    if not words:
        found = here(common.db)
        return find_problem(found.problem, common.problems), (shown(found.path),)
    first, *rest = words = ["/dev/stdin" if word == "-" else word for word in words]
    if is_problem(first, common):
        try:
            files = rest or [usual_file(first, common.db)]
        except JudgeError:
            if not os.path.lexists(first):
                raise
        else:
            return find_problem(first, common.problems), files
    elif not (is_program(first) or _is_file(first)):
        find_problem(first, common.problems)  # which says what is near
    for word in rest:
        if not os.path.lexists(word) and is_problem(word, common):
            raise UsageError(f"The kata comes first: judge run {word} FILE")
    return None, words


def problem_of_file(submission: SubmissionFile, command: str, common: Common) -> Problem:
    """The kata that a file is for, told from its text and name, or from having been judged before.

    Raises:
        UsageError: none fits, or several do; it says how to choose.
        ProblemError: the one that fits is broken.
    """
    from judge.problem.find import fitting_problems, meant_problem, signs  # only where no kata is named

    file, folders = submission.name, common.problems
    found = signs(submission.source, file)
    fitting = fitting_problems(found, folders)
    if len(fitting) == 1:
        return fitting[0]
    path, names = Path(file).absolute(), [each.id for each in fitting]
    for above, name in pairwise(path.parent.parts):
        if above == "solutions" and (not names or name in names) and is_problem(name, common):
            return find_problem(name, folders)
    if known := next((each for each in _places(common.db) if each.path == str(path)), None):
        return find_problem(known.problem, folders)
    what, name, how = "I cannot tell which kata this file is for", "KATA", "say it: {}"
    if names:
        what, name, how = f"this file fits {' and '.join(names)}", names[0], "'{}' takes the first"
    elif near := meant_problem(found, folders):
        defined, entry, name = near
        what = f"this file defines {defined}; did you mean {entry}, of {name}?"
        how = "rename it, or write '{}'"
    raise UsageError(what, where=file, remedy=how.format(shown_command("judge", command, name, file=file)))


def say_where(fault: UnknownKataError, db: Path | None) -> None:
    """Tell of a kata that was started or judged elsewhere where its folder is, or was.

    It is only told: a history may be anybody's, and a kata is code.
    """
    for each in _places(db):
        if each.problem == fault.name and each.problems:
            fault.remedy = f"it was in {each.problems}: name its folder with --problems"
            if os.path.isdir(os.path.join(each.problems, fault.name)):  # noqa: PTH112, PTH118
                fault.remedy = f"add --problems {quote(shown(each.problems))}"
            return


def is_problem(word: str, common: Common) -> bool:
    """Whether a kata has that name; installed packs are searched where no nearer one has."""
    found = (problem_folders(common.problems, installed=installed) for installed in (False, True))
    return is_name(word) and any(word == each.name for folders in found for each in folders)


def usual_file(problem: str, db: Path | None) -> str:
    """The kata's file in this folder: of the usual name, or the last one that was judged as that kata.

    Raises UsageError where there is none, StoreError.
    """
    usual = file_name(problem.replace("-", "_"))
    for name in (usual, f"{KATAS}/{usual}"):
        if os.path.lexists(name):
            return name
    return shown(here(db, problem).path)


def _is_file(word: str) -> bool:
    """Whether there is something of that name to be judged, and not a kata's own folder."""
    return os.path.lexists(word) and not os.path.exists(os.path.join(word, "problem.toml"))  # noqa: PTH110, PTH118


def seen_cards(learner: Learner) -> list[Review]:
    """The cards that were answered; whoever has answered none waits for no deck."""
    if not learner.answers:
        return []
    from judge.practice.cards import known_cards

    return known_cards(learner.answers, learner.extra)

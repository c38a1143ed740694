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
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING

from msgspec import Struct

from judge.errors import JudgeError, StoreError, UsageError
from judge.languages import file_name, is_program
from judge.problem import Problem
from judge.problem.find import find_problem, near_problem_folders, problem_folders, shipped_problems
from judge.problem.model import is_name

if TYPE_CHECKING:
    from judge.cli.options import Common
    from judge.cli.submissions import Submission, Unjudged
    from judge.practice.events import Started
    from judge.practice.history import History


class Task(Struct, frozen=True):
    """Submissions to one kata."""

    problem: Problem
    submissions: tuple[Submission, ...]


def resolve(words: Sequence[str], common: Common) -> tuple[list[Task], list[Unjudged]]:
    """The files that are meant, by kata in the order of their first files; and those that fit none.

    Raises JudgeError: no file is meant, or the only one cannot be read or fits none.
    """
    folders, db = common.problems, common.db
    from judge.cli.submissions import gathered  # not where somebody only looks

    if words:
        name, files = split(words, "run", folders, db)
        problem = find_problem(name, folders) if name else None
    else:
        found = here(db)
        problem, files = problem_of(found, folders), (shown(found.path),)
    submissions, unread = gathered(files, problem.id if problem else "")
    tasks, unfit = assigned(submissions, problem, folders, db)
    return tasks, [*unread, *unfit]


def kata_meant(word: str | None, common: Common) -> Problem:
    """The kata of that name, or that the file of that name is for; the current one without a word.

    Raises JudgeError.
    """
    if word is None:
        return problem_of(here(common.db), common.problems)
    return problem_meant(word, common.problems, common.db)


# -- the current kata ----------------------------------------------------------------------------------------


def current(folder: Path, history: History) -> Started | None:
    """The file last started or judged in that folder, of those that are still there; None without one."""
    there = (each for each in history.places() if _within(each, folder) and os.path.isfile(each.path))  # noqa: PTH113
    return next(there, None)


def here(db: Path | None) -> Started:
    """The current file of this folder. Raises UsageError, which says where the last one is; StoreError."""
    from judge.cli.kept import history_at

    folder = this_folder()
    with history_at(db, reading=True) as history:
        found, places = current(folder, history), history.places()
    if found is not None:
        return found
    for each in places:
        if _within(each, folder):
            what = f"{shown(each.path)} is not in this folder"
            raise UsageError(f"{what}. Create it: judge start {each.problem}")
    what = "You have not started a kata here."
    last = next((each.path for each in places if os.path.isfile(each.path)), None)  # noqa: PTH113
    if last is not None:
        raise UsageError(f"{what} The last one is {last}. To start one in this folder: judge start")
    raise UsageError(f"{what} Type: judge start")


def problem_of(found: Started, folders: Sequence[Path]) -> Problem:
    """The kata of a file that was started or judged, looked for also where it was then. Raises JudgeError."""
    kept = Path(found.problems) if found.problems else None
    try:
        return find_problem(found.problem, (*folders, *([kept] if kept and kept.is_dir() else [])))
    except UsageError as fault:
        if kept is None or kept.is_dir():
            raise
        what = f"the kata {found.problem} is not there any more"
        raise UsageError(what, where=str(kept), remedy="name its folder with --problems") from fault


def folder_to_keep(problem: Problem) -> str:
    """Where a kata must be looked for later: "" where every judge finds it by itself."""
    folder = problem.folder.parent.absolute()
    return "" if folder == shipped_problems() else str(folder)


def this_folder() -> Path:
    """The current folder; one that is gone stands for no folder at all."""
    try:
        return Path.cwd()
    except OSError:
        return Path()


def shown(path: str | Path) -> str:
    """An absolute path as a person in the current folder would write it."""
    try:
        return str(Path(path).relative_to(Path.cwd()))
    except (ValueError, OSError):  # it is elsewhere, or the current folder is gone
        return str(path)


def _within(place: Started, folder: Path) -> bool:
    return os.path.normpath(os.path.dirname(place.path)) == str(folder)  # noqa: PTH120


def _places(db: Path | None) -> list[Started]:
    """All files that were started or judged; none where the history fails: whoever needs it says so."""
    try:
        from judge.practice.history import History

        with History.open(db, reading=True) as history:
            return history.places()
    except StoreError:
        return []


# -- words ---------------------------------------------------------------------------------------------------


def split(
    words: Sequence[str], command: str, folders: Sequence[Path], db: Path | None
) -> tuple[str | None, tuple[str, ...]]:
    """The kata's name, None where the files tell it, and the files, at least one.

    Raises:
        UsageError: the first word is neither a kata nor a file, or there is no file.
    """
    first, *rest = words
    own = is_problem(first, folders)
    for word in rest if own else words:
        if _is_file(f"{word}/problem.yaml") or (word.endswith((".zip", ".kpp")) and _is_file(word)):
            remedy = "bt run and verifyproblem judge on it; see 'judge help packages'"
            raise UsageError("this is a package of another judge", where=word, remedy=remedy)
    if own and rest:
        return first, tuple(rest)
    if own:
        try:
            return first, (usual_file(first, db),)
        except UsageError:
            if not os.path.lexists(first):
                raise
    elif not (is_program(first) or _is_file(first)):
        find_problem(first, folders)  # which says what is near
    for word in rest:
        if not os.path.lexists(word) and is_problem(word, folders):
            raise UsageError(f"The kata comes first: judge {command} {word} FILE")
    return None, tuple(words)


def assigned(
    submissions: Sequence[Submission], problem: Problem | None, folders: Sequence[Path], db: Path | None
) -> tuple[list[Task], list[Unjudged]]:
    """The submissions by kata, all to `problem` or each to its own; and of several those that fit none.

    Raises JudgeError where that is so of the only one.
    """
    if problem is not None:
        return ([Task(problem, tuple(submissions))] if submissions else []), []
    from judge.cli.submissions import Unjudged

    problems: dict[str, Problem] = {}
    mine: dict[str, list[Submission]] = {}
    unfit = []
    for submission in submissions:
        try:
            found = problem_of_file(submission, "run", folders, db)
        except JudgeError as fault:
            if len(submissions) == 1:
                raise
            unfit.append(Unjudged(submission.name, fault.what))
            continue
        problems.setdefault(found.id, found)
        mine.setdefault(found.id, []).append(submission)
    return [Task(problems[name], tuple(own)) for name, own in mine.items()], unfit


def problem_meant(word: str, folders: Sequence[Path], db: Path | None) -> Problem:
    """The kata of that name, or the one that the file of that name is for. Raises JudgeError."""
    if is_problem(word, folders) or not (is_program(word) or _is_file(word)):
        return find_problem(word, folders)
    from judge.cli.submissions import read_submissions

    (submission, *_) = read_submissions([word])
    return problem_of_file(submission, "hint", folders, db)


def problem_of_file(
    submission: Submission, command: str, folders: Sequence[Path], db: Path | None
) -> Problem:
    """The kata that a file is for, told from its text and name, or from having been judged before.

    Raises:
        UsageError: none fits, or several do; it says how to choose.
        ProblemError: the one that fits is broken.
    """
    from judge.problem.find import fitting_problems, meant_problem, signs  # only where no kata is named
    from judge.report.words import shown_command

    found = signs(submission.source, submission.name)
    fitting = fitting_problems(found, folders)
    if len(fitting) == 1:
        return fitting[0]
    path = Path(submission.name).absolute()
    for above, name in pairwise(path.parent.parts):
        meant = above == "solutions" and (not fitting or name in [each.id for each in fitting])
        if meant and is_problem(name, folders):
            return find_problem(name, folders)
    if known := next((each for each in _places(db) if each.path == str(path)), None):
        return problem_of(known, folders)
    if fitting:
        names = [problem.id for problem in fitting]
        chosen = shown_command("judge", command, names[0], file=submission.name)
        what = f"this file fits {' and '.join(names)}"
        raise UsageError(what, where=submission.name, remedy=f"'{chosen}' takes the first")
    if near := meant_problem(found, folders):
        name, entry, problem = near
        what = f"this file defines {name}; did you mean {entry}, of {problem}?"
        chosen = shown_command("judge", command, problem, file=submission.name)
        raise UsageError(what, where=submission.name, remedy=f"rename it, or write '{chosen}'")
    chosen = shown_command("judge", command, "KATA", file=submission.name)
    what = "I cannot tell which kata this file is for"
    raise UsageError(what, where=submission.name, remedy=f"say it: {chosen}")


def is_problem(word: str, folders: Sequence[Path]) -> bool:
    """Whether a kata has that name; installed packs are searched where no nearer one has."""
    if not is_name(word):
        return False
    near = [folder.name for folder in near_problem_folders(folders)]
    return word in near or word in [folder.name for folder in problem_folders(folders)]


def usual_file(problem: str, db: Path | None) -> str:
    """The kata's file in this folder: of the usual name, or the last one that was judged as that kata.

    Raises:
        UsageError: there is none.
    """
    usual = file_name(problem.replace("-", "_"))
    if os.path.lexists(usual):
        return usual
    folder = this_folder()
    mine = [each for each in _places(db) if each.problem == problem and os.path.isfile(each.path)]  # noqa: PTH113
    for each in mine:
        if _within(each, folder):
            return shown(each.path)
    where = f" The last one is {mine[0].path}." if mine else ""
    raise UsageError(f"{usual} is not in this folder.{where} Create it: judge start {problem}")


def _is_file(word: str) -> bool:
    """Whether there is something of that name to be judged, and not a kata's own folder."""
    return os.path.lexists(word) and not os.path.exists(os.path.join(word, "problem.toml"))  # noqa: PTH110, PTH118

"""What the words of a command mean: a problem and files, or files that tell their problem themselves.

The first word is the problem if there is one of that name, even where a file is called so; `./count` is the
file. A problem without a file means its usual one, count.py, or that of the kata in hand.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from msgspec import Struct

from judge.cli.submissions import Submission, Unjudged, read_submissions
from judge.cli.wish import named_problem
from judge.errors import HistoryError, JudgeError, UsageError
from judge.languages import file_name, is_program
from judge.problem import Problem
from judge.problem.find import find_problem, near_problem_folders, problem_folders
from judge.problem.names import is_name

if TYPE_CHECKING:
    from judge.kata.events import Started


def split(
    words: Sequence[str], command: str, folders: Sequence[Path], db: Path | None
) -> tuple[str | None, tuple[str, ...]]:
    """The problem's name, None where the files tell it, and the files, at least one.

    Raises:
        UsageError: the first word is neither a problem nor a file, or there is no file.
    """
    first, *rest = words
    own = is_problem(first, folders)
    for word in rest if own else words:
        if _is_package(word):
            remedy = "bt run and verifyproblem judge on it; see 'judge help packages'"
            raise UsageError("this is a package of another judge", where=word, remedy=remedy)
    if own:
        if rest:
            return first, tuple(rest)
        if _usual_file(first, db) is not None or not os.path.lexists(first):
            named_problem(first, folders)  # whose own complaint goes first
            return first, (usual_file(first, f"{command} {first}", db),)
    elif not (is_program(first) or _is_file(first)):
        named_problem(first, folders)
    for word in rest:
        if not os.path.lexists(word) and is_problem(word, folders):
            remedy = f"the problem comes first: judge {command} PROBLEM FILE"
            raise UsageError(f"{first!r} is no problem's name", remedy=remedy)
    return None, tuple(words)


class Task(Struct, frozen=True):
    """Submissions to one problem."""

    problem: Problem
    submissions: tuple[Submission, ...]


def assigned(
    submissions: Sequence[Submission], problem: Problem | None, folders: Sequence[Path], db: Path | None
) -> tuple[list[Task], list[Unjudged]]:
    """The submissions by problem, in the order of the first of each: all to `problem`, or each to its own.

    Of several, those that no problem can be found for are apart.

    Raises:
        JudgeError: that is so of the only one; as `problem_of_file`.
    """
    if problem is not None:
        return ([Task(problem, tuple(submissions))] if submissions else []), []
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
    """The problem of that name, or the one that the file of that name is to solve. Raises UsageError."""
    if is_problem(word, folders) or not (is_program(word) or _is_file(word)):
        return find_problem(word, folders)
    (submission, *_) = read_submissions([word])
    return problem_of_file(submission, "hint", folders, db)


def problem_of_file(
    submission: Submission, command: str, folders: Sequence[Path], db: Path | None
) -> Problem:
    """The problem that a file is to solve, told from its text and name, or from being the kata in hand.

    Raises:
        UsageError: none fits, or several do; it says how to choose.
        ProblemError: the one that fits is broken.
    """
    from judge.problem.fit import fitting_problems, meant_problem, signs  # only where no problem is named
    from judge.report.names import shown_command

    found = signs(submission.source, submission.name)
    fitting = fitting_problems(found, folders)
    if len(fitting) != 1:
        in_hand = _in_hand(submission.name, folders, db)
        if in_hand is not None:
            return in_hand
    if len(fitting) > 1:
        names = [problem.id for problem in fitting]
        chosen = shown_command("judge", command, names[0], file=submission.name)
        what = f"this file fits {' and '.join(names)}"
        raise UsageError(what, where=submission.name, remedy=f"'{chosen}' takes the first")
    if fitting:
        return fitting[0]
    meant = meant_problem(found, folders)
    if meant is not None:
        name, entry, problem = meant
        what = f"this file defines {name}; did you mean {entry}, of {problem}?"
        chosen = shown_command("judge", command, problem, file=submission.name)
        raise UsageError(what, where=submission.name, remedy=f"rename it, or write '{chosen}'")
    what = "this file defines no problem's function, and is called like none"
    remedy = f"name the problem: judge {command} PROBLEM FILE; 'judge list' has them"
    raise UsageError(what, where=submission.name, remedy=remedy)


def _is_package(word: str) -> bool:
    return _is_file(f"{word}/problem.yaml") or (word.endswith((".zip", ".kpp")) and _is_file(word))


def is_problem(word: str, folders: Sequence[Path]) -> bool:
    """Whether a problem has that name; installed packs are searched where no nearer one has."""
    if not is_name(word):
        return False
    near = [folder.name for folder in near_problem_folders(folders)]
    return word in near or word in [folder.name for folder in problem_folders(folders)]


def _is_file(word: str) -> bool:
    """Whether there is something of that name to be judged, and not a problem's own folder."""
    return os.path.lexists(word) and not os.path.exists(os.path.join(word, "problem.toml"))  # noqa: PTH110, PTH118


def usual_name(problem: str) -> str:
    """The usual name of the file that solves a problem."""
    return file_name(problem.replace("-", "_"))


def usual_file(problem: str, command: str, db: Path | None) -> str:
    """The problem's file in the current folder, or that of the kata in hand if this is its problem.

    Raises:
        UsageError: there is none; `command` is what lacks it.
    """
    file = _usual_file(problem, db)
    if file is None:
        what = f"missing argument 'FILE', and there is no {usual_name(problem)} here"
        remedy = f"write judge {command} FILE, or begin one with 'judge init {problem}'"
        raise UsageError(what, remedy=remedy)
    return file


def _usual_file(problem: str, db: Path | None) -> str | None:
    usual = usual_name(problem)
    if os.path.lexists(usual):
        return usual
    from judge.cli.kata import shown

    current = _current(db)
    if current is not None and current.problem == problem and Path(current.path).exists():
        return shown(current.path)
    return None


def _in_hand(name: str, folders: Sequence[Path], db: Path | None) -> Problem | None:
    """The problem of the kata in hand, if this is its file."""
    from judge.cli.kata import problem_of

    current = _current(db)
    if current is None or current.path != str(Path(name).absolute()):
        return None
    return problem_of(current, folders)


def _current(db: Path | None) -> Started | None:
    """The kata in hand; None, too, where the history cannot be read: whoever needs it says so."""
    from judge.kata.history import History

    try:
        with History.open(db, reading=True) as history:
            return history.current()
    except HistoryError:
        return None

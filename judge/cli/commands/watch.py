"""`judge watch`: judge a file again on every save."""

from __future__ import annotations

import stat
import sys
from collections.abc import Sequence
from contextlib import closing, suppress
from pathlib import Path
from queue import SimpleQueue
from types import FrameType
from typing import NoReturn

import click

from judge.cli.fitting import problem_of_file, split
from judge.cli.judging_options import (
    isolation_option,
    no_history_option,
    no_name_option,
    no_shrink_option,
)
from judge.cli.kata import Kata, file_in_hand, problem_of, take_up, with_folder_of
from judge.cli.options import (
    db_option,
    group_option,
    json_option,
    level_option,
    problems_option,
    seed_option,
    write_json,
)
from judge.cli.outputs import show_result
from judge.cli.submissions import read_submissions
from judge.cli.watching import WatchedFile, await_event, handled
from judge.cli.wish import Wish, named_problem
from judge.errors import ExitCode, HistoryError, UsageError
from judge.judging.job import RunOptions
from judge.kata.saves import Saves
from judge.problem import Problem
from judge.problem.model import chosen_groups
from judge.report.screen import is_terminal, note, out
from judge.report.terminal import draws

_ENDINGS = ("SIGTERM", "SIGHUP")


@click.command("watch")
@click.argument("first", metavar="[[PROBLEM]", required=False)
@click.argument("file", metavar="FILE]", required=False)
@json_option
@group_option
@level_option
@seed_option
@no_name_option
@isolation_option
@no_shrink_option
@no_history_option
@db_option
@problems_option
def command(
    first: str | None,
    file: str | None,
    as_json: bool,
    groups: tuple[str, ...],
    kata_level: str | None,
    seed: int | None,
    no_name: bool,
    level: str | None,
    unshrunk: bool,
    unrecorded: bool,
    db: Path | None,
    folders: tuple[Path, ...],
) -> ExitCode:
    """Judge a file again on every save.

    Without arguments: the file of your current kata. Otherwise name a file or a problem, as for judge run. On
    a terminal, single keys show a hint, the list, a picture of the failing case or what its test group tests,
    go on to the next kata, judge again, or quit. Elsewhere each result is written as judge run does.
    """
    if first is None:
        current, file = file_in_hand(db)
        kata = _kata(problem_of(current, folders), file)
        folders = with_folder_of(current, folders)
    else:
        kata = _named(first, file, folders, db)
    chosen_groups(kata.problem, groups, kata_level)  # a name that is none is told before anything else
    options = RunOptions(groups, seed, level, diagnosed=not unshrunk, named=not no_name, level=kata_level)
    wish = Wish(options, kept=not unrecorded, db=db)
    if not unrecorded:
        _take_up(kata, db)
    with handled(dict.fromkeys(_ENDINGS, _leave)):
        if as_json or not (draws(out()) and is_terminal(sys.stdin)):
            with closing(WatchedFile(kata, wish)) as watched:
                _write_on(watched, as_json=as_json)
        from judge.cli.watch_screen import watch_on_screen  # what draws and reads keys, for who sits there

        return watch_on_screen(kata, wish, folders)


def _leave(number: int, _frame: FrameType | None) -> NoReturn:
    """End like any program that was asked to, but after clearing up."""
    raise SystemExit(128 + number)


def _named(first: str, file: str | None, folders: Sequence[Path], db: Path | None) -> Kata:
    """The kata of a problem and a file, or of one of them."""
    if file is not None:
        return _kata(named_problem(first, folders), file)
    name, (file, *_) = split((first,), "watch", folders, db)
    if name is not None:
        return _kata(named_problem(name, folders), file)
    _check_watchable(Path(file), file)
    (submission,) = read_submissions([file])
    return _kata(problem_of_file(submission, "watch", folders, db), file)


def _kata(problem: Problem, file: str) -> Kata:
    path = Path(file)
    _check_watchable(path, file)
    try:
        read_submissions([file])
    except UsageError as fault:
        if path.exists() or not path.parent.is_dir():
            raise
        raise UsageError(
            "no such file", where=file, remedy=f"'judge init {problem.id} {file}' begins it"
        ) from fault
    return Kata(problem, path.absolute())


def _check_watchable(path: Path, name: str) -> None:
    """Refuse what is never saved again: a folder, a pipe. Raises UsageError."""
    with suppress(OSError, ValueError):  # reading it says why
        mode = path.stat().st_mode
        if not stat.S_ISREG(mode):
            what = "this is a folder" if stat.S_ISDIR(mode) else "this is no ordinary file"
            raise UsageError(what, where=name, remedy="name the file to watch")


def _take_up(kata: Kata, db: Path | None) -> None:
    """Make it the kata in hand; a history that fails does not stand in the way."""
    try:
        take_up(kata, db)
    except HistoryError as fault:
        note(f"not kept in the history: {fault}")


def _write_on(watched: WatchedFile, *, as_json: bool) -> NoReturn:
    """Write every result, for whoever is no terminal; ends when the process does."""
    events: SimpleQueue[str] = SimpleQueue()

    def tell() -> None:
        events.put("saved")
        watched.look()

    with Saves(watched.kata.path, tell):
        while True:
            if watched.saved():
                found = None
                with watched.judging:
                    found = watched.judge()
                if found is None:  # saved again meanwhile
                    continue
                if isinstance(found, str):
                    note(found)
                elif as_json:
                    write_json(found.result.as_json())
                else:
                    show_result(found)
            await_event(events)

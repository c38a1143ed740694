"""`--save-regression`: the smallest failing case as a pytest case."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from judge.atomic import replace_file
from judge.cli.target import check_place
from judge.data.model import ProblemData
from judge.errors import UsageError
from judge.run.function import FunctionRunner
from judge.run.result import Result


def agree_on(path: Path) -> None:
    """Make sure that cases may be written to `path`, before anything is judged.

    A file that somebody else wrote is emptied if the person at the terminal says so.

    Raises:
        UsageError: it may not, or its folder is missing.
    """
    from judge.diagnose.regression import is_ours

    check_place(path, "--save-regression")
    if not path.exists() or is_ours(path):
        return
    where, what = str(path), "this file was not written by --save-regression"
    if not sys.stdin.isatty():
        raise UsageError(what, where=where, remedy="name another one")
    if not click.confirm(f"{path}: {what}; write over it?", err=True):
        raise UsageError("left as it is", where=where, remedy="name another file")
    replace_file(path, b"")


def save_regression(path: Path, data: ProblemData, result: Result) -> tuple[str, ...]:
    """Add the case that breaks the submission to `path`; what to say of that, if anything failed.

    Raises:
        UsageError: the file cannot be written.
        ProblemError: the reference fails.
    """
    if result.failure is None:
        return ()
    name, found = result.submission, result.counterexample
    if found is None or found.replay is None:
        return (f"{name} fails on no case by itself; {path} is as it was",)
    if result.mode is not FunctionRunner.mode:
        return (f"{name} is a program, not a function; {path} is as it was",)
    from judge.diagnose.regression import add_case

    added = add_case(path, Path(name), data, found)
    return (f"{path} {'now holds' if added else 'already held'} {found.replay}",)

"""Asking before `--save-regression` writes over a file that it has not written."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from judge.cli.target import check_place
from judge.data.atomic import replace_file
from judge.diagnose.regression import is_ours
from judge.errors import UsageError


def agree_on(path: Path) -> None:
    """Make sure that cases may be written to `path`, before anything is judged.

    A file that somebody else wrote is emptied if the person at the terminal says so.

    Raises:
        UsageError: it may not, or its folder is missing.
    """
    check_place(path, "--save-regression")
    if not path.exists() or is_ours(path):
        return
    where, what = str(path), "this file was not written by --save-regression"
    if not sys.stdin.isatty():
        raise UsageError(what, where=where, remedy="name another one")
    if not click.confirm(f"{path}: {what}; write over it?", err=True):
        raise UsageError("left as it is", where=where, remedy="name another file")
    replace_file(path, b"")

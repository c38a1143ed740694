"""Bringing back the source that a run judged."""

from __future__ import annotations

import hashlib
from pathlib import Path

from msgspec import Struct

from judge.atomic import new_file, replace_file
from judge.cli.kata import shown
from judge.cli.target import check_place
from judge.errors import UsageError, unwritable
from judge.kata.history import History, Run
from judge.reading import read_ordinary

_OPTION = "--out"


class Restored(Struct, frozen=True):
    """Where a run's source is again: `file` as seen from here, and whether that wrote anything.

    `over` says that another source was there; `kept_in` is the latest run that judged that one, None where no
    run keeps it.
    """

    run: Run
    file: str
    written: bool
    over: bool = False
    kept_in: int | None = None


def restore(history: History, number: int, target: Path | None, *, force: bool) -> Restored:
    """Write the source of that run to `target`, or to where it was; over another source only with `force`.

    Raises:
        UsageError: there is no such run, it was judged from no file, another source is there, or the place
            cannot be written.
        HistoryError: the source is damaged.
    """
    run = history.run(number)
    source = history.source(number)
    if target is None:
        if not run.path:
            raise UsageError(f"run {number} judged no ordinary file", remedy=f"name one with {_OPTION} FILE")
        target = Path(run.path)
    file = shown(target)
    check_place(target, _OPTION)
    try:
        there = read_ordinary(target) if target.exists() else None
        if there == source:
            return Restored(run, file, written=False)
        if there is None:
            new_file(target, source)
            return Restored(run, file, written=True)
        if not force:
            what = f"another source is there than the one of run {number}"
            raise UsageError(what, where=file, remedy=f"--force writes over it, {_OPTION} FILE elsewhere")
        kept = history.latest_of(hashlib.sha256(there).hexdigest())
        replace_file(target, source)
    except OSError as fault:
        raise unwritable(target, fault, f"name another file with {_OPTION}") from fault
    return Restored(run, file, written=True, over=True, kept_in=kept)

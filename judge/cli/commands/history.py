"""`judge history`: the runs so far."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Sequence
from itertools import count
from pathlib import Path
from typing import Any

import click

from judge.atomic import new_file, replace_file
from judge.cli.kata import shown
from judge.cli.kept import history_at
from judge.cli.options import db_option, json_option, problems_option, write_json
from judge.cli.target import check_place
from judge.errors import ExitCode, UsageError, unwritable
from judge.kata.events import Run
from judge.problem.find import find_problem
from judge.reading import read_ordinary
from judge.report.history import history_lines, restored_lines
from judge.report.layout import line
from judge.report.screen import out

SCHEMA = 1
_COLUMNS = (  # of the CSV: the keys of a run's object
    *("run", "time", "problem", "submission", "path", "verdict", "score"),
    *("mode", "mistake", "ratio", "passed", "failed", "levels", "source"),
)
_OUT = "--out"
_ON_SCREEN = 20  # runs, unless it is said how many


@click.command("history")
@click.argument("name", metavar="[PROBLEM]", required=False)
@click.option("--limit", type=click.IntRange(1), metavar="N", help="Only the last N runs.")
@click.option(
    "--restore", "number", type=int, metavar="RUN", help="Write the source of that run to its file again."
)
@click.option(
    _OUT,
    "target",
    metavar="FILE",
    type=click.Path(path_type=Path),
    help="Restore it to this file instead.",
)
@json_option
@click.option("--csv", "as_csv", is_flag=True, help="Write CSV, one run a line.")
@db_option
@problems_option
def command(
    name: str | None,
    limit: int | None,
    number: int | None,
    target: Path | None,
    as_json: bool,
    as_csv: bool,
    db: Path | None,
    folders: tuple[Path, ...],
) -> ExitCode:
    """Show the runs so far.

    The latest is last. With a PROBLEM, only its runs. The screen shows the last 20 unless --limit says
    otherwise; JSON and CSV have all of them.

    With --restore, the source that a run judged is written to its file again. If that file has changed since,
    what was there is kept as FILE.bak.

    A run that is damaged is left out, and a note says so. If the file cannot be read, it is renamed to
    FILE.damaged-1, a new one is begun, and a note says that.
    """
    if as_json and as_csv:
        raise UsageError("--json and --csv exclude each other", remedy="give one of them")
    if number is not None:
        if as_csv or limit is not None or name is not None:
            raise UsageError("--restore goes with --out alone", remedy="leave the rest out")
        return _restore(number, target, db, as_json=as_json)
    if target is not None:
        raise UsageError("--out goes with --restore RUN", remedy="say which run")
    on_screen = not (as_json or as_csv)
    with history_at(db, reading=True) as history:
        most = _ON_SCREEN + 1 if on_screen and limit is None else limit
        runs = history.runs(name, most)
        if not on_screen:
            runs = history.with_results(runs)
        if not runs and name is not None:
            _check(name, folders, {run.problem for run in history.runs()})
    if as_json:
        for run in runs:
            write_json(as_object(run) | {"result": run.result.as_json()})
    elif as_csv:
        _write_csv(runs)
    elif runs:
        screen = out()
        rows = runs if limit is not None else runs[-_ON_SCREEN:]
        screen.show(history_lines(rows, screen.width, more=len(rows) < len(runs)))
    else:
        out().show([line(f"No runs yet; 'judge run {name or 'PROBLEM'} FILE' adds one.")])
    return ExitCode.ACCEPTED


def _restore(number: int, target: Path | None, db: Path | None, *, as_json: bool) -> ExitCode:
    """Write the source of that run to `target`, or to where it was; what is there is kept beside it."""
    with history_at(db, reading=True) as history:
        run, source = history.run(number), history.source(number)
    if target is None:
        if not run.path:
            raise UsageError(f"run {number} judged no ordinary file", remedy=f"name one with {_OUT} FILE")
        target = Path(run.path)
    check_place(target, _OUT)
    kept = None
    try:
        there = read_ordinary(target) if target.exists() else None
        if there not in (None, source):
            kept = _kept_beside(target, there or b"")
        if there != source:
            replace_file(target, source)
    except OSError as fault:
        raise unwritable(target, fault, f"name another file with {_OUT}") from fault
    file, kept_as = shown(target), shown(kept) if kept else None
    if as_json:
        told = {"run": number, "problem": run.problem, "source": run.source_hash, "file": file}
        write_json({"schema": SCHEMA, **told, "written": there != source, "kept_as": kept_as})
    else:
        screen = out()
        screen.show(restored_lines(run, file, kept_as, screen.width, written=there != source))
    return ExitCode.ACCEPTED


def _kept_beside(path: Path, content: bytes) -> Path:
    """A new file with that content, FILE.bak or the next free name. Raises OSError."""
    for number in count():
        beside = path.with_name(f"{path.name}.bak{number or ''}")
        with contextlib.suppress(FileExistsError):
            new_file(beside, content)
            return beside
    raise AssertionError


def as_object(run: Run) -> dict[str, Any]:
    """The published object of one run, without what it came to in full."""
    return {
        "schema": SCHEMA,
        "run": run.id,
        "time": run.when.isoformat(),
        "problem": run.problem,
        "submission": run.submission,
        "path": run.path,
        "verdict": run.verdict.value,
        "score": run.score,
        "mode": run.mode.value,
        "mistake": run.mistake,
        "ratio": run.ratio,
        "passed": list(run.passed),
        "failed": list(run.failed),
        "levels": list(run.levels),
        "source": run.source_hash,
    }


def _check(name: str, folders: Sequence[Path], known: set[str]) -> None:
    """Refuse a name that is neither a problem's nor in the history, whose problem may be gone."""
    if name not in known:
        find_problem(name, folders)


def _write_csv(runs: Sequence[Run]) -> None:
    from judge.report.sheet import csv_text  # only who asks for it waits for it

    rows: list[Sequence[object]] = [_COLUMNS]
    for run in runs:
        names = {"passed": run.passed, "failed": run.failed, "levels": run.levels}
        row = as_object(run) | {key: " ".join(found) for key, found in names.items()}
        rows.append(["" if row[key] is None else row[key] for key in _COLUMNS])
    sys.stdout.write(csv_text(rows, "\n"))
    sys.stdout.flush()

"""`judge history`: the runs so far."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click

from judge.cli.options import db_option, json_option, problems_option, write_json
from judge.errors import ExitCode, UsageError
from judge.kata.history import History, Run
from judge.problem.find import find_problem
from judge.report.history import history_lines
from judge.report.layout import line, printable
from judge.report.screen import out

SCHEMA = 1
_COLUMNS = (  # of the CSV: the keys of a run's object
    *("run", "time", "problem", "submission", "path", "verdict", "score"),
    *("mode", "mistake", "ratio", "passed", "failed", "levels", "source"),
)
_ON_SCREEN = 20  # runs, unless it is said how many


@click.command("history")
@click.argument("name", metavar="[PROBLEM]", required=False)
@click.option("--limit", type=click.IntRange(1), metavar="N", help="Only the last N runs.")
@json_option
@click.option("--csv", "as_csv", is_flag=True, help="Write CSV, a run a line below the columns' names.")
@db_option
@problems_option
def command(
    name: str | None,
    limit: int | None,
    as_json: bool,
    as_csv: bool,
    db: Path | None,
    folders: tuple[Path, ...],
) -> ExitCode:
    """Show the runs so far.

    The latest is last. With a PROBLEM, only its runs. The screen shows the last 20 unless --limit says
    otherwise; JSON and CSV hold all of them.
    """
    if as_json and as_csv:
        raise UsageError("--json and --csv exclude each other", remedy="give one of them")
    on_screen = not (as_json or as_csv)
    with History.open(db, reading=True) as history:
        most = _ON_SCREEN + 1 if on_screen and limit is None else limit
        runs = history.runs(name, most)
        if not runs and name is not None:
            _check(name, folders, {run.problem for run in history.runs()})
    if as_json:
        for run in runs:
            write_json(as_object(run) | {"result": run.result})
    elif as_csv:
        _write_csv(runs)
    elif runs:
        screen = out()
        shown = runs if limit is not None else runs[-_ON_SCREEN:]
        screen.show(history_lines(shown, screen.width, more=len(shown) < len(runs)))
    else:
        out().show([line(f"No runs yet; 'judge run {name or 'PROBLEM'} FILE' adds one.")])
    return ExitCode.ACCEPTED


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
    import csv  # only who asks for it waits for it

    writer = csv.DictWriter(sys.stdout, _COLUMNS, extrasaction="ignore", lineterminator="\n")
    writer.writeheader()
    for run in runs:
        names = {"passed": run.passed, "failed": run.failed, "levels": run.levels}
        row = as_object(run) | {key: " ".join(found) for key, found in names.items()}
        writer.writerow({key: printable(str(row[key])) for key in _COLUMNS if row[key] is not None})
    sys.stdout.flush()

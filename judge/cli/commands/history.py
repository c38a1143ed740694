"""`judge history`: the runs so far."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from judge.cli.kept import history_at
from judge.cli.options import db_option, json_option, problems_option, write_json
from judge.errors import ExitCode, UsageError
from judge.kata.history import Run
from judge.problem.find import find_problem
from judge.report.history import history_lines, restored_lines
from judge.report.layout import line
from judge.report.screen import out

if TYPE_CHECKING:
    from judge.cli.restoring import Restored

SCHEMA = 1
_COLUMNS = (  # of the CSV: the keys of a run's object
    *("run", "time", "problem", "submission", "path", "verdict", "score"),
    *("mode", "mistake", "ratio", "passed", "failed", "levels", "source"),
)
_ON_SCREEN = 20  # runs, unless it is said how many


@click.command("history")
@click.argument("name", metavar="[PROBLEM]", required=False)
@click.option("--limit", type=click.IntRange(1), metavar="N", help="Only the last N runs.")
@click.option(
    "--restore", "number", type=int, metavar="RUN", help="Write the source of that run to its file again."
)
@click.option(
    "--out",
    "target",
    metavar="FILE",
    type=click.Path(path_type=Path),
    help="Restore it to this file instead.",
)
@click.option("--force", is_flag=True, help="Restore it over another source.")
@json_option
@click.option("--csv", "as_csv", is_flag=True, help="Write CSV, one run a line.")
@db_option
@problems_option
def command(
    name: str | None,
    limit: int | None,
    number: int | None,
    target: Path | None,
    force: bool,
    as_json: bool,
    as_csv: bool,
    db: Path | None,
    folders: tuple[Path, ...],
) -> ExitCode:
    """Show the runs so far.

    The latest is last. With a PROBLEM, only its runs. The screen shows the last 20 unless --limit says
    otherwise; JSON and CSV have all of them.

    --restore writes the source of a run back to its file, and says where it is. If the file holds something
    else by now, it stays as it is unless you add --force; then you are told whether a run keeps the old text.

    A run that is damaged is left out, and a note says so. If the file cannot be read, it is renamed to
    FILE.damaged-1, a new one is begun, and a note says that.
    """
    if as_json and as_csv:
        raise UsageError("--json and --csv exclude each other", remedy="give one of them")
    if number is not None:
        if as_csv or limit is not None or name is not None:
            raise UsageError(
                "--restore takes a run's number and no other choice", remedy="leave the rest out"
            )
        return _restore(number, target, db, force=force, as_json=as_json)
    if target is not None or force:
        raise UsageError("--out and --force go with --restore RUN", remedy="say which run")
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
        shown = runs if limit is not None else runs[-_ON_SCREEN:]
        screen.show(history_lines(shown, screen.width, more=len(shown) < len(runs)))
    else:
        out().show([line(f"No runs yet; 'judge run {name or 'PROBLEM'} FILE' adds one.")])
    return ExitCode.ACCEPTED


def _restore(number: int, target: Path | None, db: Path | None, *, force: bool, as_json: bool) -> ExitCode:
    from judge.cli.restoring import restore  # only who asks for it waits for it

    with history_at(db, reading=True) as history:
        restored = restore(history, number, target, force=force)
    if as_json:
        write_json(
            {
                "schema": SCHEMA,
                "run": number,
                "problem": restored.run.problem,
                "source": restored.run.source_hash,
                "file": restored.file,
                "written": restored.written,
                "over": restored.over,
                "kept_in": restored.kept_in,
            }
        )
    else:
        screen = out()
        became = _became(restored)
        screen.show(restored_lines(restored.run, restored.file, became, screen.width))
    return ExitCode.ACCEPTED


def _became(restored: Restored) -> str:
    """What became of the file that was there."""
    if not restored.written:
        return "It was there already; nothing is written."
    if not restored.over:
        return "Nothing was there."
    which = "which no run keeps" if restored.kept_in is None else f"which run {restored.kept_in} keeps"
    return f"Written over another source, {which}."


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

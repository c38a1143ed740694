"""`judge history`: the runs so far, one of them in full, what changed between two, a source again."""

from __future__ import annotations

from difflib import unified_diff
from pathlib import Path

import click
from msgspec import Struct

from judge.cli.files import check_place
from judge.cli.options import Common, command, opt
from judge.cli.resolve import history_at, shown
from judge.errors import UsageError, unwritable
from judge.files import new_file
from judge.practice.events import Run
from judge.practice.history import History
from judge.practice.stub import write_over
from judge.problem.find import find_problem
from judge.report.published_practice import GroupChange, Restored, RunList, RunRow, RunsCompared
from judge.report.views import copied

_ON_SCREEN = 18  # runs, unless it is said how many


class HistoryAsk(Struct, frozen=True):
    """What to show of the runs."""

    limit: int | None = opt("--limit N", "Only the last N runs.", type=click.IntRange(1))
    csv: bool = opt("--csv", "Write CSV, one run a line.")
    restore: bool = opt("--restore", "Write the source of that RUN to its file again.")
    out: Path | None = opt("--out FILE", "Restore it to this file instead.")


@command("history", RunRow, RunsCompared, Restored, ask=HistoryAsk)
@click.argument("words", metavar="[KATA|RUN [RUN]]", nargs=-1)
def history(words: tuple[str, ...], ask: HistoryAsk, common: Common) -> Struct:
    """Show your runs, one run, or what changed between two.

    The latest run is last. The screen shows the last 18, JSON and CSV all of them. RUN is the number in the
    first column.

    With --restore, the source that a run judged is written to its file again. If that file has changed since,
    it is kept as FILE.bak. A damaged run is left out, and a note says so.
    """
    if ask.csv and common.json:
        raise UsageError("--json and --csv exclude each other", remedy="give one of them")
    numbers = [int(word) for word in words if word.isdecimal()]
    if len(words) > max(len(numbers), 1) or len(words) > 2:
        raise UsageError("Give one kata, one run or two runs", remedy="such as judge history 3 5")
    if ask.restore != (len(numbers) == 1 and ask.restore):
        raise UsageError("Which run? --restore takes one", remedy="such as judge history 3 --restore")
    if ask.out is not None and not ask.restore:
        raise UsageError("--out goes with --restore", remedy="such as judge history 3 --restore --out old.py")
    if numbers and (ask.csv or ask.limit is not None):
        raise UsageError("--csv and --limit are for the list of runs", remedy="leave them out")
    with history_at(common.db, reading=True) as found:
        if not numbers:
            return _listed(words[0] if words else "", ask, common, found)
        runs = [(found.run(number), found.source(number)) for number in numbers]
    if ask.restore:
        return _restored(*runs[0], ask.out)
    return _compared(*runs) if len(runs) == 2 else copied(RunRow, runs[0][0])


def _listed(name: str, ask: HistoryAsk, common: Common, history: History) -> RunList:
    """The last runs, of that kata if one is named, which may be gone since. Raises UsageError."""
    on_screen = not (common.json or ask.csv)
    short = on_screen and ask.limit is None
    runs = history.runs(name or None, _ON_SCREEN + 1 if short else ask.limit)
    if not on_screen:
        runs = history.with_results(runs)
    if not runs and name:
        find_problem(name, common.problems)
    kept = runs[-_ON_SCREEN:] if short else runs
    return RunList(tuple(kept), name, more=len(kept) < len(runs), csv=ask.csv)


def _compared(first: tuple[Run, bytes], second: tuple[Run, bytes]) -> RunsCompared:
    """What changed between two runs of one kata. Raises UsageError."""
    (before, old), (after, new) = first, second
    if before.problem != after.problem:
        what = f"run {before.id} is of {before.problem}, run {after.id} of {after.problem}"
        raise UsageError(what, remedy="name two runs of one kata")
    ended, now = (
        dict.fromkeys(run.passed, "passed") | dict.fromkeys(run.failed, "failed") for run in (before, after)
    )
    old_lines, new_lines = (text.decode("utf-8", "backslashreplace").splitlines() for text in (old, new))
    diff = unified_diff(old_lines, new_lines, f"run {before.id}", f"run {after.id}", lineterm="")
    return RunsCompared(
        problem=before.problem,
        before=before.id,
        after=after.id,
        verdicts=(before.verdict, after.verdict),
        scores=(before.score, after.score),
        groups=tuple(
            GroupChange(name, ended.get(name), now.get(name))
            for name in ended | now
            if ended.get(name) != now.get(name)
        ),
        diff=tuple(diff),
    )


def _restored(run: Run, source: bytes, target: Path | None) -> Restored:
    """Write the source of that run to `target`, or to where it was; what is there is kept beside it."""
    if target is None and not run.path:
        raise UsageError(f"run {run.id} judged no ordinary file", remedy="name one with --out FILE")
    target = target or Path(run.path)
    check_place(target, "--out")
    there, kept = target.exists(), None
    try:
        if there:
            kept = write_over(target, source)
        else:
            new_file(target, source)
    except OSError as fault:
        raise unwritable(target, fault, "name another file with --out") from fault
    return Restored(
        run=run.id,
        time=run.when,
        problem=run.problem,
        source=run.source_hash,
        file=shown(target),
        written=kept is not None or not there,
        kept_as=shown(kept) if kept else None,
    )

"""Two runs of the tests that together skip nothing: conftest.py takes this plugin where $SKIPPED is set.

$SKIPPED         the file that the skipped tests are written to, with their reasons
$AGAIN           such a file of an earlier run: only its tests are run
elsewhere.txt    tests of another system, each with the reason, which may be skipped in both runs
"""

from __future__ import annotations

import os
from pathlib import Path

import pytest

ELSEWHERE = Path(__file__).with_name("elsewhere.txt")
_skipped: dict[str, str] = {}


def _read(path: Path) -> dict[str, str]:
    """Tests with their reasons: a line each, a tab between."""
    rows = (line.split("\t") for line in path.read_text(encoding="utf-8").splitlines())
    return {row[0]: row[-1] for row in rows if not row[0].startswith("#")}


def _note(report: pytest.TestReport | pytest.CollectReport) -> None:
    if report.skipped and not hasattr(report, "wasxfail"):
        reason = report.longrepr[-1] if isinstance(report.longrepr, tuple) else str(report.longrepr)
        _skipped[report.nodeid] = " ".join(reason.removeprefix("Skipped: ").split())


pytest_runtest_logreport = _note
pytest_collectreport = _note


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Keep the tests that the earlier run skipped, alone or with their whole file."""
    if "AGAIN" in os.environ:
        again = _read(Path(os.environ["AGAIN"]))
        chosen = [item for item in items if item.nodeid in again or item.nodeid.partition("::")[0] in again]
        config.hook.pytest_deselected(items=[item for item in items if item not in set(chosen)])
        items[:] = chosen


@pytest.hookimpl(trylast=True)
def pytest_sessionfinish(session: pytest.Session) -> None:
    """Write what was skipped; fail where a test was skipped in both runs."""
    if hasattr(session.config, "workerinput"):
        return
    lines = [f"{name}\t{reason}\n" for name, reason in sorted(_skipped.items())]
    Path(os.environ["SKIPPED"]).write_text("".join(lines), encoding="utf-8")
    if "AGAIN" in os.environ:
        allowed = _read(ELSEWHERE)
        never = [
            line
            for line in lines
            if not {(name := line.partition("\t")[0]), name.partition("[")[0]} & {*allowed}
        ]
        if never:
            session.exitstatus = pytest.ExitCode.TESTS_FAILED
            print("\nno run executes these tests:", *never, sep="\n")

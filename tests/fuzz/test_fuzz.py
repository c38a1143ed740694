"""The fuzz: some cases every day, more by night, always the same; and that it would see a fault.

CONTRIBUTING says how to run thousands of others.
"""

from __future__ import annotations

import sys

import pytest
from command_lines import kinds, pool
from contract import faults
from fuzz import findings
from runs import Ended, Run, Worker
from sampling import nightly
from worker import CLOSED, FULL, KEPT, NULL, TERMINAL

from judge.cli.app import app
from judge.cli.table import COMMANDS

# by day, in all, and in one test: 126 cases of submissions hold 504 hostile ones
COUNTS = {"problems": (5, 80, 80), "submissions": (1, 126, 18), "commands": (5, 1000, 100)}
SEEDS = [(target, range(day)) for target, (day, _, _) in COUNTS.items()]
SEEDS += [
    nightly(target, range(max(day, start), min(start + each, night)))
    for target, (day, night, each) in COUNTS.items()
    for start in range(0, night, each)
]

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="the worker waits by Linux's descriptors")


@pytest.fixture(scope="module")
def worker():
    with Worker() as process:
        yield process


@pytest.mark.parametrize(("target", "seeds"), SEEDS)
def test_no_case_ends_as_none_may_end(target, seeds, worker, tmp_path):
    found = list(findings(target, seeds, tmp_path, worker))
    assert not found, "\n\n".join(map(str, found))
    assert list(tmp_path.iterdir()) == []


def test_every_value_that_a_command_takes_has_odd_ones():
    commands = [app.get_command(None, name) for name in COMMANDS]
    taken = {kind for command in commands for each in command.params for kind in kinds(each)}
    assert taken == {*pool("words")} - {"LOOSE"}


SHOW, JSON = Run(("show", "middle")), Run(("start", "--json"), checked=True)
UNHEARD = Run((), streams=(NULL, FULL, KEPT))
SOUND = (
    '{"schema": 1, "problem": "middle", "title": "T", "entry": "middle", "file": "middle.py",'
    ' "created": true, "kept": ""}\n'
)


@pytest.mark.parametrize(
    ("run", "status", "out", "err", "fault"),
    [
        (SHOW, 5, "", "judge: x\n", "its status 5 is not in the contract"),
        (SHOW, -14, "", "", "it does not end"),
        (SHOW, 0, "", "", "it leaves a process behind: sleep 9"),
        (SHOW, 1, "Traceback (most recent call last)\n", "", "out says 'Traceback"),
        (SHOW, 3, "", "judge: internal fault: x\n", "err says 'internal fault'"),
        (SHOW, 0, "a\x1b[31m\n", "", r"standard output holds '\x1b'"),
        (SHOW, 0, "", "warning: x\n", "a line of standard error is not the judge's: 'warning"),
        (SHOW, 2, "", "judge: x\n" * 4, "it says 4 lines on standard error with status 2"),
        (SHOW, 2, "", f"judge: {'x' * 2000}\n", "a line of standard error has 2007 characters"),
        (SHOW, 3, "", "", "it ends with status 3 and does not say why"),
        (UNHEARD, 0, "fine\n", "", "it ends with status 0 though nobody got its output"),
        (JSON, 0, "fine\n", "", "this is no JSON (Expecting value: line 1 column 1 (char 0)): 'fine'"),
        (JSON, 0, '{"a": NaN}\n', "", "this is no JSON (NaN is no number of JSON)"),
        (JSON, 0, SOUND.replace("true", "7"), "", "breaks the schema at created"),
        (JSON, 0, SOUND, "", None),
        (SHOW, 2, "", "judge: a\njudge: b\n", None),
        (UNHEARD, 3, "", "judge: cannot write\n", None),
    ],
)
def test_the_contract_sees_what_breaks_it(run, status, out, err, fault):
    found = faults(
        run, Ended(status, out, err, "", (), left=("sleep 9",) if "behind" in (fault or "") else ())
    )
    assert any(fault in each for each in found) if fault else not found, found


def test_a_command_line_writes_only_where_it_may_and_has_the_streams_that_are_asked_for(worker, tmp_path):
    case, elsewhere = tmp_path / "own" / "case", tmp_path / "elsewhere"
    for folder in (case / "work", case / "tmp", elsewhere):
        folder.mkdir(parents=True)
    ended = worker.run(Run(("start", "count", str(elsewhere / "x.py"), "--no-watch")), case)
    assert (ended.status, len(ended.outside), list(elsewhere.iterdir())) == (2, 1, [])
    shown = worker.run(Run(("show", "count"), streams=(TERMINAL,) * 3), case)
    assert (shown.status, shown.out, "line_count" in shown.shown) == (0, "", True)
    assert worker.run(Run(("show", "count"), streams=(NULL, FULL, KEPT)), case).status == 3
    assert worker.run(Run(("show", "count"), streams=(CLOSED, KEPT, CLOSED)), case).status == 0

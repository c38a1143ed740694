"""The fuzz: some cases every day, a few hundred by night, always the same; and that it would see a fault.

CONTRIBUTING says how to run thousands of others.
"""

from __future__ import annotations

import random
import sys
from pathlib import Path

import pytest
from contract import faults
from fuzz import TARGETS, findings
from runs import Ended, Run, Worker
from sampling import nightly
from worker import CLOSED, FULL, KEPT, NULL, TERMINAL

COUNTS = {  # by day and in all; the submissions come in batches of a dozen
    "problems": (16, 100),
    "submissions": (1, 3),
    "commands": (8, 70),
}
SEEDS = [(target, range(day)) for target, (day, _) in COUNTS.items()]
SEEDS += [nightly(target, range(day, night)) for target, (day, night) in COUNTS.items()]

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="the worker waits by Linux's descriptors")


@pytest.fixture(scope="module")
def worker():
    with Worker() as process:
        yield process


@pytest.mark.parametrize(("target", "seeds"), SEEDS)
def test_no_case_ends_as_none_may_end(target, seeds, worker, tmp_path):
    assert set(COUNTS) == set(TARGETS)
    found = list(findings(target, seeds, tmp_path, worker))
    assert not found, "\n\n".join(map(str, found))
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("target", TARGETS)
def test_a_seed_makes_the_same_case_again(target, tmp_path):
    made = []
    for name in ("one", "other"):
        (tmp_path / name / "work").mkdir(parents=True)
        story, runs = TARGETS[target].prepare(random.Random("a seed"), tmp_path / name)
        files = {path.relative_to(tmp_path / name): kind(path) for path in (tmp_path / name).rglob("*")}
        made.append((story, runs, files))
    assert made[0] == made[1]
    assert made[0][1]


def kind(path: Path) -> bytes:
    """What is at a path."""
    if path.is_symlink():
        return f"-> {path.readlink()}".encode()
    return path.read_bytes() if path.is_file() else b"a folder" if path.is_dir() else b"a pipe"


SHOW = Run(("show", "middle"))
JSON = Run(("schema", "--json"), checked=True)
FINE = Ended(0, "fine\n", "", "", ())
SOUND = '{"schema": 1, "problem": "middle", "file": "middle.py"}\n'


@pytest.mark.parametrize(
    ("run", "ended", "fault"),
    [
        (SHOW, Ended(5, "", "judge: x\n", "", ()), "its status 5 is not in the contract"),
        (SHOW, Ended(-11, "", "", "", ()), "its status -11 is not in the contract"),
        (SHOW, Ended(-14, "", "", "", ()), "it does not end"),
        (SHOW, Ended(1, "Traceback (most recent call last)\n", "", "", ()), "out says 'Traceback"),
        (SHOW, Ended(3, "", "judge: internal fault: x\n", "", ()), "err says 'internal fault'"),
        (SHOW, Ended(0, "", "", "internal fault", ()), "shown says 'internal fault'"),
        (SHOW, Ended(0, "", "", "\x1b[31mred.py", ()), r"shown says '\x1b[31mred'"),
        (SHOW, Ended(0, "", "", "", ("open '/x'",)), "it changes a file that is not its own: open '/x'"),
        (SHOW, Ended(0, "a\x1b[31m\n", "", "", ()), r"standard output holds '\x1b'"),
        (SHOW, Ended(0, "", "judge: a\rb\n", "", ()), r"standard error holds '\r'"),
        (SHOW, Ended(0, "", "warning: x\n", "", ()), "a line of standard error is not the judge's: 'warning"),
        (SHOW, Ended(2, "", "judge: x\n" * 4, "", ()), "it says 4 lines on standard error with status 2"),
        (SHOW, Ended(3, "", "judge: x\n" * 101, "", ()), "it says 101 lines on standard error with status 3"),
        (
            SHOW,
            Ended(2, "", f"judge: {'x' * 2000}\n", "", ()),
            "a line of standard error has 2007 characters",
        ),
        (SHOW, Ended(2, "", "", "", ()), "it ends with status 2 and does not say why"),
        (SHOW, Ended(3, "", "", "", ()), "it ends with status 3 and does not say why"),
        (Run((), streams=(NULL, FULL, KEPT)), FINE, "it ends with status 0 though nobody got its output"),
        (Run((), streams=(NULL, CLOSED, KEPT)), FINE, "it ends with status 0 though nobody got its output"),
        (JSON, FINE, "this is no JSON (Expecting value: line 1 column 1 (char 0)): 'fine'"),
        (JSON, Ended(0, "", "", "", ()), "it ends with status 0 and writes no JSON"),
        (JSON, Ended(0, "{}", "", "", ()), "the last line of its JSON has no end"),
        (JSON, Ended(0, '{"a": NaN}\n', "", "", ()), "this is no JSON (NaN is no number of JSON)"),
        (
            Run(("init",), checked=True),
            Ended(0, SOUND.replace("1", "7"), "", "", ()),
            "breaks the schema at sc",
        ),
    ],
)
def test_the_contract_sees_what_breaks_it(run, ended, fault):
    assert any(fault in found for found in faults(run, ended)), faults(run, ended)


@pytest.mark.parametrize(
    ("run", "ended"),
    [
        (SHOW, FINE),
        (SHOW, Ended(2, "", "judge: a\njudge: b\n", "", ())),
        (Run(("init",), checked=True), Ended(0, SOUND, "", "", ())),
        (Run(("list",), checked=True), Ended(0, "", "", "", ())),
        (Run((), streams=(NULL, FULL, KEPT)), Ended(3, "", "judge: cannot write\n", "", ())),
        (Run((), streams=(TERMINAL,) * 3), Ended(130, "", "", "\x1b[31mbad\x1b[0m", ())),
    ],
)
def test_the_contract_lets_pass_what_keeps_it(run, ended):
    assert faults(run, ended) == []


def test_what_a_command_line_writes_elsewhere_is_refused_and_reported(worker, tmp_path):
    case, elsewhere = tmp_path / "case", tmp_path / "elsewhere"
    for folder in (case / "work", case / "tmp", elsewhere):
        folder.mkdir(parents=True)
    for fresh in (False, True):
        ended = worker.run(Run(("init", "count", str(elsewhere / "x.py")), fresh=fresh), case)
        assert (ended.status, len(ended.outside)) == (2, 1)
        assert ended.err.endswith("name another file\n")
    assert list(elsewhere.iterdir()) == []
    assert worker.run(Run(("init", "count", "x.py")), case).status == 0
    assert (case / "work" / "x.py").exists()


def test_a_command_line_has_the_streams_that_are_asked_for(worker, tmp_path):
    (tmp_path / "work").mkdir()
    shown = worker.run(Run(("show", "count"), streams=(TERMINAL,) * 3), tmp_path)
    assert (shown.status, shown.out, shown.err) == (0, "", "")
    assert "line_count" in shown.shown
    assert worker.run(Run(("show", "count"), streams=(NULL, FULL, KEPT)), tmp_path).status == 3
    assert worker.run(Run(("show", "count"), streams=(CLOSED, KEPT, CLOSED)), tmp_path).status == 0

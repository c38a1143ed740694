"""Measuring alone among all processes of a user: who is kept out, for how long, and where the locks lie."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest
from msgspec.structs import replace
from sandboxed import call, require

from judge.data.load import load_data
from judge.judging.session import Session
from judge.problem import TimeRule, Verdict
from judge.problem.find import find_problem
from judge.problem.solutions import accepted_source
from judge.run.alone import VARIABLE, MeasureLock
from judge.run.execute import judge_submission
from judge.run.settings import Settings

OTHER = """
import sys
from judge.run.alone import MeasureLock
with getattr(MeasureLock(), sys.argv[1])():
    print("in", flush=True)
    sys.stdin.read()
"""
PACK = Path(__file__).parents[1] / "fixtures" / "pack" / "problems"
LONG = 20.0  # seconds, for what ends at once where nothing is wrong


@contextlib.contextmanager
def another(how):
    """A process that judges or measures until the block ends."""
    command = [sys.executable, "-c", OTHER, how]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout.readline() == "in\n"
            yield process
        finally:
            process.kill()
            process.wait()


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    """The locks of this test alone."""
    monkeypatch.setenv(VARIABLE, str(tmp_path / "locks"))
    return tmp_path / "locks"


def tried(how):
    """What a machine without patience gives."""
    with getattr(MeasureLock(patience=0.02), how)() as place:
        return place


def waits(how):
    """Whether who asks so has to wait for another."""
    waited = []

    @contextlib.contextmanager
    def waiting():
        waited.append(True)
        yield None

    with getattr(MeasureLock(waiting=waiting, patience=0.02), how)():
        return bool(waited)


@pytest.mark.parametrize("how", ["judging", "measuring"])
def test_another_process_keeps_a_measurer_out_and_judges_only_where_it_measures(how):
    with another(how):
        assert not tried("measuring").alone
        assert waits("judging") is (how == "measuring")
    assert tried("measuring").alone


def test_what_is_run_for_its_answers_waits_for_nobody():
    told = []
    problem = find_problem("middle", [PACK])
    bars = lambda label: told.append(label) or contextlib.nullcontext()  # noqa: E731
    with Session(problem, bars=bars) as session, another("measuring"), session.untimed.lock.judging():
        assert told == []


@pytest.mark.parametrize(("allowed", "alone"), [(1_000.0, False), (0.05, True)])
def test_only_what_comes_near_the_limit_is_measured_alone(allowed, alone):
    problem = find_problem("middle", [PACK])
    problem = replace(problem, time=TimeRule(allowed, "mean.py"))
    asked = []

    @contextlib.contextmanager
    def waiting():
        asked.append(True)
        yield None

    settings = Settings(lock=MeasureLock(waiting=waiting, patience=0.02))
    source = accepted_source(problem, problem.time.function)
    with another("judging"):
        result = judge_submission(load_data(problem, store=None), source, "right.py", settings).result
    assert bool(asked) is alone
    assert result.time.ratio.busy.startswith("beside another judge") is alone
    assert result.verdict is (Verdict.TLE if alone else Verdict.AC)


def test_a_killed_process_gives_its_locks_back_at_once():
    with another("measuring") as process, contextlib.ExitStack() as stack:
        killer = threading.Timer(0.2, process.send_signal, [signal.SIGKILL])
        killer.start()
        assert stack.enter_context(MeasureLock(patience=LONG).measuring()).alone
        killer.join()
        assert process.wait(LONG) == -signal.SIGKILL


def test_a_stopped_process_keeps_nobody_for_ever_and_only_the_first_for_long():
    with another("measuring") as process:
        process.send_signal(signal.SIGSTOP)
        ticks = iter(range(10**6))
        machine = MeasureLock(patience=100.0, clock=lambda: 8.0 * next(ticks))  # for each look at it
        with machine.measuring() as place:
            assert not place.alone
            assert place.waited >= 100
        with machine.measuring() as place:
            assert not place.alone
            assert place.waited < 50
    with machine.measuring() as place:
        assert place.alone


def test_who_comes_later_does_not_pass_a_waiting_measurer():
    let_in = []

    def measure():
        with MeasureLock(patience=LONG).measuring() as place:
            let_in.append(place.alone)

    measurer = threading.Thread(target=measure)
    with another("judging"):
        measurer.start()
        until = time.monotonic() + LONG
        while not waits("judging"):  # until the measurer is at the door
            assert time.monotonic() < until
        assert not let_in
    measurer.join(LONG)
    assert let_in == [True]


def plant(what: str, folder: Path) -> None:
    """What somebody might have put in the folder's place before it is first asked for."""
    elsewhere = folder.with_name("elsewhere")
    if what == "a link":
        elsewhere.mkdir(mode=0o700)
        folder.symlink_to(elsewhere)
    else:
        folder.mkdir(mode=0o700)
    if what == "another user's folder":
        os.chown(folder, 65534, 65534) if os.geteuid() == 0 else folder.chmod(0o500)
    elif what == "an open folder":
        folder.chmod(0o777)
    for name in ("door", "room"):
        if what == "pipes":
            os.mkfifo(folder / name)
        elif what == "links in it":
            (folder / name).symlink_to(elsewhere)


@pytest.mark.parametrize(
    "what", ["a link", "an open folder", "pipes", "links in it", "another user's folder"]
)
def test_a_folder_that_somebody_planted_is_not_used(folder, what):
    plant(what, folder)
    before = sorted(path.name for path in folder.parent.rglob("*"))
    with MeasureLock().judging(), MeasureLock(patience=LONG).measuring() as place:  # nobody is kept out
        assert place.alone
    assert sorted(path.name for path in folder.parent.rglob("*")) == before


LOOK = """
import os
def f():
    files = []
    for number in range(256):
        try:
            found = os.fstat(number)
        except OSError:
            continue
        files.append([found.st_dev, found.st_ino])
    return files
"""


@pytest.mark.parametrize("level", ["full", "limits"])
def test_a_box_that_is_opened_meanwhile_has_no_lock_in_it(folder, level):
    require(level)
    with MeasureLock().measuring():
        files = call(LOOK, [()], level=level).replies[0].answer
        locks = [path.stat() for path in folder.iterdir()]
        assert (len(locks), len(files) > 2) == (2, True)
        assert not [lock for lock in locks if [lock.st_dev, lock.st_ino] in files]

"""Nothing of a submission outlives it, nor anything of the judge's tree a judge killed by SIGKILL."""

from __future__ import annotations

import os
import signal
import time
from pathlib import Path

import pytest
from attackers import Attacker

LEVELS = ["full", "strong", "limits"]
GONE_SECONDS = 1.0


@pytest.mark.parametrize("level", LEVELS)
def test_a_daemon_dies_with_its_run(attacker: Attacker, level: str) -> None:
    attacker.require(level)
    (found,) = attacker.run("outlive.py", "daemon", level)
    assert found["later"] == found["at_end"], "something went on writing after the run was over"
    if level == "limits":
        assert found["output"] == "started\n", "at this level it can fork, and must still be ended"
    else:
        assert found["output"].startswith("held")


@pytest.mark.parametrize("what", ["sleeper", "deaf", "close_everything_and_sleep"])
@pytest.mark.parametrize("level", LEVELS)
def test_the_tree_dies_with_a_killed_judge(attacker: Attacker, level: str, what: str) -> None:
    attacker.require(level)
    process = attacker.popen("outlive.py", what, level)
    try:
        assert process.stdout is not None
        assert process.stdout.readline() == "started\n"
        family = _settled_family(process.pid)
        assert len(family) >= 2, "a fork server and a child at least"
        os.kill(process.pid, signal.SIGKILL)
        process.wait(10)
        assert not _alive_after_a_moment(family)
    finally:
        process.kill()
        process.communicate(timeout=10)


@pytest.mark.parametrize("level", LEVELS)
def test_ctrl_c_ends_everything_at_once(attacker: Attacker, level: str) -> None:
    attacker.require(level)
    process = attacker.popen("outlive.py", "deaf", level)
    try:
        assert process.stdout is not None
        assert process.stdout.readline() == "started\n"
        family = _settled_family(process.pid)
        os.kill(process.pid, signal.SIGINT)
        assert process.wait(5) != 0
        assert not _alive(family)
    finally:
        process.kill()
        process.communicate(timeout=10)


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGKILL])
@pytest.mark.parametrize("level", LEVELS)
def test_four_boxes_in_four_threads_end_with_the_judge(
    attacker: Attacker, level: str, number: signal.Signals
) -> None:
    attacker.require(level)
    process = attacker.popen("outlive.py", "sleeper", level, "4")
    try:
        assert process.stdout is not None
        assert process.stdout.readline() == "started\n"
        family = _settled_family(process.pid, 8)
        assert len(family) >= 8, "four fork servers with a child each at least"
        os.kill(process.pid, number)
        assert process.wait(5) != 0
        assert not _alive_after_a_moment(family)
    finally:
        process.kill()
        process.communicate(timeout=10)


def _alive(family: dict[int, int]) -> list[int]:
    return [pid for pid, birth in family.items() if _birth(pid) == birth]


def _alive_after_a_moment(family: dict[int, int]) -> list[int]:
    until = time.monotonic() + GONE_SECONDS
    while (left := _alive(family)) and time.monotonic() < until:
        time.sleep(0.02)
    return left


def _settled_family(pid: int, least: int = 2) -> dict[int, int]:
    """The living descendants of a process with their times of birth, once no more of them appear."""
    known: dict[int, int] = {}
    until = time.monotonic() + 10
    calm = time.monotonic() + 0.2
    while time.monotonic() < calm or (len(_alive(known)) < least and time.monotonic() < until):
        found = _family(pid)
        if not found.keys() <= known.keys():
            calm = time.monotonic() + 0.2
        known.update(found)
        time.sleep(0.05)
    return {child: known[child] for child in _alive(known)}


def _family(pid: int) -> dict[int, int]:
    stats = {
        int(entry.name): _stat(int(entry.name)) for entry in Path("/proc").iterdir() if entry.name.isdecimal()
    }
    members, grown = {pid}, True
    while grown:
        more = {child for child, stat in stats.items() if stat and int(stat[1]) in members} - members
        members |= more
        grown = bool(more)
    return {child: int((stats[child] or ["0"] * 20)[19]) for child in members - {pid}}


def _birth(pid: int) -> int:
    """A process's start time in ticks, 0 once it is gone or only waits to be reaped."""
    stat = _stat(pid)
    return int(stat[19]) if stat and stat[0] not in "ZX" else 0


def _stat(pid: int) -> list[str] | None:
    """The fields of /proc/PID/stat from the state on."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    except OSError:
        return None

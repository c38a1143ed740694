"""Nothing of a submission outlives it, nor anything of the judge's tree a judge that is ended."""

from __future__ import annotations

import contextlib
import json
import os
import signal
import subprocess
import time
from collections.abc import Iterator
from itertools import product

import pytest
from attackers import LEVELS, USERS, Attacker, by_turns
from processes import Process, below, left
from residents import CROWD, RIGHT, WRONG, Resident
from sampling import nightly

GONE_SECONDS = 1.0
KILLS = int(os.environ.get("JUDGE_KILLS", "20"))  # in all, for both users and levels together
SEED = int(os.environ.get("JUDGE_KILLS_SEED", "1"))
SECONDS_EACH = 40


@pytest.mark.parametrize(
    ("level", "user"),  # by day where it can fork
    [each if each == ("limits", "plain") else nightly(*each) for each in product(LEVELS, USERS)],
)
def test_a_daemon_dies_with_its_run(attacker: Attacker, level: str) -> None:
    attacker.require(level)
    (found,) = attacker.run("outlive.py", "daemon", level)
    assert found["later"] == found["at_end"], "something went on writing after the run was over"
    if level == "limits":
        assert found["output"] == "started\n", "at this level it can fork, and must still be ended"
    else:
        assert found["output"].startswith("held")


@contextlib.contextmanager
def _started(attacker: Attacker, *words: str) -> Iterator[subprocess.Popen[str]]:
    """A judge whose boxes are under way, and which is gone afterwards."""
    process = attacker.popen("outlive.py", *words)
    try:
        assert process.stdout is not None
        assert process.stdout.readline() == "started\n"
        yield process
    finally:
        process.kill()
        process.communicate(timeout=10)


@pytest.mark.parametrize(
    ("what", "user", "level"),
    by_turns(["sleeper", "deaf", "close_everything_and_sleep"], USERS[::-1], LEVELS),
)
def test_the_tree_dies_with_a_killed_judge(attacker: Attacker, level: str, what: str) -> None:
    attacker.require(level)
    with _started(attacker, what, level) as process:
        family = _settled_family(process.pid)
        assert len(family) >= 2, "a fork server and a child at least"
        os.kill(process.pid, signal.SIGKILL)
        process.wait(10)
        assert not _alive_after_a_moment(family)


@pytest.mark.parametrize(("what", "user", "level"), by_turns(["sleeper", "deaf"], USERS, LEVELS[1:]))
def test_a_child_dies_with_a_killed_server(attacker: Attacker, level: str, what: str) -> None:
    """The kernel may choose it where memory is short; at the highest level it takes its namespace along."""
    attacker.require(level)
    with _started(attacker, what, level) as process:
        family = _settled_family(process.pid)
        server = next(pid for pid, each in family.items() if each.parent == process.pid)
        assert server in {each.parent for each in family.values()}
        os.kill(server, signal.SIGKILL)
        assert not _alive_after_a_moment(family)


@pytest.mark.parametrize(("what", "user", "level"), by_turns(["sleeper"], USERS[::-1], LEVELS[1:]))
def test_a_stopped_server_dies_with_what_has_forked_it(attacker: Attacker, level: str, what: str) -> None:
    """It does not see who hangs up; a change of user would have cost it the signal that ends it."""
    attacker.require(level)
    with _started(attacker, what, level) as process:
        family = _settled_family(process.pid)
        seed = next(pid for pid, each in family.items() if each.parent == process.pid)
        server = next(pid for pid, each in family.items() if each.parent == seed)
        os.kill(server, signal.SIGSTOP)
        os.kill(seed, signal.SIGKILL)
        assert not _alive_after_a_moment(family)


@pytest.mark.parametrize(
    ("number", "user", "level"), by_turns([signal.SIGINT, signal.SIGKILL], USERS, LEVELS)
)
def test_four_boxes_in_four_threads_end_with_the_judge(
    attacker: Attacker, level: str, number: signal.Signals
) -> None:
    attacker.require(level)
    with _started(attacker, "sleeper", level, "4") as process:
        family = _settled_family(process.pid, 8)
        assert len(family) >= 8, "four fork servers with a child each at least"
        os.kill(process.pid, number)
        assert process.wait(5) != 0
        assert not _alive_after_a_moment(family)


@pytest.mark.parametrize(
    ("user", "level", "count", "seed"),
    [
        ("plain", "full", 2, 4),  # of each kind one
        *(nightly(user, level, max(1, KILLS // 4), SEED) for user in USERS for level in LEVELS[:2]),
    ],
)
def test_nothing_is_alive_a_second_after_a_kill_at_a_random_moment(
    resident: Resident, level: str, count: int, seed: int
) -> None:
    resident.attacker.require(level)
    files = resident.submissions(
        resident.home / "killed",
        right=RIGHT,
        wrong=WRONG,
        works=f"{RIGHT}while True: pass\n",
        sleeps=f"import time\n{RIGHT}time.sleep(60)\n",
        crowd=CROWD,
        deaf=f"import signal\nfor n in 2, 15: signal.signal(n, signal.SIG_IGN)\n{RIGHT}while True: pass\n",
    )
    script = str(resident.attacker.home / "security" / "kills.py")
    ended = resident.run([script, str(count), str(seed), level, *files], seconds=count * SECONDS_EACH)
    assert ended.returncode == 0, ended.stderr[-2000:]
    found = json.loads(ended.stdout)
    assert found["survivors"] == []
    assert sum(found["ends"].values()) == count
    assert found["ends"].keys() & {"SIGKILL", "SIGINT"}, "none was under way when its end came"


def _alive_after_a_moment(family: dict[int, Process]) -> list[int]:
    until = time.monotonic() + GONE_SECONDS
    while (found := left(family)) and time.monotonic() < until:
        time.sleep(0.02)
    return found


def _settled_family(pid: int, least: int = 2) -> dict[int, Process]:
    """The living descendants of a process, once no more of them appear."""
    known: dict[int, Process] = {}
    until = time.monotonic() + 10
    calm = time.monotonic() + 0.2
    while time.monotonic() < calm or (len(left(known)) < least and time.monotonic() < until):
        found = below(pid)
        if not found.keys() <= known.keys():
            calm = time.monotonic() + 0.2
        known.update(found)
        time.sleep(0.05)
    return {child: known[child] for child in left(known)}

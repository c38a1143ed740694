"""A machine that is short of something: told as that, at the cost of one submission, never as its fault."""

from __future__ import annotations

import contextlib
import os
import shutil
import time
import uuid
from collections.abc import Iterator
from itertools import product
from pathlib import Path

import pytest
from attackers import LEVELS, USERS, Attacker, by_turns
from residents import CROWD, RIGHT, Resident, command, judged, limited
from sampling import nightly

GROUPS = Path("/sys/fs/cgroup")
MANY = 5  # right programs


@pytest.fixture
def crowded(resident: Resident) -> list[str]:
    """Right programs, and between them some that are right too, with 120 threads each."""
    sources = {f"right{place}": RIGHT for place in range(MANY)}
    for place in range(3):
        sources[f"crowd{place}"] = CROWD
    mixed = sorted(sources, key=lambda name: (name[-1], name))
    return resident.submissions(resident.home / "crowded", **{name: sources[name] for name in mixed})


@pytest.fixture
def rights(resident: Resident) -> list[str]:
    return resident.submissions(resident.home / "rights", **{f"right{place}": RIGHT for place in range(9)})


def _tasks_now(uid: int) -> int:
    """Processes and threads of a user, hidden ones too."""
    count = 0
    for entry in Path("/proc").iterdir():
        if entry.name.isdecimal():
            with contextlib.suppress(OSError, StopIteration):
                lines = (entry / "status").read_text().splitlines()
                owner = next(line.split()[1] for line in lines if line.startswith("Uid:"))
                count += len(list((entry / "task").iterdir())) if owner == str(uid) else 0
    return count


def _limited_processes(resident: Resident, most: int) -> tuple[str, ...]:
    """What leaves a plain user so many more processes; the kernel does not bound root's by ulimit -u."""
    uid = os.geteuid() if resident.attacker.uid is None else resident.attacker.uid
    count = _tasks_now(uid) + most
    return limited(resident.attacker, RLIMIT_NPROC=(count, count))


@contextlib.contextmanager
def _group(resident: Resident, controller: str, limits: dict[str, int]) -> Iterator[tuple[str, ...]]:
    """What starts a command of this user in a control group of its own with a limit, of either version."""
    old = GROUPS / controller
    folder = (old if old.is_dir() else GROUPS) / f"judge-suite-{uuid.uuid4().hex[:8]}"
    try:
        folder.mkdir()
    except OSError as fault:
        pytest.skip(f"no control group can be made here: {fault.strerror}")
    try:
        limit = next((name for name in limits if (folder / name).exists()), None)
        if limit is None:
            pytest.skip(f"control groups do not bound {controller} here")
        (folder / limit).write_text(str(limits[limit]))
        yield limited(resident.attacker, str(folder))
    finally:
        _remove(folder)


def _remove(folder: Path) -> None:
    for _ in range(100):  # until all that ran in it has been reaped
        with contextlib.suppress(OSError):
            folder.rmdir()
            return
        time.sleep(0.05)


CROWDS = [
    *[("ulimit", "plain", "full", 90), ("container", USERS[-1], "strong", 260)],
    *[nightly("ulimit", "plain", "strong", 260), nightly("container", "plain", "full", 90)],
]


@pytest.mark.parametrize(
    ("bound", "user", "level", "most"),
    CROWDS,
)
def test_a_right_program_is_accepted_whatever_threads_its_neighbours_hold(
    resident: Resident, crowded: list[str], bound: str, level: str, most: int
) -> None:
    """120 threads need a machine that has them; elsewhere the message says how many there are."""
    resident.attacker.require(level)
    words = command(*crowded, "-j", "8", "--isolation", level)
    if bound == "ulimit":
        found = judged(resident.run(words, before=_limited_processes(resident, most)))
    else:
        with _group(resident, "pids", {"pids.max": most}) as joined:
            found = judged(resident.run(words, before=joined, as_root=True))
    assert found.verdicts("right") == ["AC"] * MANY, found.messages()
    assert set(found.verdicts("crowd")) == {"AC" if most > 200 else "RTE"}, found.messages()
    assert found.status == (0 if most > 200 else 1)
    assert all("threads at once here, and not 128 as elsewhere: raise" in text for text in found.messages())
    limit = "ulimit -u is " if bound == "ulimit" else "/sys/fs/cgroup/"
    assert f"judge: 1 at once, not 8: there is no room for more ({limit}" in found.err
    assert bound == "ulimit" or f"pids.max is {most})" in found.err
    assert found.err.count("\n") == 1


@pytest.mark.parametrize(
    ("jobs", "user"),
    [("20", USERS[-1]), *(nightly(jobs, user) for jobs in ("200", "20") for user in USERS[:1])],
)
def test_the_descriptors_that_there_are_bound_what_is_done_at_once(
    resident: Resident, rights: list[str], jobs: str
) -> None:
    limit = limited(resident.attacker, RLIMIT_NOFILE=(200 if jobs == "200" else 64, 200))
    found = resident.judge(*rights, "-j", jobs, before=limit)
    assert (found.status, set(found.verdicts())) == (0, {"AC"}), found.messages()
    assert "there is no room for more (ulimit -n is 200)" in found.err
    assert found.err.count("\n") == 1


@pytest.mark.nightly
def test_a_soft_limit_on_descriptors_is_raised_without_a_word(resident: Resident, rights: list[str]) -> None:
    found = resident.judge(*rights, "-j", "20", before=limited(resident.attacker, RLIMIT_NOFILE=(40, 4096)))
    assert (found.status, set(found.verdicts()), found.err) == (0, {"AC"}, "")


REMEDIES = {
    "RLIMIT_FSIZE": (1_000_000, "raise the limit (ulimit -f unlimited)"),
    "RLIMIT_AS": (600_000_000, "raise the limit (ulimit -v"),
    "RLIMIT_DATA": (600_000_000, "raise the limit (ulimit -d"),
}


@pytest.mark.parametrize(
    ("option", "user"), [("RLIMIT_AS", "plain"), *(nightly(each, USERS[-1]) for each in REMEDIES)]
)
def test_a_limit_on_the_judge_is_named_with_its_remedy_and_blames_no_submission(
    resident: Resident, rights: list[str], option: str
) -> None:
    most, remedy = REMEDIES[option]
    limit = limited(resident.attacker, **{option: (most, most)})
    found = resident.judge(*rights[:6], "-j", "3", before=limit)
    assert (found.status, found.verdicts()) == (3, ["JE"] * 6), found.messages()
    assert all(remedy in text and "\n" not in text for text in found.messages()), found.messages()
    assert all("internal fault" not in text for text in found.messages())


@pytest.mark.nightly
@pytest.mark.parametrize("user", USERS)
def test_too_few_descriptors_for_a_single_container_are_named(resident: Resident, rights: list[str]) -> None:
    said: set[str] = set()
    for most in (12, 14, 17):
        found = resident.judge(*rights[:3], before=limited(resident.attacker, RLIMIT_NOFILE=(most, most)))
        assert set(found.verdicts()) <= {"AC", "JE"}, found.messages()
        assert (found.status == 0) is (found.verdicts() == ["AC"] * 3)
        said |= found.messages()
    assert said
    assert all(text.endswith("or raise the limit (ulimit -n)") for text in said), said


def test_what_the_kernel_kills_for_want_of_memory_is_no_fault_of_the_submission(
    resident: Resident, rights: list[str]
) -> None:
    """It keeps to the problem's 256 MB, and the machine has 120."""
    hungry = RIGHT.replace("    return", "    kept.append(bytearray(b'x') * (6 << 20))\n    return")
    (file,) = resident.submissions(resident.home / "hungry", hungry=f"kept = []\n{hungry}")
    limits = {"memory.limit_in_bytes": 120 << 20, "memory.max": 120 << 20}
    with _group(resident, "memory", limits) as joined:
        ended = resident.run(command(file, *rights[:3]), before=joined, as_root=True)
    found = judged(ended)
    assert (found.status, found.verdicts("right")) == (3, ["AC"] * 3), found.messages()
    assert found.verdicts("hungry") == ["JE"]
    (message,) = found.messages()
    assert message.startswith("the kernel has killed the submission's process: there is no memory left; use")


NO_ROOM = "Creating new namespace failed: Resource temporarily unavailable"
FAILURES = [  # what bubblewrap says, how often, and where its submissions are held then, if anywhere
    (NO_ROOM, 3, "full"),
    ("Out of memory", 3, "full"),
    (NO_ROOM, 10_000, ""),
    ("No permissions to create new namespace", 10_000, "strong"),
]


@pytest.mark.parametrize(("failure", "user"), by_turns(FAILURES, USERS))
def test_bubblewrap_fails_and_nothing_drops_in_silence(
    resident: Resident, rights: list[str], failure: tuple[str, int, str]
) -> None:
    """As on a machine where `judge doctor` was never run."""
    resident.attacker.require("full")
    said, times, isolation = failure
    folder = resident.cache / f"bin-{uuid.uuid4().hex[:8]}"
    folder.mkdir()
    folder.chmod(0o777)
    starts, fake = folder / "starts", folder / "bwrap"
    fake.write_text(
        f"#!/bin/sh\necho >> {starts}\n"
        f"if [ $(wc -l < {starts}) -le {times} ]; then echo 'bwrap: {said}' >&2; exit 1; fi\n"
        f'exec {shutil.which("bwrap")} "$@"\n'
    )
    fake.chmod(0o755)
    search = f"{folder}:{os.environ['PATH']}"
    found = resident.judge(*rights[:4], "-j", "2", PATH=search)
    if isolation:
        assert (found.status, set(found.verdicts())) == (0, {"AC"}), found.messages()
        assert {row["isolation"] for row in found.results.values()} == {isolation}
        assert found.err == ""
    else:
        assert (found.status, found.verdicts()) == (3, ["JE"] * 4), found.messages()
        assert all("use a smaller -j, or raise the limit on processes" in text for text in found.messages())


@pytest.mark.nightly
@pytest.mark.parametrize(("user", "level"), [*product(USERS, LEVELS[:2])])
def test_a_fork_server_without_a_process_left_says_so_and_goes_on_when_there_is_one(
    attacker: Attacker, user: str, level: str
) -> None:
    attacker.require(level)
    (found,) = attacker.run("scarce.py", level)
    looked = {"inspect": "a shortage"} if (user, level) == ("root", "strong") else {}  # nothing between else
    assert found == {**looked, "calls": "a shortage", "for a moment": [1], "afterwards": [1]}

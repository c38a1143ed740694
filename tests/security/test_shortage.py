"""A machine that is short of something: told as that, at the cost of one submission, never as its fault."""

from __future__ import annotations

import contextlib
import os
import shutil
import subprocess
import sys
import time
import uuid
from collections.abc import Iterator
from itertools import product
from pathlib import Path

import pytest
from attackers import LEVELS, USERS, Attacker, by_turns
from residents import CROWD, RIGHT, WRONG, Resident, command, judged
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
    return resident.submissions(resident.home / "rights", **{f"right{place}": RIGHT for place in range(20)})


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
    return ("prlimit", f"--nproc={_tasks_now(uid) + most}")


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
        uid = resident.attacker.uid
        drop = [] if uid is None else ["setpriv", f"--reuid={uid}", f"--regid={uid}", "--clear-groups"]
        yield ("sh", "-c", f'echo $$ > {folder}/cgroup.procs && exec "$@"', "sh", *drop)
    finally:
        _remove(folder)


def _remove(folder: Path) -> None:
    for _ in range(100):  # until all that ran in it has been reaped
        with contextlib.suppress(OSError):
            folder.rmdir()
            return
        time.sleep(0.05)


CROWDS = [
    (bound, user, level, most)
    for bound, users in (("ulimit", USERS[:1]), ("container", USERS))
    for user in users
    for level in ("full", "strong")
    for most in (90, 260)
]
CROWDS_BY_DAY = [("ulimit", "plain", "full", 90), ("container", USERS[-1], "strong", 260)]


@pytest.mark.parametrize(
    ("bound", "user", "level", "most"),
    [each if each in CROWDS_BY_DAY else nightly(*each) for each in CROWDS],
)
def test_a_right_program_is_accepted_whatever_threads_its_neighbours_hold(
    resident: Resident, crowded: list[str], bound: str, level: str, most: int
) -> None:
    """120 threads need a machine that has them, or are its shortage."""
    resident.attacker.require(level)
    words = command(*crowded, "-j", "8", "--isolation", level)
    if bound == "ulimit":
        found = judged(resident.run(words, before=_limited_processes(resident, most)))
    else:
        with _group(resident, "pids", {"pids.max": most}) as joined:
            found = judged(resident.run(words, before=joined, as_root=True))
    assert found.verdicts("right") == ["AC"] * MANY, found.messages()
    assert set(found.verdicts("crowd")) == {"AC" if most > 200 else "JE"}, found.messages()
    assert found.status == (0 if most > 200 else 3)
    assert all("threads at once here, and not 128 as elsewhere; raise" in text for text in found.messages())
    limit = "ulimit -u is " if bound == "ulimit" else "/sys/fs/cgroup/"
    assert f"judge: 1 at once, not 8: there is no room for more ({limit}" in found.err
    assert bound == "ulimit" or f"pids.max is {most})" in found.err
    assert found.err.count("\n") == 1


@pytest.mark.parametrize("user", USERS[:1])
def test_two_judges_that_take_each_others_processes_blame_no_right_program(
    resident: Resident, crowded: list[str]
) -> None:
    """Each has counted what is left before the other took it."""
    limited = _limited_processes(resident, 200)
    words = command(*crowded, "-j", "2")
    both = [resident.popen(words, before=limited) for _ in range(2)]
    for process in both:
        out, err = process.communicate(timeout=150)
        found = judged(subprocess.CompletedProcess(words, process.returncode, out, err))
        assert len(found.results) == len(crowded)
        assert set(found.verdicts("right")) <= {"AC", "JE"}, found.messages("right")


@pytest.mark.parametrize(("jobs", "user"), by_turns(["200", "20"], USERS))
def test_the_descriptors_that_there_are_bound_what_is_done_at_once(
    resident: Resident, rights: list[str], jobs: str
) -> None:
    limit = "200:200" if jobs == "200" else "64:200"
    found = resident.judge(*rights, "-j", jobs, before=("prlimit", f"--nofile={limit}"))
    assert (found.status, set(found.verdicts())) == (0, {"AC"}), found.messages()
    assert "there is no room for more (ulimit -n is 200)" in found.err
    assert found.err.count("\n") == 1


def test_a_soft_limit_on_descriptors_is_raised_without_a_word(resident: Resident, rights: list[str]) -> None:
    found = resident.judge(*rights, "-j", "20", before=("prlimit", "--nofile=40:4096"))
    assert (found.status, set(found.verdicts()), found.err) == (0, {"AC"}, "")


REMEDIES = {
    "--fsize=1000000": "raise the limit (ulimit -f unlimited)",
    "--as=600000000": "raise the limit (ulimit -v",
    "--data=600000000": "raise the limit (ulimit -d",
}


@pytest.mark.parametrize(("option", "user"), by_turns(REMEDIES, USERS))
def test_a_limit_on_the_judge_is_named_with_its_remedy_and_blames_no_submission(
    resident: Resident, rights: list[str], option: str
) -> None:
    found = resident.judge(*rights[:6], "-j", "3", before=("prlimit", option))
    assert (found.status, found.verdicts()) == (3, ["JE"] * 6), found.messages()
    assert all(REMEDIES[option] in text and "\n" not in text for text in found.messages()), found.messages()
    assert all("internal fault" not in text for text in found.messages())


@pytest.mark.nightly
@pytest.mark.parametrize("user", USERS)
def test_too_few_descriptors_for_a_single_container_are_named(resident: Resident, rights: list[str]) -> None:
    said: set[str] = set()
    for most in (12, 14, 17):
        found = resident.judge(*rights[:3], before=("prlimit", f"--nofile={most}:{most}"))
        assert len(found.results) == 3
        assert set(found.verdicts()) <= {"AC", "JE"}, found.messages()
        assert (found.status == 0) is (set(found.verdicts()) == {"AC"})
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
    ("No permissions to create new namespace", 10_000, "strong"),
]


@pytest.mark.parametrize(
    ("failure", "user"),
    [*by_turns(FAILURES, USERS), *(nightly((NO_ROOM, 10_000, ""), user) for user in USERS)],
)
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
    attacker: Attacker, level: str
) -> None:
    attacker.require(level)
    (found,) = attacker.run("scarce.py", level)
    assert found == {
        "inspect": "a shortage",
        "calls": "a shortage",
        "for a moment": [1],
        "afterwards": [1],
    }


def _once(deed: str) -> str:
    """A right program that does this in the first worked example."""
    return f"import os\ndef middle(a, b):\n    if (a, b) == (1, 2):\n        {deed}\n    return (a + b) / 2\n"


LOADED = {
    "right": RIGHT,
    "exact": "from fractions import Fraction\n" + RIGHT.replace("(a + b) / 2", "float(Fraction(a + b) / 2)"),
    "program": "for _ in range(int(input())):\n    print(sum(map(float, input().split())) / 2)\n",
    "waits": f"import time\ntime.sleep(0.5)\n{RIGHT}",
    "crowd": CROWD,
    "wrong": WRONG,
    "raises": _once("1 / 0"),
    "hogs": _once("rows = []\n        while True: rows.append(bytearray(b'x') * (8 << 20))"),
    "leaves": _once("os._exit(0)"),
    "broken": "def middle(a, b:\n",
}


@contextlib.contextmanager
def _load(count: int) -> Iterator[None]:
    """So many processes that do nothing but work."""
    busy = [subprocess.Popen([sys.executable, "-S", "-c", "while True: pass"]) for _ in range(count)]
    try:
        yield
    finally:
        for process in busy:
            process.kill()
            process.wait()


@pytest.mark.nightly
@pytest.mark.parametrize("user", USERS)
def test_a_loaded_machine_flips_no_verdict(resident: Resident) -> None:
    files = resident.submissions(resident.home / "loaded", **LOADED)
    quiet = resident.judge(*files)
    assert quiet.verdicts() == ["AC"] * 5 + ["WA", "RTE", "MLE", "RTE", "CE"], quiet.messages()
    with _load(2 * (os.cpu_count() or 1)):
        loaded = resident.judge(*files, "-j", "4")
    assert loaded.verdicts() == quiet.verdicts(), loaded.messages()
    assert (loaded.status, loaded.err) == (quiet.status, "")

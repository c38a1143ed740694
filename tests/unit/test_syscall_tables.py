"""The numbers of the system calls against the kernel's own headers (Debian: linux-libc-dev)."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from bpf_machine import PID, named, number_of, of_child, of_server
from bpf_machine import decision as _run

from judge.sandbox.filters import ALLOW, KILL, NO_TERMINAL, REFUSED, ROW, UNKNOWN, X32_BIT

GENERIC = Path("/usr/include/asm-generic/unistd.h")  # the table aarch64 uses
X86_64 = [Path("/usr/include/x86_64-linux-gnu/asm/unistd_64.h"), Path("/usr/include/asm/unistd_64.h")]
NUMBERS = {"x86_64": 0, "aarch64": 1}


def _published(paths: list[Path]) -> dict[str, int]:
    path = next((path for path in paths if path.exists()), None)
    if path is None:
        pytest.skip(f"{paths[0]} is not installed (linux-libc-dev)")
    raw = dict(re.findall(r"^#define\s+(__NR\w+)\s+(\w+)", path.read_text(), re.MULTILINE))
    table: dict[str, int] = {}
    for name, value in raw.items():
        while value in raw:  # __NR_fcntl is __NR3264_fcntl is 25
            value = raw[value]
        if name.startswith("__NR_") and value.isdecimal():
            table[name.removeprefix("__NR_")] = int(value)
    return table


@pytest.mark.parametrize(("machine", "paths"), [("x86_64", X86_64), ("aarch64", [GENERIC])])
def test_numbers_are_the_kernels(machine: str, paths: list[Path]) -> None:
    published = _published(paths)
    assert len(published) > 250
    ours = {call: number_of(call, machine) for call in named()}
    assert ours == {call: published.get(call) for call in ours}


@pytest.mark.parametrize("call", ["landlock_create_ruleset", "landlock_add_rule", "landlock_restrict_self"])
def test_landlock_has_the_same_numbers_everywhere(call: str) -> None:
    assert number_of(call, "x86_64") == number_of(call, "aarch64")


@pytest.mark.parametrize("machine", NUMBERS)
def test_what_the_server_may_do(machine: str) -> None:
    rows = of_server(machine)
    assert len(rows) < 400 * ROW.size
    for call in ("read", "openat", "mmap", "futex", "wait4", "exit_group", "getrandom", "clone", "sendmsg"):
        assert _run(rows, machine, call) == ALLOW, call
    assert _run(rows, machine, "clone", 0x10000000 | 17) == REFUSED
    assert _run(rows, machine, "clone", 0x00020000) == REFUSED
    assert _run(rows, machine, "clone3") == UNKNOWN
    assert _run(rows, machine, "capset") == REFUSED
    assert _run(rows, machine, "landlock_add_rule") == REFUSED
    assert _run(rows, machine, "ioctl", 1, 0x541B) == ALLOW
    assert _run(rows, machine, "ioctl", 1, 0x5412) == NO_TERMINAL  # TIOCSTI
    assert _run(rows, machine, "fcntl", 1, 3) == ALLOW
    assert _run(rows, machine, "fcntl", 1, 8) == REFUSED  # F_SETOWN


@pytest.mark.parametrize("machine", NUMBERS)
def test_only_stream_pairs_and_no_addresses(machine: str) -> None:
    rows = of_server(machine)
    assert _run(rows, machine, "socketpair", 1, 1 | 0o2000000) == ALLOW
    assert _run(rows, machine, "socketpair", 1, 2) == REFUSED  # datagrams carry addresses
    assert _run(rows, machine, "socketpair", 2, 1) == REFUSED
    assert _run(rows, machine, "sendto", 3, 0, 0, 0, 0) == ALLOW
    assert _run(rows, machine, "sendto", 3, 0, 0, 0, 0x1000) == REFUSED
    assert _run(rows, machine, "sendto", 3, 0, 0, 0, 1 << 40) == REFUSED


@pytest.mark.parametrize("machine", NUMBERS)
def test_what_a_child_gives_up(machine: str) -> None:
    rows = of_child(machine)
    for call in ("kill", "tgkill"):
        assert _run(rows, machine, call, PID, 9) == ALLOW
        for other in (PID + 1, 1, 0, -1, -PID):
            assert _run(rows, machine, call, other, 9) == REFUSED
    assert _run(rows, machine, "prlimit64", 0) == ALLOW
    assert _run(rows, machine, "prlimit64", 1) == REFUSED
    assert _run(rows, machine, "prctl", 15) == ALLOW
    assert _run(rows, machine, "prctl", 1) == REFUSED  # PR_SET_PDEATHSIG
    assert _run(rows, machine, "clone", 0x10000) == ALLOW
    assert _run(rows, machine, "clone", 17) == REFUSED
    for call in ("sendmsg", "recvmsg", "seccomp"):
        assert _run(rows, machine, call) == REFUSED
    assert _run(rows, machine, "read") == ALLOW


@pytest.mark.parametrize("machine", NUMBERS)
def test_unnamed_numbers_are_refused(machine: str) -> None:
    ours = {number_of(call, machine) for call in named()}
    unnamed = {101, 165, 310, 311, 425, 426, 427, 320, 40, 270_000} - ours
    assert len(unnamed) > 5
    rows = of_server(machine)
    assert {number: _run(rows, machine, number) for number in unnamed} == dict.fromkeys(unnamed, REFUSED)


def test_the_second_table_of_x86_64_is_refused_and_another_architecture_is_killed() -> None:
    rows = of_server("x86_64")
    assert _run(rows, "x86_64", X32_BIT) == UNKNOWN
    _, architecture, end = list(ROW.iter_unpack(rows))[:3]
    assert architecture == (0x15, 1, 0, 0xC000003E)
    assert end == (0x06, 0, 0, KILL)

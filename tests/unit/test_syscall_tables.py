"""The numbers of the system calls against the kernel's own headers (Debian: linux-libc-dev)."""

from __future__ import annotations

import errno
import re
import struct
from pathlib import Path

import pytest

from judge.sandbox.linux import bpf, seccomp, syscalls

GENERIC = Path("/usr/include/asm-generic/unistd.h")  # the table aarch64 uses
X86_64 = [Path("/usr/include/x86_64-linux-gnu/asm/unistd_64.h"), Path("/usr/include/asm/unistd_64.h")]
ALLOWED, REFUSED = bpf.ALLOW, bpf.errno_action(errno.EPERM)
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
    ours = {call: syscalls.number(call, machine) for call in syscalls.TABLE}
    assert ours == {call: published.get(call) for call in ours}


@pytest.mark.parametrize("call", ["landlock_create_ruleset", "landlock_add_rule", "landlock_restrict_self"])
def test_landlock_has_the_same_numbers_everywhere(call: str) -> None:
    assert syscalls.number(call, "x86_64") == syscalls.number(call, "aarch64")


def _run(rows: list[bpf.Instruction], machine: str, call: int | str, *arguments: int) -> int:
    """What a filter says of a call: an interpreter of the few instructions the filters use."""
    number = syscalls.number(call, machine) if isinstance(call, str) else call
    assert number is not None
    words = [argument & (1 << 64) - 1 for argument in (*arguments, 0, 0, 0, 0, 0, 0)][:6]
    data = struct.pack("<IIQ6Q", number, syscalls.audit_architecture(machine), 0, *words)
    place = accumulator = 0
    while True:
        code, yes, no, constant = rows[place]
        place += 1
        if code == 0x20:
            accumulator = int.from_bytes(data[constant : constant + 4], "little")
        elif code == 0x06:
            return constant
        else:
            tests = {
                0x15: accumulator == constant,
                0x25: accumulator > constant,
                0x35: accumulator >= constant,
            }
            place += yes if tests.get(code, bool(accumulator & constant)) else no


@pytest.mark.parametrize("machine", NUMBERS)
def test_what_the_server_may_do(machine: str) -> None:
    rows = seccomp.server_filter(machine)
    assert len(rows) < 400
    for call in ("read", "openat", "mmap", "futex", "wait4", "exit_group", "getrandom", "clone", "sendmsg"):
        assert _run(rows, machine, call) == ALLOWED, call
    assert _run(rows, machine, "clone", 0x10000000 | 17) == REFUSED
    assert _run(rows, machine, "clone", 0x00020000) == REFUSED
    assert _run(rows, machine, "clone3") == bpf.errno_action(errno.ENOSYS)
    assert _run(rows, machine, "capset") == REFUSED
    assert _run(rows, machine, "landlock_add_rule") == REFUSED
    assert _run(rows, machine, "ioctl", 1, 0x541B) == ALLOWED
    assert _run(rows, machine, "ioctl", 1, 0x5412) == bpf.errno_action(errno.ENOTTY)  # TIOCSTI
    assert _run(rows, machine, "fcntl", 1, 3) == ALLOWED
    assert _run(rows, machine, "fcntl", 1, 8) == REFUSED  # F_SETOWN


@pytest.mark.parametrize("machine", NUMBERS)
def test_only_stream_pairs_and_no_addresses(machine: str) -> None:
    rows = seccomp.server_filter(machine)
    assert _run(rows, machine, "socketpair", 1, 1 | 0o2000000) == ALLOWED
    assert _run(rows, machine, "socketpair", 1, 2) == REFUSED  # datagrams carry addresses
    assert _run(rows, machine, "socketpair", 2, 1) == REFUSED
    assert _run(rows, machine, "sendto", 3, 0, 0, 0, 0) == ALLOWED
    assert _run(rows, machine, "sendto", 3, 0, 0, 0, 0x1000) == REFUSED
    assert _run(rows, machine, "sendto", 3, 0, 0, 0, 1 << 40) == REFUSED


@pytest.mark.parametrize("machine", NUMBERS)
def test_what_a_child_gives_up(machine: str) -> None:
    rows = seccomp.child_filter(machine, 4711)
    for call in ("kill", "tgkill"):
        assert _run(rows, machine, call, 4711, 9) == ALLOWED
        for other in (4712, 1, 0, -1, -4711):
            assert _run(rows, machine, call, other, 9) == REFUSED
    assert _run(rows, machine, "prlimit64", 0) == ALLOWED
    assert _run(rows, machine, "prlimit64", 1) == REFUSED
    assert _run(rows, machine, "prctl", 15) == ALLOWED
    assert _run(rows, machine, "prctl", 1) == REFUSED  # PR_SET_PDEATHSIG
    assert _run(rows, machine, "clone", 0x10000) == ALLOWED
    assert _run(rows, machine, "clone", 17) == REFUSED
    for call in ("sendmsg", "recvmsg", "seccomp"):
        assert _run(rows, machine, call) == REFUSED
    assert _run(rows, machine, "read") == ALLOWED


@pytest.mark.parametrize("machine", NUMBERS)
def test_unnamed_numbers_are_refused(machine: str) -> None:
    named = {syscalls.number(call, machine) for call in syscalls.TABLE}
    unnamed = {101, 165, 310, 311, 425, 426, 427, 320, 40, 270_000} - named
    assert len(unnamed) > 5
    rows = seccomp.server_filter(machine)
    assert {number: _run(rows, machine, number) for number in unnamed} == dict.fromkeys(unnamed, REFUSED)


def test_the_second_table_of_x86_64_is_refused_and_another_architecture_is_killed() -> None:
    rows = seccomp.server_filter("x86_64")
    assert _run(rows, "x86_64", syscalls.X32_BIT) == bpf.errno_action(errno.ENOSYS)
    assert rows[1][3] == 0xC000003E
    assert rows[2] == (0x06, 0, 0, bpf.KILL)

"""Every system call of the kernel is allowed by name, with a reason, or refused; a new one is refused."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest
from bpf_machine import decision, named, number_of, of_child, of_server

from judge.sandbox.filters import ALLOW, PROFILES, UNKNOWN, table
from judge.sandbox.filters import REFUSED as FORBIDDEN

TESTS = Path(__file__).parents[1]
MACHINES = ("x86_64", "aarch64")
HEADERS = {
    "x86_64": [Path("/usr/include/x86_64-linux-gnu/asm/unistd_64.h"), Path("/usr/include/asm/unistd_64.h")],
    "aarch64": [Path("/usr/include/asm-generic/unistd.h")],
}
OF_32_BITS = range(403, 424)  # in the generic header, times of 64 bits for machines of 32
REFUSED = {FORBIDDEN, UNKNOWN}
NEWEST = 471
ANY = ((), (1,), (0x10000,), (0, 0, 2, 2), (4711, 9))  # arguments


def kernels():
    """Each call's numbers, by its name."""
    text = (TESTS / "fixtures" / "linux_system_calls.txt").read_text(encoding="utf-8")
    rows = (line.split() for line in text.splitlines() if line and not line.startswith("#"))
    return {name: (int(x86), None if arm == "-" else int(arm)) for name, x86, arm in rows}


def refused():
    """Why each call that is not allowed is refused, by its name."""
    groups = tomllib.loads((TESTS / "security" / "refused_calls.toml").read_text(encoding="utf-8"))["refused"]
    return {call: group["why"] for group in groups for call in group["calls"].split()}


def test_each_is_allowed_or_refused_and_none_is_both():
    assert named() | set(refused()) == set(kernels()), "decide about these"
    assert not named() & set(refused())


def test_the_numbers_are_the_kernels():
    listed = kernels()
    assert {call: tuple(number_of(call, machine) for machine in MACHINES) for call in named()} == {
        call: listed[call] for call in named()
    }


@pytest.mark.parametrize("machine", MACHINES)
def test_the_headers_of_this_machine_have_no_call_that_nobody_has_decided_about(machine):
    path = next((path for path in HEADERS[machine] if path.exists()), None)
    if path is None:
        pytest.skip("linux-libc-dev is not installed")
    found = re.findall(
        r"^#define\s+__NR(?:3264)?_(\w+)\s+(\d+)", path.read_text(encoding="ascii"), re.MULTILINE
    )
    skipped = {"syscalls", "arch_specific_syscall"}
    numbers = {int(number) for name, number in found if name not in skipped} - set(OF_32_BITS)
    column = MACHINES.index(machine)
    assert numbers - {row[column] for row in kernels().values()} == set(), "decide about these"


@pytest.mark.parametrize("machine", MACHINES)
@pytest.mark.parametrize("profile", PROFILES)
def test_what_is_not_in_the_table_is_refused_in_every_container(machine, profile):
    allowed = {number_of(call, machine) for call in table(machine)}
    rows = of_server(machine, profile)
    for number in set(range(NEWEST + 100)) - allowed:
        assert all(decision(rows, machine, number, *arguments) in REFUSED for arguments in ANY), number


@pytest.mark.parametrize("machine", MACHINES)
@pytest.mark.parametrize("profile", PROFILES)
def test_the_owner_in_the_table_is_who_may(machine, profile):
    server, child = of_server(machine, profile), of_child(machine, profile)
    for call, (number, whose) in table(machine).items():
        if whose == "looked":
            continue
        by_server = decision(server, machine, number) == ALLOW
        by_child = by_server and decision(child, machine, number) == ALLOW
        assert (by_server, by_child) == (
            whose in PROFILES[profile].server,
            whose in PROFILES[profile].child,
        ), call


def test_a_compiled_program_starts_nothing_and_has_no_memory_that_is_not_counted():
    server, child = of_server("x86_64", "run"), of_child("x86_64", "run")
    for call in ("fork", "vfork", "chmod", "fchmodat", "setpgid", "chdir"):
        assert decision(child, "x86_64", call) in REFUSED, call
    for call in ("memfd_create", "link", "symlink", "utimensat"):
        assert decision(server, "x86_64", call) in REFUSED, call
    assert decision(child, "x86_64", "clone", 17) in REFUSED
    assert decision(child, "x86_64", "clone", 0x10000) == ALLOW
    assert decision(child, "x86_64", "mmap", 0, 0, 3, 0x21) in REFUSED

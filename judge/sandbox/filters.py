"""The two filters of system calls: which calls the server in a container may make, and which a child of it.

The big one is an allow-list, loaded once by the fork server and inherited; every call it does not name fails
with EPERM. The small one is added by each child before the submission runs and takes away what only the
server needs: new processes, signals to others, descriptors over sockets, other processes' limits. `calls.tsv`
says which calls these are, this module which arguments some of them may have.

Both are programs of seccomp's classic BPF, in the kernel's form. They see struct seccomp_data: the call's
number at 0, the architecture at 4, argument i as two 32-bit words at 16 + 8i (low, then high: both machines
here are little-endian). Each rule begins and ends with the number in the accumulator, or returns.
"""

from __future__ import annotations

import errno
import struct
from collections.abc import Collection
from functools import cache
from pathlib import Path
from typing import NamedTuple

ROW = struct.Struct("=HBBI")  # code, jump if true, jump if false, constant
Rows = list[tuple[int, int, int, int]]
_LOAD, _EQUAL, _GREATER, _AT_LEAST, _ANY_BIT, _AND, _RETURN = 0x20, 0x15, 0x25, 0x35, 0x45, 0x54, 0x06
_NUMBER, _ARCHITECTURE, _ARGUMENTS = 0, 4, 16

KILL, ALLOW = 0x80000000, 0x7FFF0000
REFUSED, UNKNOWN, NO_TERMINAL = (0x50000 | code for code in (errno.EPERM, errno.ENOSYS, errno.ENOTTY))

MACHINES = {"x86_64": 0xC000003E, "aarch64": 0xC00000B7}  # AUDIT_ARCH_*
X32_BIT = 0x40000000  # x86_64 kernels may carry a second table above this bit; no filter of ours serves it
PID = 0x7FFFFFFF  # stands where a child's pid goes: none is ever this large

_SHARED_NOWHERE = 0x21  # MAP_SHARED and MAP_ANONYMOUS
_IOCTL = 0x5401, 0x5413, 0x541B, 0x5421, 0x5450, 0x5451  # TCGETS TIOCGWINSZ FIONREAD FIONBIO FIONCLEX FIOCLEX
_FCNTL = 0, 1, 2, 3, 4, 1030  # DUPFD GETFD SETFD GETFL SETFL DUPFD_CLOEXEC; no owner, lease, lock or seal
_PRCTL = 15, 16, 0x53564D41  # SET_NAME GET_NAME SET_VMA, which the C library uses
_STREAM = tuple(1 | flags for flags in (0, 0o4000, 0o2000000, 0o2004000))  # with NONBLOCK, CLOEXEC
_CLONE_THREAD = 0x00010000
_CLONE_NAMESPACES = 0x7E020080  # every CLONE_NEW*


class Profile(NamedTuple):
    """One kind of containment: whose calls the server and its children may make.

    `alone` says that a child starts no process, `counted` that it gets no memory that its limit does not
    count.
    """

    server: frozenset[str]
    child: frozenset[str]
    alone: bool = True
    counted: bool = False


_CHILD = frozenset(("all", "looked"))
_SERVER = _CHILD | {"server", "parents"}
_STARTS = _SERVER | {"start", "starter", "helper"}
PROFILES = {
    # a submission in the fork server's own interpreter
    "python": Profile(_SERVER, _CHILD),
    # a compiled program, or another language's interpreter: one `execve`, and threads
    "run": Profile(_STARTS, _CHILD | {"start"}, counted=True),
    # a compiler: processes of its own, and files in the one folder that it may fill
    "compile": Profile(
        _STARTS | {"fill", "compile"},
        _CHILD | {"parents", "start", "helper", "fill", "compile"},
        alone=False,
    ),
}  # none has a network, another session or group of processes, so that a kill of the group ends all


class Filters(NamedTuple):
    """Both filters; a child puts its pid in its own at `pid_at`, and loads it by the call numbered `load`."""

    server: bytes
    child: bytes
    pid_at: tuple[int, ...]
    load: int


@cache
def table(machine: str) -> dict[str, tuple[int, str]]:
    """The calls that a machine has by their names: each one's number, and whose it is."""
    lines = Path(__file__).with_name("calls.tsv").read_text(encoding="utf-8").splitlines()
    rows = (line.split("\t") for line in lines if line and not line.startswith("#"))
    at = list(MACHINES).index(machine)
    return {name: (int(numbers[at]), whose) for name, *numbers, whose, _ in rows if numbers[at] != "-"}


@cache
def filters(machine: str, profile: str) -> Filters:
    """The filters of a profile."""
    server, child = (_packed(make(machine, PROFILES[profile])) for make in (_server, _child))
    rows = enumerate(ROW.iter_unpack(child))
    at = tuple(place * ROW.size + 4 for place, row in rows if row[3] == PID)
    return Filters(server, child, at, _number("seccomp", machine))


def _server(machine: str, profile: Profile) -> Rows:
    rows: Rows = [(_LOAD, 0, 0, _ARCHITECTURE), (_EQUAL, 1, 0, MACHINES[machine]), (_RETURN, 0, 0, KILL)]
    rows += [(_LOAD, 0, 0, _NUMBER)]
    if machine == "x86_64":
        rows += [(_AT_LEAST, 0, 1, X32_BIT), (_RETURN, 0, 0, UNKNOWN)]
    pairs: Rows = [(_EQUAL, 0, 1 + len(_STREAM), 1), (_LOAD, 0, 0, _ARGUMENTS + 8)]
    ruled = {
        "ioctl": _looked(1, _one_of(_IOCTL), NO_TERMINAL),
        "fcntl": _looked(1, _one_of(_FCNTL)),
        # Only stream pairs: a datagram pair could still name another socket as its target.
        "socketpair": _looked(0, [*pairs, *_one_of(_STREAM)]),
        # An address is a pointer of 64 bits.
        "sendto": _looked(4, [(_EQUAL, 0, 2, 0), (_LOAD, 0, 0, _ARGUMENTS + 36), (_EQUAL, 1, 0, 0)]),
        "clone": _looked(0, [(_ANY_BIT, 0, 1, _CLONE_NAMESPACES)]),
    }
    looked_at = {_number(call, machine) for call in ruled}
    for first, last in _runs([each for each in _numbers(profile.server, machine) if each not in looked_at]):
        one: Rows = [(_EQUAL, 0, 1, first), (_RETURN, 0, 0, ALLOW)]
        more: Rows = [(_AT_LEAST, 0, 2, first), (_GREATER, 1, 0, last), (_RETURN, 0, 0, ALLOW)]
        rows += one if first == last else more
    for call, rule in ruled.items():
        rows += _guarded(_number(call, machine), rule)
    for number in _numbers({"never"}, machine):
        rows += _guarded(number, [(_RETURN, 0, 0, UNKNOWN)])
    return [*rows, (_RETURN, 0, 0, REFUSED)]


def _child(machine: str, profile: Profile) -> Rows:
    """What a child of the server gives up besides."""
    ruled: dict[str, Rows] = {}
    if profile.counted:
        both: Rows = [(_AND, 0, 0, _SHARED_NOWHERE), (_EQUAL, 0, 1, _SHARED_NOWHERE)]
        ruled["mmap"] = _looked(3, both)
    if profile.alone:
        ruled |= {call: _looked(0, _one_of((PID,))) for call in ("kill", "tgkill")}
        ruled["prctl"] = _looked(0, _one_of(_PRCTL))
        ruled["clone"] = _looked(0, [(_ANY_BIT, 1, 0, _CLONE_THREAD)])
    ruled["prlimit64"] = _looked(0, _one_of((0, PID) if profile.alone else (0,)))
    rows: Rows = [(_LOAD, 0, 0, _NUMBER)]
    for call, rule in ruled.items():
        rows += _guarded(_number(call, machine), rule)
    for number in _numbers(profile.server - profile.child, machine):
        rows += _guarded(number, [(_RETURN, 0, 0, REFUSED)])
    return [*rows, (_RETURN, 0, 0, ALLOW)]


def _guarded(number: int, rule: Rows) -> Rows:
    """The rule for this call alone."""
    return [(_EQUAL, 0, len(rule), number), *rule]


def _looked(argument: int, tests: Rows, refuse: int = REFUSED) -> Rows:
    """Allow where the tests of this argument's low word jump over the refusal, the one row after them."""
    return [(_LOAD, 0, 0, _ARGUMENTS + 8 * argument), *tests, (_RETURN, 0, 0, refuse), (_RETURN, 0, 0, ALLOW)]


def _one_of(values: tuple[int, ...]) -> Rows:
    return [(_EQUAL, len(values) - place, 0, value) for place, value in enumerate(values)]


def _number(call: str, machine: str) -> int:
    return table(machine)[call][0]


def _numbers(whose: Collection[str], machine: str) -> list[int]:
    """The numbers of the calls of these."""
    return sorted(number for number, each in table(machine).values() if each in whose)


def _runs(numbers: list[int]) -> list[tuple[int, int]]:
    """Sorted numbers as runs of consecutive ones, so that the filter is short."""
    runs: list[tuple[int, int]] = []
    for number in numbers:
        if runs and runs[-1][1] == number - 1:
            runs[-1] = (runs[-1][0], number)
        else:
            runs.append((number, number))
    return runs


def _packed(rows: Rows) -> bytes:
    return b"".join(ROW.pack(*row) for row in rows)

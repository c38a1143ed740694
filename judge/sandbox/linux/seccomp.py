"""The two filters: what the server in a container may still do, and what a child of it may.

The big one is an allow-list, loaded once by the fork server and inherited; every call it does not name
fails with EPERM. The small one is added by each child before the submission runs and takes away what only
the server needs: new processes, signals to others, descriptors over sockets, other processes' limits.
`judge.sandbox.linux.syscalls` says which calls these are, `judge.sandbox.linux.profiles` for whom. This
module looks at the arguments of those that are allowed for some arguments alone.
"""

from __future__ import annotations

import errno

from judge.sandbox.linux import bpf, kernel, syscalls
from judge.sandbox.linux.foreign import Byte, Pointer, Structure, UInt, UShort, addressof, byref
from judge.sandbox.linux.profiles import PYTHON

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable

    from judge.sandbox.linux.profiles import Profile

_REFUSED = bpf.errno_action(errno.EPERM)
_UNKNOWN = bpf.errno_action(errno.ENOSYS)

_SHARED_NOWHERE = 0x21  # MAP_SHARED and MAP_ANONYMOUS

_IOCTL = (
    0x5401,
    0x5413,
    0x541B,
    0x5421,
    0x5450,
    0x5451,
)  # TCGETS TIOCGWINSZ FIONREAD FIONBIO FIONCLEX FIOCLEX
_FCNTL = (0, 1, 2, 3, 4, 1030)  # DUPFD GETFD SETFD GETFL SETFL DUPFD_CLOEXEC; no owner, lease, lock or seal
_PRCTL = (15, 16, 0x53564D41)  # SET_NAME GET_NAME SET_VMA, which the C library uses
_STREAM = tuple(1 | flags for flags in (0, 0o4000, 0o2000000, 0o2004000))  # with NONBLOCK, CLOEXEC
_CLONE_THREAD = 0x00010000
_CLONE_NAMESPACES = 0x7E020080  # every CLONE_NEW*
_SET_FILTER = 1  # seccomp(2): SECCOMP_SET_MODE_FILTER


class _Program(Structure):
    """struct sock_fprog."""

    _fields_ = (("length", UShort), ("rows", Pointer))


def available() -> bool:
    """Whether this kernel filters system calls and this machine has a table."""
    machine = syscalls.machine()
    if not syscalls.supported(machine):
        return False
    action = UInt(bpf.KILL)
    try:
        kernel.syscall(_number("seccomp", machine), UInt(2), UInt(0), byref(action))
    except OSError:
        return False
    return True


def server_filter(machine: str, profile: Profile = PYTHON) -> list[bpf.Instruction]:
    """The server's filter: an allow-list, everything else is EPERM."""
    x32 = syscalls.X32_BIT if machine == "x86_64" else None
    rows = bpf.check_architecture(syscalls.audit_architecture(machine), x32, _UNKNOWN)
    ruled = {
        "ioctl": bpf.one_of(_number("ioctl", machine), 1, _IOCTL, bpf.errno_action(errno.ENOTTY)),
        "fcntl": bpf.one_of(_number("fcntl", machine), 1, _FCNTL, _REFUSED),
        "socketpair": _socket_pairs(machine),
        "sendto": bpf.null_pointer(_number("sendto", machine), 4, _REFUSED),
        "clone": bpf.without_bits(_number("clone", machine), 0, _CLONE_NAMESPACES, _REFUSED),
    }
    plain = (call for call in syscalls.calls_of(profile.server) if call not in ruled)
    for first, last in _runs(_numbers(plain, machine)):
        rows += bpf.decide_range(first, last, bpf.ALLOW)
    for rule in ruled.values():
        rows += rule
    for number in _numbers(syscalls.calls_of((syscalls.NEVER,)), machine):
        rows += bpf.decide(number, _UNKNOWN)
    return rows + bpf.otherwise(_REFUSED)


def child_filter(machine: str, pid: int, profile: Profile = PYTHON) -> list[bpf.Instruction]:
    """What a child of the server gives up besides; `pid` is its own."""
    rows = bpf.load_number()
    if profile.counted:
        rows += bpf.without_both(_number("mmap", machine), 3, _SHARED_NOWHERE, _REFUSED)
    if profile.alone:
        for call in ("kill", "tgkill"):
            rows += bpf.one_of(_number(call, machine), 0, (pid,), _REFUSED)
        rows += bpf.one_of(_number("prctl", machine), 0, _PRCTL, _REFUSED)
        rows += bpf.with_bits(_number("clone", machine), 0, _CLONE_THREAD, _REFUSED)
    rows += bpf.one_of(_number("prlimit64", machine), 0, (0, pid) if profile.alone else (0,), _REFUSED)
    servers = [whose for whose in profile.server if whose not in profile.child]
    for number in _numbers(syscalls.calls_of(servers), machine):
        rows += bpf.decide(number, _REFUSED)
    return rows + bpf.otherwise(bpf.ALLOW)


class Filter:
    """An assembled filter that can be loaded any number of times; needs no_new_privs."""

    def __init__(self, rows: list[bpf.Instruction]) -> None:
        self._bytes = bpf.assemble(rows)
        self._buffer = (Byte * len(self._bytes)).from_buffer(self._bytes)
        self._program = _Program(len(rows), addressof(self._buffer))
        self._number = _number("seccomp", syscalls.machine())

    def load(self) -> None:
        """Hold this process and its children to the filter from here on. Raises OSError."""
        kernel.syscall(self._number, UInt(_SET_FILTER), UInt(0), byref(self._program))


class ChildFilter(Filter):
    """The small filter, assembled once before the forks; a child only writes its own pid into it."""

    _MARK = 0x7FFFFFFF  # no pid is ever this large

    def __init__(self, profile: Profile = PYTHON) -> None:
        rows = child_filter(syscalls.machine(), self._MARK, profile)
        self._places = [index for index, row in enumerate(rows) if row[3] == self._MARK]
        super().__init__(rows)

    def load_for(self, pid: int) -> None:
        """Load it in the process `pid`, which must be the caller. Raises OSError."""
        for place in self._places:
            at = place * bpf.ROW.size + 4
            self._bytes[at : at + 4] = pid.to_bytes(4, "little")
        self.load()


def _socket_pairs(machine: str) -> list[bpf.Instruction]:
    """Only stream pairs: a datagram pair could still name another socket as its target.

    Two arguments are tested, so the block is two: other families go first, then the types.
    """
    number = _number("socketpair", machine)
    family = bpf.one_of(number, 0, (1,), _REFUSED)
    family[-1] = bpf.load_number()[0]  # a unix pair is not yet allowed: go on to its type
    return family + bpf.one_of(number, 1, _STREAM, _REFUSED)


def _number(call: str, machine: str) -> int:
    number = syscalls.number(call, machine)
    if number is None:
        raise LookupError(f"{machine} has no system call {call}")
    return number


def _numbers(calls: Iterable[str], machine: str) -> list[int]:
    """The numbers of the calls, those that the machine has."""
    found = (syscalls.number(call, machine) for call in calls)
    return sorted(number for number in found if number is not None)


def _runs(numbers: Iterable[int]) -> list[tuple[int, int]]:
    """Sorted numbers as runs of consecutive ones, so that the filter is short."""
    runs: list[tuple[int, int]] = []
    for number in numbers:
        if runs and runs[-1][1] == number - 1:
            runs[-1] = (runs[-1][0], number)
        else:
            runs.append((number, number))
    return runs

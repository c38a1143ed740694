"""The two filters: what the server in a container may still do, and what a child of it may.

The big one is an allow-list, loaded once by the fork server and inherited; every call it does not name
fails with EPERM. The small one is added by each child before the submission runs and takes away what only
the server needs: new processes, signals to others, descriptors over sockets, other processes' limits.
What runs in the container (`judge.sandbox.linux.profiles`) needs more calls, or must not have some.
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

_FREE = """
    read write readv writev pread64 pwrite64 preadv pwritev close close_range lseek
    open openat stat fstat lstat newfstatat statx access faccessat faccessat2 getdents getdents64 getcwd
    dup dup2 dup3 fsync fdatasync ftruncate fadvise64
    pipe pipe2 poll ppoll select pselect6 epoll_create1 epoll_ctl epoll_wait epoll_pwait eventfd2
    recvfrom shutdown getsockname
    mmap munmap mprotect mremap madvise mincore brk membarrier
    rt_sigaction rt_sigprocmask rt_sigreturn rt_sigpending rt_sigtimedwait rt_sigsuspend sigaltstack pause
    alarm getitimer setitimer restart_syscall
    nanosleep clock_nanosleep clock_gettime clock_getres gettimeofday time times
    futex set_robust_list get_robust_list rseq set_tid_address exit exit_group wait4 waitid
    sched_yield sched_getaffinity sched_getparam sched_getscheduler
    sched_get_priority_max sched_get_priority_min getcpu
    getpid gettid getppid getuid geteuid getgid getegid getgroups getresuid getresgid
    getpgrp getpgid getsid getpriority
    uname sysinfo getrandom getrusage getrlimit setrlimit umask
"""
_FORK_SERVER = "fork vfork kill tgkill sendmsg recvmsg seccomp prctl prlimit64"
_NOT_IN_A_CHILD = "sendmsg recvmsg seccomp"
_NEW_PROCESSES = "fork vfork"
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
    for first, last in _runs(_numbers(f"{_FREE} {_FORK_SERVER} {profile.more}", machine)):
        rows += bpf.decide_range(first, last, bpf.ALLOW)
    rows += bpf.one_of(_number("ioctl", machine), 1, _IOCTL, bpf.errno_action(errno.ENOTTY))
    rows += bpf.one_of(_number("fcntl", machine), 1, _FCNTL, _REFUSED)
    rows += _socket_pairs(machine)
    rows += bpf.null_pointer(_number("sendto", machine), 4, _REFUSED)
    rows += bpf.without_bits(_number("clone", machine), 0, _CLONE_NAMESPACES, _REFUSED)
    rows += bpf.decide(_number("clone3", machine), _UNKNOWN)  # the C library falls back on clone
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
    refused = f"{_NOT_IN_A_CHILD} {_NEW_PROCESSES if profile.alone else ''} {profile.not_in_a_child}"
    for number in _numbers(refused, machine):
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


def _numbers(calls: str, machine: str) -> list[int]:
    """The numbers of the calls in a text, those that the machine has."""
    found = (syscalls.number(call, machine) for call in calls.split())
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

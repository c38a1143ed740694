"""The system calls that a container allows: by name, each with its numbers, whose it is, and why.

A call that is not in this table is refused: one that is new to the kernel waits until somebody decides.
`tests/security/refused_calls.toml` says why each of the others is not here; a test holds both against the
kernel's list of today.

A number is None where that machine never had the call (aarch64 has only the newer one of each pair: `openat`
and no `open`). Whose it is:

    ALL        everything in every container
    LOOKED     the same, for some arguments alone: `judge.sandbox.linux.seccomp` says which
    SERVER     the server, no child of it
    PARENTS    the server, and a compiler, which starts its own steps
    START      everything in a container where another program is started
    STARTER    the server there
    HELPER     the server there, and a compiler
    FILL       everything in a container with a folder that may be filled
    COMPILE    everything in a compiler's container
    BEFORE     the server until its filter is loaded, and nobody later
    NEVER      refused by name: as ENOSYS, and not as EPERM
"""

from __future__ import annotations

import os

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Container

X32_BIT = 0x40000000  # x86_64 kernels may carry a second table above this bit; no filter of ours serves it

ALL, LOOKED, SERVER, PARENTS, START, STARTER, HELPER, FILL, COMPILE, BEFORE, NEVER = range(11)

_ARCHITECTURES = {"x86_64": (0, 0xC000003E), "aarch64": (1, 0xC00000B7)}  # column, AUDIT_ARCH_*

TABLE: dict[str, tuple[int | None, int | None, int, str]] = {
    # files that are open, and those that landlock lets it open
    "read": (0, 63, ALL, "reads what is open"),
    "write": (1, 64, ALL, "writes to what is open"),
    "readv": (19, 65, ALL, "as read, into several buffers"),
    "writev": (20, 66, ALL, "as write, from several buffers"),
    "pread64": (17, 67, ALL, "as read, at a place"),
    "pwrite64": (18, 68, ALL, "as write, at a place"),
    "preadv": (295, 69, ALL, "as readv, at a place"),
    "pwritev": (296, 70, ALL, "as writev, at a place"),
    "close": (3, 57, ALL, "gives a descriptor back"),
    "close_range": (436, 436, ALL, "gives many back"),
    "lseek": (8, 62, ALL, "moves within a file"),
    "open": (2, None, ALL, "opens a file: landlock says which"),
    "openat": (257, 56, ALL, "opens a file: landlock says which"),
    "stat": (4, None, ALL, "looks whether a module is there; at strong it tells that any file exists"),
    "fstat": (5, 80, ALL, "looks at what is open"),
    "lstat": (6, None, ALL, "as stat"),
    "newfstatat": (262, 79, ALL, "as stat"),
    "statx": (332, 291, ALL, "as stat"),
    "access": (21, None, ALL, "looks whether a file may be read"),
    "faccessat": (269, 48, ALL, "as access"),
    "faccessat2": (439, 439, ALL, "as access"),
    "getdents": (78, None, ALL, "lists a folder that is open"),
    "getdents64": (217, 61, ALL, "lists a folder that is open"),
    "getcwd": (79, 17, ALL, "asks for its own folder"),
    "dup": (32, 23, ALL, "a second descriptor of its own"),
    "dup2": (33, None, ALL, "as dup"),
    "dup3": (292, 24, ALL, "as dup"),
    "fcntl": (72, 25, LOOKED, "copies a descriptor, reads or sets its flags; no owner, lease, lock or seal"),
    "ioctl": (16, 29, LOOKED, "a terminal's size, what waits in a pipe; no command to any device"),
    "fsync": (74, 82, ALL, "waits for the disk, as close does for some"),
    "fdatasync": (75, 83, ALL, "as fsync"),
    "ftruncate": (77, 46, ALL, "shortens what it has opened for writing"),
    "fadvise64": (221, 223, ALL, "says how it will read"),
    # waiting
    "pipe": (22, None, ALL, "talks between its own threads"),
    "pipe2": (293, 59, ALL, "as pipe"),
    "poll": (7, None, ALL, "waits for its own descriptors"),
    "ppoll": (271, 73, ALL, "as poll"),
    "select": (23, None, ALL, "as poll"),
    "pselect6": (270, 72, ALL, "as poll"),
    "epoll_create1": (291, 20, ALL, "as poll, for event loops"),
    "epoll_ctl": (233, 21, ALL, "as epoll_create1"),
    "epoll_wait": (232, None, ALL, "as epoll_create1"),
    "epoll_pwait": (281, 22, ALL, "as epoll_create1"),
    "eventfd2": (290, 19, ALL, "wakes an event loop of its own"),
    "socketpair": (53, 199, LOOKED, "a pair of streams of its own; no datagrams: they carry addresses"),
    "sendto": (44, 206, LOOKED, "writes to such a pair; no address"),
    "recvfrom": (45, 207, ALL, "reads from such a pair"),
    "shutdown": (48, 210, ALL, "closes one way of such a pair"),
    "getsockname": (51, 204, ALL, "asks such a pair for its name"),
    # memory
    "mmap": (9, 222, LOOKED, "takes memory, maps open files; none shared that no limit would count"),
    "munmap": (11, 215, ALL, "gives memory back"),
    "mprotect": (10, 226, ALL, "loaders of libraries, compilers at run time"),
    "mremap": (25, 216, ALL, "grows an allocation"),
    "madvise": (28, 233, ALL, "gives memory back early"),
    "mincore": (27, 232, ALL, "which of its own pages are in memory"),
    "brk": (12, 214, ALL, "takes memory"),
    "membarrier": (324, 283, ALL, "orders its own threads"),
    # signals to itself, and time
    "rt_sigaction": (13, 134, ALL, "handles its own signals"),
    "rt_sigprocmask": (14, 135, ALL, "as rt_sigaction"),
    "rt_sigreturn": (15, 139, ALL, "ends a handler"),
    "rt_sigpending": (127, 136, ALL, "as rt_sigaction"),
    "rt_sigtimedwait": (128, 137, ALL, "waits for a signal of its own"),
    "rt_sigsuspend": (130, 133, ALL, "as rt_sigtimedwait"),
    "sigaltstack": (131, 132, ALL, "handles an overflow of its stack"),
    "pause": (34, None, ALL, "waits for a signal"),
    "alarm": (37, None, ALL, "a signal to itself"),
    "getitimer": (36, 102, ALL, "as alarm"),
    "setitimer": (38, 103, ALL, "as alarm"),
    "kill": (62, 129, LOOKED, "the server ends its children; a child reaches itself alone"),
    "tgkill": (234, 131, LOOKED, "as kill; abort() uses it"),
    "restart_syscall": (219, 128, ALL, "goes on after a stop"),
    "nanosleep": (35, 101, ALL, "sleeps; the limits count it"),
    "clock_nanosleep": (230, 115, ALL, "as nanosleep"),
    "clock_gettime": (228, 113, ALL, "reads a clock"),
    "clock_getres": (229, 114, ALL, "as clock_gettime"),
    "gettimeofday": (96, 169, ALL, "as clock_gettime"),
    "time": (201, None, ALL, "as clock_gettime"),
    "times": (100, 153, ALL, "reads its own CPU time"),
    # processes and threads
    "clone": (56, 220, LOOKED, "starts a thread; a process if server or compiler; no namespace"),
    "clone3": (435, 435, NEVER, "no filter sees its flags; ENOSYS, and the C library takes clone"),
    "fork": (57, None, PARENTS, "starts a process: the server, a compiler's steps"),
    "vfork": (58, None, PARENTS, "as fork"),
    "futex": (202, 98, ALL, "locks between its own threads"),
    "set_robust_list": (273, 99, ALL, "locks of a thread that ends"),
    "get_robust_list": (274, 100, ALL, "as set_robust_list"),
    "rseq": (334, 293, ALL, "the C library's own counters for each processor"),
    "set_tid_address": (218, 96, ALL, "the C library's own, at a thread's start"),
    "exit": (60, 93, ALL, "ends a thread"),
    "exit_group": (231, 94, ALL, "ends the process"),
    "wait4": (61, 260, ALL, "waits for children of its own"),
    "waitid": (247, 95, ALL, "as wait4"),
    "sched_yield": (24, 124, ALL, "lets others go first"),
    "sched_getaffinity": (204, 123, ALL, "counts the processors"),
    "sched_getparam": (143, 121, ALL, "asks, changes nothing"),
    "sched_getscheduler": (145, 120, ALL, "asks, changes nothing"),
    "sched_get_priority_max": (146, 125, ALL, "asks, changes nothing"),
    "sched_get_priority_min": (147, 126, ALL, "asks, changes nothing"),
    "getcpu": (309, 168, ALL, "asks, changes nothing"),
    # who and where it is
    "getpid": (39, 172, ALL, "asks, changes nothing"),
    "gettid": (186, 178, ALL, "asks, changes nothing"),
    "getppid": (110, 173, ALL, "asks, changes nothing"),
    "getuid": (102, 174, ALL, "asks, changes nothing"),
    "geteuid": (107, 175, ALL, "asks, changes nothing"),
    "getgid": (104, 176, ALL, "asks, changes nothing"),
    "getegid": (108, 177, ALL, "asks, changes nothing"),
    "getgroups": (115, 158, ALL, "asks, changes nothing"),
    "getresuid": (118, 148, ALL, "asks, changes nothing"),
    "getresgid": (120, 150, ALL, "asks, changes nothing"),
    "getpgrp": (111, None, ALL, "asks, changes nothing"),
    "getpgid": (121, 155, ALL, "asks, changes nothing"),
    "getsid": (124, 156, ALL, "asks, changes nothing"),
    "getpriority": (140, 141, ALL, "asks, changes nothing"),
    "uname": (63, 160, ALL, "the kernel's name and version"),
    "sysinfo": (99, 179, ALL, "how much memory there is"),
    "getrandom": (318, 278, ALL, "random numbers"),
    "getrusage": (98, 165, ALL, "what it has used itself"),
    "getrlimit": (97, 163, ALL, "its own limits"),
    "setrlimit": (160, 164, ALL, "lowers its own limits; only root raises any"),
    "prlimit64": (302, 261, LOOKED, "as getrlimit and setrlimit, of itself"),
    "umask": (95, 166, ALL, "rights of files that it makes, where it may make any"),
    "prctl": (157, 167, LOOKED, "the server watches; a child names its threads"),
    # the server alone
    "sendmsg": (46, 211, SERVER, "hands over what the judge asked for"),
    "recvmsg": (47, 212, SERVER, "takes what the judge asks for"),
    "seccomp": (317, 277, SERVER, "loads a child's own filter"),
    # before the filter is loaded, and never again
    "landlock_create_ruleset": (444, 444, BEFORE, "says which files stay"),
    "landlock_add_rule": (445, 445, BEFORE, "says which files stay"),
    "landlock_restrict_self": (446, 446, BEFORE, "says which files stay"),
    "capset": (126, 91, BEFORE, "drops all capabilities"),
    # where another program is started: compiled ones, compilers
    "execve": (59, 221, START, "becomes the program; landlock says which may be run"),
    "arch_prctl": (158, None, START, "the C library's own, at a program's start"),
    "readlink": (89, None, START, "finds its own library folders; landlock hides the links' targets"),
    "readlinkat": (267, 78, START, "as readlink"),
    "setpgid": (109, 154, STARTER, "a group of processes that is ended as a whole"),
    "chdir": (80, 49, HELPER, "goes to the program's folder"),
    # where a folder is filled: by compilers; landlock says which
    "mkdir": (83, None, FILL, "makes a folder"),
    "mkdirat": (258, 34, FILL, "makes a folder"),
    "unlink": (87, None, FILL, "takes a file of its own away"),
    "unlinkat": (263, 35, FILL, "takes a file of its own away"),
    "rename": (82, None, FILL, "renames a file of its own"),
    "renameat": (264, 38, FILL, "renames a file of its own"),
    "renameat2": (316, 276, FILL, "renames a file of its own"),
    "rmdir": (84, None, FILL, "takes a folder of its own away"),
    "flock": (73, 32, FILL, "locks a file of its own"),
    "fallocate": (285, 47, FILL, "room for a file; the limit on its size holds"),
    "statfs": (137, 43, FILL, "asks how much room there is"),
    "fstatfs": (138, 44, FILL, "asks how much room there is"),
    "chmod": (90, None, HELPER, "makes a program startable; the server empties closed folders"),
    "fchmod": (91, 52, HELPER, "as chmod"),
    "fchmodat": (268, 53, HELPER, "as chmod"),
    # compilers alone
    "utimensat": (280, 88, COMPILE, "copies a file with its times"),
    "link": (86, None, COMPILE, "a second name in its own folder"),
    "linkat": (265, 37, COMPILE, "as link"),
    "symlink": (88, None, COMPILE, "a link in its own folder; landlock holds for where it leads"),
    "truncate": (76, 45, COMPILE, "shortens a file of its own"),
    "fchdir": (81, 50, COMPILE, "goes to a folder of its own"),
    "memfd_create": (319, 279, COMPILE, "a file in memory; the limit on its size holds"),
}


def machine() -> str:
    """This machine's name as the kernel spells it."""
    return os.uname().machine


def supported(name: str) -> bool:
    """Whether there is a table for the machine `name`."""
    return name in _ARCHITECTURES


def audit_architecture(name: str) -> int:
    """The AUDIT_ARCH word that seccomp shows a filter on the machine `name`."""
    return _ARCHITECTURES[name][1]


def number(call: str, name: str) -> int | None:
    """The number of `call` on the machine `name`, or None where it has no such call."""
    row = TABLE[call]
    return (row[0], row[1])[_ARCHITECTURES[name][0]]


def calls_of(whose: Container[int]) -> list[str]:
    """The calls whose owner is one of these."""
    return [call for call, row in TABLE.items() if row[2] in whose]

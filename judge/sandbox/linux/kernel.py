"""The few calls into the kernel that Python has no function for: prctl, capabilities, raw system calls."""

from __future__ import annotations

import os
import struct

from judge.sandbox.linux.foreign import Byte, Int, Long, UInt, ULong, addressof, function, get_errno

_PRCTL, _CAPSET, _SYSCALL = map(function, ("prctl", "capset", "syscall"))

PR_SET_PDEATHSIG = 1
PR_SET_DUMPABLE = 4
PR_SET_KEEPCAPS = 8
PR_SET_CHILD_SUBREAPER = 36
PR_SET_NO_NEW_PRIVS = 38

PR_CAP_AMBIENT = 47
_RAISE = 2  # of an ambient capability

CAP_DAC_READ_SEARCH = 2
_CAPABILITY_VERSION_3 = 0x20080522

_SET_FILTER, _ACTION_AVAILABLE = 1, 2  # of seccomp(2)
_KILL = 0x80000000  # SECCOMP_RET_KILL_PROCESS
_ROW_BYTES = 8  # of a filter


def prctl(option: int, argument: int, second: int = 0) -> None:
    """One prctl(2) with one argument, or two. Raises OSError."""
    zero = ULong(0)
    _check(_PRCTL(Int(option), ULong(argument), ULong(second), zero, zero) != 0, f"prctl {option}")


def syscall(number: int, *arguments: object) -> int:
    """One raw system call; the arguments are ctypes values, bytes or None. Raises OSError."""
    result = int(_SYSCALL(Long(number), *arguments))
    _check(result < 0, f"system call {number}")
    return result


def keep_only(capability: int | None, *, passed_on: bool = False) -> None:
    """Drop every capability but this one, with None every one. Raises OSError.

    With `passed_on` the programs that are started have it too.
    """
    word = 0 if capability is None else 1 << capability
    header = struct.pack("=Ii", _CAPABILITY_VERSION_3, 0)
    words = struct.pack("=6I", word, word, word if passed_on else 0, 0, 0, 0)
    _check(_CAPSET(header, words) != 0, "capset")
    if passed_on and capability is not None:
        prctl(PR_CAP_AMBIENT, _RAISE, capability)


def filters_calls(number: int) -> bool:
    """Whether this kernel, where seccomp(2) has this number, filters system calls."""
    try:
        syscall(number, UInt(_ACTION_AVAILABLE), UInt(0), struct.pack("=I", _KILL))
    except OSError:
        return False
    return True


def load_filter(number: int, rows: bytearray) -> None:
    """Hold this process and its children to a filter from here on; needs no_new_privs. Raises OSError."""
    program = (Byte * len(rows)).from_buffer(rows)
    head = struct.pack("@HP", len(rows) // _ROW_BYTES, addressof(program))  # struct sock_fprog
    syscall(number, UInt(_SET_FILTER), UInt(0), head)


def _check(failed: bool, what: str) -> None:
    if failed:
        code = get_errno()
        raise OSError(code, f"{what}: {os.strerror(code)}")

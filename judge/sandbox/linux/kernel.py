"""The few calls into the kernel that Python has no function for: prctl, capabilities, raw system calls."""

from __future__ import annotations

import os
import struct

from judge.sandbox.linux.foreign import Int, Long, ULong, function, get_errno

_PRCTL = function("prctl")
_SYSCALL = function("syscall")

PR_SET_PDEATHSIG = 1
PR_SET_DUMPABLE = 4
PR_SET_KEEPCAPS = 8
PR_SET_CHILD_SUBREAPER = 36
PR_SET_NO_NEW_PRIVS = 38

PR_CAP_AMBIENT = 47
_RAISE = 2  # of an ambient capability

CAP_DAC_READ_SEARCH = 2
_CAPABILITY_VERSION_3 = 0x20080522


def prctl(option: int, argument: int, second: int = 0) -> None:
    """One prctl(2) with one argument, or two. Raises OSError."""
    zero = ULong(0)
    if _PRCTL(Int(option), ULong(argument), ULong(second), zero, zero) != 0:
        code = get_errno()
        raise OSError(code, f"prctl {option}: {os.strerror(code)}")


def syscall(number: int, *arguments: object) -> int:
    """One raw system call; the arguments are ctypes values, bytes or None. Raises OSError."""
    result = int(_SYSCALL(Long(number), *arguments))
    if result < 0:
        code = get_errno()
        raise OSError(code, f"system call {number}: {os.strerror(code)}")
    return result


def keep_only(capability: int | None, number: int, *, passed_on: bool = False) -> None:
    """Drop every capability but this one, with None every one; `number` is capset's. Raises OSError.

    With `passed_on` the programs that are started have it too.
    """
    word = 0 if capability is None else 1 << capability
    header = struct.pack("=Ii", _CAPABILITY_VERSION_3, 0)
    syscall(number, header, struct.pack("=6I", word, word, word if passed_on else 0, 0, 0, 0))
    if passed_on and capability is not None:
        prctl(PR_CAP_AMBIENT, _RAISE, capability)

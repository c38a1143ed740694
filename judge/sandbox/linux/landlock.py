"""Landlock: a process gives up every file but the ones under the paths it names, for itself and its children.

    create_ruleset  -> descriptor      what the rules govern: all file rights, TCP, abstract sockets, signals
    add_rule(descriptor, path, rights) once for each path that stays readable
    restrict_self(descriptor)          from here on; cannot be undone

What landlock does not govern (stat, chmod, utime, xattr, readlink, chdir) the seccomp filter refuses, but for
`stat`, which imports need.  https://docs.kernel.org/userspace-api/landlock.html
"""

from __future__ import annotations

import os
import stat
import struct

from judge.sandbox.linux import kernel
from judge.sandbox.linux.foreign import Int, UInt, ULong

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable

_CREATE, _ADD, _RESTRICT = 444, 445, 446  # the same numbers on every machine
_VERSION = 1  # flag of landlock_create_ruleset: tell the ABI instead
_PATH_BENEATH = 1

_EXECUTE, _WRITE_FILE, _READ_FILE, _READ_DIR = 1 << 0, 1 << 1, 1 << 2, 1 << 3
_READ = (
    _EXECUTE | _READ_FILE | _READ_DIR
)  # EXECUTE: mapping a shared library needs none, the loader's own check does
_OF_A_FILE = _EXECUTE | _WRITE_FILE | _READ_FILE
_SPECIAL = 1 << 6 | 1 << 9 | 1 << 10 | 1 << 11  # making devices, sockets and named pipes


def abi() -> int:
    """The kernel's landlock version, 0 without landlock."""
    try:
        return kernel.syscall(_CREATE, None, ULong(0), UInt(_VERSION))
    except OSError:
        return 0


def restrict(
    readable: Iterable[str],
    writable: Iterable[str] = (),
    runnable: Iterable[str] | None = None,
    filled: Iterable[str] = (),
) -> None:
    """Leave this process only the files under `readable`, and those in `writable` for reading and writing.

    Programs under `runnable` alone may be started; all that are readable where it is None. In the folders
    `filled` ordinary files and folders may be made. Paths that do not exist are passed over. Needs
    no_new_privs. Raises OSError.
    """
    version = abi()
    governed = _file_rights(version)
    ruleset = _create(version, governed)
    try:
        for path in readable:
            _allow(ruleset, path, (_READ if runnable is None else _READ & ~_EXECUTE) & governed)
        for path in runnable or ():
            _allow(ruleset, path, _READ & governed)
        for path in writable:
            _allow(ruleset, path, (_READ_FILE | _WRITE_FILE) & governed)
        for path in filled:
            _allow(ruleset, path, governed & ~_SPECIAL)
        kernel.syscall(_RESTRICT, Int(ruleset), UInt(0))
    finally:
        os.close(ruleset)


def _file_rights(version: int) -> int:
    """Every file right this version can govern: 13 at first, then refer, truncate, ioctl on devices."""
    return (1 << (13 + (version >= 2) + (version >= 3) + (version >= 5))) - 1


def _create(version: int, files: int) -> int:
    network = 0b11 if version >= 4 else 0  # bind and connect of TCP
    scopes = 0b11 if version >= 6 else 0  # abstract unix sockets, signals to outside
    size = 24 if version >= 6 else 16 if version >= 4 else 8
    attributes = struct.pack("=QQQ", files, network, scopes)[:size]
    return kernel.syscall(_CREATE, attributes, ULong(size), UInt(0))


def _allow(ruleset: int, path: str, rights: int) -> None:
    try:
        descriptor = os.open(path, os.O_PATH | os.O_CLOEXEC)
    except OSError:
        return
    try:
        if not stat.S_ISDIR(os.fstat(descriptor).st_mode):
            rights &= _OF_A_FILE
        rule = struct.pack("=Qi", rights, descriptor)
        kernel.syscall(_ADD, Int(ruleset), Int(_PATH_BENEATH), rule, UInt(0))
    finally:
        os.close(descriptor)

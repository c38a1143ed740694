"""Linux's own means of confinement, through the C library: prctl, capabilities, filters, landlock.

Landlock: a process gives up every file but the ones under the paths it names, for itself and its children.

    create_ruleset  -> descriptor      what the rules govern: all file rights, TCP, abstract sockets, signals
    add_rule(descriptor, path, rights) once for each path that stays readable
    restrict_self(descriptor)          from here on; cannot be undone

What landlock does not govern (stat, chmod, utime, xattr, readlink, chdir) the filter of calls refuses, but
for `stat`, which imports need.  https://docs.kernel.org/userspace-api/landlock.html
"""

from __future__ import annotations

import _ctypes  # ctypes itself takes half as long to import as the interpreter to start
import os
import stat
import struct

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable


class _Long(_ctypes._SimpleCData):  # type: ignore[type-arg]
    _type_ = "l"


class _Function(_ctypes.CFuncPtr):
    _flags_ = _ctypes.FUNCFLAG_CDECL | _ctypes.FUNCFLAG_USE_ERRNO
    _restype_ = _Long  # where it is an int, 0 and not 0 stay so


_LIBRARY = _ctypes.dlopen(None, 0)  # type: ignore[arg-type]  # the C library of this process
_syscall, _prctl, _capset = [
    _Function(_ctypes.dlsym(_LIBRARY, each)) for each in ("syscall", "prctl", "capset")
]

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

_CREATE, _ADD, _RESTRICT = 444, 445, 446  # the same numbers on every machine
_VERSION = 1  # flag of landlock_create_ruleset: tell the ABI instead
_PATH_BENEATH = 1

_EXECUTE, _WRITE_FILE, _READ_FILE, _READ_DIR = 1 << 0, 1 << 1, 1 << 2, 1 << 3
# Mapping a shared library needs no right to execute it, the loader's own check does.
_READ = _EXECUTE | _READ_FILE | _READ_DIR
_OF_A_FILE = _EXECUTE | _WRITE_FILE | _READ_FILE
_SPECIAL = 1 << 6 | 1 << 9 | 1 << 10 | 1 << 11  # making devices, sockets and named pipes


def prctl(option: int, argument: int, second: int = 0) -> None:
    """One prctl(2) with one argument, or two. Raises OSError."""
    _check(_prctl(*_words(option, argument, second, 0, 0)), f"prctl {option}")


def syscall(number: int, *arguments: int | bytes | None) -> int:
    """One raw system call. Raises OSError."""
    result: int = _syscall(*_words(number, *arguments))
    _check(result < 0, f"system call {number}")
    return result


def _words(*arguments: int | bytes | None) -> list[object]:
    """The arguments, the numbers among them as wide as a register."""
    return [_Long(each) if isinstance(each, int) else each for each in arguments]


def keep_only(capability: int | None, *, passed_on: bool = False) -> None:
    """Drop every capability but this one, with None every one. Raises OSError.

    With `passed_on` the programs that are started have it too.
    """
    word = 0 if capability is None else 1 << capability
    header = struct.pack("=Ii", _CAPABILITY_VERSION_3, 0)
    words = struct.pack("=6I", word, word, word if passed_on else 0, 0, 0, 0)
    _check(_capset(header, words), "capset")
    if passed_on and capability is not None:
        prctl(PR_CAP_AMBIENT, _RAISE, capability)


def filters_calls(number: int) -> bool:
    """Whether this kernel, where seccomp(2) has this number, filters system calls."""
    try:
        syscall(number, _ACTION_AVAILABLE, 0, struct.pack("=I", _KILL))
    except OSError:
        return False
    return True


def load_filter(number: int, rows: bytearray) -> None:
    """Hold this process and its children to a filter from here on; needs no_new_privs. Raises OSError."""
    program = _ctypes.addressof(_Long.from_buffer(rows))
    syscall(number, _SET_FILTER, 0, struct.pack("@HP", len(rows) // _ROW_BYTES, program))  # a sock_fprog


def _check(failed: bool, what: str) -> None:
    if failed:
        code = _ctypes.get_errno()
        raise OSError(code, f"{what}: {os.strerror(code)}")


def abi() -> int:
    """The kernel's landlock version, 0 without landlock."""
    try:
        return syscall(_CREATE, None, 0, _VERSION)
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
    # Every file right that this version can govern: 13 at first, then refer, truncate, ioctl on devices.
    governed = (1 << (13 + (version >= 2) + (version >= 3) + (version >= 5))) - 1
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
        syscall(_RESTRICT, ruleset, 0)
    finally:
        os.close(ruleset)


def _create(version: int, files: int) -> int:
    network = 0b11 if version >= 4 else 0  # bind and connect of TCP
    scopes = 0b11 if version >= 6 else 0  # abstract unix sockets, signals to outside
    size = 24 if version >= 6 else 16 if version >= 4 else 8
    return syscall(_CREATE, struct.pack("=QQQ", files, network, scopes)[:size], size, 0)


def _allow(ruleset: int, path: str, rights: int) -> None:
    try:
        descriptor = os.open(path, os.O_PATH | os.O_CLOEXEC)
    except OSError:
        return
    try:
        if not stat.S_ISDIR(os.fstat(descriptor).st_mode):
            rights &= _OF_A_FILE
        syscall(_ADD, ruleset, _PATH_BENEATH, struct.pack("=Qi", rights, descriptor), 0)
    finally:
        os.close(descriptor)

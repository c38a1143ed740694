"""What no submission may read: the last check before a confined fork server says that it is ready.

It asks the kernel, not the plan by which folders were hidden, so that an error in that plan stops the run
instead of showing somebody the solutions.
"""

from __future__ import annotations

import errno
import os
import stat

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable

NAMES = ("judge", "problems", "solutions")  # what the judge brings, beside one another or in one another
_MARKS = {  # by what such a folder is known; another package may well be called "problems"
    "judge": ("sandbox/boundary.py", "problems", "solutions"),
    "problems": ("*/problem.toml",),
    "solutions": ("*/accepted",),
}
_NOT_SEEN = frozenset({errno.ENOENT, errno.EACCES, errno.ENOTDIR, errno.ELOOP, errno.ENAMETOOLONG})


def first_visible(paths: Iterable[str], searched: Iterable[str]) -> str:
    """The first that can be read of `paths`, or of the judge's own folders in `searched`; "" if none can.

    Raises OSError where that cannot be told.
    """
    for path in paths:
        if shows(path):
            return path
    for entry in searched:
        for name in NAMES:
            folder = f"{entry}/{name}"
            if shows(folder) and is_ours(folder, name):
                return folder
    return ""


def shows(path: str) -> bool:
    """Whether there is a file that can be opened, or a folder that lists anything."""
    try:
        number = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)
    except OSError as error:
        if error.errno in _NOT_SEEN:
            return False
        raise
    try:
        return not stat.S_ISDIR(os.fstat(number).st_mode) or bool(os.listdir(number))  # noqa: PTH208
    finally:
        os.close(number)


def is_ours(folder: str, name: str) -> bool:
    """Whether a folder of one of NAMES holds what the judge's own, or a pack's, would hold."""
    for mark in _MARKS[name]:
        entries = os.listdir(folder) if mark.startswith("*/") else [""]  # noqa: PTH208
        rest = mark.removeprefix("*")
        if any(os.path.lexists(f"{folder}/{entry}/{rest}") for entry in entries):
            return True
    return False

"""Calling the C library through the core of ctypes: what is around it takes as long to import as a box boots.

    prctl = function("prctl")           a function of the C library that is already loaded
    prctl(Int(4), ULong(0), …)          the arguments are values of the types below, bytes or None

Every function gives a C long; `get_errno()` is errno as the last of them left it.
"""

from __future__ import annotations

import _ctypes as core
from _ctypes import addressof, get_errno

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    _Simple = core._SimpleCData[Any]
else:
    _Simple = core._SimpleCData

__all__ = [
    "Byte",
    "Int",
    "Long",
    "UInt",
    "ULong",
    "addressof",
    "function",
    "get_errno",
]


class Byte(_Simple):
    """A char."""

    _type_ = "c"


class Int(_Simple):
    """An int."""

    _type_ = "i"


class UInt(_Simple):
    """An unsigned int."""

    _type_ = "I"


class Long(_Simple):
    """A long."""

    _type_ = "l"


class ULong(_Simple):
    """An unsigned long, as wide as a size_t on every machine that Linux knows."""

    _type_ = "L"


class _Library:
    """The C library of this process."""

    _handle = core.dlopen(None, 0)  # type: ignore[arg-type]  # None stands for this process


class _Function(core.CFuncPtr):
    _flags_ = core.FUNCFLAG_CDECL | core.FUNCFLAG_USE_ERRNO
    _restype_ = Long


def function(name: str) -> Any:
    """The C library's function of that name."""
    return _Function((name, _Library()))  # type: ignore[arg-type]  # only its handle is asked for

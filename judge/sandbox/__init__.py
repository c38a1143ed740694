"""Containment: running a source that nobody trusts. Knows nothing of problems."""

from __future__ import annotations

import sys

from judge.sandbox.boundary import (
    Box,
    CallsResult,
    Inspection,
    Limits,
    ProgramResult,
    Reply,
    SourceFault,
    Stop,
    Usage,
)

__all__ = [
    "Box",
    "CallsResult",
    "Inspection",
    "Limits",
    "ProgramResult",
    "Reply",
    "SourceFault",
    "Stop",
    "Usage",
    "open_box",
]


def open_box(source: bytes, name: str, *, python: str | None = None) -> Box:
    """A box for one submission; use it in a `with` statement.

    Args:
        source: the submission's bytes, as they are in its file.
        name: its file name, shown in tracebacks.
        python: the interpreter that runs it; the judge's own where none is given.
    """
    from judge.sandbox.process import ProcessBox  # only a run needs sockets and processes

    return ProcessBox(source, name, python or sys.executable)

"""Containment: running a source that nobody trusts. Knows nothing of problems."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from judge.sandbox.boundary import LEVELS, Box, BoxFactory, Limits, Stop, Usage
from judge.sandbox.factory import Containment

if TYPE_CHECKING:
    from pathlib import Path

__all__ = ["LEVELS", "Box", "BoxFactory", "Containment", "Limits", "Stop", "Usage", "open_box"]


def open_box(source: bytes, name: str, *, level: str | None = None, hide: Iterable[Path] = ()) -> Box:
    """A box for one submission, at the best isolation level or at the one demanded; use it in a `with`.

    Who opens several had better use `Containment`.

    Args:
        source: the submission's bytes, as they are in its file.
        name: its file name, shown in tracebacks.
        level: "full", "strong" or "limits"; UsageError if that cannot be had here.
        hide: more folders that must not be seen inside, if they lie among the interpreter's own.
    """
    return Containment(level, hide)(source, name)

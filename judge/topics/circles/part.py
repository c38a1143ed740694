"""How much of a line a problem is about."""

from __future__ import annotations

from enum import Enum


class Part(Enum):
    """The part of the line A + t·D that counts."""

    LINE = "line"  # all of it
    SEGMENT = "segment"  # t from 0 to 1
    RAY = "ray"  # t from 0

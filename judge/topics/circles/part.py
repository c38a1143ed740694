"""What a problem is about: how much of the line counts, and how its cases are read."""

from __future__ import annotations

from enum import Enum


class Part(Enum):
    """The part of the line A + t·D that counts; a case is (cx, cy, r, A, B) where nothing else is said."""

    LINE = "line"  # all of it
    CHORD = "chord"  # all of it, and the answer is a length on it
    SEGMENT = "segment"  # t from 0 to 1
    RAY = "ray"  # t from 0; (cx, cy, r, O, D)
    POINT = "point"  # none: (cx, cy, r, P), read as the line from P to P
    TANGENTS = "tangents"  # the same, and the answers are points on the lines through P that touch
    PAIR = "pair"  # none: (cx1, cy1, r1, cx2, cy2, r2), the second circle's centre read as such a point
    COMMON = "common"  # the same, and the answers are points of circle 1 on common tangents
    FOOT = "foot"  # all of it: (A, B, P), the circle is the point P
    NORMAL = "normal"  # all of it: (A, B), the circle is the origin

    @property
    def of_point(self) -> bool:
        """Whether a case is a circle and a point, with no line."""
        return self in (Part.POINT, Part.TANGENTS)

    @property
    def of_pair(self) -> bool:
        """Whether a case is two circles."""
        return self in (Part.PAIR, Part.COMMON)

    @property
    def endless(self) -> bool:
        """Whether the whole infinite line counts."""
        return self not in (Part.SEGMENT, Part.RAY)

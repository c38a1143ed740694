"""What a problem is about: how much of the line counts, and how its cases are read."""

from __future__ import annotations

from enum import Enum


class Part(Enum):
    """The part of the line A + t·D that counts; a case is (cx, cy, r, A, B) where nothing else is said."""

    LINE = "line"  # all of it
    CHORD = "chord"  # all of it, and the answer is a length on it
    SEGMENT = "segment"  # t from 0 to 1
    RAY = "ray"  # t from 0; (cx, cy, r, O, D)
    HIT = "hit"  # the same, and the answer is the normal where the ray meets the circle first
    BOUNCE = "bounce"  # the same, and the answer is that point and the direction reflected there
    POINT = "point"  # none: (cx, cy, r, P), read as the line from P to P
    TANGENTS = "tangents"  # the same, and the answers are points on the lines through P that touch
    PAIR = "pair"  # none: (cx1, cy1, r1, cx2, cy2, r2), the second circle's centre read as such a point
    COMMON = "common"  # the same, and the answers are points of circle 1 on common tangents
    HITS = "hits"  # t from 0, of many circles: (circles, O, D)
    SPANS = "spans"  # the same, and what of the ray is inside: (circles, O, D, program)
    SHADOW = "shadow"  # the same, and whether a light reaches the first hit: (circles, O, D, L)
    FOOT = "foot"  # all of it: (A, B, P), the circle is the point P
    NORMAL = "normal"  # all of it: (A, B), the circle is the origin

    @property
    def of_point(self) -> bool:
        """Whether a case is a circle and a point, with no line."""
        return self in (Part.POINT, Part.TANGENTS)

    @property
    def of_ray(self) -> bool:
        """Whether a case is a circle and a ray: (cx, cy, r, O, D)."""
        return self in (Part.RAY, Part.HIT, Part.BOUNCE)

    @property
    def of_vectors(self) -> bool:
        """Whether the answer has a vector at the point that a ray meets first."""
        return self in (Part.HIT, Part.BOUNCE)

    @property
    def of_pair(self) -> bool:
        """Whether a case is two circles."""
        return self in (Part.PAIR, Part.COMMON)

    @property
    def of_crowd(self) -> bool:
        """Whether a case is many circles and a ray."""
        return self in (Part.HITS, Part.SPANS, Part.SHADOW)

    @property
    def endless(self) -> bool:
        """Whether the whole infinite line counts."""
        return self is not Part.SEGMENT and not self.of_ray

"""The common points of a circle and a line in integers of any size: no band, no tolerance, no promise."""

from __future__ import annotations

from judge.data.builders import counting
from judge.data.images import mirror_images

IntPoint = tuple[int, int]

BUILDERS = {
    "grid": counting.grid,
    "degenerate": counting.degenerate,
    "zero_radius": counting.zero_radius,
    "axis": counting.axis,
    "tangent": counting.tangent,
    "just_hit": counting.just_hit,
    "just_miss": counting.just_miss,
    "least_gap": counting.least_gap,
    "small_gap": counting.small_gap,
    "slid": counting.slid,
    "offset": counting.offset,
    "off_segment": counting.off_segment,
    "scattered": counting.scattered,
}
IMAGES = mirror_images


def reference(cx: int, cy: int, r: int, A: IntPoint, B: IntPoint) -> int | None:
    """The sign of r²a − k², for a = |B − A|² and the cross product k of B − A and A − C; None for A == B.

    This is the discriminant of the equation for the intersection, by Lagrange's identity.
    """
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == dy == 0:
        return None
    cross = dx * (A[1] - cy) - dy * (A[0] - cx)
    reach, distance = r * r * (dx * dx + dy * dy), cross * cross
    return 1 + (reach > distance) - (reach < distance)


def promise(*_case: object) -> str | None:
    """Nothing to keep: every integer case has its exact answer."""
    return None

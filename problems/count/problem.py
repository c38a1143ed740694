"""The common points of a circle and a line: the exact count, with the tangency band of problem.toml."""

from __future__ import annotations

from functools import lru_cache

from judge.data.builders import counting
from judge.data.images import mirror_images
from judge.exact import Bands, CircleLine
from judge.problem.load import bands_beside
from judge.problem.model import Number, Point

_WIDTHS = bands_beside(__file__)
_BANDS = Bands(snap=_WIDTHS["snap"], clear=_WIDTHS["clear"])

BUILDERS = {
    "grid": counting.grid,
    "degenerate": counting.degenerate,
    "close": counting.close,
    "zero_radius": counting.zero_radius,
    "axis": counting.axis,
    "tangent": counting.tangent,
    "band": counting.band,
    "near": counting.near,
    "any_kind": counting.any_kind,
    "offset": counting.offset,
    "far": counting.far,
    "lopsided": counting.lopsided,
    "off_segment": counting.off_segment,
    "scattered": counting.scattered,
}
IMAGES = mirror_images

_line = lru_cache(1)(CircleLine.through)  # the promise and the reference ask for one case in turn


def reference(cx: Number, cy: Number, r: Number, A: Point, B: Point) -> int | None:
    """0, 1 or 2 by exact signs; None for A == B."""
    return _BANDS.count(_line(cx, cy, r, A, B))


def promise(cx: Number, cy: Number, r: Number, A: Point, B: Point) -> str | None:
    """What keeps the case out of the data: a line neither within the tangency band nor clear of it."""
    return _BANDS.broken_count(_line(cx, cy, r, A, B))

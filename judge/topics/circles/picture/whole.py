"""The panel at true scale."""

from __future__ import annotations

from fractions import Fraction

from judge.drawing.frame import ExactNumber, Frame, length, rounded
from judge.drawing.lengths import round_below, short
from judge.drawing.shapes import Bar, Panel
from judge.topics.circles.picture.marks import every_spot, extent, marks_in
from judge.topics.circles.picture.scene import Scene
from judge.topics.circles.picture.strokes import circles, straight

_FAR = 6  # points further out than so many radii (or distances of the line) are shown at the edge
_MARGIN = Fraction(5, 4)
_BAR = Fraction(1, 2)

Bounds = tuple[Fraction, Fraction, Fraction, Fraction]


def whole_panel(scene: Scene) -> Panel:
    """The circle with whatever lies within a few of its sizes, and arrows to the rest."""
    frame = whole_frame(scene)
    strokes = (*circles(frame, scene), *straight(frame, scene))
    return Panel("True scale", strokes, marks_in(frame, scene, beyond=True), (scale_bar(frame, scene),))


def scale_bar(frame: Frame, scene: Scene, *, of_extent: bool = False) -> Bar:
    """A round length in the caller's units, or in units of e."""
    one = extent(scene) if of_extent else Fraction(1 << scene.line.shift)
    size = round_below(frame.unit / one * _BAR)
    share = float(size * one / frame.unit)
    return Bar(share, f"{short(size)} e" if of_extent else short(size))


def whole_frame(scene: Scene) -> Frame:
    """A window around the circle, the foot of the perpendicular and all points that are not far from them."""
    line = scene.line
    core = _core(scene)
    reach = _side(core) or extent(scene) / 8
    middle = (core[0] + core[2]) / 2, (core[1] + core[3]) / 2
    box = core
    for spot, _ in every_spot(scene):
        x, y = rounded_near(spot.x, middle[0], reach), rounded_near(spot.y, middle[1], reach)
        if max(abs(x - middle[0]), abs(y - middle[1])) <= _FAR * reach:
            box = _around(box, x, y)
    side = _side(box) or Fraction(max(line.extent, 1))
    return Frame((box[0] + box[2]) / 2, (box[1] + box[3]) / 2, side / 2 * _MARGIN)


def rounded_near(value: ExactNumber, middle: Fraction, reach: Fraction) -> Fraction:
    """A coordinate, irrational or not, as a fraction that is near it on the window's scale."""
    return middle + rounded((value - middle) / reach) * reach


def _core(scene: Scene) -> Bounds:
    """The circle and the foot, or for a point circle on the line what there is besides."""
    line = scene.line
    fx, fy = scene.foot
    cx, cy, r = Fraction(line.cx), Fraction(line.cy), Fraction(line.r)
    if not line.a and r and not scene.pair and length(fx - cx, fy - cy) > _FAR * r:
        fx, fy = cx, cy
    box = (min(cx - r, fx), min(cy - r, fy), max(cx + r, fx), max(cy + r, fy))
    for other in scene.circles[1:]:
        low, high = (other.cx - other.r, other.cy - other.r), (other.cx + other.r, other.cy + other.r)
        for at in (low, high):
            box = _around(box, Fraction(at[0]), Fraction(at[1]))
    if _side(box):
        return box
    for x, y in (scene.start, scene.end):
        box = _around(box, Fraction(x), Fraction(y))
    return box


def _around(box: Bounds, x: Fraction, y: Fraction) -> Bounds:
    return min(box[0], x), min(box[1], y), max(box[2], x), max(box[3], y)


def _side(box: Bounds) -> Fraction:
    return max(box[2] - box[0], box[3] - box[1])

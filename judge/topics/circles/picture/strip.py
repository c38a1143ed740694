"""The frames of a silhouette: all circles over each other at true scale, and a strip that follows d/r.

In the strip each frame is a dot at its d/r, the band between both thresholds is filled, and each dot says
what is to be shown there. Of many frames those around the first one that was answered wrongly are drawn.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import cos, pi, sin
from typing import Any

from judge.drawing.clip import inside, polygon, polyline
from judge.drawing.frame import Frame, direction, near
from judge.drawing.lengths import round_below, short
from judge.drawing.shapes import Bar, Fact, Mark, Panel, Picture, Role, Stroke
from judge.exact import Surd
from judge.problem.topic import Shown
from judge.topics.circles import frames
from judge.topics.circles.picture.marks import at_edge, merged

_MOST = 16  # frames that are drawn
_BEFORE = 5  # of them, how many come before the one that is wrong
_FAR = 6  # O is in the window if it is within so many radii
_MARGIN = Fraction(5, 4)
_BAR = Fraction(1, 2)
_REACH = 4.0
_HIGHEST = 2.6  # how far the strip goes, in widths of the band's half
_SHORT = 40  # letters of an answer or an input that are told


def strip(shown: Shown) -> Picture | None:
    """The picture of one case, or None where its arguments are no circles and line."""
    if len(shown.values) != 4:
        return None
    circles, origin, way, h = shown.values.values()
    circles = [tuple(each) for each in circles]
    taken = frames.frames_of(circles, tuple(origin), tuple(way))
    wanted = list(shown.exact)
    given = list(shown.given) if isinstance(shown.given, list | tuple) else None
    if not taken[0].a or len(wanted) != len(taken):
        return None
    wrong = _first_wrong(wanted, given)
    first = max(0, min((wrong or 0) - _BEFORE, len(taken) - _MOST))
    chosen = range(first, min(len(taken), first + _MOST))
    focus = chosen[0] if wrong is None else wrong
    got = shown.got or "no answer"
    said = _situation(taken[focus], focus, len(taken))
    inputs = ", ".join(f"{name}={_argument(value)}" for name, value in shown.values.items())
    facts = (
        Fact("input", inputs),
        Fact("wanted", shown.wanted or "", Role.WANTED),
        Fact("got", got, Role.GOT),
        Fact("geometry", said),
    )
    return Picture(
        shown.problem.title,
        shown.heading,
        f"Wanted {shown.wanted}, got {got}; {said}.",
        _whole(circles, origin, way, chosen, focus),
        _strip(taken, h, wanted, given, chosen),
        facts,
        "the band lies between r(1 − h) and r(1 + h)",
    )


def _first_wrong(wanted: Sequence[int], given: Sequence[Any] | None) -> int | None:
    """The first frame whose answer is another one, or is missing."""
    if given is None:
        return None
    pairs = enumerate(zip(wanted, given, strict=False))
    wrong = next((place for place, (right, mine) in pairs if mine is not right and mine != right), None)
    return min(len(given), len(wanted) - 1) if wrong is None and len(given) != len(wanted) else wrong


def _argument(value: Any) -> str:
    if isinstance(value, list | tuple):
        text = f"({', '.join(map(_argument, value))})"
        return text if len(text) <= 8 * _SHORT else f"{text[: 4 * _SHORT]} …"
    return repr(value)


def _situation(frame: frames.Frame, place: int, count: int) -> str:
    """Where the frame in focus stands, in words."""
    which = f"frame {place + 1} of {count}"
    if not frame.radius:
        return f"{which}: r = 0"
    return f"{which}: d is {short(_ratio(frame), 4)} r"


def _ratio(frame: frames.Frame) -> Surd:
    return Surd(0, 1, frame.reach, frame.a * frame.radius)


# -- all circles over each other ---------------------------------------------------------------------------


def _whole(circles: Sequence[Any], origin: Any, way: Any, chosen: range, focus: int) -> Panel:
    """The circles and the line; the one in focus is filled, and its centre named."""
    window = _window([circles[place] for place in chosen], circles[focus], origin)
    strokes = [stroke for place in chosen for stroke in _ring(window, circles[place], place == focus)]
    x, y = Fraction(circles[focus][0]), Fraction(circles[focus][1])
    ox, oy = Fraction(origin[0]), Fraction(origin[1])
    u, v = direction(Fraction(way[0]), Fraction(way[1]))
    at = window.place(x, y)
    # The line as seen from the circle in focus: from O, which may be far away, rounding would show.
    height = (Fraction(way[0]) * (oy - y) - Fraction(way[1]) * (ox - x)) / (
        Fraction(way[0]) ** 2 + Fraction(way[1]) ** 2
    )
    foot = window.place(x - height * Fraction(way[1]), y + height * Fraction(way[0]))
    ends = (foot[0] - _REACH * u, foot[1] - _REACH * v), (foot[0] + _REACH * u, foot[1] + _REACH * v)
    strokes += [Stroke(part, Role.LINE, arrow=True) for part in polyline(ends)]
    strokes += [Stroke(part, Role.BEYOND) for part in polyline((at, foot))]
    spots = ((x, y, f"C of frame {focus + 1}"), (ox, oy, "O"))
    marks = []
    for sx, sy, text in spots:
        dot = window.place(sx, sy)
        marks.append(
            Mark(dot, Role.CASE, text)
            if inside(dot)
            else at_edge(direction(sx - window.x, sy - window.y), Role.CASE, text)
        )
    size = round_below(window.unit * _BAR)
    return Panel("True scale", tuple(strokes), merged(marks), (Bar(float(size / window.unit), short(size)),))


def _window(circles: Sequence[Any], focus: Any, origin: Any) -> Frame:
    """A window around the circle in focus, and what of the others and of O is near it."""
    x, y, r = (Fraction(value) for value in focus)
    reach = r or max(abs(Fraction(origin[0]) - x), abs(Fraction(origin[1]) - y)) or Fraction(1)
    box = [x - reach, y - reach, x + reach, y + reach]
    corners = [(Fraction(origin[0]), Fraction(origin[1]))]
    for cx, cy, radius in circles:
        corners += [
            (Fraction(cx) + sign * Fraction(radius), Fraction(cy) + sign * Fraction(radius))
            for sign in (-1, 1)
        ]
    for px, py in corners:
        if max(abs(px - x), abs(py - y)) <= _FAR * reach:
            box = [min(box[0], px), min(box[1], py), max(box[2], px), max(box[3], py)]
    side = max(box[2] - box[0], box[3] - box[1])
    return Frame((box[0] + box[2]) / 2, (box[1] + box[3]) / 2, side / 2 * _MARGIN)


def _ring(window: Frame, circle: Any, filled: bool) -> list[Stroke]:
    x, y = window.place(Fraction(circle[0]), Fraction(circle[1]))
    size = near(Fraction(circle[2]) / window.unit)
    dots = tuple(
        (x + size * cos(turn), y + size * sin(turn)) for turn in (2 * pi * at / 120 for at in range(120))
    )
    area = polygon(dots) if filled else ()
    fill = [Stroke(area, Role.SHAPE, filled=True)] if area else []
    role = Role.SHAPE if filled else Role.BEYOND
    return [*fill, *(Stroke(part, role) for part in polyline((*dots, dots[0])))]


# -- frame by frame ----------------------------------------------------------------------------------------


def _strip(
    taken: Sequence[frames.Frame], h: Any, wanted: Sequence[int], given: Sequence[Any] | None, chosen: range
) -> Panel:
    """d/r from frame to frame, the band about 1, and what is wanted at each."""
    step = 1.8 / max(1, len(chosen) - 1)
    dots = [(-0.9 + step * place, _height(taken[frame], h)) for place, frame in enumerate(chosen)]
    low, high = -0.9 / _HIGHEST, 0.9 / _HIGHEST
    band = ((-1.0, low), (1.0, low), (1.0, high), (-1.0, high))
    strokes = [Stroke(band, Role.BAND, filled=True)]
    strokes += [Stroke(((-1.0, y), (1.0, y)), Role.BEYOND) for y in (low, 0.0, high)]
    if len(dots) > 1:
        strokes.append(Stroke(tuple(dots), Role.LINE))
    marks: list[Mark] = []
    for dot, frame in zip(dots, chosen, strict=True):
        mine = given[frame] if given is not None and frame < len(given) else None
        marks.append(Mark(dot, Role.WANTED if wanted[frame] else Role.CASE, str(wanted[frame])))
        if given is not None and mine != wanted[frame]:
            marks.append(Mark(dot, Role.GOT, ""))
    title = f"Frames {chosen[0] + 1} to {chosen[-1] + 1}: d/r, and what to show"
    return Panel(
        title, tuple(strokes), tuple(marks), (), "ringed: a hit is wanted; crossed: answered otherwise"
    )


def _height(frame: frames.Frame, h: Any) -> float:
    """(d/r − 1)/h on the strip's scale, cut off at its ends."""
    if not frame.radius:
        return 0.9
    over = near((_ratio(frame) - 1) / Fraction(h))
    return 0.9 * max(-1.0, min(1.0, over / _HIGHEST))

"""A circle and a polygon drawn: edges with their direction, the crossings, and a lens where it is close."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import Any

from judge.drawing.clip import inside, polyline
from judge.drawing.frame import Frame, direction, length, rounded
from judge.drawing.lengths import round_below, short
from judge.drawing.shapes import Bar, Fact, Mark, Panel, Picture, Role, Stroke
from judge.exact import Surd
from judge.problem.topic import Shown
from judge.topics.circles.bands import Bands
from judge.topics.circles.line import CircleLine
from judge.topics.circles.outline import CircleOutline
from judge.topics.circles.picture.compose import argument_text
from judge.topics.circles.picture.marks import at_edge, merged
from judge.topics.circles.picture.spots import Spot, digits
from judge.topics.circles.picture.strokes import circle
from judge.values.decode import Fault, Raw, Written, number

_MARGIN = Fraction(5, 4)
_BAR = Fraction(1, 2)
_CLOSE = Fraction(1, 100)  # what is closer than this share of the window cannot be seen at true scale
_ROOM = Fraction(5, 2)
_NAMED = 12  # corners of more than so many are not named one by one
_MOST = 64  # crossings of a submission that are drawn

_Spots = Sequence[tuple[Spot, Role]]


def draw_outline(shown: Shown) -> Picture | None:
    """The picture of one case."""
    cx, cy, r, given_corners = shown.values.values()
    corners = [tuple(corner) for corner in given_corners]
    outline = CircleOutline.of(cx, cy, r, corners)
    edges = outline.edges
    spots = list(_spots(outline, shown))
    frame = _frame(edges)
    whole = _panel("True scale", frame, outline, spots, beyond=True)
    lens = _lens(outline, frame, spots)
    said = _words(outline, Bands.of(shown.problem.bands))
    got = shown.got or "no answer"
    facts = (
        Fact("input", ", ".join(f"{name}={_short(value)}" for name, value in shown.values.items())),
        Fact("wanted", shown.wanted or "", Role.WANTED),
        Fact("got", got, Role.GOT),
        Fact("geometry", said),
    )
    description = f"Wanted {shown.wanted}, got {got}; {said}."
    return Picture(
        shown.problem.title, shown.heading, description, whole, lens, facts, "e: the case's own size"
    )


def _short(value: Any) -> str:
    if isinstance(value, list | tuple):
        return f"[{', '.join(argument_text(corner) for corner in value)}]"
    return argument_text(value)


def _spots(outline: CircleOutline, shown: Shown) -> Iterator[tuple[Spot, Role]]:
    """The centre and the corners, the wanted crossings, and those of the submission."""
    first = outline.edges[0]
    one = 1 << first.shift
    yield Spot(Fraction(first.cx), Fraction(first.cy), "C" if first.r else "C (r = 0)"), Role.CASE
    for place, line in enumerate(outline.edges):
        named = place == 0 or len(outline.edges) <= _NAMED
        yield Spot(Fraction(line.ax), Fraction(line.ay), f"V[{place}]" if named else ""), Role.CASE
    for edge, (x, y) in shown.exact or ():
        at = digits(Surd.of(x.x) * one), digits(Surd.of(y.x) * one)
        yield Spot(*at, f"wanted on {edge}"), Role.WANTED
    for edge, x, y in _given(shown.given):
        yield Spot(x * one, y * one, f"got on {edge}"), Role.GOT


def _given(raw: Raw) -> Iterator[tuple[str, Fraction, Fraction]]:
    """What of a submission's answer, JSON of any shape whatever, is an edge and a point."""
    for item in raw[:_MOST] if type(raw) in (list, tuple) else ():
        pair = type(item) in (list, tuple) and len(item) == 2 and type(item[1]) in (list, tuple)
        if pair and len(item[1]) == 2:
            edge, x, y = _number(item[0]), _number(item[1][0]), _number(item[1][1])
            if x is not None and y is not None:
                yield ("?" if edge is None else short(edge)), x, y


def _number(raw: Raw) -> Fraction | None:
    read = number(raw)
    if isinstance(read, Fault):
        return None
    return read.exact() if isinstance(read, Written) else Fraction(read)


def _frame(edges: Sequence[CircleLine]) -> Frame:
    """A window around the circle and all corners."""
    first = edges[0]
    xs = [first.cx - first.r, first.cx + first.r, *(line.ax for line in edges)]
    ys = [first.cy - first.r, first.cy + first.r, *(line.ay for line in edges)]
    side = max(max(xs) - min(xs), max(ys) - min(ys)) or 2
    middle = Fraction(min(xs) + max(xs), 2), Fraction(min(ys) + max(ys), 2)
    return Frame(*middle, Fraction(side, 2) * _MARGIN)


def _panel(title: str, frame: Frame, outline: CircleOutline, spots: _Spots, *, beyond: bool) -> Panel:
    first = outline.edges[0]
    strokes = [*circle(frame, first)]
    for line in outline.edges:
        ends = frame.place(line.ax, line.ay), frame.place(line.ax + line.dx, line.ay + line.dy)
        strokes += [Stroke(part, Role.LINE, arrow=True) for part in polyline(ends)]
    e = Fraction(first.extent or 1)
    one = Fraction(1 << first.shift) if beyond else e
    bar = round_below(frame.unit / one * _BAR)
    text = short(bar) if beyond else f"{short(bar)} e"
    marks = _marks(frame, first, spots)
    return Panel(title, tuple(strokes), marks, (Bar(float(bar * one / frame.unit), text),))


def _marks(frame: Frame, first: CircleLine, spots: _Spots) -> tuple[Mark, ...]:
    found: list[Mark] = []
    for spot, role in spots:
        at = frame.place(spot.x, spot.y)
        if inside(at):
            found.append(Mark(at, role, spot.text))
        elif role is Role.GOT:
            dx, dy = spot.x - frame.x, spot.y - frame.y
            away = short(length(dx, dy) / (first.extent or 1))
            found.append(at_edge(direction(rounded(dx), rounded(dy)), role, f"{spot.text}, {away} e away"))
    return merged(found)


def _lens(outline: CircleOutline, whole: Frame, spots: _Spots) -> Panel | None:
    """The nearest approach of a corner or an edge to the circle that is too close to be seen."""
    close = [place for place in _approaches(outline) if 0 < place[0] <= _CLOSE * whole.unit]
    if not close:
        return None
    size, x, y, what = min(close)
    unit = size * _ROOM
    title = f"Lens: {what}, × {short(whole.unit / unit)}"
    return _panel(title, Frame(x, y, unit), outline, spots, beyond=False)


def _approaches(outline: CircleOutline) -> Iterator[tuple[Fraction, Fraction, Fraction, str]]:
    """How near each corner is to the circle, and each edge's line to touching it within the edge."""
    for place, line in enumerate(outline.edges):
        yield abs(rounded(_corner_gap(line))), Fraction(line.ax), Fraction(line.ay), f"V[{place}]"
        if line.a and 0 < -line.b < line.a:
            x, y = line.cx - Fraction(line.k * line.dy, line.a), line.cy + Fraction(line.k * line.dx, line.a)
            yield abs(rounded(_gap(line))), x, y, f"edge {place}"


def _corner_gap(line: CircleLine) -> Surd:
    return Surd(-line.r, 1, (line.ax - line.cx) ** 2 + (line.ay - line.cy) ** 2, 1)


def _gap(line: CircleLine) -> Surd:
    return Surd(-line.r * line.a, abs(line.k), line.a, line.a)


def _words(outline: CircleOutline, bands: Bands) -> str:
    """How many crossings there are, and at which corners."""
    crossings = outline.crossings(bands)
    at = [each.edge for each in crossings if bands.end(outline.edges[each.line], each.which) is not None]
    count = len(crossings)
    said = f"{count} crossing{'' if count == 1 else 's'}" if count else "no crossing"
    if at:
        said += f", {'one' if len(at) == 1 else len(at)} of them at {', '.join(f'V[{each}]' for each in at)}"
    return f"{said}; e = {short(outline.edges[0].extent_length(), 3)}"

"""A picture as SVG: valid XML whatever the words in it, readable in light and dark, always the same."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from html import escape
from itertools import pairwise
from math import atan2, cos, hypot, sin

from judge.drawing.labels import Rectangle, place_labels
from judge.drawing.shapes import Bar, Dot, Fact, Mark, Panel, Picture, Role, Stroke

_SIDE = 400.0
_GAP = 24.0
_TOP = 88.0  # title, and the panels' headings
_HEADING = 18.0
_ROW = 18.0
_MARK = 6.0
_LETTERS_PER_PIXEL = 1 / 7.4
_WIDEST = 380.0  # of a label: dozens of marks in one place would leave the panel
_MOST_ROWS = 8  # of one fact: all numbers of a case have room, an answer may be longer

_LIGHT = {
    ".card": "fill:#ffffff;stroke:#d4d4d8",
    ".panel": "fill:#fafafa;stroke:#d4d4d8",
    "text": "font:13px system-ui,'Segoe UI','DejaVu Sans',sans-serif;fill:#18181b",
    ".title": "font-size:16px;font-weight:600",
    ".head": "font-weight:600",
    ".quiet": "fill:#52525b",
    ".halo": "stroke:#fafafa;stroke-width:4;stroke-linejoin:round;paint-order:stroke",
    ".circle": "stroke:#1d4ed8;stroke-width:1.8;fill:none",
    ".circle-area": "fill:#1d4ed8;fill-opacity:.07",
    ".line": "stroke:#18181b;stroke-width:1.8;fill:none",
    ".beyond": "stroke:#a1a1aa;stroke-width:1.2;stroke-dasharray:5 4;fill:none",
    ".head-line": "fill:#18181b",
    ".case": "fill:#18181b",
    ".wanted": "stroke:#15803d;stroke-width:2.6;fill:none",
    ".got": "stroke:#c2410c;stroke-width:2.6;fill:none",
    ".t-wanted": "fill:#15803d",
    ".t-got": "fill:#c2410c",
    ".bar": "stroke:#52525b;stroke-width:1.6;fill:none",
    ".leader": "stroke:#a1a1aa;stroke-width:1;fill:none",
}
_DARK = {
    ".card": "fill:#18181b;stroke:#3f3f46",
    ".panel": "fill:#202024;stroke:#3f3f46",
    "text": "fill:#f4f4f5",
    ".quiet": "fill:#a1a1aa",
    ".halo": "stroke:#202024",
    ".circle": "stroke:#93c5fd",
    ".circle-area": "fill:#93c5fd;fill-opacity:.1",
    ".line": "stroke:#f4f4f5",
    ".beyond": "stroke:#71717a",
    ".head-line,.case": "fill:#f4f4f5",
    ".wanted": "stroke:#4ade80",
    ".got": "stroke:#fb923c",
    ".t-wanted": "fill:#4ade80",
    ".t-got": "fill:#fb923c",
    ".bar": "stroke:#a1a1aa",
    ".leader": "stroke:#71717a",
}


def style(scope: str = "", media: str = "(prefers-color-scheme:dark)") -> str:
    """The style sheet of the drawings, for what is inside `scope`; `media` says where it is dark."""
    light, dark = (
        "".join(f"{_scoped(names, scope)}{{{rules}}}\n" for names, rules in table.items())
        for table in (_LIGHT, _DARK)
    )
    return f"\n{light}@media {media}{{\n{dark}}}\n"


def _scoped(names: str, scope: str) -> str:
    return ",".join(f"{scope} {name}" if scope else name for name in names.split(","))


def to_svg(picture: Picture) -> str:
    """The whole document, with a newline at its end."""
    panels = picture.panels
    width = _GAP + len(panels) * (_SIDE + _GAP)
    below = _TOP + _SIDE + _HEADING + 26
    rows = [row for fact in picture.facts for row in _fact_rows(fact, width - 2 * _GAP - 70)]
    height = below + _ROW * (len(rows) + 1) + 12
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" role="img" aria-labelledby="title desc" '
        f'viewBox="0 0 {_n(width)} {_n(height)}" width="{_n(width)}" height="{_n(height)}">'
    )
    title = f"{picture.title} – {picture.heading}" if picture.heading else picture.title
    parts = [
        head,
        f'<title id="title">{words(title)}</title>',
        f'<desc id="desc">{words(picture.description)}</desc>',
        f"<style>{style()}</style>",
        f'<rect class="card" x="0.5" y="0.5" width="{_n(width - 1)}" height="{_n(height - 1)}" rx="8"/>',
        _text(_GAP, 32, _cut(picture.title, width - 2 * _GAP, 10.2), "title"),
        _text(_GAP, 51, _cut(picture.heading, width - 2 * _GAP), "quiet"),
    ]
    for place, panel in enumerate(panels):
        parts.extend(_panel(panel, _GAP + place * (_SIDE + _GAP), _TOP))
    parts.extend(_legend(picture, _GAP, below))
    for place, (label, text, kind) in enumerate(rows, 1):
        y = below + 6 + _ROW * place
        parts.append(_text(_GAP, y, label, "quiet"))
        parts.append(_text(_GAP + 70, y, text, kind))
    return "\n".join([*(part for part in parts if part), "</svg>"]) + "\n"


def panel_svg(panel: Panel, name: str, description: str, *, alone: bool = False) -> str:
    """One panel without its heading and its note, as an element of an HTML page or a file of its own.

    The page has `style(scope)` once; `name` begins the ids, so that several elements stand in one page.
    """
    size = f' width="{_n(_SIDE + 2)}" height="{_n(_SIDE + 2)}"' if alone else ""
    side, title, about = _n(_SIDE + 2), f"{name}-title", f"{name}-about"
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" role="img" aria-labelledby="{words(title)} {words(about)}" '
        f'viewBox="-1 -1 {side} {side}"{size}>'
    )
    parts = [
        head,
        f'<title id="{words(title)}">{words(panel.title)}</title>',
        f'<desc id="{words(about)}">{words(description)}</desc>',
        f"<style>{style()}</style>" if alone else "",
        *_drawing(panel),
    ]
    return "\n".join([*(part for part in parts if part), "</svg>"])


def words(text: str) -> str:
    """Text that is safe in XML: markup escaped, and whatever does not print written out."""
    return escape(_plain(text))


def _plain(text: str) -> str:
    return "".join(
        letter if letter.isprintable() else letter.encode("unicode_escape").decode("ascii") for letter in text
    )


# -- a panel -----------------------------------------------------------------------------------------------


def _panel(panel: Panel, left: float, top: float) -> Iterator[str]:
    """The panel in a group of its own, whose origin is its upper left corner."""
    yield f'<g transform="translate({_n(left)} {_n(top)})">'
    yield _text(0, -10, _cut(panel.title, _SIDE, 8.4), "head")
    yield from _drawing(panel)
    if panel.note:
        yield _text(0, _SIDE + _HEADING, _cut(panel.note, _SIDE), "quiet")
    yield "</g>"


def _drawing(panel: Panel) -> Iterator[str]:
    """The panel's square and all that is in it."""
    yield f'<rect class="panel" width="{_n(_SIDE)}" height="{_n(_SIDE)}"/>'
    for stroke in panel.strokes:
        yield _stroke(stroke)
    ink = _ink(panel)
    bars, taken = _bars(panel, ink)
    for stroke in panel.strokes:
        at = _arrow_place(stroke)
        if at:
            yield _head(*at, _ROLE_TEXT[stroke.role] or "head-line")
            taken.append(Rectangle(at[0], at[1], 8, 8))
    yield from bars
    spots = [_pixel(mark.at) for mark in panel.marks]
    taken += [Rectangle(x, y, _MARK + 2, _MARK + 2) for x, y in spots]
    for mark, (x, y) in zip(panel.marks, spots, strict=True):
        yield _mark(mark, x, y)
    labelled = [(mark, spot) for mark, spot in zip(panel.marks, spots, strict=True) if mark.text]
    texts = [(x, y, _cut(mark.text, _WIDEST)) for mark, (x, y) in labelled]
    for (mark, _), label in zip(labelled, place_labels(texts, _SIDE, taken, ink), strict=True):
        box = label.box
        if label.leader:
            yield _line(label.x, label.y, *_side_of(box, label.x, label.y), "leader")
        kind = "" if mark.shared else _ROLE_TEXT[mark.role]
        yield _text(box.x, box.y + 4.5, label.text, f"halo {kind}".strip(), middle=True)


_CLASSES = {role: role.value for role in Role} | {Role.SHAPE: "circle"}  # as published pictures have it
_KEY = 8.0  # pixels of a letter in the legend
_ROLE_TEXT = {Role.WANTED: "t-wanted", Role.GOT: "t-got"} | dict.fromkeys(
    (Role.CASE, Role.SHAPE, Role.LINE, Role.BEYOND), ""
)


def _pixel(dot: Dot) -> Dot:
    return (dot[0] + 1) * _SIDE / 2, (1 - dot[1]) * _SIDE / 2


def _stroke(stroke: Stroke) -> str:
    dots = " ".join(f"{_n(x)},{_n(y)}" for x, y in map(_pixel, stroke.dots))
    if stroke.filled:
        return f'<polygon class="{_CLASSES[stroke.role]}-area" points="{dots}"/>'
    return f'<polyline class="{_CLASSES[stroke.role]}" points="{dots}"/>'


def _arrow_place(stroke: Stroke) -> tuple[float, float, float] | None:
    """Where a stroke's direction is shown, and which way: at its end it would hide what is there."""
    (x1, y1), (x2, y2) = map(_pixel, stroke.dots[-2:])
    if not stroke.arrow or hypot(x2 - x1, y2 - y1) < 40:
        return None
    return x1 + (x2 - x1) * 0.62, y1 + (y2 - y1) * 0.62, atan2(y2 - y1, x2 - x1)


def _head(x: float, y: float, turn: float, kind: str) -> str:
    corners = [(7.0, 0.0), (-5.0, 5.0), (-5.0, -5.0)]
    dots = " ".join(
        f"{_n(x + a * cos(turn) - b * sin(turn))},{_n(y + a * sin(turn) + b * cos(turn))}" for a, b in corners
    )
    return f'<polygon class="{kind}" points="{dots}"/>'


def _mark(mark: Mark, x: float, y: float) -> str:
    """A dot for a point of the case, a ring for a wanted one, a cross for a given one; an arrow outwards."""
    if mark.towards:
        kind = {Role.WANTED: "t-wanted", Role.GOT: "t-got"}.get(mark.role, "case")
        return _head(x, y, atan2(-mark.towards[1], mark.towards[0]), kind)
    if mark.role is Role.WANTED:
        return f'<circle class="wanted" cx="{_n(x)}" cy="{_n(y)}" r="{_n(_MARK + 1)}"/>'
    if mark.role is Role.GOT:
        return _cross(x, y)
    return f'<circle class="case" cx="{_n(x)}" cy="{_n(y)}" r="3.2"/>'


def _cross(x: float, y: float) -> str:
    a, b, c, d = _n(x - _MARK + 1), _n(y - _MARK + 1), _n(x + _MARK - 1), _n(y + _MARK - 1)
    return f'<path class="got" d="M{a} {b}L{c} {d}M{a} {d}L{c} {b}"/>'


def _ink(panel: Panel) -> list[Dot]:
    """Dots every few pixels along all lines."""
    dots = []
    for stroke in panel.strokes:
        if stroke.filled:
            continue
        for (x1, y1), (x2, y2) in pairwise(map(_pixel, stroke.dots)):
            steps = max(1, int(hypot(x2 - x1, y2 - y1) / 5))
            dots += [(x1 + (x2 - x1) * i / steps, y1 + (y2 - y1) * i / steps) for i in range(steps)]
    return dots


def _side_of(box: Rectangle, x: float, y: float) -> Dot:
    """The point of a label's box that is next to its mark."""
    return min(max(x, box.x - box.w), box.x + box.w), min(max(y, box.y - box.h), box.y + box.h)


# -- scale bars, legend, facts -----------------------------------------------------------------------------


def _bars(panel: Panel, ink: Sequence[Dot]) -> tuple[list[str], list[Rectangle]]:
    """The scale bars in the left corner, below or above, that has less in it; and what room they take."""
    if not panel.bars:
        return [], []
    upright = [bar for bar in panel.bars if bar.upright]
    high = 40.0 + sum(bar.length * _SIDE / 2 + 4 for bar in upright)
    wide = max(max(bar.length * _SIDE / 2, 7.6 * len(bar.text)) + 16 for bar in panel.bars)
    corners = [Rectangle(wide / 2 + 4, base - high / 2, wide / 2 + 4, high / 2) for base in (_SIDE, high)]
    corner = min(corners, key=lambda box: sum(box.holds(*dot) for dot in ink))
    base = corner.y + corner.h
    return [part for bar in panel.bars for part in _bar(bar, base)], [corner]


def _bar(bar: Bar, base: float) -> Iterator[str]:
    size = bar.length * _SIDE / 2
    if bar.upright:
        low, high = base - 34, base - 34 - size
        yield f'<path class="bar" d="M8 {_n(low)}H16M12 {_n(low)}V{_n(high)}M8 {_n(high)}H16"/>'
        yield _text(22, (low + high) / 2 + 4.5, bar.text, "halo quiet")
        return
    y = base - 10
    top, bottom, end = _n(y - 4), _n(y + 4), _n(12 + size)
    yield f'<path class="bar" d="M12 {top}V{bottom}M12 {_n(y)}H{end}M{end} {top}V{bottom}"/>'
    yield _text(12, y - 8, bar.text, "halo quiet")


def _legend(picture: Picture, left: float, y: float) -> Iterator[str]:
    first, second = picture.keys
    drawn = {mark.role for panel in picture.panels for mark in panel.marks}
    drawn |= {stroke.role for panel in picture.panels for stroke in panel.strokes}
    if Role.WANTED in drawn:
        yield f'<circle class="wanted" cx="{_n(left + 7)}" cy="{_n(y - 5)}" r="{_n(_MARK + 1)}"/>'
        yield _text(left + 22, y, first, "t-wanted")
        left += 90 + _KEY * (len(first) - len("wanted"))
    if Role.GOT in drawn:
        yield _cross(left + 7, y - 5)
        yield _text(left + 20, y, second, "t-got")
        left += 70 + _KEY * (len(second) - len("got"))
    yield _text(left, y, picture.legend, "quiet")


def _fact_rows(fact: Fact, room: float) -> list[tuple[str, str, str]]:
    """A fact in as many rows as it takes, cut after a few."""
    letters = int(room * _LETTERS_PER_PIXEL)
    rows = _wrapped(_plain(fact.text), letters)
    if len(rows) > _MOST_ROWS:
        rows = [*rows[: _MOST_ROWS - 1], rows[_MOST_ROWS - 1][: letters - 1] + "…"]
    kind = _ROLE_TEXT[fact.role]
    return [(fact.label if not place else "", row, kind) for place, row in enumerate(rows)]


def _wrapped(text: str, letters: int) -> list[str]:
    rows = [""]
    for word in _pieces(text, letters):
        if rows[-1] and len(rows[-1]) + 1 + len(word) > letters:
            rows.append(word)
        else:
            rows[-1] = f"{rows[-1]} {word}" if rows[-1] else word
    return rows


def _pieces(text: str, letters: int) -> Sequence[str]:
    return [word[at : at + letters] for word in text.split() for at in range(0, len(word), letters)]


def _cut(text: str, room: float, letter: float = 1 / _LETTERS_PER_PIXEL) -> str:
    text, most = _plain(text), int(room / letter)
    return text if len(text) <= most else text[: most - 1] + "…"


def _text(x: float, y: float, text: str, kind: str, *, middle: bool = False) -> str:
    if not text:
        return ""
    anchor = ' text-anchor="middle"' if middle else ""
    name = f' class="{kind}"' if kind else ""
    return f'<text{name} x="{_n(x)}" y="{_n(y)}"{anchor}>{words(text)}</text>'


def _line(x1: float, y1: float, x2: float, y2: float, kind: str) -> str:
    return f'<path class="{kind}" d="M{_n(x1)} {_n(y1)}L{_n(x2)} {_n(y2)}"/>'


def _n(value: float) -> str:
    """A coordinate to a tenth of a pixel, without a sign on zero."""
    text = f"{value:.1f}".removesuffix(".0")
    return "0" if text == "-0" else text

"""A panel as SVG: valid XML whatever the words in it, readable in light and dark, always the same.

drawing.css has the colours, a rule a line: those of the light, an empty line, and what differs in the dark.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from html import escape
from itertools import pairwise
from math import atan2, cos, hypot, sin
from pathlib import Path

from judge.drawing.labels import Rectangle, place_labels
from judge.drawing.shapes import Bar, Dot, Panel, Role
from judge.errors import printable

_SHEET = Path(__file__).with_name("drawing.css")
_SIDE = 400.0
_MARK = 6.0
_LETTER = 7.4  # pixels
_WIDEST = 380.0  # of a label: dozens of marks in one place would leave the panel
_TEXT = {Role.WANTED: "t-wanted", Role.GOT: "t-got"}


def style(scope: str = "", media: str = "(prefers-color-scheme:dark)") -> str:
    """The style sheet of the drawings, for what is inside `scope`; `media` says where it is dark."""
    rules = _SHEET.read_text(encoding="utf-8").splitlines()
    if scope:
        rules = [re.sub(r"^|,(?=[^{]*{)", rf"\g<0>{scope} ", rule) if rule else "" for rule in rules]
    at = rules.index("")
    return "\n".join(["", *rules[:at], f"@media {media}{{", *rules[at + 1 :], "}", ""])


def panel_svg(panel: Panel, name: str, description: str, *, alone: bool = False) -> str:
    """One panel without its heading and its note, as an element of an HTML page or a file of its own.

    The page has `style(scope)` once; `name` begins the ids, so that several elements stand in one page.
    """
    side, title, about = _n(_SIDE + 2), words(f"{name}-title"), words(f"{name}-about")
    size = f' width="{side}" height="{side}"' if alone else ""
    parts = [
        f'<title id="{title}">{words(panel.title)}</title>',
        f'<desc id="{about}">{words(description)}</desc>',
        f"<style>{style()}</style>" if alone else "",
        *_drawing(panel),
    ]
    return element(f'aria-labelledby="{title} {about}" viewBox="-1 -1 {side} {side}"{size}', parts)


def element(attributes: str, parts: Iterable[str]) -> str:
    """An SVG element of these parts; those that are empty are left out."""
    head = f'<svg xmlns="http://www.w3.org/2000/svg" role="img" {attributes}>'
    return "\n".join([head, *filter(None, parts), "</svg>"])


def text(x: float | str, y: float | str, said: str, kind: str, anchor: str = "") -> str:
    """A text of that class; nothing where it says nothing."""
    if not said:
        return ""
    name = f' class="{kind}"' if kind else ""
    end = f' text-anchor="{anchor}"' if anchor else ""
    return f'<text{name} x="{_n(x)}" y="{_n(y)}"{end}>{words(said)}</text>'


def words(said: str) -> str:
    """Text that is safe in XML: markup escaped, and whatever does not print written out."""
    return escape(printable(said))


# -- a panel -----------------------------------------------------------------------------------------------


def _drawing(panel: Panel) -> Iterator[str]:
    """The panel's square and all that is in it, from its upper left corner."""
    yield f'<rect class="panel" width="{_n(_SIDE)}" height="{_n(_SIDE)}"/>'
    for stroke in panel.strokes:
        name = "circle" if stroke.role is Role.SHAPE else stroke.role.value
        shape, kind = ("polygon", f"{name}-area") if stroke.filled else ("polyline", name)
        yield f'<{shape} class="{kind}" points="{_points(map(_pixel, stroke.dots))}"/>'
    for word in panel.words:
        x, y = _pixel(word.at)
        said = _cut(word.text, word.room * _SIDE / 2 - _LETTER)
        yield text(x, y + 4.5, said, f"halo {_TEXT.get(word.role, '')}".strip(), "middle")
    ink = _ink(panel)
    bars, taken = _bars(panel, ink)
    for stroke in panel.strokes:
        (x1, y1), (x2, y2) = map(_pixel, stroke.dots[-2:])
        if stroke.arrow and hypot(x2 - x1, y2 - y1) >= 40:  # not at its end: it would hide what is there
            x, y = x1 + (x2 - x1) * 0.62, y1 + (y2 - y1) * 0.62
            yield _head(x, y, atan2(y2 - y1, x2 - x1), _TEXT.get(stroke.role, "head-line"))
            taken.append(Rectangle(x, y, 8, 8))
    yield from bars
    spots = [(mark, *_pixel(mark.at)) for mark in panel.marks]
    taken += [Rectangle(x, y, _MARK + 2, _MARK + 2) for _, x, y in spots]
    for mark, x, y in spots:
        if mark.towards:
            yield _head(x, y, atan2(-mark.towards[1], mark.towards[0]), _TEXT.get(mark.role, "case"))
        else:
            yield _mark(mark.role, x, y)
    labelled = [spot for spot in spots if spot[0].text]
    texts = [(x, y, _cut(mark.label)) for mark, x, y in labelled]
    for (mark, x, y), label in zip(labelled, place_labels(texts, _SIDE, taken, ink), strict=True):
        box = label.box
        if label.leader:  # to the point of the box that is next to the mark
            nx = min(max(x, box.x - box.w), box.x + box.w)
            ny = min(max(y, box.y - box.h), box.y + box.h)
            yield f'<path class="leader" d="M{_n(x)} {_n(y)}L{_n(nx)} {_n(ny)}"/>'
        kind = "halo" if mark.shared else f"halo {_TEXT.get(mark.role, '')}".strip()
        yield text(box.x, box.y + 4.5, label.text, kind, "middle")


def _pixel(dot: Dot) -> Dot:
    return (dot[0] + 1) * _SIDE / 2, (1 - dot[1]) * _SIDE / 2


def _points(dots: Iterable[Dot]) -> str:
    return " ".join(f"{_n(x)},{_n(y)}" for x, y in dots)


def _head(x: float, y: float, turn: float, kind: str) -> str:
    """The head of an arrow."""
    corners = [(7.0, 0.0), (-5.0, 5.0), (-5.0, -5.0)]
    dots = [(x + a * cos(turn) - b * sin(turn), y + a * sin(turn) + b * cos(turn)) for a, b in corners]
    return f'<polygon class="{kind}" points="{_points(dots)}"/>'


def _mark(role: Role, x: float, y: float) -> str:
    """A dot for a point of the case, a ring for a wanted one, a cross for a given one."""
    if role is Role.GOT:
        a, b, c, d = _n(x - _MARK + 1), _n(y - _MARK + 1), _n(x + _MARK - 1), _n(y + _MARK - 1)
        return f'<path class="got" d="M{a} {b}L{c} {d}M{a} {d}L{c} {b}"/>'
    kind, radius = ("wanted", _MARK + 1) if role is Role.WANTED else ("case", 3.2)
    return f'<circle class="{kind}" cx="{_n(x)}" cy="{_n(y)}" r="{_n(radius)}"/>'


def _ink(panel: Panel) -> list[Dot]:
    """Dots every few pixels along all lines."""
    dots = []
    for stroke in panel.strokes:
        for (x1, y1), (x2, y2) in pairwise(map(_pixel, () if stroke.filled else stroke.dots)):
            steps = max(1, int(hypot(x2 - x1, y2 - y1) / 5))
            dots += [(x1 + (x2 - x1) * i / steps, y1 + (y2 - y1) * i / steps) for i in range(steps)]
    return dots


# -- scale bars --------------------------------------------------------------------------------------------


def _bars(panel: Panel, ink: Sequence[Dot]) -> tuple[list[str], list[Rectangle]]:
    """The scale bars in the left corner, below or above, that has less in it; and what room they take."""
    if not panel.bars:
        return [], []
    high = 40.0 + sum(bar.length * _SIDE / 2 + 4 for bar in panel.bars if bar.upright)
    wide = max(max(bar.length * _SIDE / 2, 7.6 * len(bar.text)) + 16 for bar in panel.bars)
    corners = [Rectangle(wide / 2 + 4, base - high / 2, wide / 2 + 4, high / 2) for base in (_SIDE, high)]
    corner = min(corners, key=lambda box: sum(box.holds(*dot) for dot in ink))
    return [part for bar in panel.bars for part in _bar(bar, corner.y + corner.h)], [corner]


def _bar(bar: Bar, base: float) -> Iterator[str]:
    size = bar.length * _SIDE / 2
    if bar.upright:
        low, high = base - 34, base - 34 - size
        yield f'<path class="bar" d="M8 {_n(low)}H16M12 {_n(low)}V{_n(high)}M8 {_n(high)}H16"/>'
        yield text(22, (low + high) / 2 + 4.5, bar.text, "halo quiet")
        return
    y = base - 10
    top, bottom, end = _n(y - 4), _n(y + 4), _n(12 + size)
    yield f'<path class="bar" d="M12 {top}V{bottom}M12 {_n(y)}H{end}M{end} {top}V{bottom}"/>'
    yield text(12, y - 8, bar.text, "halo quiet")


def _cut(said: str, room: float = _WIDEST) -> str:
    said, most = printable(said), max(1, int(room / _LETTER))
    return said if len(said) <= most else said[: most - 1] + "…"


def _n(value: float | str) -> str:
    """A coordinate to a tenth of a pixel, without a sign on zero; one that is written stays."""
    if isinstance(value, str):
        return value
    found = f"{value:.1f}".removesuffix(".0")
    return "0" if found == "-0" else found

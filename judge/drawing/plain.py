"""Two pictures of what has no shape of its own: a table of values, and a graph with its nodes on a circle."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import cos, pi, sin
from typing import Any

from judge.drawing.shapes import Dot, Mark, Panel, Picture, Role, Stroke, Word

_EDGE = 0.98  # of a panel, that tables reach
_TILE = 0.92  # of a cell's sides, that its tile fills
_RING = 0.72  # the radius of a graph, whose names stand beside its nodes
_LONG = 3.0  # times as wide as high, that a cell may be


def table(
    rows: Sequence[Sequence[Any]], marks: Mapping[tuple[int, int], Role] = {}, title: str = ""
) -> Picture:
    """The values in cells, a row below the other; `marks` has the cells, (row, column), that have a role."""
    across = max(map(len, rows), default=1) or 1
    high = min(2 / max(len(rows), 1), 2 / across) * _EDGE
    wide = min(2 / across * _EDGE, _LONG * high)
    strokes, words = [], []
    for r, row in enumerate(rows):
        for c, value in enumerate(row):
            x, y = (c - across / 2 + 0.5) * wide, (len(rows) / 2 - r - 0.5) * high
            w, h, role = wide / 2 * _TILE, high / 2 * _TILE, marks.get((r, c))
            corners = ((x - w, y - h), (x + w, y - h), (x + w, y + h), (x - w, y + h), (x - w, y - h))
            strokes.append(Stroke(corners, Role.SHAPE, filled=True))
            strokes += [Stroke(corners, role)] if role else []
            words.append(Word((x, y), role or Role.CASE, str(value), wide))
    return _picture(title or "table", rows, Panel(title, tuple(strokes), (), (), words=tuple(words)))


def graph(
    names: Sequence[Any],
    edges: Sequence[tuple[Any, Any]],
    marks: Mapping[Any, Role] = {},
    title: str = "",
    *,
    arrows: bool = False,
) -> Picture:
    """The nodes on a circle in their order, the first at the top, and the edges between two of them.

    `marks` has the names, and the pairs of names of edges, that have a role.
    """
    turns = {name: pi / 2 - 2 * pi * at / len(names) for at, name in enumerate(names)}
    places: dict[Any, Dot] = {name: (_RING * cos(turn), _RING * sin(turn)) for name, turn in turns.items()}
    strokes = [
        Stroke((places[a], places[b]), marks.get((a, b), Role.LINE), arrow=arrows) for a, b in edges if a != b
    ]
    found = [Mark(places[name], Role.CASE, str(name), str(name)) for name in names]
    found += [Mark(places[name], marks[name], "") for name in names if name in marks]
    return _picture(title or "graph", edges, Panel(title, tuple(strokes), tuple(found), ()))


def _picture(title: str, said: Sequence[Any], panel: Panel) -> Picture:
    return Picture(f"{title}: {', '.join(map(str, said))}", panel, None, scaled=False)

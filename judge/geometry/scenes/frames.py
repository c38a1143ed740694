"""Scenes of a circle that moves beside a line: frames("in", "out", **PLAIN) draws (circles, O, D, h)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

from judge.data.draw import Draw
from judge.geometry.level import Case, Scene, Vocabulary, maker, near_gap, parsed
from judge.geometry.pose import Atom, Length, Point, Vector, posed, root_up

_PLACES = Vocabulary.of(
    "a place of a circle beside the line",
    "in less even more out low high centre broad dot dot-miss dot-origin dot-again",
)
_BROAD = 34  # bits by which a broad circle is larger than the others
_SHARES = 0.01, 0.02, 0.05, 0.1, 0.2, 0.25, 0.4
_PARTS = 64  # of a radius: a threshold with h = j/64 is exact
_FINE = 20  # bits by which a radius grows where a threshold is nearly met

Row = tuple[list[int], int]  # a centre and a radius


def frames(
    *words: str,
    first: Sequence[str] = ("in", "out"),
    count: tuple[int, int] = (8, 24),
    size: int = 30,
    exact: bool = False,
    grows: bool = False,
    again: bool = False,
    away: int = 3,
    least: int = 10,
    **how: Any,
) -> Scene:
    """Frames whose distance d from the line is where a word says; "~" puts it just off.

    in, out        clear of both thresholds
    even           exactly at r, which is no case unless it is just off
    less, more     between them, below r or above it
    low, high      exactly at r(1 − h), r(1 + h), where h is `exact`: a number of 64ths
    centre, broad  the line runs through the centre; r is 2**34 times that of the others
    dot, dot-miss  r is 0, and the centre is on the line or not
    dot-origin     r is 0, and the centre is the origin of the line; dot-again: that of the first frame

    Args:
        first: the words of the first frame.
        count: the least and the greatest number of frames.
        grows: whether each frame has a radius of its own.
        again: whether a few circles come again and again.
        away: how many radii a centre may be away along the line.
        least: of what is just off, see judge.geometry.level.scene.
        how: the pose.
    """
    parsed((*words, *first), _PLACES)

    def draw_case(draw: Draw) -> Case:
        h = draw.integer(1, _PARTS // 2 - 1) / _PARTS if exact else draw.choice(_SHARES)
        unit = _PARTS << (_FINE if any(word[-1] == "~" for word in (*words, *first)) else 0)
        radius = unit * draw.integer(size // 4 + 1, size)

        start = draw.integer(-3 * radius, 3 * radius)

        def row(plan: Sequence[str]) -> Row:
            r = unit * draw.integer(size // 4 + 1, size) if grows else radius
            word, x = draw.choice(plan), draw.integer(-away * r, away * r)
            x = {"dot-origin": start, "dot-again": rows[0][0][0] if rows else 0}.get(word, x)
            r <<= _BROAD if word == "broad" else 0
            d = _distance(draw, word, r, Fraction(h))
            if word[-1] == "~":
                d += near_gap(draw, max(r, root_up((x - start) ** 2 + d * d)), least) * draw.sign()
            return [x, d * draw.sign()], 0 if word.startswith("dot") else r

        rows: list[Row] = []
        rows.append(row(first))
        pool = [row(words) for _ in range(3)] if again else []
        more = draw.integer(*count) - 1
        rows += [draw.choice(pool) if again else row(words) for _ in range(more)]
        atoms: list[Atom] = [Point([start, 0]), Vector([draw.integer(1, 9) * draw.sign(), 0])]
        for centre, r in rows:
            atoms += [Point(centre), Length([r])]
        O, D, *rest = posed(draw, atoms, **how)
        circles = tuple((*centre, r) for centre, r in zip(rest[::2], rest[1::2], strict=True))
        return circles, O, D, h

    return draw_case


def _distance(draw: Draw, word: str, r: int, h: Fraction) -> int:
    """How far from the line a frame's centre is."""
    low, high = r * (1 - h), r * (1 + h)
    part = Fraction(draw.integer(1, 15), 16)
    places: dict[str, Callable[[], int | Fraction]] = {
        "in": lambda: low * part * Fraction(9, 10),
        "less": lambda: low + (r - low) * part,
        "even": lambda: r,
        "more": lambda: r + (high - r) * part,
        "out": lambda: high * (1 + 2 * part),
        "low": lambda: low,
        "high": lambda: high,
        "dot-miss": lambda: r * part,
    }
    return int(places.get(word.rstrip("~"), int)())


@maker
def anything(draw: Draw, reach: int, most: int) -> Case:
    """Any whole numbers up to `reach`, in at most so many frames."""

    def pair() -> tuple[int, int]:
        return draw.integer(-reach, reach), draw.integer(-reach, reach)

    circles = tuple((*pair(), draw.integer(0, reach)) for _ in range(draw.integer(1, most)))
    return circles, pair(), pair(), draw.integer(1, _PARTS // 2 - 1) / _PARTS

"""Scenes of two circles: pairs("outer", "inner~", **BIG) draws (cx1, cy1, r1, cx2, cy2, r2)."""

from __future__ import annotations

from collections.abc import Sequence

from judge.data.draw import Draw
from judge.geometry.level import Nudge, checked, scene
from judge.geometry.pose import Atom, Length, Point

_PAIRS = (
    *("outer", "inner", "cross", "apart", "within", "close", "alike", "equal", "same", "ring"),
    *("dots", "dot-on", "dot-off", "dot-centre"),
)


def _level_pair(
    draw: Draw, words: Sequence[str], size: int = 30, uneven: int = 0
) -> tuple[list[Atom], list[Nudge]]:
    """Two circles with their centres on the x axis; one is `uneven` powers of two larger."""
    word, near = words[0].rstrip("~"), words[0][-1] == "~"
    a = draw.integer(size // 4 + 1, size) << uneven
    b = draw.integer(size // 4 + 1, size)
    if draw.boolean():
        a, b = b, a
    if word == "close":  # they touch, and their centres are 100 to 900 times nearer than their radii
        a = max(a, 1000 * b)
        b = a - a // draw.integer(100, 900)
        a, b = (a, b) if draw.boolean() else (b, a)
    if word in ("alike", "equal"):  # alike: the radii differ by 2**-10 to 2**-23
        b = a if word == "equal" else a - max(1, a >> draw.integer(10, 23)) * draw.sign()
    small, large = sorted((a, b))
    if word in ("inner", "within", "cross", "ring") and (large - small) * 50 < large:
        draw.reject()  # else the centres are almost one
    between = {
        "outer": lambda: a + b,
        "inner": lambda: large - small,
        "close": lambda: large - small,
        "alike": lambda: draw.integer(large // 2, 4 * large),
        "equal": lambda: draw.integer(large // 2, 4 * large),
        "cross": lambda: draw.integer(large - small + 1, a + b - 1),
        "apart": lambda: a + b + draw.integer(1, max(1, a + b)),
        "within": lambda: draw.integer(large // 100 + 1, max(large // 100 + 1, large - small - 1)),
        "dot-on": lambda: a,
        "dot-off": lambda: draw.choice((a // 2 + 1, 2 * a)),
    }
    d = between[word]() if word in between else 0
    if word == "same":
        b = a
    if word == "dots":
        a, b, d = 0, 0, draw.choice((0, a))
    if word.startswith("dot-"):
        a, b = (0, a) if draw.boolean() else (a, 0)
    nudges = [Nudge(3 if word == "same" else 2, 0)] if near else []
    return [Point([0, 0]), Length([a]), Point([d, 0]), Length([b])], nudges


def _check(words: list[str]) -> None:
    for word in words:
        checked(word, _PAIRS, "a way for two circles to lie")


pairs = scene(_level_pair, lambda C1, r1, C2, r2: (*C1, r1, *C2, r2), _check)

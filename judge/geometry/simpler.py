"""Simpler cases like a failing one: about the origin, laid level, with fewer digits or corners.

Nothing here need be right: a candidate counts only if it is valid and the submission fails on it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from decimal import Context, Decimal, localcontext
from itertools import permutations
from typing import Any

from judge.problem.model import Case
from judge.values.atoms import Number

_DIGITS = 60  # of the roots taken here: whatever a double holds, and the narrowest gaps
_FINEST = 16  # digits that are kept at most
_ZERO = Decimal(0)

Pair = tuple[Decimal, Decimal]

# Of each kind the letters of its arguments, and the points or vectors that may become the x axis: a pair of
# points "01" by their places, a vector "v". P is a point, V a vector, c the two numbers of a point, r a
# length, + a list of what comes next, . anything else. The first point of each becomes the origin.
_LINE, _RAY = ("crPP", ("12",)), ("crPV", ("v",))
_SHAPES: dict[str, tuple[str, tuple[str, ...]]] = {
    **dict.fromkeys(("line", "points", "segment", "count in a segment", "chord"), _LINE),
    **dict.fromkeys(("ray", "normal", "reflection"), _RAY),
    "seven": ("crcc", ("12",)),
    "point": ("crP", ("01",)),
    "tangents": ("crP", ("01",)),
    "diameter": ("PPP", ("01",)),
    "side": ("PPP", ("01",)),
    "foot": ("PPP", ("01",)),
    "pair": ("crcr", ("01",)),
    "common tangents": ("crcr", ("01",)),
    "hits": ("+crPV", ("v",)),
    "spans": ("+crPV.", ("v",)),
    "light": ("+crPVP", ("v",)),
    "frames": ("+crPV.", ("v",)),
    "polygon": ("cr+P", ("12",)),
    "balls": ("PPrPPr", ("01", "23")),
    "wall": ("PPrPP", ("23", "01")),
}
_ORIGINS = {
    "hits": -1,
    "spans": -1,
    "frames": -1,
    "light": -2,
    "balls": 2,
    "wall": 2,
}  # of the points, if not 0


def simpler(kind: str, case: Case) -> Iterator[Case]:
    """Cases that are simpler as a whole."""
    if kind == "sphere":
        yield from _spheres(case)
        return
    if kind not in _SHAPES:
        return
    yield from _fewer(kind, case)
    letters, axes = _SHAPES[kind]
    floats = any(isinstance(each, float) for each in _numbers(case))
    with localcontext(Context(prec=_DIGITS)):
        for axis in (*axes, None):
            laid = _laid(letters, case, _ORIGINS.get(kind, 0), axis)
            if laid is None:
                continue
            variants = [laid]
            if kind == "frames":
                variants.insert(0, _above(laid))
            if kind == "balls":
                variants.insert(0, _one_moves(laid))
            if letters in ("crPP", "crPV", "crcc") and axis:
                variants.append(_across_the_centre(laid))
            for variant in variants:
                yield from _rounded(variant, floats)


def _numbers(value: Any) -> Iterator[Any]:
    if isinstance(value, tuple):
        for each in value:
            yield from _numbers(each)
    else:
        yield value


def _fewer(kind: str, case: Case) -> Iterator[Case]:
    """Half of the corners, and each left out."""
    if kind == "polygon" and len(case[3]) > 3:
        cx, cy, r, V = case
        half = len(V) // 2
        kept = [V[:half], V[half:], V[::2], *(V[:at] + V[at + 1 :] for at in range(len(V)))]
        yield from ((cx, cy, r, each) for each in kept if len(each) >= 3)


# -- a case laid out ---------------------------------------------------------------------------------------


class _Laid:
    """A case with its points and vectors seen from the origin, along the axis and to its left."""

    def __init__(self, points: list[Pair], vectors: list[Pair], lengths: list[Decimal], build: Any) -> None:
        self.points, self.vectors, self.lengths, self.build = points, vectors, lengths, build

    def moved(self, points: list[Pair], lengths: list[Decimal] | None = None) -> _Laid:
        """The same with other points, and perhaps other lengths."""
        return _Laid(points, self.vectors, self.lengths if lengths is None else lengths, self.build)


def _laid(letters: str, case: Case, origin: int, axis: str | None) -> _Laid | None:
    """The case about the origin, with that axis level; None where the axis has no length."""
    points: list[Pair] = []
    vectors: list[Pair] = []
    lengths: list[Decimal] = []
    build = _reader(letters, case, points, vectors, lengths)
    ox, oy = points[origin]
    u, v = Decimal(1), _ZERO
    if axis == "v":
        u, v = vectors[0]
    elif axis:
        (ax, ay), (bx, by) = points[int(axis[0])], points[int(axis[1])]
        u, v = bx - ax, by - ay
    size = (u * u + v * v).sqrt()
    if not size:
        return None
    seen = [(x - ox, y - oy) for x, y in points]
    turned = [[((x * u + y * v) / size, (u * y - v * x) / size) for x, y in each] for each in (seen, vectors)]
    return _Laid(turned[0], turned[1], lengths, build)


def _reader(
    letters: str, case: Case, points: list[Pair], vectors: list[Pair], lengths: list[Decimal]
) -> Callable[..., Case]:
    """Read a case into those lists; what comes back builds a case from others in their order."""
    plan: list[tuple[str, int, Any]] = []  # letters of an argument, how many in a list or -1, and the rest
    values, at = list(case), 0

    def read(letter: str, value: Any) -> None:
        if letter == "r":
            lengths.append(Decimal(value))
        elif letter in "PVc":
            (vectors if letter == "V" else points).append((Decimal(value[0]), Decimal(value[1])))

    letters = letters.replace("+cr", "C").replace("+P", "L")
    for letter in letters:
        value = values[at] if letter != "c" else values[at : at + 2]
        at += 2 if letter == "c" else 1
        plan.append((letter, len(value) if letter in "CL" else -1, value))
        if letter == "C":
            for x, y, r in value:
                read("P", (x, y))
                read("r", r)
        elif letter == "L":
            for each in value:
                read("P", each)
        else:
            read(letter, value)

    def build(places: Sequence[Any], ways: Sequence[Any], sizes: Sequence[Any]) -> Case:
        p, w, s = iter(places), iter(ways), iter(sizes)
        made: list[Any] = []
        for letter, many, value in plan:
            if letter == "C":
                made.append(tuple((*next(p), next(s)) for _ in range(many)))
            elif letter == "L":
                made.append(tuple(next(p) for _ in range(many)))
            elif letter == "c":
                made.extend(next(p))
            else:
                made.append({"P": p, "V": w, "r": s}[letter].__next__() if letter in "PVr" else value)
        return tuple(made)

    return build


def _above(laid: _Laid) -> _Laid:
    """Circles straight above the line: their distances are all that counts."""
    return laid.moved([(_ZERO, abs(y)) for _, y in laid.points])


def _one_moves(laid: _Laid) -> _Laid:
    """One disc of both radii moves, and the other is a point that rests."""
    p0, p1, q0, q1 = laid.points
    end = p1[0] - q1[0] + q0[0], p1[1] - q1[1] + q0[1]
    return laid.moved([p0, end, q0, q0], [sum(laid.lengths, _ZERO), _ZERO])


def _across_the_centre(laid: _Laid) -> _Laid:
    """The line through the centre, its ends as far from the nearest root as they were."""
    r, (_, height) = laid.lengths[0], laid.points[1]
    square = r * r - height * height
    half = square.sqrt() if square > 0 else _ZERO
    return laid.moved(
        [laid.points[0], *((x - half + r if x > 0 else x + half - r, _ZERO) for x, _ in laid.points[1:])]
    )


# -- fewer digits ------------------------------------------------------------------------------------------


def _rounded(laid: _Laid, floats: bool) -> Iterator[Case]:
    """Cases of few digits like this one: of each number, of all alike, and in integers."""
    everything = [*laid.points, *laid.vectors]
    size = max((abs(x) for pair in everything for x in pair), default=_ZERO)
    size = max([size, *laid.lengths])
    if not size:
        return
    flipped = laid.moved([(x, -y) for x, y in laid.points])
    for kept in range(1, _FINEST + 1):
        for each in (laid, flipped):
            yield _built(each, lambda value, _: _few(value, kept), floats)  # noqa: B023
        for coarse in {1, kept}:
            fine, rough = (_power(size.adjusted() + 1 - digits) for digits in (kept, coarse))
            yield _built(laid, lambda value, along: value.quantize(rough if along else fine), floats)  # noqa: B023
        if laid.lengths and laid.lengths[0] and size / laid.lengths[0] < 10**9:
            scale = _power(kept) / laid.lengths[0]
            yield _built(laid, lambda value, _: _whole(value, scale), False)  # noqa: B023
            yield _built(
                laid,
                lambda value, along: _few(_whole(value, scale), 1) if along else _whole(value, scale),  # noqa: B023
                False,
            )


def _whole(value: Decimal, scale: Decimal) -> Decimal:
    return (value * scale).quantize(Decimal(1))


def _built(laid: _Laid, round_: Callable[[Decimal, bool], Decimal], floats: bool) -> Case:
    """The case with each number rounded; those along the axis are told apart."""

    def plain(value: Decimal, *, along: bool = False) -> Number:
        value = round_(value, along)
        return float(value) if floats and value else int(value.to_integral_value())

    places, ways = (
        [(plain(x, along=True), plain(y)) for x, y in each] for each in (laid.points, laid.vectors)
    )
    case: Case = laid.build(places, ways, [plain(each) for each in laid.lengths])
    return case


def _few(value: Decimal, digits: int) -> Decimal:
    return value.quantize(_power(value.adjusted() + 1 - digits)) if value else value


def _power(exponent: int) -> Decimal:
    """10^exponent, of a single digit: what `quantize` needs, and `**` does not give."""
    return Decimal((0, (1,), exponent))


# -- space -------------------------------------------------------------------------------------------------


def _spheres(case: Case) -> Iterator[Case]:
    """About the origin, in fewer axes, the axes in another order, with signs for a direction."""
    centre, r, origin, direction = case
    signs = tuple((x > 0) - (x < 0) for x in direction)
    floats = any(isinstance(each, float) for each in _numbers(case))
    near = tuple(x - y for x, y in zip(origin, centre, strict=True))
    yield from (((0, 0, 0), r, near, direction), ((0, 0, 0), r, near, signs), (centre, r, origin, signs))
    for axis in range(3):
        yield tuple(_without(each, axis) if isinstance(each, tuple) else each for each in case)
    for order in permutations(range(3)):
        yield tuple(tuple(each[at] for at in order) if isinstance(each, tuple) else each for each in case)
    with localcontext(Context(prec=_DIGITS)):
        for kept in (1, 2, 3, 6):
            yield tuple(
                tuple(_short(x, kept, floats) for x in each)
                if isinstance(each, tuple)
                else _short(each, kept, floats)
                for each in case
            )


def _without(point: tuple[Number, ...], axis: int) -> tuple[Number, ...]:
    return (*point[:axis], 0, *point[axis + 1 :])


def _short(value: Number, digits: int, floats: bool) -> Number:
    short = _few(Decimal(value), digits)
    return (
        float(short)
        if floats and short
        else int(short)
        if short == short.to_integral_value()
        else float(short)
    )

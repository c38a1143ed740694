"""Level figures made of words, put just off where a word says so, and posed; and draws of plain numbers.

In a level figure the line is parallel to the x axis and all that is exact is whole. A word is a height of a
line over a circle (`touch`), a place on it (`before`), or what a scene adds; "~" after a word puts the figure
just off it: by 1 to 1.2, 1 to 2 or 3 to 8 times 1e-7 of its size.
"""

from __future__ import annotations

import difflib
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from fractions import Fraction
from math import ceil, isqrt
from typing import Any, Concatenate, NamedTuple, ParamSpec

from judge.data.draw import Draw, Rejected
from judge.errors import ProblemError
from judge.geometry.pose import Atom, Length, Point, Vector, posed, root_up, triple

Case = tuple[Any, ...]
Scene = Callable[[Draw], Case]
P = ParamSpec("P")

_FINE = 30  # bits of the size where a figure is nudged: 1e-7 of it is 53 units and more
_LEVEL = ("size", "uneven")  # keys of a pose that are the level figure's


class Vocabulary(NamedTuple):
    """The words that a scene knows at one place, and what they are: "a height of a line"."""

    what: str
    known: Sequence[str]
    numbered: bool = False  # whether digits may follow

    @classmethod
    def of(cls, what: str, known: str, *, numbered: bool = False) -> Vocabulary:
        """The words of a text."""
        return cls(what, known.split(), numbered)

    def check(self, word: str) -> None:
        """Refuse a word that is none; "~", "-" and "?" around it do not count. Raises ProblemError."""
        bare = word.rstrip("~").lstrip("-?")
        bare = bare.rstrip("0123456789") if self.numbered else bare
        if bare not in self.known:
            near = difflib.get_close_matches(bare, self.known, 1)
            remedy = f"did you mean {near[0]!r}?" if near else "use one of these"
            raise ProblemError(f"{bare!r} is not {self.what}: {', '.join(self.known)}", remedy=remedy)


HEIGHT = Vocabulary.of("a height of a line", "cut chord through off-centre flat touch miss dot dot-miss")
PLACE = Vocabulary.of(
    "a place on a line", "before in after first last foot close near nearer by far very-far farther remote ="
)


class Nudge(NamedTuple):
    """This coordinate is put just off: `times` the gap, to one side, or to either where `side` is 0."""

    atom: Atom
    coordinate: int
    side: int = 0
    times: Fraction | int = 1


Level = tuple[list[Atom], list[Nudge]]


def maker(drawn: Callable[Concatenate[Draw, P], Case]) -> Callable[P, Scene]:
    """A maker of scenes from a function of a draw and what the scene is given."""

    def make(*given: P.args, **named: P.kwargs) -> Scene:
        return lambda draw: drawn(draw, *given, **named)

    make.__doc__ = drawn.__doc__
    return make


def parsed(plans: Iterable[str], *known: Vocabulary) -> list[list[str]]:
    """The words of each plan; what its last words may be is the last of `known`. Raises ProblemError."""
    split = [plan.split() for plan in plans]
    for words in split:
        for at, word in enumerate(words):
            known[min(at, len(known) - 1)].check(word)
    return split


def levelled(
    level: Callable[..., Level], shape: Callable[..., Case], *known: Vocabulary
) -> Callable[..., Scene]:
    """A maker of scenes from a level figure: plans, of which a case takes one, and how it is posed.

    `level` makes the figure of a draw and the words of a plan, `shape` puts the posed atoms in the order of
    the call. With `least=7` what is just off is so by 0.7e-7 of its size, too, where that is clear after the
    turn.
    """

    def make(*plans: str, **how: Any) -> Scene:
        kept = {key: how.pop(key) for key in _LEVEL if key in how}
        least, split = how.pop("least", 10), parsed(plans, *known)

        def draw_case(draw: Draw) -> Case:
            atoms, nudges = level(draw, draw.choice(split), **kept)
            if nudges:
                _nudge(draw, atoms, nudges, least)
            return shape(*posed(draw, atoms, **how))

        return draw_case

    return make


@maker
def either(draw: Draw, *scenes: Scene) -> Case:
    """One of several scenes."""
    return draw.choice(scenes)(draw)


@maker
def tried(draw: Draw, drawn: Scene, fits: Callable[[Case], bool] = bool, tries: int = 40) -> Case:
    """The first of so many draws that is a case and fits."""
    for _ in range(tries):
        with suppress(Rejected):
            case = drawn(draw)
            if fits(case):
                return case
    return draw.reject()


def held(draw: Draw, case: Case) -> Case:
    """The case, unless one of its numbers is larger than 2**30, or nearer to 0 than 1e-30."""
    numbers = [x for each in case for x in (each if isinstance(each, tuple) else (each,))]
    if any(abs(x) > 1 << 30 or 0 < abs(x) < 1e-30 for x in numbers):
        draw.reject()
    return case


def telling(drawn: Scene, plain: Callable[..., Any], tolerant: Callable[..., Any]) -> Scene:
    """Only cases on which a plain program's answer has another form than a tolerant one's."""
    return tried(drawn, lambda case: plain(*case) != tolerant(*case))


# -- a line over a circle -----------------------------------------------------------------------------


def height(draw: Draw, word: str, size: int) -> tuple[int, int, int | None]:
    """(R, h, half): the radius, the line's height, and half the chord where that is whole.

    A chord is never so flat that it nearly touches.
    """
    R = draw.integer(max(2, size // 2), size)
    if word == "dot":
        return 0, 0, 0
    if word == "dot-miss":
        return 0, R * draw.sign(), None
    if word == "through":
        return R, 0, R
    if word == "chord":
        p, q, c = triple(draw, max(5, min(size, 4_418)))
        k = draw.integer(max(1, size // c // 2), max(1, size // c))
        if q * 20 < c:
            draw.reject()
        return c * k, p * k * draw.sign(), q * k
    if word == "off-centre":  # by 2**-2 to 2**-40 of the radius; mostly so that half the chord is hardly R
        hardly = R * draw.integer(45, 160) // 10**6
        off = draw.choice((R >> draw.integer(2, 40), hardly, hardly, R * draw.integer(9, 30) // 1000))
        return R, max(1, off) * draw.sign(), None
    if word == "cut":
        return R, draw.integer(1 - R, R - 1), None
    if word == "flat":  # the chord bends by 2e-6 to 2e-4 of the radius
        return R, (R - R * draw.integer(2, draw.choice((20, 200))) // 10**6) * draw.sign(), None
    if word == "touch":
        return R, R * draw.sign(), 0
    return R, (R + draw.integer(1, 2 * R)) * draw.sign(), None  # miss


def place(draw: Draw, word: str, R: int, h: int, half: int | None, size: int) -> int:
    """x of a place on the line, seen from the circle's foot; the ray or segment runs to greater x."""
    turned = {"-": -1, "?": draw.sign() if word[0] == "?" else 1}.get(word[0], 1)
    name, r = word.rstrip("~").lstrip("-?"), R or size
    inner, outer = isqrt(max(0, R * R - h * h - 1)) if abs(h) < R else 0, root_up(max(0, R * R - h * h))
    if name in ("before", "after"):
        x = outer + 1 + draw.integer(0, 2 * r)
        x = -x if name == "before" else x
    elif name == "in":
        if inner < 1:
            draw.reject()
        x = draw.integer(1 - inner, inner - 1)
    elif name in ("first", "last"):
        if half is None:
            draw.reject()
        x = -half if name == "first" else half
    elif name == "near":
        x = (r * draw.integer(1, 20) // 2_000 + 1) * draw.sign()
    elif name == "nearer":  # on a touch, hardly more than the least way that is clear of the circle
        x = r * draw.integer(450, 500) // 10**6 * draw.sign()
    elif name == "close":  # by 2**-11 to 2**-40 of the radius
        x = max(1, r >> draw.integer(11, 40)) * draw.sign()
    elif name == "by":
        x = outer + draw.integer(1, 3 * r)
    elif name == "far":
        x = -r * draw.integer(100, 20_000)
    elif name == "very-far":
        x = -r * draw.integer(10**5, 10**6)
    elif name == "farther":  # so far that only a line through the centre is clear, or a touch
        x = -r * draw.integer(10**6, 10**7 - 1)
    elif name == "remote":  # so far that only a touch is clear
        x = -r * draw.integer(10**7, 10**8)
    else:  # foot
        x = 0
    return turned * x


def over_circle(
    draw: Draw, words: Sequence[str], size: int = 30, dimension: int = 2, uneven: int = 0
) -> tuple[int, list[Point], list[Nudge]]:
    """The radius, the points at the places of `words`, whose first is the height, and the nudges."""
    R, h, half = height(draw, words[0].rstrip("~"), size)
    R, h, half = R << uneven, h << uneven, half if half is None else half << uneven
    xs: list[int] = []
    for word in words[1:]:
        xs.append(xs[-1] if word[0] == "=" else place(draw, word, R, h, half, size << uneven))
    if uneven and len(xs) > 1:  # split: only the way from the first point has more bits than a double
        most = size >> draw.choice((0, 24))
        xs[1] = xs[0] + (1 if xs[1] > xs[0] else -1) * draw.integer(most // 2, most)
    points = [Point([x, h, *[0] * (dimension - 2)]) for x in xs]
    side, off = draw.sign(), draw.sign()
    nudges = [Nudge(point, 1, side) for point in points] if words[0][-1] == "~" else []
    for word, end in zip(words[1:], points, strict=True):
        if word[-1] == "~":
            # Across the circle a step along the line counts half/R of itself, and none at a touch.
            times = Fraction(R, half) if half else 1
            moved = [point for point in points if point[0] == end[0]] if "=" in words else [end]
            nudges += [Nudge(point, 0, off, times) for point in moved]
    return R, points, nudges


def _nudge(draw: Draw, atoms: list[Atom], nudges: Sequence[Nudge], least: int) -> None:
    """Scale the figure up until 1e-7 of its size is several units, and put it just off."""
    points = [each for each in atoms if isinstance(each, Point)]
    reach = [abs(n) for each in atoms if isinstance(each, Length) for n in each]
    reach += [root_up(_way(each, points[0])) for each in points]  # no turn makes it larger
    fine = 1 << max(0, _FINE - max(reach).bit_length())
    for each in atoms:
        if not isinstance(each, Vector):
            each[:] = [n * fine for n in each]
    gap = near_gap(draw, max(reach) * fine, least)
    for nudge in nudges:
        side = nudge.side or draw.sign()
        nudge.atom[nudge.coordinate] += side * ceil(nudge.times * gap)


def _way(end: Point, start: Point) -> int:
    return sum([(m - n) ** 2 for m, n in zip(end, start, strict=True)])


def near_gap(draw: Draw, size: int, lowest: int = 10) -> int:
    """1 to 1.2, 1 to 2 or 3 to 8 times 1e-7 of the size, rounded up: nearly a touch, and clear of it.

    With a `lowest` of 7 also 0.7 times that, which is clear where a turn makes the size as much smaller.
    """
    finer = [(lowest, 9)] * 4 if lowest < 10 else []  # most of which are not clear
    least, most = draw.choice([(10, 12), (10, 20), (30, 80), *finer])
    return draw.integer(least * size, most * size) // 10**8 + 1


# -- plain numbers ------------------------------------------------------------------------------------


@maker
def grid(draw: Draw, shape: str, reach: int) -> Case:
    """Whole numbers up to `reach`: n a number, r a radius, p a point, P a point in space, d a direction.

    So small that everything special comes up by itself; now and then a number is that of another argument, or
    a point is the origin.
    """
    return _shaped(draw, shape, lambda: draw.integer(-reach, reach), again=True)


@maker
def whole(draw: Draw, shape: str, bits: int) -> Case:
    """Ints up to 2**bits."""
    return _shaped(draw, shape, lambda: draw.integer(-(1 << bits), 1 << bits))


@maker
def corners(draw: Draw, shape: str, bits: int) -> Case:
    """Ints at ±2**bits, a few of them 0 or off by 1: a difference has a bit more, a sum of squares three."""

    def number() -> int:
        return ((1 << bits) - (draw.integer(0, 7) == 7)) * draw.sign() if draw.integer(0, 5) else 0

    return _shaped(draw, shape, number)


@maker
def uniform(draw: Draw, shape: str, *reaches: float) -> Case:
    """Doubles and ints up to one of `reaches`."""
    reach = draw.choice(reaches)

    def number() -> int | float:
        if draw.integer(0, 3) == 0:
            return draw.integer(-int(reach), int(reach))
        return draw.integer(-(2**40), 2**40) / 2**40 * reach

    return _shaped(draw, shape, number)


@maker
def uneven(draw: Draw, shape: str) -> Case:
    """Numbers that are up to three times a length, or up to three times 2e-9 to 1e-6 of it."""
    far = draw.integer(2**19, 2**20) * 2.0 ** draw.choice((8, 8, -20, -60))
    near = far * draw.integer(20, 99) / 10 ** draw.choice((8, 8, 8, 9, 10))
    return _shaped(draw, shape, lambda: draw.integer(-3, 3) * draw.choice((far, near)))


def _shaped(draw: Draw, shape: str, number: Callable[[], Any], *, again: bool = False) -> Case:
    sizes = {"n": 1, "r": 1, "p": 2, "d": 2, "P": 3, "D": 3}
    kind = draw.choice(("int", "float", "mixed")) if again else ""
    case: list[Any] = []
    for letter in shape:
        numbers = [number() for _ in range(sizes[letter])]
        if again and draw.integer(0, 11) == 0:
            numbers = [0] * len(numbers)
        earlier = [each for each in case if isinstance(each, tuple) and len(each) == len(numbers)]
        if again and earlier and letter in "pP" and draw.integer(0, 11) == 0:
            case.append(draw.choice(earlier))
            continue
        if kind:
            numbers = [_typed(draw, kind, each) for each in numbers]
        if letter == "r":
            numbers = [abs(numbers[0])]
        case.append(numbers[0] if letter in "nr" else tuple(numbers))
    return tuple(case)


def _typed(draw: Draw, kind: str, number: int) -> int | float:
    return float(number) if kind == "float" or (kind == "mixed" and draw.boolean()) else number

"""Many circles along a ray in a picture: tagged hits, spans beside the ray, a light and its shadow."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any

from judge.drawing.frame import ExactNumber
from judge.exact import Surd
from judge.problem.topic import Shown
from judge.topics.circles.bands import Bands
from judge.topics.circles.crowd import Crowd
from judge.topics.circles.line import CircleLine
from judge.topics.circles.part import Part
from judge.topics.circles.picture.given import read_number
from judge.topics.circles.picture.scene import Scene, Way
from judge.topics.circles.picture.spots import Spot
from judge.values.decode import items, word

_MOST = 12  # hits, spans and circles that are labelled
_DIGITS = 30  # of a number that a point is drawn from
_SIDE = 0.03  # of a panel: how far beside the ray a span is drawn
_TAGS = {-1: "enter", 0: "touch", 1: "exit"}

ExactPlace = tuple[ExactNumber, ExactNumber]


def crowd_scene(part: Part, shown: Shown) -> Scene | None:
    """The scene of such a case, about the circle that the ray is nearest to touching; None of any other."""
    values = list(shown.values.values())
    if len(values) < 3 or not any(values[2]):
        return None
    light = tuple(values[3]) if part is Part.SHADOW else None
    circles = [tuple(each) for each in values[0]]
    crowd = Crowd.of(circles, tuple(values[1]), tuple(values[2]), *([light] if light else []))
    line = min(crowd.lines, key=_closeness)
    others = tuple(each for each in crowd.lines if each is not line)
    bands = Bands.of({"snap": Fraction(0), **shown.problem.bands})
    scene = Scene(Part.RAY, line, (), (), bands.snap, others=others, names=_names(crowd))
    if part is Part.HITS:
        return _with_hits(scene, crowd, shown)
    if part is Part.SPANS:
        return _with_spans(scene, crowd, shown)
    assert light is not None
    return _with_light(scene, crowd, bands, light, shown)


def _closeness(line: CircleLine) -> Fraction:
    """|d − r|, nearly."""
    return abs(Fraction(Surd(-line.r * line.a, abs(line.k), line.a, line.a).decimal(_DIGITS)))


def _names(crowd: Crowd) -> tuple[Spot, ...]:
    """The circles' numbers at their centres; those of one centre together."""
    found: dict[tuple[int, int], list[str]] = {}
    for index, line in enumerate(crowd.lines[:_MOST]):
        found.setdefault((line.cx, line.cy), []).append(f"{index}" if line.r else f"{index} (r = 0)")
    return tuple(Spot(Fraction(x), Fraction(y), ", ".join(names)) for (x, y), names in found.items())


def _at(crowd: Crowd, t: ExactNumber) -> ExactPlace:
    (ox, oy), (dx, dy) = crowd.origin, crowd.direction
    return t * dx + ox, t * dy + oy


def _with_hits(scene: Scene, crowd: Crowd, shown: Shown) -> Scene:
    hits = [hit for each in shown.exact for hit in getattr(each, "items", (each,))]
    wanted = tuple(Spot(*_at(crowd, Surd.of(t.x)), f"{tag} {index}") for t, index, tag in hits[:_MOST])
    given = tuple(_given_hits(crowd, shown.given))
    return scene.having(wanted=wanted, given=given)


def _given_hits(crowd: Crowd, raw: Any) -> Iterator[Spot]:
    for each in (items(raw) or ())[:_MOST]:
        parts = items(each) or ()
        if len(parts) == 3 and (t := read_number(parts[0])) is not None:
            yield Spot(*_at(crowd, t), f"got {word(parts[2]) or '?'} {_short(parts[1])}")


def _short(raw: Any) -> str:
    return str(raw) if type(raw) is int and abs(raw) < 1000 else "?"


def _with_spans(scene: Scene, crowd: Crowd, shown: Shown) -> Scene:
    ways = []
    for start, end in shown.exact[:_MOST]:
        ways.append(Way(_at(crowd, Surd.of(start.x)), _at(crowd, Surd.of(end.x)), "wanted", _SIDE))
    for each in (items(shown.given) or ())[:_MOST]:
        ends = [read_number(end) for end in items(each) or ()]
        if len(ends) == 2 and None not in ends:
            ways.append(Way(_at(crowd, ends[0]), _at(crowd, ends[1]), "got", -_SIDE))  # type: ignore[arg-type]
    return scene.having(ways=tuple(ways))


def _with_light(scene: Scene, crowd: Crowd, bands: Bands, light: Sequence[Any], shown: Shown) -> Scene:
    one = 1 << crowd.shift
    lamp = Spot(Fraction(light[0]) * one, Fraction(light[1]) * one, "L")
    scene = scene.having(names=(*scene.names, lamp))
    hits = crowd.ahead(crowd.every_hit(bands), bands)
    if not hits:
        return scene
    x, y = _at(crowd, crowd.parameter(hits[0], bands))
    lit = shown.exact == "lit"
    way = Way((x, y), (lamp.x, lamp.y), "line" if lit else "beyond", 0.0)
    return scene.having(names=(*scene.names, Spot(x, y, f"P, {shown.exact}")), ways=(way,))


def crowd_words(scene: Scene, part: Part, exact: Any) -> str:
    """What there is to say of the answer, for a sentence."""
    circles = len(scene.others) + 1
    count = f"{circles} circle{'' if circles == 1 else 's'}"
    if part is Part.HITS:
        hits = sum(len(getattr(each, "items", (each,))) for each in exact)
        return f"{count}, {hits} hit{'' if hits == 1 else 's'} ahead"
    if part is Part.SPANS:
        return f"{count}, {len(exact)} span{'' if len(exact) == 1 else 's'}, drawn beside the ray"
    what: Mapping[Any, str] = {
        "lit": "the light shines on P",
        "dark": "P is in the dark",
        None: "the ray hits nothing",
    }
    return f"{count}, {what[exact]}"

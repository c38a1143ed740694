"""Small figures for quiz cards: a few circles in whole numbers, and a ray or a line across them.

A scene of test data draws them, and `Crowd` decides. Where two things happen nearly together, or a line
nearly touches, the figure is drawn anew: a person should see the answer.
"""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal
from itertools import pairwise

from judge.data.draw import Draw, Rejected
from judge.drawing import Picture
from judge.geometry.crowd import Crowd, Hit
from judge.geometry.picture import bare
from judge.geometry.quadratic import TANGENT
from judge.geometry.scenes.crowds import anywhere
from judge.geometry.view import Ring, View, Way
from judge.problem.declare import Puzzle, decisions

IntPoint = tuple[int, int]
IntCircle = tuple[int, int, int]

_FORMS = {"ray": ("first-hit", "order"), "points": ("tags",), "hits": ("tags",)}
_LABELS = "ABCD"
_TRIES = 5_000
_APART = 0.5  # what decides is exact, or at least so long
_CENTRES = 2  # how far apart they are at least, in x or in y
_BACK = 30  # where a line is taken to begin, in lengths of PQ
_TAGS = {"i": "in", "o": "out", "t": "touch"}
_drawn = anywhere(7, (2, 4), (1, 3))


def puzzle(kind: str, form: str, draw: Draw) -> Puzzle | None:
    """A figure for that form of cards, about cases of that kind; None where there is none."""
    if form not in _FORMS.get(kind, ()):
        return None
    for _ in range(_TRIES):
        try:
            circles, O, D = _drawn(draw)
        except Rejected:
            continue
        line = kind == "points"
        start = (O[0] - _BACK * D[0], O[1] - _BACK * D[1]) if line else O
        crowd = Crowd(circles, start, D)
        hits = _seen(crowd, circles)
        order = tuple(dict.fromkeys(_LABELS[hit.circle] for hit in hits))
        if len(order) < (1 if form == "first-hit" else 2):
            continue
        given = (*map(_words, _LABELS, circles), _way(O, D, line=line))
        picture = _picture(circles, O, D, line=line)
        first = {hit.circle: hit for hit in reversed(hits)}
        told = hits if form == "tags" else sorted(first.values(), key=hits.index)
        why = ", ".join(_event(crowd, hit, line=line, tagged=form == "tags") for hit in told)
        if form == "tags":
            return Puzzle(given, picture, _TAGS, tuple("ito"[hit.which + 1] for hit in hits), why=f"{why}.")
        words, one = dict.fromkeys(_LABELS[: len(circles)], ""), form == "first-hit"
        return Puzzle(given, picture, words, order[:1] if one else order, one, f"The ray meets {why}.")
    return None


def _seen(crowd: Crowd, circles: Sequence[IntCircle]) -> list[Hit]:
    """Every hit in order; none where a person could not tell."""
    for number, (x, y, _) in enumerate(circles):
        if any(max(abs(x - u), abs(y - v)) < _CENTRES for u, v, _ in circles[:number]):
            return []
    with decisions() as made:
        hits = crowd.hits()
    if any(
        abs(each.gap) * crowd.sure.size < _APART and (each.gap or each.what != TANGENT.name) for each in made
    ):
        return []
    places = [float(crowd.time(hit).x) for hit in hits]
    length = float(crowd.circles[0].a) ** 0.5
    return hits if all((after - before) * length >= _APART for before, after in pairwise(places)) else []


def _words(label: str, circle: IntCircle) -> str:
    return f"circle {label}: centre ({circle[0]}, {circle[1]}), radius {circle[2]}"


def _way(O: IntPoint, D: IntPoint, *, line: bool) -> str:
    if line:
        return f"the line from P = {O} through Q = ({O[0] + D[0]}, {O[1] + D[1]})"
    return f"the ray from O = {O} along D = {D}"


def _event(crowd: Crowd, hit: Hit, *, line: bool, tagged: bool) -> str:
    word = f" {_TAGS['ito'[hit.which + 1]]}" if tagged else ""
    place = "" if line else f" at t = {float(crowd.time(hit).x):.3g}"
    return f"{_LABELS[hit.circle]}{word}{place}"


def _picture(circles: Sequence[IntCircle], O: IntPoint, D: IntPoint, *, line: bool) -> Picture:
    view = View()
    for label, circle in zip(_LABELS, circles, strict=False):
        x, y, r = map(Decimal, circle)
        view.rings.append(Ring(x, y, r))
        view.name((x, y), label)
    way = Way((Decimal(O[0]), Decimal(O[1])), (Decimal(D[0]), Decimal(D[1])), None if line else 0, None)
    view.ways.append(way)
    view.name(way.start, "P" if line else "O")
    if line:
        view.name(way.at(1), "Q")
    return bare(view)

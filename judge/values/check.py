"""Deciding an answer, JSON of any shape or a line of text, and saying why it is wrong.

A target is what answers are held against, made of the exact one once, and plain JSON: three doubles for a
real number (`judge.values.answers.accepted_doubles`), ints and words themselves, None, tuples; {"any": […]}
and {"such as": …} stand for the wrappers of the exact tree. Doubles decide nearly always: the exact answer is
asked for only where a number that is no double lies beside an end of the interval.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from functools import partial
from math import inf, isfinite
from typing import Any, NamedTuple

from msgspec import Struct
from msgspec.structs import replace

from judge.errors import ProblemError
from judge.values.answers import AnyOf, Exact, Judged, Target, Tolerance, Words
from judge.values.atoms import NOTHING, ROOT, Atom, Mismatch, Place, Type, Unfit, Value
from judge.values.parameters import leaves
from judge.values.reading import entry, read, read_line
from judge.values.show import shown, wanted, wanted_line
from judge.values.types import DictType, Entries, ListType, lasting
from judge.values.wire import Raw, Unreadable, Written, exactly, quoted

ExactOf = Callable[[], tuple[Exact, Tolerance]]
_NONE = re.compile(r"""'(?:[^'\\]|\\.)*'|"(?:[^"\\]|\\.)*"|None""")
_REORDERED = 64  # items up to which a wrong list is held against itself in another order


class Accepted(Struct, frozen=True):
    """The answer is right; `worst_ulps` is the largest error of its numbers, in ulps of the nearest doubles.

    None where the answer has no measured number; an exact 0, which has no scale of its own, adds nothing.
    """

    worst_ulps: float | None = None


class Rejection(Struct, frozen=True):
    """The answer is wrong, and why, for a person.

    `wanted` and `got` are whole answers. Where one number decided, `where` names it ("y of point 2") and its
    errors are given: absolute, relative to the wanted number (None where that is 0), and in its ulps.
    """

    message: str
    wanted: str
    got: str
    where: str = ""
    absolute: float | None = None
    relative: float | None = None
    ulps: float | None = None


Outcome = Accepted | Rejection
_UNMEASURED = Accepted()


def target(type_: Type, exact: Exact, tolerance: Tolerance) -> Target:
    """What answers are held against.

    Raises ProblemError for an exact answer that is none of this type, and for a tolerance that does not fit.
    """
    try:
        return _target(type_, exact, tolerance)
    except Unfit as why:
        raise ProblemError(
            f"the exact answer is no {type_.text}: {why}", remedy="correct it, or the answer's type"
        ) from None


def _target(type_: Type, exact: Exact, tolerance: Tolerance) -> Target:
    if isinstance(exact, AnyOf):
        if not exact.answers:
            raise Unfit("AnyOf without answers")
        return {"any": tuple([_target(type_, each, tolerance) for each in exact.answers])}
    if isinstance(exact, Judged):
        return {"such as": _target(type_, exact.sample, tolerance)}
    inner = lasting(type_)
    if exact is None and inner is not type_:
        return None
    if isinstance(inner, Atom):
        return inner.aim(exact, tolerance)
    if isinstance(inner, DictType):
        exact = inner.ordered(exact)
    if wrong := inner.why_not(tuple(exact) if type(exact) is list else exact):
        raise Unfit(wrong)
    return tuple([_target(part, each, tolerance) for part, each in inner.pairs(exact)])


# -- deciding ----------------------------------------------------------------------------------------------


def check(type_: Type, raw: Raw, target: Target, exact: ExactOf) -> Outcome:
    """Decide an answer, JSON of any shape whatever; it never raises for one."""
    found, _ = decide(type_, raw, target, exact)
    if isinstance(found, float):
        return Accepted(found) if found >= 0.0 else _UNMEASURED
    why = found()
    return Rejection(why.message, wanted(type_, target), shown(type_, raw), why.where, *why.errors)


def is_right(type_: Type, raw: Raw, target: Target, exact: ExactOf) -> bool:
    """Whether `check` accepts it, without a word about why not: for who decides a hundred thousand."""
    return isinstance(decide(type_, raw, target, exact)[0], float)


def decide(
    type_: Type, raw: Raw, target: Target, exact: ExactOf
) -> tuple[float | Callable[[], Mismatch], tuple[Value] | None]:
    """How many ulps an answer is off at most, NOTHING if there is nothing to be off; or what says why.

    Beside it, in a tuple of one, the value, where it had to be read and could be.
    """
    try:
        worst = type_.quick(raw, target)
    except (TypeError, ValueError):  # a target with alternatives in it is not unpacked
        worst = None
    if worst is not None:
        return worst, None
    try:
        value = read(type_, raw)
    except Unreadable as why:
        return partial(Mismatch, str(why)), None
    found = _off(type_, value, target, _Ask(exact, type_.words), ROOT)
    return found.tell if isinstance(found, _Miss) else found, (value,)


class _Ask(NamedTuple):
    """What may be asked while an answer is decided: the exact answer, and the problem's own words."""

    exact: ExactOf
    words: Words

    def at(self, place: Place) -> Any:
        """The exact answer there, and the tolerance."""
        found, tolerance = self.exact()
        for step in place.steps():
            found = found.answers if isinstance(found, AnyOf) else found
            found = (sorted(found.items()) if type(found) is dict else found)[step]
        return found, tolerance


class _Miss(NamedTuple):
    """Where a value is wrong, and what says why."""

    place: Place
    tell: Callable[[], Mismatch]


def _off(type_: Type, value: Value, target: Target, ask: _Ask, place: Place) -> float | _Miss:
    """How many ulps a value is off at most, or where it is wrong."""
    if type(target) is dict:
        return _off_any(type_, value, target, ask, place)
    inner = lasting(type_)
    if inner is not type_ and (value is None or target is None):
        return NOTHING if value is target else _Miss(place, partial(_none, inner, value, target, ask, place))
    if isinstance(inner, Atom):
        leaf = partial(ask.at, place)
        off = inner.off(value, target, leaf)
        return (
            _Miss(place, partial(inner.miss, value, target, leaf, ask.words, place)) if off is None else off
        )
    if isinstance(inner, DictType):
        return _off_entries(inner, value, target, ask, place)
    count, worst = len(value), NOTHING
    if count != len(target) and isinstance(inner, ListType):
        return _Miss(place, partial(_other_count, inner, value, target, ask, place))
    for at, (part, given, each) in enumerate(zip(inner.parts(count), value, target, strict=True)):
        one = _off(part, given, each, ask, Place(place, at, inner, count))
        if isinstance(one, _Miss):
            if isinstance(inner, ListType):
                return _Miss(one.place, partial(_other_items, inner, value, target, ask, place, one))
            return one
        if one > worst:
            worst = one
    return worst


def _off_entries(type_: DictType, value: Value, target: Target, ask: _Ask, place: Place) -> float | _Miss:
    """The same for a dict: first its keys, then what stands there."""
    given, wanted, worst = dict(value), dict(target), NOTHING
    if missing := [key for key in wanted if key not in given]:
        return _Miss(place, partial(place.mismatch, f"no entry {type_.key.shown(missing[0])}"))
    if surplus := [key for key in given if key not in wanted]:
        return _Miss(place, partial(place.mismatch, f"an entry {type_.key.shown(surplus[0])} too many"))
    for at, (key, each) in enumerate(target):
        one = _off(type_.value, given[key], each, ask, entry(type_, key, place, at))
        if isinstance(one, _Miss):
            return one
        worst = max(worst, one)
    return worst


def _off_any(type_: Type, value: Value, target: Target, ask: _Ask, place: Place) -> float | _Miss:
    """The same for an answer of which there are several."""
    if "such as" in target:
        for atom, each in leaves(type_, value):
            if wrong := atom.beyond(each):
                return _Miss(place, partial(place.mismatch, wrong))
        judged, _ = ask.at(place)
        why = judged.why_not(_plain(value), judged.group)
        return NOTHING if why is None else _Miss(place, partial(place.mismatch, why))
    misses = []
    for step, each in enumerate(target["any"]):
        found = _off(type_, value, each, ask, Place(place, step))
        if not isinstance(found, _Miss):
            return found
        misses.append(found)
    return _Miss(place, partial(_of_several, type_, value, target, place, misses))


def _plain(value: Value) -> Any:
    """A value that was read, as Python has it: digits alone are an int, another decimal its double."""
    if isinstance(value, Entries):
        return {key: _plain(each) for key, each in value}
    if isinstance(value, list | tuple):
        return type(value)([_plain(each) for each in value])
    if isinstance(value, Written):
        if value.text.lstrip("+-").isdecimal():
            return int(value.text)
        return value.approx if isfinite(value.approx) else exactly(value)
    return value


# -- why an answer is wrong --------------------------------------------------------------------------------


def _none(type_: Type, value: Value, target: Target, ask: _Ask, place: Place) -> Mismatch:
    """None where there is an answer, or the other way round."""
    if target is None:
        message = f"None expected, {shown(type_, value)} given"
    elif ask.words.missing and not place.name():
        name = f"{ask.words.answer} = " if ask.words.answer else ""
        message = f"None given, {ask.words.missing}: {name}{wanted(type_, target)}"
    else:
        message = f"{wanted(type_, target)} expected, None given"
    return place.mismatch(message)


def _of_several(type_: Type, value: Value, target: Target, place: Place, misses: Sequence[_Miss]) -> Mismatch:
    """What is wrong beside that right answer which agrees the longest, and misses by the least."""
    inner = lasting(type_)
    if value is None or (isinstance(inner, Atom) and not inner.measured):
        return place.mismatch(f"{wanted(type_, target)} expected, {shown(type_, value)} given")
    longest = max(each.place.steps()[len(place.steps()) + 1 :] for each in misses)
    told = [each.tell() for each in misses if each.place.steps()[len(place.steps()) + 1 :] == longest]
    return min(told, key=lambda why: inf if why.errors[0] is None else why.errors[0])


def _other_count(type_: ListType, value: Value, target: Target, ask: _Ask, place: Place) -> Mismatch:
    """Too many items, or too few."""
    size = len(target)
    count = f"1 {type_.one}" if size == 1 else f"{size or 'no'} {type_.several}"
    message = f"{count} expected, {len(value) or 'none'} given"
    if size == 1 and len(value) == 2 and all(_fits(type_, each, target, 0, ask, place) for each in value):
        message += f": the same {type_.one} twice"
    return place.mismatch(message)


def _other_items(
    type_: ListType, value: Value, target: Target, ask: _Ask, place: Place, first: _Miss
) -> Mismatch:
    """Another order, or the `first` item that is wrong."""
    taken: set[int] = set()
    for each in value if len(value) <= _REORDERED else ():
        fitting = [at for at in range(len(target)) if _fits(type_, each, target, at, ask, place)]
        if len(fitting) != 1:  # in a list of noughts and ones order is not what is wrong
            break
        taken.update(fitting)
    if len(taken) < len(value):
        return first.tell()
    order = f": {ask.words.order}" if ask.words.order else ""
    return Mismatch(f"{place.prefix()}the right {type_.several} in the wrong order{order}")


def _fits(type_: ListType, item: Value, target: Target, at: int, ask: _Ask, place: Place) -> bool:
    return not isinstance(_off(type_.item, item, target[at], ask, Place(place, at, type_, 1)), _Miss)


# -- lines of text -----------------------------------------------------------------------------------------


def check_line(type_: Type, text: str, target: Target, exact: ExactOf) -> Outcome:
    """Decide one line of a program's output (without its newline, whatever it holds); see `check`."""
    answer = read_line(type_, text)
    got = quoted(text)[1:-1]
    if isinstance(answer, str):
        return Rejection(answer, wanted_line(type_, target), got)
    outcome = check(type_, answer[0], target, exact)
    if isinstance(outcome, Accepted):
        return outcome
    # The answers are shown as programs write them; what stands in quotation marks is a text.
    message = _NONE.sub(lambda found: found[0] if found[0] != "None" else "none", outcome.message)
    return replace(outcome, message=message, wanted=wanted_line(type_, target), got=got)

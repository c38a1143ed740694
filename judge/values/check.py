"""Deciding an answer, JSON of any shape or a line of text, and saying why it is wrong.

A target is what answers are held against, made of the exact one once, and plain JSON: three doubles for a
real number (`judge.values.answers.accepted_doubles`), ints and words themselves, None, tuples; {"run": […]},
{"any": […]} and {"such as": …} stand for the wrappers of the exact tree. Doubles decide nearly always: the
exact answer is asked for only where a number that is no double lies beside an end of the interval.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from math import inf
from typing import Any, NamedTuple

from msgspec import Struct

from judge.errors import ProblemError
from judge.values.answers import AnyOf, Exact, Judged, Run, Tolerance, Words
from judge.values.base import NOTHING, ROOT, Atom, Mismatch, Place, Target, Type, Unfit, Value, unequal
from judge.values.show import shown, wanted
from judge.values.types import Composite, ListType, OptionalType, TupleType, lasting
from judge.values.wire import Raw, Unreadable, Written, collecting, fault, items

ExactOf = Callable[[], tuple[Exact, Tolerance]]
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


# -- targets -----------------------------------------------------------------------------------------------


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
        return {"any": [_target(type_, each, tolerance) for each in exact.answers]}
    if isinstance(exact, Judged):
        return {"such as": _target(type_, exact.sample, tolerance)}
    if isinstance(type_, OptionalType):
        return None if exact is None else _target(type_.inner, exact, tolerance)
    if isinstance(type_, Atom):
        return type_.aim(exact, tolerance)
    assert isinstance(type_, Composite)
    if type(exact) not in (list, tuple):
        raise Unfit(f"{exact!r} where a {type_.kind.__name__} is meant")
    count = sum(len(each.items) if isinstance(each, Run) else 1 for each in exact)
    if isinstance(type_, TupleType) and count != len(type_.fixed):
        raise Unfit(f"{count} parts where {len(type_.fixed)} are meant")
    if isinstance(type_, ListType) and not type_.low <= count <= (inf if type_.high is None else type_.high):
        raise Unfit(f"{count} {type_.one if count == 1 else type_.several} where {type_.bounds()} are meant")
    return tuple(
        [
            {"run": [_target(part, one, tolerance) for one in each.items]}
            if isinstance(each, Run)
            else _target(part, each, tolerance)
            for part, each in zip(type_.parts(len(exact)), exact, strict=True)
        ]
    )


class Wanted(NamedTuple):
    """One element of a target: its own, the steps to it in the exact tree, and the places of its run."""

    target: Target
    steps: tuple[int, ...]
    run: range


def elements(targets: Sequence[Target]) -> list[Wanted]:
    """The elements of a tuple's or a list's target in order, those of runs too."""
    found: list[Wanted] = []
    for place, each in enumerate(targets):
        many = each["run"] if type(each) is dict and "run" in each else None
        run = range(len(found), len(found) + (1 if many is None else len(many)))
        if many is None:
            found.append(Wanted(each, (place,), run))
        else:
            found += [Wanted(one, (place, step), run) for step, one in enumerate(many)]
    return found


# -- deciding ----------------------------------------------------------------------------------------------


class Ask:
    """What may be asked while an answer is decided: the exact answer, and the problem's own words."""

    def __init__(self, exact: ExactOf, words: Words) -> None:
        self._exact, self.words = exact, words

    def at(self, path: _Path) -> Any:
        """The exact leaf there, and the tolerance."""
        exact, tolerance = self._exact()
        steps = []
        while path is not None:
            path, step = path
            steps.append(step)
        for step in reversed(steps):
            parts: Any = exact.answers if isinstance(exact, AnyOf) else getattr(exact, "items", exact)
            exact = parts[step]
        return exact, tolerance

    def why_not(self, value: Value, path: _Path) -> str | None:
        """Why the problem itself does not accept a value that was read."""
        judged, _ = self.at(path)
        found: str | None = judged.why_not(_plain(value), judged.group)
        return found


_Path = Any  # (the path above, step) from a part of an answer up to its root, which is None


def _plain(value: Value) -> Any:
    """A value that was read, as Python has it: digits alone are an int, another decimal is its double."""
    if isinstance(value, list | tuple):
        return type(value)([_plain(each) for each in value])
    if isinstance(value, Written):
        return int(value.text) if value.text.lstrip("+-").isdecimal() else value.approx
    return value


def check(type_: Type, raw: Raw, target: Target, exact: ExactOf) -> Outcome:
    """Decide an answer, JSON of any shape whatever; it never raises for one."""
    try:
        worst = type_.quick(raw, target)
    except (TypeError, ValueError):  # a target with alternatives or runs in it is not unpacked
        worst = None
    if worst is None:
        ask = Ask(exact, type_.words)
        try:
            value = read(type_, raw)
            worst = off(type_, value, target, ask, None)
        except Unreadable as why:
            return Rejection(str(why), wanted(type_, target), shown(type_, raw))
        if worst is None:
            miss = _why(type_, value, target, ask, ROOT, None)
            return Rejection(miss.message, wanted(type_, target), shown(type_, raw), miss.where, *miss.errors)
    return Accepted(worst) if worst >= 0.0 else _UNMEASURED


def is_right(type_: Type, raw: Raw, target: Target, exact: ExactOf) -> bool:
    """Whether `check` accepts it, without a word about why not: for who decides a hundred thousand."""
    if quick_off(type_, raw, target) is not None:
        return True
    try:
        return off(type_, read(type_, raw), target, Ask(exact, type_.words), None) is not None
    except Unreadable:
        return False


def quick_off(type_: Type, raw: Raw, target: Target) -> float | None:
    """How far off the usual right answer is; None for any other one."""
    try:
        return type_.quick(raw, target)
    except (TypeError, ValueError):  # a target with alternatives or runs in it is not unpacked
        return None


def read(type_: Type, raw: Raw, place: Place = ROOT, *, bounded: bool = True) -> Value:
    """The value that an answer stands for; raises Unreadable.

    `bounded` says whether a list may have no more items than its type says.
    """
    if isinstance(type_, OptionalType):
        if raw is None:
            return None
        if isinstance(type_.inner, Atom):
            return type_.inner.read(raw, place, type_.noun if place is ROOT else type_.inner.noun)
        return read(type_.inner, raw, place, bounded=bounded)
    if isinstance(type_, Atom):
        return type_.read(raw, place, type_.noun)
    assert isinstance(type_, Composite)
    found = items(raw)
    if found is None or (isinstance(type_, ListType) and len(found) and is_one_item(type_, found)):
        raise Unreadable(_no_parts(type_, raw, found, place))
    count = len(found)
    if bounded or isinstance(type_, TupleType):
        why = type_.wrong_count(count, place)
        if why:
            raise Unreadable(why)
    if isinstance(type_, ListType) and set(map(type, found)) <= {int} and type_.item.text == "int":
        return list(found)  # a million of them, perhaps
    return type_.kind(
        [
            read(part, each, type_.down(place, at, count), bounded=bounded)
            for at, (part, each) in enumerate(zip(type_.parts(count), found, strict=True))
        ]
    )


def is_one_item(type_: ListType, found: Sequence[Raw]) -> bool:
    """Whether one item is given where a list of them is meant: (x, y) for [(x, y)]."""
    parts = type_.item.fixed if isinstance(type_.item, TupleType) else ()
    return len(parts) == len(found) and all(
        type(each) in (int, float) or (type(each) is dict and items(each) is None) for each in found
    )


def _no_parts(type_: Composite, raw: Raw, found: Sequence[Raw] | None, place: Place) -> str:
    name = place.name()
    what = f"{name} is meant to be {type_.noun}" if name else f"{type_.noun} is meant"
    if isinstance(type_, ListType) and raw is None:
        return f"None where {what}" + (f": no {type_.several} are []" if not type_.low else "")
    if isinstance(type_, ListType) and found is not None:
        return f"{f'a {type_.one}' if type_.one != 'item' else shown(type_.item, raw)} where {what}"
    wrong, remedy = fault(raw), ""
    if isinstance(type_, ListType):
        remedy = collecting(wrong.type)
    elif type_.one == "point" and wrong.type.startswith("complex"):
        remedy = f"return a point as {type_.noun}"
    return wrong.where(what, remedy)


def off(type_: Type, value: Value, target: Target, ask: Ask, path: _Path) -> float | None:
    """How many ulps a value is off at most, NOTHING if there is nothing to be off; None where it is wrong."""
    if type(target) is dict:
        if "such as" in target:
            return NOTHING if ask.why_not(value, path) is None else None
        ways = (off(type_, value, each, ask, (path, step)) for step, each in enumerate(target["any"]))
        return next((each for each in ways if each is not None), None)
    if isinstance(type_, Atom):
        return type_.off(value, target, lambda: ask.at(path))
    if isinstance(type_, OptionalType):
        if value is None or target is None:
            return NOTHING if value is target else None
        return off(type_.inner, value, target, ask, path)
    assert isinstance(type_, Composite)
    has_runs = type_.kind is list and any(type(each) is dict and "run" in each for each in target)
    if not has_runs and len(value) != len(target):
        return None
    worst, parts = NOTHING, type_.parts(len(value))
    if not has_runs:
        for at, (part, given, one) in enumerate(zip(parts, value, target, strict=True)):
            found = off(part, given, one, ask, (path, at))
            if found is None:
                return None
            if found > worst:
                worst = found
        return worst
    wanted = elements(target)
    if len(value) != len(wanted):
        return None
    for each in _each(type_, value, wanted, ask, path):
        if each is None:
            return None
        worst = max(worst, each)
    return worst


def _each(
    type_: Composite, value: Value, wanted: list[Wanted], ask: Ask, path: _Path
) -> Iterator[float | None]:
    """How far off each part is; one of a run uses up the first element left that accepts it."""
    used: set[int] = set()
    for at, (part, each) in enumerate(zip(type_.parts(len(value)), value, strict=True)):
        found = None
        for index in wanted[at].run:
            if index not in used:
                found = off(part, each, wanted[index].target, ask, _below(path, wanted[index]))
                if found is not None:
                    used.add(index)
                    break
        yield found


def _below(path: _Path, wanted: Wanted) -> _Path:
    for step in wanted.steps:
        path = (path, step)
    return path


# -- why an answer is wrong --------------------------------------------------------------------------------


def _why(type_: Type, value: Value, target: Target, ask: Ask, place: Place, path: _Path) -> Mismatch:
    """Why a value that is wrong is so."""
    if type(target) is dict and "such as" in target:
        return Mismatch(f"{place.prefix()}{ask.why_not(value, path)}", place.name())
    if type(target) is dict:
        inner = lasting(type_)
        if (value is None and type_.optional) or (isinstance(inner, Atom) and not inner.measured):
            return unequal(inner, value, wanted(type_, target), place)
        misses = [
            _why(type_, value, each, ask, place, (path, step)) for step, each in enumerate(target["any"])
        ]
        return min(misses, key=lambda why: inf if why.errors[0] is None else why.errors[0])
    if isinstance(type_, OptionalType):
        if value is not None and target is not None:
            return _why(type_.inner, value, target, ask, place, path)
        if target is None:
            message = f"None wanted, {shown(type_.inner, value)} given"
        elif place is ROOT and ask.words.missing:
            name = f"{ask.words.answer} = " if ask.words.answer else ""
            message = f"None given, {ask.words.missing}: {name}{wanted(type_.inner, target)}"
        else:
            message = f"{wanted(type_.inner, target)} wanted, None given"
        return Mismatch(f"{place.prefix()}{message}", place.name())
    if isinstance(type_, Atom):
        return type_.why(value, target, ask.words, place)
    assert isinstance(type_, Composite)
    parts = elements(target)
    if isinstance(type_, ListType):
        if len(value) != len(parts):
            message = _wrong_number(type_, value, parts, ask, path)
            return Mismatch(place.prefix() + message, place.name())
        if _is_reordered(type_, value, parts, ask, path):
            order = f": {ask.words.order}" if ask.words.order else ""
            return Mismatch(f"{place.prefix()}the right {type_.several} in the wrong order{order}")
    at = next(at for at, each in enumerate(_each(type_, value, parts, ask, path)) if each is None)
    part, first = type_.parts(len(value))[at], _left(type_, value, parts, at, ask, path)
    down = type_.down(place, at, len(parts))
    return _why(part, value[at], first.target, ask, down, _below(path, first))


def _left(type_: Composite, value: Value, parts: list[Wanted], at: int, ask: Ask, path: _Path) -> Wanted:
    """The first element of the run at a wrong place that no part before it has used up."""
    used: set[int] = set()
    for before in range(parts[at].run.start, at):
        item = type_.parts(len(value))[before]
        for index in parts[before].run:
            if (
                index not in used
                and off(item, value[before], parts[index].target, ask, _below(path, parts[index])) is not None
            ):
                used.add(index)
                break
    return next(parts[index] for index in parts[at].run if index not in used)


def _wrong_number(type_: ListType, value: Value, parts: list[Wanted], ask: Ask, path: _Path) -> str:
    count = f"1 {type_.one}" if len(parts) == 1 else f"{len(parts) or 'no'} {type_.several}"
    message = f"{count} wanted, {len(value) or 'none'} given"
    if len(parts) == 1 and len(value) == 2:
        below = _below(path, parts[0])
        if all(off(type_.item, each, parts[0].target, ask, below) is not None for each in value):
            message += f": the same {type_.one} twice"
    return message


def _is_reordered(type_: ListType, value: Value, parts: list[Wanted], ask: Ask, path: _Path) -> bool:
    """Whether every item given is one of those wanted, each of them once.

    Where an item fits in two places, as in a list of noughts and ones, order is not what is wrong.
    """
    if not 2 <= len(value) <= _REORDERED:
        return False
    taken: set[int] = set()
    for each in value:
        fitting = [
            index
            for index, part in enumerate(parts)
            if off(type_.item, each, part.target, ask, _below(path, part)) is not None
        ]
        if len(fitting) != 1:
            return False
        taken.update(fitting)
    return len(taken) == len(value)

"""Calls in a row on one object: `calls{get(key: int) -> int?; put(key: int)}`, and `returns{…}` of the same.

The calls are a parameter, tuples of a method's name and its arguments; what they return is the answer. A
method without an answer may return anything.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from functools import cached_property
from typing import Any, NamedTuple

from judge.values import check, parameters, show, wire
from judge.values.answers import Exact, Target, Tolerance, Words
from judge.values.atoms import NOTHING, Atom, Leaf, Mismatch, Place, Quick, Type, Unfit, Value
from judge.values.wire import Raw

_FEW = 6  # calls of a simple case
_NUMBER = 3  # the largest number in it
_LONG = 1 << 63  # other languages are told of larger ones by a type's bounds
_ORDINALS = ["first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth"]


class Method(NamedTuple):
    """A method: what it takes, and what it answers; None where nobody looks at that."""

    name: str
    takes: tuple[tuple[str, Type], ...]
    answer: Type | None = None

    @property
    def text(self) -> str:
        """As problem.toml has it."""
        taken = ", ".join(f"{name}: {type_.text}" for name, type_ in self.takes)
        return f"{self.name}({taken})" + (f" -> {self.answer.text}" if self.answer else "")


class _Methods(Atom):
    """What both have: the methods, by their order."""

    kind, plural = "", "calls"

    def __init__(self, methods: Sequence[Method]) -> None:
        names = [each.name for each in methods]
        if doubled := next((name for name in names if names.count(name) > 1), ""):
            raise ValueError(f"there are two methods {doubled!r}")
        self.methods = tuple(methods)
        self.place = {name: place for place, name in enumerate(names)}
        self.text = f"{self.kind}{{{'; '.join(each.text for each in methods)}}}"

    def of(self, call: Sequence[Any]) -> Method:
        """The method that is called."""
        return self.methods[self.place[call[0]]]

    def given(self, call: Sequence[Any]) -> Iterator[tuple[str, Type, Any]]:
        """What a call hands over: the parameter's name, its type, the argument."""
        return ((*taken, each) for taken, each in zip(self.of(call).takes, call[1:], strict=True))


class CallType(_Methods):
    """The calls of one case."""

    kind, noun, annotation = "calls", "a list of calls", "list"
    is_parameter, is_plain = True, False

    def why_not(self, value: Any) -> str | None:
        """A tuple of calls of these methods, each with as many arguments of its types."""
        if type(value) is not tuple:
            return f"{value!r} where a tuple of calls is expected"
        return next(filter(None, map(self._fault, value)), None)

    def _no_call(self, call: Any) -> str | None:
        known = type(call) is tuple and call and type(call[0]) is str and call[0] in self.place
        takes = self.of(call).takes if known else ()
        if known and len(call) - 1 == len(takes):
            return None
        more = f"; {call[0]} takes {', '.join(name for name, _ in takes) or 'nothing'}" if known else ""
        return f"{wire.cut(repr(call))} where a call of {' or '.join(self.place)} is expected{more}"

    def _fault(self, call: Any) -> str | None:
        if wrong := self._no_call(call):
            return wrong
        given = self.given(call)
        faults = (parameters.fault(type_, f"{call[0]}: {name}", each) for name, type_, each in given)
        return next(filter(None, faults), None)

    def beyond(self, value: Any) -> str | None:
        """An argument that is beyond its type's bounds."""
        for call in value:
            for name, type_, each in self.given(call):
                for atom, leaf in parameters.leaves(type_, each):
                    if wrong := atom.beyond(leaf):
                        return f"{wrong}, as {name} of {call[0]}"
                    if type(leaf) is int and getattr(atom, "low", 0) is None and abs(leaf) >= _LONG:
                        return f"{leaf}, of more than 64 bits, as {name} of {call[0]}: give its type bounds"
        return None

    def listed(self, value: Any, *, received: bool = False) -> Any:
        """Each call as a submission receives it; or else with the pairs of a dict, as JSON can hold them."""
        way = parameters.argument if received or not self.keyed else parameters.listed
        return self._mapped(way, value)

    @cached_property
    def keyed(self) -> bool:  # type: ignore[override]
        """Whether a method takes a dict."""
        return any(type_.keyed for each in self.methods for _, type_ in each.takes)

    def kept(self, value: Any) -> Any:
        """Each dict as its pairs."""
        if type(value) is not tuple or any(map(self._no_call, value)):
            return value
        return tuple(self._mapped(parameters.kept, value))

    def _mapped(self, way: Callable[[Type, Any], Any], value: Any) -> list[Any]:
        return [(call[0], *(way(type_, each) for _, type_, each in self.given(call))) for call in value]

    def simpler(self, value: Any) -> Iterator[Any]:
        """Fewer calls, half of them or one, then simpler arguments."""
        count = size = len(value)
        while size := size // 2:
            for start in range(0, count, size):
                yield (*value[:start], *value[start + size :])
        if count == 1:
            yield ()
        for at, call in enumerate(value):
            for place, (_, type_, each) in enumerate(self.given(call), 1):
                for other in parameters.simpler(type_, each):
                    yield (*value[:at], (*call[:place], other, *call[place + 1 :]), *value[at + 1 :])

    def simple(self, integer: Callable[[int, int], int]) -> Any:
        """A few calls with small numbers."""

        def number(_positive: bool) -> int:
            return integer(0, _NUMBER)

        def call() -> tuple[Any, ...]:
            method = self.methods[integer(0, len(self.methods) - 1)]
            given = (parameters.simple(type_, integer, number, positive=False) for _, type_ in method.takes)
            return method.name, *given

        return tuple([call() for _ in range(integer(1, _FEW))])

    def text_of(self, value: Any) -> str:
        """JSON without blanks."""
        return json.dumps(value, separators=(",", ":"))

    def value_from(self, token: str) -> Any:
        """The calls that `text_of` wrote."""
        found = _tupled(json.loads(token))
        if wrong := self.why_not(found):
            raise ValueError(wrong)
        return found


class ReturnType(_Methods):
    """What the calls return, in their order; a target is the method's place and its answer's target."""

    kind, noun, annotation = "returns", "a list of what the calls return", "list"

    @cached_property
    def measured(self) -> bool:  # type: ignore[override]
        """Whether any method returns real numbers."""
        return any(each.answer.measured for each in self.methods if each.answer)

    @cached_property
    def items(self) -> int:
        """Those of the longest answer."""
        return max(each.answer.items if each.answer else 0 for each in self.methods)

    @cached_property
    def quick(self) -> Quick:
        """All answers, one after the other."""
        quicks = [
            each.answer.quick if each.answer else lambda _raw, _target: NOTHING for each in self.methods
        ]

        def quick(raw: Raw, target: Target) -> float | None:
            if type(raw) is not list or len(raw) != len(target):
                return None
            found = [quicks[place](given, wanted) for given, (place, wanted) in zip(raw, target, strict=True)]
            return None if None in found else max(found, default=NOTHING)

        return quick

    def why_not(self, value: Any) -> str | None:
        """A list."""
        return None if isinstance(value, list | tuple) else f"{value!r} where {self.noun} is expected"

    def value_of(self, raw: Raw) -> Any:
        """The answers as they were sent."""
        if type(raw) not in (list, tuple):
            raise ValueError("no list")
        return list(raw)

    def aim(self, exact: Exact, tolerance: Tolerance) -> Target:
        """One for each call."""
        found = []
        for each in exact:
            answer = self.methods[each.method].answer
            try:
                found.append((each.method, check.target(answer, each.answer, tolerance) if answer else None))
            except Exception as why:
                raise Unfit(f"{shown_call(each.call)}: {why}") from None
        return tuple(found)

    def best(self, target: Target) -> Value:
        """What perfect calls return."""
        return self._each(show.best, target)

    def accepted(self, target: Target) -> Any:
        """What is accepted of each call; null where nobody looks."""
        return self._each(show.accepted, target)

    def _each(self, ask: Callable[[Type, Target], Any], target: Target) -> list[Any]:
        """What is asked of each call's answer; None where nobody looks at that."""
        answers = ((self.methods[place].answer, wanted) for place, wanted in target)
        return [ask(answer, wanted) if answer else None for answer, wanted in answers]

    def shown(self, value: Value) -> str:
        """As a list; a target is shown by its best."""
        return wire.show(_sent(value))

    def off(self, value: Value, target: Target, leaf: Leaf) -> float | None:
        """How far off the worst of them is."""
        if len(value) != len(target):
            return None
        worst = NOTHING
        for at, each in enumerate(value):
            found = self.decided(at, each, target[at], leaf)
            if not isinstance(found, float):
                return None
            worst = max(worst, found)
        return worst

    def decided(self, at: int, raw: Raw, target: Target, leaf: Leaf) -> float | check.Rejection:
        """How far off the answer `at` that place is, or why it is wrong."""
        place, wanted = target
        answer = self.methods[place].answer
        if answer is None:
            return NOTHING

        def exact() -> tuple[Exact, Tolerance]:
            every, tolerance = leaf()
            return every[at].answer, tolerance  # type: ignore[index]

        found = check.check(answer, raw, wanted, exact)
        if isinstance(found, check.Rejection):
            return found
        return NOTHING if found.worst_ulps is None else found.worst_ulps

    def miss(self, value: Value, target: Target, leaf: Leaf, words: Words, place: Place) -> Mismatch:
        """The first call that returns a wrong answer."""
        if len(value) != len(target):
            return Mismatch(f"{len(target)} answers expected, {len(value)} given")
        calls = leaf()[0]
        for at, raw in enumerate(value):
            found = self.decided(at, raw, target[at], leaf)
            if isinstance(found, check.Rejection):
                call = f"the {ordinal(at + 1)} call, {shown_call(calls[at].call)}"  # type: ignore[index]
                why = f"{call}, gave {found.got}; {found.wanted} is expected"
                if found.where or found.message != f"{found.wanted} expected, {found.got} given":
                    why = f"{call}: {found.message}"
                return Mismatch(why, call, (found.absolute, found.relative, found.ulps))  # type: ignore[arg-type]
        raise AssertionError


def ordinal(number: int) -> str:
    """`third`, `21st`."""
    if number <= len(_ORDINALS):
        return _ORDINALS[number - 1]
    ending = {1: "st", 2: "nd", 3: "rd"}.get(number % 10, "th") if number % 100 // 10 != 1 else "th"
    return f"{number}{ending}"


def shown_call(call: Sequence[Any]) -> str:
    """`put(1, 10)`."""
    return f"{call[0]}({', '.join(wire.cut(repr(each)) for each in call[1:])})"


def _sent(value: Any) -> Raw:
    if isinstance(value, list | tuple):
        return [_sent(each) for each in value]
    return {"word": value} if isinstance(value, str) else value


def _tupled(value: Any) -> Any:
    return tuple(map(_tupled, value)) if isinstance(value, list) else value

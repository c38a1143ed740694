"""`(T, T, …)`: a tuple of fixed parts; `vec2` and `vec3` are tuples whose parts are called x, y and z."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any

from judge.values.decode import fault, items
from judge.values.judged import first_of
from judge.values.lines import Tokens
from judge.values.outcome import COORDINATES, Place, Unfit, Unreadable, Words
from judge.values.rightness import accepts
from judge.values.tolerance import Tolerance
from judge.values.tree import Exact
from judge.values.type import NOTHING_MEASURED, Draws, Number, Question, Quick, Raw, Target, Type

if TYPE_CHECKING:
    from judge.values.interval import Roots


class TupleType(Type):
    """Its `parts` in order; `names` are those of the parts in messages, `alias` is the stub's name for it."""

    def __init__(self, parts: Sequence[Type], names: Sequence[str] = (), alias: str = "") -> None:
        if len(parts) < 2:
            raise ValueError("a tuple has two parts or more")
        self.parts = tuple(parts)
        self.names = tuple(names) or tuple(f"part {place}" for place in range(1, len(parts) + 1))
        self.is_vector = self.names == COORDINATES[: len(parts)]
        self.text = f"({', '.join(part.text for part in parts)})"
        self.plural = "tuples"
        self.measured = any(part.measured for part in parts)
        self.settled = all(part.settled for part in parts)
        self.is_parameter = all(part.is_parameter and not part.is_buffer for part in parts)
        self.may_begin_with_none = parts[0].may_begin_with_none
        self.is_plain = all(part.is_plain for part in parts)
        widths = [part.width for part in parts]
        self.width = None if None in widths else sum(filter(None, widths))
        self.depth = 1 + max(part.depth for part in parts)
        self.most = sum(part.most + (part.depth > 0) for part in parts)
        self.lengths = max(part.lengths for part in parts)
        self._alias = alias
        self._spelled = f"tuple[{', '.join(part.annotation for part in parts)}]"
        self.annotation = alias or self._spelled
        self.noun = f"a {self._spelled}"  # as the file to begin with spells it
        if self.is_vector:
            self.noun = f"({', '.join(self.names)})"
            self.plural, self.element = "points", ("point", "points")
        if self.measured:
            rounded = (part.rounded.format(f"{{0}}[{at}]") or f"{{0}}[{at}]" for at, part in enumerate(parts))
            self.rounded = f"({', '.join(rounded)})"

    def aimed(self, exact: Exact, tolerance: Tolerance, roots: Roots) -> Target:
        """A tuple of the parts' targets."""
        if type(exact) not in (list, tuple):
            raise Unfit(f"{exact!r} where a tuple is meant")
        if len(exact) != len(self.parts):
            raise Unfit(f"{len(exact)} parts where {len(self.parts)} are meant")
        return tuple(
            [part.targeted(each, tolerance, roots) for part, each in zip(self.parts, exact, strict=True)]
        )

    @cached_property
    def quick(self) -> Quick:
        """All parts."""
        count, parts = len(self.parts), [part.quick for part in self.parts]

        def quick(raw: Raw, target: Target) -> float | None:
            if type(raw) is not list or len(raw) != count or type(target) is dict:
                return None
            worst = NOTHING_MEASURED
            for part, given, wanted in zip(parts, raw, target):  # noqa: B905  # the lengths are equal
                off = part(given, wanted)
                if off is None:
                    return None
                if off > worst:
                    worst = off
            return worst

        return quick

    def read(self, raw: Raw, question: Question, place: Place) -> Any:
        """A tuple of the parts' values."""
        found = items(raw)
        if found is None:
            name, wrong = place.name(), fault(raw)
            is_point = self.is_vector and wrong.type.startswith("complex")
            remedy = f"return a point as {self.noun}" if is_point else ""
            meant = f"{name} is meant to be {self.noun}" if name else f"{self.noun} is meant"
            raise Unreadable(wrong.where(meant, remedy))
        if len(found) != len(self.parts):
            name = place.name()
            what = (
                f"{len(found)} {'coordinate' if self.is_vector else 'part'}{'' if len(found) == 1 else 's'}"
            )
            raise Unreadable(f"{name or 'the answer'} has {what} where {self.noun} is meant")
        return tuple(
            [
                part.read(each, question, self._place(place, at))
                for at, (part, each) in enumerate(zip(self.parts, found, strict=True))
            ]
        )

    def _place(self, place: Place, at: int) -> Place:
        return Place(place, at, self.names[at])

    def matched(self, value: Any, target: Target, question: Question, place: Place) -> float:
        """The worst of the parts."""
        return max(
            part.held(given, wanted, question, self._place(place, at))
            for at, (part, given, wanted) in enumerate(zip(self.parts, value, target, strict=True))
        )

    def fits(self, value: Any, target: Target, question: Question, place: Place) -> bool:
        """Whether every part does."""
        return all(
            accepts(part, given, wanted, question, self._place(place, at))
            for at, (part, given, wanted) in enumerate(zip(self.parts, value, target, strict=True))
        )

    def take(self, tokens: Tokens) -> Raw:
        """The parts, one after the other."""
        return [part.take(tokens) for part in self.parts]

    def hint(self, words: Words) -> str:
        """The parts' own."""
        if self.is_vector:
            return " ".join(self.names)
        return ", ".join(part.hint(Words()) for part in self.parts)

    def printed_one(self, target: Target) -> Iterator[str]:
        """The parts' tokens."""
        for part, each in zip(self.parts, target, strict=True):
            yield from part.printed(each)

    def wanted_one(self, target: Target) -> str:
        """A tuple."""
        wanted = (part.wanted(each) for part, each in zip(self.parts, target, strict=True))
        return f"({', '.join(wanted)})"

    def shown(self, raw: Raw) -> str:
        """A tuple, if it has as many parts."""
        found = items(raw)
        if found is None or len(found) != len(self.parts):
            return super().shown(raw)
        return f"({', '.join(part.shown(each) for part, each in zip(self.parts, found, strict=True))})"

    def exact_text_one(self, exact: Exact) -> Any:
        """A list of the parts' texts."""
        return [part.exact_text(each) for part, each in zip(self.parts, exact, strict=True)]

    def accepted_one(self, target: Target) -> Any:
        """A list of what the parts accept."""
        return [part.accepted(each) for part, each in zip(self.parts, target, strict=True)]

    def asserts_one(self, what: str, target: Target) -> Iterator[str]:
        """The parts' own."""
        for at, (part, each) in enumerate(zip(self.parts, target, strict=True)):
            yield from part.asserts(f"{what}[{at}]", each)

    def form(self, value: Any, *, target: bool = False) -> str:
        """The parts' forms."""
        if self.is_vector:
            return "point"
        forms = (part.form(each, target=target) for part, each in self._firsts(value))
        return f"({', '.join(forms)})"

    def flat(self, value: Any, *, target: bool = False) -> Iterator[float]:
        """The parts' numbers."""
        for part, each in self._firsts(value):
            yield from part.flat(each, target=target)

    def _firsts(self, value: Any) -> Iterator[tuple[Type, Any]]:
        """Each part with its value; of several targets with the first."""
        return zip(self.parts, map(first_of, value), strict=True)

    # -- values of parameters ------------------------------------------------------------------------

    def fault(self, name: str, value: Any) -> str | None:
        """A tuple of as many parts, each as it should be."""
        if type(value) is not tuple or len(value) != len(self.parts):
            return f"{name} must be {self._several}, not {value!r}"
        return next(
            (
                wrong
                for part, each in zip(self.parts, value, strict=True)
                if (wrong := part.fault(name, each))
            ),
            None,
        )

    @property
    def _several(self) -> str:
        if all(part.width == 1 and part.annotation in ("float", "int") for part in self.parts):
            return "a pair of numbers" if len(self.parts) == 2 else f"{len(self.parts)} numbers"
        return f"a tuple {self.text}"

    def outside(self, value: Any, low: Fraction | int, high: Fraction | int) -> tuple[Any, Any, Any] | None:
        """The first part's that is outside."""
        for part, each in zip(self.parts, value):  # noqa: B905  # the lengths are equal
            found = part.outside(each, low, high)
            if found is not None:
                return found
        return None

    def reals(self, value: Any) -> Iterator[Number]:
        """Those of the parts."""
        for part, each in zip(self.parts, value, strict=True):
            yield from part.reals(each)

    def tokens(self, value: Any) -> Iterator[str]:
        """The parts' tokens."""
        for part, each in zip(self.parts, value, strict=True):
            yield from part.tokens(each)

    def from_tokens(self, tokens: Iterator[str]) -> Any:
        """The parts, one after the other."""
        return tuple([part.from_tokens(tokens) for part in self.parts])

    def listed(self, value: Any) -> Any:
        """A tuple of the parts' values."""
        return tuple([part.listed(each) for part, each in zip(self.parts, value, strict=True)])

    def argument(self, value: Any) -> Any:
        """A tuple of the parts' arguments."""
        if self.is_plain:
            return value
        return tuple([part.argument(each) for part, each in zip(self.parts, value, strict=True)])

    def literal(self, value: Any) -> str:
        """A tuple."""
        return f"({', '.join(part.literal(each) for part, each in zip(self.parts, value, strict=True))})"

    def simpler(self, value: Any) -> Iterator[Any]:
        """One part simpler."""
        for at, (part, each) in enumerate(zip(self.parts, value, strict=True)):
            for other in part.simpler(each):
                yield (*value[:at], other, *value[at + 1 :])

    def round(self, value: Any) -> Any:
        """The parts rounded."""
        return tuple([part.round(each) for part, each in zip(self.parts, value, strict=True)])

    def simple(self, draw: Draws, number: Callable[[bool], Number], *, positive: bool) -> Any:
        """Simple parts; a coordinate may always be negative."""
        return tuple(
            [part.simple(draw, number, positive=positive and not self.is_vector) for part in self.parts]
        )

    def aliases(self) -> Mapping[str, str]:
        """Its own, and those of the parts."""
        inner = {name: meant for part in self.parts for name, meant in part.aliases().items()}
        return inner | ({self._alias: self._spelled} if self._alias else {})


def vector(parts: Sequence[Type], alias: str) -> TupleType:
    """A tuple of coordinates, numbers of a type made for it."""
    for part in parts:
        part.noun = "a coordinate"
    return TupleType(parts, COORDINATES[: len(parts)], alias)


def is_pair(type_: Type) -> bool:
    """Whether values are points or vectors in the plane."""
    return isinstance(type_, TupleType) and type_.is_vector and len(type_.parts) == 2

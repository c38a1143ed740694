"""`[T]`, `[T; n]`, `[T; low..high]`: a list, its length bounded or not."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

from judge.values.decode import collecting, fault, items
from judge.values.elements import Wanted, elements
from judge.values.judged import first_of
from judge.values.likeness import Outline, Usual, only_digits, reordered
from judge.values.lines import Tokens
from judge.values.list_values import ListValues
from judge.values.outcome import Mismatch, Place, Unfit, Unreadable, Words
from judge.values.rightness import accepts
from judge.values.tolerance import Tolerance
from judge.values.tree import Exact, Run
from judge.values.type import (
    LONGEST,
    MANY_LENGTHS,
    NOTHING_MEASURED,
    Question,
    Quick,
    Raw,
    Target,
    Type,
)

if TYPE_CHECKING:
    from judge.values.interval import Roots

_SHOWN = 20  # items that are shown
_REORDERED = 64  # items up to which a wrong list is held against itself in another order


class ListType(ListValues, Type):
    """So many times `item`: from `low` to `high`, which is None where there is no bound."""

    item: Type
    width = None
    is_plain = False

    def __init__(self, item: Type, low: int = 0, high: int | None = None) -> None:
        if high is not None and not low <= high:
            raise ValueError("the bounds leave no length: low is above high")
        self.item = item
        self.low, self.high = low, high
        bounds = "" if high is None and not low else f"; {low}" if low == high else f"; {low}..{high}"
        self.text = f"[{item.text}{bounds}]"
        self.measured, self.settled = item.measured, item.settled
        self.is_parameter = item.is_parameter and not item.is_buffer
        self.depth = 1 + item.depth
        each = item.most + (item.depth > 0)
        self.most = LONGEST if high is None else high * each
        self.lengths = max(item.lengths, MANY_LENGTHS if high is None else high - low + 1)
        self.one, self.several = item.element
        self.noun, self.plural = f"a list of {item.plural}", "lists"
        self.variable = self.several
        self.annotation = f"list[{item.annotation}]"
        self._is_points = bool(getattr(item, "is_vector", False))
        if self.measured and item.rounded:
            self.rounded = self._rounding()

    def _rounding(self) -> str:
        if self._is_points:
            names: list[str] = self.item.names  # type: ignore[attr-defined]
            parts: list[Type] = self.item.parts  # type: ignore[attr-defined]
            rounded = (part.rounded.format(name) or name for part, name in zip(parts, names, strict=True))
            return f"[({', '.join(rounded)}) for {', '.join(names)} in {{0}}]"
        return f"[{self.item.rounded.format('item')} for item in {{0}}]"

    # -- exact answers and targets -------------------------------------------------------------------

    def aimed(self, exact: Exact, tolerance: Tolerance, roots: Roots) -> Target:
        """The items' targets, those of a run together."""
        if type(exact) not in (list, tuple):
            raise Unfit(f"{exact!r} where a list is meant")
        targets: list[Target] = []
        count = 0
        for each in exact:
            if isinstance(each, Run):
                targets.append({"run": [self.item.targeted(one, tolerance, roots) for one in each.items]})
                count += len(each.items)
            else:
                targets.append(self.item.targeted(each, tolerance, roots))
                count += 1
        if count < self.low or (self.high is not None and count > self.high):
            raise Unfit(f"{count} {self.one if count == 1 else self.several} where {self.bounds()} are meant")
        return tuple(targets)

    # -- deciding ------------------------------------------------------------------------------------

    @cached_property
    def quick(self) -> Quick:
        """All items, one after the other."""
        item = self.item.quick

        def quick(raw: Raw, target: Target) -> float | None:
            if type(raw) is dict:  # many numbers, sent as bytes; or what is no list at all
                found = items(raw)
                raw = None if found is None else list(found)
            if type(raw) is not list or type(target) is dict or len(raw) != len(target):
                return None
            worst = NOTHING_MEASURED
            for given, wanted in zip(raw, target):  # noqa: B905  # the lengths are equal
                off = item(given, wanted) if type(wanted) is not dict else _any(item, given, wanted)
                if off is None:
                    return None
                if off > worst:
                    worst = off
            return worst

        return quick

    def read(self, raw: Raw, question: Question, place: Place) -> Any:
        """A list of the items' values."""
        found = items(raw)
        if found is None or (self.item.depth and len(found) and self._is_one(found)):
            raise Unreadable(self._no_list(raw, found, place))
        if self.high is not None and len(found) > self.high and question.bounded:
            meant = f"where {self.bounds() if self.low == self.high else f'at most {self.high}'} are meant"
            raise Unreadable(f"{place.prefix()}{len(found)} {self.several} given {meant}")
        return [
            self.item.read(each, question, self._place(place, at, at, len(found)))
            for at, each in enumerate(found)
        ]

    def _is_one(self, found: Sequence[Raw]) -> bool:
        """Whether one item is given where a list of them is meant: (x, y) for [(x, y)]."""
        inner = getattr(self.item, "parts", ())
        return len(inner) == len(found) and all(
            type(each) in (int, float) or (type(each) is dict and items(each) is None) for each in found
        )

    def _no_list(self, raw: Raw, found: Sequence[Raw] | None, place: Place) -> str:
        name = place.name()
        meant = f"{name} is meant to be {self.noun}" if name else f"{self.noun} is meant"
        if raw is None:
            return f"None where {meant}" + (f": no {self.several} are []" if not self.low else "")
        if found is not None:
            what = f"a {self.one}" if self.one != "item" else self.shown_item(raw)
            return f"{what} where {meant}"
        wrong = fault(raw)
        return wrong.where(meant, collecting(wrong.type))

    def shown_item(self, raw: Raw) -> str:
        """One item, as its type shows it."""
        return self.item.shown(raw)

    def _place(self, place: Place, step: int, at: int, count: int) -> Place:
        alone = count == 1 and self.one == "point" and not place.name()
        return Place(place, step, f"{self.one} {at + 1}", alone=alone)

    def matched(self, value: Any, target: Target, question: Question, place: Place) -> float:
        """The worst of the items; those of a run in any order."""
        wanted = elements(target)
        if len(value) != len(wanted):
            raise Mismatch(place.prefix() + self._wrong_number(value, wanted, question, place), place.name())
        worst = NOTHING_MEASURED
        used: set[int] = set()
        for at, each in enumerate(value):
            try:
                worst = max(worst, self._held(each, at, wanted, used, question, place))
            except Mismatch:
                if self._is_reordered(value, wanted, question, place):
                    order = f": {question.words.order}" if question.words.order else ""
                    message = f"{place.prefix()}the right {self.several} in the wrong order{order}"
                    raise Mismatch(message) from None
                raise
        return worst

    def fits(self, value: Any, target: Target, question: Question, place: Place) -> bool:
        """Whether every item does, those of a run in any order."""
        wanted = elements(target)
        if len(value) != len(wanted):
            return False
        used: set[int] = set()
        for at, each in enumerate(value):
            for index in wanted[at].run:
                spot = self._at(place, wanted, index, at)
                if index not in used and accepts(self.item, each, wanted[index].target, question, spot):
                    used.add(index)
                    break
            else:
                return False
        return True

    def _held(
        self,
        each: Any,
        at: int,
        wanted: Sequence[Wanted],
        used: set[int],
        question: Question,
        place: Place,
    ) -> float:
        """How far off the item at `at` is; of a run it uses up the first element left that accepts it."""
        first: Mismatch | None = None
        for index in wanted[at].run:
            if index in used:
                continue
            try:
                spot = self._at(place, wanted, index, at)
                worst = self.item.held(each, wanted[index].target, question, spot)
            except Mismatch as why:
                first = first or why
                continue
            used.add(index)
            return worst
        assert first is not None  # a run has as many elements as places
        raise first

    def _at(self, place: Place, wanted: Sequence[Wanted], index: int, at: int) -> Place:
        """The place of a given item that is held against the wanted one at `index`."""
        steps = wanted[index].steps
        for step in steps[:-1]:
            place = Place(place, step, "")
        return self._place(place, steps[-1], at, len(wanted))

    def _wrong_number(
        self, value: Sequence[Any], wanted: Sequence[Wanted], question: Question, place: Place
    ) -> str:
        count = f"1 {self.one}" if len(wanted) == 1 else f"{len(wanted) or 'no'} {self.several}"
        message = f"{count} wanted, {len(value) or 'none'} given"
        if len(wanted) == 1 and len(value) == 2:
            at = self._at(place, wanted, 0, 0)
            if all(accepts(self.item, each, wanted[0].target, question, at) for each in value):
                message += f": the same {self.one} twice"
        return message

    def _is_reordered(
        self, value: Sequence[Any], wanted: Sequence[Wanted], question: Question, place: Place
    ) -> bool:
        """Whether every item given is one of those wanted, each of them once.

        Where an item fits in two places, as in a list of noughts and ones, order is not what is wrong.
        """
        if not 2 <= len(value) <= _REORDERED:
            return False
        taken: set[int] = set()
        for at, each in enumerate(value):
            fitting = [
                index
                for index in range(len(wanted))
                if accepts(
                    self.item, each, wanted[index].target, question, self._at(place, wanted, index, at)
                )
            ]
            if len(fitting) != 1:
                return False
            taken.update(fitting)
        return len(taken) == len(value)

    # -- lines of text -------------------------------------------------------------------------------

    def take(self, tokens: Tokens) -> Raw:
        """The length, and then the items."""
        ahead = tokens.ahead
        if ahead.lower() == "none":
            raise Unreadable(f'"{ahead}" where {self.hint(Words())} is meant: no {self.several} are 0')
        count = tokens.integer(f"the number of {self.several} k")
        if not self.low <= count or (self.high is not None and count > self.high):
            shown = str(count) if len(str(count)) <= 20 else f"{str(count)[:20]}…"
            raise Unreadable(f"k = {shown} where {self._range()} {self.several} are meant")
        if self.item.width is not None and tokens.root is self and tokens.left != count * self.item.width:
            noun = "coordinates" if self._is_points else "more"
            needed = f"k = {count} needs {count * self.item.width} {noun}"
            raise Unreadable(f"{needed}, {tokens.left} given")
        if count > tokens.left:
            raise Unreadable(f"the line ends too early: it holds {tokens.meant}")
        return [self.item.take(tokens) for _ in range(count)]

    def _range(self) -> str:
        if self.high is None:
            return f"{self.low} or more"
        return str(self.low) if self.low == self.high else f"{self.low} to {self.high}"

    def hint(self, words: Words) -> str:
        """The length and the first item."""
        if self._is_points:
            names: Sequence[str] = self.item.names  # type: ignore[attr-defined]
            return f"k {' '.join(f'{name}1' for name in names)} …"
        item = self.item.hint(Words())
        return f"k and then k times ({item})" if self.item.depth else f"k and then k times {item}"

    def printed_one(self, target: Target) -> Iterator[str]:
        """The length and the items' tokens."""
        wanted = elements(target)
        yield str(len(wanted))
        for each in wanted:
            yield from self.item.printed(each.target)

    # -- showing -------------------------------------------------------------------------------------

    def wanted_one(self, target: Target) -> str:
        """A list; a run is shown in its own order."""
        return listed([self.item.wanted(each.target) for each in elements(target)[: _SHOWN + 1]], target)

    def shown(self, raw: Raw) -> str:
        """A list, cut where it is long."""
        found = items(raw)
        if found is None or (self._is_one(found) and found):
            return super().shown(raw)
        return listed([self.item.shown(each) for each in found[: _SHOWN + 1]], found)

    def exact_text_one(self, exact: Exact) -> Any:
        """A list of the items' texts."""
        return [
            {"run": [self.item.exact_text(one) for one in each.items]}
            if isinstance(each, Run)
            else self.item.exact_text(each)
            for each in exact
        ]

    def accepted_one(self, target: Target) -> Any:
        """A list of what the items accept."""
        return [
            {"run": [self.item.accepted(one) for one in each["run"]]}
            if type(each) is dict and "run" in each
            else self.item.accepted(each)
            for each in target
        ]

    def asserts_one(self, what: str, target: Target) -> Iterator[str]:
        """The length and the items; each element of a run is somewhere among those in its place."""
        wanted = elements(target)
        yield f"len({what}) == {len(wanted)}"
        for at, each in enumerate(wanted):
            if len(each.run) == 1:
                yield from self.item.asserts(f"{what}[{at}]", each.target)
            else:
                first, last = each.run[0], each.run[-1]
                held = " and ".join(self.item.asserts("item", each.target))
                yield f"any({held} for item in {what}[{first}:{last + 1}])"

    # -- telling one mistake from another ------------------------------------------------------------

    def form(self, value: Any, *, target: bool = False) -> str:
        """How many items; where they are no plain numbers or points, their forms too."""
        found = [first_of(each.target) for each in elements(value)] if target else value
        forms = [self.item.form(each, target=target) for each in found[:LONGEST]]
        if set(forms) <= {"point", "number", "count"}:
            return f"{self.several} {len(found)}"
        return f"{self.several} {len(found)} {' '.join(forms)}"

    def flat(self, value: Any, *, target: bool = False) -> Iterator[float]:
        """The items' numbers."""
        for each in [first_of(each.target) for each in elements(value)] if target else value:
            yield from self.item.flat(each, target=target)

    def kind(self, given: Outline, right: Outline, usual: Usual) -> str:
        """Fewer or more items, the right ones in another order, other digits, others."""
        (form, numbers), (wanted_form, wanted) = given, right
        name = form.partition(" ")[0]
        if name != self.several or not wanted_form.startswith(f"{name} "):
            return form
        count, size = (int(each.split(" ", 2)[1]) for each in (form, wanted_form))
        if count != size:
            return f"{'fewer' if count < size else 'more'} {count}"
        if len(numbers) != len(wanted):
            return form
        if only_digits(numbers, wanted) and form == wanted_form:
            return "digits"
        if reordered(numbers, wanted, count):
            return "reordered"
        return "elsewhere" if form == wanted_form else form


def _any(item: Quick, given: Raw, wanted: Target) -> float | None:
    """The first of several targets that accepts an item; a run is none of them."""
    return next((off for each in wanted.get("any", ()) if (off := item(given, each)) is not None), None)


def listed(shown: list[str], whole: Sequence[Any]) -> str:
    """The text of a list whose first items are `shown`, one more than fit if there are more."""
    if len(shown) > _SHOWN:
        shown = [*shown[:_SHOWN], "…"]
        return f"[{', '.join(shown)}] ({len(whole):,} items)"
    return f"[{', '.join(shown)}]"

"""Answers and targets as a person, or a program, writes them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import islice, starmap
from typing import Any

from judge.values.answers import AnyOf, Called, Exact, Judged, Real, Target
from judge.values.atoms import Atom, Type, Value
from judge.values.parameters import tokens
from judge.values.types import Composite, DictType, ListType, TupleType, lasting
from judge.values.wire import Raw, cut, items, show

_ANSWERS = 3  # of several that are right, which are shown
_ITEMS = 20  # of a list, which are shown
_TOKEN = 1_100  # characters: an int may have as many


def best(type_: Type, target: Target) -> Value:
    """The value of a perfect answer: of several the first, the sample, and the nearest doubles."""
    if type(target) is dict:
        return best(type_, target["any"][0] if "any" in target else target["such as"])
    if target is None:
        return None
    inner = lasting(type_)
    return inner.best(target) if isinstance(inner, Atom) else inner.kind(starmap(best, inner.pairs(target)))


def line(type_: Type, target: Target) -> str:
    """The line that a perfect program prints, doubles as repr writes them."""
    return " ".join(tokens(type_, best(type_, target)))


def wanted_line(type_: Type, target: Target) -> str:
    """The same as it is shown: a long text is cut."""
    return " ".join([cut(each, _TOKEN) for each in tokens(type_, best(type_, target))])


def wanted(type_: Type, target: Target) -> str:
    """The wanted answer as a person would write it in Python, its numbers correctly rounded."""
    if type(target) is dict:
        if "such as" in target:
            return f"such as {wanted(type_, target['such as'])}"
        answers, most = target["any"], 1 if isinstance(lasting(type_), ListType) else _ANSWERS
        several = [wanted(type_, each) for each in answers[:most]]
        return " or ".join(several + ["…"] * (len(answers) > most))
    if target is None:
        return "None"
    inner = lasting(type_)
    if isinstance(inner, Atom):
        return inner.shown(inner.best(target))
    return _bracketed(wanted, inner, target)


def shown(type_: Type, raw: Raw) -> str:
    """An answer, as JSON or read, as a person would write it, bounded whatever its shape."""
    inner = lasting(type_)
    found = items(raw) if isinstance(inner, Atom) else inner.found(raw)
    if found is None or isinstance(inner, Atom) or is_one_item(inner, found):
        return show(raw)
    if isinstance(inner, TupleType) and len(found) != len(inner.made_of):
        return show(raw)
    return _bracketed(shown, inner, found)


def is_one_item(type_: Composite, found: Sequence[Raw]) -> bool:
    """Whether one item is given where a list of them is expected: (x, y) for [(x, y)]."""
    if not isinstance(type_, ListType) or not isinstance(type_.item, TupleType):
        return False
    given = [type(each) for each in found]
    return (
        len(type_.item.made_of) == len(found)
        and {*given} != {dict}
        and all(type(each) in (int, float) or (type(each) is dict and items(each) is None) for each in found)
    )


def _bracketed(tell: Callable[[Type, Any], str], type_: Composite, values: Sequence[Any]) -> str:
    if isinstance(type_, TupleType):
        return f"({', '.join(starmap(tell, type_.pairs(values)))})"
    if isinstance(type_, DictType):
        kinds = type_.key, type_.value
        first, last, parts = "{", "}", map(": ".join, (map(tell, kinds, each) for each in values))
    else:
        first, last, parts = "[", "]", map(tell, type_.parts(len(values)), values)
    text, count = ", ".join(islice(parts, _ITEMS)), len(values)
    end = last if count <= _ITEMS else f", …{last} ({count:,} {'entries' if last == '}' else 'items'})"
    return f"{first}{text}{end}"


def exact_text(exact: Exact) -> Any:
    """An exact answer as JSON: numbers that are not ints as decimal text of up to 40 digits."""
    if isinstance(exact, AnyOf):
        return {"any": exact_text(exact.answers)}
    if isinstance(exact, Judged):
        return {"such as": exact_text(exact.sample)}
    if isinstance(exact, Called):
        return exact_text(exact.answer)
    if isinstance(exact, Real):
        from judge.exact import Surd

        return Surd.of(exact.x).decimal(40)
    if isinstance(exact, dict):
        exact = sorted(exact.items())
    return list(map(exact_text, exact)) if isinstance(exact, list | tuple) else exact


def accepted(type_: Type, target: Target) -> Any:
    """What is accepted, as JSON: for each real number the least and the greatest double."""
    if type(target) is dict:
        if "any" in target:
            return {"any": [accepted(type_, each) for each in target["any"]]}
        return {"such as": accepted(type_, target["such as"])}
    inner = lasting(type_)
    if target is not None and not isinstance(inner, Atom):
        return list(starmap(accepted, inner.pairs(target)))
    return inner.accepted(target) if target is not None and isinstance(inner, Atom) else target

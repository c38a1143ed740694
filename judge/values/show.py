"""Answers and targets as a person, or a program, writes them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice
from typing import Any

from judge.values.answers import AnyOf, Exact, Judged, Run
from judge.values.base import Atom, Target, Type
from judge.values.types import Composite, ListType, OptionalType, TupleType
from judge.values.wire import Raw, items, show

_ANSWERS = 3  # of several that are right, which are shown
_ITEMS = 20  # of a list, which are shown


def first_of(target: Target) -> Target:
    """The target, of several the first, and of those that the problem itself accepts the sample."""
    while type(target) is dict and "run" not in target:
        target = target["any"][0] if "any" in target else target["such as"]
    return target


def flat_runs(targets: Sequence[Target]) -> Iterator[Target]:
    """The elements of a tuple's or a list's target, those of runs among them."""
    for each in targets:
        if type(each) is dict and "run" in each:
            yield from each["run"]
        else:
            yield each


def wanted(type_: Type, target: Target) -> str:
    """The wanted answer as a person would write it in Python, its numbers correctly rounded."""
    if type(target) is dict:
        if "such as" in target:
            return f"such as {wanted(type_, target['such as'])}"
        answers = target["any"]
        several = [wanted(type_, each) for each in answers[:_ANSWERS]]
        return " or ".join(several + ["…"] * (len(answers) > _ANSWERS))
    if target is None:
        return "None"
    if isinstance(type_, OptionalType):
        return wanted(type_.inner, target)
    if isinstance(type_, Atom):
        return type_.shown_target(target)
    assert isinstance(type_, Composite)
    every = list(flat_runs(target))
    return _bracketed(type_, map(wanted, type_.parts(len(every)), every), len(every))


def shown(type_: Type, raw: Raw) -> str:
    """An answer, as JSON or read, as a person would write it, bounded whatever its shape."""
    from judge.values.check import is_one_item

    if isinstance(type_, OptionalType):
        return "None" if raw is None else shown(type_.inner, raw)
    if isinstance(type_, Atom):
        return type_.shown(raw)
    found = items(raw)
    if found is None or (isinstance(type_, TupleType) and len(found) != len(type_.fixed)):
        return show(raw)
    if isinstance(type_, ListType) and len(found) and is_one_item(type_, found):
        return show(raw)
    assert isinstance(type_, Composite)
    return _bracketed(type_, map(shown, type_.parts(len(found)), found), len(found))


def _bracketed(type_: Composite, parts: Iterator[str], count: int) -> str:
    if isinstance(type_, TupleType):
        return f"({', '.join(parts)})"
    text = ", ".join(islice(parts, _ITEMS))
    return f"[{text}]" if count <= _ITEMS else f"[{text}, …] ({count:,} items)"


def line(type_: Type, target: Target) -> str:
    """The line that a perfect program prints: of several answers the first, doubles as repr writes them."""
    return " ".join(_printed(type_, target))


def _printed(type_: Type, target: Target) -> Iterator[str]:
    target = first_of(target)
    if target is None:
        yield "none"
    elif isinstance(type_, OptionalType):
        yield from _printed(type_.inner, target)
    elif isinstance(type_, Atom):
        yield type_.token(target)
    else:
        assert isinstance(type_, Composite)
        every = list(flat_runs(target))
        if isinstance(type_, ListType):
            yield str(len(every))
        for part, each in zip(type_.parts(len(every)), every, strict=True):
            yield from _printed(part, each)


def exact_text(type_: Type, exact: Exact) -> Any:
    """An exact answer as JSON: numbers that are not ints as decimal text of up to 40 digits."""
    if isinstance(exact, AnyOf):
        return {"any": [exact_text(type_, each) for each in exact.answers]}
    if isinstance(exact, Judged):
        return {"such as": exact_text(type_, exact.sample)}
    if isinstance(exact, Run):
        return {"run": [exact_text(type_, each) for each in exact.items]}
    if isinstance(type_, OptionalType):
        return None if exact is None else exact_text(type_.inner, exact)
    if isinstance(type_, Atom):
        return type_.exact_text(exact)
    assert isinstance(type_, Composite)
    return list(map(exact_text, type_.parts(len(exact)), exact))


def accepted(type_: Type, target: Target) -> Any:
    """What is accepted, as JSON: for each real number the least and the greatest double."""
    if type(target) is dict:
        ((name, inner),) = target.items()
        return {
            name: accepted(type_, inner) if name == "such as" else [accepted(type_, each) for each in inner]
        }
    if isinstance(type_, OptionalType):
        return None if target is None else accepted(type_.inner, target)
    if isinstance(type_, Atom):
        return type_.accepted(target)
    assert isinstance(type_, Composite)
    return list(map(accepted, type_.parts(len(target)), target))


def asserts(type_: Type, what: str, target: Target) -> Iterator[str]:
    """Python conditions on the expression `what`, all of which hold exactly for a right answer.

    Of what the problem itself accepts only the judge can say.
    """
    if type(target) is dict:
        if "any" in target:
            ways = [" and ".join(asserts(type_, what, each)) for each in target["any"]]
            yield " or ".join(f"({way})" for way in ways)
    elif isinstance(type_, OptionalType):
        if target is None:
            yield f"{what} is None"
        else:
            yield from asserts(type_.inner, what, target)
    elif isinstance(type_, Atom):
        yield type_.asserts(what, target)
    else:
        assert isinstance(type_, Composite)
        count = 0
        every = len(list(flat_runs(target)))
        if isinstance(type_, ListType):
            yield f"len({what}) == {every}"
        for part, each in zip(type_.parts(len(target)), target, strict=True):
            run = each["run"] if type(each) is dict and "run" in each else None
            if run is None:
                yield from asserts(part, f"{what}[{count}]", each)
            else:  # each element of a run is somewhere among those in its place
                for one in run:
                    held = " and ".join(asserts(part, "item", one))
                    yield f"any({held} for item in {what}[{count}:{count + len(run)}])"
            count += 1 if run is None else len(run)

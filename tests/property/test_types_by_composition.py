"""Every type that the language makes reads what it writes; the exact answer is right, an ulp more is not."""

from __future__ import annotations

import ast
import json
import math
from fractions import Fraction
from re import ASCII, fullmatch, search
from types import SimpleNamespace
from typing import Any, NamedTuple

import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from judge.diagnose.candidates import measure
from judge.diagnose.replay import _from_values
from judge.diagnose.replay import encode as encode_id
from judge.exact import Surd
from judge.problem import Parameter
from judge.sandbox.calls import text as to_driver
from judge.sandbox.encode import encode
from judge.values import check, outline, reading, show
from judge.values import parameters as own
from judge.values.answers import Real, Tolerance
from judge.values.check import Accepted, Rejection
from judge.values.grammar import parse
from judge.values.wire import tokens

pytestmark = pytest.mark.slow

TOLERANCE = Tolerance(extent=Fraction(1, 10**9), relative=Fraction(1, 10**12), ulps=Fraction(1))
WORDS = ("lit", "dark", "run", "any")
SLOW = settings(max_examples=30, deadline=None, suppress_health_check=list(HealthCheck))


class Kind(NamedTuple):
    """A type's text, its exact answers, and its values as a parameter."""

    text: str
    exact: st.SearchStrategy[Any]
    values: st.SearchStrategy[Any]


ints = st.integers(-(10**30), 10**30)
surds = st.builds(
    lambda p, q, d, s: Surd(p, q, d, s),
    st.integers(-(10**9), 10**9),
    st.integers(-99, 99),
    st.integers(0, 10**6),
    st.integers(1, 10**4),
)
reals = st.tuples(surds, st.fractions(0, 1000, max_denominator=64)).map(lambda pair: Real(*pair))
floats = st.floats(allow_nan=False, allow_infinity=False)
numbers = st.one_of(floats, ints)
words = st.sampled_from(WORDS)
signs = st.sampled_from('ab "\\%,:=-~\n') | st.characters(min_codepoint=32, max_codepoint=126)
texts = st.text(signs, max_size=9)
small = st.integers(-5, 9)
unit = st.floats(0, 1)

ATOMS = [
    Kind("text(0..9)", texts, texts),
    Kind("bool", st.booleans(), st.booleans()),
    Kind("int(-5..9)", small, small),
    Kind("real(0..1)", st.fractions(0, 1).map(Real), unit),
    Kind("int", ints, ints),
    Kind("real", reals, numbers),
    Kind(f"word({'|'.join(WORDS)})", words, words),
    Kind("vec2", st.tuples(reals, reals), st.tuples(numbers, numbers)),
    Kind("vec3", st.tuples(reals, reals, reals), st.tuples(numbers, numbers, numbers)),
]
ARRAYS = Kind("array(f64; 5)", st.nothing(), st.lists(floats, max_size=5).map(tuple))


def optional(kind: Kind) -> Kind:
    if "?" in kind.text:
        return kind
    return Kind(f"{kind.text}?", st.none() | kind.exact, st.none() | kind.values)


def several(parts: list[Kind]) -> Kind:
    return Kind(
        f"({', '.join(part.text for part in parts)})",
        st.tuples(*(part.exact for part in parts)),
        st.tuples(*(part.values for part in parts)),
    )


def listed(kind: Kind, bounds: tuple[int, int] | None) -> Kind:
    low, high = bounds or (0, 4)
    text = f"[{kind.text}]" if bounds is None else f"[{kind.text}; {low}..{high}]"
    exact, values = (st.lists(each, min_size=low, max_size=high) for each in (kind.exact, kind.values))
    return Kind(text, exact, values.map(tuple))


def keyed(key: Kind, kind: Kind, bounds: tuple[int, int] | None) -> Kind:
    low, high = bounds or (0, 4)
    text = f"{{{key.text}: {kind.text}}}" if bounds is None else f"{{{key.text}: {kind.text}; {low}..{high}}}"
    exact, values = (
        st.dictionaries(key.values, each, min_size=low if low < 2 else 0, max_size=high).filter(
            lambda found: low <= len(found) <= high
        )
        for each in (kind.exact, kind.values)
    )
    return Kind(text, exact, values.map(lambda found: tuple(sorted(found.items()))))


KEYS = [each for each in ATOMS if each.text[:4] in ("text", "int(", "word", "bool")]
bounds = st.none() | st.tuples(st.integers(0, 2), st.integers(2, 4))
kinds = st.recursive(
    st.sampled_from(ATOMS),
    lambda inner: st.one_of(
        inner.map(optional),
        st.lists(inner, min_size=2, max_size=3).map(several),
        st.builds(listed, inner, bounds),
        st.builds(keyed, st.sampled_from(KEYS), inner, bounds),
    ),
    max_leaves=5,
)
answers = kinds.flatmap(lambda kind: st.tuples(st.just(kind.text), kind.exact))
parameters = (kinds | st.sampled_from((ARRAYS, optional(ARRAYS)))).flatmap(
    lambda kind: st.tuples(st.just(kind.text), kind.values)
)


def given_for(exact: Any, target: Any) -> Any:
    """What a perfect function returns: the correctly rounded doubles of the exact answer."""
    if isinstance(exact, Real):
        return target[2]
    if isinstance(exact, dict):
        return {key: given_for(exact[key], each) for key, each in target}
    if isinstance(exact, tuple | list):
        return type(exact)(map(given_for, exact, target))
    return exact


def journey(value: Any) -> Any:
    """A submission's value as it arrives."""
    return json.loads(json.dumps(encode(value)))


def judged(text: str, exact: Any, raw: Any) -> Any:
    type_ = parse(text)
    target = check.target(type_, exact, TOLERANCE)
    outcome = check.check(type_, raw, target, lambda: (exact, TOLERANCE))
    said = check.is_right(type_, raw, target, lambda: (exact, TOLERANCE))
    assert said == isinstance(outcome, Accepted)  # without words it is the same
    return outcome


@SLOW
@given(answers)
def test_the_exact_answer_is_accepted_in_every_form_and_read_as_it_is_written(answer):
    text, exact = answer
    type_ = parse(text)
    target = check.target(type_, exact, TOLERANCE)
    perfect = journey(given_for(exact, target))
    assert isinstance(judged(text, exact, perfect), Accepted)
    kept = json.loads(json.dumps(target))
    assert isinstance(check.check(type_, perfect, kept, lambda: (exact, TOLERANCE)), Accepted)
    assert show.wanted(type_, kept) == show.wanted(type_, target)
    line = show.line(type_, target)
    assert isinstance(check.check_line(type_, line, target, lambda: (exact, TOLERANCE)), Accepted)
    json.dumps([show.exact_text(exact), show.accepted(type_, target)])
    assert outline.outline(type_, perfect) == outline.right(type_, target)
    read = reading.read_line(type_, line)
    assert not isinstance(read, str)
    assert outline.outline(type_, read[0]) == outline.right(type_, target)


def leaves(type_: Any, target: Any, given: Any, words: tuple[str, ...] = ()) -> Any:
    """Every real number in an answer: the words of its place, its target, and the answer with another one."""
    name = type(type_).__name__
    if name == "OptionalType" and target is not None:
        yield from leaves(type_.inner, target, given, words)
    elif name == "RealType":
        yield words, target, lambda other: other
    elif name in ("TupleType", "ListType"):
        for at, (one, each) in enumerate(zip(target, given, strict=True)):
            if name == "TupleType":
                part, word = type_.made_of[at], type_.names[at]
            else:
                part, word = type_.item, f"{type_.one} {at + 1}"
            for place, bounds_of, changed in leaves(part, one, each, (word, *words)):
                yield place, bounds_of, lambda x, at=at, f=changed: [*given[:at], f(x), *given[at + 1 :]]


@SLOW
@given(answers, st.data())
def test_one_ulp_outside_is_refused_and_its_place_is_named(answer, data):
    text, exact = answer
    type_ = parse(text)
    target = check.target(type_, exact, TOLERANCE)
    given = journey(given_for(exact, target))
    found = list(leaves(type_, target, given))
    assume(found)
    words, (low, high, *_), changed = data.draw(st.sampled_from(found))
    assert isinstance(judged(text, exact, changed(high)), Accepted)
    assert isinstance(judged(text, exact, changed(low)), Accepted)
    name, around = words, given
    while name[-1:] == ("point 1",) and len(around) == 1:  # an only point needs no number
        name, around = name[:-1], around[0]
    for outside in (math.nextafter(high, math.inf), math.nextafter(low, -math.inf)):
        outcome = judged(text, exact, changed(outside))
        assert isinstance(outcome, Rejection)
        if outcome.where:  # not the right items in another order
            assert outcome.where == (" of ".join(name) or "the answer")
            assert outcome.absolute is not None


@SLOW
@given(answers, st.data())
def test_any_other_shape_is_refused_and_never_raises(answer, data):
    text, exact = answer
    raw = data.draw(
        st.recursive(
            st.one_of(st.none(), st.booleans(), numbers, st.text(max_size=3)),
            lambda inner: (
                st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=3), inner, max_size=2)
            ),
            max_leaves=6,
        )
    )
    type_ = parse(text)
    outcome = judged(text, exact, raw)
    assert isinstance(outcome, Accepted | Rejection)
    assert isinstance(outline.outline(type_, raw)[0], str)
    if isinstance(outcome, Rejection):
        assert outcome.message.isprintable()


def tupled(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: tupled(each) for key, each in value.items()}
    return tuple(map(tupled, value)) if isinstance(value, list | tuple) else value


@SLOW
@given(parameters)
def test_parameters_go_through_text_and_json(parameter):
    text, value = parameter
    type_ = parse(text)
    assert own.fault(type_, "p", value) is None
    words = list(own.tokens(type_, value))
    line = " ".join(words)
    assert line.isascii()
    assert "\n" not in line
    assert tokens(line) == words
    again = own.from_tokens(type_, iter(words))
    assert repr(again) == repr(value)
    problem: Any = SimpleNamespace(id="any", parameters=[Parameter("p", type_, "")])
    replay = encode_id(problem, SimpleNamespace(name="some"), (value,))
    assert fullmatch(r"[\w.:+,%~-]+", replay, ASCII)
    assert repr(_from_values(replay.split(":")[2][1:], problem)) == repr((value,))
    sent = to_driver([(own.argument(type_, value),)])
    assert fullmatch(rb"1 0\n[\w.+=-]*( [\w.+=-]+)*\n", sent)
    assert repr(tupled(json.loads(json.dumps(value)))) == repr(value)
    if "array" not in text:
        written = tupled(ast.literal_eval(own.literal(type_, value)))
        assert repr(own.kept(type_, written)) == repr(value)
    for simpler in own.simpler(type_, value):
        assert own.fault(type_, "p", simpler) is None
        assert not [each for atom, each in own.leaves(type_, simpler) if atom.beyond(each)]
        if not search(r"real|vec|array", type_.text):  # of numbers as large as these nothing is summed
            assert measure((simpler,)) <= measure((value,))
    for atom, leaf in own.leaves(type_, value):
        assert all(measure((each,)) < measure((leaf,)) for each in atom.simpler(leaf))

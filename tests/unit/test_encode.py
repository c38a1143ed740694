"""Answers encoded inside the containment, and read back outside."""

from __future__ import annotations

import decimal
import enum
import fractions
import json
import sys
import typing
import warnings
from array import array
from collections import Counter, OrderedDict, defaultdict

import numpy as np
import pytest

from judge.sandbox.encode import MOST_CHARACTERS, MOST_ITEMS, MOST_TEXT, encode
from judge.values.wire import LONGEST_TEXT, Refusal, Written, exactly, fault, number, numbers


def through(value):
    """`value` after the whole journey."""
    return json.loads(json.dumps(encode(value), allow_nan=False))


def wrong(name, text=""):
    return {"type": name, "text": text}


class Point(typing.NamedTuple):
    x: float
    y: float


class Liar(list):
    def __iter__(self):
        return iter([1])


class LyingDict(dict):
    def __getitem__(self, key):
        return 3


class LyingTuple(tuple):
    __slots__ = ()

    def __len__(self):
        return 2


class MyFloat(float):
    def __le__(self, other):
        return True


class MyText(str):
    def __eq__(self, other):
        return True

    __hash__ = str.__hash__


class Colour(enum.IntEnum):
    RED = 1


class Loud:
    def __repr__(self):
        raise RuntimeError("repr was called")

    __str__ = __hash__ = __eq__ = __float__ = __iter__ = __len__ = __repr__


@pytest.mark.parametrize(
    ("value", "form"),
    [
        (None, None),
        (-(2**63), -(2**63)),
        (2**63, {"int": "8000000000000000"}),
        (-(2**70), {"int": "-400000000000000000"}),
        (0.1, 0.1),
        ([], []),
        ([(1, 2.5), (3.0, 4)], [[1, 2.5], [3.0, 4]]),
        (((1, 2), [3, 4]), [[1, 2], [3, 4]]),
        (Point(1, 2.0), [1, 2.0]),
        (decimal.Decimal("NaN"), {"decimal": "NaN"}),
        (True, True),
        ([True, None], [True, None]),
        (float("nan"), wrong("float", "nan")),
        (float("-inf"), wrong("float", "-inf")),
        ("1", {"word": "1"}),
        ("a\nb\0\x1b\xe9\ud800", {"word": "a\nb\0\x1b\xe9\ud800"}),
        (MyText("a"), wrong("MyText", "a subclass of str")),
        (((1, 2),), {"tuple": [[1, 2]]}),
        (array("d", [1.5, 2]), [1.5, 2.0]),
        (b"1", wrong("bytes", "b'1'")),
        (1 + 2j, wrong("complex", "(1+2j)")),
        (Liar([1]), wrong("Liar", "a subclass of list with its own way of reading it")),
        (LyingTuple((1,)), wrong("LyingTuple", "a subclass of tuple with its own way of reading it")),
        (MyFloat(1.0), wrong("MyFloat", "a subclass of float")),
        (Colour.RED, wrong("Colour", "a subclass of int")),
        ({1: 2}, {"dict": [[1, 2]]}),
        (Counter("aba"), {"dict": [[{"word": "a"}, 2], [{"word": "b"}, 1]]}),
        (defaultdict(list, {1: [2]}), {"dict": [[1, [2]]]}),
        (OrderedDict({2: 1, 1: ()}), {"dict": [[2, 1], [1, []]]}),
        (LyingDict({1: 2}), wrong("LyingDict", "a subclass of dict with its own way of reading it")),
        ((i for i in range(3)), wrong("generator")),
        (Loud(), wrong("Loud")),
        (2**5000, wrong("int", "5001 bits long")),
    ],
)
def test_forms(value, form):
    assert through(value) == form


def test_a_text_is_sent_whole_or_said_to_be_too_long():
    assert MOST_CHARACTERS == LONGEST_TEXT
    whole = "a" * MOST_CHARACTERS
    assert through(whole) == {"word": whole}
    said = "a text of 1,000,001 characters, more than 1,000,000"
    assert through(f"{whole}b") == wrong("str", said)
    assert fault(through(f"{whole}b")).text == f"{said},"
    assert through(b"a" * 10**7)["text"].startswith("b'aaa")


def test_the_texts_of_an_answer_share_what_may_be_sent():
    half = "a" * (MOST_CHARACTERS // 2)
    first, second, third = through([half, half, "b"])
    assert first == second == {"word": half}
    assert fault(third).text == "a text of more than 1,000,000 characters in all its parts,"
    assert through([["a"], "b"]) == [[{"word": "a"}], {"word": "b"}]  # nor is that kept for the next answer


@pytest.mark.parametrize(
    ("value", "form"),
    [
        (np.float64(0.1), 0.1),
        (np.float32(0.1), float(np.float32(0.1))),
        (np.uint64(2**64 - 1), {"int": "f" * 16}),
        (np.bool_(True), True),
        (np.array([True, False]), [True, False]),
        (np.zeros(2000, dtype=bool), [False] * 2000),
        (np.float64("nan"), wrong("float64", "nan")),
        (np.complex128(1j), wrong("complex128", "1j")),
        (np.str_("1"), wrong("str_", "")),
        (np.array([[1.5, 2], [3, 4]]), [[1.5, 2.0], [3.0, 4.0]]),
        ([np.array([1.0, 2.0]), (np.float64(3), np.int8(4))], [[1.0, 2.0], [3.0, 4]]),
        (np.array([None, 0.5], dtype=object), [None, 0.5]),
        (np.longdouble(1) / 3 * 0 + 2, 2.0),
        (np.array(3.5), 3.5),
    ],
)
def test_numpy_counts_as_the_numbers_it_holds(value, form):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert through(value) == form


def test_a_class_that_is_derived_from_numpys_or_only_calls_itself_so_is_a_wrong_type():
    assert through(type("Mine", (np.float64,), {})(1.0))["type"] == "Mine"
    assert through(np.zeros(2).view(type("Rows", (np.ndarray,), {})))["type"] == "Rows"
    forged = type("float64", (), {"__module__": "numpy", "dtype": None, "item": lambda self: 1.0})
    assert through(forged()) == wrong("float64")


def test_bounds_of_depth_and_items():
    cyclic: list = [1]
    cyclic.append(cyclic)
    text = json.dumps(encode(cyclic))
    assert "nested more than" in text
    assert len(text) < 1000
    wide: list = [0] * 50
    wide[:] = [wide] * 50
    assert len(json.dumps(encode(wide))) < 100 * MOST_ITEMS
    many = wrong("list", f"of more than {MOST_ITEMS} items")
    assert through([(0, 0)] * (MOST_ITEMS // 3 + 1)) == [[0, 0]] * (MOST_ITEMS // 3) + [many]
    assert through([None] * (MOST_ITEMS + 1)) == many
    assert encode([None] * 5, 4) == wrong("list", "of more than 4 items")
    assert encode([None] * (MOST_ITEMS + 1), MOST_ITEMS + 1) == [None] * (MOST_ITEMS + 1)
    assert len(through(b"x" * 10**6)["text"]) <= MOST_TEXT
    assert len(through(type("N" * 10**5, (), {})())["type"]) <= 80


@pytest.mark.parametrize(
    ("value", "code"),
    [
        ([3] * 2000, "b"),
        ([0.5] * 2000, "d"),
        (array("b", [3] * 2000), "b"),
        (array("H", [40_000] * 2000), "i"),
        (np.full(2000, 3, dtype=np.int8), "b"),
        (np.full(2000, 1 << 63, dtype=np.uint64), "Q"),
        (np.full(4000, 0.5)[::2], "d"),
        ([3] * 2000 + [1 << 40], "q"),
        (np.full(2000, 128), "h"),
        (np.full(2000, 0.5, dtype=">f8"), "d"),
    ],
)
def test_many_numbers_of_one_type_are_sent_as_bytes(value, code):
    sent = through(value)
    assert list(sent) == ["array"]
    assert sent["array"][0] == code
    assert numbers(sent).tolist() == [float(each) for each in value]


def test_nothing_foreign_runs(monkeypatch):
    class Meta(type):
        def __getattribute__(cls, name):
            raise RuntimeError("the metaclass was asked")

    class Strange(metaclass=Meta):
        pass

    assert through(Strange()) == wrong("Strange")
    forged = type("Fraction", (), {"numerator": property(lambda self: 1 / 0)})
    monkeypatch.setattr(fractions, "Fraction", forged)
    assert through(forged()) == wrong("Fraction", "reading it raised ZeroDivisionError")
    broken = type(sys)("numpy")
    broken.ndarray, broken.generic = forged, 5
    monkeypatch.setitem(sys.modules, "numpy", broken)
    assert through(Strange())["type"] == "Strange"


@pytest.mark.parametrize(
    "value",
    [0, 5, -7, 2**64, -(2**4000), 0.1, 5e-324, fractions.Fraction(1, 3), fractions.Fraction(-(2**90), 7)],
)
def test_numbers_come_back_exactly_and_decimals_or_they_are_refused(value):
    read = number(through(value))
    assert (type(read), read) == (type(value), value)
    read = number(through(decimal.Decimal("-12.5e-3")))
    assert isinstance(read, Written)
    assert exactly(read) == fractions.Fraction(-1, 80)
    for text in ("NaN", "Infinity", "1e999999", "-1e-999999"):
        assert isinstance(number(through(decimal.Decimal(text))), Refusal)

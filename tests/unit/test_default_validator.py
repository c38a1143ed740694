"""The default output validator of Kattis, as the C++ program is: spaces, letters, numbers, nearness."""

from __future__ import annotations

import pytest

from judge.packs.foreign.tokens import BadFlagsError, as_number, difference, rules_of

NEAR = ("float_tolerance", "1e-6")

CASES = [  # arguments, answer, output, whether it is accepted
    ((), b"1 2\n", b"1\n\n 2", True),
    ((), b"1 2\n", b"1\x0b2\x0c\r\t\n", True),
    ((), b"1 2", b"1\x1c2", False),  # a space to Python's text, not to C
    ((), b"1 2", b"1\x852", False),
    ((), b"1 2", b"1\xc2\xa02", False),
    ((), b"1", b"", False),
    ((), b"1", b" \n", False),
    ((), b"", b"\n ", True),
    ((), b"", b"x", False),
    ((), b"1", b"1 1", False),
    ((), b"Yes", b"yES", True),
    ((), b"\xc3\xa9", b"\xc3\x89", False),  # only A to Z have another case
    ((), b"1.0", b"1", False),
    (("case_sensitive",), b"Yes", b"yes", False),
    (("case_sensitive",), b"Yes", b"Yes", True),
    ((), b"a\0b", b"a", True),  # a C string ends at its NUL
    ((), b"a\0b", b"A\0c", True),
    ((), b"ab", b"a\0b", False),
    (("space_change_sensitive",), b"1 2\n", b"1 2\n", True),
    (("space_change_sensitive",), b"1 2\n", b"1 2", False),
    (("space_change_sensitive",), b"1 2\n", b"1  2\n", False),
    (("space_change_sensitive",), b"1 2", b"1 2\n", False),
    (("space_change_sensitive",), b"1 2", b" 1 2", False),
    (("space_change_sensitive",), b"1\r\n", b"1\n", False),
    (("space_change_sensitive", "case_sensitive"), b"A b", b"A B", False),
    (("space_change_sensitive", *NEAR), b"1.0 2", b"1 2.0", True),
    (NEAR, b"1", b"1.000001", True),
    (NEAR, b"1", b"1.0000011", False),
    (NEAR, b"1000000", b"1000001", True),  # relative
    (NEAR, b"0", b"1e-6", True),
    (NEAR, b"0", b"-1.1e-6", False),
    (NEAR, b"0.5", b"0x1p-1", True),
    (NEAR, b"0.5", b".5", True),
    (NEAR, b"5", b"5.", True),
    (NEAR, b"5", b"5e", True),  # %lf takes it, and strtod its beginning
    (NEAR, b"5", b"5e+", True),
    (NEAR, b"5", b"5x", False),
    (NEAR, b"5", b"5_0", False),
    (NEAR, b"5", b"five", False),
    (NEAR, b"5", b"inf", False),
    (NEAR, b"5", b"nan", False),
    (NEAR, b"5", b"5\0six", True),
    (NEAR, b"1e400", b"1E400", True),  # no double: a word
    (NEAR, b"1e400", b"2e400", False),
    (NEAR, b"1e308", b"-1e308", False),  # their difference is infinite
    (NEAR, b"inf", b"INF", True),
    (NEAR, b"x 1", b"X 1.0", True),
    (("float_absolute_tolerance", "0.1"), b"100", b"100.2", False),
    (("float_absolute_tolerance", "0.1"), b"100", b"100.05", True),
    (("float_relative_tolerance", "0.1"), b"100", b"109", True),
    (("float_relative_tolerance", "0.1"), b"0", b"0.0001", False),
    (("float_relative_tolerance", "0.1"), b"0", b"0.0", True),
    (("float_tolerance", "0"), b"1.0", b"1", True),
    (("float_tolerance", "-1"), b"1.0", b"1", False),  # below 0 it is none
    (("float_tolerance", "0x1p-3"), b"1", b"1.125", True),
    (("float_tolerance", "9", "float_absolute_tolerance", "0.1"), b"1", b"9", True),  # the relative 9 stays
    (("float_absolute_tolerance", "9", "float_tolerance", "0.1"), b"1", b"9", False),
]


@pytest.mark.parametrize(("flags", "answer", "output", "accepted"), CASES)
def test_an_output_is_accepted_or_not(flags, answer, output, accepted):
    why = difference(answer, output, rules_of(flags))
    assert (why == "") is accepted, why


NEEDS = "float_tolerance"


@pytest.mark.parametrize(
    "flags", [(NEEDS,), (NEEDS, "x"), (NEEDS, "inf"), (NEEDS, "1e400"), ("case_insensitive",), ("1e-6",)]
)
def test_arguments_that_it_does_not_take(flags):
    with pytest.raises(BadFlagsError):
        rules_of(flags)


@pytest.mark.parametrize(
    ("token", "value"),
    [
        (b"0x", None), (b"0x.", 0.0), (b"0x.p1", None), (b"0x.8", 0.5), (b"0X1P", 1.0), (b"0x1p-", 1.0),
        (b"-0x1.8p1", -3.0), (b"0x1p99999999999999999999", None), (b"0x1g", None), (b".", None),
        (b"-.", None), (b"+-1", None), (b"1e5.5", None), (b"1e5e5", None), (b"0e999999999999", 0.0),
        (b"", None), (b"1 ", None),
    ],
)  # fmt: skip
def test_what_the_c_library_takes_for_a_number(token, value):
    assert as_number(token) == value


def test_the_reason_names_the_place_and_is_short():
    why = difference(b"1 2 " + b"3" * 9999, b"1 2 " + b"4" * 9999, rules_of(()))
    assert why.startswith("token 3: ")
    assert len(why) < 200

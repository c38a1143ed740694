"""A case that a person wrote is read as it was shown, and the strangest texts are told in one line.

The forms of a case and what is none are in golden/transcripts: try/cases.txt.
"""

from __future__ import annotations

import pytest

from judge.data.parse import line_of, read_case
from judge.errors import UsageError
from judge.problem.find import find_problem


@pytest.fixture(scope="module")
def count():
    return find_problem("count")


@pytest.mark.parametrize("case", [(0, 0, 1, (-1, 1), (1.5, 1)), (0, 0.0, 1, (1000.0, 10), (-0.0, 1))])
def test_the_line_of_a_case_is_that_case_with_its_types(count, case):
    assert repr(read_case(count, line_of(count, case))) == repr(case)


def test_numbers_may_be_sums_products_and_powers(count):
    text = "2**0.5, 1e8 + 1e-7, -(3 - 1) / 4, (2**100, +7), B=[0, 5 * 2]"
    assert read_case(count, text) == (2**0.5, 1e8 + 1e-7, -0.5, (2**100, 7), (0, 10))


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("(" * 5000, "this is not Python ("),
        ("0," * 10_001, "a case of 20,002 characters is too long"),
        ("[" * 60 + "1" + "]" * 60 + ",2,3,4,5", "cx: nested too deeply"),
        ("1" * 5000 + ", 0, 1, (0, 0), (1, 1)", "this is not Python"),
        ("1" * 5000 + " 0 1 0 0 1 1", "is not a value of cx"),
        ("0if 1else 2, 2, 3, 4, '\\d'", "is not a plain value"),  # of which Python would warn
        ("2**4001, 0, 1, (0, 0), (1, 1)", "cx: a power is too large"),
        ("9**9**9**9, 0, 1, (0, 0), (1, 1)", "cx: a power is too large"),
        ("(-8)**0.5, 0, 1, (0, 0), (1, 1)", "cx: a number is not finite or not real"),
        ("1e308 * 10, 0, 1, (0, 0), (1, 1)", "cx: a number is not finite or not real"),
        ("1 / 0, 0, 1, (0, 0), (1, 1)", "cx: division by zero"),
        ("exit(7), 0, 1, (0, 0), (1, 1)", "cx: 'exit(7)' is not a plain value"),
        ("'a' * 10**9, 0, 1, (0, 0), (1, 1)", "cx: \"'a'\" is not a number"),
    ],
)
def test_a_text_made_to_be_odd_is_told_in_a_line(count, text, told):
    with pytest.raises(UsageError) as refused:
        read_case(count, text)
    assert told in str(refused.value)
    assert "\n" not in str(refused.value)

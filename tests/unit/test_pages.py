"""Texts in pages, as the loop of `judge start` shows them."""

from __future__ import annotations

import pytest
from first_draw import first_draw
from hypothesis import given
from hypothesis import strategies as st

from judge.report.watch import pages

ROWS = st.lists(st.sampled_from(["", "", "a", "b", "c"]), max_size=80)


@pytest.fixture(autouse=True)
def _warm():
    first_draw()


@given(ROWS, st.integers(4, 20))
def test_nothing_is_lost_and_no_page_is_too_long(rows, room):
    found = pages(rows, room)
    assert [row for page in found for row in page if row] == [row for row in rows if row]
    assert all(len(page) <= room for page in found)
    assert all(page[0] for page in found[1:])


def test_a_page_ends_at_an_empty_row_but_not_below_a_heading():
    rows = [*"abcdefg", "", "Heading", "", *"hijklmn"]
    assert pages(rows, 10)[0] == [*"abcdefg"]
    assert pages([*"abcdefghi", "", "j"], 10)[0] == [*"abcdefghi"]
    assert pages([*"abcdefghijklm"], 10)[0] == [*"abcdefghij"]

"""From one run to another: groups gained and lost, and the difference of the sources."""

from __future__ import annotations

import pytest
from past_runs import past_result

from judge.kata.changes import change
from judge.kata.history import History


@pytest.fixture
def between():
    """What changed between two results with these sources."""

    def run(old, new, before=b"a\n", after=b"b\n"):
        with History.open() as history:
            numbers = history.add(old, before, ""), history.add(new, after, "")
            found = [history.run(number) for number in numbers]
        return change(*found, (before, after))

    return run


def test_groups_gained_and_lost(between):
    found = between(
        past_result(passed=("grid", "band"), failed=("tangent", "small")),
        past_result(passed=("grid", "tangent"), failed=("band", "small")),
    )
    assert (found.gained, found.lost) == (("tangent",), ("band",))


def test_a_group_that_was_left_out_or_is_another_problems_is_neither(between):
    found = between(past_result(passed=("grid", "band")), past_result(passed=("grid",)))
    assert (found.gained, found.lost) == ((), ())
    found = between(past_result(passed=("grid",)), past_result(passed=("tangent",), failed=("band",)))
    assert (found.gained, found.lost) == ((), ())
    found = between(past_result("count", failed=("grid",), passed=()), past_result("segment"))
    assert (found.gained, found.lost) == ((), ())


def test_the_sources_line_by_line(between):
    found = between(past_result(name="a.py"), past_result(name="b.py"), b"x\ny\nz\n", b"x\nY\nz\n")
    assert found.diff == ("--- run 1 a.py", "+++ run 2 b.py", "@@ -1,3 +1,3 @@", " x", "-y", "+Y", " z")


@pytest.mark.parametrize(
    ("before", "after", "told"),
    [
        (b"x", b"x\n", ("-x", "\\ No newline at end of file", "+x")),
        (b"x\n", b"x", ("-x", "+x", "\\ No newline at end of file")),
        (b"", b"x\n", ("+x",)),
        (b"x\r\n", b"x\n", ("-x\r", "+x")),
        (b"x\x0cy\n", b"x\x0cz\n", ("-x\x0cy", "+x\x0cz")),
        (b"\xff\n", b"\xfe\n", ("-\\xff", "+\\xfe")),
    ],
)
def test_ends_of_lines_and_bytes_that_are_no_text(before, after, told, between):
    assert between(past_result(), past_result(), before, after).diff[3:] == told


def test_sources_that_are_the_same_or_too_long_to_compare(between):
    found = between(past_result(), past_result(), b"x\n", b"x\n")
    assert (found.same_source, found.diff) == (True, ())
    assert between(past_result(), past_result(), b"x\n" * 30_000, b"y\n" * 30_000).diff is None

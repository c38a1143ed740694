"""The kill matrix: who kills whom, and which group is needed."""

from __future__ import annotations

from fractions import Fraction

import pytest
from judging import make_group
from msgspec.structs import replace

from judge.problem import Verdict
from judge.report.values import percent
from judge.run.matrix import kill_matrix
from judge.run.result import GroupResult


def group(name, *kills):
    return replace(make_group(name), kills=kills)


def results(cases=10, **rejected):
    """A program's results: the places of the rejected cases of each group."""
    return [
        GroupResult(
            name,
            Verdict.WA if places else Verdict.AC,
            cases,
            cases - len(places),
            None,
            0.0,
            wrong=dict.fromkeys(places, ("count", (0.0,))),
        )
        for name, places in rejected.items()
    ]


GROUPS = [group("examples"), group("grid", "blind", "deaf"), group("edge", "deaf"), group("spare", "blind")]
PROGRAMS = [
    ("wrong/blind.py", "blind", results(examples=(), grid=(0, 1, 2), edge=(), spare=(4,))),
    ("wrong/deaf.py", "deaf", results(examples=(), grid=(2,), edge=(5, 6), spare=())),
    ("wrong/deaf-once.py", "deaf", results(examples=(), grid=(), edge=(6,), spare=())),
    ("wrong/immortal.py", "dumb", results(examples=(), grid=(), edge=(), spare=())),
]


@pytest.fixture(scope="module")
def matrix():
    return kill_matrix(GROUPS, PROGRAMS)


def test_a_row_tells_every_groups_share(matrix):
    blind, deaf, once, immortal = matrix.rows
    assert [kill.rejected for kill in blind.kills] == [(), (1, 2, 3), (), (5,)]
    assert [kill.share for kill in blind.killing] == [Fraction(3, 10), Fraction(1, 10)]
    assert (blind.aimed, deaf.aimed, immortal.aimed) == (("grid", "spare"), ("grid", "edge"), ())
    assert [row.own and row.own.group for row in matrix.rows] == ["grid", "edge", "edge", None]
    assert [kill.group for kill in once.killing] == ["edge"]


def test_groups_that_do_nothing_of_their_own(matrix):
    assert matrix.aimless == ("examples",)
    assert matrix.replaceable == ("grid", "spare")
    assert [row.file for row in matrix.unkilled] == ["wrong/immortal.py"]
    empty = kill_matrix(GROUPS, [])
    assert (empty.rows, empty.unkilled) == ((), ())


def test_a_share_is_all_or_nothing_only_where_it_is():
    shares = [(0, 5), (5, 5), (1, 900), (899, 900), (1, 3)]
    assert [percent(Fraction(*share)) for share in shares] == ["0%", "100%", "1%", "99%", "33%"]

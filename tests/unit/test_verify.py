"""The setter's gate: what it says about each broken promise, and the kill matrix."""

from __future__ import annotations

import shutil
from fractions import Fraction
from pathlib import Path

import pytest
from broken_problems import broken
from judging import make_group
from msgspec.structs import replace

from judge.problem.load import load_problem
from judge.run.matrix import kill_matrix
from judge.run.result import Answers
from judge.run.verify import verify_problem

pytestmark = pytest.mark.slow

FIXTURES = Path(__file__).parent.parent / "fixtures"


@pytest.fixture
def pack(tmp_path):
    """A copy of the sound problem with its solutions."""
    for kind in ("problems", "solutions"):
        shutil.copytree(FIXTURES / kind / "root-count", tmp_path / kind / "root-count")
    return tmp_path


def verified(pack, **options):
    return verify_problem(load_problem(pack / "problems" / "root-count"), **options)


def test_drifted_data_are_a_fault_until_they_are_pinned(pack):
    page = pack / "problems" / "root-count" / "problem.py"
    page.write_text(
        page.read_text().replace("(draw.integer(-reach, reach),)", "(-draw.integer(-reach, reach),)")
    )
    report = verified(pack)
    assert report.pins == "differing"
    assert [str(fault) for fault in report.faults] == [
        (
            "root-count/pins.json: the data of group 'small' differ from their pinned hash; "
            "if that is meant, pin the data with: judge verify root-count --pin"
        )
    ]
    assert verified(pack, update_pins=True).pins == "written"
    assert not verified(pack).faults


def test_data_that_cannot_be_built_are_the_one_fault(tmp_path):
    report = verify_problem(load_problem(broken("example-contradicts", tmp_path)))
    (fault,) = report.faults
    assert fault.where == "example-contradicts/statement.md:5"
    assert "contradicts solve" in fault.what
    assert report.faults
    assert report.solutions == ()


def group(name, *kills):
    return replace(make_group(name), kills=kills)


def does(**rejected):
    """What a program answers: the places of the rejected cases of each group, of 10."""
    return {name: Answers(10, dict.fromkeys(places, ("count", (0.0,)))) for name, places in rejected.items()}


GROUPS = [group("examples"), group("grid", "blind", "deaf"), group("edge", "deaf"), group("spare", "blind")]
SIZES = {each.name: 10 for each in GROUPS}
PROGRAMS = [
    ("wrong/blind.py", "blind", does(examples=(), grid=(0, 1, 2), edge=(), spare=(4,))),
    ("wrong/deaf.py", "deaf", does(examples=(), grid=(2,), edge=(5, 6), spare=())),
    ("wrong/deaf-once.py", "deaf", does(examples=(), grid=(), edge=(6,), spare=())),
    ("wrong/immortal.py", "dumb", does(examples=(), grid=(), edge=(), spare=())),
]


@pytest.fixture(scope="module")
def matrix():
    return kill_matrix(GROUPS, SIZES, PROGRAMS)


def test_a_row_tells_every_groups_share(matrix):
    blind, deaf, once, immortal = matrix.rows
    assert [kill.rejected for kill in blind.kills] == [(), (1, 2, 3), (), (5,)]
    assert [kill.share for kill in blind.killing] == [Fraction(3, 10), Fraction(1, 10)]
    assert (blind.aimed, deaf.aimed, immortal.aimed) == (("grid", "spare"), ("grid", "edge"), ())
    assert [row.own and row.own.group for row in matrix.rows] == ["grid", "edge", "edge", None]
    assert [kill.group for kill in once.killing] == ["edge"]

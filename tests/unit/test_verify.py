"""The setter's gate: what it says about each broken promise."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from broken_problems import broken

from judge.errors import JudgeError
from judge.problem.find import typed
from judge.problem.load import load_problem
from judge.run.execute import judge_submission
from judge.verify import gate
from judge.verify.gate import Options, verify_problem

pytestmark = pytest.mark.slow

FIXTURES = Path(__file__).parent.parent / "fixtures"


@pytest.fixture
def pack(tmp_path):
    """A copy of the sound problem with its solutions."""
    for kind in ("problems", "solutions"):
        shutil.copytree(FIXTURES / kind / "root-count", tmp_path / kind / "root-count")
    return tmp_path


def verified(pack, **options):
    return verify_problem(load_problem(pack / "problems" / "root-count"), Options(**options))


def test_drifted_data_are_a_fault_until_they_are_pinned(pack):
    page = pack / "problems" / "root-count" / "problem.py"
    page.write_text(
        page.read_text().replace("(draw.integer(-reach, reach),)", "(-draw.integer(-reach, reach),)")
    )
    report = verified(pack)
    assert report.pins == "differing"
    (fault,), problem = report.faults, load_problem(page.parent)
    assert str(fault).startswith(
        "root-count/pins.json: the data of group 'small' differ from their pinned hash"
    )
    assert fault.remedy == f"if that is meant, pin the data with: judge verify {typed(problem)} --pin"
    assert verified(pack, pin=True).pins == "written"
    assert not verified(pack).faults


def test_pins_that_are_missing_are_told_so(pack):
    (pack / "problems" / "root-count" / "pins.json").unlink()
    report = verified(pack)
    (fault,) = report.faults
    assert (report.pins, fault.where) == ("missing", "root-count/pins.json")
    assert fault.remedy.endswith("--pin")


def test_a_reference_that_cannot_be_timed_costs_what_is_raced_against_it(pack, monkeypatch):
    why = "the reference solution in Go cannot be timed: exit status 1"

    def judged(data, source, name, settings):
        if name == "signs.py":
            raise JudgeError(why)
        return judge_submission(data, source, name, settings)

    monkeypatch.setattr(gate, "judge_submission", judged)
    report = verified(pack)
    (fault,) = report.faults
    assert (fault.where, report.solutions[0].unjudged) == ("root-count/accepted/signs.py", why)
    assert fault.what.endswith(why)
    assert len(report.solutions) == 2


def test_data_that_cannot_be_built_are_the_one_fault(tmp_path):
    report = verify_problem(load_problem(broken("example-contradicts", tmp_path)))
    (fault,) = report.faults
    assert fault.where == "example-contradicts/statement.md:5"
    assert "contradicts solve" in fault.what
    assert report.faults
    assert report.solutions == ()


@pytest.mark.parametrize(
    ("source", "faults"),
    [
        ('license = "cc by-sa"', 1),
        ('license = "cc by-sa"\nauthors = ["Ada Lovelace"]', 0),
        ('license = "cc by-sa"\norigin = "a book"', 0),
        ('license = "public domain"', 0),
    ],
)
def test_a_license_that_nobody_gives_is_a_fault(pack, source, faults):
    file = pack / "problems" / "root-count" / "problem.toml"
    file.write_text(f"{file.read_text()}\n[source]\n{source}\n")
    found = [str(fault) for fault in verified(pack).faults]
    said = "the license is cc by-sa, and neither authors nor an origin are named; name them in [source]"
    assert [each.partition(": ")[2] for each in found] == [said] * faults

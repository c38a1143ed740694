"""The setter's gate: what it checks, and what it says about each broken promise.

What it says of solutions is in golden/transcripts: faults/solutions.txt.
"""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from broken_problems import broken

from judge.problem import Verdict
from judge.problem.load import load_problem
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
    toml = pack / "problems" / "root-count" / "problem.toml"
    toml.write_text(toml.read_text().replace("seed = 1", "seed = 2"))
    report = verified(pack)
    assert report.pins == "differing"
    assert [str(fault) for fault in report.faults] == [
        (
            "root-count/hashes.json: the data of group 'small' differ from their pinned hash; "
            "if that is meant, pin the data with: judge verify root-count --pin"
        )
    ]
    assert verified(pack, update_pins=True).pins == "written"
    assert verified(pack).ok


def test_data_that_cannot_be_built_are_the_one_fault(tmp_path):
    report = verify_problem(load_problem(broken("example-contradicts", tmp_path)))
    (fault,) = report.faults
    assert fault.where == "example-contradicts/statement.md:5"
    assert "contradicts solve" in fault.what
    assert (report.ok, report.solutions) == (False, ())


def test_a_slow_program_is_one_that_runs_out_of_time(pack):
    toml = pack / "problems" / "root-count" / "problem.toml"
    toml.write_text(toml.read_text().replace("cpu_seconds = 2", "cpu_seconds = 0.2"))
    slow = pack / "solutions" / "root-count" / "slow"
    slow.mkdir()
    (slow / "endless.py").write_text('"""endless."""\ndef root_count(c):\n    while True: pass\n')
    report = verified(pack)
    assert report.ok, report.faults
    assert [(each.name, each.verdict) for each in report.solutions][-1] == ("endless", Verdict.TLE)

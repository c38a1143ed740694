"""A kata is added in the steps that CONTRIBUTING tells, as they stand there."""

from __future__ import annotations

import json

import pytest
from pages import ROOT, claims_hold
from walk import WALKS, go, steps

PAGE = ROOT / WALKS[1][0]


@pytest.fixture(scope="module")
def walk():
    if not PAGE.exists():
        pytest.skip("not part of a source distribution")
    return steps(PAGE.read_text(encoding="utf-8"), WALKS[1][1])


def test_a_kata_is_added_as_told(walk, tmp_path):
    taken = go(walk, tmp_path)
    claims_hold(taken)
    assert [each.status for each in taken] == [0, 1, 0]
    pinned = tmp_path / "problems" / "tangent-length" / "hashes.json"
    assert len(json.loads(pinned.read_text(encoding="utf-8"))) > 0


def test_a_fault_in_a_step_is_noticed(walk, tmp_path):
    """The other way round: were the page wrong, the test above would say so."""
    from dataclasses import replace

    spoilt = [
        replace(step, text=step.text.replace("- r * r", "- r")) if step.words.endswith("problem.py") else step
        for step in walk
    ]
    with pytest.raises(AssertionError, match="does not show as told"):
        claims_hold(go(spoilt, tmp_path))


def test_every_file_of_a_kata_is_told(walk):
    told = {step.words.rpartition("/")[2] for step in walk if step.is_file}
    assert {"problem.toml", "problem.py", "statement.md", "hints.md"} <= told
    assert {step.words.split("/")[2] for step in walk if step.words.startswith("solutions/")} == {
        "accepted",
        "wrong",
    }

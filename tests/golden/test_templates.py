"""The katas that new ones begin with: sound on three sets of data, with five mistakes each."""

from __future__ import annotations

from pathlib import Path

import pytest

import judge
from judge.data.pins import read_pins
from judge.practice.begin import KINDS
from judge.problem.load import load_problem
from judge.verify.gate import Options, verify_problem

PROBLEMS = Path(judge.__file__).parent / "manual" / "katas" / "problems"
KATAS = sorted(path.parent.name for path in PROBLEMS.glob("*/problem.toml"))
FIRST = next(iter(KINDS.values()))  # whose one mistake is enough


@pytest.mark.slow
@pytest.mark.parametrize("name", KATAS)
def test_a_kata_to_begin_with_is_sound(name):
    found = verify_problem(load_problem(PROBLEMS / name), Options(seeds=3))
    assert (found.faults, found.warnings, found.pins) == ((), (), "matching")
    kills = {each for pin in read_pins(load_problem(PROBLEMS / name)).values() for each in pin["kills"]}
    assert name == FIRST or len(kills) >= 5


def test_every_kind_is_one_of_them():
    assert {*KINDS.values()} <= {*KATAS}

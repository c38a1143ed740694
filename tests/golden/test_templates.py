"""The katas that new ones begin with: sound on three sets of data, with five mistakes each."""

from __future__ import annotations

from pathlib import Path

import pytest

import judge
from judge.data.load import load_data
from judge.data.pins import read_pins
from judge.errors import UsageError
from judge.judging.inprocess import InProcess
from judge.packs.begin import KINDS, begin_kata
from judge.problem import Verdict
from judge.problem.load import load_problem
from judge.problem.solutions import SolutionKind, read_solutions
from judge.run.execute import judge_submission
from judge.run.settings import Settings
from judge.sandbox import Containment
from judge.sandbox.available import levels_here
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


@pytest.mark.slow
@pytest.mark.parametrize("level", ["full", "strong", "limits"])
def test_their_programs_are_right_at_every_level_and_in_the_process_of_a_tab(level):
    if level not in {each.name for each in levels_here() if each.available}:
        pytest.skip(f"no {level} here")
    for name in KATAS:
        problem = load_problem(PROBLEMS / name)
        if problem.growth:  # whose large cases take long
            continue
        data = load_data(problem)
        for each in read_solutions(problem, SolutionKind.ACCEPTED).programs:
            if each.language:
                continue
            boxes = [Containment(level), *([InProcess] if level == "limits" and not problem.talks else [])]
            for factory in boxes:
                settings = Settings(factory, measured=False)
                found = judge_submission(data, each.source, each.path.name, settings).result
                assert found.verdict is Verdict.AC, (name, each.file, found.failure)


def test_where_the_current_folder_is_gone_that_is_one_clear_line(tmp_path, monkeypatch):
    gone = tmp_path / "gone"
    gone.mkdir()
    monkeypatch.chdir(gone)
    gone.rmdir()
    with pytest.raises(UsageError, match="cannot be written"):
        begin_kata(Path("../broken"))

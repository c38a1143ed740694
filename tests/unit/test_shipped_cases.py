"""Cases of shipped katas: replay ids, neighbours, the smallest number, thresholds beside the bands."""

from __future__ import annotations

import math
import shutil
from fractions import Fraction
from pathlib import Path

import msgspec
import pytest

from judge.data.build import Fresh, bounds_fault
from judge.data.load import load_data
from judge.diagnose.replay import decode, encode, problem_name
from judge.errors import ProblemError, UsageError
from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.problem.load import load_problem
from judge.problem.module import load_module
from judge.run.execute import judge_submission
from judge.values.grammar import parse


@pytest.fixture(scope="module", params=["segment", "exact-count"])
def problem(request):
    return find_problem(request.param)


def test_every_group_comes_back(problem):
    module = load_module(problem)
    for data in load_data(problem).groups:
        for case in (data.cases[0], data.cases[-1]):
            replay = encode(problem, data.group, case)
            assert problem_name(replay) == problem.id
            group, again, answer = decode(replay, problem, module)
            assert (group, repr(again)) == (data.group, repr(case))
            assert answer == module.solve(*case)


def test_a_bad_id_is_a_short_line_however_long_it_is():
    """The others are in golden/transcripts: refused/replay-ids.txt."""
    problem = find_problem("count")
    with pytest.raises(UsageError, match="no replay id") as caught:
        decode("count:grid:v" + "9" * 20_000 + ":123456", problem, load_module(problem))
    assert len(str(caught.value)) < 200


PROBLEMS = Path(__file__).parents[2] / "problems"
SOUND = Path(__file__).parents[1] / "fixtures" / "problems" / "root-count"


def changed(one, other):
    return [place for place, (a, b) in enumerate(zip(one, other, strict=True)) if a != b]


def assert_neighbours(cases):
    turns = dict.fromkeys(range(5), 0)
    for number in range(1, len(cases)):
        if number % 11 == 0:
            continue  # it stands for itself
        assert changed(cases[number - 1], cases[number]) == [(number % 11 - 1) % 5]
        turns[(number % 11 - 1) % 5] += 1
    assert min(turns.values()) >= 5


def test_fresh_neighbours_are_such_too_with_nothing_between_them():
    problem = load_problem(PROBLEMS / "segment")
    fresh = Fresh(problem, load_module(problem), [problem.group("repeated")], 7)
    series = next(fresh.series())
    assert_neighbours(series.cases)


def test_a_smaller_number_is_out_of_bounds_whatever_its_place_and_0_is_not():
    problem = load_problem(PROBLEMS / "segment")

    def bounds(flat):
        return bounds_fault(problem, (*flat[:3], tuple(flat[3:5]), tuple(flat[5:])))

    for place in range(7):
        for sign in (1, -1) if place != 2 else (1,):  # a radius
            flat = [1.0] * 7
            flat[place] = sign * math.nextafter(1e-30, 0)
            assert "nearer to 0 than 1e-30 but not 0" in bounds(flat)
            flat[place] = sign * 1e-30  # the least double that is not below it
            assert bounds(flat) is None
    assert bounds([0, 0.0, 0, 0.0, 0, 0, 0.0]) is None
    assert bounds([0, 0.0, 5e-324, 0.0, 0, 0, 0.0]) is not None


@pytest.mark.parametrize("bound", [Fraction(1, 3), Fraction(2, 3), Fraction(1, 2)])
def test_a_double_is_too_small_just_when_it_is_below_the_exact_bound(bound):
    (c,) = load_problem(SOUND).parameters
    number = parse("number")

    class Small:
        parameters = (msgspec.structs.replace(c, type=number, smallest=bound),)

    near = [math.nextafter(float(bound), end) for end in (0, 1)]
    for x in (*near, float(bound)):
        assert (bounds_fault(Small, (x,)) is None) is (x >= bound)


@pytest.mark.parametrize("smallest", ["2", "1e400", "-1"])
def test_what_is_no_such_bound_is_a_fault(tmp_path, smallest):
    folder = shutil.copytree(SOUND, tmp_path / "root-count")
    text = (SOUND / "problem.toml").read_text()
    (folder / "problem.toml").write_text(
        text.replace("low = -9", f"low = -9, smallest = {smallest}").replace("integer", "number")
    )
    with pytest.raises(ProblemError, match="other than 0 is not from 0 to 1"):
        load_problem(folder)


SILHOUETTE = (find_problem("silhouette").solutions / "accepted" / "state_machine.py").read_text()
WIDTH = "1e-10 * max(r, abs(fx), abs(fy))"


@pytest.mark.nightly
@pytest.mark.parametrize(
    ("width", "verdict"),
    [("1e-12", Verdict.AC), ("5e-8", Verdict.AC), ("0", Verdict.WA), ("1e-6", Verdict.WA)],
)
def test_any_threshold_in_the_gap_is_right_and_none_outside_of_it(width, verdict):
    assert WIDTH in SILHOUETTE
    problem, source = find_problem("silhouette"), SILHOUETTE.replace(WIDTH, WIDTH.replace("1e-10", width))
    assert judge_submission(load_data(problem), source.encode(), "mine.py").result.verdict is verdict

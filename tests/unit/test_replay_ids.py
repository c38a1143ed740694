"""Replay ids: every case of every group comes back from its id, and what is no id is one clear line."""

from __future__ import annotations

import pytest

from judge.data.load import load_data
from judge.data.module import load_module
from judge.diagnose.replay import decode, encode, problem_name
from judge.errors import UsageError
from judge.problem.find import find_problem


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
            assert answer == module.solve(*case).answer


def test_a_bad_id_is_a_short_line_however_long_it_is():
    """The others are in golden/transcripts: refused/replay-ids.txt."""
    problem = find_problem("count")
    with pytest.raises(UsageError, match="no replay id") as caught:
        decode("count:grid:v" + "9" * 20_000 + ":123456", problem, load_module(problem))
    assert len(str(caught.value)) < 200


def test_an_id_by_choices_of_an_older_judge_is_told_so():
    problem = find_problem("count")
    with pytest.raises(UsageError, match="of an older judge"):
        decode("count:tangent:c1.-14:000000", problem, load_module(problem))

"""Groups with a size: their keys, their data, and submissions that are judged by how they grow."""

from __future__ import annotations

import json
import re
import shutil
from array import array
from pathlib import Path

import jsonschema
import pytest
from sandboxed import call, limits

from judge.cli.app import app
from judge.data import ProblemData
from judge.data.load import load_data
from judge.errors import ProblemError
from judge.problem import Verdict
from judge.problem.load import load_problem
from judge.problem.model import MOST_INPUT_MB
from judge.run.execute import judge_submission
from judge.sandbox.inside import wire
from judge.schema import schema_of

pytestmark = pytest.mark.slow

PACK = Path(__file__).parent.parent / "fixtures" / "growth"
GROWS = re.compile(r"it grows like n\^\d\.\d, the reference like n\^\d\.\d")


def problem_of(name):
    return load_problem(PACK / "problems" / name)


@pytest.fixture(scope="module")
def inversions():
    return load_data(problem_of("inversions"), store=None)


@pytest.fixture(scope="module")
def signs():
    return load_data(problem_of("signs"), store=None)


def judged(data, solution, problem=None):
    path = PACK / "solutions" / data.problem.id / solution
    data = ProblemData(problem or data.problem, data.groups)
    return judge_submission(data, path.read_bytes(), path.name).result


def changed(tmp_path, *changes, name="inversions", file="problem.toml"):
    """The folder of a problem whose file reads otherwise."""
    folder = tmp_path / "problems" / name
    shutil.copytree(PACK / "problems" / name, folder, dirs_exist_ok=True)
    path = folder / file
    text = path.read_text(encoding="utf-8")
    for old, new in changes:
        assert old in text
        text = text.replace(old, new, 1)
    path.write_text(text, encoding="utf-8")
    return folder


TIME = '[time]\nlimit = 1000\nfunction = "tree.py"\nprogram = "program.py"\n'
REFUSED = {  # the file, what is changed there, the line at fault, words of the complaint and of the remedy
    "slope": ("toml", ("growth = 0.4", "growth = 0"), 6, "growth = 0", "give a number > 0"),
    "time alone": ("toml", (TIME, ""), 6, "growth is measured beside a reference", "add a [time] table"),
    "size": ("py", ("size=2000", "size=0"), 35, "group 'n-2000': size = 0", "give a whole number >= 1"),
    "room": (
        "toml",
        ("input_mb = 1", "input_mb = 100"),
        13,
        "limits.input_mb = 100",
        f"give a number <= {MOST_INPUT_MB}",
    ),
}


@pytest.mark.parametrize("fault", sorted(REFUSED))
def test_a_wrong_key_is_refused_with_its_line(fault, tmp_path):
    file, change, line, what, remedy = REFUSED[fault]
    with pytest.raises(ProblemError) as caught:
        load_problem(changed(tmp_path, change, file=f"problem.{file}"))
    assert what in caught.value.what
    assert remedy in (caught.value.remedy or "")
    assert caught.value.where == f"inversions/problem.{file}:{line}"


def test_cases_beyond_the_limit_on_input_are_refused(tmp_path):
    folder = changed(tmp_path, ("input_mb = 1", "input_mb = 0.0625"))
    with pytest.raises(
        ProblemError, match=r"group 'n-2000' has 0\.\d MB of cases; input_mb is 0\.0625"
    ) as caught:
        load_data(load_problem(folder), store=None)
    assert caught.value.where == "inversions/problem.py:35"


@pytest.fixture
def cache(tmp_path, monkeypatch):
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache" / "data"


@pytest.mark.usefixtures("cache")
def test_big_cases_are_kept_as_they_are(monkeypatch):
    cold = load_data(problem_of("inversions"))
    monkeypatch.setattr("judge.data.build.build", None)
    warm = load_data(problem_of("inversions"))
    assert repr([(g.cases, g.targets) for g in warm.groups]) == repr(
        [(g.cases, g.targets) for g in cold.groups]
    )


def test_a_container_has_room_for_as_much_input_as_a_problem_may_have():
    room = wire.REGION_BYTES - wire.replies_at(MOST_INPUT_MB << 20)
    assert room >= 2 * wire.REPLY_BYTES
    numbers = array("d", bytes(MOST_INPUT_MB << 20))
    within = limits(memory_bytes=512 << 20, output_bytes=wire.REPLY_BYTES)
    (reply,) = call("def f(a):\n    return [a.typecode, len(a)]", [(numbers,)], within).replies
    assert reply.answer == [{"word": "d"}, (MOST_INPUT_MB << 20) // 8]


def test_a_big_case_that_fails_is_not_shown(signs):
    many = signs.groups[2].group
    path = PACK / "solutions" / "signs" / "wrong" / "no-zero.py"
    result = judge_submission(signs, path.read_bytes(), path.name, groups=[many.name]).result
    assert (result.failure.group, result.failure.case, result.failure.input) == ("many", 1, None)
    assert re.fullmatch(r"item \d+: 0 expected, 1 given", result.failure.message)
    assert len(json.dumps(result.as_json())) < 3_000


def test_a_good_solution_passes_and_its_growth_is_published(inversions):
    result = judged(inversions, "accepted/tree.py")
    assert (result.verdict, result.score) == (Verdict.AC, 100), result.failure
    if result.time.growth is not None:  # on a machine ten times as quick the groups are too short
        assert result.as_json()["time"]["growth"]["groups"] == ["n-2000", "n-6000"]
    jsonschema.validate(result.as_json(), schema_of(app.get_command(None, "run")))


@pytest.mark.nightly
def test_a_quadratic_solution_is_too_slow_for_how_it_grows(inversions):
    result = judged(inversions, "slow/all-pairs.py")
    assert (result.verdict, result.failure.group) == (Verdict.TLE, "n-6000")
    assert GROWS.match(result.failure.message)
    assert result.time.growth.exponent > result.time.growth.reference + 0.4
    jsonschema.validate(result.as_json(), schema_of(app.get_command(None, "run")))


def test_what_is_clearly_too_steep_is_not_run_to_its_end(inversions, monkeypatch):
    monkeypatch.setattr("judge.run.growth.LEAST_SECONDS", 0.001)  # of a reference that is quick on one case
    # Whether it is too steep is the clock's to say, and held to figures in test_growth.py.
    monkeypatch.setattr("judge.run.growing.is_steep", lambda smaller, larger, slope: True)
    result = judged(inversions, "slow/all-pairs.py")
    assert (result.verdict, result.failure.group) == (Verdict.TLE, "n-6000")
    assert GROWS.match(result.failure.message)
    assert [(group.passed, group.cases) for group in result.groups[-2:]] == [(8, 8), (1, 3)]

"""What a worker does with a task: the result of `judge run`, where it was judged, and by what."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest
from msgspec.structs import replace

import judge
from judge.batch import work
from judge.batch.model import Environment, Task
from judge.batch.work import judge_task, level_here
from judge.errors import UsageError
from judge.judging import RunOptions
from judge.problem.find import find_problem

PACK = Path(__file__).parents[1] / "fixtures" / "pack" / "problems"
FLOOR = b"def middle(a, b):\n    return (a + b) // 2\n"
TERMS = RunOptions(diagnosed=False)


@pytest.fixture(scope="module", autouse=True)
def _own_cache(tmp_path_factory):
    with pytest.MonkeyPatch.context() as patched:
        patched.setenv("JUDGE_CACHE", str(tmp_path_factory.mktemp("cache")))
        yield
    work.release()


@pytest.fixture(scope="module")
def task():
    problem = find_problem("middle", [PACK])
    level, _ = level_here(problem, TERMS)
    environment = Environment.here(problem, TERMS, level)
    return Task("middle", "ada/middle.py", FLOOR, TERMS, environment, (str(PACK),))


def without_times(plain):
    return {name: each for name, each in plain.items() if name not in ("time", "memory_bytes", "groups")} | {
        "groups": [{**group, "cpu_seconds": 0} for group in plain["groups"]]
    }


@pytest.mark.slow
def test_a_task_is_judged_as_judge_run_does(task):
    done = judge_task(task)
    plain = judge.judge(
        "middle", FLOOR, name="ada/middle.py", folders=[PACK], options=judge.RunOptions(diagnosed=False)
    )
    assert without_times(done.result) == without_times(json.loads(json.dumps(plain.as_json())))
    assert done.result["pitfall"]["names"] == ["floor-division"]
    assert (done.machine, done.worker) == (os.uname().nodename, f"{os.uname().nodename}:{os.getpid()}")
    assert done.seconds > 0


@pytest.mark.parametrize(
    ("part", "words"), [("data", "the problem's files (else → "), ("python", "Python (else → cpython 3.")]
)
def test_another_environment_is_refused_in_one_line(task, part, words):
    environment = replace(task.environment, **{part: "else"})
    with pytest.raises(UsageError) as refused:
        judge_task(replace(task, environment=environment))
    assert words in str(refused.value)
    assert "\n" not in str(refused.value)
    assert "middle on " in str(refused.value)


def test_a_broken_problem_costs_its_own_tasks_alone(task, tmp_path):
    (tmp_path / "middle").mkdir()
    (tmp_path / "middle" / "problem.toml").write_text("title = 3\n")
    broken = replace(task, folders=(str(tmp_path),))
    result = judge_task(broken).result
    assert result["verdict"] == "JE"
    assert "problem.toml" in result["failure"]["message"]

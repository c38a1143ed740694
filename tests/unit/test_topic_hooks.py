"""What a problem.py hands over: `solve`, asked once a case, its bands, and the hooks of its topic."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path

import pytest
from msgspec.structs import replace

import judge
from judge.data import load_data
from judge.data.model import ProblemData
from judge.data.module import load_module
from judge.diagnose.shrink import shrink
from judge.problem.load import load_problem
from judge.problem.topic import Topic
from judge.run import Settings, run_submission
from judge.run.runner import runner_for
from judge.sandbox import open_box

FIXTURES = Path(__file__).parent.parent / "fixtures"
MIDDLE = FIXTURES / "pack" / "problems" / "middle"
FLOOR = b"def middle(a, b):\n    return (a + b) // 2\n"


@pytest.fixture
def asked():
    """The module of `middle`, and how often its solve was asked for each case."""
    problem = load_problem(MIDDLE)
    module = load_module(problem)
    times = Counter()

    def solve(*case):
        times[repr(case)] += 1
        return module.solve(*case)

    return problem, replace(module, solve=solve), times


def shrunk(problem, module):
    data = ProblemData(problem, load_data(problem).groups, module=module)
    result = run_submission(problem, data, FLOOR, "mine.py", settings=Settings(measured=False))
    with open_box(FLOOR, "mine.py") as box:
        runner = runner_for(problem, box.inspect(), FLOOR)
        return shrink(data, box, runner, result.verdict, result.failure)


def test_the_search_solves_each_case_once(asked):
    problem, module, times = asked
    found = shrunk(problem, module)
    assert found.case == (0, 1)
    assert len(times) > 10
    assert set(times.values()) == {1}


def test_the_search_asks_the_topic_what_is_simpler_and_what_is_special(asked):
    problem, module, _ = asked
    asked_of = []

    def simpler(same, case):
        asked_of.append((same, case))
        return [(2, 3)]

    topic = Topic(simpler=simpler, special=lambda case: 5 * (0 in case) + 9 * (1 in case))
    found = shrunk(problem, replace(module, topic=topic))
    assert asked_of[0][0] is problem
    assert found.case == (2, 3)


PAGE = Path(judge.__file__).parent / "manual" / "problem-py.md"


def test_the_page_tells_every_name_and_every_hook():
    rows = re.findall(r"^\| `(\w+)", PAGE.read_text(encoding="utf-8"), re.MULTILINE)
    assert rows == ["solve", "BUILDERS", "TOPIC", *Topic.__struct_fields__]

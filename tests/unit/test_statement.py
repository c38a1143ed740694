"""Placeholders and worked examples of a statement."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from judge.errors import ProblemError
from judge.spec.load import load_problem

SOUND = Path(__file__).parent.parent / "fixtures" / "problems" / "root-count"


@pytest.fixture
def stating(tmp_path):
    """Loads the sound problem with another statement."""

    def load(text):
        folder = tmp_path / "problems" / "root-count"
        shutil.copytree(SOUND, folder, dirs_exist_ok=True)
        (folder / "statement.md").write_text(text, encoding="utf-8")
        return load_problem(folder)

    return load


def wanted(problem):
    return [(example.case, example.wanted) for example in problem.examples]


def test_placeholders_stand_for_what_the_file_says(stating):
    problem = stating(
        "{{entry}}: {{ c.low }} to {{c.high}}, {{limits.cpu_seconds}} s, {{small.count}} cases\n\n"
        ">>> root_count({{c.high}})\n2\n"
    )
    assert problem.statement.startswith("root_count: -9 to 9, 2 s, 5 cases\n")
    assert wanted(problem) == [((9,), 2)]


def test_answers_end_at_a_blank_line_a_fence_or_the_next_prompt(stating):
    problem = stating(
        "```\n>>> root_count(1)\n2\n>>> root_count(2)\n[(1, 2),\n (3.5, -4)]\n```\n"
        ">>> root_count(0)\nNone\n\nMore text\n"
    )
    assert wanted(problem) == [((1,), 2), ((2,), [(1, 2), (3.5, -4)]), ((0,), None)]
    assert [example.line for example in problem.examples] == [2, 4, 8]


def test_a_call_may_go_on_over_lines_and_write_points_as_lists(stating):
    problem = stating(">>> root_count(\n...     [1, -2.5]\n... )\n1\n")
    assert wanted(problem) == [(((1, -2.5),), 1)]


@pytest.mark.parametrize(
    "call",
    ["root_count(__import__('os').getcwd())", "root_count(*[4])", "root_count(c)", "root_count(2 ** 3)"],
)
def test_an_example_is_never_run(stating, call):
    with pytest.raises(ProblemError, match="no plain"):
        stating(f">>> {call}\n2\n")


UNPLAIN = ["{[]}", "{[]: 1}", "-" * 600 + "1", "[" * 5000]


@pytest.mark.parametrize("value", UNPLAIN)
def test_an_argument_or_an_answer_that_is_no_value_is_a_fault(stating, value):
    with pytest.raises(
        ProblemError, match=r"^root-count/statement.md:1: the example .* is no Python|the example's arg"
    ):
        stating(f">>> root_count({value})\n2\n")
    with pytest.raises(
        ProblemError, match=r"^root-count/statement.md:1: the example's answer .* no plain value"
    ):
        stating(f">>> root_count(4)\n{value}\n")


@pytest.mark.parametrize("call", ["(" * 400 + "4" + ")" * 400, "root_count(\x00)", "", "root_count(4) +"])
def test_an_example_that_cannot_be_parsed_is_a_fault(stating, call):
    with pytest.raises(ProblemError, match=r"^root-count/statement.md:1: the example .* is no "):
        stating(f">>> {call}\n2\n")

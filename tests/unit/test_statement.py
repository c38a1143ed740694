"""Placeholders and worked examples of a statement."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from judge.errors import ProblemError
from judge.problem.load import load_problem

SOUND = Path(__file__).parent.parent / "fixtures" / "problems" / "root-count"


@pytest.fixture
def stating(tmp_path):
    """Loads the sound problem with another statement."""

    def load(text, kind="count", parameter="integer"):
        folder = tmp_path / "problems" / "root-count"
        shutil.copytree(SOUND, folder, dirs_exist_ok=True)
        (folder / "statement.md").write_text(text, encoding="utf-8")
        table = (SOUND / "problem.toml").read_text().replace('answer = "count"', f'answer = "{kind}"')
        table = table.replace('type = "integer"', f'type = "{parameter}"')
        tolerance = "" if kind == "count" else "[tolerance]\nrelative = 1e-9\n"
        (folder / "problem.toml").write_text(table.replace("[limits]", f"{tolerance}[limits]"))
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


@pytest.mark.parametrize("text", ["1e-7", "0.001", "1000"])
def test_a_small_number_is_written_as_such(stating, tmp_path, text):
    stating(">>> root_count(1)\n2\n")
    folder = tmp_path / "problems" / "root-count"
    table = (folder / "problem.toml").read_text(encoding="utf-8")
    (folder / "problem.toml").write_text(f"{table}\n[bands]\nleast = {text}\n", encoding="utf-8")
    (folder / "statement.md").write_text("It is {{least}}.\n\n>>> root_count(1)\n2\n", encoding="utf-8")
    assert load_problem(folder).statement.startswith(f"It is {text}.")


def test_answers_end_at_a_blank_line_a_fence_or_the_next_prompt(stating):
    problem = stating(
        "```\n>>> root_count(1)\n2\n>>> root_count(2)\n(\n  1)\n```\n>>> root_count(0)\nNone\n\nMore text\n"
    )
    assert wanted(problem) == [((1,), 2), ((2,), 1), ((0,), None)]
    assert [example.line for example in problem.examples] == [2, 4, 8]


EXAMPLE = r"^root-count/statement.md:1: the example"


@pytest.mark.parametrize("call", ["root_count(__import__('os').getcwd())", "root_count(2 ** 3)"])
def test_an_example_is_never_run(stating, call):
    with pytest.raises(ProblemError, match="no plain"):
        stating(f">>> {call}\n2\n")


@pytest.mark.parametrize("value", ["{[]}", "-" * 600 + "1", "[" * 5000])
def test_an_argument_or_an_answer_that_is_no_value_is_a_fault(stating, value):
    with pytest.raises(ProblemError, match=f"{EXAMPLE} .* is no Python|the example's arg"):
        stating(f">>> root_count({value})\n2\n")
    with pytest.raises(ProblemError, match=f"{EXAMPLE}'s answer .* no plain value"):
        stating(f">>> root_count(4)\n{value}\n")


@pytest.mark.parametrize("call", ["(" * 400 + "4" + ")" * 400, "root_count(\x00)", ""])
def test_an_example_that_cannot_be_parsed_is_a_fault(stating, call):
    with pytest.raises(ProblemError, match=f"{EXAMPLE} .* is no "):
        stating(f">>> {call}\n2\n")


@pytest.mark.parametrize(
    ("kind", "answer"),
    [
        *(("count", answer) for answer in ("True", "1.0", "[]")),
        *(("parameter", answer) for answer in ("'1'", "1e999")),
        *(("points", answer) for answer in ("None", "[(1, 2), 3]")),
    ],
)
def test_an_answer_of_another_type_is_a_fault_with_its_line(kind, answer, stating):
    with pytest.raises(ProblemError, match=r"^root-count/statement.md:3: the example's answer ") as caught:
        stating(f"A sentence.\n\n>>> root_count(4)\n{answer}\n", kind)
    assert f" {answer!r} is none: it " in str(caught.value)
    assert str(caught.value).endswith("; correct it, or the answer that problem.toml declares")


@pytest.mark.parametrize("argument", ['"4"', "True", "1e999", "[1, '2']"])
def test_an_argument_that_is_no_number_and_no_point_is_a_fault_with_its_line(argument, stating):
    with pytest.raises(ProblemError, match=r"^root-count/statement.md:1: .*(no plain|is invalid: )"):
        stating(f">>> root_count({argument})\n2\n")


@pytest.mark.parametrize(
    "text", [f"root_count(4)\n{'9' * 5000}", f"root_count(4)\n{'[' * 900}", f"root_count({'9' * 5000})\n2"]
)
def test_a_fault_is_a_short_line_however_long_the_example(text, stating):
    with pytest.raises(ProblemError) as caught:
        stating(f">>> {text}\n")
    assert len(str(caught.value)) < 300

"""Reading a problem's folder: problem.toml, its statement's placeholders and worked examples."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

from judge.errors import ProblemError
from judge.problem import Tier, Tolerance
from judge.problem.load import load_problem

SOUND = Path(__file__).parent.parent / "fixtures" / "problems" / "root-count"


def test_everything_the_file_says():
    problem = load_problem(SOUND)
    assert (problem.id, problem.title, problem.entry) == ("root-count", "Square roots", "root_count")
    assert (problem.tier, str(problem.answer)) == (Tier.JUNIOR, "count")
    assert problem.folder == SOUND
    assert problem.solutions == SOUND.parent.parent / "solutions" / "root-count"
    assert (problem.limits.cpu_seconds, problem.limits.wall_seconds) == (2.0, 10.0)
    assert (problem.limits.memory_bytes, problem.limits.output_bytes) == (128 * 2**20, 2**20)
    (parameter,) = problem.parameters
    assert (parameter.name, str(parameter.type)) == ("c", "integer")
    assert (parameter.low, parameter.high) == (-9, 9)
    examples, small = problem.groups
    assert (examples.name, examples.count, examples.points) == ("examples", 2, 40)
    assert (small.seed, small.count, small.points, small.kills) == ("root-count", 12, 60, ("sign-forgotten",))
    assert small.tolerance == Tolerance()
    assert problem.group("small") is small
    assert problem.group("large") is None


@pytest.fixture
def changed(tmp_path):
    """The sound problem with another value of a key."""

    def load(key, value):
        folder = tmp_path / "problems" / "other"
        shutil.copytree(SOUND, folder)
        text = (folder / "problem.toml").read_text()
        assert key in text
        (folder / "problem.toml").write_text(re.sub(rf"\b{key} = [^,\n]*", f"{key} = {value}", text, count=1))
        return load_problem(folder)

    return load


@pytest.mark.parametrize("name", ["Root", "root--count", "rööt"])
def test_a_folder_must_have_a_plain_name(tmp_path, name):
    shutil.copytree(SOUND, tmp_path / name)
    with pytest.raises(ProblemError, match="not a name for a kata; use small letters"):
        load_problem(tmp_path / name)


LIMITS = ("cpu_seconds", "wall_seconds", "memory_mb", "output_mb")


@pytest.mark.parametrize(
    ("key", "value", "said"),
    [
        ("high", "9" * 5000, "^other/problem.toml: not TOML: an integer has too many digits; rep"),
        ("high", "[" * 3000 + "]" * 3000, "problem.toml: not TOML: its lists or tables are nested"),
        *(
            (key, number, rf"other/problem.toml:\d+: limits.{key} = .*; give a number [<>]= ")
            for key, number in zip(LIMITS, ("1e400", "1e-400", "1000001", "0.0009"), strict=True)
        ),
    ],
    ids=lambda each: each[:12],
)
def test_what_no_machine_could_read_or_keep_is_a_fault_of_the_file(key, value, said, changed):
    with pytest.raises(ProblemError, match=said):
        changed(key, value)


SOUND = Path(__file__).parent.parent / "fixtures" / "problems" / "root-count"


def test_a_key_that_would_keep_the_parser_busy_is_a_fault_with_its_line(tmp_path):
    folder = tmp_path / "problems" / "other"
    shutil.copytree(SOUND, folder)
    with (folder / "problem.toml").open("a") as file:
        file.write(f"\n[{'a.' * 10_000}a]\n")
    lines = (folder / "problem.toml").read_text().count("\n")
    with pytest.raises(
        ProblemError, match=rf"^other/problem.toml:{lines}: not TOML: a key of more than 100 parts; "
    ):
        load_problem(folder)


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
        "{{entry}}: {{ c.low }} to {{c.high}}, {{limits.cpu_seconds}} s\n\n>>> root_count({{c.high}})\n2\n"
    )
    assert problem.statement.startswith("root_count: -9 to 9, 2 s\n")
    assert wanted(problem) == [((9,), 2)]


def test_answers_end_at_a_blank_line_a_fence_or_the_next_prompt(stating):
    problem = stating(
        "```\n>>> root_count(1)\n2\n>>> root_count(2)\n(\n  1)\n```\n>>> root_count(0)\nNone\n\nMore text\n"
    )
    assert wanted(problem) == [((1,), 2), ((2,), 1), ((0,), None)]
    assert [example.line for example in problem.examples] == [2, 4, 8]


EXAMPLE = r"^root-count/statement.md:1: the example"


@pytest.mark.parametrize("call", ["root_count(__import__('os').getcwd())", "root_count(2 ** 3)"])
def test_an_example_is_never_run(stating, call):
    with pytest.raises(ProblemError, match="is not a call of root_count with plain values"):
        stating(f">>> {call}\n2\n")


@pytest.mark.parametrize("value", ["{[]}", "-" * 600 + "1", "[" * 5000])
def test_an_argument_or_an_answer_that_is_no_value_is_a_fault(stating, value):
    with pytest.raises(ProblemError, match=f"{EXAMPLE} .* is not a call of root_count"):
        stating(f">>> root_count({value})\n2\n")
    with pytest.raises(ProblemError, match=f"{EXAMPLE}'s answer .* not a plain value"):
        stating(f">>> root_count(4)\n{value}\n")


@pytest.mark.parametrize("call", ["(" * 400 + "4" + ")" * 400, "root_count(\x00)", ""])
def test_an_example_that_cannot_be_parsed_is_a_fault(stating, call):
    with pytest.raises(ProblemError, match=f"{EXAMPLE} .* is not a "):
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


ROOT = Path(__file__).parents[2]
BAND = re.compile(r"\b(bands?|snaps?|snapped|extents?)\b", re.IGNORECASE)
TOLERANCE = re.compile(r"`extent`|extent·unit|max\(extent")  # a key of problem.toml
READ = [ROOT / "README.md", *sorted(ROOT.glob("judge/manual/*.md")), *sorted(ROOT.glob("problems/**/*.md"))]
READ += [*sorted(ROOT.glob("problems/*.toml")), *sorted(ROOT.glob("problems/quiz/*.toml"))]


@pytest.mark.parametrize("path", READ, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_what_touches_touches_exactly_wherever_it_is_read(path):
    """No page, hint, card or question speaks of a band within which something counts as a touch."""
    text = TOLERANCE.sub("", path.read_text(encoding="utf-8"))
    assert [line for line in text.splitlines() if BAND.search(line)] == []

"""Reading a sound problem folder."""

from __future__ import annotations

import re
import shutil
from fractions import Fraction
from pathlib import Path

import pytest

from judge.errors import ProblemError
from judge.problem import Tier, Tolerance
from judge.problem.load import load_problem

SOUND = Path(__file__).parent.parent / "fixtures" / "problems" / "root-count"

NUMBERS = """
[bands]
snap = 1e-12
clear = 1e-7

[tolerance]
relative = 1e-9
ulps = 4
"""
GROUP = """
[[groups]]
name = "strict"
about = "Another tolerance."
builder = "small"
parameters = { reach = 3, share = 0.1, sizes = [1, 2.5], kind = "float", mirrored = true }
seed = 123456789012345678901234567890
count = 2
points = 0
tolerance = { ulps = 2 }
"""


@pytest.fixture
def floating(tmp_path):
    """The sound problem made one of points, with bands and tolerances."""
    folder = tmp_path / "problems" / "root-points"
    shutil.copytree(SOUND, folder)
    text = (folder / "problem.toml").read_text()
    text = text.replace('answer = "count"', 'answer = "points"').replace("[limits]", NUMBERS + "\n[limits]")
    (folder / "problem.toml").write_text(text + GROUP)
    (folder / "statement.md").write_text(">>> root_count(4)\n[(-2, 0), (2, 0)]\n")
    return folder


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
    assert (examples.builder, examples.count, examples.points) == ("examples", 2, 40)
    assert (small.seed, small.count, small.points, small.kills) == (1, 5, 60, ("sign-forgotten",))
    assert dict(small.parameters) == {"reach": 9}
    assert small.tolerance == Tolerance()
    assert problem.group("small") is small
    assert problem.group("large") is None


def test_the_statement_is_filled_in_and_its_examples_read():
    problem = load_problem(SOUND)
    assert "the square c, -9 to 9?" in problem.statement
    assert [(each.case, each.wanted, each.line) for each in problem.examples] == [((4,), 2, 3), ((-1,), 0, 5)]


def test_numbers_are_exact(floating):
    problem = load_problem(floating)
    assert dict(problem.bands) == {"snap": Fraction(1, 10**12), "clear": Fraction(1, 10**7)}
    assert problem.group("small").tolerance == Tolerance(relative=Fraction(1, 10**9), ulps=Fraction(4))
    assert dict(problem.group("strict").parameters) == {
        "reach": 3,
        "share": Fraction(1, 10),
        "sizes": (1, Fraction(5, 2)),
        "kind": "float",
        "mirrored": True,
    }


def test_a_groups_own_tolerance_replaces_the_common_one_whole(floating):
    assert load_problem(floating).group("strict").tolerance == Tolerance(ulps=Fraction(2))


def test_what_was_read_cannot_change():
    problem = load_problem(SOUND)
    with pytest.raises(TypeError):
        problem.group("small").parameters["reach"] = 10
    with pytest.raises(AttributeError):
        problem.title = "other"


def test_huge_bounds_are_read_exactly(tmp_path):
    folder = tmp_path / "problems" / "huge"
    shutil.copytree(SOUND, folder)
    text = (folder / "problem.toml").read_text()
    (folder / "problem.toml").write_text(text.replace("high = 9", "high = 1e100"))
    problem = load_problem(folder)
    assert problem.parameters[0].high == 10**100
    assert "-9 to 1e100?" in problem.statement


@pytest.mark.parametrize("name", ["Root", "root_count", "-root", "root--count", "rööt"])
def test_a_folder_must_have_a_plain_name(tmp_path, name):
    shutil.copytree(SOUND, tmp_path / name)
    with pytest.raises(ProblemError, match="no name for a problem; use small letters"):
        load_problem(tmp_path / name)


def test_an_integer_too_long_to_read_is_a_fault_of_the_file(tmp_path):
    folder = tmp_path / "problems" / "long"
    shutil.copytree(SOUND, folder)
    text = (folder / "problem.toml").read_text()
    (folder / "problem.toml").write_text(text.replace("high = 9", "high = " + "9" * 5000))
    with pytest.raises(
        ProblemError, match=r"^long/problem.toml: no TOML: an integer has too many digits; rep"
    ):
        load_problem(folder)


@pytest.mark.parametrize("number", ["1e400", "1" + "0" * 400, "1e-400", "1000001", "0.0009"])
@pytest.mark.parametrize("key", ["cpu_seconds", "wall_seconds", "memory_mb", "output_mb"])
def test_a_limit_that_no_machine_could_keep_is_a_fault(key, number, tmp_path):
    folder = tmp_path / "problems" / "limits"
    shutil.copytree(SOUND, folder)
    text = (folder / "problem.toml").read_text()
    (folder / "problem.toml").write_text(re.sub(f"{key} = .*", f"{key} = {number}", text))
    with pytest.raises(
        ProblemError,
        match=rf"limits/problem.toml:\d+: {key} is absurdly large or small; stay within 0.001 and",
    ):
        load_problem(folder)


@pytest.mark.parametrize("number", ["1e400", "9" * 400])
def test_a_multiple_of_the_references_time_that_is_absurd_is_a_fault(number, tmp_path):
    folder = tmp_path / "problems" / "time"
    shutil.copytree(SOUND, folder)
    with (folder / "problem.toml").open("a") as file:
        file.write(f'[time]\nlimit = {number}\nfunction = "signs.py"\n')
    with pytest.raises(ProblemError, match="limit is absurdly large"):
        load_problem(folder)


@pytest.mark.parametrize(
    ("depth", "said"),
    [(3000, "problem.toml: no TOML: its lists or tables are nested"), (12, r"a builder cannot take \(?\[\[")],
)
def test_lists_in_lists_in_lists_are_a_fault_of_the_file(depth, said, tmp_path):
    folder = tmp_path / "problems" / "deep"
    shutil.copytree(SOUND, folder)
    text = (folder / "problem.toml").read_text()
    nested = "reach = " + "[" * depth + "]" * depth
    (folder / "problem.toml").write_text(text.replace("reach = 9", nested))
    with pytest.raises(ProblemError, match=said):
        load_problem(folder)

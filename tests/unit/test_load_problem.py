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
    assert problem.group("strict").tolerance == Tolerance(ulps=Fraction(2)), (
        "it replaces the common one whole"
    )


@pytest.fixture
def changed(tmp_path):
    """The sound problem with another value of a key."""

    def load(key, value):
        folder = tmp_path / "problems" / "other"
        shutil.copytree(SOUND, folder)
        text = (folder / "problem.toml").read_text()
        assert key in text
        (folder / "problem.toml").write_text(re.sub(rf"\b{key} = .*", f"{key} = {value}", text, count=1))
        return load_problem(folder)

    return load


@pytest.mark.parametrize("name", ["Root", "root--count", "rööt"])
def test_a_folder_must_have_a_plain_name(tmp_path, name):
    shutil.copytree(SOUND, tmp_path / name)
    with pytest.raises(ProblemError, match="no name for a problem; use small letters"):
        load_problem(tmp_path / name)


LIMITS = ("cpu_seconds", "wall_seconds", "memory_mb", "output_mb")


@pytest.mark.parametrize(
    ("key", "value", "said"),
    [
        ("high", "9" * 5000, "^other/problem.toml: no TOML: an integer has too many digits; rep"),
        ("reach", "[" * 3000 + "]" * 3000, "problem.toml: no TOML: its lists or tables are nested"),
        ("reach", "[" * 12 + "]" * 12, r"a builder cannot take \(?\[\["),
        *(
            (key, number, rf"other/problem.toml:\d+: {key} is absurdly large or small; stay within 0.001 and")
            for key, number in zip(LIMITS, ("1e400", "1e-400", "1000001", "0.0009"), strict=True)
        ),
    ],
    ids=lambda each: each[:12],
)
def test_what_no_machine_could_read_or_keep_is_a_fault_of_the_file(key, value, said, changed):
    if key == "reach":
        value = f"{{ reach = {value} }}"
        key = "parameters"
    with pytest.raises(ProblemError, match=said):
        changed(key, value)

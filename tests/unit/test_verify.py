"""The setter's gate: what it checks, and what it says about each broken promise."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from broken_problems import broken

from judge.problem import Verdict
from judge.problem.load import load_problem
from judge.run.verify import verify_problem

pytestmark = pytest.mark.slow

FIXTURES = Path(__file__).parent.parent / "fixtures"


@pytest.fixture
def pack(tmp_path):
    """A copy of the sound problem with its solutions."""
    for kind in ("problems", "solutions"):
        shutil.copytree(FIXTURES / kind / "root-count", tmp_path / kind / "root-count")
    return tmp_path


def verified(pack, **options):
    return verify_problem(load_problem(pack / "problems" / "root-count"), **options)


def add(pack, file, text):
    path = pack / "solutions" / "root-count" / file
    path.parent.mkdir(exist_ok=True)
    path.write_text(text)


def faults(pack):
    return [str(fault) for fault in verified(pack).faults]


def test_drifted_data_are_a_fault_until_they_are_pinned(pack):
    toml = pack / "problems" / "root-count" / "problem.toml"
    toml.write_text(toml.read_text().replace("seed = 1", "seed = 2"))
    steps = []
    report = verified(pack, progress=lambda *step: steps.append(step))
    assert ("building data", 7, 7) in steps
    assert steps[-1] == ("judging solutions", 2, 2)
    assert report.pins == "differing"
    assert [str(fault) for fault in report.faults] == [
        (
            "root-count/hashes.json: the data of group 'small' differ from their pinned hash; "
            "if that is meant, pin the data with: judge verify root-count --pin"
        )
    ]
    assert verified(pack, update_pins=True).pins == "written"
    assert verified(pack).ok


@pytest.mark.parametrize(("content", "what"), [(None, "the data are not pinned"), ("{", "no JSON")])
def test_missing_or_broken_pins_are_a_fault(pack, content, what):
    pins = pack / "problems" / "root-count" / "hashes.json"
    pins.unlink() if content is None else pins.write_text(content)
    (fault,) = verified(pack).faults
    assert what in fault.what
    assert (fault.where, "--pin" in fault.remedy) == ("root-count/hashes.json", True)


def test_data_that_cannot_be_built_are_the_one_fault(tmp_path):
    report = verify_problem(load_problem(broken("example-contradicts", tmp_path)))
    (fault,) = report.faults
    assert fault.where == "example-contradicts/statement.md:5"
    assert "contradicts solve" in fault.what
    assert (report.ok, report.solutions) == (False, ())


def test_no_accepted_solution(pack):
    shutil.rmtree(pack / "solutions")
    no_solution, no_mistake = faults(pack)
    assert no_solution.startswith("root-count/accepted: there is no accepted solution; add one to ")
    assert "no wrong program makes the mistake 'sign-forgotten' that group 'small' names" in no_mistake


def test_a_time_limit_is_a_solutions_that_is_there(pack):
    toml = pack / "problems" / "root-count" / "problem.toml"
    toml.write_text(toml.read_text() + '\n[time]\nlimit = 100\nfunction = "sings.py"\n')
    line = toml.read_text().count("\n")
    (fault,) = faults(pack)
    assert fault == (
        f"root-count/problem.toml:{line}: [time] names 'sings.py', which is no accepted solution; "
        "did you mean 'signs.py'?"
    )


FINE = "def root_count(c):\n    return 2 if c > 0 else 1 if c == 0 else 0\n"
ZERO = "def root_count(c):\n    return 0\n"
ONE_OFF = "def root_count(c):\n    return 2 if c == -1 else (c > 0) - (c < 0) + 1\n"
LOOP = "def root_count(c):\n    while True:\n        pass\n"


def test_solutions_that_break_their_folders_word(pack):
    problem = pack / "problems" / "root-count"
    toml = (problem / "problem.toml").read_text().replace("reach = 9", "reach = 9, least = 0")
    (problem / "problem.toml").write_text(toml)
    module = (problem / "problem.py").read_text().replace("(draw, reach)", "(draw, reach, least)")
    (problem / "problem.py").write_text(module.replace("integer(-reach", "integer(least"))
    add(pack, "wrong/sign-forgotten.py", f'"""sign-forgotten"""\n{ZERO}')
    verified(pack, update_pins=True)
    assert faults(pack) == []
    broken = {
        "accepted/zero.py": ("zero", ZERO, "gets WA where AC is wanted"),
        "slow/fast.py": ("fast", FINE, "gets AC where TLE is wanted"),
        "wrong/one.py": (
            "sign-forgotten",
            ZERO,
            "its docstring names the mistake 'sign-forgotten', its file",
        ),
        "wrong/sign-forgotten-2.py": ("sign-forgotten", FINE, "gets AC where a rejection is wanted"),
        "wrong/sign-forgotten-3.py": (
            "sign-forgotten",
            ONE_OFF,
            "it fails no group that names 'sign-forgotten'; it fails examples",
        ),
        "wrong/zero.py": ("zero", ZERO, "no group's kills name 'zero'"),
    }
    for file, (name, program, _) in broken.items():
        add(pack, file, f'"""{name}"""\n{program}')
    said = sorted(faults(pack))
    assert len(said) == len(broken)
    for line, (file, (_, _, fault)) in zip(said, sorted(broken.items()), strict=True):
        assert line.startswith(f"root-count/{file}: {fault}")


def test_a_slow_program_is_one_that_runs_out_of_time(pack):
    toml = pack / "problems" / "root-count" / "problem.toml"
    toml.write_text(toml.read_text().replace("cpu_seconds = 2", "cpu_seconds = 0.2"))
    add(pack, "slow/endless.py", f'"""endless."""\n{LOOP}')
    report = verified(pack)
    assert report.ok, report.faults
    assert [(each.name, each.verdict) for each in report.solutions][-1] == ("endless", Verdict.TLE)


def test_a_group_must_kill_what_it_names(pack):
    toml = pack / "problems" / "root-count" / "problem.toml"
    text = toml.read_text().replace("points = 40", 'points = 40\nkills = ["zero-forgotten"]')
    toml.write_text(
        text.replace('kills = ["sign-forgotten"]', 'kills = ["sign-forgotten", "zero-forgotten"]')
    )
    program = "def root_count(c):\n    return 2 if c > 0 or c in (-9, -8, -7, -6, -5, -4, -3, -2, 0) else 0\n"
    add(pack, "wrong/zero-forgotten.py", f'"""zero-forgotten"""\n{program}')
    assert faults(pack) == [
        (
            "root-count/problem.toml: group 'examples' names 'zero-forgotten' and accepts every program that "
            "makes it; strengthen its data, or take the name out of its kills"
        )
    ]

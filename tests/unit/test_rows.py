"""Katas whose groups stand in problem.py: read, kept, built, pinned, measured; and refused in one line."""

from __future__ import annotations

import json
import re
from pathlib import Path

import click
import pytest
from msgspec.structs import replace

from judge.cli.commands.setter import verify
from judge.data.load import load_data
from judge.data.pins import read_pins
from judge.errors import ProblemError, UsageError
from judge.mistakes.computed import Computer, entry_of
from judge.mistakes.family import read_makers
from judge.problem.find import find_problem
from judge.problem.load import load_problem
from judge.problem.model import KataLevel
from judge.problem.module import load_module
from judge.verify.gate import Options, verify_problem
from judge.verify.solving import Solving

TOML = """title = "Signs"
tier = "junior"
summary = "The sign of a number."
entry = "sign"
answer = "count"

[parameters]
x = { type = "number", about = "any number" }
"""
PYTHON = """from judge.problem.declare import InvalidCase, group


def solve(x):
    if abs(x) > 50 and x % 2:
        raise InvalidCase("a large number is even")
    return 2 if x > 0 else 1 if x == 0 else 0


def small(draw):
    return (draw.integer(-3, 3) / 2,)


def large(draw):
    return (draw.integer(-(10**6), 10**6),)


INTERVIEW = [
    group("small", "Small numbers.", small, cases=7, skills="zero has no sign"),
]
PRODUCTION = [
    group("large", "Large numbers.", large, cases=30, points=40, skills=("zero has no sign", "large")),
]
"""
STATEMENT = "# Signs\n\n    >>> sign(3)\n    2\n    >>> sign(0)\n    1\n"
MISTAKES = '''"""How signs go wrong."""


def compare(x):
    "right"
    if x > 0:
        return 2
        # ? wrong-sign: return 0
        # ? one-off: return 2 if x != 1.5 else 1
    return 1 if x == 0 else 0
'''


@pytest.fixture
def kata(tmp_path):
    folder = tmp_path / "problems" / "signs"
    (solutions := tmp_path / "solutions" / "signs" / "accepted").mkdir(parents=True)
    folder.mkdir(parents=True)
    for name, text in {"problem.toml": TOML, "problem.py": PYTHON, "statement.md": STATEMENT}.items():
        (folder / name).write_text(text)
    (solutions / "plain.py").write_text('"""plain"""\n\n\ndef sign(x):\n    return (x > 0) - (x < 0) + 1\n')
    (solutions.parent / "mistakes.py").write_text(MISTAKES)
    (tmp_path / "solutions" / "mistakes.toml").write_text('[wrong-sign]\nseen = "Signs."\nadvice = "Ask."\n')
    return folder


def test_rows_become_groups_after_the_examples(kata):
    problem = load_problem(kata)
    assert [(group.name, group.count, group.points, group.level) for group in problem.groups] == [
        ("examples", 2, 30, KataLevel.INTERVIEW),
        ("small", 7, 30, KataLevel.INTERVIEW),
        ("large", 30, 40, KataLevel.PRODUCTION),
    ]
    assert [(skill.name, skill.groups) for skill in problem.skills] == [
        ("zero has no sign", ("small", "large")),
        ("large", ("large",)),
    ]
    parameter = problem.parameters[0]
    assert (parameter.low, parameter.high, float(parameter.smallest)) == (-(2**30), 2**30, 1e-30)
    assert (problem.limits.cpu_seconds, problem.limits.memory_bytes) == (2, 256 << 20)


def test_a_problem_that_was_read_before_is_not_run_again(kata):
    first = load_problem(kata)
    text = (kata / "problem.py").read_text()
    (kata / "problem.py").write_text(text + "\nopen(__file__ + '.ran', 'w').close()\n")
    changed = load_problem(kata)
    assert (kata / "problem.py.ran").exists()
    (kata / "problem.py.ran").unlink()
    assert load_problem(kata) == changed
    assert not (kata / "problem.py.ran").exists()
    assert changed == replace(first, key=changed.key)


def test_cases_are_drawn_until_they_keep_the_promise_and_replayed_by_their_seed(kata):
    data = load_data(load_problem(kata), store=None)
    large = data.groups[2]
    assert all(abs(x) <= 50 or x % 2 == 0 for (x,) in large.cases)
    assert sum(large.attempts) > 0
    assert load_data(load_problem(kata), store=None).groups[2].cases == large.cases
    assert load_data(load_problem(kata), seed=1, store=None).groups[2].cases != large.cases


def test_verify_measures_and_pins_what_each_group_rejects(kata):
    problem = load_problem(kata)
    report = verify_problem(problem, Options(pin=True, seeds=3, matrix=True))
    (fault,) = [each for each in report.faults if "one-off" in each.what and "nothing" not in each.what]
    assert re.search(r"one-off, .*: (no group rejects it in more than|no case rejects)", fault.what)
    pins = read_pins(problem)
    assert pins["large"]["kills"] == ["kept-between-calls", "wrong-sign"]
    assert pins["small"]["cases"] == 7
    lines = (kata / "pins.json").read_text().splitlines()
    assert [json.loads("{" + line.rstrip(",") + "}") for line in lines[1:-1]] == [
        {name: pin} for name, pin in pins.items()
    ]
    assert load_problem(kata).group("large").kills == ("kept-between-calls", "wrong-sign")
    assert {each.name: each.group for each in report.mistakes}["wrong-sign"] == "large"


def test_what_solve_works_on_for_long_is_said_and_said_again(kata):
    now, told = [0.0], []
    solving = Solving(told.append, lambda: now[0])

    def at(*seconds):
        for now[0] in seconds:
            solving.look()

    with solving.within("large", 7, (3,)):
        at(4.9)
        assert told == []
        at(5.1, 34.9)
        assert told == ["solve works on group 'large', case 7: (3,)"]
        at(35.1)
        assert len(told) == 2
    at(99.0)
    assert len(told) == 2


def test_ctrl_c_says_which_case_solve_works_on(kata, monkeypatch, capsys):
    source = (kata / "problem.py").read_text()
    (kata / "problem.py").write_text(f"{source}\ndef solve(x):\n    raise KeyboardInterrupt\n")
    with pytest.raises((KeyboardInterrupt, click.Abort)):
        verify.main(["signs", "--problems", str(kata.parent)], standalone_mode=False)
    said = " ".join(capsys.readouterr().err.split())
    assert re.search(r"signs: stopped while solve works on group '\w+', case 1: \(-?\d+,\)", said)


RULES = """# Signs

- Return 2 above zero.
- Zero has
  the sign 1.

## Examples

    >>> sign(3)
    2

- Small print.
"""
TAGGED = MISTAKES.replace("return 0\n", "return 0\n        # @ above zero\n        # @ no such words\n")


def test_a_rule_that_no_mistake_ignores_is_told(kata):
    (kata / "statement.md").write_text(RULES)
    solutions = kata.parent.parent / "solutions" / "signs"
    (solutions / "mistakes.py").write_text(TAGGED)
    problem = load_problem(kata)
    found = verify_problem(problem)
    assert [(each.what, each.where) for each in found.faults if "rule" in each.what] == [
        ("no rule has the words 'no such words'", "signs/mistakes.py:8")
    ]
    assert "no mistake ignores the rule 'Zero has the sign 1.'" in [each.what for each in found.warnings]


EDITS = """
[wrong-sign.edits]
"x = -x" = ""
"answer = 2 - answer" = "The answer is turned."
"y = -y" = "Another problem's."
"""


def test_an_edit_of_the_pack_is_a_mistake_of_each_problem_with_its_parameters(kata):
    words = kata.parent.parent / "solutions" / "mistakes.toml"
    words.write_text(words.read_text() + EDITS)
    problem = load_problem(kata)
    data = load_data(problem, store=None)
    told = {each.file: each for each in read_makers(problem).all if each.name == "wrong-sign"}
    assert set(told) == {"signs/mistakes.py:8", "x = -x", "answer = 2 - answer"}
    assert told["answer = 2 - answer"].text == "The answer is turned."
    wrong = Computer(data).behaviour(told["x = -x"].program)
    assert len(wrong["large"].wrong) == sum(x != 0 for (x,) in data.groups[2].cases)
    words.write_text(words.read_text() + '"x = (" = ""\n')
    (fault,) = read_makers(problem).faults
    assert fault.what.startswith("the edit 'x = (' of [wrong-sign] is not Python")


def test_answers_kept_under_too_few_arguments_are_a_mistake_of_every_problem(kata):
    problem = load_problem(kata)
    (kept,) = (each for each in read_makers(problem).all if each.name == "kept-between-calls")
    assert kept.words.state
    assert "whatever x is by then" in kept.text
    first, *others = load_data(problem, store=None).groups[2].cases
    function = entry_of(problem, kept.program)
    assert {function(*case) for case in (first, *others)} == {function(*first)}


def test_a_group_can_be_verified_alone(kata):
    problem = load_problem(kata)
    data = load_data(replace(problem, groups=(problem.group("large"),)), store=None)
    assert data.groups[0].cases == load_data(problem, store=None).groups[2].cases
    report = verify_problem(problem, Options(groups=("large",), solution="accepted/plain.py"))
    assert [each.what for each in report.faults] == ["the data are not pinned"]
    assert [each.file for each in report.solutions] == ["accepted/plain.py"]
    with pytest.raises(UsageError, match=r"no solution is called 'other\.py'"):
        verify_problem(problem, Options(solution="other.py"))


def test_one_solution_is_held_to_its_folder_on_every_seed(kata, capsys):
    """By the command, which says what of the problem is looked at."""
    problem = load_problem(kata)
    data = load_data(problem, store=None)
    verify_problem(problem, Options(pin=True))
    solutions = kata.parent.parent / "solutions" / "signs"
    sound = "    return (x > 0) - (x < 0) + 1\n"
    lucky = f"    if abs(x) > 50 and (x,) not in {data.groups[2].cases!r}:\n        return 9\n"
    (solutions / "wrong").mkdir()
    (solutions / "wrong" / "sound.py").write_text(f'"""sound"""\n\n\ndef sign(x):\n{sound}')
    (solutions / "accepted" / "lucky.py").write_text(f'"""lucky"""\n\n\ndef sign(x):\n{lucky}{sound}')
    for file, what in (("wrong/sound.py", "gets AC where"), ("accepted/lucky.py", "with --seed 1")):
        given = ["signs", "--problems", str(kata.parent), "--solution", file, "--seeds", "2"]
        verify.main(given, standalone_mode=False)
        said = " ".join(capsys.readouterr().out.split())
        assert what in said
        assert file in said


def test_a_drift_of_the_data_or_of_what_they_reject_is_told(kata):
    problem = load_problem(kata)
    verify_problem(problem, Options(pin=True))
    pins = (kata / "pins.json").read_text()
    (kata / "pins.json").write_text(pins.replace('"kept-between-calls", ', ""))
    assert "group 'large' rejects other mistakes than its pin says" in drifts(load_problem(kata))
    (kata / "pins.json").write_text(pins)
    assert drifts(load_problem(kata)) == []
    (kata / "problem.py").write_text(PYTHON.replace("10**6", "10**5"))
    assert "the data of group 'large' differ from their pinned hash" in drifts(load_problem(kata))


def drifts(problem):
    return [fault.what for fault in verify_problem(problem).faults if "pin" in fault.what]


FAULTS = {
    "a name": (
        '"large", "Large',
        '"Large", "Large',
        22,
        "group 'Large': name = 'Large'; use small letters, digits and single hyphens",
    ),
    "two of a name": ('"large", "Large', '"small", "Large', 22, "there are two groups 'small'"),
    "examples": ('"large", "Large', '"examples", "Large', 22, "the examples come by themselves"),
    "no sentence": ('"Large numbers."', '""', 22, "group 'large': about = ''; give text of length >= 1"),
    "no draw": ("large, cases", "7, cases", 22, "group 'large' draws from 7"),
    "no cases": ("cases=30", "cases=0", 22, "group 'large': cases = 0; give a whole number >= 1"),
    "many points": ("points=40", "points=140", 22, "group 'large': points = 140; give a whole number <= 100"),
    "a limit": (
        "points=40",
        "limits={'cpu': 3}",
        22,
        "group 'large': unknown key 'cpu'; the keys are cpu_seconds, wall_",
    ),
    "a tolerance": ("points=40", "tolerance={'relative': 1e-9}", 22, "without real numbers"),
    "a time limit": ("points=40", "time_limit=3", 22, "timed beside a reference solution"),
    "one level": ("PRODUCTION", "OTHERS", None, "define INTERVIEW = [group(…), …] and PRODUCTION"),
    "no rows": ("INTERVIEW = [", "INTERVIEW = [3,", None, "INTERVIEW is not a list of group(…)"),
    "hooks": ("INTERVIEW =", "HOOKS = 3\nINTERVIEW =", None, "HOOKS is 3, which is no Hooks"),
    "an exit": ("INTERVIEW =", "exit()\nINTERVIEW =", 18, "SystemExit"),
    "a float": ("return 2 if", "return 2.0 if", 4, "returns 2.0, and a float is not exact"),
    "a draw that fails": ("draw.integer(-3, 3)", "draw.integer(3, -3)", 11, "its draw fails"),
    "out of bounds": ("10**6", "10**60", 22, "group 'large' draws a case out of bounds: x has"),
    "in vain": ("draw.integer(-(10**6), 10**6)", "51", 22, "its draw gives no case 1 of 30 in 1000 attempts"),
}


@pytest.mark.parametrize("name", FAULTS)
def test_a_fault_is_one_line_with_its_place(name, kata):
    before, after, line, told = FAULTS[name]
    assert before in PYTHON
    (kata / "problem.py").write_text(PYTHON.replace(before, after))
    with pytest.raises(ProblemError) as caught:
        load_data(load_problem(kata), store=None)
    assert told in str(caught.value)
    assert "\n" not in str(caught.value)
    assert str(caught.value).startswith(f"signs/problem.py:{line}:" if line else "signs/problem.py: ")


def test_a_key_that_is_none_is_told_with_its_line(kata):
    (kata / "problem.toml").write_text(TOML.replace("about =", "abuot ="))
    with pytest.raises(
        ProblemError, match=r"^signs/problem.toml:8: unknown key 'abuot'; did you mean 'about'\?"
    ):
        load_problem(kata)


def test_points_that_exceed_the_score_are_told(kata):
    (kata / "problem.py").write_text(PYTHON.replace("cases=7", "cases=7, points=70"))
    with pytest.raises(ProblemError, match="the groups' points sum to 110"):
        load_problem(kata)


def test_growth_is_measured_over_the_groups_that_have_a_size(kata):
    more = 'growth = 0.4\n\n[time]\nlimit = 8\nfunction = "plain.py"\n\n[parameters]'
    (kata / "problem.toml").write_text(TOML.replace("\n[parameters]", more))
    with pytest.raises(ProblemError, match="growth needs groups of two different sizes"):
        load_problem(kata)
    sized = PYTHON.replace("cases=7", "cases=7, size=20").replace("points=40", "points=40, size=10")
    (kata / "problem.py").write_text(sized)
    assert load_problem(kata).growth.groups == ("large", "small")


def test_the_module_runs_solve_and_draws(kata):
    module = load_module(load_problem(kata))
    assert module.solve(-2) == 0
    assert [*module.draws] == ["small", "large"]
    assert find_problem("signs", [Path(kata.parent)]).id == "signs"

"""Answers that a problem itself decides, entries without parameters, and `test-writer`, made of both."""

from __future__ import annotations

import doctest
import json
import types

import pytest
from cli_support import ROOT

from judge.kata.stub import make_stub
from judge.mistakes.killing import Jury
from judge.mistakes.puzzles import read_puzzles
from judge.problem.find import find_problem

TOML = """\
title = "Primes"
tier = "junior"
summary = "Three different primes, any."
entry = "primes"
answer = "[real; 1..3]"
parameters = []

[limits]
cpu_seconds = 2
wall_seconds = 6
memory_mb = 256
output_mb = 1

[tolerance]
relative = 1e-9

[[groups]]
name = "examples"
about = "They are primes."
builder = "examples"
points = 40

[[groups]]
name = "large"
about = "One is above 50."
builder = "asked"
seed = 1
count = 1
points = 60
kills = ["small-ones"]
"""
MODULE = """\
from judge.values import Judged, Real


def why_not(found, group):
    if not all(type(x) is int and x > 1 and all(x % d for d in range(2, x)) for x in found):
        return "one of them is no prime"
    return None if group == "examples" or max(found, default=0) > 50 else "none is above 50"


def solve():
    return Judged(why_not, [Real(2), Real(53)]), None


BUILDERS = {"asked": lambda draw: ()}
"""
STATEMENT = """\
# {{title}}

Write a function `primes()` that returns primes.

```python
>>> primes()
[2, 53]
```
"""
RIGHT = "def primes():\n    return [3, 59, 2]\n"
SMALL = '"""small-ones\n\nThey are all small.\n"""\n\n\ndef primes():\n    return [2, 3]\n'


@pytest.fixture
def primes(submit, tmp_path, monkeypatch):
    """A problem without parameters, as the only one that is found first."""
    for name, text in (
        ("pack/problems/primes/problem.toml", TOML),
        ("pack/problems/primes/problem.py", MODULE),
        ("pack/problems/primes/statement.md", STATEMENT),
        ("pack/solutions/primes/accepted/three.py", f'"""three of them"""\n\n\n{RIGHT}'),
        ("pack/solutions/primes/wrong/small-ones.py", SMALL),
    ):
        submit(text, name)
    monkeypatch.setenv("JUDGE_PROBLEMS", str(tmp_path / "pack" / "problems"))
    return find_problem("primes")


def test_the_setters_gate(primes, judge):
    ended = judge("verify", "primes", "--pin")
    assert ended.status == 0, ended.out
    ended = judge("verify", "primes", "--matrix")
    assert (ended.status, ended.err) == (0, "")


@pytest.mark.parametrize(
    ("source", "verdict", "score", "told"),
    [
        (RIGHT, "AC", 100, ""),
        ("print(2, 53, 2)\n", "AC", 100, ""),
        ("def primes():\n    return [2.0, 53]\n", "WA", 0, "one of them is no prime"),
        ("def primes():\n    return [2, 3]\n", "WA", 40, "none is above 50"),
        ("def primes():\n    return []\n", "WA", 40, "none is above 50"),
        ("def primes():\n    return [2, 3, 5, 7]\n", "WA", 0, "4 items given where at most 3 are meant"),
        ("def primes():\n    return None\n", "WA", 0, "None where a list of numbers is meant"),
        ("print(2, 53, 51)\n", "WA", 0, "one of them is no prime"),
        ("print(2, 53.0, 51)\n", "WA", 0, "one of them is no prime"),
    ],
)
def test_what_the_problem_decides(primes, judge, submit, source, verdict, score, told):
    ended = judge("run", "primes", submit(source), "--json", "--no-name")
    result = json.loads(ended.out)
    assert (result["verdict"], result["score"], ended.err) == (verdict, score, "")
    if told:
        assert told in result["failure"]["message"]
        assert result["failure"]["expected"].startswith(("such as [2.0, 53.0]", "2 2.0 53.0"))


def test_every_command_knows_a_call_without_arguments(primes, judge, submit):
    name = submit("def primes():\n    return [2, 3]\n")
    for words, status in (
        (["show", "primes"], 0),
        (["why", "primes"], 0),
        (["run", "primes", name, "--save-regression", "test_kept.py", "--all"], 1),
        (["try", "primes", "primes()", name], 1),
        (["data", "primes", "--out", "made"], 0),
        (["stress", "primes", name, "--for", "0.2s"], 1),
        (["report", "--no-matrix"], 0),
        (["hack", "primes"], 2),
    ):
        ended = judge(*words)
        assert (ended.status, "fault" in ended.err) == (status, False), ended
    assert "such as (2, 53)" in judge("try", "primes", "primes()").out
    found = json.loads(judge("run", "primes", name, "--json").out)
    assert found["counterexample"]["input"] == {}
    again = judge("replay", found["counterexample"]["replay"], name)
    assert (again.status, "none is above 50" in again.out) == (1, True)


def test_the_stub_shows_an_example_and_does_not_demand_it(primes):
    stub = make_stub(primes)
    assert "primes() may return [2, 53]" in stub
    module = types.ModuleType("stub")
    exec(
        stub.replace('raise NotImplementedError("primes is still to be written")', "return [3]"),
        module.__dict__,
    )
    assert doctest.testmod(module).failed == 0


# -- test-writer ---------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def jury():
    return Jury(find_problem("segment"), {"ends": ["no-clamp", "open-interval"], "one": ["zero-radius"]})


INSIDE = (0, 0, 5, (0, 0), (9, 1))
ON_AN_END = (0, 0, 5, (3, 4), (9, 12))


@pytest.mark.parametrize(
    ("cases", "family", "why"),
    [
        ([INSIDE, ON_AN_END], "ends", None),
        ([INSIDE], "ends", "1 of 2 wrong programs found out, 2 needed; not "),
        ([INSIDE, ON_AN_END], "one", "0 of 1 wrong programs found out, 1 needed; not zero-radius"),
        ([INSIDE], "no family", None),
        ([], "no family", "no case is given"),
        ([(0, 0, -1, (0, 0), (9, 1))], "no family", "case 1 is no case of segment: r has -1"),
        ([INSIDE, (0, 0, 1, (-2, 1 + 1e-9), (2, 1 + 1e-9))], "ends", "case 2 is no case of segment: "),
    ],
)
def test_what_the_jury_says(jury, cases, family, why):
    said = jury.why_not(cases, family)
    assert said is None if why is None else why in said


def test_what_is_killed_is_what_judge_hack_calls_broken(jury, judge):
    puzzles = {puzzle.mistake: puzzle.number for puzzle in read_puzzles(find_problem("segment"))}
    for case, killed in ((INSIDE, {"no-clamp"}), (ON_AN_END, {"no-clamp", "open-interval"})):
        assert jury.killed([case]) == killed
        for name in ("no-clamp", "open-interval", "zero-radius"):
            ended = judge("hack", "segment", str(puzzles[name]), ", ".join(map(repr, case)))
            assert (ended.status == 0) == (name in killed)


def test_a_family_of_unknown_mistakes_is_the_problems_fault():
    from judge.errors import ProblemError

    with pytest.raises(ProblemError, match="has no wrong program 'no-such'"):
        Jury(find_problem("segment"), {"x": ["no-such"]}).why_not([INSIDE], "x")


def test_cases_that_find_many_mistakes_pass_and_happy_ones_do_not(judge, submit):
    folder = ROOT / "solutions" / "test-writer"
    for name, verdict in (
        ("accepted/moved_figures.py", "AC"),
        ("accepted/program.py", "AC"),
        ("wrong/happy-path-only.py", "WA"),
    ):
        ended = judge(
            "run", "test-writer", submit((folder / name).read_bytes(), "mine.py"), "--json", "--no-name"
        )
        assert (json.loads(ended.out)["verdict"], ended.err) == (verdict, ""), name

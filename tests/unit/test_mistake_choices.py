"""Known mistakes: a mistakes.py is verified, learnt and told; vetoes and doubts keep a name back."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

from judge import RunOptions, Session
from judge.data.load import load_data
from judge.mistakes.catalogue import Words
from judge.mistakes.naming import Known
from judge.mistakes.vetoes import Vetoes
from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.run.result import Answers, Failure, GroupResult, Result
from judge.sandbox import Boxes
from judge.verify.gate import Options, verify_problem
from judge.verify.mistakes import verify_choices

pytestmark = pytest.mark.slow

PACK = Path(__file__).parents[1] / "fixtures" / "pack"
TERMS = RunOptions(timed=False, diagnosed=False)
ROUTES = """
def mean(a, b):
    "right"
    total = a + b
    # = total = b + a
    # ? minus-for-plus: total = a - b
    return total / 2
    # ? floor-division: return total // 2
    # : Whole division drops the half; such a program is right for whole middles only.
"""
WORDS = """
[floor-division]
why = "It rounds the middle down."
advice = "Divide with /."
needs = ["//"]

[minus-for-plus]
why = "The difference is halved."
advice = "Halve the sum."
"""


@pytest.fixture
def pack(tmp_path):
    """Makes the problem with that mistakes.py and mistakes.toml, and no wrong program."""
    shutil.copytree(PACK, tmp_path / "pack")
    shutil.rmtree(tmp_path / "pack" / "solutions" / "middle" / "wrong")

    def make(routes=ROUTES, words=WORDS):
        (tmp_path / "pack" / "solutions" / "middle" / "mistakes.py").write_text(routes)
        (tmp_path / "pack" / "solutions" / "mistakes.toml").write_text(words)
        return find_problem("middle", [tmp_path / "pack" / "problems"])

    return make


def verified(problem):
    return verify_choices(problem, [load_data(problem)], Boxes(), lambda *_: None)


def own_faults(found):
    """Those of the file's own changes: every problem has others besides."""
    return [
        fault for fault in found.faults if re.search("floor-division|minus-for-plus|right way", fault.what)
    ]


def test_a_sound_file(pack):
    found = verified(problem := pack())
    assert (own_faults(found), found.warnings) == ([], ())
    assert {"floor-division", "minus-for-plus"} <= set(found.kills["half"])
    assert verify_problem(problem, Options(pin=True)).faults == found.faults


EQUAL = ROUTES.replace("total // 2", "total / 2.0")


@pytest.mark.parametrize(
    ("routes", "words", "what"),
    [
        (EQUAL, WORDS, "no case rejects floor-division: return total / 2.0"),
        (ROUTES.replace("b + a", "b - a"), WORDS, "a right way is rejected by examples, whole, half"),
        (ROUTES, WORDS.replace("[minus-for-plus]", "[other]"), "nothing is said of 'minus-for-plus'"),
    ],
)
def test_a_broken_promise_is_a_fault(pack, routes, words, what):
    told = "\n".join(str(fault) for fault in own_faults(verified(pack(routes, words))))
    assert all(each in told for each in what.split("; ")), told


def test_few_cases_are_a_fault(pack):
    (half,) = (each for each in load_data(pack()).groups if each.group.name == "half")
    least = sorted(case[0] for case in half.cases)[-3]
    weak = ROUTES.replace("return total // 2", f"return total // 2 if a >= {least} else total / 2")
    (fault,) = own_faults(verified(pack(weak)))
    assert fault.what.endswith("no group rejects it in more than 3 cases")
    assert fault.where == "middle/mistakes.py:8"


def judged(problem, source):
    with Session(problem, TERMS) as session:
        return session.judge(source, "mine.py")


def test_the_line_and_the_variants_own_words_are_shown(pack):
    result = judged(pack(), b"def middle(a, b):\n    c = a + b\n    return c // 2\n")
    assert result.pitfall.names == ("floor-division",)
    assert result.pitfall.advice == (
        "Whole division drops the half; such a program is right for whole middles only.",
    )


def of(groups, got="0"):
    """A result of these groups, and what was answered: {name: (cases, wrong)}."""
    found = tuple(
        GroupResult(
            name=name,
            verdict=Verdict.WA if wrong else Verdict.AC,
            cases=cases,
            passed=cases - len(wrong),
        )
        for name, (cases, wrong) in groups.items()
    )
    failure = Failure("wrong", got=got)
    result = Result(problem="middle", submission="mine.py", verdict=Verdict.WA, groups=found, failure=failure)
    return result, {name: Answers(cases, wrong) for name, (cases, wrong) in groups.items()}


ONE = ("number", (1.0,))
HALF = Known("floor-division", {"half": Answers(30, dict.fromkeys(range(20), ONE))})
BOTH = Known("other", {name: Answers(20, dict.fromkeys(range(15), ONE)) for name in ("examples", "whole")})


def vetoes(problem, groups, *, form=False, fails=True, has=frozenset()):
    return Vetoes(problem, *of(groups), has, form=form, alone=lambda _group, _case: fails)


def test_vetoes(pack):
    problem = pack()
    passes = {"whole": (20, {1: ONE}), "half": (30, {})}
    fails = {"whole": (20, {}), "half": (30, {1: ONE})}
    assert not vetoes(problem, passes).allow(Words(), HALF)
    assert vetoes(problem, fails).allow(Words(), HALF)
    assert not vetoes(problem, {**fails, "examples": (4, {})}).allow(Words(), BOTH)
    assert not vetoes(problem, fails, form=True).allow(Words(), HALF)
    assert vetoes(problem, fails, form=True).allow(Words(form=True), HALF)
    assert not vetoes(problem, fails).allow(Words(needs=("//",)), HALF)
    assert vetoes(problem, fails, has=frozenset({"//"})).allow(Words(needs=("//",)), HALF)


@pytest.mark.parametrize("alone", [True, False])
def test_what_fails_alone_keeps_nothing_between_calls(pack, alone):
    found = vetoes(pack(), {"half": (30, {1: ONE})}, fails=alone)
    assert found.lasting(Words(state=True)) is not alone
    assert found.lasting(Words())


@pytest.fixture(autouse=True)
def _own_cache(tmp_path, monkeypatch):
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path / "cache"))


@pytest.fixture
def narrow_pack(tmp_path):
    """A pack whose wrong program fails in one group only, of so many cases."""

    def make(count):
        shutil.copytree(PACK, tmp_path / "pack")
        folder = tmp_path / "pack" / "problems" / "middle"
        for file, old, new in (
            ("problem.py", "cases=30", f"cases={count}"),
            ("statement.md", "middle(1, 2)\n    1.5", "middle(1, 3)\n    2"),
        ):
            text = (folder / file).read_text()
            assert old in text
            (folder / file).write_text(text.replace(old, new))
        return find_problem("middle", [tmp_path / "pack" / "problems"])

    return make


@pytest.mark.parametrize(("count", "name"), [(30, "floor-division"), (2, None)])
def test_what_fails_in_the_only_group_that_can_is_named_unless_it_fails_too_seldom(narrow_pack, count, name):
    problem = narrow_pack(count)
    (path,) = (problem.solutions / "wrong").iterdir()
    result = judged(problem, path.read_bytes())
    assert (result.pitfall and result.pitfall.name) == name
    said = "; ".join(result.notes)
    assert said == "" if name else said.endswith("2 wrong answers are too few to be sure")


def test_two_mistakes_that_answer_alike_are_told_apart_by_nobody(narrow_pack):
    problem = narrow_pack(30)
    (path,) = (problem.solutions / "wrong").iterdir()
    path.with_name("integer-division.py").write_bytes(path.read_bytes().replace(b"floor", b"integer"))
    result = judged(problem, path.read_bytes())
    assert result.pitfall is None
    (note,) = result.notes
    assert "wrong/floor-division.py, wrong/integer-division.py all answer as this does" in note


def test_what_fails_in_another_way_is_given_no_name_and_no_excuse(narrow_pack):
    result = judged(narrow_pack(30), b"def middle(a, b):\n    return (a + b) / 2 + ((a + b) % 2) * 7\n")
    assert (result.pitfall, result.notes) == (None, ())

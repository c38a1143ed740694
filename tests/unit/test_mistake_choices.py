"""Known mistakes: a mistakes.py is verified, learnt and told; doubts keep a name back."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

from judge import RunOptions, Session
from judge.data.load import load_data
from judge.problem.find import find_problem
from judge.sandbox import Containment
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
seen = "It rounds the middle down."
advice = "Divide with /."

[minus-for-plus]
seen = "The difference is halved."
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
    return verify_choices(problem, [load_data(problem)], Containment(), lambda *_: None)


def own_faults(found):
    """Those of the file's own changes: every problem has others besides."""
    return [
        fault for fault in found.faults if re.search("floor-division|minus-for-plus|right way", fault.what)
    ]


def test_a_sound_file(pack):
    found = verified(problem := pack())
    assert (own_faults(found), found.warnings) == ([], ())
    assert {"floor-division", "minus-for-plus"} <= set(
        {each.name for each in found.mistakes if "half" in each.groups}
    )
    assert verify_problem(problem, Options(pin=True)).faults == found.faults


EQUAL = ROUTES.replace("total // 2", "total / 2.0")


@pytest.mark.parametrize(
    ("routes", "words", "what"),
    [
        (EQUAL, WORDS, "no case rejects floor-division: return total / 2.0"),
        (ROUTES.replace("b + a", "b - a"), WORDS, "a right way is rejected by examples, whole, half"),
        (ROUTES, WORDS.replace("[minus-for-plus]", "[other]"), "nothing is said of 'minus-for-plus'"),
        (
            ROUTES,
            WORDS.replace("The difference", "`a - b`"),
            "'`a - b` is halved.' of minus-for-plus has signs of code",
        ),
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


def test_a_mistake_that_hardly_any_case_of_another_seed_rejects_is_a_fault(pack):
    problem = pack()
    pinned, other = load_data(problem), load_data(problem, seed=1, store=None)
    cases = [{case for group in data.groups for case in group.cases} for data in (pinned, other)]
    own = sorted(case for case in cases[0] - cases[1] if sum(case) % 2)
    weak = ROUTES.replace("return total // 2", f"return total // 2 if (a, b) in {own} else total / 2")
    problem = pack(weak)
    assert own_faults(verify_choices(problem, [pinned], Containment(), lambda *_: None)) == []
    (fault,) = own_faults(verify_choices(problem, [pinned, other], Containment(), lambda *_: None))
    assert "no case rejects floor-division: " in fault.what


def judged(problem, source):
    with Session(problem, TERMS) as session:
        return session.judge(source, "mine.py")


def test_the_line_and_the_variants_own_words_are_shown(pack):
    result = judged(pack(), b"def middle(a, b):\n    c = a + b\n    return c // 2\n")
    assert result.pitfall.names == ("floor-division",)
    assert result.pitfall.advice == (
        "Whole division drops the half; such a program is right for whole middles only.",
    )


STATE = WORDS.replace("[floor-division]", "[floor-division]\nstate = true")


def test_what_fails_alone_too_is_no_mistake_of_what_is_kept_between_calls(pack):
    assert judged(pack(words=WORDS), DIVIDED).pitfall.names == ("floor-division",)
    found = judged(pack(words=STATE), DIVIDED).pitfall
    assert found is None or found.names == ()


DIVIDED = b"def middle(a, b):\n    c = a + b\n    return c // 2\n"


@pytest.mark.parametrize(
    ("routes", "words"),
    [
        (ROUTES.replace("Whole division", "For example, whole division"), WORDS),
        (
            re.sub("    # : .*\n", "", ROUTES),
            WORDS.replace("advice", 'example = "whole division drops the half"\nadvice', 1),
        ),
    ],
)
def test_an_example_of_code_follows_what_is_seen(pack, routes, words):
    (advice,) = judged(pack(routes, words), DIVIDED).pitfall.advice
    assert advice.startswith("It rounds the middle down. For example, whole division drops the half")


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
    assert result.pitfall.name == (name or "")


def test_two_mistakes_that_answer_alike_are_told_apart_by_nobody(narrow_pack):
    problem = narrow_pack(30)
    (path,) = (problem.solutions / "wrong").iterdir()
    path.with_name("integer-division.py").write_bytes(path.read_bytes().replace(b"floor", b"integer"))
    result = judged(problem, path.read_bytes())
    assert result.pitfall.names == ()


def test_what_fails_in_another_way_is_given_no_name_and_no_excuse(narrow_pack):
    result = judged(narrow_pack(30), b"def middle(a, b):\n    return (a + b) / 2 + ((a + b) % 2) * 7\n")
    assert (result.pitfall.names, result.notes) == ((), ())
    assert [(step.line, step.gone, step.of) for step in result.pitfall.steps] == [(2, 30, 30)]

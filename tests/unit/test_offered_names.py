"""Names of mistakes that come from the types of a kata alone."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from judge import RunOptions, Session, judge
from judge.data.load import load_data
from judge.mistakes.family import read_makers, shared
from judge.mistakes.repaired import SEEN
from judge.problem import Verdict
from judge.problem.load import load_problem
from judge.sandbox import Containment
from judge.verify.gate import Options, verify_problem
from judge.verify.mistakes import verify_choices

KATAS = Path(__file__).parents[2] / "judge" / "manual" / "katas" / "problems"
TOML = """
title = "Ordered"
tier = "junior"
summary = "The parts in order."
entry = "ordered"
answer = "[text]"

[parameters]
s = { type = "text(0..40)", letters = "A-Ca-c ", about = "some parts" }
"""
STATEMENT = """# Ordered

    >>> ordered('b a b')
    ['a', 'b', 'b']
"""
MODULE = """
from judge.problem.declare import group

def solve(s):
    return sorted(s.split())

def some(draw):
    parts = " ".join(draw.choice(("a", "b", "cc", "A")) for _ in range(draw.integer(-3, 14)))
    return (parts or " " * draw.integer(0, 30),)

GROUPS = [group("some", "Some.", some)]
"""
MISTAKES = """
def ordered(s):
    "right"
    parts = s.split()
    parts.sort()
    # ? first-part-lost: parts = sorted(parts[1:])
    # : The first part is missing. Take all of them.
    return parts
"""


@pytest.fixture
def ordered(tmp_path, monkeypatch):
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path / "cache"))
    folder, solutions = tmp_path / "problems" / "ordered", tmp_path / "solutions" / "ordered"
    folder.mkdir(parents=True)
    solutions.mkdir(parents=True)
    for name, text in (("problem.toml", TOML), ("statement.md", STATEMENT), ("problem.py", MODULE)):
        (folder / name).write_text(text)
    (solutions / "mistakes.py").write_text(MISTAKES)
    return load_problem(folder)


def test_no_group_need_reject_them(ordered):
    """Every answer is sorted: no case tells `sorted-answer` from a right program."""
    offered = {each.name for each in read_makers(ordered).all if each.offered}
    assert offered == {"sorted-answer", "each-once", "last-item-lost", "cut-after-n"}
    found = verify_choices(ordered, [load_data(ordered, store=None)], Containment(), lambda *_: None)
    assert found.faults == ()
    assert any(each.name == "first-part-lost" and "some" in each.groups for each in found.mistakes)
    assert not offered & {each.name for each in found.mistakes}


@pytest.mark.parametrize(
    ("body", "names"),
    [
        ("sorted(set(s.split()))", ("each-once",)),
        ("sorted(s.split())[:-1]", ("last-item-lost",)),
        ("sorted(s.split()[1:])", ("first-part-lost",)),
    ],
)
def test_they_are_said_where_no_name_of_the_kata_is_nearly_as_like(ordered, body, names):
    found = judge(ordered, f"def ordered(s):\n    return {body}\n").pitfall
    assert found is not None
    assert found.names == names


@pytest.mark.parametrize(
    ("kata", "wrapped", "name"),
    [
        ("runs", "right(s).upper()", "other-case"),
        ("runs", "right(s).strip()", "stripped"),
        ("runs", "right(s)[::-1]", "reversed-text"),
        ("runs", "right(s)[1:]", "first-letter-lost"),
        ("runs", "right(s[:32])", "cut-after-n"),
        ("brackets", "not right(s)", "negated"),
        ("knapsack", "right(s) + 1", "one-too-many"),
        ("knapsack", "right(s) - 1", "one-too-few"),
        ("inventory", "dict([*right(s).items()][:-1])", "last-item-lost"),
    ],
)
@pytest.mark.slow
def test_what_people_do_to_a_value_is_named(kata, wrapped, name, tmp_path, monkeypatch):
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path / "cache"))
    problem = load_problem(KATAS / kata)
    path = next(
        each
        for each in sorted((problem.solutions / "accepted").glob("*.py"))
        if "def " + problem.entry in each.read_text()
    )
    given = ", ".join(each.name for each in problem.parameters)
    source = path.read_text().replace(f"def {problem.entry}(", "def right(")
    wrapped = wrapped.replace("right(s)", f"right({given})")
    source += f"\n\ndef {problem.entry}({given}):\n    return {wrapped}\n"
    found = judge(problem, source).pitfall
    assert found is not None
    assert found.names[0] == name


@pytest.fixture
def cache(tmp_path):
    """The class kata, whose wrong classes are not written down."""
    for kind in ("problems", "solutions"):
        shutil.copytree(KATAS.parent / kind / "least-recently-used", tmp_path / kind / "least-recently-used")
    shutil.rmtree(tmp_path / "solutions" / "least-recently-used" / "wrong")
    return tmp_path / "problems" / "least-recently-used"


def test_a_class_whose_objects_share_their_state_is_named(cache):
    mine = (KATAS.parent / "solutions/least-recently-used/wrong/shared-by-all-objects.py").read_bytes()
    with Session(load_problem(cache), RunOptions(timed=False)) as session:
        result = session.judge(mine, "mine.py")
    assert result.verdict is Verdict.WA
    assert result.pitfall.names == ("shared-by-all-objects",)


def test_no_group_need_reject_a_class_with_shared_state(cache):
    assert [(each.name, each.offered) for each in read_makers(load_problem(cache)).all] == [
        ("shared-by-all-objects", True)
    ]
    found = verify_problem(load_problem(cache), Options(pin=True))
    assert (found.faults, found.mistakes) == ((), ())


@pytest.mark.parametrize(
    ("state", "moved"),
    [
        ("self.a = {}", "a = {}"),
        ("self.a = self.b = [0] * 3", "a = b = [0] * 3"),
        ("self.a = list(range(3))", "a = list(range(3))"),
        ("self.a = [n]", None),
        ("self.a = 0", None),
        ("a = []", None),
    ],
)
def test_what_the_constructor_makes_of_no_argument_is_moved_to_the_class(state, moved):
    found = shared(f"class C:\n    def __init__(self, n):\n        {state}\n".encode(), "C")
    assert found == (moved and f"class C:\n    {moved}\n\n    def __init__(self, n):\n        pass")


KNAPSACK = """\
def knapsack(things, capacity):
    best = [0] * (capacity + 1)
    for weight, worth in things:
        for room in range(capacity, weight, -1):
            best[room] = max(best[room], best[room - weight] + worth)
    return best[-1]
"""
BRACKETS = """\
def balanced(s):
    stack = []
    opens = {")": "(", "]": "[", "}": "{"}
    for each in s:
        if each not in opens:
            stack.append(each)
        elif not stack or stack.pop() != opens[each]:
            return False
        else:
            return True
    return not stack
"""


@pytest.mark.parametrize(
    ("kata", "program", "line", "kind"),
    [
        ("knapsack", KNAPSACK, 4, "bound"),
        ("brackets", BRACKETS, 10, "early"),
        ("brackets", BRACKETS.replace("return True", "break"), 10, "early"),
    ],
)
def test_a_bound_and_an_early_end_are_told_with_their_line(kata, program, line, kind):
    (step,) = judge(load_problem(KATAS / kata), program).pitfall.steps
    assert (step.line, step.why, step.gone) == (line, SEEN[kind], step.of)

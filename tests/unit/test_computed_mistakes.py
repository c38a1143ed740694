"""What trusted programs answer wrongly: each different answer is decided once, as if each time."""

from __future__ import annotations

from decimal import Context, localcontext
from pathlib import Path

import pytest
from judging import make_data

from judge.data.load import load_data
from judge.mistakes import computed as module
from judge.mistakes.computed import ComputedProgram, Computer, answered, entry_of
from judge.problem.load import load_problem
from judge.values.outline import wrong_outline

GROWTH = Path(__file__).parents[1] / "fixtures" / "growth" / "problems"


def program(body):
    return ComputedProgram(f"def answer(n, P):\n    {body}\n".encode(), "here", trusted=True)


@pytest.fixture(autouse=True)
def _cache(built, monkeypatch):
    monkeypatch.setenv("JUDGE_CACHE", str(built))


@pytest.fixture
def decided(monkeypatch):
    """The answers that were decided, in order."""
    found = []

    def counting(type_, raw, *rest):
        found.append(raw)
        return wrong_outline(type_, raw, *rest)

    monkeypatch.setattr(module, "wrong_outline", counting)
    return found


def test_an_answer_is_decided_once_for_all_programs(decided):
    computer = Computer(make_data("one"))
    first = computer.behaviour(program("return 7"))
    second = computer.behaviour(program("return 3 + 4"))
    assert first == second
    assert {*first["one"].wrong.values()} == {("count", (7.0,))}
    assert decided == [7] * 4


def test_answers_of_other_types_are_others():
    computer = Computer(make_data("one"))
    bodies = ["7", "7.5", "7.0", "True", "Fraction(7)", "7", "(x for x in P)"]
    told = []
    for body in bodies:
        source = f"from fractions import Fraction\ndef answer(n, P):\n    return {body}\n"
        wrong = computer.behaviour(ComputedProgram(source.encode(), "here"))["one"].wrong
        told.append({form for form, _ in wrong.values()})
    assert told == [
        {"count"}, {"type float"}, {"type float"}, {"type bool"}, {"type float"}, {"count"},
        {"type generator"},
    ]  # fmt: skip


def test_a_program_that_changes_its_lists_changes_no_other_ones():
    data = load_data(load_problem(GROWTH / "inversions"))
    spoils = b"def inversions(numbers):\n    numbers.clear()\n    return []\n"
    keeps = b"def inversions(numbers):\n    return 10**9 + len(numbers)\n"
    computer = Computer(data)
    alone = Computer(data).behaviour(ComputedProgram(keeps, "keeps"))
    computer.behaviour(ComputedProgram(spoils, "spoils"))
    assert computer.behaviour(ComputedProgram(keeps, "keeps")) == alone
    assert all(values[0] > 10**9 for _, values in alone["few"].wrong.values())


def test_a_callers_precision_changes_no_answer():
    source = b"from decimal import Decimal\n\n\ndef answer(n, P):\n    return int(Decimal(10**9 + n) / 7)\n"
    program, data = ComputedProgram(source, "sevenths"), make_data("one")
    (group,) = data.groups
    alone = Computer(data).behaviour(program)
    with localcontext(Context(prec=3)):
        assert Computer(data).behaviour(program) == alone
        function = entry_of(data.problem, program)
        found = answered(data.problem, function, group.cases[0], group.targets[0], lambda: None)
    assert found == alone["one"].wrong[0] == ("count", (142857143.0,))


def test_an_exception_is_a_wrong_answer():
    raising = Computer(make_data("one")).behaviour(program("return 1 // 0"))
    assert {*raising["one"].wrong.values()} == {("raised ZeroDivisionError", ())}

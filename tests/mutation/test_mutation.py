"""The mutants of the accepted solutions: made as they say, and most of them rejected."""

from __future__ import annotations

import ast
import random

import pytest
from mutants import mutants
from mutate import PROBLEMS, mutants_of, outcomes
from sampling import daily

SAMPLE = 8  # of each problem; the command judges all of them


@pytest.fixture(scope="module", autouse=True)
def _own_cache(built):
    """The person's own cache stays out of it."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("JUDGE_CACHE", str(built))
        yield


def changes(source):
    return [(mutant.was, mutant.becomes) for mutant in mutants(source)]


@pytest.mark.parametrize(
    ("source", "becomes"),
    [
        ("a + b", ["a - b"]),
        ("a and b or c", ["(a and b) and c", "(a or b) or c"]),
        ("max(a, b)", ["min(a, b)"]),
        ("-abs(a)", ["abs(a)", "-a"]),
        ("a <= b > c", ["a < b > c", "a > b > c", "a <= b >= c", "a <= b <= c"]),
        ("a is None", ["a is not None"]),
        ("f(3)", ["f(4)", "f(2)"]),
        ("f(0.5)", ["f(1.0)", "f(0.25)"]),
        ("f(1e-10)", ["f(1e-06)", "f(1e-14)"]),
        ("f('text', True, None)", []),
    ],
)
def test_what_an_expression_becomes(source, becomes):
    expected = sorted(ast.unparse(ast.parse(text)) for text in becomes)
    assert sorted(after for _, after in changes(source)) == expected


def test_a_name_is_exchanged_for_one_like_it_in_its_function():
    source = "def f(dx, dy, r):\n    return g(dx) * r\n\ndef g(dz):\n    return dz\n"
    assert ("return g(dx) * r", "return g(dy) * r") in changes(source)
    assert not any("dz" in after and "dx" in before for before, after in changes(source))
    assert not any(before == "return dz" for before, _ in changes(source))


def test_equal_changes_of_equal_lines_are_numbered():
    found = mutants("f(a + b)\nf(a + b)\n")
    assert [(mutant.becomes, mutant.number) for mutant in found] == [("f(a - b)", 1), ("f(a - b)", 2)]
    assert [mutant.source for mutant in found] == ["f(a - b)\nf(a + b)\n", "f(a + b)\nf(a - b)\n"]


@pytest.mark.parametrize("problem", daily(PROBLEMS, ["which-side"]))
def test_the_data_reject_most_of_a_sample(problem):
    found = mutants_of(problem)
    assert len({key for key, _ in found}) == len(found)
    judged = list(outcomes(problem, random.Random(problem).sample(found, SAMPLE)))
    assert len(judged) == SAMPLE
    assert 2 * sum(each.survived for each in judged) <= SAMPLE, "\n".join(map(str, judged))

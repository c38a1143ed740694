"""The search over a builder's choices: it reads nothing of what is around it, and ends with its budget."""

from __future__ import annotations

from types import SimpleNamespace

import pytest
from hypothesis.internal.conjecture import providers

from judge.diagnose.search import shrunk
from judge.diagnose.trial import SearchBudget


def by_parameters(least, budget):
    """What the search by parameters finds among numbers that fail from `least` on, and its draws: whether the
    budget was spent by then.
    """
    drawn = []

    def builder(draw):
        drawn.append(budget.spent)
        return draw.integer(0, 10_000)

    trial = SimpleNamespace(
        budget=budget,
        valid=lambda *_: True,
        alone=lambda case, _: SimpleNamespace(measure=case) if case >= least else None,
    )
    return shrunk(trial, builder, None, [10_000]), drawn


def test_the_search_reads_none_of_the_modules_around_it(monkeypatch):
    monkeypatch.setattr(providers, "_get_local_constants", lambda: pytest.fail("they are read"))
    assert by_parameters(10, SearchBudget())[0].measure == 10
    found, drawn = by_parameters(20_000, SearchBudget())
    assert (found, len(drawn) > 100) == (None, True)


def test_a_spent_budget_ends_the_search_by_parameters_at_once():
    _, drawn = by_parameters(10, SearchBudget(3))
    assert (len(drawn), sum(drawn)) == (4, 1)  # with the last one it was noticed

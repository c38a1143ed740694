"""The search over a builder's choices: it reads nothing of what is around it, and ends with its budget."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
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
    return shrunk(trial, builder, None), drawn


def test_the_search_reads_none_of_the_modules_around_it(monkeypatch):
    monkeypatch.setattr(providers, "_get_local_constants", lambda: pytest.fail("they are read"))
    assert by_parameters(10, SearchBudget())[0].measure == 10
    found, drawn = by_parameters(20_000, SearchBudget())
    assert (found, len(drawn) > 100) == (None, True)


def test_a_spent_budget_ends_the_search_by_parameters_at_once():
    _, drawn = by_parameters(10, SearchBudget(3))
    assert (len(drawn), sum(drawn)) == (4, 1)  # with the last one it was noticed


LOOK = """
import neighbour
from types import SimpleNamespace
from judge.diagnose.search import shrunk
from judge.diagnose.trial import SearchBudget
trial = SimpleNamespace(budget=SearchBudget(), valid=lambda *_: True, alone=lambda *_: None)
assert shrunk(trial, lambda draw: draw.integer(0, 10_000), None) is None
"""


def test_the_search_leaves_nothing_in_the_folder_of_the_person(tmp_path):
    """In a process of its own, since Hypothesis takes its notes on modules once."""
    (tmp_path / "neighbour.py").write_text("NUMBERS = [12345, 67890]\n")
    path = os.pathsep.join([str(Path(__file__).parents[2]), str(tmp_path)])
    settings = {**os.environ, "PYTHONPATH": path, "PYTHONDONTWRITEBYTECODE": "1"}
    subprocess.run([sys.executable, "-c", LOOK], cwd=tmp_path, env=settings, check=True, timeout=120)
    assert [each.name for each in tmp_path.iterdir()] == ["neighbour.py"]

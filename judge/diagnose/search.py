"""Hypothesis over a builder's choices: the simplest failing case that it can build.

Hypothesis is imported when something is searched for: that takes longer than judging does.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from random import Random
from typing import Any

from judge.data.draw import Draw
from judge.diagnose.trial import FailingCase, Trial
from judge.problem import Case, Group


def strategy(builder: Callable[[Draw], Any]) -> Any:
    """The cases of a builder as Hypothesis draws them; choices that make none are left out."""
    from hypothesis import reject
    from hypothesis.errors import HypothesisException
    from hypothesis.strategies import composite, integers

    @composite
    def cases(draw: Any) -> Any:
        try:
            return builder(Draw(lambda low, high: draw(integers(low, high))))
        except HypothesisException:
            raise
        except Exception:  # a shrunk choice may break what the recipe counts on, as a divisor that becomes 0
            reject()

    return cases()


class _Spent(BaseException):
    """The budget is spent; no Exception, for Hypothesis would take that for a failure and shrink it."""


def shrunk(trial: Trial, builder: Callable[[Draw], Any], group: Group) -> FailingCase | None:
    """The simplest failing case on the way that Hypothesis takes; None if nothing fails.

    The search is the same every time: nothing is kept, and chance has a fixed seed.
    """
    from hypothesis import Phase, Verbosity, find, settings
    from hypothesis.errors import HypothesisException

    best: list[FailingCase] = []

    def fails(case: Case) -> bool:
        if trial.budget.spent:
            raise _Spent
        trial.budget.looked_at()
        failing = trial.alone(case, group) if trial.valid(case, group) else None
        if failing is not None and (not best or failing.measure < best[0].measure):
            best[:] = [failing]
        return failing is not None

    profile = settings(
        database=None,
        deadline=None,
        max_examples=200,
        phases=[Phase.generate, Phase.shrink],
        verbosity=Verbosity.quiet,
    )
    # Nothing found, or a submission that answers at random: `best` is what there is.
    with _secluded(), suppress(HypothesisException, _Spent):
        find(strategy(builder), fails, settings=profile, random=Random(0))
    return best[0] if best else None


@contextmanager
def _secluded() -> Iterator[None]:
    """Hypothesis reads nothing of what is around it, keeps nothing and says nothing.

    It would draw constants from the code of all modules in the current folder, where there are others for
    each person, and leave notes on them in a folder `.hypothesis`. Versions that do not look for them have no
    such function. What it has to say of our settings is not for the person.
    """
    from hypothesis.internal.conjecture import providers

    constants = getattr(providers, "_get_local_constants", None)
    providers._get_local_constants = lambda: providers.Constants()  # type: ignore[attr-defined]
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            yield
    finally:
        providers._get_local_constants = constants  # type: ignore[assignment]

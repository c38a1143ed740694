"""Hypothesis over a builder's choices: from a failing case of it to the simplest that it can build.

Hypothesis is imported when something is searched for: that takes longer than judging does.
"""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from random import Random
from typing import Any

from judge.data.draw import Draw
from judge.diagnose.trial import Finding, Trial
from judge.problem import Case, Group

_KEY = b"the failing case"


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


def shrunk(
    trial: Trial, builder: Callable[[Draw], Any], group: Group, choices: Sequence[int]
) -> Finding | None:
    """The simplest failing case on the way that Hypothesis takes from `choices`; None if nothing fails.

    The search is the same every time: nothing is kept, and chance has a fixed seed.
    """
    from hypothesis import Phase, Verbosity, find, settings
    from hypothesis.database import InMemoryExampleDatabase
    from hypothesis.errors import HypothesisException

    best: list[Finding] = []

    def fails(case: Case) -> bool:
        if trial.budget.spent:
            raise _Spent
        trial.budget.looked_at()
        if not trial.valid(case, group):
            return False
        finding = trial.alone(case, group)
        if finding is None:
            return False
        if not best or finding.measure < best[0].measure:
            best[:] = [finding]
        return True

    database = InMemoryExampleDatabase()
    known = _as_bytes(choices)
    if known is not None:
        database.save(_KEY, known)
    profile = settings(
        database=database,
        deadline=None,
        max_examples=200,
        phases=[Phase.reuse, Phase.generate, Phase.shrink],
        verbosity=Verbosity.quiet,
    )
    # Nothing found, or a submission that answers at random: `best` is what there is.
    with ExitStack() as stack:
        stack.enter_context(_keeping_nothing())
        stack.enter_context(_without_neighbours())
        stack.enter_context(warnings.catch_warnings())
        stack.enter_context(suppress(HypothesisException, _Spent))
        warnings.simplefilter("ignore")  # what Hypothesis has to say of our settings is not for the person
        find(strategy(builder), fails, settings=profile, random=Random(0), database_key=_KEY)
    return best[0] if best else None


@contextmanager
def _keeping_nothing() -> Iterator[None]:
    """Leave no folder `.hypothesis` wherever the person is: it would hold notes on the problem's module."""
    from hypothesis.configuration import set_hypothesis_home_dir, storage_directory

    before = storage_directory(intent_to_write=False)
    set_hypothesis_home_dir(os.devnull)
    try:
        yield
    finally:
        set_hypothesis_home_dir(before if isinstance(before, Path) else before.path)  # by its version


@contextmanager
def _without_neighbours() -> Iterator[None]:
    """Draw no constants from the code of modules that lie in the current folder: elsewhere there are others.

    Versions that do not look for them have no such function.
    """
    from hypothesis.internal.conjecture import providers

    known = getattr(providers, "_get_local_constants", None)
    if known is None:
        yield
        return
    nothing = providers.Constants()  # type: ignore[attr-defined]  # `known` would read all our modules for one
    providers._get_local_constants = lambda: nothing
    try:
        yield
    finally:
        providers._get_local_constants = known


def _as_bytes(choices: Sequence[int]) -> bytes | None:
    """The choices as Hypothesis keeps them; None with a version that has another form."""
    try:
        from hypothesis.database import choices_to_bytes
    except ImportError:
        return None
    return choices_to_bytes(tuple(choices))

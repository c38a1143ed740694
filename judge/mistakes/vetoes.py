"""What keeps a name from being said, however well it seems to fit.

own group     the submission passes a group whole that the mistake fails most: it does not make it
several       it passes groups whole of which the mistake fails half
words         the name speaks of `//`, a slope, a global, a root, and the program has none
state         the name says that something is kept between calls, but the case fails called alone as well
form          most wrong answers have a form that no answer has: then only mistakes of form are told
"""

from __future__ import annotations

from collections.abc import Callable

from judge.mistakes.catalogue import Words
from judge.mistakes.naming import Known
from judge.problem import Problem, Verdict
from judge.run.result import Behaviour, Result

_SEVERAL = 2  # groups of which a mistake fails half, that nobody passes who makes it
_SHARE = 0.2  # of its own group, that a mistake must fail for the group to say that it is not made


class Vetoes:
    """The vetoes against names for one result, that of a submission which answers as it `does`.

    `has` are the features of the submission's syntax tree, `form` says that its answers have no right form,
    `alone(group, case)` calls one case in a process of its own and says whether it fails.
    """

    def __init__(
        self,
        problem: Problem,
        result: Result,
        does: Behaviour,
        has: frozenset[str],
        *,
        form: bool,
        alone: Callable[[str, int], bool],
    ) -> None:
        self._does = does
        self._has = has
        self._form = form
        self._alone = alone
        self._passed = {group.name for group in result.groups if group.verdict is Verdict.AC}
        self._own: dict[str, list[str]] = {}
        for group in problem.groups:
            for name in group.kills:
                self._own.setdefault(name, []).append(group.name)
        self._steady: bool | None = None

    def allow(self, words: Words, known: Known) -> bool:
        """Whether a mistake may be compared with the submission at all."""
        if words.needs and not self._has.intersection(words.needs):
            return False
        if self._form and not words.form:
            return False
        return not (self._passes_its_own(known) or self._passes_several(known))

    def lasting(self, words: Words) -> bool:
        """Whether the name stands: that something is kept between calls is looked at only now."""
        if not words.state:
            return True
        if self._steady is None:
            failing = next((name for name, answers in self._does.items() if answers.wrong), None)
            self._steady = failing is None or self._alone(failing, max(self._does[failing].wrong))
        return not self._steady

    def _passes_several(self, known: Known) -> bool:
        """Whether it passes groups, at least a few, of which this program fails half."""
        halves = (
            2 * len(answers.wrong) >= answers.reached
            for name in self._passed
            if (answers := known.behaviour.get(name)) is not None and answers.wrong
        )
        return sum(halves) >= _SEVERAL

    def _passes_its_own(self, known: Known) -> bool:
        """Whether it passes that of the groups naming the mistake which this program fails most."""
        failed = {
            name: len(answers.wrong) / max(1, answers.reached)
            for name in self._own.get(known.name, ())
            if (answers := known.behaviour.get(name)) is not None and answers.wrong
        }
        own = max(failed, key=lambda name: failed[name], default=None)
        return own is not None and failed[own] >= _SHARE and own in self._passed

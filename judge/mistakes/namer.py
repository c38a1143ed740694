"""The mistakes of one problem, ready to be recognised in results."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager
from functools import cached_property, partial

from msgspec.structs import replace

from judge.cache import DISK, Store
from judge.data import ProblemData
from judge.data.build import target_of
from judge.errors import told
from judge.mistakes.catalogue import MistakeText, read_kinds
from judge.mistakes.computed import KnownAnswers, Progress, answered, entry_of
from judge.mistakes.family import read_makers
from judge.mistakes.forms import of_form
from judge.mistakes.likeness import Known, Likeness
from judge.mistakes.repaired import LIKELY, Repaired, seen_in, with_steps
from judge.problem.model import Verdict, case_of
from judge.repair.features import LIBRARY
from judge.repair.search import Repair
from judge.run.result import Behaviour, Pitfall, Result
from judge.run.settings import Settings
from judge.values import outline
from judge.values.answers import is_cut
from judge.values.outline import Outline

_FEW = 8  # different right answers, up to which many mistakes have the same wrong ones

_CLEAR = 0.7  # a likeness that stands even if the known program passes the case that is shown

Alone = Callable[[str, int], bool]  # whether a submission fails that case of the group, called for it alone


class Namer:
    """Says which known mistake explains a result; what the mistakes answer is found once and kept.

    `settings` say how programs are judged, `store` keeps what they answer; `progress` opens a bar for it;
    `notes` are for the person.
    """

    def __init__(
        self,
        data: ProblemData,
        seed: int | None,
        settings: Settings,
        progress: Callable[[], AbstractContextManager[Progress | None]],
        store: Store = DISK,
    ) -> None:
        self.notes: list[str] = []
        self._data = data
        self._answers = KnownAnswers(data, seed, settings, store)
        self._progress = progress

    def learn(self) -> None:
        """Find what the mistakes answer while the data are new; later runs have it. Raises JudgeError."""
        if not self._answers.kept:
            _ = self._known

    def named(
        self,
        result: Result,
        does: Behaviour,
        has: Callable[[], frozenset[str] | None],
        alone: Alone,
        repair: Callable[[], Repair | None] = lambda: None,
    ) -> Result:
        """The result with its pitfall: what wrong answers like its own are known for, and what is proved.

        `does` is what the submission answers, `has` says what its text has (repair.features), None where
        no person writes so much: then nothing is said. `repair` seeks the changes that make it right, where
        the form of its answers is. Raises JudgeError where the mistakes' programs cannot be judged.
        """
        if not any(answers.wrong for answers in does.values()):
            return result
        features = has()
        found = self._proved(result, does, features, alone, repair)
        library = LIBRARY in (features or ())
        if found.pitfall is None or (result.submission.endswith(".py") and not library):
            return found
        advice = tuple(map(seen_in, found.pitfall.advice))  # of others the answers alone are known
        return replace(found, pitfall=replace(found.pitfall, advice=advice, library=library))

    def _proved(
        self,
        result: Result,
        does: Behaviour,
        has: frozenset[str] | None,
        alone: Alone,
        repair: Callable[[], Repair | None],
    ) -> Result:
        """The result with its name, and with what is proved."""
        result, known = self._named(result, does, has, alone)
        if known is None or (result.pitfall is None and _is_cut(result)):
            return result  # … or the program's digits are missing, which is told
        try:
            found = repair()
        except Exception as fault:  # the name is known, and worth more
            return result.noting(f"no line is looked for: {told(fault)}")
        answered = any(each.passed for each in result.groups)
        if found is None or (not answered and result.verdict is Verdict.RTE and not _is_one_change(found)):
            return result  # where every call raises, that is the mistake
        kinds = read_kinds(self._data.problem)
        answers = {outline for outlines in self._rights.values() for outline in outlines}
        told_of = Repaired(found, known, kinds, few=len(answers) <= _FEW)
        return with_steps(result, told_of, partial(self._fails, result))

    def _named(
        self, result: Result, does: Behaviour, has: frozenset[str] | None, alone: Alone
    ) -> tuple[Result, Likeness | None]:
        """The result with its name, and what else it may be like; None where the answers' form is wrong."""
        if has is None:
            return result, None
        formed = of_form(result, does, self._data, has, self._rights)
        if formed.pitfall is not None:
            return replace(result, pitfall=formed.pitfall), None
        if formed.unreadable:
            return result, None
        made = [each for each in self._known if _may_be(each.maker.words, has, faulty=formed.faulty)]
        likeness = Likeness(made, does)
        best = likeness.best()
        if best is None or not likeness.nearest(best[0]).maker.offered:  # it must be far ahead
            likeness = Likeness([each for each in made if not each.maker.offered], does)
            best = likeness.best()
        if best is None:
            return result, likeness
        name, share = best
        nearest = likeness.nearest(name)
        state = nearest.maker.words.state and self._steady(does, alone)
        if state or (share < _CLEAR and not self._fails(result, nearest)):
            return result, likeness
        text = nearest.maker.wrong if share >= LIKELY else seen_in(nearest.maker.wrong)
        return replace(result, pitfall=Pitfall((name,), round(share, 3), (text,))), likeness

    def _fails(self, result: Result, known: Known) -> bool:
        """Whether the known program fails the case that is shown, as far as it can be called here."""
        maker, shown, data = known.maker, result.counterexample or result.failure, self._data
        group = data.problem.group(shown.group or "") if shown else None
        if shown is None or shown.input is None or group is None or not maker.program.trusted:
            return True
        case = case_of(shown.input)
        target = target_of(data.problem, *data.exact(case, group))
        function = entry_of(data.problem, maker.program)
        return answered(data.problem, function, case, target, lambda: data.exact(case, group)) is not None

    def _steady(self, does: Behaviour, alone: Alone) -> bool:
        """Whether a case fails that is called alone too: then nothing is kept between calls."""
        failing = next((name for name, answers in does.items() if answers.wrong), None)
        return failing is None or alone(failing, max(does[failing].wrong))

    @cached_property
    def _rights(self) -> Mapping[str, Sequence[Outline]]:
        """The outlines of the right answers to every case, by the group's name."""
        answer = self._data.problem.answer
        return {
            each.group.name: [outline.right(answer, target) for target in each.targets]
            for each in self._data.groups
        }

    @cached_property
    def _known(self) -> Sequence[Known]:
        """The programs to compare with: of those of one mistake that answer alike, the first."""
        read = read_makers(self._data.problem)
        self.notes += [f"a known mistake is left out: {fault}" for fault in read.faults]
        with self._progress() as advance:
            behaviours, note = self._answers.of([each.program for each in read.all], advance)
        self.notes += [note] if note else []
        found: dict[tuple[str, int], Known] = {}
        for maker, does in zip(read.all, behaviours, strict=True):
            if any(each.wrong for each in does.values()):
                found.setdefault((maker.name, id(does)), Known(maker, does))
        return [*found.values()]


def _may_be(words: MistakeText, has: frozenset[str], *, faulty: bool) -> bool:
    """Whether the name may be said of a program that has this; of `faulty` forms only what is one."""
    return (not words.needs or bool(has.intersection(words.needs))) and (words.form or not faulty)


def _is_cut(result: Result) -> bool:
    """Whether the case that is shown is wrong because too few digits are printed."""
    shown = result.counterexample or result.failure
    return shown is not None and is_cut(shown.message)


def _is_one_change(found: Repair) -> bool:
    """Whether one change makes all of it right."""
    return any(len(steps) == 1 for steps in found.whole)

"""The mistakes of one problem, ready to be recognised in results."""

from __future__ import annotations

import gc
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager
from functools import cached_property

from msgspec import Struct
from msgspec.structs import replace

from judge.cache import DISK, Store
from judge.data.model import ProblemData
from judge.languages import language_of
from judge.mistakes.catalogue import read_catalogue, read_kinds
from judge.mistakes.computed import Computer, Program
from judge.mistakes.family import Choice, Family
from judge.mistakes.features import features
from judge.mistakes.forms import of_form
from judge.mistakes.known import KnownAnswers, Progress
from judge.mistakes.makers import Maker, Makers, distinct, read_makers
from judge.mistakes.naming import Known, Match, best_match
from judge.mistakes.nearest import nearest
from judge.mistakes.repaired import Repaired, with_steps
from judge.mistakes.rights import right_outlines
from judge.mistakes.same import Cases, Joint, Same, as_match, twins, wrong_answers
from judge.mistakes.vetoes import Vetoes
from judge.repair.search import Repair
from judge.run.result import Behaviour, Pitfall, Result
from judge.run.settings import Settings
from judge.values.outline import Outline

_SENTENCE = re.compile(r".*?(?:[.!?](?=\s)|$)", re.DOTALL)  # the first one of a text

Alone = Callable[[str, int], bool]  # whether a submission fails that case of the group, called for it alone


class _Ready(Struct):
    """What is compared with, and what each of them answers; `makers`, `choices` and `known` belong together.

    `choices` are all that make the same mistake with the same answers, on whatever route.
    """

    read: Makers
    makers: list[Maker]
    choices: list[list[Choice]]
    known: list[Known]


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
        self._computer = Computer(data)  # of what makes two mistakes at once
        self._progress = progress
        self._made: _Ready | None = None

    def learn(self) -> None:
        """Find what the mistakes answer while the data are new; later runs have it. Raises JudgeError."""
        if not self._answers.kept:
            self._ready()

    def named(
        self,
        result: Result,
        does: Behaviour,
        source: bytes,
        alone: Alone,
        repair: Callable[[], Repair | None] = lambda: None,
    ) -> Result:
        """The result with its pitfall: what wrong answers like its own are known for, and what is proved.

        `does` is what the submission answers, `source` its text; of one that is longer than any that a person
        writes nothing is said. `repair` seeks the changes that make it right, where nothing is wrong with the
        answers' form. Raises JudgeError where the mistakes' programs cannot be judged.
        """
        if not any(answers.wrong for answers in does.values()):
            return result
        with _collecting_later():
            result, known = self._named(result, does, source, alone)
        found = repair() if known is not None else None
        if known is None or found is None:
            return result
        kinds = read_kinds(self._data.problem)
        told = Repaired(found, known, does, kinds)
        return with_steps(result, told, kinds, read_catalogue(self._data.problem))

    def _named(
        self, result: Result, does: Behaviour, source: bytes, alone: Alone
    ) -> tuple[Result, Sequence[Known] | None]:
        """The result with its name, and what else it may be like; None where the answers' form is wrong."""
        has = features(source, language_of(result.submission))
        if has is None:
            return result, None
        found = of_form(result, does, self._data, has, self._rights)
        if found.pitfall is not None:
            return replace(result, pitfall=found.pitfall), None
        if found.unreadable:
            return result, None
        ready = self._ready()
        vetoes = Vetoes(ready.read.problem, result, does, has, form=found.faulty, alone=alone)
        kept = [
            place for place, each in enumerate(ready.known) if vetoes.allow(ready.makers[place].words, each)
        ]
        makers, known = [ready.makers[place] for place in kept], [ready.known[place] for place in kept]
        joint = self._joint(ready.read.family, [ready.choices[place] for place in kept])
        match, alike = self._match(joint, known, does)
        if match is None:
            alike = [place for place in alike if vetoes.lasting(makers[place].words)]
            match = as_match(does, alike, known)
        if match is None:
            note = [_why_not(does, [makers[place] for place in alike])] if alike else []
            return result.noting(*note), known
        if not all(vetoes.lasting(makers[place].words) for place in match.places):
            return result, known
        return replace(result, pitfall=_pitfall(match, makers)), known

    def _match(
        self, joint: Joint | None, known: Sequence[Known], does: Behaviour
    ) -> tuple[Match | None, Sequence[int]]:
        """What explains the submission, or else the programs that answer just as it does."""
        data, rights = self._data, self._rights
        near = nearest(does, known, data.groups)
        same = Same(does, known, data.groups, data.problem.answer, rights, joint)
        match = same.one(near.same) or same.two(near.pairs)
        if match is None:
            worth = near.worth

            def fits(one: int, other: int) -> float | None:
                return same.fits(worth[one], worth[other])

            few = [known[place] for place in worth]
            match = best_match(does, few, data.groups, data.problem.answer, fits, rights)
            match = match and match.at(worth)
        return match, () if match else twins(does, known)

    @cached_property
    def _rights(self) -> Mapping[str, Sequence[Outline]]:
        return right_outlines(self._data)

    def _joint(self, family: Family | None, choices: Sequence[Sequence[Choice]]) -> Joint | None:
        """What the program answers that makes two mistakes at once, by the first choices that go together."""
        if family is None:
            return None

        def joint(one: int, other: int, only: Cases) -> Behaviour | None:
            pairs = (family.together(first, second) for first in choices[one] for second in choices[other])
            both = next((each for each in pairs if each is not None), None)
            if both is None:
                return None
            return self._computer.behaviour(Program(family.program(both).encode(), family.place(both)), only)

        return joint

    def _ready(self) -> _Ready:
        if self._made is None:
            read = read_makers(self._data.problem)
            self.notes += [f"a known mistake is left out: {fault}" for fault in read.faults]
            with self._progress() as advance:
                behaviours, note = self._answers.of([each.program for each in read.all], advance)
            self.notes += [note] if note else []
            alike = distinct(read.all, behaviours)
            makers = [read.all[places[0]] for places in alike]
            choices = [[c for i in places if (c := read.all[i].choice) is not None] for places in alike]
            known = [
                Known(maker.name, behaviours[places[0]], maker.chance)
                for maker, places in zip(makers, alike, strict=True)
            ]
            self._made = _Ready(read, makers, choices, known)
        return self._made


@contextmanager
def _collecting_later() -> Iterator[None]:
    """Without the collector of cycles, which looks at hundreds of thousands of tuples again and again: naming
    makes no cycles. It costs as much time as naming itself."""
    if not gc.isenabled():
        yield
        return
    gc.disable()
    try:
        yield
    finally:
        gc.enable()


def _pitfall(match: Match, makers: Sequence[Maker]) -> Pitfall:
    found = [makers[place] for place in match.places]
    return Pitfall(
        tuple(maker.name for maker in found),
        round(match.score, 3),
        tuple(_what_is_wrong(maker) for maker in found),
        tuple(makers[place].name for place in match.perhaps),
    )


def _what_is_wrong(maker: Maker) -> str:
    """What is said of the mistake, without what to do instead: that is for the hints."""
    if maker.text == maker.words.told and maker.words.why:
        return maker.words.why
    return _SENTENCE.match(maker.text)[0] if maker.text else ""  # type: ignore[index]  # it always matches


def _why_not(does: Behaviour, alike: Sequence[Maker]) -> str:
    """Why a submission that answers exactly as known programs do is given no name."""
    files = ", ".join(maker.file for maker in alike)
    if len({maker.name for maker in alike}) > 1:
        return f"the mistake is not named: {files} all answer as this does, and make different ones"
    count = wrong_answers(does)
    told = "1 wrong answer is" if count == 1 else f"{count} wrong answers are"
    return f"the mistake is not named: it answers as {files} does, but {told} too few to be sure"

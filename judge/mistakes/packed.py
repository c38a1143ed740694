"""Wrong answers as they are kept: packed, with their kinds, and unpacked only where somebody asks.

[reached]                                         a group without wrong answers
[reached, cases, [[form, kind, n], …], of, numbers]   the others: the cases, the place of each one's form in
                                                  the list before, and n doubles for each; all in base64
"""

from __future__ import annotations

from array import array
from base64 import b64decode, b64encode
from collections.abc import Callable, Iterator, Mapping
from functools import cached_property
from typing import Any

from judge.run.result import Answers
from judge.values.outline import Outline

KindOf = Callable[[int, Outline], str]  # of a wrong answer to a case


class PackedWrong(Mapping[int, Outline]):
    """Wrong answers by case, as a dict of them would be, and what kind each of them is."""

    def __init__(self, plain: list[Any]) -> None:
        _, cases, self._forms, self._of, self._numbers = plain
        self._cases: array[int] = _array("I", cases)

    def __len__(self) -> int:
        return len(self._cases)

    def __iter__(self) -> Iterator[int]:
        return iter(self._cases)

    def __getitem__(self, case: int) -> Outline:
        return self._rows[case][0]

    def __contains__(self, case: object) -> bool:
        return case in self._rows

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Mapping) and dict(self.items()) == dict(other.items())

    __hash__ = None  # type: ignore[assignment]

    def kind(self, case: int) -> str:
        """What kind of wrong answer that to `case` is."""
        return self._rows[case][1]

    @cached_property
    def _rows(self) -> dict[int, tuple[Outline, str]]:
        numbers: array[float] = _array("d", self._numbers)
        found = {}
        at = 0
        for case, place in zip(self._cases, _array("H", self._of), strict=True):
            form, kind, count = self._forms[place]
            found[case] = ((form, tuple(numbers[at : at + count])), kind)
            at += count
        return found


def packed(answers: Answers, kind: KindOf) -> list[Any]:
    """One group's answers as JSON."""
    if not answers.wrong:
        return [answers.reached]
    forms: dict[tuple[str, str, int], int] = {}
    of, numbers = array("H"), array("d")
    for case, outline in answers.wrong.items():
        of.append(forms.setdefault((outline[0], kind(case, outline), len(outline[1])), len(forms)))
        numbers.extend(outline[1])
    cases = array("I", answers.wrong)
    return [answers.reached, _text(cases), [list(form) for form in forms], _text(of), _text(numbers)]


def unpacked(plain: Any) -> Answers:
    """What `packed` wrote. Raises TypeError or ValueError for most of anything else."""
    reached, *rest = plain
    if not rest:
        return Answers(reached, {})
    return Answers(reached, PackedWrong(plain))


def _text(numbers: array[Any]) -> str:
    return b64encode(numbers.tobytes()).decode()


def _array(code: str, text: str) -> array[Any]:
    found = array(code)
    found.frombytes(b64decode(text))
    return found

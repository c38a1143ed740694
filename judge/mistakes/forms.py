"""Faults of an answer's form, told exactly: they come before every mistake of the problem's own.

A function that prints instead of returning, a text, a complex number, a single item where a list of them is
meant, a crash that is no matter of numbers.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence

from msgspec import Struct

from judge.data import ProblemData
from judge.run.result import Behaviour, Pitfall, Result
from judge.values import outline
from judge.values.outline import UNREADABLE, Outline, only_digits

_MOST = 0.5  # of the wrong answers, from which on a fault of form is what is wrong
_ALL = 0.9
_ENOUGH = 20  # cases that all get one answer
_CRASHES = frozenset(
    f"raised {name}"
    for name in (
        "NameError", "UnboundLocalError", "AttributeError", "ImportError", "ModuleNotFoundError", "TypeError",
        "KeyError", "IndexError", "RecursionError", "AssertionError", "NotImplementedError",
    )
)  # fmt: skip

_OF_TYPE: Mapping[str, tuple[str, str]] = {
    "type complex": (
        "complex-answer",
        "The answer is a complex number: the root of a negative one. Decide on the sign first.",
    ),
    "type str": (
        "text-for-a-value",
        "The answer is a text. Return the value itself, not what it looks like printed.",
    ),
}


class Form(Struct, frozen=True):
    """What the answers' form says: a pitfall of its own, or that most of them have no right form.

    `unreadable` says that most are lines which hold no answer: they are no evidence of any mistake.
    """

    pitfall: Pitfall | None = None
    faulty: bool = False
    unreadable: bool = False


def of_form(
    result: Result,
    does: Behaviour,
    data: ProblemData,
    has: frozenset[str],
    rights: Mapping[str, Sequence[Outline]],
) -> Form:
    """Look at the forms of a result's wrong answers, which are what the submission `does`.

    `has` are the features of its syntax tree, `rights` the outlines of all right answers by group.
    """
    problem, item = data.problem, data.problem.answer.one
    given = [outline for answers in does.values() for outline in answers.wrong.values()]
    forms = Counter(outline[0] for outline in given)
    if forms[UNREADABLE] >= _MOST * len(given):
        return Form(unreadable=True)
    if _prints(result, does, forms, has, rights):
        advice = "The function prints its answer and returns None. Return it; printing is for programs."
        return _named("print-for-return", advice)
    if forms["type str"] >= _ALL * len(given) and _empty_ones(does, rights):
        advice = f"Where there is no {item}, a text is returned. Return []."
        return _named("none-for-empty", advice)
    for form, (name, advice) in _OF_TYPE.items():
        if forms[form] >= _ALL * len(given):
            return _named(name, advice)
    bare = _bare(does, data)
    if bare.total() >= _ALL * len(given):
        several = max(bare)
        name = f"{item.replace(' ', '-')}-not-in-a-list"
        advice = f"A single {item} is returned as it is. Return a list, even if it has only one {item}."
        if several > 1:
            name = f"{item.replace(' ', '-')}s-in-one-list"
            what, each = ("coordinates", ": [(x, y), (x, y)]") if item == "point" else ("numbers", ".")
            advice = f"The {what} of {several} {problem.answer.several} in one list. Group them{each}"
        return _named(name, advice)
    if not problem.formatted and (constant := _constant(does, rights, forms)):
        advice = f"{constant} is the answer to every case, whatever the input is."
        return _named("one-answer", advice)
    right = {_kind(form) for outlines in rights.values() for form, _ in outlines}
    odd = sum(count for form, count in forms.items() if _is_odd(form) and _kind(form) not in right)
    return Form(faulty=odd >= _MOST * len(given))


def _named(name: str, advice: str) -> Form:
    return Form(Pitfall((name,), 1.0, (advice,)))


def _prints(
    result: Result,
    does: Behaviour,
    forms: Counter[str],
    has: frozenset[str],
    rights: Mapping[str, Sequence[Outline]],
) -> bool:
    """Whether a function prints, and answers None to all that it is asked; a program would print `none`."""
    returned = result.failure is not None and result.failure.got == "None"
    if not (returned and "print" in has and forms["none"] == forms.total()):
        return False
    return all(form == "none" for form, _ in _passed(does, rights))


def _empty_ones(does: Behaviour, rights: Mapping[str, Sequence[Outline]]) -> bool:
    """Whether wrong answers come only where the right one is a list without items."""
    right = (rights[name][case] for name, answers in does.items() for case in answers.wrong)
    return all(form.endswith(" 0") for form, _ in right)


def _bare(does: Behaviour, data: ProblemData) -> Counter[int]:
    """How many wrong answers are the right items without a list around each or all, by how many they are."""
    answer = data.problem.answer
    if answer.lengths <= 1:
        return Counter()
    targets = {each.group.name: each.targets for each in data.groups}
    found: Counter[int] = Counter()
    for name, answers in does.items():
        for case, (form, numbers) in answers.wrong.items():
            right, wanted = outline.right(answer, targets[name][case])
            if form.startswith("shape ") and _same(numbers, wanted):
                words = right.split()
                found[int(words[1]) if words[1:] and words[1].isdigit() else 1] += 1
    return found


def _constant(does: Behaviour, rights: Mapping[str, Sequence[Outline]], forms: Counter[str]) -> str:
    """The one answer that all cases get, as far as they show; empty where there are several."""
    given = {outline for answers in does.values() for outline in answers.wrong.values()}
    if len(given) != 1 or any(form.startswith(("raised ", "stopped ", "type ")) for form in forms):
        return ""
    (answer,) = given
    passed = [right == answer for right in _passed(does, rights)]
    if len(passed) + forms.total() < _ENOUGH or not all(passed):
        return ""
    return "None" if answer[0] == "none" else _in_words(answer)


def _passed(does: Behaviour, rights: Mapping[str, Sequence[Outline]]) -> Iterator[Outline]:
    """The right answers to the cases that were accepted."""
    for name, answers in does.items():
        for case in range(answers.reached):
            if case not in answers.wrong:
                yield rights[name][case]


def _in_words(answer: Outline) -> str:
    form, numbers = answer
    if numbers:
        return ", ".join(f"{number:g}" for number in numbers)
    kind, _, said = form.partition(" ")
    if kind in ("word", outline.TEXT):
        return repr(said)
    if kind == "bool":
        return said.capitalize()
    return "None" if form == "none" else "The empty list" if form.endswith(" 0") else ""


def _same(numbers: Sequence[float], wanted: Sequence[float]) -> bool:
    return len(numbers) == len(wanted) > 0 and only_digits(numbers, wanted)


def _kind(form: str) -> str:
    return form.partition(" ")[0]


def _is_odd(form: str) -> bool:
    return form.startswith(("type ", "shape ", UNREADABLE, "word")) or form in _CRASHES

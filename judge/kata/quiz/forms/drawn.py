"""Questions about a figure that is drawn anew each time; a problem's exact reference knows the answer.

`count` draws a case of the problem's own groups, and asks how many things its answer holds. For the other
forms the problem's topic makes figure and answer (`Hooks.puzzle`).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

from judge.kata.quiz.cards import Card, Wants
from judge.kata.quiz.forms.form import Form, cannot
from judge.kata.quiz.question import Question, Reply
from judge.kata.quiz.sources import Sources
from judge.kata.quiz.typed import NONE, count, listed, sequence

_TRIES = 1_000  # cases that are looked at for one of small numbers

if TYPE_CHECKING:
    from judge.data.draw import Draw
    from judge.drawing import Picture
    from judge.problem import Group, Problem


def _count(card: Card, sources: Sources, draw: Draw) -> Question:
    from judge.data.build import new_case
    from judge.data.validate import Validator
    from judge.problem.declare import Shown
    from judge.problem.module import blaming

    problem, module = sources.problem(card.problem), sources.module(card.problem)
    validator = Validator(problem, module.solve)
    with blaming(problem, f"card {card.key}: the problem's own code fails on a fresh case"):
        for _ in range(_TRIES):
            group = draw.choice(_groups(card, problem))
            builder = module.draws[group.name]
            case, exact = new_case(problem, group, builder, validator, lambda _attempt: draw, 1)
            if not card.largest or all(_is_whole(number, card.largest) for number in _numbers(case)):
                break
        else:
            what = f"no case is in whole numbers up to {card.largest}"
            raise cannot(card, what, "raise largest, or name other groups")
        values = problem.named(case)
        shown = Shown(problem, values, None, None, None)  # else the answer would be drawn
        drawn = module.hooks.picture(shown) if module.hooks.picture else None
    many = _many(card, exact)
    return Question(
        card,
        "a whole number, or none",
        many,
        partial(_counted, many),
        given=(", ".join(f"{name}={_plain(value)}" for name, value in values.items()),),
        picture=_bare(drawn) if drawn else None,
        why=card.back,
    )


def _bare(drawn: Picture) -> Picture:
    """The figure at true scale alone, and no words but the names of its points."""
    whole = replace(drawn.whole, title="", note="")
    return replace(drawn, heading="", description="", whole=whole, lens=None, facts=())


def _numbers(value: Any) -> Iterator[float]:
    """The numbers in a case."""
    if isinstance(value, int | float):
        yield value
    elif isinstance(value, tuple | list):
        for part in value:
            yield from _numbers(part)


def _is_whole(number: float, most: int) -> bool:
    return abs(number) <= most and number == int(number)


def _groups(card: Card, problem: Problem) -> list[Group]:
    from judge.problem.model import EXAMPLES

    able = [group for group in problem.groups if group.name != EXAMPLES and group.size is None]
    for name in card.groups:
        if name not in [group.name for group in able]:
            remedy = f"name some of {', '.join(group.name for group in able)}"
            raise cannot(card, f"{problem.id} has no group {name!r} to draw from", remedy)
    found = [group for group in able if not card.groups or group.name in card.groups]
    if not found:
        raise cannot(card, f"{problem.id} has no group to draw from", "name another problem")
    return found


def _many(card: Card, exact: Any) -> str:
    """How many things an exact answer holds."""
    if exact is None:
        return NONE
    if type(exact) is int and exact >= 0:
        return str(exact)
    if isinstance(exact, list):
        return str(len(exact))
    raise cannot(
        card, f"the answer of {card.problem} counts nothing", "name a problem that answers a count or a list"
    )


def _counted(many: str, typed: str) -> Reply:
    found = count(typed)
    return Reply(found == many, found)


def _plain(value: Any) -> str:
    if isinstance(value, tuple | list):
        return f"({', '.join(map(_plain, value))})"
    return repr(int(value) if isinstance(value, float) and value.is_integer() else value)


def _puzzle(card: Card, sources: Sources, draw: Draw) -> Question:
    from judge.problem.module import blaming

    problem, module = sources.problem(card.problem), sources.module(card.problem)
    make = module.hooks.puzzle
    with blaming(problem, f"card {card.key}: the figure cannot be made"):
        found = make(card.form, draw, module.solve) if make else None
    if found is None:
        raise cannot(card, f"{problem.id} has no figure for {card.form!r}", "name another problem, or form")
    words = [f"{word} ({meaning})" if meaning else word for word, meaning in found.words.items()]
    expects = f"{listed(words, 'or' if found.one else 'and')}{'' if found.one else ' in order'}, or {NONE}"
    return Question(
        card,
        expects,
        " ".join(found.answer) or NONE,
        partial(_read, found.answer, found.words),
        given=found.given,
        picture=found.picture,
        why=" ".join(part for part in (found.why, card.back) if part),
    )


def _read(answer: tuple[str, ...], words: Mapping[str, str], typed: str) -> Reply:
    found = sequence(typed, words)
    return Reply(found == answer, " ".join(found) or NONE)


def _fault(card: Card) -> tuple[str, str, str] | None:
    if card.largest < 0:
        return "largest", f"largest is {card.largest}", "write the largest number that a figure may have"
    return None


FORMS = {
    "count": Form(Wants(needs=("problem",), takes=("groups", "largest"), check=_fault), _count),
    **{name: Form(Wants(needs=("problem",)), _puzzle) for name in ("first-hit", "order", "tags")},
}

"""A card as a question: what is shown, and what an answer comes to.

recall                             free recall; the person compares with the model answer, and rates it
choice                             one option is right, every other one a mistake with a name
number                             a number, exactly or nearly
count                              a fresh case of a problem: how many things its answer holds
first-hit, order, tags             a figure that the problem's topic makes (`Hooks.puzzle`)
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import partial
from pathlib import Path
from typing import Any, NoReturn

from msgspec import Struct
from msgspec.structs import replace

from judge.data.draw import Draw, seeded
from judge.drawing import Picture
from judge.errors import ProblemError
from judge.practice import cards
from judge.practice.cards import NONE, Card, Choice, Count, Drawn, Number, listed
from judge.problem import Group, Problem
from judge.problem.declare import Shown
from judge.problem.find import find_problem
from judge.problem.model import EXAMPLES
from judge.problem.module import blaming, load_module
from judge.values import show
from judge.values.parameters import literal

_FRESH = 1_000  # cases that are looked at for one of small numbers


class CardReply(Struct, frozen=True):
    """What an answer comes to; `given` is the answer as it was understood.

    Where it is wrong in a way that has a name, `mistake` is that, and `why` says what is wrong with it.
    """

    right: bool
    given: str
    mistake: str = ""
    why: str = ""


class Question(Struct, frozen=True):
    """One question.

    Attributes:
        card: what it is made from.
        expects: what may be typed, in words.
        answer: the right answer in words, the model answer of one that the person rates.
        check: what an answer comes to; raises MistypedError. None where the person rates it.
        given: what is known of the figure, a line each.
        options: what to choose from, each with its letter.
        picture: the figure, without the answer.
        drawn: the figure with the answer, which is shown with that.
        why: what makes the answer right in this figure.
    """

    card: Card
    expects: str
    answer: str
    check: Callable[[str], CardReply] | None = None
    given: tuple[str, ...] = ()
    options: tuple[tuple[str, str], ...] = ()
    picture: Picture | None = None
    drawn: Picture | None = None
    why: str = ""


def ask(card: Card, folders: Sequence[Path], seed: int, turn: str) -> Question:
    """The card as a question, of a problem that is looked for in the `folders` first.

    What is left to chance depends on the seed and on the `turn`.

    Raises:
        UsageError: a problem that it names is not here.
        ProblemError: a problem's own code fails, or the card asks for what it has not.
    """
    draw = Draw(seeded(f"quiz/{seed}/{card.key}/{turn}"))
    match card.content:
        case Choice() as content:
            return _choice(card, content, draw)
        case Number() as content:
            answer = f"{content.answer} {content.unit}".rstrip()
            check = partial(_nearly, content)
            return Question(card, f"a number: {cards.NUMBER}", answer, check, why=card.back)
        case Count() as content:
            return _count(card, content, find_problem(content.problem, folders), draw)
        case Drawn() as content:
            return _drawn(card, find_problem(content.problem, folders), draw)
    return Question(card, "Your answer (only Enter if you say it aloud)", card.back)


def _refuse(card: Card, what: str, remedy: str) -> NoReturn:
    """Raise the ProblemError of a card that asks for what its problem has not."""
    raise ProblemError(f"card {card.content.id!r}: {what}", where=f"quiz/{card.deck}.toml", remedy=remedy)


def _choice(card: Card, content: Choice, draw: Draw) -> Question:
    """The options in an order by chance."""
    options = [(content.right, CardReply(True, ""))]
    options += [(each.text, CardReply(False, "", each.mistake, each.why)) for each in content.wrong]
    for end in range(len(options) - 1, 0, -1):
        at = draw.integer(0, end)
        options[at], options[end] = options[end], options[at]
    found = dict(zip(cards.LETTERS, options, strict=False))
    right = next(letter for letter, (_, reply) in found.items() if reply.right)

    def check(typed: str) -> CardReply:
        letter = cards.option(typed, list(found))
        return replace(found[letter][1], given=letter)

    shown = tuple((letter, text) for letter, (text, _) in found.items())
    answer = f"{right}  {content.right}"
    return Question(card, listed(list(found), "or"), answer, check, options=shown, why=card.back)


def _exactly(wanted: str, read: Callable[[str], str], typed: str) -> CardReply:
    given = read(typed)
    return CardReply(given == wanted, given)


def _nearly(content: Number, typed: str) -> CardReply:
    typed = typed.strip().removesuffix(content.unit)
    found, wanted = cards.number(typed), cards.number(content.answer)
    return CardReply(abs(found - wanted) <= Fraction(content.within) * abs(wanted), typed.strip())


# -- figures -----------------------------------------------------------------------------------------------


def _count(card: Card, content: Count, problem: Problem, draw: Draw) -> Question:
    from judge.data.build import new_case

    module = load_module(problem)
    groups = _groups(card, content, problem)
    with blaming(problem, f"card {card.key}: the problem's own code fails on a fresh case"):
        for _ in range(_FRESH):
            case, exact, *_ = new_case(problem, module, draw.choice(groups), lambda _attempt: draw.integer)
            if not content.largest or _is_small(case, content.largest):
                break
        else:
            what = f"no case is in whole numbers up to {content.largest}"
            _refuse(card, what, "raise largest, or name other groups")
        values = problem.named(case)
        shown = Shown(problem, values, exact, str(show.exact_text(exact)), None)
        drawn = module.hooks.picture(shown) if module.hooks.picture else None
    found = len(exact) if isinstance(exact, list) else exact
    many = NONE if found is None else str(found)
    if found is not None and type(found) is not int:
        what = f"the answer of {card.problem} counts nothing"
        _refuse(card, what, "name a problem that answers a count or a list")
    told = ", ".join(f"{each.name}={literal(each.type, values[each.name])}" for each in problem.parameters)
    check = partial(_exactly, many, cards.count)
    return Question(card, "a number, or none", many, check, given=(told,), drawn=drawn, why=card.back)


def _is_small(value: Any, largest: int) -> bool:
    """Whether all numbers in a case are whole and at most so large."""
    if isinstance(value, tuple | list):
        return all(_is_small(part, largest) for part in value)
    return not isinstance(value, int | float) or (abs(value) <= largest and value == int(value))


def _groups(card: Card, content: Count, problem: Problem) -> list[Group]:
    able = {each.name: each for each in problem.groups if each.name != EXAMPLES and each.size is None}
    for name in content.groups:
        if name not in able:
            what = f"{problem.id} has no group {name!r} to draw from"
            _refuse(card, what, f"name some of {', '.join(able)}")
    return [each for name, each in able.items() if name in (content.groups or able)]


def _drawn(card: Card, problem: Problem, draw: Draw) -> Question:
    module = load_module(problem)
    make = module.hooks.puzzle
    with blaming(problem, f"card {card.key}: the figure cannot be made"):
        figure = make(card.form, draw, module.solve) if make else None
    if figure is None:
        _refuse(card, f"{problem.id} has no figure for {card.form!r}", "name another problem, or form")
    words = [f"{word} ({meaning})" if meaning else word for word, meaning in figure.words.items()]
    expects = listed(words, "or") if figure.one else f"{listed(words, 'and')} in order"
    answer = " ".join(figure.answer) or NONE
    check = partial(_exactly, answer, partial(cards.sequence, words=figure.words))
    why = f"{figure.why} {card.back}".strip()
    return Question(
        card, f"{expects}, or {NONE}", answer, check, given=figure.given, picture=figure.picture, why=why
    )

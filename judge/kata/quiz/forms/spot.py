"""A known wrong program is shown: which test group breaks it?

The program is a choice of the problem's mistakes.py, rendered; all groups are asked, so that of the options
one rejects it and the others accept it.
"""

from __future__ import annotations

import ast
from collections.abc import Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING

from judge.kata.quiz.cards import Card, Wants
from judge.kata.quiz.forms.choice import LETTERS, shuffled
from judge.kata.quiz.forms.form import Form, cannot
from judge.kata.quiz.question import Question, Reply
from judge.kata.quiz.sources import Sources
from judge.kata.quiz.typed import letters_of, option

if TYPE_CHECKING:
    from judge.data.draw import Draw
    from judge.mistakes.makers import Maker
    from judge.problem import Group, Problem
    from judge.run.result import Behaviour

_OPTIONS = 4
_TRIES = 12  # programs that are looked at
_LONGEST = 60  # lines of a program that are shown


def _ask(card: Card, sources: Sources, draw: Draw) -> Question:
    from judge.mistakes.computed import computed
    from judge.mistakes.makers import read_makers
    from judge.problem.solutions import MISTAKES

    read = read_makers(sources.problem(card.problem))
    makers = [
        each for each in read.all if _usable(each) and (not card.mistakes or each.name in card.mistakes)
    ]
    if not makers:
        what = f"{card.problem} has no program with such a mistake"
        raise cannot(card, what, f"name mistakes of its {MISTAKES}, or none")
    data = sources.data(card.problem)
    for _ in range(_TRIES):
        maker = draw.choice(makers)
        breaking, passing = _sides(read.problem, maker, computed(data, maker.program))
        if breaking and passing:
            return _question(card, maker, draw.choice(breaking), _some(passing, _OPTIONS - 1, draw), draw)
    what = f"no program of {card.problem} is broken by some groups and not by others"
    raise cannot(card, what, "name other mistakes, or another problem")


def _usable(maker: Maker) -> bool:
    """Whether its program can be read: it changes lines of a route, and does not only wrap it."""
    choice = maker.choice
    if choice is None or choice.before >= 0 or choice.after >= 0:
        return False
    program = shown_program(maker.program.source.decode("utf-8"))
    return bool(program) and len(program.splitlines()) <= _LONGEST


def shown_program(source: str) -> str:
    """The program without what nobody calls and without docstrings; empty where it is hard to read.

    A change that returns early leaves the rest of its function behind: that would be read for nothing.
    """
    from judge.mistakes.puzzles import without_pass  # late as above

    source = without_pass(source)
    tree = ast.parse(source)
    needed: list[ast.stmt] = []
    wanted: set[str] = set()
    for node in reversed(tree.body):  # what is called stands before what calls it
        if isinstance(node, ast.Import | ast.ImportFrom):
            names = {alias.asname or alias.name.partition(".")[0] for alias in node.names}
            node.names = [
                each for each in node.names if (each.asname or each.name.partition(".")[0]) in wanted
            ]
        else:
            names = _defined(node)
        if needed and not names & wanted:
            continue
        needed.append(node)
        wanted |= {each.id for each in ast.walk(node) if isinstance(each, ast.Name)}
    if any(_unreachable(node) for node in needed):
        return ""
    lines = source.splitlines()
    parts = [
        ast.unparse(node)
        if isinstance(node, ast.Import | ast.ImportFrom)
        else "\n".join(_without_docstring(lines, node))
        for node in reversed(needed)
    ]
    imports = [part for part in parts if part.startswith(("import ", "from "))]
    return "\n\n\n".join([*(["\n".join(imports)] if imports else []), *parts[len(imports) :]])


def _defined(node: ast.stmt) -> set[str]:
    """The names that a statement of a module gives a value."""
    if isinstance(node, ast.FunctionDef | ast.ClassDef):
        return {node.name}
    return {
        each.id for each in ast.walk(node) if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Store)
    }


def _without_docstring(lines: Sequence[str], node: ast.stmt) -> list[str]:
    kept = list(lines[node.lineno - 1 : node.end_lineno])
    if isinstance(node, ast.FunctionDef) and ast.get_docstring(node) is not None:
        first = node.body[0]
        kept[first.lineno - node.lineno : (first.end_lineno or first.lineno) - node.lineno + 1] = []
    return kept


def _unreachable(tree: ast.AST) -> bool:
    """Whether anything stands behind a return, or a lambda is called where it stands."""
    for node in ast.walk(tree):
        body = getattr(node, "body", None)
        if isinstance(body, list) and any(isinstance(each, ast.Return) for each in body[:-1]):
            return True
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Lambda):
            return True
    return False


def _sides(problem: Problem, maker: Maker, does: Behaviour) -> tuple[list[Group], list[Group]]:
    """The groups that name the mistake and reject the program, and those that accept it."""
    asked = [group for group in problem.groups if group.name in does]
    breaking = [group for group in asked if maker.name in group.kills and does[group.name].wrong]
    return breaking, [group for group in asked if not does[group.name].wrong]


def _some(groups: Sequence[Group], most: int, draw: Draw) -> list[Group]:
    return [groups[place] for place in shuffled(len(groups), draw)[:most]]


def _question(card: Card, maker: Maker, right: Group, others: Sequence[Group], draw: Draw) -> Question:
    groups = [right, *others]
    order = [groups[place] for place in shuffled(len(groups), draw)]
    letters = LETTERS[: len(order)]
    by_letter = dict(zip(letters, order, strict=True))
    answer = next(letter for letter, group in by_letter.items() if group is right)
    return Question(
        card,
        letters_of(letters),
        f"{answer}  {right.name}: it is {maker.name}",
        partial(_check, by_letter, answer),
        options=tuple((letter, f"{group.name}: {group.about}") for letter, group in by_letter.items()),
        program=shown_program(maker.program.source.decode("utf-8")),
        why=" ".join(part for part in (maker.text, card.back) if part),
    )


def _check(by_letter: Mapping[str, Group], answer: str, typed: str) -> Reply:
    letter = option(typed, list(by_letter))
    if letter == answer:
        return Reply(True, letter)
    return Reply(False, letter, why=f"It answers every case of {by_letter[letter].name} rightly.")


FORM = Form(Wants(needs=("problem",), takes=("mistakes", "back")), _ask)

"""A problem's mistakes as choices: changes of a right route, and of its input and answer; each is a program.

Every single mistake, and every two that do not touch the same lines, exist without having been written. A
choice is rendered as the text of a program, and what it answers is what that program answers.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import cached_property

from msgspec import Struct

from judge.mistakes.catalogue import EXAMPLE, Catalogue, MistakeText, read_catalogue
from judge.mistakes.routes import Change, Route, Routes, read_routes
from judge.mistakes.transforms import HELPERS, KEPT_BETWEEN_CALLS, transforms
from judge.problem import Problem
from judge.problem.solutions import MISTAKES
from judge.problem.toml import read_text

INNER = "right_way"  # what a route is called below a transform
KEPT = MistakeText(state=True, needs=("state",))  # where mistakes.toml says nothing of it


class Variant(Struct, frozen=True):
    """What is done otherwise: changes of one route and transforms, by their places; -1 is no transform."""

    route: int
    changes: tuple[int, ...] = ()
    before: int = -1
    after: int = -1


class SpoiledLine(Struct, frozen=True):
    """A line that a mistake spoils: what stands in a right program, and instead; one of them may be empty."""

    right: str
    wrong: str


class Family:
    """All choices of one problem. Raises ProblemError where its files cannot be read."""

    def __init__(self, problem: Problem, catalogue: Catalogue | None = None) -> None:
        self.problem = problem
        self.catalogue = read_catalogue(problem) if catalogue is None else catalogue
        path = problem.solutions / MISTAKES
        self.where = f"{path.parent.name}/{MISTAKES}"
        self._routes: Routes = read_routes(read_text(path), self.where)
        self._transforms = transforms(problem, self.catalogue)

    @staticmethod
    def of(problem: Problem, catalogue: Catalogue | None = None) -> Family | None:
        """The family of a problem; None where it has no mistakes.py."""
        return Family(problem, catalogue) if (problem.solutions / MISTAKES).is_file() else None

    @property
    def routes(self) -> Sequence[Route]:
        """The right ways, and those that are a mistake in themselves."""
        return self._routes.routes

    def right_ways(self) -> Iterator[Variant]:
        """What must be accepted: every right route, plain and with each of its styles."""
        for place, route in enumerate(self.routes):
            if not route.mistake:
                yield Variant(place)
                yield from (Variant(place, (i,)) for i, each in enumerate(route.changes) if not each.name)

    def singles(self) -> Iterator[Variant]:
        """Every mistake alone: on the plain route, and on routes that are one, in each of their styles."""
        for place, route in enumerate(self.routes):
            if route.mistake:
                yield Variant(place)
            for i, change in enumerate(route.changes):
                if change.name or route.mistake:
                    yield Variant(place, (i,))
        for i, each in enumerate(self._transforms):
            yield Variant(0, after=i) if each.after else Variant(0, before=i)

    def names(self, choice: Variant) -> tuple[str, ...]:
        """The mistakes it makes, in the order of the program."""
        found = [self._transforms[choice.before].name] if choice.before >= 0 else []
        found += [self.routes[choice.route].mistake] if self.routes[choice.route].mistake else []
        found += [change.name for change in self.changes(choice) if change.name]
        found += [self._transforms[choice.after].name] if choice.after >= 0 else []
        return tuple(dict.fromkeys(found))

    def changes(self, choice: Variant) -> list[Change]:
        """What it changes in its route."""
        return [self.routes[choice.route].changes[place] for place in choice.changes]

    @staticmethod
    def general(choice: Variant) -> bool:
        """Whether nothing of this problem's own file is changed, but input or answer as in any problem."""
        return not choice.changes and (choice.before >= 0 or choice.after >= 0)

    def offered(self, choice: Variant) -> bool:
        """Whether its name may be said, and no group need reject it: it comes from the types alone."""
        return any(self._transforms[i].offered for i in (choice.before, choice.after) if i >= 0)

    def words(self, name: str) -> MistakeText:
        """What mistakes.toml says of a mistake; nothing where it does not know it."""
        return self.catalogue.get(name, KEPT if name == KEPT_BETWEEN_CALLS else MistakeText())

    def told(self, choice: Variant) -> str:
        """What is wrong and what to do instead, as it fits this very change."""
        texts = [change.text for change in self.changes(choice)]
        texts += [self._transforms[i].text for i in (choice.before, choice.after) if i >= 0]
        own = next(filter(None, (*texts, self.routes[choice.route].text)), "")
        words = self.words(self.names(choice)[0])
        return f"{words.seen} {own}" if own.startswith(EXAMPLE) else own or words.told

    def place(self, choice: Variant) -> str:
        """Where it stands, as `count/mistakes.py:12`, or what it does to input and answer."""
        for change in self.changes(choice):
            if change.name:
                return f"{self.where}:{change.line}"
        for i in (choice.before, choice.after):
            if i >= 0:
                return self._transforms[i].line
        return f"{self.where}, {self.routes[choice.route].name}"

    def style_place(self, choice: Variant) -> str:
        """Where a right way stands: the line of its style, or its route."""
        changes = self.changes(choice)
        return (
            f"{self.where}:{changes[0].line}"
            if changes
            else f"{self.where}, {self.routes[choice.route].name}"
        )

    def equal(self, choice: Variant) -> str:
        """The reason why no case can tell it from a right program; empty where one must."""
        return next((change.equal for change in self.changes(choice) if change.equal), "")

    def lines(self, choice: Variant) -> tuple[SpoiledLine, ...]:
        """The lines it spoils, if they are few enough to say something by themselves."""
        route = self.routes[choice.route]
        found = []
        for change in self.changes(choice):
            for piece in change.pieces:
                old = [
                    line for line in route.lines[piece.start : piece.end] if not line.lstrip().startswith("#")
                ]
                if change.name and len(old) <= 1 >= len(piece.lines) - 1:
                    found.append(SpoiledLine("".join(old).strip(), "\n".join(piece.lines).strip()))
        return tuple(found) if len(found) == 1 else ()

    def program(self, choice: Variant) -> str:
        """The text of a whole program that makes the choice."""
        route = self.routes[choice.route]
        source = route.source(self.changes(choice))
        inner = INNER if choice.before >= 0 or choice.after >= 0 else self.problem.entry
        source = re.sub(rf"^def {route.name}\(", f"def {inner}(", source, count=1, flags=re.MULTILINE)
        parts = [self._routes.prelude, source.rstrip()]
        if inner == INNER:
            parts += [HELPERS, self._outer(choice)]
        return "\n\n\n".join(part for part in parts if part) + "\n"

    def _outer(self, choice: Variant) -> str:
        given = ", ".join(each.name for each in self.problem.parameters)
        rows = [f"def {self.problem.entry}({given}):"]
        if choice.before >= 0:
            rows.append(f"    {self._transforms[choice.before].line}")
        rows.append(f"    answer = {INNER}({given})")
        if choice.after >= 0:
            rows.append(f"    {self._transforms[choice.after].line}")
        return "\n".join([*rows, "    return answer"])

    @cached_property
    def named(self) -> tuple[tuple[Variant, str], ...]:
        """Every single choice with its mistake's name."""
        return tuple((choice, self.names(choice)[0]) for choice in self.singles())

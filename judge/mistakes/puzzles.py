"""Wrong programs that a person is to break with one case: one for each known mistake of a problem.

A puzzle shows a program as a person writes it, without a word of what is wrong with it. What is shown is what
is run. The easiest come first: those that the groups of the easier level should catch, and of them those that
the first groups should.

A mistake that shows only in the second of two calls is no puzzle, nor is one that only big cases show.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Sequence
from functools import cached_property

from msgspec import Struct

from judge.errors import UsageError, nearest
from judge.mistakes.family import read_makers
from judge.mistakes.plain import as_written
from judge.problem import Group, Problem
from judge.problem.model import LEVELS

HACKED = 12  # programs of a kata that are asked


class WrongProgram(Struct, frozen=True, dict=True):
    """One wrong program. `number` counts from 1, the easiest first; `advice` says what is wrong.

    `group` is one that should catch the mistake: its tolerance holds. It is `special` where no group that
    should catch it has the tolerance of most, so that a case must be fair to right programs too. A `trusted`
    one is a choice of mistakes.py, the setter's own code.
    """

    number: int
    mistake: str
    known: str
    entry: str
    advice: str
    group: Group
    special: bool
    trusted: bool = False

    @cached_property
    def source(self) -> bytes:
        """The `known` program as a person writes it; that of a choice begins at its `entry`."""
        return as_written(self.known, self.entry).encode()


def read_puzzles(problem: Problem, first: Collection[str] = ()) -> tuple[WrongProgram, ...]:
    """The puzzles of a problem, the mistakes `first` and then the easiest; none where none are known.

    Raises ProblemError where the files that tell of its mistakes are broken.
    """
    read = read_makers(problem)
    for fault in read.faults:
        raise fault
    usual = usual_group(problem).tolerance
    small = [group for group in problem.groups if group.size is None]
    small.sort(key=lambda group: LEVELS.index(group.level.value) if group.level else 0)
    found: list[WrongProgram] = []
    names = dict.fromkeys(name for group in small for name in sorted(group.kills))
    for name in sorted(names, key=lambda name: name not in first):
        makers = [each for each in read.all if each.name == name and not (each.words.state or each.equal)]
        if not makers:
            continue
        beside = [maker for maker in makers if maker.file == makers[0].file]
        maker = beside[len(beside) // 2]  # of an epsilon of every size, the middle one
        groups = [group for group in small if name in group.kills]
        fitting = [group for group in groups if group.tolerance == usual]
        group, trusted = (fitting or groups)[0], maker.program.trusted
        source, entry = maker.program.source.decode(), problem.entry if trusted else ""
        found.append(
            WrongProgram(len(found) + 1, name, source, entry, maker.text, group, not fitting, trusted)
        )
    return tuple(found)


def usual_group(problem: Problem) -> Group:
    """A group that has the tolerance of most."""
    usual = Counter(group.tolerance for group in problem.groups).most_common(1)[0][0]
    return next(group for group in problem.groups if group.tolerance == usual)


def puzzle_called(puzzles: Sequence[WrongProgram], word: str, problem: str) -> WrongProgram:
    """The puzzle of that number or mistake. Raises UsageError."""
    for puzzle in puzzles:
        if word in (str(puzzle.number), puzzle.mistake):
            return puzzle
    meant = nearest(word, [puzzle.mistake for puzzle in puzzles])
    remedy = f"did you mean {meant!r}?" if meant else f"they are numbered from 1 to {len(puzzles)}"
    raise UsageError(f"{problem} has no wrong program {word!r}", remedy=remedy)

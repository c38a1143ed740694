"""Wrong programs that a person is to break with one case: one for each known mistake of a problem.

A puzzle shows a program without a word of what is wrong with it: no docstring, no comment, and of what stands
before the function only what it uses. What is shown is what is run. The easiest come first: those that the
groups of the easier level should catch, and of them those that the first groups should.

A mistake that shows only in the second of two calls is no puzzle, nor is one that only big cases show.
"""

from __future__ import annotations

import ast
import io
import re
import tokenize
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence

from msgspec import Struct

from judge.errors import UsageError, nearest
from judge.mistakes.family import INNER
from judge.mistakes.makers import Maker, Makers, read_makers
from judge.problem import Group, Problem
from judge.problem.model import LEVELS

_NEUTRAL = "inner"  # what a function is called whose own name would tell that it is right


class Puzzle(Struct, frozen=True):
    """One wrong program. `number` counts from 1, the easiest first; `advice` says what is wrong.

    `group` is one that should catch the mistake: its tolerance holds. It is `special` where no group that
    should catch it has the tolerance of most, so that a case must be fair to right programs too. A `trusted`
    one is a choice of mistakes.py, the setter's own code.
    """

    number: int
    mistake: str
    source: bytes
    advice: str
    group: Group
    special: bool
    trusted: bool = False


def read_puzzles(problem: Problem) -> tuple[Puzzle, ...]:
    """The puzzles of a problem, the easiest first; none where no mistakes of it are known. It runs nothing.

    Raises ProblemError where the files that tell of its mistakes are broken.
    """
    read = read_makers(problem)
    for fault in read.faults:
        raise fault
    groups = _naming(read)
    usual = Counter(group.tolerance for group in problem.groups).most_common(1)[0][0]
    found: list[Puzzle] = []
    for name in sorted(groups, key=lambda name: (_ease(problem, groups[name][0]), name)):
        makers = [maker for maker in read.all if maker.name == name and _one_case_tells(read, maker)]
        if not makers:
            continue
        maker = _typical(makers)
        fitting = [group for group in groups[name] if group.tolerance == usual]
        puzzle = Puzzle(
            len(found) + 1,
            name,
            _bare(problem, maker),
            maker.text,
            (fitting or groups[name])[0],
            not fitting,
            maker.program.trusted,
        )
        found.append(puzzle)
    return tuple(found)


def puzzle_called(puzzles: Sequence[Puzzle], word: str, problem: str) -> Puzzle:
    """The puzzle of that number or mistake. Raises UsageError."""
    for puzzle in puzzles:
        if word in (str(puzzle.number), puzzle.mistake):
            return puzzle
    meant = nearest(word, [puzzle.mistake for puzzle in puzzles])
    remedy = f"did you mean {meant!r}?" if meant else f"they are numbered from 1 to {len(puzzles)}"
    raise UsageError(f"{problem} has no wrong program {word!r}", remedy=remedy)


def _naming(read: Makers) -> Mapping[str, list[Group]]:
    """The groups of small cases that should catch each mistake, the easier level first."""
    found: dict[str, list[Group]] = {}
    whole = read.problem
    for group in sorted(whole.groups, key=lambda group: _ease(whole, group)[0]):
        for name in group.kills if group.size is None else ():
            found.setdefault(name, []).append(group)
    return found


def _ease(problem: Problem, group: Group) -> tuple[int, int]:
    level = LEVELS.index(group.level.value) if group.level else 0
    return level, [each.name for each in problem.groups].index(group.name)


def _one_case_tells(read: Makers, maker: Maker) -> bool:
    if maker.words.state:
        return False
    return maker.choice is None or read.family is None or not read.family.equal(maker.choice)


def _typical(makers: Sequence[Maker]) -> Maker:
    """The one in the middle of those on the first line that makes it, such as an epsilon of every size."""
    beside = [maker for maker in makers if maker.file == makers[0].file]
    return beside[len(beside) // 2]


def without_pass(source: str) -> str:
    """The source without each `pass` on a line of its own beside other statements: it marks a change."""
    lines = source.splitlines()
    needless = {
        each.lineno
        for node in ast.walk(ast.parse(source))
        for name in ("body", "orelse", "finalbody")
        if isinstance(body := getattr(node, name, None), list)
        for each in body
        if isinstance(each, ast.Pass) and any(_does(other) for other in body)
    }
    return "".join(
        f"{row}\n" for number, row in enumerate(lines, 1) if number not in needless or row.strip() != "pass"
    )


def _does(node: ast.stmt) -> bool:
    """Whether it is neither `pass` nor a docstring."""
    text = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
    return not (text or isinstance(node, ast.Pass))


# -- a program without what would tell its mistake ----------------------------------------------------------


def _bare(problem: Problem, maker: Maker) -> bytes:
    source = maker.program.source.decode()
    if maker.choice is not None:
        source = re.sub(rf"\b{INNER}\b", _NEUTRAL, source)
        source = _without_unused(source, problem.entry)
    source = without_pass(_without_comments(source))
    lines = source.splitlines()
    for first, last in reversed(list(_docstrings(source))):
        del lines[first - 1 : last]
    return _tidy(lines).encode()


def _without_unused(source: str, entry: str) -> str:
    """The source without what stands outside and `entry` does not lead to, its lines left empty."""
    tree = ast.parse(source)
    lines = source.splitlines()
    wanted, fresh = {entry}, {entry}
    while fresh:
        used = {
            name.id
            for node in tree.body
            if not wanted.isdisjoint(_bound(node))
            for name in ast.walk(node)
            if isinstance(name, ast.Name)
        }
        wanted, fresh = wanted | used, used - wanted
    for node in tree.body:
        bound = _bound(node)
        first = min([node.lineno, *(each.lineno for each in getattr(node, "decorator_list", []))])
        if bound and wanted.isdisjoint(bound):
            lines[first - 1 : node.end_lineno] = [""] * ((node.end_lineno or first) - first + 1)
        elif isinstance(node, ast.ImportFrom) and not bound <= wanted:
            kept = [ast.unparse(alias) for alias in node.names if _called(alias) in wanted]
            lines[first - 1] = f"from {node.module} import {', '.join(kept)}"
            lines[first : node.end_lineno] = [""] * ((node.end_lineno or first) - first)
    return "\n".join(lines)


def _bound(node: ast.stmt) -> set[str]:
    """The names that a statement outside of functions gives a meaning to."""
    if isinstance(node, ast.FunctionDef | ast.ClassDef):
        return {node.name}
    if isinstance(node, ast.Import | ast.ImportFrom):
        return {_called(alias) for alias in node.names}
    if isinstance(node, ast.Assign | ast.AnnAssign):
        targets = node.targets if isinstance(node, ast.Assign) else [node.target]
        return {each.id for target in targets for each in ast.walk(target) if isinstance(each, ast.Name)}
    return set()


def _called(alias: ast.alias) -> str:
    return (alias.asname or alias.name).partition(".")[0]


def _without_comments(source: str) -> str:
    """The source with every comment taken out, in as many lines."""
    lines = source.splitlines()
    for token in tokenize.generate_tokens(io.StringIO(source).readline):
        if token.type == tokenize.COMMENT:
            row, column = token.start
            lines[row - 1] = lines[row - 1][:column].rstrip()
    return "\n".join(lines)


def _docstrings(source: str) -> Iterator[tuple[int, int]]:
    """The first and last line of each, from 1, in order; of what has nothing else in it, none."""
    found = []
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Module | ast.FunctionDef | ast.ClassDef) and len(node.body) > 1:
            first = node.body[0]
            if isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant):
                found.append((first.lineno, first.end_lineno or first.lineno))
    return iter(sorted(found))


def _tidy(lines: Sequence[str]) -> str:
    """The lines with no empty one at either end, and at most two together; within a function none."""
    kept: list[str] = []
    for at, row in enumerate(lines):
        after = next((each for each in lines[at:] if each.strip()), "")
        if row.strip() or (kept and after and not after[0].isspace() and kept[-2:] != ["", ""]):
            kept.append(row.rstrip())
    return "\n".join(kept).strip("\n") + "\n"

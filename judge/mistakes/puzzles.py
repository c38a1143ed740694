"""Wrong programs that a person is to break with one case: one for each known mistake of a problem.

A puzzle shows a program without a word of what is wrong with it, and without what does nothing: docstrings,
comments, names that are never read, what stands below a return. What is shown is what is run. The easiest
come first: those that the groups of the easier level should catch, and of them those that the first groups
should.

A mistake that shows only in the second of two calls is no puzzle, nor is one that only big cases show.
"""

from __future__ import annotations

import ast
import io
import re
import tokenize
from collections import Counter
from collections.abc import Collection, Iterator, Sequence

from msgspec import Struct

from judge.errors import UsageError, nearest
from judge.mistakes.family import INNER
from judge.mistakes.makers import Maker, Makers, read_makers
from judge.problem import Group, Problem
from judge.problem.model import LEVELS

_HARMLESS = ("abs", "copysign", "hypot", "len", "map", "max", "min")  # calls that cannot fail on valid input
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


def read_puzzles(problem: Problem, first: Collection[str] = ()) -> tuple[Puzzle, ...]:
    """The puzzles of a problem, the mistakes `first` and then the easiest; none where none are known.

    Raises ProblemError where the files that tell of its mistakes are broken.
    """
    read = read_makers(problem)
    for fault in read.faults:
        raise fault
    usual = usual_group(problem).tolerance
    small = [group for group in problem.groups if group.size is None]
    small.sort(key=lambda group: LEVELS.index(group.level.value) if group.level else 0)
    found: list[Puzzle] = []
    names = dict.fromkeys(name for group in small for name in sorted(group.kills))
    for name in sorted(names, key=lambda name: name not in first):
        makers = [maker for maker in read.all if maker.name == name and _one_case_tells(read, maker)]
        if not makers:
            continue
        beside = [maker for maker in makers if maker.file == makers[0].file]
        maker = beside[len(beside) // 2]  # of an epsilon of every size, the middle one
        groups = [group for group in small if name in group.kills]
        fitting = [group for group in groups if group.tolerance == usual]
        group, trusted = (fitting or groups)[0], maker.program.trusted
        source = _bare(problem, maker)
        found.append(Puzzle(len(found) + 1, name, source, maker.text, group, not fitting, trusted))
    return tuple(found)


def usual_group(problem: Problem) -> Group:
    """A group that has the tolerance of most."""
    usual = Counter(group.tolerance for group in problem.groups).most_common(1)[0][0]
    return next(group for group in problem.groups if group.tolerance == usual)


def puzzle_called(puzzles: Sequence[Puzzle], word: str, problem: str) -> Puzzle:
    """The puzzle of that number or mistake. Raises UsageError."""
    for puzzle in puzzles:
        if word in (str(puzzle.number), puzzle.mistake):
            return puzzle
    meant = nearest(word, [puzzle.mistake for puzzle in puzzles])
    remedy = f"did you mean {meant!r}?" if meant else f"they are numbered from 1 to {len(puzzles)}"
    raise UsageError(f"{problem} has no wrong program {word!r}", remedy=remedy)


def _one_case_tells(read: Makers, maker: Maker) -> bool:
    if maker.words.state:
        return False
    return maker.choice is None or read.family is None or not read.family.equal(maker.choice)


# -- a program without what would tell its mistake ----------------------------------------------------------


def _bare(problem: Problem, maker: Maker) -> bytes:
    source, entry = maker.program.source.decode(), ""
    if maker.choice is not None:
        source, entry = re.sub(rf"\b{INNER}\b", _NEUTRAL, source), problem.entry
    source = _without_comments(source)
    while (shorter := _cut(_inlined(source), entry)) != source:
        source = shorter
    return _tidy(source.splitlines()).encode()


def _cut(source: str, entry: str) -> str:
    """The source with every statement that does nothing left empty, or what is left of it in its place."""
    tree = ast.parse(source)
    lines = source.splitlines()
    for node, rest in (*_needless(tree), *_unused(tree, entry)):
        first = min([node.lineno, *(each.lineno for each in getattr(node, "decorator_list", []))])
        last = node.end_lineno or first
        before = lines[first - 1].encode()[: node.col_offset]
        after = lines[last - 1].encode()[node.end_col_offset or 0 :]
        if not before.strip() and not after.strip():  # it has its lines for itself
            lines[first - 1 : last] = [rest] + [""] * (last - first)
    return "\n".join(lines)


def _needless(tree: ast.Module) -> Iterator[tuple[ast.stmt, str]]:
    """Statements of a block that do nothing there; never all of one."""
    unread = {id(each) for node in tree.body for each in _unread(node)}
    for node in ast.walk(tree):
        for block in (getattr(node, name, None) for name in ("body", "orelse", "finalbody")):
            found, ended = [], False
            for each in block if isinstance(block, list) else ():
                text = isinstance(each, ast.Expr) and isinstance(each.value, ast.Constant)
                if ended or text or isinstance(each, ast.Pass) or id(each) in unread:
                    found.append((each, ""))
                ended = ended or isinstance(each, ast.Return | ast.Raise | ast.Continue | ast.Break)
            yield from found if isinstance(block, list) and len(found) < len(block) else ()


def _unread(function: ast.stmt) -> Iterator[ast.Assign]:
    """Assignments to names that the function never reads, of values that cannot fail."""
    nodes = list(ast.walk(function)) if isinstance(function, ast.FunctionDef) else []
    read = {each.id for each in nodes if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Load)}
    targets = [each.target for each in nodes if isinstance(each, ast.AugAssign)]
    read |= {each.id for each in targets if isinstance(each, ast.Name)}
    read |= {name for each in nodes if isinstance(each, ast.Global | ast.Nonlocal) for name in each.names}
    for each in nodes:
        if isinstance(each, ast.Assign) and _bound(each).isdisjoint(read) and _is_harmless(each.value):
            yield each


def _is_harmless(value: ast.expr) -> bool:
    """Whether to work it out changes nothing, and does not fail as the root of a number below 0 does."""
    parts = list(ast.walk(value))
    calls = (each.func for each in parts if isinstance(each, ast.Call))
    plain = all(isinstance(each, ast.Name) and each.id in _HARMLESS for each in calls)
    return plain and not any(isinstance(each, ast.FloorDiv | ast.Mod | ast.Pow) for each in parts)


def _inlined(source: str) -> str:
    """The source with x in place of every f(x) where f returns what it is given."""
    tree = ast.parse(source)
    same = {
        node.name
        for node in tree.body
        if isinstance(node, ast.FunctionDef)
        and [*map(ast.unparse, node.body)] == [f"return {ast.unparse(node.args)}"]
    }
    lines = source.splitlines()
    for call in ast.walk(tree):
        if isinstance(call, ast.Call) and isinstance(call.func, ast.Name) and call.func.id in same:
            row = lines[call.lineno - 1]
            if call.lineno == call.end_lineno and row.isascii():  # whose columns are its bytes
                given = ast.unparse(call.args[0])
                lines[call.lineno - 1] = row[: call.col_offset] + given + row[call.end_col_offset :]
                return _inlined("\n".join(lines))
    return source


def _unused(tree: ast.Module, entry: str) -> Iterator[tuple[ast.stmt, str]]:
    """What stands outside and `entry` does not lead to; nothing where there is no entry."""
    wanted, fresh = {entry}, {entry}
    while fresh:
        parts = [part for node in tree.body if wanted & _bound(node) for part in ast.walk(node)]
        used = {part.id for part in parts if isinstance(part, ast.Name)}
        wanted, fresh = wanted | used, used - wanted
    for node in tree.body if entry else ():
        bound = _bound(node)
        if bound and wanted.isdisjoint(bound):
            yield node, ""
        elif isinstance(node, ast.ImportFrom) and not bound <= wanted:
            kept = [ast.unparse(alias) for alias in node.names if _called(alias) in wanted]
            yield node, f"from {node.module} import {', '.join(kept)}"


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


def _tidy(lines: Sequence[str]) -> str:
    """The lines with no empty one at either end, and at most two together; within a function none."""
    kept: list[str] = []
    for at, row in enumerate(lines):
        after = next((each for each in lines[at:] if each.strip()), "")
        if row.strip() or (kept and after and not after[0].isspace() and kept[-2:] != ["", ""]):
            kept.append(row.rstrip())
    return "\n".join(kept).strip("\n") + "\n"

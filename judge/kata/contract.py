"""A statement as the docstring of a stub: what is wanted, wrapped for code, the examples as doctests.

Left out are the title, the task and the signature (the stub has its own), figures, and what concerns
programs that read standard input.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Callable, Iterator

from msgspec import Struct

from judge.problem import Example, Problem

_ITEM = re.compile(r"(?:[-*+]|\d+[.)])\s+")
_HEADING = re.compile(r"(#+)\s")
_FENCE = "```"
_CODE = "    "

Prompt = Callable[[Example], list[str]]  # the lines of one doctest


class _Block(Struct, frozen=True):
    """A part of a Markdown text that is wrapped, or left as it is, in one piece."""

    kind: str  # "heading", "text", "item", "code" or "example"
    lines: tuple[str, ...]
    number: int  # of its first line, from 1


def contract_lines(problem: Problem, width: int, prompt: Prompt) -> list[str]:
    """The statement's contract in lines of at most `width` columns where it is prose.

    `prompt` writes an example as a doctest. Blank lines stand between the parts, none at either end.
    """
    examples = {example.line: example for example in problem.examples}
    laid: list[str] = []
    before = ""
    for block in _told(problem):
        tight = before == block.kind and block.kind in ("item", "example")
        laid += [] if tight or not laid else [""]
        if block.kind == "example":
            laid += prompt(examples[block.number])
        else:
            laid += _wrapped(block, width)
        before = block.kind
    return laid


def _wrapped(block: _Block, width: int) -> list[str]:
    if block.kind in ("code", "heading"):
        return list(block.lines)
    text = " ".join(line.strip() for line in block.lines)
    marker = _ITEM.match(text) if block.kind == "item" else None
    hanging = " " * (marker.end() if marker else 0)
    return textwrap.wrap(
        text, width, subsequent_indent=hanging, break_long_words=False, break_on_hyphens=False
    )


def _told(problem: Problem) -> Iterator[_Block]:
    """The blocks that belong to the contract; "Write a function … that returns" becomes "Return"."""
    skipped = 0  # the level of the heading whose section is left out
    task: _Block | None = None  # the words before the signature, which those after it go on from
    for block in _blocks(problem.statement.splitlines()):
        heading = _HEADING.match(block.lines[0]) if block.kind == "heading" else None
        if heading:
            level = len(heading[1])
            if level == 1:
                continue
            if not skipped or level <= skipped:
                skipped = level if _concerns_programs(block.lines[0], problem) else 0
        if skipped or _is_told_elsewhere(block, problem):
            continue
        if block.kind == "text" and task is None and "function" in block.lines[-1].split()[-1:]:
            task = block
        elif block.kind == "code" and _is_signature(block, problem):
            continue
        elif task is not None and task.lines:
            yield _joined(task, block)
            task = _Block("text", (), 0)
        else:
            yield block


def _concerns_programs(heading: str, problem: Problem) -> bool:
    return "program" in heading.lower() and problem.entry not in heading


def _is_told_elsewhere(block: _Block, problem: Problem) -> bool:
    """Whether it is a figure, the task, which the summary tells, or the rule for programs."""
    text = " ".join(line.strip() for line in block.lines)
    if block.kind == "item":
        return "is run as a program" in text
    return block.kind == "text" and text.startswith(("![", f"Write `{problem.entry}("))


def _is_signature(block: _Block, problem: Problem) -> bool:
    words = [line.strip().removeprefix("def ") for line in block.lines]
    return len(words) == 1 and words[0].startswith(f"{problem.entry}(")


def _joined(task: _Block, rest: _Block) -> _Block:
    text = " ".join([*task.lines, *rest.lines])
    return _Block("text", (re.sub(r"^Write a function that returns ", "Return ", text),), task.number)


def _blocks(lines: list[str]) -> Iterator[_Block]:
    """The text in blocks; an example is one wherever it stands."""
    at = 0
    while at < len(lines):
        start, kind = at, _kind(lines[at])
        at += 1
        if not kind:
            continue
        if kind == "fence":
            at, inner = _fenced(lines, at)
            yield from inner
            continue
        if kind != "heading":
            while at < len(lines) and _goes_on(kind, lines[at]):
                at += 1
        yield _Block(kind, tuple(lines[start:at]), start + 1)


def _fenced(lines: list[str], start: int) -> tuple[int, list[_Block]]:
    """What a fence that opens before `start` holds, and the place behind it."""
    end = next((at for at in range(start, len(lines)) if lines[at].startswith(_FENCE)), len(lines))
    prompts = [at for at in range(start, end) if lines[at].lstrip().startswith(">>>")]
    if prompts:
        return end + 1, [_Block("example", (lines[at],), at + 1) for at in prompts]
    code = tuple(_CODE + line if line.strip() else "" for line in lines[start:end])
    return end + 1, [_Block("code", code, start + 1)] if code else []


def _kind(line: str) -> str:
    """What begins with this line; nothing where it is blank."""
    if not line.strip():
        return ""
    if line.startswith(_FENCE):
        return "fence"
    if line.lstrip().startswith(">>>"):
        return "example"
    if _HEADING.match(line):
        return "heading"
    if line.startswith((_CODE, "|")):
        return "code"
    return "item" if _ITEM.match(line) else "text"


def _goes_on(kind: str, line: str) -> bool:
    """Whether `line` belongs to the block of that kind that stands above it."""
    following = _kind(line)
    if kind == "example":  # the answer, and further lines of the call
        return following not in ("", "example", "fence")
    if kind == "code":
        return following == "code"
    return following == "text" or (following == "code" and kind == "item")

"""The rules of a statement, and the mistakes that ignore them: every rule should have one.

A rule is an item of the list that stands before `## Examples`. A change of mistakes.py names the rule that it
ignores by a few of its words: `# @ goes on for ever`.
"""

from __future__ import annotations

from collections.abc import Iterator

from judge.mistakes.family import Family
from judge.run.verify import Fault

_SHOWN = 60  # characters of a rule in a message


def rules_of(statement: str) -> list[str]:
    """The rules of a statement's text, each in one line."""
    found: list[list[str]] = []
    open_ = False
    for line in statement.partition("\n## Examples")[0].splitlines():
        if line.startswith("- "):
            found.append([])
        open_ = line.startswith("- ") or (open_ and line[:1] in ("", " "))
        if open_:
            found[-1] += line.removeprefix("- ").split()
    return [" ".join(words) for words in found]


def rule_faults(family: Family) -> tuple[list[Fault], list[Fault]]:
    """The changes that name no rule or more than one, and as warnings the rules that no change ignores."""
    rules = rules_of(family.problem.statement)
    ignored: set[str] = set()
    faults = []
    for words, line in _tags(family):
        meant = [rule for rule in rules if words in rule]
        ignored.update(meant)
        if len(meant) != 1:
            count = f"{len(meant)} rules have" if meant else "no rule has"
            what = f"{count} the words {words!r}"
            faults.append(Fault(what, f"{family.where}:{line}", "write words that stand in one rule"))
    remedy = (
        f"write the mistake that ignores it in {family.where}, with '# @ ' and some of its words below it"
    )
    where = f"{family.problem.id}/statement.md"
    return faults, [
        Fault(f"no mistake ignores the rule {_short(rule)!r}", where, remedy)
        for rule in rules
        if rule not in ignored
    ]


def _tags(family: Family) -> Iterator[tuple[str, int]]:
    tags = {
        (words, change.line)
        for route in family.routes
        for change in route.changes
        if not change.equal
        for words in change.rules
    }
    return iter(sorted(tags, key=lambda tag: tag[1]))


def _short(rule: str) -> str:
    return rule if len(rule) <= _SHOWN else rule[: _SHOWN - 1].rstrip() + "…"

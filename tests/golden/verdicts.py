"""What a right and a wrong program of each kata come to, a line of JSON for each: python verdicts.py KATA…

The cases drawn and the mistakes known by the Python that runs it. Groups whose size grows are left out: how
far a slow program comes in them depends on what else the machine does.
"""

from __future__ import annotations

import json
import sys

from judge import RunOptions, Session
from judge.languages import language_of
from judge.mistakes.puzzles import read_puzzles
from judge.problem import Problem
from judge.problem.find import find_problem


def programs(problem: Problem) -> tuple[bytes, bytes]:
    """A right program, and one with a known mistake."""
    accepted, wrong = (
        [path for path in sorted((problem.solutions / kind).glob("*.py")) if not language_of(path)]
        for kind in ("accepted", "wrong")
    )
    puzzles = read_puzzles(problem)
    mistaken = puzzles[len(puzzles) // 2].source if puzzles else wrong[0].read_bytes()
    return accepted[0].read_bytes(), mistaken


def main() -> None:
    """Write the lines."""
    for kata in sys.argv[1:]:
        problem = find_problem(kata)
        groups = tuple(group.name for group in problem.groups if group.size is None)
        with Session(problem, RunOptions(groups=groups, timed=False)) as session:
            for source in programs(problem):
                result = session.judge(source, "program.py")
                smallest = result.counterexample
                row = {
                    "kata": kata,
                    "verdict": result.verdict.value,
                    "groups": [(group.name, group.verdict.value, group.passed) for group in result.groups],
                    "smallest": smallest
                    and (smallest.group, smallest.input, smallest.expected, smallest.got),
                    "name": result.pitfall and result.pitfall.names,
                }
                print(json.dumps(row))


if __name__ == "__main__":
    main()

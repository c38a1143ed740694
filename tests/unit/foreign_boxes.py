"""Boxes of programs in another language that only exist on paper: what a run takes is said, not measured."""

from __future__ import annotations

from collections.abc import Callable
from random import Random

from msgspec.structs import replace

from judge.run.budget import Budget
from judge.run.function import FunctionRunner
from judge.run.group import GroupRun
from judge.run.program import ProgramRunner
from judge.run.races import measure
from judge.run.reference import Reference
from judge.sandbox.boundary import Inspection, ProgramResult, SourceFault, Stop, Usage

START = 0.05


class Paper:
    """A program that answers rightly; a run on so many passes takes `start` + `seconds(passes)` of CPU time.

    `bad` are numbers of passes from which on it is out of memory, `wrong` those from which on it answers 7;
    an answer is filled up with blanks to `width` characters.
    """

    isolation = "limits"

    def __init__(
        self, seconds, *, start=START, noise=0.0, bad=10**9, wrong=10**9, width=0, fault="", language="Go"
    ):
        self.seconds: Callable[[int], float] = seconds
        self.start, self.noise, self.bad, self.wrong = start, noise, bad, wrong
        self.width, self.fault, self.language = width, fault, language
        self.idle = Usage(0.05, 0.05, 0)
        self.runs: list[int] = []
        self._random = Random(1)

    def inspect(self):
        return Inspection(
            SourceFault(self.fault) if self.fault else None, (("answer", 1),), (), self.language
        )

    def run_whole(self, stdin, limits):
        passes, lines = 0, []
        rows = stdin.decode().splitlines()
        while rows:
            count = int(rows[0].split()[0])
            called = len(rows[0].split()) == 2
            passes += 1 if called else count // 4
            for at, row in enumerate(rows[1 : 1 + count]):
                number = (
                    7
                    if passes + (0 if called else at // 4) > self.wrong
                    else int(sum(map(float, row.split())))
                )
                lines.append(f"[0,{number}]" if called else str(number))
            rows = rows[1 + count :]
        self.runs.append(passes)
        took = self.start + self.seconds(passes) * (1 + self.noise * self._random.uniform(-1, 1))
        usage = Usage(took, took, 1 << 20)
        if passes >= self.bad:
            return ProgramResult(Stop.MEMORY, b"", b"", "used more than 256 MB", usage)
        stdout = "".join(f"{line:{self.width}}\n" for line in lines).encode()
        if len(stdout) > limits.output_bytes:
            return ProgramResult(Stop.OUTPUT, b"", b"", "wrote too much", usage)
        return ProgramResult(Stop.ANSWERED, stdout, b"", "", usage)

    def run_program(self, stdin, limits):
        done = self.run_whole(stdin, limits)
        return done._replace(usage=done.usage._replace(cpu_seconds=done.usage.cpu_seconds - self.start))

    def __enter__(self):
        return self

    def __exit__(self, *exc):
        pass


class Library(Reference):
    """Reference solutions on paper, by their files' names."""

    def __init__(self, problem, boxes):
        super().__init__(problem, lambda source, name: None)
        self._on_paper = boxes

    def open(self, name):
        return self._on_paper.get(name)


def raced(data, rule, mine, boxes, *, program=False):
    """The decision and the group, of a submission in Go that was accepted."""
    problem = replace(data.problem, time=rule)
    runner = ProgramRunner(problem, language="Go") if program else FunctionRunner(problem, "Go")
    run = GroupRun(data, data.groups[0], runner)
    run.passed = len(run.cases)
    decision = measure(problem, runner, [run], mine, Library(problem, boxes), Budget(problem))
    return decision, run

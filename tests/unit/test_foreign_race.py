"""The race of a submission in another language: what its time is held to, and what noise can't decide."""

from __future__ import annotations

from collections.abc import Callable
from random import Random

import pytest
from judging import make_data
from msgspec.structs import replace

from judge.errors import JudgeError, UsageError
from judge.problem import TimeRule, Verdict
from judge.problem.find import find_problem
from judge.run.execute import measure
from judge.run.foreign import LONG_SECONDS, passes_for
from judge.run.group import GroupRun
from judge.run.groups import Judging
from judge.run.program import ProgramRunner
from judge.run.runner import Replies, Runner
from judge.run.settings import Reference, check_needs
from judge.run.timing import TurnPair, decide
from judge.sandbox.boundary import Inspection, ProgramResult, Reply, SourceFault, Stop, Usage

START = 0.05


class Paper:
    """A program on paper that answers rightly; so many passes take `start` + `seconds(passes)` of CPU time.

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
    runner = ProgramRunner(problem, language="Go") if program else Runner(problem, "Go")
    run = GroupRun(data, data.groups[0], runner)
    run.passed = len(run.cases)
    decision = measure(Judging(runner, mine), [run], Library(problem, boxes), beside=False)
    return decision, run


LIMIT = 10.0
RULE = TimeRule(LIMIT, "calls.py", references={"go": "reference.go"})
ONE = 0.0005  # seconds of a pass of the reference


def steady(factor=1.0):
    return lambda passes: factor * ONE * passes


def warming(factor=1.0, cold=0.04):
    """A compiler at run time: the first passes take longer than all later ones."""
    return lambda passes: factor * ONE * passes + (cold if passes else 0.0)


def race(mine, reference=None, rule=RULE, **more):
    return raced(make_data("one"), rule, mine, {"reference.go": reference or Paper(steady())}, **more)


@pytest.mark.parametrize("start", [0.0, 0.5])
@pytest.mark.parametrize("cost", [steady, warming])
def test_the_start_is_taken_off_both_and_the_reference_takes_long_enough(cost, start):
    reference = Paper(cost(), start=start)
    decision, run = race(Paper(cost(), start=start), reference)
    assert decision.ratio.median == pytest.approx(1.0, abs=0.01)
    assert (decision.too_slow, decision.borderline, run.verdict) == (False, False, Verdict.AC)
    assert cost()(max(reference.runs)) >= LONG_SECONDS
    assert (decision.reference, decision.why) == ("Go", "")


@pytest.mark.parametrize(("factor", "too_slow"), [(7.9, False), (14, True)])
def test_what_is_clear_is_decided(factor, too_slow):
    decision, _ = race(Paper(steady(factor)))
    assert (decision.too_slow, decision.borderline) == (too_slow, False)
    assert decision.ratio.median == pytest.approx(factor, rel=0.1)


@pytest.mark.parametrize("noise", [0.3, 0.6])
@pytest.mark.parametrize("factor", [9.0, 10.0, 11.0])
def test_noise_around_the_limit_is_a_close_call_and_never_too_slow(factor, noise):
    decision, _ = race(Paper(steady(factor), noise=noise), Paper(steady(), noise=noise))
    assert (decision.too_slow, decision.borderline) == (False, True)


def test_long_answers_have_room_in_every_pass():
    data, width = make_data("one"), 10_000
    reference = Paper(steady(), width=width)
    decision, run = raced(data, RULE, Paper(steady(2), width=width), {"reference.go": reference})
    wrote = max(reference.runs) * len(run.cases) * width
    assert wrote > 2 * data.problem.limits.output_bytes
    assert decision.ratio.median == pytest.approx(2.0, abs=0.1)


@pytest.mark.parametrize("first", [0.1, 0.9])
def test_who_remembers_answers_is_raced_by_first_passes(first):
    mine = Paper(lambda passes: first + 0.00001 * passes if passes else 0.0)
    decision, _ = race(mine)
    assert decision.too_slow
    assert max(mine.runs) == 1


@pytest.mark.parametrize(("factor", "cold", "theirs"), [(1, 0.6, 0.3), (7, 0.3, 0.15), (9, 0.36, 0.04)])
def test_who_warms_up_is_no_slower_for_that(factor, cold, theirs):
    decision, _ = race(Paper(warming(factor, cold)), Paper(warming(1, theirs)))
    assert not decision.too_slow
    assert decision.ratio.median < LIMIT


def test_the_start_is_measured_in_every_turn():
    """The machine starts a language the more slowly the longer the race takes."""

    class Later(Paper):
        def run_whole(self, stdin, limits):
            self.start = START + 0.01 * sum(passes > 0 for passes in reference.runs)
            return super().run_whole(stdin, limits)

    reference = Later(steady())
    decision, _ = race(Later(steady(9)), reference)
    assert decision.ratio.pairs == 9
    assert decision.ratio.median == pytest.approx(9.0, abs=0.5)


@pytest.mark.parametrize(("factor", "too_slow"), [(1, False), (7, False), (60, True)])
def test_what_does_not_survive_the_passes_is_raced_by_single_ones(factor, too_slow):
    decision, run = race(Paper(steady(factor), bad=20))
    assert decision.too_slow is too_slow
    assert decision.ratio.median <= factor
    assert run.verdict is Verdict.AC


def test_a_function_that_answers_otherwise_in_a_later_pass_is_wrong():
    decision, run = race(Paper(steady(), wrong=20))
    assert (run.verdict, decision.too_slow) == (Verdict.WA, False)
    assert "when it was run again to be timed" in run.failure.message


def test_a_program_that_was_promised_fewer_cases_is_not_wrong():
    rule = TimeRule(LIMIT, "calls.py", "program.py")
    decision, run = raced(
        make_data("one"), rule, Paper(steady(), wrong=20), {"program.py": OnPaper(0.001)}, program=True
    )
    assert run.verdict is Verdict.AC
    assert decision.why == "no reference program in Go: held to Python's"


class OnPaper:
    """Python's reference: a call or line takes so many seconds."""

    def __init__(self, seconds):
        self.seconds = seconds


@pytest.fixture(autouse=True)
def python(monkeypatch):
    """Python's own on paper too: it answers each case, and takes its time for each."""

    def ask(self, box, cases, limits):
        assert isinstance(box, OnPaper)
        return Replies([Reply(Stop.ANSWERED, 0)] * len(cases), Usage(box.seconds * len(cases)))

    monkeypatch.setattr(Runner, "ask", ask)
    monkeypatch.setattr("judge.run.program.ProgramRunner.ask", ask)


@pytest.mark.parametrize(("factor", "too_slow"), [(7, False), (14, True)])
def test_without_a_reference_in_its_language_it_is_held_to_pythons(factor, too_slow):
    rule = TimeRule(LIMIT, "calls.py")
    decision, _ = raced(make_data("one"), rule, Paper(steady(factor)), {"calls.py": OnPaper(ONE / 4)})
    assert decision.ratio.median == pytest.approx(factor, rel=0.1)
    assert decision.too_slow is too_slow
    assert (decision.reference, decision.why) == (
        "Python",
        "no reference in Go: held to Python's",
    )


@pytest.mark.parametrize(
    ("reference", "said"),
    [
        (Paper(steady(), fault="no semicolon"), "in Go does not compile: no semicolon"),
        (Paper(steady(), bad=1), "cannot be timed: used more than 256 MB"),
    ],
)
def test_a_reference_that_fails_is_no_fault_of_the_submission(reference, said):
    with pytest.raises(JudgeError, match=said):
        race(Paper(steady()), reference)


def test_passes_are_enough_and_nothing_short_is_divided_by():
    taken = []

    def run(passes):
        taken.append(passes)
        return 0.0 if passes < 100 else 0.0001 * passes

    assert passes_for(0.1, run, 10**6)[1] >= 0.1
    assert len(taken) <= 6
    assert passes_for(0.1, lambda passes: 0.0, 500) == (500, 0.0)


@pytest.mark.parametrize(
    ("ratios", "too_slow", "borderline"),
    [
        ([20] * 9, True, False),  # every pair is clearly above
        ([14, 30, 14, 30, 14, 30, 14, 30, 14], True, False),
        ([11] * 9, True, True),
        ([9, 9, 9, 9, 11, 11, 11, 11, 11], False, True),  # quartiles on both sides
        ([10.5, 10.5, 10.5, 10.5, 12, 20, 20, 20, 20], False, True),  # and too far apart
        ([5] * 9, False, False),
    ],
)
def test_a_cautious_decision(ratios, too_slow, borderline):
    decision = decide([TurnPair(0.1 * ratio, 0.1) for ratio in ratios], LIMIT, cautious=True)
    assert (decision.too_slow, decision.borderline) == (too_slow, borderline)


def test_what_the_reference_needs_is_told_where_it_is_missing():
    problem = find_problem("vector")
    assert problem.time.needs == ("numpy",)
    check_needs(problem)
    missing = replace(problem, time=replace(problem.time, needs=("no_such_module",)))
    with pytest.raises(UsageError, match=r"imports no_such_module, which is not installed; .*pip install"):
        check_needs(missing)

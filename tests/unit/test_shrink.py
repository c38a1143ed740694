"""The smallest case of a wrong program fails, keeps the promise and is simpler than what failed first."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from contextlib import ExitStack
from pathlib import Path

import pytest
from mistaken import mistaken
from msgspec.structs import replace

from judge.data import ProblemData
from judge.data.build import validate
from judge.data.load import load_data
from judge.diagnose.candidates import measure, numbers_of
from judge.diagnose.replay import decode
from judge.diagnose.shrink import shrink
from judge.diagnose.trial import SearchBudget, Trial
from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.problem.module import load_module
from judge.run.execute import judge_submission, opened
from judge.run.runner import Runner
from judge.run.settings import Reference, Settings
from judge.sandbox import open_box
from judge.sandbox.boundary import Stop, Usage

pytestmark = pytest.mark.slow

FIXTURES = Path(__file__).parents[1] / "fixtures"
PACKS = [FIXTURES / "problems", FIXTURES / "pack" / "problems"]
MIDDLE = "def middle(a, b):\n    {}\n    return (a + b) / 2\n"


def shrunk(name, source, *, budget=None, cpu_seconds=2.0, later=None):
    """The result of judging the source, and its counterexample; that search has `later` CPU seconds."""
    problem = find_problem(name, PACKS)
    problem = replace(problem, limits=replace(problem.limits, cpu_seconds=cpu_seconds))
    data = ProblemData(problem, load_data(problem).groups)
    source = source.encode() if isinstance(source, str) else source
    result = judge_submission(data, source, "mine.py", Settings(measured=False)).result
    with ExitStack() as stack:
        if later is not None:
            data = ProblemData(
                replace(problem, limits=replace(problem.limits, cpu_seconds=later)), data.groups
            )
        box = stack.enter_context(open_box(source, "mine.py"))
        runner = opened(box, data.problem, source)
        reference = stack.enter_context(Reference(problem, open_box))
        found = shrink(
            data,
            box,
            runner,
            result,
            reference=reference,
            budget=budget or SearchBudget(cpu=600.0, wall=600.0),  # of a busy machine
        )
    return problem, result, found


LARGE = MIDDLE.format("if a * b > 100_000: return 7")


def test_the_smallest_case_fails_by_itself_and_always_is_the_same():
    problem, _, found = shrunk("middle", LARGE)
    assert shrunk("middle", LARGE)[2] == found
    case = tuple(found.input.values())
    assert (case, found.cut_short) == ((200, 600), False)
    again = decode(found.replay, problem, load_module(problem))
    assert again[:2] == (problem.group(found.group), case)
    assert list(found.input) == [parameter.name for parameter in problem.parameters]
    space = {}
    exec(compile(LARGE, "mine.py", "exec"), space)
    assert repr(space["middle"](*case)) == found.got != found.expected


def simplest_of(count, deed):
    """The simplest of so many cases for which such a program fails, sought twice; what was called by then."""
    source, budget = MIDDLE.format(deed).encode(), SearchBudget()
    problem = find_problem("middle", PACKS)
    data = load_data(problem)
    cases, group = [(0, number) for number in range(count)], data.groups[0].group
    with open_box(source, "mine.py") as box:
        runner = opened(box, problem, source)
        trial = Trial(data.module, box, runner, Verdict.WA, budget)
        return [(trial.simplest(cases, group), budget.calls) for _ in range(2)]


def test_a_case_that_the_reference_gets_wrong_counts_for_nothing():
    source = MIDDLE.format("return 7").encode()
    problem = find_problem("middle", PACKS)
    data = load_data(problem)
    reference = MIDDLE.format("if b == 0: return 7").encode()
    with open_box(source, "mine.py") as box, open_box(reference, "reference.py") as other:
        trial = Trial(data.module, box, opened(box, problem, source), Verdict.WA, SearchBudget())
        trial.reference = lambda: other
        cases, group = [(0, 0), (0, 1)], data.groups[0].group
        assert trial.simplest(cases, group).case == (0, 1)
        assert trial.simplest(cases, group, reference_agrees=False).case == (0, 0)


def test_a_case_that_was_right_is_not_called_again():
    assert simplest_of(300, "pass") == [(None, 300)] * 2


def test_a_machine_that_stands_still_once_does_not_end_the_search(monkeypatch):
    asked, stalls = Runner.ask, [True]

    def ask(runner, box, cases, limits):
        replies = asked(runner, box, cases, limits)
        return replies._replace(stop=Stop.WAITING, replies=[]) if stalls and stalls.pop() else replies

    monkeypatch.setattr(Runner, "ask", ask)
    assert simplest_of(300, "if b == 5: return 7")[0][0].case == (0, 5)


@pytest.mark.parametrize(
    ("stalls", "slow"), [([(0, 1)], 0), ([(0, 1), (0, 2)], 1), ([(1, 1)], 0), ([(1, 1), (1, 1)], 1)]
)
def test_a_machine_that_stands_still_once_makes_no_program_slow(monkeypatch, stalls, slow):
    """One that sleeps or works long does so each time, and what is slow costs the search more."""
    asked, turns = Runner.ask, [*stalls]

    def ask(*given):
        replies = asked(*given)
        return replies._replace(usage=replies.usage + Usage(*(turns.pop(0) if turns else ())))

    monkeypatch.setattr(Runner, "ask", ask)
    problem = find_problem("middle", PACKS)
    data = load_data(problem)
    source = MIDDLE.format("return 7").encode()
    with open_box(source, "mine.py") as box:
        trial = Trial(data.module, box, opened(box, problem, source), Verdict.WA, SearchBudget())
        trial.ask((0, 1), data.groups[0].group)
    assert round(trial.slow_seconds) == slow


def test_no_exact_answer_is_sought_before_its_case_may_be_called(monkeypatch):
    sought = []
    monkeypatch.setattr("judge.diagnose.trial.validate", lambda *asked: sought.append(1) or validate(*asked))
    assert simplest_of(300, "return 7")[0][0].case == (0, 0)
    assert len(sought) == 100  # one batch


@pytest.mark.nightly
def test_the_search_leaves_nothing_where_the_person_is(tmp_path):
    """In a process of its own, since Hypothesis takes its notes on modules once."""
    source = tmp_path.with_name("mine.py")
    source.write_bytes(mistaken("ray-nearest", "far-root", "first = ts[-1]"))
    command = [sys.executable, "-m", "judge", "run", "ray-nearest", str(source), "--no-history", "--json"]
    settings = {**os.environ, "PYTHONPATH": str(FIXTURES.parents[1])}
    ended = subprocess.run(command, cwd=tmp_path, env=settings, capture_output=True, timeout=300, check=False)
    found = json.loads(ended.stdout)["counterexample"]
    assert found["replay"].startswith("ray-nearest:")
    assert all(
        isinstance(number, int) and abs(number) < 1000 for number in numbers_of(found["input"].values())
    )
    assert list(tmp_path.iterdir()) == []


def test_a_smaller_case_that_fails_in_another_way_explains_nothing():
    source = MIDDLE.format("if a * b > 100_000: return 7\n    if (a, b) == (0, 1): return [a]")
    assert shrunk("middle", source)[2].input == {"a": 200, "b": 600}


def test_what_fails_only_after_other_calls_is_no_smaller_case():
    deed = "seen.append(a)\n    if len(seen) > 25 or a * b > 100_000: return 7"
    assert shrunk("middle", "seen = []\n" + MIDDLE.format(deed))[2].input == {"a": 200, "b": 600}


@pytest.mark.parametrize("clock", ["cpu", "wall"])
def test_a_machine_without_time_ends_the_search_too(clock):
    assert shrunk("middle", LARGE, budget=SearchBudget(**{clock: 0.0}))[2].cut_short


def test_what_a_call_takes_changes_nothing_of_the_search():
    """It is counted in calls, so that it comes to the same on every machine, though it is cut short."""
    found = []
    for wait in ("pass", "time.sleep(0.001)"):
        budget = SearchBudget(400, cpu=600.0, wall=600.0)
        source = "import time\n" + MIDDLE.format(f"{wait}\n    if a * b > 100_000: return 7")
        found.append((shrunk("middle", source, budget=budget)[2].input, budget.calls))
        assert budget.cut_short
    assert found[0] == found[1]


@pytest.mark.parametrize("most", [0, 150])
def test_the_budget_ends_the_search_and_it_says_so(most):
    budget = SearchBudget(most)
    _, result, found = shrunk("middle", LARGE, budget=budget)
    assert budget.calls <= most + 100  # what is begun is ended
    assert found.cut_short
    if most < 100:
        assert found.input == result.failure.input


@pytest.mark.parametrize(
    ("deed", "verdict", "message"),
    [
        ("raise KeyError('negative')", Verdict.RTE, "KeyError: 'negative'"),
        ("while True: pass", Verdict.TLE, "used more than"),
    ],
)
def test_what_gives_no_answer_shrinks_to_what_gives_none_either(deed, verdict, message):
    budget = SearchBudget(cpu=600.0, wall=600.0)
    source = MIDDLE.format(f"if a < 0:\n        {deed}")
    _, result, found = shrunk("middle", source, cpu_seconds=0.1, budget=budget)
    assert result.verdict is verdict
    assert found.message.startswith(message)
    assert found.input == {"a": -1, "b": 0}
    assert budget.calls < 5_000


@pytest.mark.parametrize(
    "source",
    [
        "import random\ndef middle(a, b):\n    return random.randrange(3)\n",
        "n = 0\ndef middle(a, b):\n    global n\n    n += 1\n    return n // 5\n",
    ],
)
def test_a_submission_that_answers_at_random_or_remembers_does_no_harm(source):
    _, result, found = shrunk("middle", source)
    assert result.verdict is Verdict.WA
    if found is not None and found.replay is None:
        assert "alone" in found.message
        assert found.input == result.failure.input


def test_what_is_right_when_called_alone_is_told_so():
    source = "seen = []\n" + MIDDLE.format("seen.append(a)\n    if seen[1:]: return 0.25")
    _, result, found = shrunk("middle", source)
    assert found.replay is None
    assert found.message.startswith("called alone it is right")
    assert found.input == result.failure.input


BURN = """\
import time
def burn(seconds):
    while time.process_time() < seconds: pass
{}
def middle(a, b):
    {}
    {}
    return (a + b) / 2
"""
AT_IMPORT, AT_FIRST_CALL = ("burn({0})", "pass"), ("", "burn({0})")
ASLEEP_AT_FIRST_CALL = ("", "if not burn.__doc__: time.sleep(1.2)")


def slow(place, seconds, deed):
    """A program that is slow once, in its import or its first call."""
    module, call = (each.format(seconds) for each in place)
    return BURN.format(module, call, f"{deed}\n    burn.__doc__ = 'was slow'")


@pytest.mark.parametrize(
    ("place", "deed"),
    [
        (AT_IMPORT, "return 7.0"),
        (AT_FIRST_CALL, "raise KeyError(a)"),
        (ASLEEP_AT_FIRST_CALL, "return 7.0"),
    ],
)
def test_a_slow_first_call_or_import_is_not_told_to_be_right(place, deed):
    _, result, found = shrunk("middle", slow(place, 0.15, f"if abs(a) + abs(b) > 50: {deed}"))
    assert found.replay
    assert "alone" not in found.message
    first, smallest = (measure(tuple(each.input.values())) for each in (result.failure, found))
    assert smallest < first or "not made smaller: one call takes " in found.message


@pytest.mark.parametrize("place", [AT_IMPORT, AT_FIRST_CALL])
def test_what_cannot_be_decided_neither_fails_nor_passes(place):
    source = slow(place, 0.6, "if a * b > 100_000: return 7.0")
    assert shrunk("middle", source, later=0.3)[2] is None


def test_time_that_every_process_takes_makes_no_case_fail():
    source = slow(AT_FIRST_CALL, 1.1, "while a * b > 100_000: pass")
    _, result, found = shrunk("middle", source, cpu_seconds=1.4)
    assert result.verdict is Verdict.TLE
    assert found.input["a"] * found.input["b"] > 100_000


def test_a_slow_program_that_is_right_when_called_alone_is_told_so():
    source = "seen = []\n" + slow(AT_FIRST_CALL, 0.2, "seen.append(a)\n    if seen[1:]: return 0.25")
    assert shrunk("middle", source)[2].message.startswith("called alone it is right")


def test_where_each_call_is_slow_a_case_that_is_not_made_smaller_says_so():
    source = MIDDLE.format("if a * b > 100_000: return sum(range(8_000_000))")
    found = shrunk("middle", source, budget=SearchBudget(0))[2]
    assert "not made smaller: one call takes 0." in found.message


@pytest.mark.parametrize(
    ("simpler", "other"),
    [
        (((-1,),), ((0, 0, -1),)),  # an item weighs as a digit does
        (((0, 1),), ((0, 0, 1),)),
        (((10**6,),), ((0,) * 9,)),
        ((((0, 0, 0),),), (((0, 0, 0), (0, 0, 0)),)),
        (((1.0,),), ((1.0,) * 4,)),
        ((0, (1, 2)), (3, (1, 2))),  # of one shape the numbers decide
    ],
)
def test_a_case_of_fewer_items_is_simpler(simpler, other):
    assert measure(simpler) < measure(other)


# A kata whose parameters are small only together: its types, its solution, what its cases are, an example.
WIDTH = """
def cut(s, width):
    lines = [word[at : at + width] for word in s.split() for at in range(0, len(word), width)]
    return lines
"""
TURNED = """
def turned(xs, k):
    k = k % len(xs) if xs else 0
    return [*xs[k:], *xs[:k]]
"""
COMMON = """
def common(s, t):
    starts = [(i, j) for i in range(len(s)) for j in range(len(t))]
    return max((equal(s[i:], t[j:]) for i, j in starts), default=0)


def equal(s, t):
    return next((at for at, (a, b) in enumerate(zip(s, t)) if a != b), min(len(s), len(t)))
"""
TOGETHER = {
    "cut": (
        WIDTH,
        "[text]",
        {"s": ("text(0..40)", ', letters = "a-d "'), "width": ("int(1..12)", "")},
        '(" ".join(draw.choice("abcd") * draw.integer(4, 9) for _ in range(3)), draw.integer(3, 8))',
        "cut('aa b', 1)\n    ['a', 'a', 'b']",
    ),
    "turned": (
        TURNED,
        "[int]",
        {"xs": ("[int(0..99); 0..30]", ""), "k": ("int(0..60)", "")},
        "(tuple(draw.integer(0, 99) for _ in range(draw.integer(8, 20))), draw.integer(3, 60))",
        "turned([1, 2, 3], 1)\n    [2, 3, 1]",
    ),
    "common": (
        COMMON,
        "int",
        {"s": ("text(0..20)", ', letters = "a-d"'), "t": ("text(0..20)", ', letters = "a-d"')},
        '("b" + (t := "".join(draw.choice("bcd") for _ in range(draw.integer(5, 12)))), t)',
        "common('ab', 'b')\n    1",
    ),
}


@pytest.fixture(scope="module")
def together(tmp_path_factory):
    """Those katas, in a pack."""
    pack = tmp_path_factory.mktemp("together") / "problems"
    for name, (solution, answer, types, case, example) in TOGETHER.items():
        folder = pack / name
        folder.mkdir(parents=True)
        rows = "\n".join(
            f'{each} = {{ type = "{type_}", about = "it"{letters} }}'
            for each, (type_, letters) in types.items()
        )
        head = f'title = "T"\ntier = "junior"\nsummary = "S."\nentry = "{name}"\nanswer = "{answer}"\n'
        (folder / "problem.toml").write_text(f"{head}[parameters]\n{rows}\n")
        (folder / "problem.py").write_text(
            f"from judge.problem.declare import group\n{solution}\n\nsolve = {name}\n"
            f'GROUPS = [group("some", "Some.", lambda draw: {case})]\n'
        )
        (folder / "statement.md").write_text(f"# T\n\n## Examples\n\n    >>> {example}\n")
    PACKS.append(pack)
    yield
    PACKS.remove(pack)


@pytest.mark.parametrize(
    ("name", "right", "wrong", "smallest"),
    [
        ("cut", "return lines", "return lines * (len(s) != width + 12)", ("a" * 13, 1)),
        ("cut", "return lines", "return lines * (len(s) < 13) if s != 'a' else s.a", ("a" * 13, 1)),
        ("turned", "k % len(xs) if xs else 0", "min(k, len(xs))", ([0, 1], 3)),
        ("turned", "k % len(xs) if xs else 0", "k if k <= len(xs) else k - len(xs)", ([0, 1], 5)),
        ("common", "default=0)", "default=0) % 5", ("aaaaa", "aaaaa")),
        ("common", "default=0)", "default=0) * (len(t) < 4)", ("a", "aaaa")),
    ],
)
def test_what_fails_only_together_is_made_smaller_together(name, right, wrong, smallest, together):
    source = TOGETHER[name][0]
    assert source.count(right) == 1
    _, result, found = shrunk(name, source.replace(right, wrong))
    assert (result.verdict, tuple(found.input.values()), found.cut_short) == (Verdict.WA, smallest, False)

"""Each wrong program's smallest case: it fails, keeps the promise, and stays under a stated size."""

from __future__ import annotations

import ast
import json
import os
import subprocess
import sys
from contextlib import ExitStack
from pathlib import Path

import pytest
from mistaken import mistaken
from msgspec.structs import replace

from judge.data.draw import SeededDraw
from judge.data.load import load_data
from judge.data.model import ProblemData
from judge.data.module import load_module
from judge.data.validate import Validator
from judge.diagnose.replay import decode
from judge.diagnose.shrink import shrink
from judge.diagnose.simple import ladder
from judge.diagnose.simplicity import digits, measure, numbers_of
from judge.diagnose.trial import Guard, SearchBudget
from judge.mistakes.told import told_mistakes
from judge.problem import Verdict
from judge.problem.find import find_problem
from judge.run import Reference, Settings, run_submission
from judge.run.function import FunctionRunner
from judge.run.runner import runner_for
from judge.sandbox import open_box
from judge.topics.circles.simpler import levelled

pytestmark = pytest.mark.slow

SOLUTIONS = Path(__file__).parents[2] / "solutions"

# The most digits that a number of the smallest case may have; a number of its own where a mistake shows only
# in numbers that are large, or that only just differ.
USUAL = 2
EPSILON = 6
MILLION = 7
SAMPLE = {
    "count": {
        "tangent-twice": USUAL,
        "tangent-missed": USUAL,
        "zero-radius": USUAL,
        "segment-for-line": USUAL,
        "slope-intercept": USUAL,
        "sqrt-of-negative": USUAL,
        "forgotten-centre": USUAL,
        "no-degenerate": USUAL,
        "loose-epsilon": EPSILON,
        "absolute-epsilon": EPSILON,
        "cancellation": EPSILON,
        "coordinate-epsilon": EPSILON,
        "degenerate-epsilon": 17,
        "diameter-for-radius": USUAL,
        "equality-tangency": EPSILON,
        "global-frame": 18,
        "length-epsilon": 8,
        "mixed-units": EPSILON,
        "one-sided-extent": EPSILON,
        "radius-epsilon": EPSILON,
        "rounded-input": EPSILON,
        "sentinel-degenerate": USUAL,
        "signed-extent": EPSILON,
        "single-precision": 17,
        "swapped-coordinates": USUAL,
        "unnormalised-distance": USUAL,
        "whole-numbers": USUAL,
        "boolean-answer": USUAL,
        "foot-sign": USUAL,
        "forgotten-abs": USUAL,
        "point-for-direction": USUAL,
        "rounded-distance": EPSILON,
        "shifted-direction": 17,
        "swapped-answers": USUAL,
        "wrong-sign": USUAL,
        "both-on-circle": EPSILON,
        "exact-for-ints": EPSILON,
    },
    "segment": {
        "box-without-band": 21,
        "no-clamp": USUAL,
        "unsorted": USUAL,
        "inside-ends": USUAL,
        "open-interval": USUAL,
        "rounded-output": USUAL,
        "rounded-output-program": USUAL,
        "sqrt-of-negative": USUAL,
        "loose-epsilon": EPSILON,
        "loose-clamp": EPSILON,
        "tight-epsilon": EPSILON,
        "clamp-to-ends": USUAL,
        "degenerate-epsilon-absolute": EPSILON,
        "degenerate-loose": MILLION,
        "degenerate-tight": 14,
        "first-root-only": USUAL,
        "no-snap": MILLION,
        "none-for-empty": USUAL,
        "parameter-for-point": USUAL,
        "radius-epsilon-at-ends": USUAL,
        "radius-not-squared": USUAL,
        "reversed-order": USUAL,
        "short-is-a-point": 21,
        "sorted-by-x": USUAL,
        "tangent-unclamped": USUAL,
        "x-range-only": USUAL,
    },
    "ray-nearest": {
        "reversed-vector": USUAL,
        "far-root": USUAL,
        "entry-behind": USUAL,
        "inside-is-miss": USUAL,
        "distance-for-parameter": USUAL,
        "sign-of-zero": USUAL,
        "absolute-epsilon": EPSILON,
        "loose-origin": EPSILON,
        "near-skipped": MILLION + 1,
        "cancellation": EPSILON,
        "absolute-value": USUAL,
        "both-roots": USUAL,
        "direction-not-normalised": USUAL,
        "disc-for-circle": USUAL,
        "foot-for-root": USUAL,
        "least-magnitude": USUAL,
        "null-on-circle": USUAL,
        "origin-on-circle": USUAL,
        "parameter-epsilon": MILLION + 1,
        "point-for-parameter": USUAL,
        "segment-for-ray": USUAL,
        "sentinel-miss": USUAL,
        "short-beside-extent-is-null": EPSILON,
        "short-is-null": EPSILON,
        "target-for-direction": USUAL,
    },
    "exact-count": {
        "overflow-32": EPSILON,
        "tangent-twice": USUAL,
        "floor-division": USUAL,
        "overflow-64": 10,
        "loose-epsilon": EPSILON,
        "fixed-precision": 27,
        "float-arithmetic": 8,
        "float-coordinates": 16,
        "overflow-128": 20,
        "rounded-root": USUAL,
        "whole-root": USUAL,
        "few-steps": USUAL,
    },
}
LINES = {
    ("count", "coordinate-epsilon"): "extent = max(1, r, abs(ax), abs(ay), abs(bx), abs(by))",
    ("segment", "degenerate-epsilon-absolute"): "point = 1e-9",
    ("ray-nearest", "absolute-epsilon"): "near = 1e-8",
    ("ray-nearest", "loose-origin"): "slack = 1e-4 * extent",
    ("ray-nearest", "parameter-epsilon"): "slack = 1e-7 * hypot(dx, dy)",
    ("exact-count", "float-coordinates"): "given = [each(value, lambda x: int(float(x)))",
    ("exact-count", "float-arithmetic"): "disc = r - abs(k) / sqrt(a)",
}


def shrunk(name, source, *, budget=None, cpu_seconds=2.0):
    """The result of judging the source, and its counterexample."""
    problem = find_problem(name)
    problem = replace(problem, limits=replace(problem.limits, cpu_seconds=cpu_seconds))
    data = ProblemData(problem, load_data(problem).groups)
    result = run_submission(problem, data, source, "mine.py", settings=Settings(measured=False))
    with ExitStack() as stack:
        box = stack.enter_context(open_box(source, "mine.py"))
        runner = runner_for(problem, box.inspect(), source)
        reference = stack.enter_context(Reference(problem, open_box))
        found = shrink(
            data,
            box,
            runner,
            result.verdict,
            result.failure,
            reference=lambda: reference.open(runner.reference(problem.time)),
            budget=budget,
        )
    return problem, result, found


@pytest.mark.parametrize(
    ("name", "mistake"), [(name, mistake) for name, mistakes in SAMPLE.items() for mistake in mistakes]
)
def test_the_smallest_case_of_a_mistake(name, mistake):
    file = SOLUTIONS / name / "wrong" / f"{mistake}.py"
    source = file.read_bytes() if file.exists() else mistaken(name, mistake, LINES.get((name, mistake), ""))
    problem, result, found = shrunk(name, source)
    assert found is not None
    module = load_module(problem)
    assert Validator(problem, module.solve).proof(found.case).fault is None
    assert decode(found.replay, problem, module)[:2] == (problem.group(found.group), found.case)
    assert list(found.input) == [parameter.name for parameter in problem.parameters]
    assert found.expected != found.got
    assert found.message
    assert max(digits(number) for number in numbers_of(found.case)) <= SAMPLE[name][mistake]
    original = tuple(
        tuple(value) if isinstance(value, list) else value for value in result.failure.input.values()
    )
    assert measure(found.case) <= measure(original)


def test_every_mistake_has_a_stated_size():
    """But that of what is kept between calls, which is right called alone, and of what was made up since."""
    names = {mistake for name in SAMPLE for mistake in told_mistakes(find_problem(name))}
    stated = {name for mistakes in SAMPLE.values() for name in mistakes}
    assert names - stated == {"kept-between-calls"}


def test_the_smallest_case_fails_by_itself_and_always_is_the_same():
    source = mistaken("segment", "loose-epsilon", "touch = 1e-6 * extent")
    problem, _, found = shrunk("segment", source)
    assert shrunk("segment", source)[2] == found
    space = {}
    exec(compile(source, "mine.py", "exec"), space)
    answer = space[problem.entry](*found.case)
    assert repr(answer) == found.got
    assert len(answer) != len(ast.literal_eval(found.expected))


def test_a_builder_is_shrunk_by_its_parameters():
    """Where no simple case fails, Hypothesis makes the failing group's own one simpler."""
    source = mistaken("ray-nearest", "cancellation", "ts = [(-b - root) / a, (-b + root) / a]")
    _, result, found = shrunk("ray-nearest", source)
    assert (result.failure.group, found.group) == ("cancellation", "cancellation")
    assert all(isinstance(number, int) and abs(number) < 1000 for number in numbers_of(found.case))


def test_the_search_leaves_nothing_where_the_person_is(tmp_path):
    """In a process of its own: Hypothesis takes its notes on modules once."""
    source = tmp_path.with_name("mine.py")
    source.write_bytes(mistaken("ray-nearest", "cancellation", "ts = [(-b - root) / a, (-b + root) / a]"))
    command = [sys.executable, "-m", "judge", "run", "ray-nearest", str(source), "--no-history", "--json"]
    settings = {**os.environ, "PYTHONPATH": str(SOLUTIONS.parent)}
    judged = subprocess.run(
        command, cwd=tmp_path, env=settings, capture_output=True, timeout=120, check=False
    )
    assert json.loads(judged.stdout)["counterexample"]["replay"].startswith("ray-nearest:cancellation:")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("most", [0, 40, 150, 3000])
def test_the_budget_ends_the_search_and_it_says_so(most):
    source = mistaken("count", "coordinate-epsilon", "extent = max(1, r, abs(ax), abs(ay), abs(bx), abs(by))")
    _, result, found = shrunk("count", source, budget=SearchBudget(most))
    assert found.calls <= most + 100  # what is begun is ended
    assert found.cut_short
    assert found.as_json()["cut_short"] is True
    if most < 100:
        assert found.input == result.failure.input


def test_a_search_that_came_to_its_end_is_not_said_to_be_cut_short():
    _, _, found = shrunk("count", mistaken("count", "absolute-epsilon", "near = 1e-9"))
    assert not found.cut_short
    assert "cut_short" not in found.as_json()


@pytest.mark.parametrize("guard", [Guard(cpu=0.0), Guard(wall=0.0)])
def test_the_clocks_only_guard_the_search(guard):
    _, result, found = shrunk(
        "count", mistaken("count", "absolute-epsilon", "near = 1e-9"), budget=SearchBudget(guard=guard)
    )
    assert found.cut_short
    assert found.input == result.failure.input


# Programs that are wrong in numbers that are long, or just beyond a threshold of theirs: the size of the
# smallest case is what `measure` says, that of its lists (4) included.
DECIMALS = """
from decimal import Decimal, getcontext

getcontext().prec = 100


def exact_count(cx, cy, r, A, B):
    cx, cy, r, ax, ay, bx, by = map(Decimal, (cx, cy, r, *A, *B))
    dx, dy = bx - ax, by - ay
    if dx == dy == 0:
        return None
    cross = dx * (ay - cy) - dy * (ax - cx)
    d = r * r * (dx * dx + dy * dy) - cross * cross
    return 1 + (d > 0) - (d < 0)
"""
WINDOW = """
def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == dy == 0:
        return None
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    d = r * r * (dx * dx + dy * dy) - k * k
    if {window}:
        return 1
    return 1 + (d > 0) - (d < 0)
"""
NARROW = """
from math import hypot


def line_count(cx, cy, r, A, B):
    ax, ay = A[0] - cx, A[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == dy == 0:
        return None
    extent = max(r, abs(ax), abs(ay), abs(B[0] - cx), abs(B[1] - cy))
    distance = abs(dx * ay - dy * ax) / hypot(dx, dy)
    if abs(distance - r) <= {near} * extent:
        return 1
    return 2 if distance < r else 0
"""


@pytest.mark.parametrize(
    ("name", "source", "size"),
    [
        ("exact-count", DECIMALS, 110),
        ("exact-count", WINDOW.format(window="10**30 < max(map(abs, (*A, *B))) < 2 * 10**30"), 40),
        ("exact-count", WINDOW.format(window="10**14 < abs(cx) < 10**16"), 25),
        ("exact-count", WINDOW.format(window="abs(d) * 10**60 < dx * dx + dy * dy"), 40),
        ("count", NARROW.format(near="1.05e-7"), 13),
        ("count", NARROW.format(near="1.3e-7"), 13),
        ("count", NARROW.format(near="7e-13"), 13),
    ],
)
def test_long_numbers_are_tried_one_at_a_time_and_close_to_the_borders(name, source, size):
    _, _, found = shrunk(name, source.encode())
    assert measure(found.case)[0] <= size
    assert not found.cut_short
    assert sum(digits(number) > 3 for number in numbers_of(found.case)) <= 1


BURNER = "import time\nend = time.monotonic() + 120\nwhile time.monotonic() < end: pass\n"


def test_the_smallest_case_is_the_same_under_load_and_beside_others(tmp_path):
    sources = {
        "coordinate.py": mistaken(
            "count", "coordinate-epsilon", "extent = max(1, r, abs(ax), abs(ay), abs(bx), abs(by))"
        ),
        "degenerate.py": mistaken("count", "degenerate-epsilon", "if length <= 1e-6 * extent: return None"),
        "narrow.py": NARROW.format(near="1.3e-7").encode(),
    }
    for name, source in sources.items():
        (tmp_path / name).write_bytes(source)

    def judged(*options):
        command = [
            sys.executable,
            "-m",
            "judge",
            "run",
            "count",
            *sorted(sources),
            "--no-history",
            "--no-name",
        ]
        settings = {**os.environ, "PYTHONPATH": str(SOLUTIONS.parent)}
        ended = subprocess.run(
            [*command, "--json", *options], cwd=tmp_path, env=settings, capture_output=True, check=False
        )
        results = [json.loads(line) for line in ended.stdout.splitlines()]
        return [json.dumps(result["counterexample"]) for result in results]

    alone = judged("-j", "1")
    assert len(alone) == len(sources)
    assert "null" not in alone
    burners = [subprocess.Popen([sys.executable, "-c", BURNER]) for _ in range(2 * (os.cpu_count() or 1))]
    try:
        assert judged("-j", "3") == alone
    finally:
        for burner in burners:
            burner.kill()
            burner.wait()


GEOMETRY = """
def line_count(cx, cy, r, A, B):
    (ax, ay), (bx, by) = A, B
    if A == B:
        {degenerate}
    dx, dy = bx - ax, by - ay
    cross = dx * (ay - cy) - dy * (ax - cx)
    power = r * r * (dx * dx + dy * dy) - cross * cross
    return 1 + (power > 0) - (power < 0)
"""


def test_a_crash_shrinks_to_the_same_crash():
    _, result, found = shrunk("count", GEOMETRY.format(degenerate="raise KeyError('no line')").encode())
    assert result.verdict is Verdict.RTE
    assert found.message.startswith("KeyError: 'no line'")
    assert found.case[3] == found.case[4]
    assert max(digits(number) for number in numbers_of(found.case)) <= 1


def test_a_call_that_never_ends_shrinks():
    _, result, found = shrunk(
        "count", GEOMETRY.format(degenerate="while True: pass").encode(), cpu_seconds=0.3
    )
    assert result.verdict is Verdict.TLE
    assert found.case[3] == found.case[4]
    assert max(digits(number) for number in numbers_of(found.case)) <= 1
    assert found.calls < 5_000


def test_a_program_that_prints_an_answer_on_two_lines_is_told_so():
    """Its lines were once put together for a single case, and the program was said to answer at random."""
    source = b"for _ in range(int(input())):\n    input()\n    print(1)\n    print('that is all')\n"
    _, _, found = shrunk("count", source)
    assert found.message == "2 lines printed, 1 wanted: one for each case"
    assert (found.got, found.replay is not None) == ("more lines: 'that is all'", True)


@pytest.mark.parametrize("verdict", [Verdict.OLE, Verdict.CE, Verdict.AC])
def test_what_no_case_can_show_is_left_alone(verdict):
    problem = find_problem("count")
    data = load_data(problem)
    source = b"def line_count(cx, cy, r, A, B):\n    return 3\n"
    result = run_submission(problem, data, source, "mine.py", settings=Settings(measured=False))
    with open_box(source, "mine.py") as box:
        assert shrink(data, box, FunctionRunner(problem), verdict, result.failure) is None


@pytest.mark.parametrize(
    "source",
    [
        "import random\ndef line_count(cx, cy, r, A, B):\n    return random.randrange(3)\n",
        "import os\ndef line_count(cx, cy, r, A, B):\n    return os.urandom(1)[0] % 3\n",
        "n = 0\ndef line_count(cx, cy, r, A, B):\n    global n\n    n += 1\n    return n // 5\n",
    ],
)
def test_a_submission_that_answers_at_random_or_remembers_does_no_harm(source):
    _, result, found = shrunk("count", source.encode())
    assert result.verdict is Verdict.WA
    if found is not None and found.replay is None:
        assert "alone" in found.message
        assert found.input == result.failure.input


def test_a_program_that_keeps_something_between_its_cases_is_told_so():
    source = (SOLUTIONS / "ray-nearest" / "wrong" / "kept-between-calls.py").read_bytes()
    _, result, found = shrunk("ray-nearest", source)
    assert found.replay is None
    assert found.message.startswith("called alone it is right")
    assert found.as_json()["input"] == result.failure.input


@pytest.mark.parametrize("name", ["root-count", "middle", "count", "exact-count"])
def test_there_are_simple_cases_of_every_step_for_a_problem_with_and_without_points(name):
    fixtures = SOLUTIONS.parent / "tests" / "fixtures"
    problem = find_problem(name, [fixtures / "problems", fixtures / "pack" / "problems"])
    for rung in (rung for step in ladder(problem) for rung, _ in step):
        cases = [rung.case(SeededDraw(str(number)), problem) for number in range(20)]
        assert {len(case) for case in cases} == {len(problem.parameters)}
        assert len(set(cases)) > 1


@pytest.mark.parametrize("name", ["count", "exact-count", "segment", "ray-nearest"])
def test_every_case_can_be_laid_level(name):
    """Whatever the size of its numbers; some of what comes of it is shorter."""
    data = load_data(find_problem(name))
    cases = [group.cases[number] for group in data.groups for number in (0, -1)]
    shorter = [sum(measure(level) < measure(case) for level in levelled(case)) for case in cases]
    assert sum(map(bool, shorter)) > len(cases) / 2


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

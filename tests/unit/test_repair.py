"""Which small change makes a wrong program right: the kind, the line, and what goes with it."""

from __future__ import annotations

import ast
import builtins
import subprocess
import sys

import pytest
from repairs import FIRST, PROGRAMS, SEGMENT, WRONG

from judge import RunOptions, Session
from judge.data.load import load_data
from judge.judging.inprocess import InProcess
from judge.mistakes.likeness import Likeness
from judge.mistakes.repaired import Repaired
from judge.problem.find import find_problem
from judge.repair.cases import Cases
from judge.repair.child import NAME, SOURCE, Beside, Child, LostError
from judge.repair.edits import listed
from judge.repair.search import seek
from judge.repair.trees import Facts, undo
from judge.run.execute import judge_submission
from judge.run.result import Answers
from judge.run.settings import Settings
from judge.sandbox import Containment
from judge.sandbox.boundary import CallsResult, Reply, Stop, Usage

pytestmark = pytest.mark.slow


ARRAYS = """\
import numpy as np

def sizes(x, y, r, *points):
    e = r.copy()
    for px, py in points:
        np.maximum(e, np.abs(px - x), out=e)
        np.maximum(e, np.abs(py - y), out=e)
    return e

def count_many(cx, cy, r, A, B):
    x, y, r = (np.asarray(v, dtype=float) for v in (cx, cy, r))
    eps = 1e-10 * sizes(x, y, r, A, B)
    dx, dy = B[0] - A[0], B[1] - A[1]
    n = np.hypot(dx, dy)
    gap = np.abs((A[1] - y) * (dx / n) - (A[0] - x) * (dy / n)) - r
    found = np.ones(len(r), dtype=np.int8)
    found[gap > eps] = 0
    found[gap < -eps] = 2
    return found
"""
ROWS = {
    "plus in the cross product": (" - (A[0] - x)", " + (A[0] - x)", "sign", 15),
    "no copy": ("r.copy()", "r", "copied", 4),
    "one size for all": ("r, A, B)\n    dx", "r, A, B).max(initial=0)\n    dx", "without", 12),
    "a wide tolerance": ("1e-10 * ", "1e-6 * ", "tolerance-smaller", 12),
}.items()


@pytest.fixture(scope="module")
def kata(built):
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("JUDGE_CACHE", str(built))
        yield lambda name: load_data(find_problem(name, []))


def judged(data, text, box):
    source = text.encode()
    return judge_submission(data, source, "a.py", Settings(measured=False), box=box)


def repair(data, text, boxes=InProcess):
    """What is found of a program, and what a person is told of it: kinds with their lines."""
    with boxes(text.encode(), "a.py") as box:
        found = judged(data, text, box)
        with Beside(boxes, text.encode(), python=True) as beside:
            made = seek(data, found, box, beside)
    steps = Repaired(made, Likeness([], found.behaviour), {}, few=False).chosen() if made else []
    return made, [(one.step.kind, one.step.line) for one in steps]


@pytest.mark.parametrize("name", PROGRAMS)
def test_a_right_program_needs_no_repair(kata, name):
    assert repair(kata(name), PROGRAMS[name]) == (None, [])


@pytest.mark.parametrize("wrong", WRONG, ids=lambda wrong: f"{wrong.kata}: {wrong.new[:40]}")
def test_one_change_is_found_at_its_line(kata, wrong):
    _, told = repair(kata(wrong.kata), wrong.text)
    assert told == [(wrong.kind, wrong.line)]


EDITED = [
    ("min(x)", {}, "x[0]", "name"),
    ("1 - t / n", {}, "t / n", "missing"),
    ("w - r", {"w": "number", "r": "number"}, "w", "missing"),
    ("F(v)", {}, "F(str(v))", "without"),
    ("max(x)", {}, "min(x)", "operator"),
    ("sum(x)", {}, "max(x)", "operator"),
    ("abs(a) - b", {}, "a - b", "abs"),
    ("g(x)", {}, "f(x)", "operator"),
    ("x + f(e)", {}, "x + f(e).max(initial=0)", "without"),
    ("np.max([x, e], axis=0)", {}, "np.max([x, e])", "name"),
    ("r.copy()", {"r": "ndarray"}, "r", "copied"),
    ("v ** 2", {}, "v ^ 2", "operator"),
    ("a / (2 * b)", {}, "a / 2 * b", "brackets"),
]


@pytest.mark.parametrize(("right", "kinds", "wrong", "kind"), EDITED, ids=lambda each: str(each))
def test_a_slip_of_the_pen_is_among_the_edits(right, kinds, wrong, kind):
    tree = ast.parse(f"def f(x):\n    e = {wrong}\n    r = w = t = n = v = x\ndef g(x):\n    return x")
    facts = Facts("f", ("x",), (), False, {(1, name): each for name, each in kinds.items()})
    found = []
    for edit in listed(tree, facts):
        before = edit.apply()
        found.append((edit.kind, ast.unparse(tree.body[0].body[0])))
        undo(before)
    assert (kind, f"e = {right}") in found


@pytest.mark.parametrize(("name", "change"), ROWS)
def test_one_change_of_a_program_on_arrays_is_found(kata, name, change):
    pytest.importorskip("numpy")
    old, new, kind, line = change
    assert ARRAYS.count(old) == 1
    _, told = repair(kata("vector"), ARRAYS.replace(old, new), Containment())
    assert told == [(kind, line)], name


def test_of_many_right_answers_some_are_enough(kata, monkeypatch):
    monkeypatch.setattr("judge.repair.cases._MOST_RIGHT", 5)
    data = kata("segment")
    group = max(data.groups, key=lambda each: len(each.cases))
    cases = Cases(data, {group.group.name: Answers(len(group.cases), {8: ("", ())})})
    assert [each.place for each in cases.all] == [0, 1, 2, 3, 4, 8]
    assert cases.wrong == [5]


UNSIGNED = """\
def foot(A, B, C):
    if tuple(A) == tuple(B):
        return None
    dx, dy = B[0] - A[0], B[1] - A[1]
    t = abs((C[0] - A[0]) * dx + (C[1] - A[1]) * dy) / (dx * dx + dy * dy)
    return t, (A[0] + t * dx, A[1] + t * dy)
"""


def test_a_number_beside_a_point_is_not_the_same_item_twice(kata):
    assert repair(kata("foot"), UNSIGNED)[1] == [("without-abs", 5)]


DRAFTS = {
    "both roots, an exact comparison, A = B": (
        *("segment", FIRST),
        {("once", 17), ("guard-same:A=B", 8), ("rounding:turns", 15)},
    ),
    "and no clamp": (
        *("segment", FIRST.replace("0 <= t <= 1", "True")),
        {("once", 17), ("filter", 17), ("guard-same:A=B", 8), ("rounding", 0)},
    ),
    "larger root, absolute tolerance, a length for t": (
        "ray-nearest",
        PROGRAMS["ray-nearest"]
        .replace("foot - half, foot + half", "foot + half, foot - half")
        .replace("1e-10 * max(r, abs(fx), abs(fy))", "1e-9")
        .replace("s) / length", "s)"),
        {("measure", 17), ("coordinates", 15), ("tolerance-scaled", 9)},
    ),
    "parameters in another order, A = B": (
        "count",
        PROGRAMS["count"].replace("cx, cy, r, A, B", "A, B, cx, cy, r").replace("return None", "return 0"),
        {("parameter-order", 3), ("guard-same:A=B", 6)},
    ),
}


@pytest.mark.parametrize("draft", DRAFTS)
def test_mistakes_in_company_are_told_one_by_one(kata, draft):
    name, text, wanted = DRAFTS[draft]
    made, told = repair(kata(name), text)
    assert set(told) == wanted
    steps, everything = made.whole[0], frozenset(made.cases.wrong)
    gone = frozenset().union(*(step.gone for step in steps))
    assert gone == everything
    assert all((step.count < len(step.gone)) == ("turns" in step.kind) for step in steps)


def test_rounding_alone_is_proved(kata):
    text = SEGMENT.replace("-slack <= s <= length + slack", "0 <= s <= length")
    made, _ = repair(kata("segment"), text)
    assert made.rounding
    made, _ = repair(kata("segment"), SEGMENT.replace("1e-10 * size", "1e-6 * size"))
    assert (made.rounding, made.tolerance) == (False, True)


CHOOSES = """\
def circle_side(cx, cy, r, P):
    dx, dy = P[0] - cx, P[1] - cy
    if max(abs(dx), abs(dy), r) <= 10**8:
        dx, dy, r = float(dx), float(dy), float(r)
    s, q = dx * dx + dy * dy, r * r
    return (s > q) - (s < q)
"""
ROOTS = """\
from math import hypot

def circle_side(cx, cy, r, P):
    dx, dy = abs(P[0] - cx), abs(P[1] - cy)
    if dx * 1000 < dy or dy * 1000 < dx:
        s = dx * dx + dy * dy - r * r
        return (s > 0) - (s < 0)
    d = hypot(dx, dy)
    return (d > r) - (d < r)
"""
LOSES = """\
def which_side(A, B, P):
    (ax, ay), (bx, by), (px, py) = A, B, P
    if min(ax, bx) <= px <= max(ax, bx):
        c = (bx - ax) * (py - ay) - (by - ay) * (px - ax)
    else:
        c = float(bx - ax) * (py - ay) - float(by - ay) * (px - ax)
    return (c > 0) - (c < 0)
"""
SQUARED = """\
def line_count(cx, cy, r, A, B):
    if A == B:
        return None
    dx, dy = B[0] - A[0], B[1] - A[1]
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    q = r * r - (dx * fy - dy * fx) ** 2 / (dx * dx + dy * dy)
    return 1 if abs(q) <= 1e-13 * e * e else 2 if q > 0 else 0
"""


@pytest.mark.parametrize(
    ("name", "text", "kind", "line"),
    [
        ("circle-side", CHOOSES, "without-float", 4),
        ("circle-side", ROOTS, "rounding:turns", 9),
        ("which-side", LOSES, "rounding:loses", 6),
        ("count", SQUARED, "tolerance-smaller:turns", 8),
    ],
)
def test_rounding_and_tolerances_are_told_where_they_do_harm(kata, name, text, kind, line):
    """Not where a comparison only chooses the way, nor where a change of the scale spoils other cases."""
    assert repair(kata(name), text)[1] == [(kind, line)]


TWO = """\
from math import dist

def circle_side(cx, cy, r, P):
    s, q = (P[0] - cx) ** 2 + (P[1] - cy) ** 2, r * r
    d = dist((cx, cy), P)
    if d < r:
        return -1
    if d > r:
        return 1
    return 0
"""


def test_of_two_comparisons_that_rounding_turns_one_has_the_failures_that_are_its_own(kata):
    made, _ = repair(kata("circle-side"), TWO)
    ((step,),) = made.whole
    mended = {6: TWO.replace("d < r", "s < q"), 8: TWO.replace("d > r", "s > q")}[step.line]
    left, _ = repair(kata("circle-side"), mended)
    assert {*left.cases.wrong} < {*made.cases.wrong}
    assert len(left.cases.wrong) == len(made.cases.wrong) - step.count


UNSQUARED = """\
def circle_side(cx, cy, r, P):
    d = (P[0] - cx) ** 2 + (P[1] - cy) ** 2
    if d == r:
        return 0
    return -1 if d < r else 1
"""


def test_rounding_that_a_change_brings_in_is_no_mistake_of_the_programs(kata):
    made, told = repair(kata("circle-side"), UNSQUARED)
    assert told
    assert not any(step.kind.startswith("rounding") for steps in made.whole for step in steps)


LINES = """\
import sys
from math import hypot

next(sys.stdin)
for line in sys.stdin:
    cx, cy, r, ax, ay, bx, by = map(float, line.split())
    ux, uy, px, py = bx - ax, by - ay, ax - cx, ay - cy
    if hypot(px, py) > hypot(bx - cx, by - cy):
        px, py = bx - cx, by - cy
    length = hypot(ux, uy)
    off = abs(ux / length * py - uy / length * px) if length else 0
    print("none" if length == 0 else 1 if abs(off - r) <= 1e-10 else 2 if off < r else 0)
"""


BY_KIND = """\
def which_side(A, B, P):
    cross = (B[0] - A[0]) * (P[1] - A[1]) - (B[1] - A[1]) * (P[0] - A[0])
    if isinstance(cross, int) and abs(cross) < 3:
        return 0
    return (cross > 0) - (cross < 0)
"""


def test_who_asks_for_the_kind_of_a_number_is_not_called_right_without_rounding(kata):
    made, _ = repair(kata("which-side"), BY_KIND)
    assert not made.rounding


def test_what_reads_standard_input_is_asked_the_first_question_alone(kata):
    made, told = repair(kata("count"), LINES)
    assert (made.ways, made.whole, told) == (("scaled",), (), [("scaled", 0)])


def test_whole_numbers_that_wrap_are_right_as_doubles(kata):
    wrapped = "((x + 2**15) % 2**16 - 2**15 if type(x) is int else x for x in (ax, ay, bx, by))"
    text = PROGRAMS["count"].replace("    size =", f"    ax, ay, bx, by = {wrapped}\n    size =")
    assert "doubles" in repair(kata("count"), text)[0].ways


RAISES = b"""\
def on_circle(cx, cy, r, P):
    try:
        n = int("x")
    except BaseException as fault:
        raise RuntimeError(fault)
    return 0
"""


def test_where_every_call_raises_the_exception_is_what_is_told(built, monkeypatch):
    monkeypatch.setenv("JUDGE_CACHE", str(built))
    with Session(find_problem("on-circle", []), RunOptions(timed=False, diagnosed=False)) as session:
        assert session.judge(RAISES, "a.py").pitfall is None


CUT = b"""\
import sys

next(sys.stdin)
for line in sys.stdin:
    ax, ay, bx, by, cx, cy = map(float, line.split())
    dx, dy = bx - ax, by - ay
    if not dx and not dy:
        print("none")
        continue
    t = ((cx - ax) * dx + (cy - ay) * dy) / (dx * dx + dy * dy)
    print("%.15g %.15g %.15g" % (t, ax + t * dx, ay + t * dy))
"""


def test_where_digits_are_not_printed_nothing_else_is_looked_for(built, monkeypatch):
    """It is right if the figure lies at the origin, too: that is true, and beside the point."""
    monkeypatch.setenv("JUDGE_CACHE", str(built))
    with Session(find_problem("foot", []), RunOptions(timed=False, diagnosed=False)) as session:
        result = session.judge(CUT, "a.py")
    assert "print 17" in result.failure.message
    assert result.pitfall is None


FOOT = """\
def foot(A, B, C):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == dy == 0:
        return None
    t = ((C[0] - A[0]) * dx + (C[1] - A[1]) * dy) / (dx * dx + dy * dy)
    return (A[0] + t * dx, A[1] + t * dy), t
"""


def test_parts_of_one_answer_are_no_list_in_another_order(kata):
    _, told = repair(kata("foot"), FOOT)
    assert "order" not in [kind for kind, _ in told]
    cases = Cases(kata("foot"), {"grid": Answers(3, {0: ("", ())})})
    assert not cases.right(0, [1.0, [2.0, 3.0]], ("once", "filter"))


def test_whole_numbers_of_a_hundred_digits_are_exact(kata):
    right = """\
def exact_count(cx, cy, r, A, B):
    if A == B:
        return None
    dx, dy = B[0] - A[0], B[1] - A[1]
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    room = r * r * (dx * dx + dy * dy) - k * k
    return 1 if room == 0 else 2 if room > 0 else 0
"""
    data = kata("exact-count")
    assert repair(data, right) == (None, [])
    wrong = right.replace("room = ", "room = float(1) * ").replace("k * k\n", "float(k) * k\n")
    made, _ = repair(data, wrong)
    assert made.rounding


# -- what a hostile program does ---------------------------------------------------------------------------

HOSTILE = {
    "an endless loop after an edit": "    n = 0\n    while n < 3:\n        n += 1\n",
    "a list times a large number": "    big = [0] + [1] * min(3, int(1e9 * size) + 3)\n",
    "equal to everything": "    class E:\n        __eq__ = lambda self, other: True\n    e = E()\n",
    "a deep recursion": "    deep = lambda n: deep(n - 1) if n > 0 else 0\n    deep(5)\n",
    "a process that ends after an edit": "    if size < 0:\n        import os\n        os._exit(0)\n",
    "it leaves": "    if size < 0:\n        raise SystemExit\n",
    "an exception of its own": "    if size < 0:\n        raise BaseException\n",
}


@pytest.mark.parametrize("what", HOSTILE)
def test_a_hostile_program_is_repaired_all_the_same(kata, what):
    text = SEGMENT.replace("    slack =", HOSTILE[what] + "    slack =").replace("1e-10", "1e-5")
    _, told = repair(kata("segment"), text, Containment())
    assert [kind for kind, _ in told] == ["tolerance-smaller"]


@pytest.mark.parametrize(
    "body",
    [
        "import os\nif '_turn_' in globals(): os._exit(0)",
        "import os, signal\nif '_turn_' in globals(): os.kill(os.getpid(), signal.SIGKILL)",
        "while '_turn_' in globals(): print('x' * 999999)",
    ],
)
def test_a_child_that_dies_or_floods_is_no_repair(kata, body):
    text = body + "\n" + SEGMENT.replace("1e-10", "1e-5")
    with Containment()(SEGMENT.replace("1e-10", "1e-5").encode(), "a.py") as box:
        found = judged(kata("segment"), SEGMENT, box)
        with Beside(Containment(), text.encode(), python=True) as beside:
            made = seek(kata("segment"), found, box, beside)
    assert made is None or not made.whole


def test_ten_thousand_lines_are_read_and_left(kata):
    text = SEGMENT.replace("1e-10", "1e-5").replace("    slack =", "    pass\n" * 10_000 + "    slack =")
    made, told = repair(kata("segment"), text)
    assert made is None or not made.whole or told[0][1] <= text.count("\n") + 1


class Lying:
    """A box whose child answers what it likes."""

    def __init__(self, answers):
        self._answers = answers

    def call(self, entry, calls, limits):
        found = [Reply(Stop.ANSWERED, each) for each in self._answers]
        return CallsResult(tuple(found[: len(calls)]), Usage())


@pytest.mark.parametrize(
    "rows",
    [
        None,
        7,
        [[0, 1]],
        [[0, 1, 0, "x"]],
        [[999, 1, 0, 1]],
        [[0, 999_999, 0, 1]],
        [[0, 0, 0, 1]],
        [[-1, 1, 0, 1]],
        [{"int": "1"}],
    ],
)
def test_a_table_that_is_none_is_no_repair(kata, rows):
    data = kata("segment")
    cases = Cases(data, {data.groups[0].group.name: Answers(2, {})})
    asked = Child(Lying([1, rows]), SEGMENT, cases)
    if isinstance(rows, list):
        with pytest.raises(LostError):
            asked.table(())
    else:
        assert asked.table(()) == []


def test_a_child_that_says_too_little_is_lost(kata):
    data = kata("segment")
    cases = Cases(data, {data.groups[0].group.name: Answers(2, {})})
    for answers in ([], [1], [0, []], [1, [[1]]]):
        with pytest.raises(LostError):
            Child(Lying(answers), SEGMENT, cases).answers((), [0, 1])


class Mortal:
    """A box whose processes answer all calls but some, which end them, and end with the one after so many."""

    def __init__(self, deadly, most=99, stop=Stop.CPU):
        self.processes, self._deadly, self._most, self._stop = 0, deadly, most, stop

    def call(self, entry, calls, limits):
        self.processes += 1
        found = [Reply(Stop.ANSWERED, 1)]
        for at, (_, places, number) in enumerate(calls[1:]):
            if number in self._deadly or at == self._most:
                return CallsResult((*found, Reply(self._stop)), Usage())
            answer = Reply(Stop.ANSWERED, [[number] for _ in places])
            found.append(Reply(Stop.EXCEPTION) if number == 5 else answer)
        return CallsResult(tuple(found), Usage())


@pytest.mark.parametrize(
    ("box", "gone", "processes"),
    [
        (Mortal([]), [5], 1),
        (Mortal([3]), [3, 5], 3),
        (Mortal([0]), [0, 5], 2),
        (Mortal([0, 7, 8, 9], stop=Stop.EXITED), [0, 5, 7, 8, 9], 5),
        (Mortal([], most=6), [5], 3),
    ],
)
def test_who_ends_a_process_costs_itself_alone(kata, box, gone, processes):
    data = kata("segment")
    cases = Cases(data, {data.groups[0].group.name: Answers(2, {})})
    found = Child(box, SEGMENT, cases).answers((), [0, 1], range(10))
    assert found == [None if n in gone else [(0, n), (1, n)] for n in range(10)]
    assert box.processes == processes


@pytest.mark.parametrize(("stop", "most"), [(Stop.CPU, 4), (Stop.WALL, 4), (Stop.MEMORY, 13)])
def test_not_many_processes_are_begun_after_their_ends(kata, stop, most):
    data = kata("segment")
    cases = Cases(data, {data.groups[0].group.name: Answers(2, {})})
    box = Mortal(range(99), stop=stop)
    with pytest.raises(LostError):
        Child(box, SEGMENT, cases).answers((), [0, 1], range(99))
    assert box.processes == most


class Sleepy(InProcess):
    """A box in which every process sleeps for a second."""

    calls = 0

    def call(self, entry, calls, limits):
        Sleepy.calls += entry != "features"
        return super().call(entry, calls, limits)._replace(usage=Usage(0.0, 1.0))


def test_what_sleeps_whenever_it_is_imported_is_not_asked_for_long(kata, monkeypatch):
    text = SEGMENT.replace("-slack <= s <= length + slack", "True")
    assert repair(kata("segment"), text)[0].whole
    monkeypatch.setattr(Sleepy, "calls", 0)
    with Sleepy(text.encode(), "a.py") as box, Beside(Sleepy, text.encode(), python=True) as beside:
        seek(kata("segment"), judged(kata("segment"), text, InProcess(text.encode(), "a.py")), box, beside)
    assert 1 < Sleepy.calls < 8


# -- what holds whatever the program is --------------------------------------------------------------------


def test_the_order_of_the_candidates_does_not_matter(kata, monkeypatch):
    wrong = [SEGMENT.replace("1e-10 * size", "1e-9"), FIRST]
    first = [repair(kata("segment"), text)[1] for text in wrong]
    other = SOURCE.replace(b"found = _Edits(", b"found = _Reversed(") + (
        b"\nclass _Reversed(_Edits):\n    def __init__(self, *a):\n"
        b"        super().__init__(*a)\n        self.made = self.made[::-1]\n"
    )
    assert other.count(b"_Reversed") == 2
    monkeypatch.setattr("judge.repair.child.SOURCE", other)
    assert [repair(kata("segment"), text)[1] for text in wrong] == first


def test_half_the_counts_find_one_change(kata):
    text = SEGMENT.replace("1e-10 * size", "1e-9")
    with InProcess(text.encode(), "a.py") as box:
        found = judged(kata("segment"), text, box)
        with Beside(InProcess, text.encode(), python=True) as beside:
            made = seek(kata("segment"), found, box, beside, share=0.5)
    assert made.whole


def test_a_library_is_no_program_to_be_changed(kata):
    text = "try:\n    import shapely\nexcept ImportError:\n    pass\n" + SEGMENT.replace("1e-10", "1e-5")
    made, _ = repair(kata("segment"), text)
    assert made is None or not made.whole


def secrets(data):
    """Numbers of right answers that are in no case, and are no size of one."""
    cases = Cases(data, {group.group.name: Answers(len(group.cases), {}) for group in data.groups})
    open_ = repr([[each.case for each in cases.all], cases.sizes])
    found = [
        number[2]
        for each in cases.all
        if isinstance(each.target, tuple | list)
        for point in each.target
        for number in point
        if len(repr(number[2])) > 15
    ]
    return cases, sorted({number for number in found if repr(abs(number)) not in open_})[:300]


def test_no_right_answer_enters_the_box(kata):
    """What is sent is the text, the arguments and sizes: no target is among it, in whatever form."""
    sent = []

    class Spying(InProcess):
        def call(self, entry, calls, limits):
            sent.append(repr((entry, calls)))
            return super().call(entry, calls, limits)

    data = kata("segment")
    _, hidden = secrets(data)
    assert len(hidden) > 100
    made, _ = repair(data, SEGMENT.replace("-slack <= s <= length + slack", "True"), Spying)
    assert made.whole
    asked = [each for each in sent if each.startswith("('ask'")]
    assert len(asked) > 3
    written = "".join(asked)
    assert [number for number in hidden if repr(number) in written] == []


LOOKING = """
import gc, sys

def circle_segment(cx, cy, r, A, B):
    wanted = {2 * x for x in HALVES}
    waiting, seen = [], set()
    frame = sys._getframe(1)
    while frame is not None:
        waiting += [*frame.f_locals.values(), frame.f_globals.get("_opened")]
        frame = frame.f_back
    for one in waiting:
        if type(one) is float and one in wanted:
            return [(0.0, 0.0)] * 7
        if id(one) not in seen and len(waiting) < 500_000:
            seen.add(id(one))
            waiting += [each for each in gc.get_referents(one) if each is not wanted]
    return [(1.0, 1.0)] * 6
"""


def test_the_memory_of_the_child_holds_no_right_answer(kata):
    """A program that looks through the objects about it for a number of a right answer finds none."""
    data = kata("segment")
    cases, hidden = secrets(data)
    text = LOOKING.replace("HALVES", repr([number / 2 for number in hidden]))
    with Containment()(SOURCE.replace(b"MOST_TURNS = 20_000", b"MOST_TURNS = 10**9"), NAME) as box:
        (pairs,) = Child(box, text, cases).answers((), [0, 1])
    assert [len(raw) for _, raw in pairs] == [6] * 2
    cases.sizes[0] = (hidden[0], 1.0)  # it would find one
    with Containment()(SOURCE.replace(b"MOST_TURNS = 20_000", b"MOST_TURNS = 10**9"), NAME) as box:
        (pairs,) = Child(box, text, cases).answers((), [0, 1])
    assert [len(raw) for _, raw in pairs] == [7] * 2


def test_what_lies_in_a_library_is_not_changed(kata):
    """Nor is anything said of the lines that call it: it may be the library that needs the change."""
    text = SEGMENT.replace("1e-10 * size", "1e-9")
    data = kata("segment")
    assert data.module
    for first, whole in (("import statistics", True), ("import yaml", False)):
        changed = f"{first}\n{text}".encode()
        with (
            Containment()(text.encode(), "a.py") as box,
            Beside(Containment(), changed, python=True) as beside,
        ):
            assert ("library" in beside.features()) is not whole
            made = seek(data, judged(data, text, box), box, beside)
        assert bool(made and made.whole) is whole


def test_the_judge_parses_no_submission(kata):
    """Neither here nor in what it imports: with a parser that refuses, one change is found all the same."""
    text = SEGMENT.replace("1e-10 * size", "1e-9")
    data = kata("segment")
    assert data.module
    with Containment()(text.encode(), "a.py") as box:
        found = judged(data, text, box)
        with (
            Beside(Containment(), text.encode(), python=True) as beside,
            pytest.MonkeyPatch.context() as patch,
        ):
            for name in ("parse", "walk", "literal_eval"):
                patch.setattr(ast, name, refused)
            patch.setattr(builtins, "compile", refused)
            assert {"root", "comparison"} <= beside.features()
            made = seek(data, found, box, beside)
    assert made.whole


@pytest.mark.parametrize(
    ("source", "found"),
    [
        (b"x = 5 // 2", {"//", "whole", "round"}),
        (b"import math, numpy.linalg\nx = 5 // 2", {"//", "whole", "round"}),
        (b"def f():\n    from ezdxf.math import Vec2\n    return 5 // 2", {"library"}),
        (b"def f(:", set()),
        (b"import os\nos._exit(0)", set()),
        (b"# \xff\nx = 5 // 2", {"//", "whole", "round"}),
        (b"(" * 50_000, set()),
        (b"x = 1" + b" " * 1_000_000, None),
    ],
)
def test_what_a_text_has_is_asked_in_the_box(source, found):
    with Beside(Containment(), source, python=True) as beside:
        assert beside.features() == found


def refused(*_, **__):
    raise AssertionError("the judge parses")


def test_the_file_in_the_box_needs_nothing_of_the_judge():
    first, _, rest = SOURCE.decode().partition("\n")
    script = f"{first}\nimport sys; sys.modules['judge'] = None\n{rest}\nprint(ask.__name__)"
    ended = subprocess.run([sys.executable, "-S", "-"], input=script, capture_output=True, text=True)
    assert (ended.stdout, ended.stderr) == ("ask\n", "")


@pytest.mark.parametrize(
    ("was", "becomes"),
    [
        ("(b - c) / a, (b + c) / a", "((b - c) / (2 * a), (b + c) / (2 * a))"),
        ("b // 2, c // 2", "(b / 2, c / 2)"),
    ],
)
def test_one_change_is_made_at_all_its_places(was, becomes):
    tree = ast.parse(f"def f(a, b, c):\n    return {was}\n")
    edits = listed(tree, Facts("f", ["a", "b", "c"], [], False, {}))
    (edit,) = [each for each in edits if each.what == "all"]
    edit.apply()
    assert ast.unparse(tree).endswith(f"return {becomes}")

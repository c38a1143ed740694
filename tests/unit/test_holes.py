"""Holes in a kata's data, of a toy that is no geometry: is a divisible by b?"""

from __future__ import annotations

import ast
import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from judge.data.load import load_data
from judge.holes.bench import Bench
from judge.holes.hunt import look_for_holes
from judge.holes.inside import changed, ladders
from judge.holes.model import HoleSearch
from judge.holes.mutants import mutants
from judge.problem.load import load_problem
from judge.sandbox import Containment
from judge.sandbox.available import levels_here
from judge.values.check import is_right

HELD = any(each.available for each in levels_here() if each.name != "limits")

TOML = """
title = "Divides"
tier = "junior"
summary = "Whether b divides a."
entry = "divides"
answer = "int"
sets = ["junior"]
place = 1

[parameters]
a = { type = "integer", low = -1000, high = 1000, about = "a number" }
b = { type = "integer", low = -1000, high = 1000, about = "another" }
"""
STATEMENT = """# Divides

Is `a` a multiple of `b`? Answer 1 or 0; nothing but 0 is a multiple of 0.

## Examples

```
>>> divides(6, 3)
1
>>> divides(7, 2)
0
```
"""
PROBLEM = '''"""Whether b divides a."""

from judge.problem.declare import group


def solve(a, b):
    return int(a == 0 if b == 0 else a % b == 0)


GROUPS = [
    group("small", "Small numbers.", lambda draw: (draw.integer(2, 60), draw.integer(2, 9)), cases=40),
    MORE
]
'''
ZERO = 'group("zero", "b is 0.", lambda draw: (draw.integer(-20, 20), 0), cases=40),'
SIGNS = (
    'group("signs", "Of any sign.", lambda draw: (draw.integer(-999, 999), draw.integer(-9, 9)), cases=200),'
)
LARGE = 'group("large", "Large.", lambda draw: (draw.integer(1, 999), 7), cases=2, size=500),'
RIGHT = '''"""remainder

Nothing is left.
"""


def divides(a, b):
    if b == 0:
        return int(a == 0)
    a, b = abs(a), abs(b)
    return int(a in range(0, a + 1, b))
'''


class Memory:
    """A store that keeps everything."""

    def __init__(self):
        self.kept = {}

    def read(self, name, key, kind):
        import msgspec

        found = self.kept.get((name, key))
        return None if found is None else msgspec.json.decode(found, type=kind)

    def write(self, name, key, value, what=""):
        self.kept[name, key] = value


@pytest.fixture
def pack(tmp_path):
    folder, solutions = tmp_path / "problems" / "divides", tmp_path / "solutions" / "divides"
    (solutions / "accepted").mkdir(parents=True)
    folder.mkdir(parents=True)
    (folder / "problem.toml").write_text(TOML)
    (folder / "statement.md").write_text(STATEMENT)
    (solutions / "accepted" / "remainder.py").write_text(RIGHT)
    return with_groups(tmp_path, "")


def with_groups(pack: Path, more: str) -> Path:
    (pack / "problems" / "divides" / "problem.py").write_text(PROBLEM.replace("MORE", more))
    return pack


def looked(pack, store=None, **how):
    problem = load_problem(pack / "problems" / "divides")
    search = HoleSearch(**{"cases": 1500, "seconds": 1e9, **how})
    return look_for_holes(problem, [load_data(problem, store=None)], Containment(), search, store or Memory())


def changes(found):
    return {(hole.was, hole.becomes) for hole in found.holes}


# -- mutants ----------------------------------------------------------------------------------------------


def plain(text):
    return ast.unparse(ast.parse(text))


def becomes(source):
    return {plain(each.becomes) for each in mutants(source)}


@pytest.mark.parametrize(
    ("source", "some"),
    [
        ("x = a + b", {"x = (a - b)", "x = (a)", "x = (b)"}),
        ("x = a and b or c", {"x = ((a or b) or c)", "x = (a and b)"}),
        ("x = max(a, b)", {"x = min(a, b)", "x = abs(a)", "x = (a + b)"}),
        ("x = -abs(a)", {"x = (abs(a))", "x = -(a)"}),
        ("x = a <= b > c", {"x = a < b > c", "x = b > c", "x = a <= b"}),
        ("x = f(3)", {"x = f((4))", "x = f((2))", "x = f((-3))"}),
        ("x = f(1e-10)", {"x = f(1.2e-07)", "x = f(1e-16)", "x = f(0.0)"}),
        ("x = a[0]", {"x = a[1]"}),
        (
            "x, y = a - b, c - d",
            {
                f"x, y = (a - b, c - d); {each}"
                for each in ("x *= abs(x) > 1e-09 * abs(y)", "y *= abs(y) > 1e-12 * abs(x)")
            },
        ),
        (
            "x = a == b",
            {"x = (abs((a) - (b)) <= 1e-30)", "x = (abs((a) - (b)) <= 1e-16 * max(abs(a), abs(b)))"},
        ),
        ("x = a == {1: b}", {"x = (abs((a) - ({1: b})) <= 1e-30)"}),
        ("if a: b = 1", {"if False: b = 1", "if a: pass"}),
        ("def f(a):\n    return a", {"return None"}),
        ("def f(dx, dy):\n    return dx", {"return dy"}),
        (
            "t = 1e-9\ndef f(a, b):\n    return a < t",
            {"return a < (1e-09 * abs(b))", "return a < (120 * t)"},
        ),
        ("x = abs(a - b) <= t", {"x = abs((a) ** 2 - (b) ** 2) <= (t)", "x = (abs(a - b)) ** 2 <= (t) ** 2"}),
        ("x = 1e-9 * a\nb = 2", {"x = 1e-09 * abs(b)", "x = 1e-09 * (a + abs(b))"}),
    ],
)
def test_what_a_program_becomes(source, some):
    assert set(map(plain, some)) <= becomes(source)


def test_mutants_are_programs_no_two_alike_and_what_nobody_evaluates_is_left():
    source = 'def f(a: int = 3, *b: "x") -> int:\n    "text 4"\n    return f"{a + 1}" + g(*b)\n'
    found = [*mutants(source)]
    assert len({ast.dump(ast.parse(each.source)) for each in found}) == len(found)
    assert {each.kind for each in found} == {"return None", "operator", "dropped operand"}


def test_a_ladder_goes_down_and_is_one_for_each_use():
    found = [each for each in mutants("t = 1e-9 * e\nx = a < t\ny = b < t") if each.kind == "tolerance"]
    assert len({each.ladder for each in found}) == 3
    rungs = [float(each.becomes.split()[2]) for each in found if each.line == 1]
    assert rungs == sorted(rungs, reverse=True)


@pytest.mark.parametrize(
    ("name", "number", "source", "case", "answer"),
    [
        ("int{} that wraps", 16, "a * b", (300, 300), 300 * 300 - 65536 * 1),
        ("int{} that saturates", 16, "a * b", (300, 300), 32767),
        ("floats of {} bits", 24, "a + b", (2**24, 1), 2.0**24),
        ("floats of {} bits", 53, "a + b", (2**24, 1), 2.0**24 + 1),
        ("Decimal of {} digits", 6, "sqrt(a)", (2, 0), 1.41421),
        ("Decimal of {} digits", 40, "sqrt(a * a)", (10**15 + 1, 0), 10**15 + 1),
        ("answer rounded to {} decimals", 4, "a / b", (2, 3), 0.6667),
        ("answer of {} digits", 4, "a / b", (2000, 3), 666.7),
        ("input as whole numbers", 0, "a + b", (1.4, 2), 3),
        ("input as floats of {} bits", 24, "a", (0.1, 0), 13421773 / 2**27),
    ],
)
def test_other_numbers(name, number, source, case, answer):
    names = {}
    exec(f"from math import sqrt\ndef f(a, b):\n    return {source}\n", names)
    assert (name, number) in ladders(measured=True)
    assert changed(name, number, names["f"], names)(*case) == answer


# -- the search -------------------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.skipif(not HELD, reason="mutants need isolation full or strong")
class TestSearch:
    def test_what_the_data_lack_is_found_and_what_a_group_draws_then_is_not(self, pack):
        found = looked(pack)
        assert found.exit_code == 3
        assert {"a, b = abs(a), abs(b)", "if b == 0:"} <= {was for was, _ in changes(found)}
        assert found.mutants == found.rejected + found.accepted
        assert found.accepted >= found.edge + found.unknown + len(found.holes)
        for hole in found.holes:
            a, b = ast.literal_eval(hole.case)
            assert hole.right == str(int(a == 0 if b == 0 else a % b == 0)) != hole.given
        closed = looked(with_groups(pack, ZERO + SIGNS))
        assert (closed.exit_code, closed.holes, closed.faults) == (0, (), ())
        assert closed.accepted

    def test_a_search_goes_on_where_it_ended_and_depends_on_nothing_else(self, pack):
        store = Memory()
        first = looked(pack, store, cases=1)
        second = looked(pack, store, cases=1)
        assert second.cases > first.cases
        at_once = looked(pack, cases=second.cases)
        assert at_once.cases == second.cases
        assert (at_once.edge, at_once.unknown) == (second.edge, second.unknown)
        assert {hole.case for hole in at_once.holes} == {hole.case for hole in second.holes}

    def test_only_mutants_whose_group_has_changed_are_judged_again(self, pack, monkeypatch):
        store = Memory()
        before = looked(pack, store)
        asked, plainly = [], Bench._called

        def called(self, work, cases):
            asked.extend(each for each, *_ in work if each.mutant.kind)
            return plainly(self, work, cases)

        monkeypatch.setattr(Bench, "_called", called)
        after = looked(with_groups(pack, ZERO), store, cases=0)
        assert after.rejected > before.rejected
        assert 0 < len({each.key for each in asked}) <= before.accepted

    def test_another_seed_judges_no_mutant_again(self, pack, monkeypatch):
        store = Memory()
        before = looked(pack, store, cases=0)
        asked = []
        monkeypatch.setattr(Bench, "_called", lambda self, work, cases: asked.extend(work) or [])
        after = looked(pack, store, cases=0, seed=1)
        assert (after.accepted, asked) == (before.accepted, [])

    def test_a_mark_is_kept_and_a_stale_one_is_a_fault(self, pack):
        row = '[[same]]\nfile = "accepted/remainder.py"\nwas = "{}"\nbecomes = "{}"\nwhy = "a is no sign"\n'
        marks = pack / "solutions" / "divides" / "same.toml"
        marks.write_text(row.format("a, b = abs(a), abs(b)", "a, b = (a), …"))
        found = looked(pack)
        assert found.marked == 1
        assert not any(becomes == "a, b = (a), abs(b)" for _, becomes in changes(found))
        marks.write_text(
            row.format("return int(a in range(0, a + 1, b))", "return None") + row.format("x = 1", "x = 2")
        )
        stale = looked(pack)
        assert [(fault.where, fault.what) for fault in stale.faults] == [
            ("divides/same.toml:1", "this mutant is rejected now"),
            ("divides/same.toml:6", "no mutant is like this"),
        ]

    def test_mutants_are_not_judged_when_the_time_is_up_and_the_next_search_goes_on(self, pack):
        (pack / "solutions" / "divides" / "same.toml").write_text(
            '[[same]]\nfile = "accepted/remainder.py"\nwas = "a, b = abs(a), abs(b)"\n'
            'becomes = "a, b = (a), …"\nwhy = "a is no sign"\n'
        )
        store = Memory()
        late = looked(pack, store, seconds=0.0)
        assert (late.mutants, late.faults, len(late.notes)) == (0, (), 1)
        told = [(each.mutants, each.rejected, changes(each)) for each in (looked(pack, store), looked(pack))]
        assert told[0] == told[1]

    def test_a_right_program_that_fails_is_a_fault_with_its_case(self, pack):
        other = pack / "solutions" / "divides" / "accepted" / "modulo.py"
        other.write_text('"""modulo"""\n\n\ndef divides(a, b):\n    return int(a % b == 0)\n')
        found = looked(pack)
        (fault,) = [each for each in found.faults if each.where == "accepted/modulo.py"]
        assert "judge try divides" in fault.what

    def test_each_costs_itself_alone_that_hangs_leaves_prints_recurses_or_fills_memory(self, pack, tmp_path):
        there = tmp_path / "written"
        lines = [
            "if b == 7: open(NAME, 'w')",
            "if b == 7: raise SystemExit",
            "if b == 7: print('x' * 10 ** 8)",
            "if b == 7: divides(a, b)",
            "if b == 7: [0] * 10 ** 10",
            "if b == 7: 7 ** 10 ** 10",
            "if b == 7: return os._exit(0)",
        ]
        source = RIGHT.replace("    if b == 0:\n", "    if b == 7.5: pass\n    if b == 0:\n")
        path = pack / "solutions" / "divides" / "accepted" / "remainder.py"
        path.write_text(source)
        from judge.holes import programs
        from judge.holes.mutants import Mutant

        def bad(self, measured):
            for line in lines:
                text = source.replace("if b == 7.5: pass", line.replace("NAME", repr(str(there))))
                yield programs.Candidate(self, Mutant("bad", 1, "", line, "import os\n" + text))
            yield programs.Candidate(self, Mutant("good", 1, "", "", source + "\n"))

        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(programs.Base, "mutants", bad)
            found = looked(pack, cases=1)
        assert (found.mutants, found.rejected, found.accepted) == (len(lines) + 1, len(lines), 1)
        assert not there.exists()

    def test_of_a_case_larger_than_those_that_are_asked_the_large_groups_tell(self, tmp_path, pack):
        """A mutant that hangs on lists of more than five, and one that is wrong on a negative number."""
        from judge.holes import programs
        from judge.holes.mutants import Mutant

        folder, solutions = tmp_path / "problems" / "divides", tmp_path / "solutions" / "divides"
        row = 'a = { type = "[integer; 1..90]", low = -9, high = 9, about = "numbers" }\n'
        (folder / "problem.toml").write_text(TOML.partition("a = {")[0] + row)
        (folder / "statement.md").write_text(STATEMENT.partition(">>>")[0] + ">>> divides([6, 3])\n9\n```\n")
        right = '"""sum"""\n\n\ndef divides(a):\n    return sum(a)\n'
        (solutions / "accepted" / "remainder.py").write_text(right)
        lines = ["    while len(a) > 5: pass\n", "    if a[0] < 0: return 99\n"]

        def bad(self, measured):
            for at, line in enumerate(lines, 1):
                text = right.replace("    return", line + "    return")
                yield programs.Candidate(self, Mutant("bad", at, "", line, text))

        def lists(*groups):
            rows = [
                f'group("g{at}", "L.", lambda draw: (({low}, *[draw.integer(0, 9)] * {n}),), cases=2{more}),'
                for at, (n, low, more) in enumerate(groups)
            ]
            text = "from judge.problem.declare import group\n\n\ndef solve(a):\n    return sum(a)\n\n\n"
            (folder / "problem.py").write_text(text + f"GROUPS = [{''.join(rows)}]\n")
            return {hole.becomes for hole in looked(pack).holes}

        hangs, wrong = lines
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(programs.Base, "mutants", bad)
            assert lists((4, 0, "")) == {hangs, wrong}
            assert lists((4, 0, ""), (50, -1, ", size=50")) == {wrong}
            assert lists((4, 0, ""), (20, 0, "")) == {wrong}
            assert lists((4, 0, ""), (20, -1, "")) == set()

    def test_a_kata_without_a_program_that_can_be_changed_is_told(self, pack):
        (pack / "solutions" / "divides" / "accepted" / "remainder.py").unlink()
        (fault,) = looked(pack).faults
        assert fault.what == "no accepted program can be changed"

    def test_a_kata_of_programs_alone_is_one_clear_line_and_no_fault(self):
        katas = Path(load_data.__code__.co_filename).parents[1] / "manual" / "katas" / "problems"
        command = [sys.executable, "-m", "judge", "verify", "depot", "--holes", "--problems", str(katas)]
        ended = subprocess.run(command, capture_output=True, text=True, check=False)
        assert (ended.returncode, ended.stdout) == (0, "depot  not looked at\n")
        assert ended.stderr.count("\n") == 1
        assert "has no function to change" in ended.stderr

    def test_the_command_says_what_it_found_and_exits_with_3(self, pack):
        def judge(*words):
            command = [sys.executable, "-m", "judge", *words, "--problems", str(pack / "problems")]
            return subprocess.run(command, capture_output=True, text=True, check=False)

        look = "verify", "divides", "--holes", "--for", "1s"
        found = judge(*look, "--json")
        while "the same command goes on" in found.stderr:  # on a busy machine a second is little
            found = judge(*look, "--json")
        assert found.returncode == 3, found.stderr
        (line,) = found.stdout.splitlines()
        assert {hole["becomes"] for hole in json.loads(line)["holes"]}
        unknown = json.loads(line)["unwitnessed"]
        assert len(unknown) == json.loads(line)["unknown"] > 0
        assert unknown[0] not in judge(*look).stdout
        assert unknown[0] in judge(*look, "--all").stdout
        shown = judge(*look).stdout
        assert "judge try divides" in shown
        assert "solutions/divides/same.toml" in shown
        with_groups(pack, ZERO + SIGNS)
        assert judge(*look).returncode == 0
        for words in (("--for", "1s"), ("--seed", "1"), ("--holes", "--pin"), ("--holes", "--for", "soon")):
            assert judge("verify", "divides", *words).returncode == 2
        with_groups(pack, LARGE)
        for words in (("--isolation", "limits"), ("--group", "large")):
            refused = judge(*look, *words)
            assert (refused.returncode, len(refused.stderr.splitlines())) == (2, 1)
            assert "fault" not in refused.stderr

    def test_each_way_alone_finds_something(self, pack, monkeypatch):
        from judge.holes.cases import Stream

        for way in ("edge", "rows", "near", "changed", "plain"):
            monkeypatch.setattr(Stream, "ways", (way,))
            found = looked(pack, cases=3000)
            assert found.holes, way
            assert {hole.way for hole in found.holes} == {way}


KATAS = Path(__file__).parents[2] / "judge" / "manual" / "katas"


@pytest.mark.slow
@pytest.mark.skipif(not HELD, reason="programs are changed only where they are contained")
@pytest.mark.parametrize(
    ("kata", "kept", "change"),
    [
        ("runs", ["short", "alone", "long"], "s without blanks at the ends"),
        ("least-recently-used", ["one-place"], "pass"),
        ("knapsack", ["heavy"], "max("),
    ],
)
def test_a_hole_is_found_where_groups_are_missing(kata, kept, change, tmp_path, monkeypatch):
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path / "cache"))
    shutil.copytree(KATAS, tmp_path / "katas")
    folder = tmp_path / "katas" / "problems" / kata
    path = folder / "problem.py"
    lines = path.read_text("utf-8").splitlines(keepends=True)
    rows = [f'    group("{name}"' for name in kept]
    path.write_text(
        "".join(line for line in lines if not line.startswith("    group(") or line.startswith((*rows,)))
    )
    problem = load_problem(folder)
    assert [each.name for each in problem.groups] == ["examples", *kept]
    search = HoleSearch(cases=4000, seconds=1e9)
    found = look_for_holes(problem, [load_data(problem, store=None)], Containment(), search, Memory())
    assert found.faults == ()
    assert any(change in hole.becomes for hole in found.holes)


def test_to_be_off_by_a_hair_more_than_allowed_proves_no_hole():
    problem = load_problem(Path(__file__).parents[2] / "problems" / "distance")
    found = Bench([load_data(problem)], None, {}, lambda *_: None).solved(((0, 0), (1, 0), (0.5, 3.0)))

    def accepted(times):  # e is 3, and 1e-9·e is allowed
        answer = 3 + times * 3e-9
        return is_right(problem.answer, answer, found.target, lambda: (found.exact, found.group.tolerance))

    assert accepted(1.05)
    assert accepted(-1.05)
    assert not accepted(1.2)
    assert not accepted(-1.2)

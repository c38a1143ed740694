"""The audit of a problem's data: how many cases there are of every kind, and reasons why there are none."""

from __future__ import annotations

import json
import shutil
from fractions import Fraction
from pathlib import Path

import pytest
from msgspec.structs import replace

from judge.data.model import GroupData
from judge.errors import ProblemError
from judge.problem.load import load_problem
from judge.problem.topic import Decision, Topic
from judge.report.verified import report_lines
from judge.run.audit import Few, audit
from judge.run.matrix import Kill, Matrix, Row
from judge.run.verify import VerifyReport, verify_problem

PACK = Path(__file__).parents[1] / "fixtures" / "pack"
FIXTURE = Path(__file__).parents[1] / "fixtures" / "problems" / "root-count"


@pytest.fixture
def middle():
    return replace(load_problem(PACK / "problems" / "middle"), audit={})


def groups_of(problem, *several):
    """Groups of these cases."""
    return [
        GroupData(replace(problem.groups[0], name=f"g{at}"), list(cases), [None] * len(cases))
        for at, cases in enumerate(several)
    ]


def found(audited):
    return {bucket.name: bucket.cases for bucket in audited.buckets}


def test_cases_are_told_apart_by_the_types_of_their_numbers_but_for_whole_ones(middle):
    groups = groups_of(middle, [(1, 2), (1.0, 2), (1, 2.0)], [(0.5, 0.5)])
    audited = audit(middle, Topic(), groups, None)
    assert audited.types == {"g0": (1, 0, 2), "g1": (0, 1, 0)}
    assert found(audited) == {"numbers, all int": 1, "numbers, all float": 1, "numbers, mixed": 2}
    assert audited.gaps == ()
    whole = load_problem(FIXTURE)
    audited = audit(whole, Topic(), groups_of(whole, [(1,), (2,)]), None)
    assert (audited.types, audited.buckets) == ({}, ())


def test_an_empty_kind_is_a_gap_unless_a_reason_is_given(middle):
    groups = groups_of(middle, [(1, 2)])
    assert [gap.name for gap in audit(middle, Topic(), groups, None).gaps] == [
        "numbers, all float",
        "numbers, mixed",
    ]
    excused = replace(middle, audit={"numbers, mixed": "why not", "numbers, all int": "idle"})
    audited = audit(excused, Topic(), groups, None)
    assert [gap.name for gap in audited.gaps] == ["numbers, all float"]
    assert audited.idle == ("numbers, all int",)
    assert audit(replace(middle, audit={"numbers": "all of them"}), Topic(), groups, None).gaps == ()
    assert audit(replace(middle, audit={"number": "no name"}), Topic(), groups, None).idle == ("number",)


def test_some_case_comes_near_the_smallest_number(middle):
    smallest = [replace(each, smallest=Fraction(1, 10**9)) for each in middle.parameters]
    problem = replace(middle, parameters=tuple(smallest))
    far, near = (1.0, 2), (5e-8, 0)
    assert found(audit(problem, Topic(), groups_of(problem, [far]), None))["numbers, near the smallest"] == 0
    assert found(audit(problem, Topic(), groups_of(problem, [near]), None))["numbers, near the smallest"] == 1


def measured(case):
    """How far the first number is from the second, as it says itself."""
    a, b = case
    yield ("above" if a > b else "below"), abs(a - b)


def topic_of(**options):
    decision = Decision("gap", ("above", "below"), measured, **options)
    return Topic(decisions=lambda _problem: [decision])


def counts(middle, cases, **options):
    audited = audit(middle, topic_of(**options), groups_of(middle, cases), None)
    return {name.removeprefix("gap, "): n for name, n in found(audited).items() if name.startswith("gap")}


def test_a_decision_is_counted_by_side_and_decade(middle):
    cases = [(0.05, 0.0), (0.0, 0.05), (0.5, 0.0), (0.6, 0.0), (0.0, 0.0005)]
    assert counts(middle, cases, least=1e-3) == {
        "above, 1e-3 to 1e-2": 0,
        "above, 1e-2 to 1e-1": 1,
        "above, 1e-1 to 1e0": 2,
        "below, 1e-3 to 1e-2": 0,
        "below, 1e-2 to 1e-1": 1,
        "below, 1e-1 to 1e0": 0,
    }


def test_the_edges_of_a_band_are_kinds_and_what_no_case_may_be_is_none(middle):
    cases = [(0.00095, 0), (0.0005, 0), (0.11, 0), (0.5, 0), (0.31, 0)]
    found = counts(middle, cases, least=1e-4, within=1e-3, beyond=1e-1)
    assert {name: n for name, n in found.items() if name.startswith("above")} == {
        "above, 1e-4 to 1e-3": 2,
        "above, 1e-1 to 1e0": 3,
        "above, 0.9 to 1 times 0.001": 1,
        "above, 1.01 to 3 times 0.1": 1,
    }
    edges = ("0.9 to 1 times 0.001", "1.01 to 3 times 0.1")  # without decades there are edges only
    alone = counts(middle, [(1, 0)], within=1e-3, beyond=1e-1)
    assert list(alone) == [f"{side}, {edge}" for side in ("above", "below") for edge in edges]


def matrix(*rejected):
    rows = [
        Row(f"wrong/w{n}.py", "w", (), (Kill("a", tuple(range(n)), 9), Kill("b", (), 9))) for n in rejected
    ]
    return Matrix(("a", "b"), tuple(rows), (), (), ())


def text_of(report, **options):
    return "\n".join(
        "".join(span if isinstance(span, str) else span.text for span in each)
        for each in report_lines(report, 100, **options)
    )


def test_the_screen_warns_and_shows_the_counts_with_the_matrix(middle):
    audited = audit(
        middle, topic_of(least=0.1, within=1e-3, beyond=1e-2), groups_of(middle, [(1, 0.5)]), matrix(1)
    )
    few = audit(middle, Topic(), groups_of(middle, [(1, 2)]), matrix(0, 1, 4, 5, 9)).few
    assert few == (Few("wrong/w1.py", 1), Few("wrong/w4.py", 4))
    report = VerifyReport("middle", 1, 1, "matching", (), (), audit=audited)
    assert "warning  wrong/w1.py: only 1 case of all groups reject it" in text_of(report)
    assert "mixed" not in text_of(report)
    shown = text_of(report, with_matrix=True)
    assert "g0           0          0      1" in shown
    assert "gap, above  1 from 1e-1, 0 at 0.9 to 1 times 0.001" in shown


@pytest.mark.slow
def test_a_gap_is_a_fault_of_the_gate(tmp_path):
    for kind in ("problems", "solutions"):
        shutil.copytree(PACK / kind / "middle", tmp_path / kind / "middle")
    place = tmp_path / "problems" / "middle" / "problem.toml"
    place.write_text(place.read_text().replace("numbers, mixed", "numbers, all int"))
    said = [str(fault) for fault in verify_problem(load_problem(tmp_path / "problems" / "middle")).faults]
    assert any("gives a reason for 'numbers, all int', and no such kind is empty" in each for each in said)
    assert any("there is no case of 'numbers, mixed'" in each for each in said)


def test_a_reason_says_something(tmp_path):
    folder = tmp_path / "root-count"
    folder.mkdir()
    for each in FIXTURE.iterdir():
        if each.is_file():
            (folder / each.name).write_text(each.read_text())
    text = (folder / "problem.toml").read_text()
    (folder / "problem.toml").write_text(text.replace("[limits]", '[audit]\n"numbers" = " "\n\n[limits]', 1))
    with pytest.raises(ProblemError, match="it is not said why there is no case of 'numbers'"):
        load_problem(folder)
    assert json.dumps(dict(load_problem(FIXTURE).audit)) == "{}"

"""What is made of results: JUnit for CI servers, and those of a class read back from what is published."""

from __future__ import annotations

import re
from xml.etree import ElementTree as Xml

import msgspec
import pytest
from classes import ROWS
from msgspec.structs import replace
from past_runs import past_result

from judge.batch.model import WorkerResult
from judge.problem import Verdict
from judge.problem.model import KataLevel
from judge.report.formats import junit
from judge.run.kept import read_result
from judge.run.result import (
    Failure,
    GroupResult,
    LevelResult,
    Mode,
    Pitfall,
    Result,
    Timing,
    earned,
    judge_fault,
)

# What the schemas of Jenkins (junit-10.xsd) and Surefire (surefire-test-report.xsd) both allow: for each
# element its required attributes, the others, and its children in their order. Times have more digits than
# the three of those schemas: many a case takes less than a thousandth of a second.
SHAPE = {
    "testsuites": (set(), {"name", "time", "tests", "failures", "errors"}, ["testsuite"]),
    "testsuite": (
        {"name", "tests", "failures", "errors", "skipped"},
        {"time", "group"},
        ["properties", "testcase"],
    ),
    "properties": (set(), set(), ["property"]),
    "property": ({"name", "value"}, set(), []),
    "testcase": ({"name", "time"}, {"classname", "group"}, ["failure", "skipped", "error", "system-out"]),
    "failure": ({"type"}, {"message"}, []),
    "error": ({"type"}, {"message"}, []),
}
TIME = re.compile(r"[0-9]+\.[0-9]{6}")
EVIL = "a\x00\x08\x1b[31m]]>\n<!-- & \ud800 \ufffe </failure><system-out>'\" \u202e"


def read(*results: Result) -> Xml.Element:
    root = Xml.fromstring(junit(list(results)))
    for element in root.iter():
        required, optional, children = SHAPE[element.tag]
        assert required <= set(element.attrib) <= required | optional, element.tag
        order = [children.index(child.tag) for child in element]
        assert order == sorted(order), element.tag
        if "time" in element.attrib:
            assert TIME.fullmatch(element.attrib["time"])
    return root


def group(name: str, verdict: Verdict, passed: int = 0) -> GroupResult:
    return GroupResult(name=name, verdict=verdict, cases=10, passed=passed, points=50)


@pytest.mark.parametrize("verdict", [Verdict.WA, Verdict.CE, Verdict.JE])
def test_nothing_of_a_submission_breaks_the_document(verdict):
    groups = () if verdict in (Verdict.CE, Verdict.JE) else (group("grid", verdict),)
    failure = Failure(EVIL, "grid" if groups else None, 1, {"cx": 1}, "2", EVIL)
    result = Result(problem="count", submission=EVIL, verdict=verdict, failure=failure, **earned(groups))
    root = read(result)
    assert len(list(root.iter("system-out"))) == 0
    (case,) = root.iter("testcase")
    assert r"\x00\x08\x1b[31m]]>" in case[0].text
    assert r"<!-- & \ud800 \ufffe </failure><system-out>" in case[0].text
    assert case[0].get("message").endswith("'\" \\u202e")


def test_what_does_not_compile_is_a_failed_case_and_the_judges_own_fault_an_error():
    fault = judge_fault("count", "a.py", "the reference fails")
    failure = Failure("SyntaxError (line 2)")
    compiled = Result(problem="count", submission="a.py", verdict=Verdict.CE, failure=failure)
    for result, told in (
        (fault, ("judge", "error", "JE", "the reference fails")),
        (compiled, ("compile", "failure", "CE", "SyntaxError (line 2)")),
    ):
        root = read(result)
        (case,) = root.iter("testcase")
        assert (case.get("name"), case[0].tag, case[0].get("type")) == told[:3]
        assert told[3] in case[0].get("message")
        assert (root.get("errors"), root.get("failures")) == (("1", "0") if result is fault else ("0", "1"))
    assert read().get("tests") == "0"


FULL = replace(
    past_result(failed=("band",), ratio=2.0),
    levels=(LevelResult(KataLevel.INTERVIEW, False, 3, 3, 2),),
    pitfall=Pitfall(("a", "b"), 0.5, ("", ""), ("c",)),
    time=Timing(cpu_seconds=0.1, borderline=True, import_seconds=0.5, reference="C++", why="no C"),
    counterexample=Failure(
        "off", group="grid", input={"r": 10**30}, expected="1", got="2", replay="p:grid:v:0"
    ),
)


@pytest.mark.parametrize("result", [FULL, judge_fault("count", "a.py", "why")])
def test_a_result_is_read_back_as_it_was(result):
    assert read_result(msgspec.json.decode(msgspec.json.encode(result.as_json()))) == result


def test_what_older_judges_wrote_is_read():
    old = {
        "schema": 1, "problem": "count", "submission": "a.py", "mode": "program", "verdict": "WA", "score": 5,
        "levels": [{"level": "interview", "passed": True, "groups": 2, "run": 2, "accepted": 2}],
        "groups": [{"name": "grid", "verdict": "WA", "cases": 9, "passed": 4, "worst_ulps": None,
                    "cpu_seconds": 0.5, "level": "production"}],
        "failure": {"group": "grid", "case": 3, "input": {"cx": 10**30}, "expected": "1", "got": "2",
                    "message": "off"},
        "counterexample": {"input": {"cx": 0}, "expected": "0", "got": "1", "message": "off",
                           "replay": "count:grid:v0:abcdef", "cut_short": True},
        "pitfall": {"name": "a + b", "score": 0.5, "lines": [{"wrong": "x", "right": "y"}]},
        "time": {"cpu_seconds": 0.1, "wall_seconds": 0.2, "borderline": False,
                 "ratio": {"median": 2.0, "low": 1.0, "high": 3.0, "pairs": 9},
                 "reference": {"language": "Python", "why": "no reference in Go"}},
        "memory_bytes": 8, "isolation": None, "thresholds": [],
    }  # fmt: skip
    read = read_result(old)
    assert (read.schema, read.mode, read.verdict, read.score) == (2, Mode.PROGRAM, Verdict.WA, 5)
    assert read.levels == (LevelResult(KataLevel.INTERVIEW, True, 2, 2, 2),)
    assert read.groups == (
        GroupResult(
            name="grid", verdict=Verdict.WA, cases=9, passed=4, level=KataLevel.PRODUCTION, cpu_seconds=0.5
        ),
    )
    assert (read.failure.case, read.failure.input) == (3, {"cx": 10**30})
    assert (read.counterexample.group, read.counterexample.cut_short) == ("grid", True)
    assert read.pitfall.names == ("a", "b")
    assert (read.time.reference, read.time.why, read.time.ratio.median) == (
        "Python",
        "no reference in Go",
        2.0,
    )
    assert read_result(read.as_json()) == read


@pytest.mark.parametrize("damaged", [{}, {"schema": 1}, [], {"schema": 2, "verdict": "??"}])
def test_what_is_no_result_is_told(damaged):
    with pytest.raises(ValueError, match="this is not a result"):
        read_result(damaged)


def test_a_row_that_cannot_be_read_is_a_fault_of_its_own():
    result = replace(ROWS[0], done=WorkerResult({"verdict": "??"})).result
    assert (result.verdict, result.submission) == (Verdict.JE, "ann/count-1.py")

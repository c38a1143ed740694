"""What is made of results: JUnit for CI servers, and those of a class read back from what is published."""

from __future__ import annotations

import re
from xml.etree import ElementTree as Xml

import msgspec
import pytest
from classes import ROWS
from msgspec.structs import replace
from past_runs import past_result

from judge.batch.results import results_of
from judge.problem import Verdict
from judge.problem.model import KataLevel
from judge.report.junit import junit
from judge.run import Failure, GroupResult, Mode, Result, judge_fault
from judge.run.published import result_of
from judge.run.result import Against, LevelResult, Pitfall, Timing

# What the schemas of Jenkins (junit-10.xsd) and Surefire (surefire-test-report.xsd) both allow: for each
# element its required attributes, the others, and its children in their order.
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
TIME = re.compile(r"[0-9]+\.[0-9]{0,3}")
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
    return GroupResult(name, verdict, 10, passed, None, 0.0625, 50)


@pytest.mark.parametrize("verdict", [Verdict.WA, Verdict.CE, Verdict.JE])
def test_nothing_of_a_submission_breaks_the_document(verdict):
    groups = () if verdict in (Verdict.CE, Verdict.JE) else (group("grid", verdict),)
    failure = Failure(EVIL, "grid" if groups else None, 1, {"cx": 1}, "2", EVIL)
    result = Result("count", EVIL, Mode.FUNCTION, verdict, groups, failure)
    root = read(result)
    assert len(list(root.iter("system-out"))) == 0
    (case,) = root.iter("testcase")
    assert r"\x00\x08\x1b[31m]]>" in case[0].text
    assert r"<!-- & \ud800 \ufffe </failure><system-out>" in case[0].text
    assert case[0].get("message").endswith("'\" \\u202e")


def test_what_does_not_compile_is_a_failed_case_and_the_judges_own_fault_an_error():
    fault = judge_fault("count", "a.py", "the reference fails")
    compiled = Result("count", "a.py", Mode.FUNCTION, Verdict.CE, failure=Failure("SyntaxError (line 2)"))
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
    levels=(LevelResult(KataLevel.INTERVIEW, 3, 3, 2),),
    pitfall=Pitfall(("a", "b"), 0.5, ("", ""), ("c",), (("x", "y"),)),
    time=Timing(0.1, 0.2, None, True, None, 0.5, Against("C++", "why")),
    counterexample={"input": {"r": 10**30}, "expected": "1", "got": "2", "replay": "x"},
)


@pytest.mark.parametrize("result", [FULL, judge_fault("count", "a.py", "why")])
def test_what_is_published_is_read_back(result):
    plain = msgspec.json.decode(msgspec.json.encode(result.as_json()))
    points = {group.name: group.points for group in result.groups}
    read = result_of(plain | {"thresholds": []}, points)  # which older judges wrote
    assert read.as_json() == result.as_json()
    assert read.failure == (replace(result.failure, given=None) if result.failure else None)


def test_a_row_that_cannot_be_read_is_a_fault_of_its_own():
    broken = replace(ROWS[0], json='{"result": {"verdict": "??"}}')
    (result,) = results_of([broken], {})
    assert (result.verdict, result.submission) == (Verdict.JE, "ann/count-1.py")

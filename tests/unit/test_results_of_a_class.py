"""What is made of a class's results: read back from what is published, JUnit, archives for Dolos."""

from __future__ import annotations

import csv
import io
import zipfile
from xml.etree import ElementTree as Xml

import msgspec
import pytest
from classes import ROWS, row
from msgspec.structs import replace
from page_support import outcome as judged

from judge.batch.model import Handin, Student
from judge.batch.outcome import Outcome
from judge.batch.results import advice_of, batch_junit, results_of
from judge.batch.similar import compared
from judge.problem.find import find_problem
from judge.problem.level import KataLevel
from judge.problem.verdict import Verdict
from judge.run.execute import judge_fault
from judge.run.published import result_of
from judge.run.result import Against, LevelResult, Pitfall, Timing

FULL = replace(
    judged(mistake="absolute-epsilon", ratio=2.0),
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


def test_rows_get_points_and_advice():
    count = find_problem("count")
    advice = advice_of(count)
    (name, told) = next(iter(advice.items()))
    (result,) = results_of([row("ann", "count", name, ("tangent",))], {"count": count})
    assert result.submission == "ann/count.py"
    assert result.pitfall.advice == (told,)
    assert result.score == sum(each.points for each in count.groups if each.name in ("examples", "grid"))
    (other,) = results_of([row("ann", "gone", "some", ("tangent",))], {})
    assert (other.verdict, other.pitfall.name) == (Verdict.WA, "some")


def test_a_row_that_cannot_be_read_is_a_fault_of_its_own():
    broken = replace(ROWS[0], json='{"result": {"verdict": "??"}}')
    (result,) = results_of([broken], {})
    assert (result.verdict, result.submission) == (Verdict.JE, "ann/count-1.py")


def test_a_suite_for_each_hand_in():
    root = Xml.fromstring(batch_junit(ROWS, {"count": find_problem("count")}))
    suites = root.findall("testsuite")
    assert [suite.get("name") for suite in suites][:2] == ["count ann/count-1.py", "count ann/count-2.py"]
    assert len(suites) == len(ROWS)
    assert root.get("failures") == str(sum(int(suite.get("failures")) for suite in suites)) == "10"
    assert suites[6].find("testcase").get("name") == "compile"


# -- for Dolos -----------------------------------------------------------------------------------------------

HANDINS = [
    Handin("ann", "count", "ann/count.py", b"a = 1\n"),
    Handin("ann", "count", "ann/count-2.py", b"a = 2\n"),
    Handin("bob", "count", "-f ../b\x1b/count.py", b"b = 1\n"),
    Handin("ann", "segment", "ann/segment.cpp", b"int a;"),
    Handin("bob", "segment", "bob/segment.cpp", b"int b;"),
    Handin("bob", "ray-nearest", "bob/ray.py", b"c"),
]


@pytest.fixture
def outcome():
    """Ann's second file for count is better than her first."""
    rows = [row(each.student, each.problem, fails=("grid",), file=each.file) for each in HANDINS]
    rows[1] = row("ann", "count", file="ann/count-2.py")
    students = (Student("ann", "=1+1", "A"), Student("bob"))
    return Outcome(students, ("count", "ray-nearest", "segment"), tuple(rows))


def compare(folder, outcome):
    return compared(folder, outcome, HANDINS, {"count": find_problem("count")})


def test_an_archive_for_each_problem_and_language(outcome, tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    folder = tmp_path / "geo.judge.similar"
    told = compare(folder, outcome)
    assert [(each.archive.name, each.files, each.report, each.why) for each in told] == [
        ("count-python.zip", 2, None, ""),
        ("segment-cpp.zip", 2, None, ""),
    ]
    with zipfile.ZipFile(told[0].archive) as archive:
        assert archive.namelist() == ["0001.py", "0002.py", "info.csv"]
        assert [archive.read(name) for name in ("0001.py", "0002.py")] == [b"a = 2\n", b"b = 1\n"]
        rows = list(csv.DictReader(io.StringIO(archive.read("info.csv").decode())))
    assert [*rows[0]] == ["filename", "full_name", "labels", "student", "file"]
    assert [*rows[0].values()] == ["0001.py", "'=1+1", "A", "ann", "ann/count-2.py"]
    assert (rows[1]["full_name"], rows[1]["file"]) == ("bob", "'-f ../b\\x1b/count.py")
    assert b"def line_count" in (folder / "count-python.stub.py").read_bytes()
    before = told[0].archive.read_bytes()
    compare(folder, outcome)
    assert told[0].archive.read_bytes() == before

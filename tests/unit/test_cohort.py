"""A class on the screen: table, cohort and gradebook, where nothing a student says is more than text."""

from __future__ import annotations

import csv
import io

import pytest
from classes import class_of, row, small_class
from msgspec.structs import replace
from rich.cells import cell_len

from judge.batch.cohort import cohort_of, counting
from judge.batch.gradebook import BOM, Sheet, cell, csv_text, gradebook, is_gradebook
from judge.batch.model import KeptRow, Submission, WorkerResult
from judge.batch.roster import read_students
from judge.errors import ExitCode
from judge.problem.model import Verdict
from judge.report.published_klass import Student
from judge.report.screen import Screen, drawn
from judge.report.views import view
from judge.run.result import judge_fault


def scored(student, problem, verdict="WA", score=40, at=1.0):
    file = f"{student}/{problem}-{at:g}.py"
    result = replace(judge_fault(problem, file, "why"), verdict=Verdict(verdict), score=score)
    return KeptRow(student, problem, file, "d", WorkerResult(result.as_json(), "lab1"), None, at)


class Terminal(io.StringIO):
    """A stream that a person looks at."""

    def isatty(self):
        return True


def shown(cohort, width=80, stream=None):
    """The class as it is read, without colours; whole where no terminal is given."""
    return drawn(view(cohort, screen := Screen(stream or io.StringIO(), colour=False, width=width)), screen)


@pytest.mark.parametrize("width", [40, 80, 200])
def test_thirty_students_and_twenty_problems_fit_any_screen(width):
    students = [Student(f"student-with-a-long-name-{at:02}") for at in range(30)]
    problems = [f"problem-number-{at:02}" for at in range(20)]
    rows = [scored(each.id, problem, "AC", 100) for each in students for problem in problems]
    cohort = cohort_of(students, problems, rows)
    lines = shown(cohort, width).partition("600 of 600 accepted")[0].splitlines()
    assert max(map(cell_len, lines)) <= width
    assert sum(line.count("AC 100") for line in lines) == 600
    assert all(sum(f"{at:02}" in line for line in lines) for at in range(20))
    assert sum("20 of 20  2000" in line for line in lines) == 30
    assert max(line.count("AC 100") for line in shown(cohort, None).splitlines()) == 20


def test_the_best_counts_and_the_newest_of_equals():
    rows = [
        scored("a", "p", "WA", 70),
        scored("a", "p", "JE", 0, at=3.0),
        scored("a", "p", "RTE", 70, at=2.0),
    ]
    assert counting(rows)["a", "p"] == rows[2]
    accepted = scored("a", "p", "AC", 60, at=0.5)
    assert counting([accepted, *rows])["a", "p"] == accepted
    assert cohort_of((), ("p",), (accepted, *rows)).exit_code is ExitCode.ACCEPTED
    assert cohort_of((), ("p",), rows).exit_code is ExitCode.NOT_ACCEPTED
    assert (
        cohort_of((), ("p",), (accepted,), left=[Submission("b", "p", "")]).exit_code is ExitCode.NOT_ACCEPTED
    )
    assert cohort_of((), ("p",), rows[1:2]).exit_code is ExitCode.FAULT
    assert shown(cohort_of((), (), ())) == "0 of 0 accepted, 0 students, 0 katas\n"


def test_stuck_is_the_same_mistake_twice_in_a_row_and_nothing_accepted():
    assert [(each.problem, each.what, each.students) for each in small_class().stuck] == [
        ("count", "forgotten-abs", ("bob",))
    ]
    fails = ("grid",)
    first, other = row("a", "count", "one", fails, at=1.0), row("a", "count", "two", fails, at=2.0)
    last = row("a", "count", "one", ("grid", "tangent"), at=3.0)
    assert class_of(first, other).stuck == ()
    assert class_of(other, last, history=[first]).stuck == ()
    assert len(class_of(last, history=[first]).stuck) == 1
    assert class_of(last, history=[last]).stuck == ()  # one text, judged twice
    unnamed = [row("a", "count", "", fails, file=name) for name in ("1.py", "2.py")]
    assert class_of(*unnamed).stuck == ()


@pytest.mark.parametrize("width", [40, 80, None])
@pytest.mark.parametrize("stream", [Terminal(), io.StringIO()])
def test_it_fits_the_screen_and_nothing_in_it_steers(width, stream):
    said = shown(small_class(), width, stream)
    assert "\x1b" not in said
    assert r"dee\x1b[31m王" in said
    assert "forgotten-abs" in said
    assert "judged with strong isolation on lab, 1 file" in " ".join(said.split())
    if width:
        assert max(map(cell_len, said.splitlines())) <= width
    assert all(row == row.rstrip() for row in said.splitlines())


def test_long_lists_are_folded_on_a_terminal_and_nobody_is_nothing():
    empty = class_of(problems=())
    assert (empty.students, empty.problems, empty.marks) == ((), (), {})
    fails = ("grid", "tangent")
    many = class_of(*(row(f"s{at:03}", "count", f"mistake-{at % 9}", fails) for at in range(90)))
    folded, whole = (shown(many, 80, stream).partition("kata\n")[2] for stream in (Terminal(), io.StringIO()))
    assert "  and 4 more\n" in folded
    assert "and 82 more" in folded
    assert folded.count("\n") < 20 < whole.count("\n")
    assert "more" not in whole
    assert "s089" in whole


def test_a_number_that_tells_two_of_one_name_apart_is_shown():
    lines = shown(class_of(*(row(f"Anna Schmidt ({at})", "p") for at in (4715, 4716)), problems=("p",)))
    assert [line[:18] for line in lines.splitlines()[1:3]] == ["Anna Schmi… (4715)", "Anna Schmi… (4716)"]


def test_what_is_not_judged_yet_was_submitted():
    left = [Submission("bob", "q", "bob/q.py"), Submission("ann", "q", "ann/q.py")]
    students = [Student(each) for each in ("ann", "bob", "cid")]
    cohort = cohort_of(students, ("p", "q"), [row("ann", "p")], left=left)
    assert (cohort.nothing_handed_in, cohort.nothing_accepted) == (("cid",), ())
    lines = shown(cohort).splitlines()
    assert [line.split()[:3] for line in lines[1:4]] == [
        ["ann", "AC", "90"],
        ["bob", "–", "…"],
        ["cid", "–", "–"],
    ]
    assert "… not judged yet" in lines
    assert "q  2 of 3 submitted, 0 accepted" in lines


def test_what_could_not_be_judged_was_submitted_and_says_why():
    cohort = class_of(row("ann", "p", verdict=Verdict.JE), students=[Student("ann")], problems=("p",))
    assert (cohort.nothing_handed_in, cohort.nothing_accepted) == ((), ("ann",))
    assert [why for _, why in cohort.unjudged] == ["line 1: '(' was never closed"]
    assert read(gradebook(cohort, Sheet()))[1][-1] == "p.py: line 1: '(' was never closed"


def read(content, delimiter=","):
    return list(csv.reader(io.StringIO(content.decode("utf-8-sig"), newline=""), delimiter=delimiter))


def test_a_line_a_student():
    content = gradebook(small_class(), Sheet())
    assert content.startswith(b'\xef\xbb\xbf"student","name","group","segment","count","total",')
    head, *lines = read(content)
    assert head[6:] == ["segment verdict", "segment mistake", "count verdict", "count mistake", "unread"]
    assert lines[0] == ["ann", "Ann Lee", "A", "30", "90", "120", "WA", "tangent-twice", "AC", "", ""]
    assert lines[2][3:] == ["0", "60", "60", "CE", "", "WA", "forgotten-abs", ""]
    assert lines[3][:6] == ["dee\\x1b[31m王", "王小明", "B", "60", "", "60"]
    assert lines[4] == ["eve", "<script>alert(1)</script>", "B", "", "", "0", "", "", "", "", ""]
    assert [each[0] for each in lines] == ["ann", "bob", "cid", "dee\\x1b[31m王", "eve", "zoe"]
    assert content.count(b"\r\n") == 7
    assert is_gradebook(content[:100])
    assert is_gradebook(b"\xef\xbb\xbfstudent,name,group,segment\r\n")
    assert not is_gradebook(b"name,student\r\n")
    assert (
        "\\udcff" in gradebook(class_of(students=[Student("a\udcff")]), Sheet()).decode()
    )  # half a character


@pytest.mark.parametrize(
    ("name", "shown"),
    [
        ("=1+1", "'=1+1"),
        ("@SUM(A1)", "'@SUM(A1)"),
        (" =1", " '=1"),
        ("＝1", "'＝1"),
        ('a";=cmd|x', "a\";'=cmd|x"),
        ('",=1', "\",'=1"),
        ("Anna-Maria O'Neil, Dr.", "Anna-Maria O'Neil, Dr."),
    ],
)
def test_no_cell_is_calculated(name, shown):
    assert cell(name) == shown
    content = gradebook(class_of(row("s", "count", file="=f.py"), students=[Student("s", name)]), Sheet())
    assert read(content)[1][1] == shown
    for delimiter in ",;\t":  # whatever is usual where it is opened
        assert not [
            each
            for line in read(content, delimiter)
            for each in line
            if each.lstrip(' "')[:1] in tuple("=+-@")
        ]


@pytest.mark.parametrize("sign", [",", ";", "\t"])
@pytest.mark.parametrize("end", ["\n", "\r\n"])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-16-le", "utf-16-be"])
def test_the_lists_own_columns_go_back_as_they_are(tmp_path, sign, end, encoding):
    path = tmp_path / "list.csv"
    own = [
        ["Student", "ID", "phone", "note"],
        ["    Points Possible", "", "10", "(read only)"],
        ["Byron, Ada", "7", "+49 (0)30 12-3", "-"],
        ["- Luc; Jean", "8", " -5", "a\nb"],
        ["=SUM(1)", "9", "+cmd|' /C calc'!A0", "-HYPERLINK(1)"],
    ]
    path.write_bytes(f"{'' if encoding == 'utf-8' else BOM}{csv_text(own, sign, end)}".encode(encoding))
    guarded = [*own[:4], ["'=SUM(1)", "9", "'+cmd|' /C calc'!A0", "'-HYPERLINK(1)"]]
    for numbered in (True, False):
        roster = read_students(path)
        cohort = cohort_of(roster.students, ("p", "q"), [row("7", "p")], titles=roster.titles)
        written = gradebook(cohort, roster.sheet, numbered=numbered)
        content = written.decode(encoding).encode()
        assert [cells[:4] for cells in read(content, sign)] == guarded
        assert read(content, sign)[0].count("total") == 1
        assert content.replace(b"a\nb", b"").count(end.encode()) == content.count(b"\n") - 1
        assert is_gradebook(written[:400])
        path.write_bytes(written)

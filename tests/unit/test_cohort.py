"""The cohort: which row counts, what the bars are of, who is stuck; on a screen and in a gradebook."""

from __future__ import annotations

import csv
import io

import pytest
from classes import class_of, row, small_class

from judge.batch.model import Student
from judge.report.cohort.gradebook import gradebook, is_gradebook
from judge.report.cohort.lines import cohort_lines
from judge.report.layout import cells
from judge.report.screen import Screen
from judge.report.sheet import cell


def text(width, **asked):
    """The cohort as it is read, without colours."""
    stream = io.StringIO()
    Screen(stream, colour=False, width=width).show(cohort_lines(small_class(), width, **asked))
    return stream.getvalue()


def test_stuck_is_the_same_mistake_twice_in_a_row_and_nothing_accepted():
    assert [(each.problem, each.mistake, each.students) for each in small_class().stuck] == [
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


@pytest.mark.parametrize("width", [20, 80, None])
@pytest.mark.parametrize("whole", [False, True])
def test_it_fits_the_screen_and_nothing_in_it_steers(width, whole):
    shown = text(width, whole=whole)
    assert "\x1b" not in shown
    assert r"dee\x1b[31m王" in shown.replace("\n", "").replace(" ", "")
    assert "forgotten-abs" in shown
    if width:
        assert max(map(cells, shown.splitlines())) <= width
    assert all(row == row.rstrip() for row in shown.splitlines())


def test_long_lists_are_folded_and_nobody_is_nothing():
    empty = class_of(problems=())
    assert (empty.people, empty.problems, empty.views, empty.handins) == ((), (), (), 0)
    assert list(cohort_lines(empty, 80)) == []
    fails = ("grid", "tangent")
    many = [row(f"s{at:03}", "count", f"mistake-{at % 9}", fails) for at in range(90)]
    folded = [*cohort_lines(class_of(*many), 80)]
    whole = [*cohort_lines(class_of(*many), 80, whole=True)]
    said = ["".join(span.text for span in each) for each in folded]
    assert "  and 4 more mistakes or verdicts: --all" in said
    assert any(each.endswith("and 82 more: --all") for each in said)
    assert len(folded) < 20 < len(whole)
    assert not any("--all" in span.text for each in whole for span in each)


# -- the gradebook: every cell where it belongs, and none that a spreadsheet would calculate ------------


def read(content, delimiter=","):
    return list(csv.reader(io.StringIO(content.decode("utf-8-sig"), newline=""), delimiter=delimiter))


def test_a_line_a_student():
    content = gradebook(small_class())
    assert content.startswith(b'\xef\xbb\xbf"student","name","group","segment","count","total",')
    head, *lines = read(content)
    assert head[6:] == ["segment verdict", "segment mistake", "count verdict", "count mistake"]
    assert lines[0] == ["ann", "Ann Lee", "A", "30", "90", "120", "WA", "tangent-twice", "AC", ""]
    assert lines[2][3:] == ["0", "60", "60", "CE", "", "WA", "forgotten-abs"]
    assert lines[3][:6] == ["dee\\x1b[31m王", "王小明", "B", "60", "", "60"]
    assert lines[4] == ["eve", "<script>alert(1)</script>", "B", "", "", "0", "", "", "", ""]
    assert [each[0] for each in lines] == ["ann", "bob", "cid", "dee\\x1b[31m王", "eve", "zoe"]
    assert content.count(b"\r\n") == 7
    assert is_gradebook(content[:100])
    assert is_gradebook(b"\xef\xbb\xbfstudent,name,group,segment\r\n")
    assert not is_gradebook(b"name,student\r\n")
    assert "\\udcff" in gradebook(class_of(students=[Student("a\udcff")])).decode()  # half a character


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
    content = gradebook(class_of(row("s", "count", file="=f.py"), students=[Student("s", name)]))
    assert read(content)[1][1] == shown
    for delimiter in ",;\t":  # whatever is usual where it is opened
        assert not [
            each
            for line in read(content, delimiter)
            for each in line
            if each.lstrip(' "')[:1] in tuple("=+-@")
        ]

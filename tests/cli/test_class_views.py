"""`judge class`: the cohort after the table, and the files that are written."""

from __future__ import annotations

import csv
import io
import os
import re
from datetime import datetime, timedelta
from importlib import import_module
from pathlib import Path

import pytest
from cli_support import FLOOR, MEAN
from msgspec.structs import replace

from judge.batch import classroom
from judge.batch.work import judge_task
from judge.judging.session import Session
from judge.problem import Verdict

pytestmark = pytest.mark.slow

LONG = """
def middle(a, b):
    total = a + b
    parts = [total, total, total]
    if total < 0:
        parts = [-part for part in parts]
        return -(sum(parts) / len(parts)) // 2
    bounds = (min(parts), max(parts))
    if bounds[0] != bounds[1] or len(bounds) != 2:
        raise ValueError("never")
    for part in parts:
        if part != total:
            return None
    half = sum(parts) / len(parts) // 2
    return half if half * 2 <= total else half - 1
"""
MARKUP = "<img src=x onerror=\"document.title='pwned'\">"


@pytest.fixture
def homework(submit):
    """Two students whose programs are equal but for names, a right one, one whose every name is markup."""
    submit(MEAN, "homework/ada/middle.py")
    submit(LONG, "homework/bob/middle.py")
    submit(LONG.replace("total", "s").replace("half", "h") + "# mine\n", "homework/cy/middle.py")
    submit(FLOOR, f"homework/{MARKUP}/middle.py")
    submit(f'id,name,group\nada,=1+1,a\nzoe,Zoe,"{MARKUP.replace(chr(34), chr(34) * 2)}"\n', "list.csv")
    return "homework"


def test_smallest_cases_are_kept_and_not_sought_again(judge, homework, monkeypatch):

    def pages():
        assert judge("class", homework, "--feedback", "pages").status == 1
        return {path.name: path.read_text(encoding="utf-8") for path in Path("pages").iterdir()}

    first = pages()
    assert "Smallest failing case" in first["bob.html"]
    monkeypatch.setattr(Session, "judge", None)
    assert pages() == first


def test_a_text_that_has_another_verdict_now_is_not_sought_again(judge, homework, monkeypatch):
    own = Session.judge

    def otherwise(session, source, name, on_verdict=None):
        return replace(own(session, source, name, on_verdict), verdict=Verdict.OLE)

    assert judge("class", homework).status == 1
    monkeypatch.setattr(Session, "judge", otherwise)
    assert judge("class", homework, "--feedback", "pages").status == 1
    assert "Smallest failing case" not in Path("pages/bob.html").read_text(encoding="utf-8")
    monkeypatch.setattr(Session, "judge", None)
    assert judge("class", homework, "--feedback", "pages").status == 1


def test_what_was_noted_when_a_file_was_judged_is_said_once(judge, homework, monkeypatch):
    own = Session.judge
    monkeypatch.setattr(Session, "judge", lambda *given: own(*given).noting("Waited: another judge"))
    assert "Waited" in judge("class", homework).err
    assert "Waited" not in judge("class", homework).err


def test_the_page_again_costs_nothing(judge, homework, monkeypatch):
    """No task is sent, no case is sought, one empty box tells the level, and the page stays as it is."""
    page = Path("class.html")
    assert judge("class", homework, "--html", page).status == 1
    before = page.stat().st_mtime_ns, page.read_bytes()
    took, taken = Session.take, []
    monkeypatch.setattr(Session, "take", lambda *given: taken.append(given[1]) or took(*given))
    monkeypatch.setattr(Session, "judge", None)
    days_later(monkeypatch)
    again = judge("class", homework, "--html", page)
    assert (again.status, again.err) == (1, "judge: 4 results kept from before\n")
    assert taken == [b""]
    assert (page.stat().st_mtime_ns, page.read_bytes()) == before


def test_pages_are_written_as_students_finish(judge, submit, monkeypatch):
    """Two katas each; a run that is stopped leaves the pages of those who are done, and is gone on with."""
    for who in ("ada", "bob", "cy"):
        submit(FLOOR + f"# {who}\n", f"homework/{who}/middle.py")
        submit("def line_count(:\n", f"homework/{who}/count.py")
    submit("id,name\nada,A\nbob,B\ncy,A\nzoe,Z\n", "list.csv")
    words = ("class", "homework", "--students", "list.csv", "--feedback", "pages")
    stopped = []

    def until_bob(task):
        if task.source.endswith(b"# bob\n") and not stopped:
            stopped.append(task)
            raise KeyboardInterrupt
        return judge_task(task)

    monkeypatch.setattr(classroom, "judge_task", until_bob)
    ended = judge(*words)
    assert ended.status == 130
    first = written()
    assert sorted(first) == ["ada.html", "zoe.html"]
    assert "A (ada)" in first["ada.html"][1]
    assert "Nothing was submitted." in first["zoe.html"][1]
    days_later(monkeypatch)
    assert judge(*words).status == 1
    second = written()
    assert sorted(second) == ["ada.html", "bob.html", "cy.html", "zoe.html"]
    assert {name: second[name] for name in first} == first
    submit(MEAN, "homework/bob/middle.py")
    assert judge(*words).status == 1
    assert [name for name, page in written().items() if page != second[name]] == ["bob.html"]


def days_later(monkeypatch):
    """From here on pages are made on another day."""

    class Later(datetime):
        @classmethod
        def now(cls, tz=None):
            return datetime.now(tz) + timedelta(days=2)

    monkeypatch.setattr(import_module("judge.cli.commands.class"), "datetime", Later)


def written():
    """When each page was written, and what it says."""
    pages = sorted(Path("pages").iterdir())
    return {path.name: (path.stat().st_mtime_ns, path.read_text(encoding="utf-8")) for path in pages}


def test_everything_after_the_table(judge, homework, monkeypatch):
    files = ("--csv", "grades.csv", "--html", "class.html", "--feedback", "pages")
    ended = judge("class", homework, "--students", "list.csv", *files)
    assert ended.status == 1
    shown = ended.out.split("middle  4 of 5 submitted, 1 accepted\n")[1]
    assert "floor-division" in shown
    assert "groups that fail: " in shown
    alike = "  middle  identical after removing names, spacing and comments: bob, cy\n"
    assert alike in shown
    grades = list(csv.reader(io.StringIO(Path("grades.csv").read_bytes().decode("utf-8-sig"), newline="")))
    assert grades[1][:5] == ["ada", "'=1+1", "a", "100", "100"]
    assert [each[0] for each in grades[1:]] == ["ada", "zoe", MARKUP, "bob", "cy"]
    html = Path("class.html").read_text(encoding="utf-8")
    assert "Smallest failing case" in html
    assert "middle: 4 of 5 submitted, 1 accepted" in html
    assert not re.findall(r"<img|<script", html)
    pages = {path.name: path.read_text(encoding="utf-8") for path in Path("pages").iterdir()}
    assert sorted(pages)[1:] == ["ada.html", "bob.html", "cy.html", "zoe.html"]
    assert "bob/middle.py" in pages["bob.html"]
    assert "ada" not in pages["bob.html"]
    assert not re.findall(r"<img|<script", "".join(pages.values()))
    Path("pages/bob.html").write_text("precious", encoding="utf-8")
    ended = judge("class", homework, "--feedback", "pages")
    assert "pages/bob.html: it is there already, and it is not a feedback page" in ended.err
    assert Path("pages/bob.html").read_text(encoding="utf-8") == "precious"
    assert judge("class", homework, "--students", "list.csv", *files[2:4]).status == 1
    assert Path("class.html").read_text(encoding="utf-8") == html


def test_every_member_of_a_group_gets_its_marks(judge, submit):
    """One file of two students is no copy and no equal file; that of a third one is."""
    submit(LONG, "homework/submission_1/middle.py")
    submit(LONG, "homework/submission_2/middle.py")
    submit("notes", "homework/submission_1/notes.doc")
    submit(
        "submission_1:\n  :submitters:\n  - :name: Ada L\n    :sid: '7'\n  - :name: Bob B\n    :sid: '8'\n"
        "submission_2:\n  :submitters:\n  - :name: Cy D\n    :sid: '9'\n",
        "homework/submission_metadata.yml",
    )
    submit("id,name\n7,Ada L\n8,Bob B\n9,Cy D\n", "list.csv")
    files = ("--csv", "grades.csv", "--feedback", "pages")
    ended = judge("class", "homework", "--students", "list.csv", *files)
    rows = [line.split() for line in ended.lines[1:4]]
    assert [row[:2] for row in rows] == [["7", "WA"], ["8", "WA"], ["9", "WA"]]
    assert [row[2].endswith("=") for row in rows] == [False, False, True]
    assert "identical files: 7, 8, 9" in ended.out
    assert ended.err.count("notes.doc") == 1
    grades = list(csv.reader(io.StringIO(Path("grades.csv").read_bytes().decode("utf-8-sig"), newline="")))
    assert grades[1][2:] == grades[2][2:]
    assert [each[-1][:9] for each in grades[1:]] == ["notes.doc", "notes.doc", ""]
    assert sorted(path.name for path in Path("pages").iterdir()) == ["7.html", "8.html", "9.html"]
    Path("homework/submission_2/middle.py").unlink()
    assert "equal files" not in judge("class", "homework").out


def test_days_late_weights_and_numbers_for_names(judge, submit):
    """A list of a platform's own: its columns go on, and a note stands on the student's page."""
    submit(MEAN, "homework/Ada Lovelace_11_assignsubmission_file/middle.py")
    submit(FLOOR, "homework/Bob Byron_12_assignsubmission_file/middle.py")
    submit("x", "homework/Bob Byron_12_assignsubmission_file/essay.docx")
    submit(
        "Identifier,Full name,note,extra days\nParticipant 11,Ada Lovelace,Well done.,1\n"
        "Participant 12,Bob Byron,,\nParticipant 13,Cy Doe,,\n",
        "list.csv",
    )
    for path in Path("homework").rglob("middle.py"):
        os.utime(path, (1_800_000_000 + 90_000,) * 2)  # 25 hours late
    due = datetime.fromtimestamp(1_800_000_000).strftime("%Y-%m-%dT%H:%M:%S")[:16]
    files = ("--csv", "grades.csv", "--html", "class.html", "--feedback", "pages")
    words = ("--students", "list.csv", "--due", due, "--weight", "middle=3", "--anonymous", *files)
    ended = judge("class", "homework", *words)
    assert ended.status == 1
    assert not re.findall("Ada|Bob|Byron", ended.out)
    head, *grades = csv.reader(io.StringIO(Path("grades.csv").read_bytes().decode("utf-8-sig"), newline=""))
    assert head == [
        *("Identifier", "Full name", "note", "extra days", "number", "middle", "total", "late days"),
        *("middle verdict", "middle mistake", "unread"),
    ]
    assert grades[0][:8] == ["Participant 11", "Ada Lovelace", "Well done.", "1", "1", "100", "100", "1"]
    assert grades[1][4:10] == ["2", "40", "40", "2", "WA", "floor-division"]
    assert grades[1][10] == "essay.docx: not a program, by its name"
    assert grades[2][:8] == ["Participant 13", "Cy Doe", "", "", "3", "", "0", "0"]
    pages = {path.name: path.read_text(encoding="utf-8") for path in Path("pages").iterdir()}
    assert sorted(pages) == ["1.html", "2.html", "3.html"]
    assert not re.findall("Ada|Bob|Byron", "".join(pages.values()) + Path("class.html").read_text())
    assert "Well done." in pages["1.html"]
    assert "1 day late" in pages["1.html"]
    assert "essay.docx: not a program" in pages["2.html"]
    assert "Nothing was submitted." in pages["3.html"]
    assert "'middle=x' is not a weight" in judge("class", "homework", "--weight", "middle=x").err
    assert "--json has names" in judge("class", "homework", "--anonymous", "--json").err


def test_a_platforms_late_stays_and_a_day_ends_at_its_last_second(judge, submit):
    submit(MEAN, "homework/lovelaceada_LATE_101_555_middle.py")
    submit(FLOOR, "homework/byronbob_102_556_middle.py")
    submit(FLOOR, "homework/doecy_103_557_middle.py")
    for name, when in (("lovelaceada_LATE_101_555", "10T12:00"), ("byronbob_102_556", "10T23:59:58")):
        second = datetime.fromisoformat(f"2026-11-{when}").timestamp()
        os.utime(f"homework/{name}_middle.py", (second, second))
    ended = judge("class", "homework", "--due", "2026-11-10")
    signs = {line.split()[0]: line.split()[2][-1] for line in ended.lines[1:4]}
    assert [who for who, sign in signs.items() if sign == "l"] == ["doecy", "lovelaceada"]
    assert "'' is not a time" in judge("class", "homework", "--due", "").err


def test_a_name_that_fits_two_of_the_list_is_told(judge, submit):
    submit(MEAN, "homework/ada/middle.py")
    submit(MEAN, "homework/ADA/middle.py")
    submit("name\nAda\nADA\n", "list.csv")
    ended = judge("class", "homework", "--students", "list.csv")
    assert [line.split()[0] for line in ended.lines[1:4]] == ["Ada", "ADA", "ada?"]
    assert ended.err == "judge: 'ada' fits ADA and Ada: write this name into a column 'id' of the list\n"


def test_numbers_for_names_hide_file_names_too(judge, submit):
    submit(FLOOR, "canvas/lovelaceada_101_555_middle.py")
    submit("x", "canvas/lovelaceada_101_556_notes.pdf")
    Path("canvas/byronbob_102_557_middle.py").symlink_to("lovelaceada_101_555_middle.py")
    os.link("canvas/lovelaceada_101_555_middle.py", "canvas/doecy_103_558_middle.py")
    submit(FLOOR, "katas/middle/ada.py")
    submit("x", "katas/middle/ada.pdf")
    submit("x", "katas/middle/bob/notes.doc")
    submit("x", "katas/lovelace.doc")
    for folder, told in (("canvas", "notes.pdf: not a program"), ("katas", "2: not a program")):
        files = ("--html", f"{folder}.html", "--feedback", f"{folder}-pages")
        ended = judge("class", folder, "--anonymous", *files)
        pages = [Path(f"{folder}.html"), *sorted(Path(f"{folder}-pages").iterdir())]
        assert len(pages) == 4
        said = [page.read_text(encoding="utf-8") for page in pages]
        for shown in (ended.out, ended.err, *said):
            assert not re.findall("lovelace|byron|doecy|\\b(ada|bob|cy)\\b", shown, re.IGNORECASE)
        assert told in ended.out


def test_pages_in_the_class_and_weights_of_nothing_are_told(judge, submit):
    submit(MEAN, "homework/ada/middle.py")
    ended = judge("class", "homework", "--feedback", "homework/pages")
    assert (ended.status, Path("homework/pages").exists()) == (2, False)
    assert "--feedback: pages in the class's folder would be read" in ended.err
    said = judge("class", "homework", "--weight", "segment=2", "--weight", "middle=0").err.splitlines()
    assert said == [
        "judge: --weight segment: it is not in the table",
        "judge: --weight: all weights are 0, and so is every total",
    ]


def test_a_kata_of_one_level_is_judged_whole(judge, submit):
    submit(MEAN, "homework/ann/middle.py")
    ended = judge("class", "homework", "--level", "interview")
    assert (ended.status, ended.lines[-1].split()[-2:]) == (0, ["1", "accepted"])

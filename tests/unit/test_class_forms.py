"""What learning platforms hand out: made-up samples of each form, with the tool, its version and the page.

Moodle 4.x and 5.x     mod/assign/downloader.php, grading worksheet (its source)
Canvas                 content_zipper.rb, gradebook_exporter.rb (its source, 2026)
Brightspace            Import and export grades (its documentation); names as others' readers take them
Blackboard             Work offline with grade data (its documentation); names as others' readers take them
Gradescope             Export submissions (its guide); metadata as others' readers take it
"""

from __future__ import annotations

import io
import json
import zipfile
from datetime import datetime
from pathlib import Path

import pytest

from judge.batch.folder import read_class
from judge.batch.roster import read_students

PROBLEMS = [Path(__file__).parents[1] / "fixtures" / "pack" / "problems"]
MEAN = "def middle(a, b):\n    return (a + b) / 2\n"

MOODLE = (
    "\ufeffIdentifier,Full name,Email address,Status,Grade,Maximum grade\r\n"
    "Participant 4711,Ada Lovelace,ada@uni.example,Submitted for grading,,10.00\r\n"
    "Participant 4712,Bob O'Brien,bob@uni.example,Submitted for grading,,10.00\r\n"
)
CANVAS = (
    "Student,ID,SIS Login ID,Section,HW 1 (77)\n,,,,Manual Posting\n    Points Possible,,,,10.00\n"
    '"Lovelace, Ada",101,alove,Section 1,8.00\n"Ødegård, Bo",102,bo,Section 1,\n'
)
BRIGHTSPACE = (
    "OrgDefinedId,Username,Last Name,First Name,End-of-Line Indicator\n"
    "#7001,#alove,Lovelace,Ada,#\n#7002,#bobo,Brien,Bob,#\n"
)
BLACKBOARD = '"Last Name","First Name","Username"\n"Lovelace","Ada","alove"\n"Brien","Bob","bob.brien"\n'
GRADESCOPE = (
    "First Name,Last Name,SID,Email\nAda,Lovelace,7001,ada@uni.example\nBob,Brien,7002,b@uni.example\n"
)
METADATA = (
    "submission_77:\n  :submitters:\n  - :name: Ada Lovelace\n    :sid: '7001'\n    :email: ada@uni.example\n"
    "submission_78:\n  :submitters:\n  - :name: Bob Brien\n"
    "  :created_at: 2026-11-20 18:05:00.123456789 +02:00\n"
    "  :results:\n    tests:\n    - :name: A test\n...\n---\n"
    "submission_79:\n  :submitters:\n  - :name: Ada Lovelace\n    :sid: '7001'\n  - :name: ''\n"
    "    :email: b@uni.example\n  - :name: Cy Doe\n  :score: 1\n  :history:\n  - :name: 'Old\n'\n"
)
PLAIN = "First name,Last name,Email address\nAda,Lovelace,alove@uni.example\nAda,Byron,byron@uni.example\n"


@pytest.fixture
def place(tmp_path, monkeypatch):
    monkeypatch.delenv("JUDGE_PROBLEMS", raising=False)
    return tmp_path / "class"


def read(place, roster, names, encoding="utf-8"):
    """Whose each file is, and for what, with a list of the students or without."""
    for name in names:
        path = place / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(METADATA if name.endswith(".yml") else MEAN)
    students = None
    if roster:
        path = place.with_name("list.csv")
        path.write_bytes(roster.encode(encoding))
        students = read_students(path)
    return read_class(place, folders=PROBLEMS, roster=students)


@pytest.mark.parametrize(
    ("roster", "names", "whose"),
    [
        (
            MOODLE,
            [
                "Ada Lovelace_4711_assignsubmission_file/sub/middle.py",
                "Bob OBrien_4712_assignsubmission_file_/middle.py",
            ],
            ["Ada Lovelace", "Bob O'Brien"],
        ),
        (MOODLE, ["Ada Lovelace_4711_assignsubmission_file_middle.py"], ["Ada Lovelace"]),
        (MOODLE, ["Participant_4712_assignsubmission_file/middle.py"], ["Bob O'Brien"]),
        (
            CANVAS,
            [
                "lovelaceada_101_555_middle.py",
                "degrdbo_LATE_102_556_middle-1.py",
                "stranger_999_557_middle.py",
            ],
            ["101", "102", "stranger"],
        ),
        (CANVAS, ["anon_x7Kp2_555_middle.py", "LATE_anon_q_556_middle.py"], ["q", "x7Kp2"]),
        (
            BRIGHTSPACE,
            [
                "9001-42 - Ada Lovelace - Nov 20, 2026 612 PM/middle.py",
                "9002-42 - 7002 Brien - 20 November 2026 612 PM/middle.py",
                "index.html",
            ],
            ["7001", "7002"],
        ),
        (
            BLACKBOARD,
            [
                "HW 1_alove_attempt_2026-11-20-10-15-00_middle.py",
                "HW 1_alove_attempt_2026-11-20-10-15-00.txt",
                "HW 1_bob.brien_poging_2026-11-20-10-15-00_middle.py",
            ],
            ["Brien", "Lovelace"],
        ),
        (
            GRADESCOPE,
            [
                "assignment_9_export/submission_metadata.yml",
                "assignment_9_export/submission_77/middle.py",
                "assignment_9_export/submission_78/middle.py",
            ],
            ["Ada", "Bob"],
        ),
        (
            GRADESCOPE,
            ["submission_metadata.yml", "submission_79/middle.py"],
            ["Ada", "Bob", "Cy Doe"],
        ),
        (PLAIN, ["ada lovelace/middle.py", "Byron/middle.py"], ["Byron", "Lovelace"]),
        (PLAIN, ["alove/middle.py", "Byron, Ada/middle.py"], ["Byron", "Lovelace"]),
        ("", ["Ada Lovelace_4711_assignsubmission_file/middle.py"], ["Ada Lovelace"]),
        (
            "",
            [
                "Anna Schmidt_4715_assignsubmission_file/middle.py",
                "Anna Schmidt_4716_assignsubmission_file/middle.py",
                "Participant_4717_assignsubmission_file/middle.py",
            ],
            ["Anna Schmidt (4715)", "Anna Schmidt (4716)", "Participant"],
        ),
        (PLAIN, ["ada/middle.py", "x_1_2_y/middle.py", "bob/middle.py"], ["ada", "bob", "x_1_2_y"]),
    ],
)
def test_whose_a_file_is(place, roster, names, whose):
    found = read(place, roster, names)
    assert [(each.student, each.problem) for each in found.submissions] == [
        (each, "middle") for each in whose
    ]


def test_blackboards_text_about_a_submission_is_left_out_unless_it_is_all_there_is(place):
    ada, bob = (f"HW 1_{who}_attempt_2026-11-20-10-15-00" for who in ("alove", "bob.brien"))
    names = [f"gradebook_HW 1/{name}" for name in (f"{ada}.txt", f"{ada}_middle.py", f"{bob}.txt")]
    found = read(place, BLACKBOARD, names)
    assert [each.file for each in found.submissions] == [names[1]]
    assert [each.file for each in found.unplaced] == [names[2]]


def test_late_is_shown_as_the_platform_tells_it(place):
    found = read(place, CANVAS, ["lovelaceada_LATE_101_555_middle.py", "degrdbo_102_556_middle.py"])
    assert found.late == {"101"}


@pytest.mark.parametrize(
    ("name", "second"),
    [
        ("HW 1_alove_attempt_2026-11-20-18-05-00_middle.py", "2026-11-20T18:05"),
        ("9001-42 - Ada Lovelace - Nov 20, 2026 605 PM/middle.py", "2026-11-20T18:05"),
        ("9001-42 - Ada Lovelace - 20 November 2026 112 AM/middle.py", "2026-11-20T01:12"),
        ("submission_78/middle.py", "2026-11-20T18:05+02:00"),
        ("9001-42 - Ada Lovelace - 20. Mai 2026 1805/middle.py", ""),
        ("lovelaceada_101_555_middle.py", ""),
    ],
)
def test_the_platforms_time_counts_where_it_says_one(place, name, second):
    names = ["submission_metadata.yml"] if name.startswith("submission") else []
    (found,) = read(place, "", [*names, name]).submissions
    own = (place / name).stat().st_mtime
    assert found.at == (datetime.fromisoformat(second).timestamp() if second else own)


def test_moodles_status_says_who_is_late(place):
    status = "Submitted for grading - 1 day 2 hours late - Graded"
    read(
        place,
        MOODLE.replace("bob@uni.example,Submitted for grading", f"bob@uni.example,{status}"),
        ["a/b.py"],
    )
    assert [each.late for each in read_students(place.with_name("list.csv")).students] == [False, True]


def test_a_list_in_utf_16_whose_rows_of_a_platform_are_no_students(place):
    found = read(place, CANVAS, ["lovelaceada_101_555_middle.py"], "utf-16")
    assert [each.student for each in found.submissions] == ["101"]
    roster = read_students(place.with_name("list.csv"))
    assert [(each.id, each.name) for each in roster.students] == [
        ("101", "Lovelace, Ada"),
        ("102", "Ødegård, Bo"),
    ]
    assert roster.titles == ("Student", "ID", "SIS Login ID", "Section", "HW 1 (77)")
    assert roster.students[0].cells == ("Lovelace, Ada", "101", "alove", "Section 1", "8.00")


def test_who_stands_in_a_team_of_somebody_else_keeps_the_own_folder(place):
    teams = "name,team,mentor\nAda,cy,\nCy,ben,Ada\nBen,ada,\n"
    found = read(place, teams, ["Ada/middle.py", "ben/middle.py", "cy/middle.py"])
    assert [each.student for each in found.submissions] == ["Ada", "Ben", "Cy"]


def test_two_whom_a_name_fits_are_not_chosen_between(place):
    twins = "Name,Login\nAda Byron,ada1\nAda Byron,ada2\n"
    found = read(place, twins, ["Ada Byron/middle.py", "ada2/middle.py"])
    assert [each.student for each in found.submissions] == ["Ada Byron", "ada2"]


# -- programs inside of something else -----------------------------------------------------------------------


def zipped(files, links=()):
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w") as archive:
        for name, text in files.items():
            info = zipfile.ZipInfo(name)
            info.external_attr = (0o120777 if name in links else 0o100644) << 16
            archive.writestr(info, text)
    return content.getvalue()


def test_a_zip_a_notebook_and_spoilt_names_are_read(place):
    for name in ("ada", "bob", "cy", "dee"):
        (place / name).mkdir(parents=True)
    (place / "ada" / "homework.zip").write_bytes(
        zipped({"hw/middle.py": MEAN, "__MACOSX/x": "", "l.py": "/"}, ["l.py"])
    )
    cells = [
        {"cell_type": "markdown", "source": ["# Middle"]},
        {"cell_type": "code", "source": ["%matplotlib inline\n", "import math"]},
        {"cell_type": "code", "source": MEAN},
    ]
    (place / "bob" / "middle.ipynb").write_text(json.dumps({"cells": cells}))
    (place / "cy" / "middle.PY").write_text(MEAN)
    (place / "dee" / "middle.py.txt").write_text(MEAN)
    found = read_class(place, folders=PROBLEMS)
    assert [(each.student, each.file) for each in found.submissions] == [
        ("ada", "ada/homework.zip/hw/middle.py"),
        ("bob", "bob/middle.py"),
        ("cy", "cy/middle.py"),
        ("dee", "dee/middle.py"),
    ]
    assert found.submissions[1].source == b"import math\n\n" + MEAN.encode()
    assert all(each.problem == "middle" and not each.why for each in found.submissions)


@pytest.mark.parametrize(
    ("name", "content", "why"),
    [
        ("a.zip", zipped({"a.py": b"#" * (3 << 20)}), "3 MB is more than 2 MB"),
        ("a.zip", zipped({f"{at}.py": "" for at in range(101)}), "101 files are more than 100"),
        ("a.zip", zipped({"inner.zip": zipped({"middle.py": MEAN})}), "no program is in this zip"),
        ("a.zip", b"PK\x03\x04 broken", "this zip cannot be opened"),
        ("a.ipynb", b"{}", "this notebook cannot be read"),
    ],
)
def test_what_stays_unread_says_why(place, name, content, why):
    (place / "ada").mkdir(parents=True)
    (place / "ada" / name).write_bytes(content)
    (left_out,) = read_class(place, folders=PROBLEMS).unplaced
    assert left_out.student == "ada"
    assert left_out.why.startswith(why)

"""The files that `judge run` and its likes write: JUnit XML, tests that keep a failing case."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree as Xml

import pytest
from cli_support import FLOOR, MEAN

pytestmark = pytest.mark.slow


@pytest.fixture
def team(submit):
    """A folder of a wrong submission and a right one."""
    submit(FLOOR, "team/b.py")
    submit(MEAN, "team/a.py")
    return "team"


@pytest.mark.parametrize("form", ["editor", "text"])
def test_a_file_is_written_with_every_format(form, judge, team):
    ended = judge("run", "middle", team, "--format", form, "--junit", "out.xml")
    assert ended.status == 1
    root = Xml.parse("out.xml").getroot()
    assert [suite.get("name") for suite in root] == ["middle team/a.py", "middle team/b.py"]
    assert [suite.get("failures") for suite in root] == ["0", "2"]
    assert judge("run", "middle", "team/a.py", "--junit", "out.xml").status == 0  # its own file, again
    assert len(Xml.parse("out.xml").getroot()) == 1


def test_what_the_submission_prints_and_returns_cannot_break_it(judge, submit):
    source = "import sys\ndef middle(a, b):\n    print(']]></testsuite>')\n    return '\\x08]]>\\ud800<'\n"
    judge("run", "middle", submit(source), "--junit", "out.xml")
    (failure, _, _) = Xml.parse("out.xml").getroot().iter("failure")
    assert r"the str '\x08]]>\ud800<' where a number" in failure.get("message")


# -- a test that holds a file ----------------------------------------------------------------------------


KEPT = """from pathlib import Path

from judge.testing import check_case


def test_kept():
    check_case({!r}, Path(__file__).parent / "mine.py")
"""


def run_pytest(name):
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", name]
    environment = {key: value for key, value in os.environ.items() if not key.startswith("PYTEST")}
    return subprocess.run(command, capture_output=True, text=True, timeout=60, env=environment)


def test_a_kept_case_fails_until_the_submission_is_right(judge, submit):
    result = json.loads(judge("run", "middle", submit(FLOOR, "mine.py"), "--json").out)
    Path("test_kept.py").write_text(KEPT.format(result["counterexample"]["replay"]))
    assert "1 failed" in run_pytest("test_kept.py").stdout
    submit(MEAN, "mine.py")
    assert run_pytest("test_kept.py").returncode == 0


# -- files that no transcript can hold -------------------------------------------------------------------


def refused(ended, *words):
    assert ended.status == 2, ended
    assert ended.out == ""
    assert ended.err.count("\n") == 1, ended.err
    assert ended.err.startswith("judge: ")
    for word in words:
        assert word in ended.err


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["run", "middle", "a\0b"], "no such file"),
        (["start", "middle", "a\0b"], "cannot be written"),
        (["start", "middle", "x" * 3000], "cannot be written (file name too long)"),
        (["new", "pack", "a" * 300], "cannot be written (file name too long); name another folder"),
    ],
)
def test_a_name_no_file_can_have(words, told, judge, submit):
    judge("run", "middle", submit(MEAN), "-q")
    refused(judge(*words), told)
    assert [path.name for path in Path().iterdir()] == ["mine.py"]


def test_a_file_too_large_to_be_a_program(judge, submit):
    refused(judge("run", "middle", submit(b"#" * (5 * 2**20))), "larger than 4 MB")


@pytest.mark.skipif(os.geteuid() == 0, reason="needs another user than root")
def test_what_may_not_be_read(judge, submit):
    Path(submit(MEAN)).chmod(0)
    refused(judge("run", "middle", "mine.py"), "cannot be read (permission denied)", "check its permissions")
    folder = Path(submit(MEAN, "team/mine.py")).parent
    folder.chmod(0)
    try:
        refused(judge("run", "middle", "team"), "team: cannot be read (permission denied)")
    finally:
        folder.chmod(0o755)


@pytest.mark.skipif(os.geteuid() == 0, reason="needs another user than root")
@pytest.mark.parametrize(
    ("words", "told"),
    [
        ("run middle mine.py --junit closed/out", "closed/out: cannot be written"),
        ("new closed/pack mine", "cannot be written (permission denied)"),
    ],
)
def test_a_folder_that_may_not_be_written_is_told_of_before_anything_is_done(words, told, judge, submit):
    judge("run", "middle", submit(MEAN), "-q")
    Path("closed").mkdir(mode=0o555)
    refused(judge(*words.split()), told)

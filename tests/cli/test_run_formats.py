"""`judge run --format` and `--junit`."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree as Xml

import pytest
from cli_support import BROKEN, FLOOR, MEAN, ROOT


def kinds(ended) -> list[str]:
    return [line.split(" ", 1)[0] for line in ended.lines]


def test_text_is_what_there_is_without_a_format(judge, submit):
    name = submit(FLOOR)
    first = judge("run", "middle", name, "--no-shrink").lines
    assert judge("run", "middle", name, "--no-shrink", "--format", "text").lines[:-1] == first[:-1]


def test_json_is_the_same_by_both_names(judge, submit):
    name = submit(FLOOR)
    for words in (["--format", "json"], ["--json", "--format", "json"], ["--json"]):
        ended = judge("run", "middle", name, *words)
        assert (ended.status, json.loads(ended.out)["verdict"]) == (1, "WA")


@pytest.mark.parametrize("form", ["text", "github"])
def test_contradicting_formats_are_refused(form, judge, submit):
    ended = judge("run", "middle", submit(MEAN), "--json", "--format", form)
    assert (ended.status, ended.out) == (2, "")
    assert f"--json and --format {form} contradict each other; leave one out" in ended.err


def test_annotations_and_nothing_else(judge, submit):
    submit(FLOOR, "team/b.py")
    submit(MEAN, "team/a.py")
    submit("def middle(a, b)\n", "team/c.py")
    ended = judge("run", "middle", "team", "--format", "github", "-q")
    assert (ended.status, ended.err) == (1, "")
    assert kinds(ended) == ["::notice", "::error", "::error"]
    assert ended.lines[0].startswith("::notice file=team/a.py,line=1,title=middle%3A AC::AC  accepted")
    assert "file=team/c.py,line=1,col=17,title=middle%3A CE" in ended.lines[2]


def test_an_exception_is_annotated_at_its_own_line(judge, submit):
    name = submit("def middle(a, b):\n    c = a\n    return c / 0\n")
    ended = judge("run", "middle", name, "--format", "github")
    assert "line=3,title=middle%3A RTE in examples%2C case 1::" in ended.out


@pytest.mark.parametrize("form", ["json", "github", "text"])
def test_a_file_is_written_with_every_format(form, judge, submit):
    submit(FLOOR, "team/b.py")
    submit(MEAN, "team/a.py")
    ended = judge("run", "middle", "team", "--format", form, "--junit", "out.xml")
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


def test_a_broken_problem_is_an_error_for_each_submission(judge, submit):
    submit(MEAN, "team/a.py")
    submit(MEAN, "team/b.py")
    words = ("run", "misspelt-key", "team", "--problems", BROKEN, "--junit", "out.xml")
    ended = judge(*words)
    assert (ended.status, ended.out) == (3, "")
    root = Xml.parse("out.xml").getroot()
    assert [suite.get("errors") for suite in root] == ["1", "1"]
    assert "problem.toml" in next(root.iter("error")).get("message")
    ended = judge(*words, "--format", "github")
    assert (ended.status, kinds(ended)) == (3, ["::error", "::error"])


@pytest.mark.parametrize(
    ("place", "wanted"),
    [
        ("mine.py", "it is there already and is no JUnit XML"),
        ("nowhere/out.xml", "its folder does not exist"),
        (".", "it is a folder"),
        ("/dev/null", "it is no ordinary file"),
    ],
)
def test_a_file_that_cannot_be_meant_is_refused_before_anything_is_judged(place, wanted, judge, submit):
    name = submit(MEAN)
    ended = judge("run", "middle", name, "--junit", place)
    assert (ended.status, ended.out) == (2, "")
    assert f"{place}: {wanted}" in ended.err
    assert Path(name).read_text() == MEAN


def test_a_wrong_use_leaves_the_last_file_alone(judge, submit):
    name = submit(MEAN)
    judge("run", "middle", name, "--junit", "out.xml")
    before = Path("out.xml").read_bytes()
    assert judge("run", "middel", name, "--junit", "out.xml").status == 2
    assert Path("out.xml").read_bytes() == before


def test_only_who_asks_for_xml_imports_it(submit, judge):
    name = submit(MEAN)
    judge("run", "middle", name)
    script = (
        "import sys\nfrom judge.cli import main\n"
        f"sys.argv = ['judge', 'run', 'middle', {name!r}]\n"
        "try:\n    main()\nexcept SystemExit:\n    pass\n"
        "print('xml.etree' in sys.modules, file=sys.stderr)\n"
    )
    command = [sys.executable, "-c", script]
    settings = {**os.environ, "PYTHONPATH": str(ROOT)}
    ended = subprocess.run(command, capture_output=True, text=True, timeout=60, check=True, env=settings)
    assert ended.stderr.split() == ["False"]

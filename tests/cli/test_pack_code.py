"""Which commands run the code of a pack, and which do so once at most. The manual says the same."""

from __future__ import annotations

import io
import json
import re
import shutil
import sys

import pytest
from cli_support import FLOOR, MEAN, PACK
from sampling import daily

from judge.cli.table import COMMANDS
from judge.manual import page

pytestmark = pytest.mark.slow

READ = {  # those that read what is kept of it, in the ways that could make a difference
    "list": ["list --json"],
    "show": ["show middle", "show middle --groups"],
    "start": ["start middle new.py", "start middle other.py --reset", "start"],
    "hint": ["hint middle --all"],
    "progress": ["progress", "progress --due"],
    "drill": ["drill"],
    "history": ["history middle", "history --json"],
    "new": ["new problems/fresh-kata"],
    "doctor": ["doctor"],
    "help": ["help pack of katas", "help --schema run"],
}
RUN_IT = {
    "run": "run middle mine.py -q",
    "try": "try {id} mine.py",
    "hack": "hack middle 1,2",
    "class": "class homework",
    "solution": "solution middle --give-up --times",
    "export": "export middle --out made --format files",
    "verify": "verify middle",
    "quiz": "quiz counts",
    "interview": "interview halves --kata middle",
}
BY_DAY = ("try", "export")
MARKING = """
import os
with open(os.environ["MARK"], "a") as mark:
    mark.write("{} ran\\n")
"""
COUNTS = 'title = "S"\n[[cards]]\nid = "a"\nform = "count"\nfront = "F?"\nback = "B."\nproblem = "middle"\n'
META = "Metadata-Version: 2.1\nName: marking\nVersion: 1\n"


@pytest.fixture
def mark(tmp_path, monkeypatch):
    """The file that the packs' code writes to."""
    path = tmp_path / "mark"
    monkeypatch.setenv("MARK", str(path))
    monkeypatch.setenv("JUDGE_CACHE", str(tmp_path / "cache"))
    return path


@pytest.fixture
def practised(judge, mark, submit, tmp_path, monkeypatch):
    """`middle`, whose problem.py leaves a mark: a current kata with a history, and no data in the cache.

    The id of a case that fails.
    """
    shutil.copytree(PACK, tmp_path / "pack")
    module = tmp_path / "pack" / "problems" / "middle" / "problem.py"
    module.write_text(module.read_text().replace("from __future__ import annotations\n", f"{MARKING}", 1))
    toml = module.with_name("problem.toml")
    rule = '[time]\nlimit = 1000\nfunction = "mean.py"\n\n'  # there are times to measure
    toml.write_text(toml.read_text().replace("[tolerance]", f"{rule}[tolerance]", 1))
    (module.parents[1] / "quiz" / "counts.toml").write_text(COUNTS)
    monkeypatch.setenv("JUDGE_PROBLEMS", str(tmp_path / "pack" / "problems"))
    for source, name in ((MEAN, "mine.py"), (FLOOR, "floor.py"), (FLOOR, "homework/ada/middle.py")):
        submit(source, name)
    for words in ("start middle other.py", "hint middle"):
        judge(*words.split())
    run = judge("run", "middle", "floor.py", "--json")
    shutil.rmtree(tmp_path / "cache" / "data")
    mark.unlink()
    return json.loads(run.out)["counterexample"]["replay"]


def test_a_problem_is_run_when_it_is_first_read(judge, practised, mark, tmp_path):
    shutil.rmtree(tmp_path / "cache")
    assert judge("list").status == 0
    mark.unlink()
    assert judge("list").status == 0
    assert not mark.exists()


def test_these_commands_only_read_it(judge, practised, mark):
    assert {*READ, *RUN_IT, "site"} == set(COMMANDS)  # which has a test of its own
    more = ["solution middle --give-up", "hack middle"]
    for words in (*(each for ways in READ.values() for each in ways), *more):
        assert judge(*words.split()).status == 0, words
        assert not mark.exists(), words


@pytest.mark.parametrize("command", daily(RUN_IT, BY_DAY))
def test_these_commands_run_it(command, judge, practised, mark, monkeypatch):
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(b"?\n" * 3)))
    ended = judge(*RUN_IT[command].format(id=practised).split())
    assert ended.status in ((0, 1, 3) if command == "verify" else (0, 1)), ended
    assert mark.exists()


def test_completion_only_reads(practised, mark, process, tmp_path):
    shutil.rmtree(tmp_path / "cache")
    asked = {"_JUDGE_COMPLETE": "bash_complete", "COMP_WORDS": "judge run mid", "COMP_CWORD": "2"}
    assert "middle" in process(**asked).out
    assert not mark.exists()


@pytest.fixture
def installed_pack(mark, tmp_path, monkeypatch):
    """An installed pack whose package leaves a mark when it is imported, on the import path."""
    site = tmp_path / "site"
    shutil.copytree(PACK / "problems" / "middle", site / "marking" / "mark-middle")
    (site / "marking" / "__init__.py").write_text(MARKING)
    (site / "marking-1.dist-info").mkdir()
    (site / "marking-1.dist-info" / "METADATA").write_text(META)
    (site / "marking-1.dist-info" / "entry_points.txt").write_text("[judge.problems]\nmarking = marking\n")
    monkeypatch.syspath_prepend(str(site))
    yield
    sys.modules.pop("marking", None)


@pytest.mark.parametrize(
    ("words", "imported"),
    [
        ("list", True),
        ("show nothing-like-it", True),
        ("run middle mine.py", False),
        ("doctor", True),
        ("--help", False),
    ],
)
def test_an_installed_pack_is_imported_where_its_name_is_looked_up(
    words, imported, judge, submit, installed_pack, mark
):
    submit(MEAN)
    ended = judge(*words.split())
    assert ended.status == (2 if "nothing" in words else 0), ended
    assert mark.exists() == imported


def test_the_manual_names_the_same_commands():
    readme = " ".join(page("sandbox").text.split())
    (told,) = re.findall(r"runs with your rights when you use ([^.]*)\.", readme)
    assert set(re.findall(r"`(?:judge )?(\w+)`", told)) == {*RUN_IT, "start", "site"}
    assert "docker run --init" in readme

"""What was shown is in the history, whenever the judge is killed."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from cli_support import FLOOR, MEAN, ROOT
from sampling import daily, nightly

from judge.kata.history import History

pytestmark = pytest.mark.slow

TEAM = {f"team/{number:02}.py": (MEAN, FLOOR)[number % 2] + f"# {number}\n" for number in range(8)}
FORMATS = {  # and what a line of each says of a submission
    "json": lambda line: json.loads(line)["submission"],
    "github": lambda line: (
        "team" + line.partition("file=team")[2].partition(",")[0] if "file=" in line else None
    ),
    "text": lambda line: line.split()[1] if line[4:].startswith("team/") else None,
}


def killed(form: str, db: Path, after: int) -> list[str]:
    """Judge the team and kill the judge as soon as so many are shown; all that were shown."""
    words = ["run", "middle", "team", "-j", "3", "--format", form, "--db", str(db)]
    quick = ["--no-shrink", "--no-name", "--isolation", "limits"]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    shown = []
    with subprocess.Popen(
        [sys.executable, "-m", "judge", *words, *quick], stdout=subprocess.PIPE, text=True, env=environment
    ) as running:
        assert running.stdout is not None
        for line in running.stdout:  # to the end: what had been written before the kill was shown too
            name = FORMATS[form](line)
            if name:
                shown.append(name)
            if len(shown) == after:
                running.kill()
    assert len(shown) >= after
    return shown


@pytest.mark.parametrize("form", daily(FORMATS, ("text",)))
def test_a_judge_that_is_killed_has_kept_what_it_has_shown(form, submit, tmp_path):
    for name, source in TEAM.items():
        submit(source, name)
    for after in (1, 5):
        db = tmp_path / f"{after}.sqlite3"
        shown = killed(form, db, after)
        with History.open(db) as history:
            kept = {run.submission: history.source(run.id).decode() for run in history.runs()}
        assert {name: kept.get(name) for name in shown} == {name: TEAM[name] for name in shown}


@pytest.mark.parametrize("words", [nightly(["--json"]), []])
def test_watch_has_kept_what_it_has_shown(words, submit, own_history):
    quick = ["--no-shrink", "--no-name", "--isolation", "limits"]
    command = [sys.executable, "-m", "judge", "watch", "middle", submit(FLOOR), *words, *quick]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    with subprocess.Popen(command, stdout=subprocess.PIPE, env=environment) as running:
        assert running.stdout is not None
        assert running.stdout.readline()
        running.kill()
    with History.open() as history:
        assert [run.verdict.value for run in history.runs()] == ["WA"]


def test_a_hint_that_was_shown_counts_as_seen():
    reading, writing = os.pipe()
    os.close(reading)  # showing it is the last thing that happens
    words = [sys.executable, "-m", "judge", "hint", "middle"]
    ended = subprocess.run(words, stdout=writing, stderr=subprocess.PIPE, cwd=ROOT, timeout=60, check=False)
    os.close(writing)
    assert ended.returncode == 141
    with History.open() as history:
        assert history.hints_seen("middle") == 1

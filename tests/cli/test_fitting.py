"""`judge run FILE` and its likes where two problems fit a file, and what stands in a file's way."""

from __future__ import annotations

import json
import os
import shutil

import pytest
from cli_support import FLOOR, MEAN


@pytest.fixture
def twice(tmp_path, monkeypatch):
    """A second problem with the entry function `middle`, called other-middle, in a folder of its own."""
    folder = tmp_path / "more" / "other-middle"
    shutil.copytree(f"{os.environ['JUDGE_PROBLEMS']}/middle", folder)
    (folder / "hashes.json").unlink(missing_ok=True)
    monkeypatch.setenv("JUDGE_PROBLEMS", f"{os.environ['JUDGE_PROBLEMS']}:{folder.parent}")


def problem_of(ended):
    return [json.loads(line)["problem"] for line in ended.lines]


def test_two_that_fit_are_named_and_how_to_choose(judge, submit, twice):
    submit(MEAN)
    ended = judge("run", "mine.py")
    assert (ended.status, ended.out) == (2, "")
    assert ended.err == (
        "judge: mine.py: this file fits middle and other-middle; 'judge run middle mine.py' takes the first\n"
    )
    submit('"""other-middle: A stub."""\n' + MEAN, "stub.py")
    assert problem_of(judge("run", "stub.py", "--json")) == ["other-middle"]
    submit(MEAN, "other_middle.py")
    assert problem_of(judge("run", "other_middle.py", "--json")) == ["other-middle"]
    judge("init", "other-middle", "mine.py", "--force")  # the kata in hand decides
    submit(MEAN)
    assert problem_of(judge("run", "mine.py", "--json")) == ["other-middle"]


@pytest.mark.parametrize("word", ["middle.py", "middle"])
def test_fresh_cases_are_for_a_file_alone_and_a_problem_alone_too(word, judge, submit):
    submit(FLOOR, "middle.py")
    ended = judge("stress", word, "--for", "5s", "--seed", "1", "--no-name", "--no-shrink", "--json")
    assert (ended.status, json.loads(ended.out)["submission"]) == (1, "middle.py")

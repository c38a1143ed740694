"""A kata and a language are added in the steps that CONTRIBUTING tells, as they stand there."""

from __future__ import annotations

import json
import re
import shutil
from dataclasses import replace

import pytest
from walk import ROOT, WALKS, changed, claims_hold, go, steps

from judge.kata.begin import begin_kata

PAGE = ROOT / WALKS[1][0]


@pytest.fixture(scope="module")
def walk():
    if not PAGE.exists():
        pytest.skip("not part of a source distribution")
    return steps(PAGE.read_text(encoding="utf-8"), WALKS[1][1])


def test_a_kata_is_added_as_told(walk, tmp_path):
    taken = go(walk, tmp_path)
    claims_hold(taken)
    assert [each.status for each in taken] == [0, 0, 0, 1, 0]
    pinned = tmp_path / "problems" / "two-points" / "hashes.json"
    assert "far-together" in json.loads(pinned.read_text(encoding="utf-8"))["groups"]


@pytest.mark.nightly
def test_a_fault_in_a_step_is_noticed(walk, tmp_path):
    """The other way round: were the page wrong, the test above would say so."""
    spoilt = [
        replace(step, text=step.text.replace("apart = 9", "apart = 900")) if step.is_change else step
        for step in walk
    ]
    with pytest.raises(AssertionError, match="does not show as told"):
        claims_hold(go(spoilt, tmp_path))


@pytest.fixture
def language():
    if not PAGE.exists():
        pytest.skip("not part of a source distribution")
    if shutil.which("perl") is None:
        pytest.skip("no perl here: apt-get install perl")
    name, title = WALKS[3]
    return steps((ROOT / name).read_text(encoding="utf-8"), title)


def test_a_language_is_added_as_told(language, tmp_path):
    taken = go(language, tmp_path)
    claims_hold(taken)
    assert [each.status for each in taken] == [0, 0, 1, 0, 1, 0, 1]
    files = sorted(path.name for path in (tmp_path / "languages").iterdir())
    assert files == ["perl.py", "perl.toml"]


@pytest.mark.nightly
def test_a_fault_in_the_added_driver_is_noticed(language, tmp_path):
    spoilt = [replace(step, text=step.text.replace("'%.17g'", "'%.3g'")) for step in language]
    with pytest.raises(AssertionError, match="does not show as told"):
        claims_hold(go(spoilt, tmp_path))


def test_a_change_that_does_not_fit_is_noticed():
    assert changed("a = 1\nb = 2\n", " a = 1\n-b = 2\n+b = 3\n") == "a = 1\nb = 3\n"
    for text in ("a = 1\n", "b = 2\nb = 2\n"):
        with pytest.raises(AssertionError, match="does not fit"):
            changed(text, "-b = 2\n+b = 3\n")


def test_every_file_of_a_kata_is_told(walk, tmp_path):
    page = PAGE.read_text(encoding="utf-8")
    begin_kata(tmp_path, "mine")
    for path in tmp_path.rglob("*"):
        if path.is_file():
            assert f"`{path.name}`" in page or f"`{path.parent.name}/*.py`" in page, path


def test_every_path_that_is_told_is_there():
    page = PAGE.read_text(encoding="utf-8")
    told = set(re.findall(r"`((?:judge|tests|problems|solutions)/[^`<>*\s]+)`", page))
    own = {path for path in told if not re.search(r"two-points|<id>", path)}
    assert len(own) > 30
    assert [path for path in sorted(own) if not (ROOT / path).exists()] == []
    assert "(../judge/manual/problem-toml.md)" in page

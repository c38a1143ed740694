"""A kata and a language are added in the steps that CONTRIBUTING tells, as they stand there."""

from __future__ import annotations

import json
import re
import shutil

import pytest
from walk import ROOT, WALKS, claims_hold, go, steps

from judge.packs.begin import begin_kata

PAGE = ROOT / WALKS[1][0]
pytestmark = pytest.mark.skipif(not PAGE.exists(), reason="not part of a source distribution")


@pytest.fixture
def page():
    return PAGE.read_text(encoding="utf-8")


@pytest.mark.nightly
def test_a_kata_is_added_as_told(page, tmp_path):
    taken = go(steps(page, WALKS[1][1]), tmp_path)
    claims_hold(taken)
    assert [each.status for each in taken] == [0, 0, 0, 1, 0]
    pinned = tmp_path / "problems" / "two-points" / "pins.json"
    assert "law-of-cosines" in json.loads(pinned.read_text(encoding="utf-8"))["far-together"]["kills"]


@pytest.mark.nightly
@pytest.mark.skipif(shutil.which("perl") is None, reason="perl is not installed")
def test_a_language_is_added_as_told(page, tmp_path):
    taken = go(steps(page, WALKS[3][1]), tmp_path)
    claims_hold(taken)
    assert [each.status for each in taken] == [0, 0, 1, 0, 1, 0, 1]
    files = sorted(path.name for path in (tmp_path / "languages").glob("*/*"))
    assert files == ["driver.pl", "language.toml"]


def test_every_file_and_path_that_is_told_is_there_and_every_file_of_a_kata_is_told(page, tmp_path):
    begin_kata(tmp_path, "mine")
    for path in tmp_path.rglob("*"):
        if path.is_file():
            assert f"`{path.name}`" in page or f"`{path.parent.name}/*.py`" in page, path
    told = set(re.findall(r"`((?:judge|tests|problems|solutions)/[^`<>*\s]+)`", page))
    own = {path for path in told if not re.search(r"two-points|<id>", path)}
    assert len(own) > 20
    assert [path for path in sorted(own) if not (ROOT / path).exists()] == []

"""`judge report`: where the page goes, what it must not overwrite, and what the command says."""

from __future__ import annotations

import io
import json
import re
import sys
from pathlib import Path

import pytest
from cli_support import FLOOR, MEAN

USUAL = Path("judge-report.html")


@pytest.fixture
def judged(judge, submit):
    """A history of two runs: the floor, then the mean."""
    assert judge("run", "middle", submit(FLOOR), "--no-shrink").status == 1
    assert judge("run", "middle", submit(MEAN)).status == 0


def test_it_writes_the_page_and_says_where(judge, judged):
    ended = judge("report")
    assert (ended.status, ended.out, ended.err) == (0, "judge-report.html\n", "")
    page = USUAL.read_text(encoding="utf-8")
    assert "solved on" in page
    assert "floor-division" in page
    assert "yours, 1 ×" in page  # in the kill matrix
    assert "(a + b) / 2" in page  # the last source
    assert USUAL.stat().st_mode & 0o777 == 0o644
    assert [path.name for path in Path().iterdir() if path.suffix == ".tmp"] == []


def tiles(page):
    """The figures at the head of the page, by their label."""
    return dict(re.findall(r"<dt>(.*?)</dt><dd>(.*?)</dd></div>", page))


def test_cards_alone_are_reported(judge, monkeypatch):
    monkeypatch.setattr(sys, "stdin", io.StringIO("0\n"))
    assert judge("quiz", "--card", "middle/complex-roots").status == 0
    monkeypatch.setattr(sys, "stdin", io.StringIO("?\n"))
    assert judge("quiz", "--card", "senior/cull-ratio").status == 0
    ended = judge("report", "--json")
    assert (ended.status, ended.err) == (0, "")
    assert (json.loads(ended.out)["runs"], json.loads(ended.out)["problems"]) == (0, [])
    page = USUAL.read_text(encoding="utf-8")
    assert tiles(page)["answers to cards known"] == "1 of 2"
    assert not any("run" in label for label in tiles(page))
    assert 'id="ready"' in page


def test_a_problem_whose_own_solution_was_judged_alone_has_no_matrix(judge, pack, submit):
    own = pack / "solutions" / "middle"
    assert judge("run", "middle", str(own / "accepted" / "mean.py")).status == 0
    assert judge("report").status == 0
    assert "Kill matrix" not in USUAL.read_text(encoding="utf-8")
    assert judge("run", "middle", submit(FLOOR), "--no-shrink").status == 1
    assert judge("report").status == 0
    assert "Kill matrix" in USUAL.read_text(encoding="utf-8")


def test_it_may_be_made_again_and_is_the_same(judge, judged, monkeypatch):
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1800000000")
    assert judge("report").status == 0
    first = USUAL.read_bytes()
    assert judge("report").status == 0
    assert USUAL.read_bytes() == first
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "soon")
    assert "$SOURCE_DATE_EPOCH: 'soon' is no time" in judge("report").err


def test_what_is_no_report_is_not_overwritten(judge, judged):
    USUAL.write_text("<!doctype html><title>precious</title>")
    ended = judge("report")
    assert ended.status == 2
    assert ended.err == (
        "judge: judge-report.html: it is there already and is no report; "
        "name another file with --out, or overwrite it with --force\n"
    )
    assert "precious" in USUAL.read_text()
    assert judge("report", "--force").status == 0
    assert "precious" not in USUAL.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("words", "wanted"),
    [
        (["--out", "nowhere/page.html"], "its folder does not exist; make the folder first"),
        (["--out", "."], "it is a folder; name a file with --out"),
        (["--out", "/dev/null", "--force"], "it is no ordinary file"),
        (["--out", "x" * 300], "cannot be written (file name too long)"),
        (["--db", "empty.sqlite3"], "empty.sqlite3: there is nothing to report; judge something first"),
    ],
)
def test_what_cannot_be_done(judge, judged, words, wanted):
    ended = judge("report", *words)
    assert ended.status == 2
    assert ended.out == ""
    assert wanted in ended.err
    assert ended.err.count("\n") == 1
    assert not Path("empty.sqlite3").exists()


def test_a_problem_that_cannot_be_read_any_more(judge, judged, tmp_path):
    (tmp_path / "pack" / "broken").mkdir(parents=True)
    (tmp_path / "pack" / "broken" / "problem.toml").write_text("title = 1")
    ended = judge("report", "--problems", "pack")
    assert ended.status == 0
    assert "a problem is left out: broken/problem.toml:1: " in ended.err
    assert USUAL.exists()

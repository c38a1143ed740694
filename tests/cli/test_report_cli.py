"""`judge report`: where the page goes, what it must not overwrite, and what the command says."""

from __future__ import annotations

from pathlib import Path

import pytest
from cli_support import FLOOR, MEAN

pytestmark = pytest.mark.slow

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
    assert "1 of 38" in page
    assert "floor-division" in page
    assert "overcome" in page
    assert "(a + b) / 2" in page  # the accepted source
    assert USUAL.stat().st_mode & 0o777 == 0o644
    assert [path.name for path in Path().iterdir() if path.suffix == ".tmp"] == []


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


def test_a_problem_that_cannot_be_read_any_more(judge, judged, tmp_path):
    (tmp_path / "pack" / "broken").mkdir(parents=True)
    (tmp_path / "pack" / "broken" / "problem.toml").write_text("title = 1")
    ended = judge("report", "--problems", "pack")
    assert ended.status == 0
    assert "a problem is left out: broken/problem.toml:1: " in ended.err
    assert USUAL.exists()

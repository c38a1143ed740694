"""Measuring language beside language: what the figures are made of, and how they are shown."""

from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path

import pytest
from foreign_boxes import Paper
from judging import make_data

from judge.report.bench import bench_lines, ns, remarks
from judge.report.page.bench import is_bench_page, render_bench
from judge.run import bench as engine
from judge.run.bench import Bench, Entrant, Row, Spread, bench

GOLDEN = Path(__file__).parents[1] / "golden" / "bench"
WHEN = datetime(2026, 1, 2, tzinfo=UTC)
PYTHON = Entrant("quadratic.py", b"", "Python")
GO = Entrant("reference.go", b"", "Go")
RUST = "no rustc (apt-get install rustc)"
MINE = Entrant("mine.go", b"", "Go", own=True)


@pytest.fixture
def measured(monkeypatch):
    """Measure boxes on paper, by the names of their files, on four cases."""
    monkeypatch.setattr(engine, "_bare_start", lambda: 0.01)
    monkeypatch.setattr("judge.run.laps.MOST_INPUT", 1 << 13)  # what is never long enough ends soon

    def run(boxes, rounds=3, tell=None):
        class Entered(dict):
            def __call__(self, source, name):
                return self[name]

        data = make_data("one")
        entrants = [Entrant(name, b"", "Go") for name in boxes]
        return bench(data, data.groups, entrants, Entered(boxes), rounds, tell)

    return run


def lines_of(found, width=80):
    return ["".join(span.text for span in each) for each in bench_lines(found, width)]


def test_a_case_is_the_slope_and_neither_the_start_nor_the_first_pass(measured):
    warm = Paper(lambda passes: 0.004 * passes + (0.1 if passes else 0.0), start=0.06)
    plain = Paper(lambda passes: 0.002 * passes, start=0.06)
    found = measured({"plain.go": plain, "warm.go": warm})
    first, second = found.rows
    assert first.seconds.median == pytest.approx(0.002 / 4)
    assert second.seconds.median == pytest.approx(0.004 / 4)
    assert second.ratio.median == pytest.approx(2.0)
    assert (first.first.median, second.first.median) == pytest.approx((0.002 / 4, 0.104 / 4))
    assert second.start.median == pytest.approx(6.0)
    assert (found.cases, found.rounds, found.wanted, found.interrupted) == (4, 3, 3, False)
    assert second.passes * 0.004 >= engine.LONG_SECONDS
    assert (first.wrong, second.wrong) == (0, 0)


def test_what_answers_wrongly_is_measured_and_said(measured):
    found = measured(
        {"plain.go": Paper(lambda passes: 0.002 * passes), "bad.go": Paper(lambda n: 0.1 * n, wrong=0)}
    )
    assert [row.wrong for row in found.rows] == [0, 4]
    assert found.rows[1].ratio.median == pytest.approx(50)
    assert list(remarks(found)) == [("Go", "it answers 4 cases wrongly")]


def test_what_fails_has_no_figures_and_the_others_have(measured):
    boxes = {
        "plain.go": Paper(lambda passes: 0.002 * passes),
        "broken.go": Paper(lambda passes: 0.0, fault="no semicolon"),
        "fat.go": Paper(lambda passes: 0.002 * passes, bad=1),
    }
    found = measured(boxes)
    assert [row.why_not for row in found.rows] == [
        "",
        "it does not compile: no semicolon",
        "stopped: used more than 256 MB",
    ]
    assert [row.seconds is None for row in found.rows] == [False, True, True]


def test_nothing_short_is_divided_by(measured):
    found = measured({"none.go": Paper(lambda passes: 0.0), "plain.go": Paper(lambda passes: 0.002 * passes)})
    assert found.rows[1].ratio is None
    assert found.rows[0].seconds.median == 0


def test_an_interruption_keeps_the_rounds_that_are_whole(measured):
    class Impatient(Paper):
        def run_whole(self, stdin, limits):
            if len(self.runs) > 12:
                raise KeyboardInterrupt
            return super().run_whole(stdin, limits)

    told = []
    boxes = {"a.go": Paper(lambda n: 0.4 * n), "b.go": Impatient(lambda n: 0.4 * n)}
    found = measured(boxes, rounds=99, tell=lambda *words: told.append(words))
    assert found.interrupted
    assert 0 < found.rounds < 99
    assert all(row.seconds for row in found.rows)
    assert "interrupted" in lines_of(found)[0]
    assert told[0] == ("Go, getting ready", 0, 200)


def test_an_interruption_before_the_first_round(measured):
    class Never(Paper):
        def run_whole(self, stdin, limits):
            raise KeyboardInterrupt

    found = measured({"a.go": Never(lambda n: 1.0)})
    assert (found.rounds, found.rows[0].seconds) == (0, None)
    assert lines_of(found)[-1].endswith("not measured: it was interrupted before")


def spread(median, wide=0.05):
    return Spread(median, median * (1 - wide), median * (1 + wide))


def sample():
    """A benchmark of four programs and two that were not measured."""

    def row(entrant, seconds, first, start, **more):
        figures = map(spread, (seconds, seconds / 4.5e-6, first, start))
        return Row(entrant, *figures, 9 << 20, 40, **more)

    rows = (
        row(PYTHON, 4.5e-6, 4.8e-6, 1.0),
        row(Entrant("reference.cpp", b"", "C++"), 0.84e-6, 1.0e-6, 0.11),
        row(GO, 1.4e-6, 1.6e-6, 0.16),
        row(Entrant("reference.java", b"", "Java"), 5.4e-6, 48e-6, 6.4),
        row(MINE, 63e-6, 64e-6, 0.16, wrong=3),
        Row(Entrant("reference.rs", b"", "Rust", missing=RUST), why_not=RUST),
        Row(Entrant("old.c", b"", "C", own=True), why_not="it does not compile: no semicolon (line 3)"),
    )
    return Bench("segment", 875, 7, 7, spread(0.0103), rows, "full")


@pytest.mark.parametrize("width", [80, 50])
def test_the_screen_is_as_it_was(width):
    path = GOLDEN / f"screen-{width}.txt"
    assert "\n".join(lines_of(sample(), width)) + "\n" == path.read_text(encoding="utf-8")
    assert all(len(each) <= width for each in lines_of(sample(), width))
    assert width < 80 or len(lines_of(sample(), width)) <= 24  # a terminal's


def test_the_page_is_whole_and_escapes_what_it_is_given_and_one_of_nothing_says_why():
    own = Entrant("<b>.go", b"", "Go", own=True)
    rows = (*sample().rows[:4], Row(own, spread(1e-6), spread(0.2), spread(2e-6), spread(0.2)))
    found = Bench("segment", 875, 5, 7, None, rows, "full")
    page = render_bench(found, WHEN)
    text = page.decode()
    assert is_bench_page(page)
    assert not is_bench_page(b"<!doctype html><html>")
    assert "5 of 7 rounds, interrupted" in text
    assert "&lt;b&gt;.go" in text
    assert "<b>" not in text
    assert text.count('class="spread') == 5
    assert text.count("first pass: ") == 5
    assert render_bench(found, WHEN) == page
    nothing = Bench("segment", 875, 0, 7, None, sample().rows[-2:], "full")
    text = render_bench(nothing, WHEN).decode()
    assert "not measured here: no rustc (apt-get install rustc)" in text
    assert "<svg" not in text


@pytest.mark.parametrize(
    ("duration", "shown"),
    [(4.553e-6, "4,550"), (8.44e-8, "84"), (9.996e-7, "1,000"), (1e-12, "< 1"), (0, "< 1")],
)
def test_nanoseconds(duration, shown):
    assert ns(duration) == shown

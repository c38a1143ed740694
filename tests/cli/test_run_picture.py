from __future__ import annotations

import xml.etree.ElementTree as ElementTree

import pytest
from cli_support import FLOOR, ROOT
from test_run_screen import on_a_terminal

pytestmark = pytest.mark.slow

ALWAYS_ONE = "def line_count(cx, cy, r, A, B):\n    return 1\n"
RIGHT = ROOT / "solutions" / "count" / "accepted" / "exact.py"
WHERE = ("--problems", str(ROOT / "problems"), "--group", "grid")


def braille(text):
    return [letter for letter in text if "\u2800" < letter <= "\u28ff"]


def test_the_failing_case_is_drawn_into_a_file(judge, submit, tmp_path):
    words = ("run", "count", submit(ALWAYS_ONE), "--svg", "case.svg", *WHERE)
    titles = []
    for options in ((), ("--no-shrink",), ("--json",), ("--quiet",)):
        ended = judge(*words, *options)
        assert ended.status == 1
        assert not braille(ended.out)  # nobody is looking
        titles.append(ElementTree.parse(tmp_path / "case.svg").getroot()[0].text)
    name = "Line and circle: how many common points"
    assert titles[0] == titles[2] == titles[3] == f"{name} – counterexample"
    assert titles[1].startswith(f"{name} – grid, case")


def test_a_file_that_is_no_svg_is_left_alone(judge, submit, tmp_path):
    (tmp_path / "notes.txt").write_text("mine")
    ended = judge("run", "count", submit(ALWAYS_ONE), "--svg", "notes.txt", *WHERE)
    assert ended.status == 2
    assert ended.err == "judge: notes.txt: it is there already and is no SVG; name another file with --svg\n"
    assert (tmp_path / "notes.txt").read_text() == "mine"


@pytest.mark.parametrize("target", [".", "nowhere/case.svg"])
def test_a_place_that_takes_no_file_is_refused(target, judge, submit):
    ended = judge("run", "count", submit(ALWAYS_ONE), "--svg", target, *WHERE)
    assert ended.status == 2
    assert len(ended.err.splitlines()) == 1


def test_it_draws_one_submission(judge, submit):
    submit(ALWAYS_ONE, "a/one.py")
    submit(ALWAYS_ONE, "a/two.py")
    ended = judge("run", "count", "a", "--svg", "case.svg", *WHERE)
    assert (ended.status, "name one FILE" in ended.err) == (2, True)


def test_nothing_is_written_where_nothing_is_to_be_drawn(judge, submit, tmp_path):
    ended = judge("run", "count", RIGHT, "--svg", tmp_path / "case.svg", *WHERE)
    assert ended.status == 0
    assert "nothing to draw" in ended.err
    other = judge("run", "middle", submit(FLOOR), "--svg", tmp_path / "case.svg")
    assert (other.status, "nothing to draw" in other.err) == (1, True)
    assert not (tmp_path / "case.svg").exists()


@pytest.mark.parametrize(("columns", "drawn"), [(59, False), (60, True), (100, True)])
def test_a_terminal_that_is_wide_enough_shows_it(columns, drawn, submit, tmp_path):
    submit(ALWAYS_ONE)
    words = ("run", "count", tmp_path / "mine.py", "--picture", *WHERE)
    status, written = on_a_terminal(*words, columns=columns, NO_COLOR="1")
    assert status == 1
    assert bool(braille(written)) is drawn
    assert ("o wanted" in written) is drawn
    assert written.splitlines()[-1].startswith("WA  ") or "WA  wrong answer" in written.split("o wanted")[-1]
    assert all(len(line) <= columns for line in written.splitlines() if " judge replay " not in line)


def test_the_smallest_case_is_seen_with_its_picture(submit):
    """On a terminal of 24 rows, the last of which the shell's prompt takes."""
    submit(ALWAYS_ONE)
    for words in (["--picture"], ["--all"]):
        status, written = on_a_terminal("run", "count", "mine.py", *words, *WHERE, NO_COLOR="1")
        assert status == 1
        below = written[written.index("  smallest case found") :].splitlines()
        assert sum(-(-max(len(row), 1) // 80) for row in below) <= 23
        assert braille("".join(below))


@pytest.mark.parametrize(("rows", "drawn"), [(24, False), (40, True)])
def test_a_tall_terminal_shows_it_unasked(rows, drawn, submit):
    submit(ALWAYS_ONE)
    status, written = on_a_terminal("run", "count", "mine.py", *WHERE, rows=rows, NO_COLOR="1")
    assert (status, bool(braille(written))) == (1, drawn)
    assert len(written.splitlines()) < rows
    assert ("--picture" in written) is not drawn


def test_a_terminal_without_the_characters_does_without(submit, tmp_path):
    submit(ALWAYS_ONE)
    status, written = on_a_terminal(
        "run", "count", tmp_path / "mine.py", *WHERE, PYTHONIOENCODING="latin-1", PYTHONUTF8="0"
    )
    assert status == 1
    assert "u28" not in written

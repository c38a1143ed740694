"""`judge start` on a real terminal: saves, keys, a terminal that is given back as it was."""

from __future__ import annotations

import os
import re
import shutil
import signal
import termios
import time
from pathlib import Path

import pytest
from cli_support import FLOOR, MEAN
from terminals import PATIENCE, Terminal

from judge.practice.events import Help, Run
from judge.practice.history import History
from judge.problem import Verdict
from judge.problem.find import sound_problems
from judge.problem.model import Mode

pytestmark = pytest.mark.slow

HOME, REST = "\x1b[H", "\x1b[J"
LAST_KEY = "q quit"


class Watching(Terminal):
    """`judge start`, which draws one picture over the other."""

    @property
    def frame(self):
        """What is seen: the last whole picture, without the sequences that place it."""
        if HOME not in self.written:
            return ""
        last = self.written.rsplit(HOME, 1)[1]
        if REST not in last:
            return ""
        return re.sub("\x1b\\[[?0-9]*[a-zA-Z]", "", last.split(REST, 1)[0]).replace("\r\n", "\n")

    def sees(self, *words, without=()):
        """Wait until the picture has all these words; its lines but the keys."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            whole = self.frame.endswith(LAST_KEY)
            if whole and all(word in self.frame for word in words):
                assert not [word for word in without if word in self.frame]
                return self.frame.rstrip().splitlines()[:-1]
            assert self.read(), self.written
        raise AssertionError(f"no {words} in:\n{self.frame}")

    def begins(self):
        """Wait until it judges the file for the first time."""
        while "judging mine.py" not in self.written:
            assert self.read()

    def leaves(self, key="q", status=0):
        """Ask it to end, and see that the terminal is given back."""
        if isinstance(key, str):
            self.press(key)
        else:
            os.kill(self.process.pid, key)
        assert self.ends() == status
        assert termios.tcgetattr(self.ours) == self.before
        assert "Traceback" not in self.written


@pytest.fixture
def watch():
    open_ones = []

    def start(*words, rows=30):
        open_ones.append(Watching("start", *words, rows=rows, NO_COLOR="1"))
        return open_ones[-1]

    yield start
    for terminal in open_ones:
        terminal.__exit__()


def last(lines):
    """The last line that is not empty, where the verdict belongs."""
    return [line for line in lines if line.strip()][-1]


def test_every_save_is_judged_and_the_verdict_is_last(watch, submit, tmp_path):
    terminal = watch("middle", submit(FLOOR))
    lines = terminal.sees("WA  Wrong answer")
    assert lines[0] == "WA  Wrong answer  mine.py"
    assert last(lines).startswith("WA  21 of 52 cases pass, 40 of 100 points")
    submit(MEAN)
    lines = terminal.sees("AC  Accepted")
    assert last(lines).startswith("AC  all 52 cases pass")
    terminal.leaves()
    for picture in terminal.written.split("\x1b[?2026h")[1:]:  # in one write, which clears nothing first
        assert picture.startswith(HOME)
        assert "\x1b[?2026l" in picture
    assert "\x1b[2J" not in terminal.written
    with History() as history:
        assert [run.verdict.value for run in history.runs("middle")] == ["WA", "AC"]
        assert [each.path for each in history.places()] == [str(tmp_path / "mine.py")]


def test_a_file_is_replaced_deleted_and_written_in_pieces(watch, submit, tmp_path):
    mine = tmp_path / submit(FLOOR)
    terminal = watch("middle", mine)
    terminal.sees("WA  Wrong answer")
    submit(MEAN, "new")
    (tmp_path / "new").rename(mine)  # as many editors save
    terminal.sees("AC  Accepted")
    mine.unlink()
    assert last(terminal.sees("is gone")) == "mine.py is gone; it is judged again when it is back"
    mine.write_text("def middle(a, b):\n    return (a +")
    assert last(terminal.sees("Does not compile")).startswith("CE  nothing was run")
    assert "picture" not in terminal.frame  # of no case
    mine.write_text("")
    terminal.sees("is empty; it is judged when there is something in it")
    with mine.open("a") as file:
        for piece in (FLOOR[:20], FLOOR[20:]):
            file.write(piece)
            file.flush()
    terminal.sees("WA  Wrong answer")
    terminal.leaves()


def test_the_keys(watch, submit):
    terminal = watch("middle", submit(FLOOR))
    terminal.sees("WA  Wrong answer")
    terminal.press("h")
    assert terminal.sees("hint 1 of 3")[0].startswith("Half of what?")
    terminal.press("h")
    assert last(terminal.sees("hint 2 of 3")).startswith("WA  ")
    terminal.press("l")
    assert last(terminal.sees("first-steps", "of 38 katas")).startswith("WA  ")
    terminal.press("s")
    assert last(terminal.sees("half-way between a and b")).startswith("WA  ")
    terminal.press("p")
    assert last(terminal.sees("There is no failing case to draw.")).startswith("WA  ")
    terminal.press("e")
    assert last(terminal.sees("There is no page for middle yet")).startswith("WA  ")
    terminal.press("x")
    terminal.sees("Press x again.")
    terminal.press("\x1b[A%")  # an arrow where there are no pages, and a key that means nothing
    terminal.press("n")
    assert last(terminal.sees("Not solved yet. Press n again to skip it.")).startswith("WA  ")
    terminal.press("\n")
    terminal.sees("Smallest failing case", without=["again to skip"])
    terminal.leaves("Q")
    with History() as history:
        assert max(each.hints for each in history.events(Help, "middle")) == 2
        assert len(history.runs("middle")) == 1


def test_what_is_long_is_read_in_pages(watch, tmp_path):
    terminal = watch("segment", rows=24)
    terminal.sees("Created segment.py")
    for key, page in (
        ("s", 1),
        (" ", 2),
        ("\x1b[6~", 3),
        (" ", 4),
        (" ", 4),
        ("b", 3),
        ("b", 2),
        ("\x1b[A", 1),
        ("b", 1),
    ):
        terminal.written = ""
        terminal.press(key)
        lines = terminal.sees(f"statement, page {page} of 4")
        assert lines[0].startswith("segment  Circle and segment   ")
        assert len(lines) < 24
    assert terminal.frame.endswith("space more   b back   Enter result   q quit")
    terminal.press("\n")
    terminal.sees("Created segment.py")
    terminal.leaves()


def test_the_model_is_shown_once_the_kata_is_solved(watch, submit):
    terminal = watch("middle", submit(FLOOR))
    terminal.sees("WA  Wrong answer")
    terminal.press("m")
    terminal.sees("Solve it first, or give up: judge solution --give-up")
    submit(MEAN)
    terminal.sees("m  the model: ", "You  2 runs, no hint; 2 lines, the model has 2")
    assert "h hint" not in terminal.frame
    terminal.press("h")
    terminal.sees("Solved. m shows the model solution.")
    terminal.press("m")
    lines = terminal.sees("yours")
    assert lines.count("def middle(a, b):") == 2
    terminal.leaves()
    with History() as history:
        assert not [*history.events(Help, "middle")]


ACCEPTED = {"submission": "a.py", "path": "", "verdict": Verdict.AC, "score": 100, "mode": Mode.FUNCTION}
ACCEPTED |= {"mistake": None, "ratio": None, "passed": (), "failed": (), "source_hash": "0", "packed": b""}


def test_going_on_begins_the_next_kata_beside_this_one(watch, submit, pack, tmp_path):
    shutil.copytree(pack / "problems", tmp_path / "problems")
    shutil.copytree(pack / "problems" / "middle", tmp_path / "problems" / "mid-twin")
    for name in ("middle", "mid-twin"):
        file = tmp_path / "problems" / name / "problem.toml"
        file.write_text(f'sets = ["path"]\n{file.read_text()}')
    with History() as history:
        for kata in sound_problems()[0]:
            if kata.id != "middle":
                history.keep(Run(problem=kata.id, **ACCEPTED))
    terminal = watch("middle", submit(MEAN), "--problems", "problems")
    terminal.sees("AC  Accepted")
    terminal.press("n")
    lines = terminal.sees("Created mid_twin.py. Open it in your editor.")
    assert lines[0] == "mid-twin  The middle"
    begun = tmp_path / "mid_twin.py"
    with History() as history:
        assert history.places()[0].path == str(begun)
    begun.write_text(MEAN)
    terminal.sees("AC  Accepted")
    terminal.press("n")
    assert last(terminal.sees("All other katas are solved.")).startswith("AC  ")
    terminal.leaves()


@pytest.mark.parametrize(
    ("ending", "status"),
    [("\x03", 130), (signal.SIGTERM, 143)],
)
def test_the_terminal_is_given_back_however_it_ends(ending, status, watch, submit):
    terminal = watch("middle", submit(MEAN))
    terminal.sees("AC  Accepted")
    terminal.leaves(ending, status)
    busy = watch("middle", submit(SLEEPS))
    busy.begins()
    busy.leaves(ending, status)


def test_it_is_drawn_anew_after_a_resize_and_after_it_was_stopped(watch, submit):
    terminal = watch("middle", submit(MEAN))
    assert not [row for row in terminal.sees("AC  Accepted", "katas") if row.startswith("[#.........]")]
    terminal.written = ""
    terminal.resize(64, 24)
    assert [row for row in terminal.sees("AC  Accepted", "katas") if row.startswith("[#.........]")]
    taken = termios.tcgetattr(terminal.ours)
    os.kill(terminal.process.pid, signal.SIGSTOP)
    termios.tcsetattr(terminal.ours, termios.TCSANOW, terminal.before)  # as a shell does then
    terminal.written = ""
    os.kill(terminal.process.pid, signal.SIGCONT)
    terminal.sees("AC  Accepted")
    assert termios.tcgetattr(terminal.ours) == taken != terminal.before
    terminal.leaves()


def test_an_accepted_save_is_told_where_the_history_cannot_be_read(watch, submit):
    terminal = watch("middle", submit(FLOOR))
    terminal.sees("WA  Wrong answer")
    kept = Path(os.environ["JUDGE_DB"])
    kept.rename(kept.with_name("elsewhere"))
    kept.mkdir()
    submit(MEAN)
    lines = terminal.sees("AC  Accepted")
    assert last(lines).startswith("AC  all 52 cases pass")
    terminal.press("s")
    terminal.sees("half-way between a and b")
    terminal.leaves()


SLEEPS = "import time\ndef middle(a, b):\n    time.sleep(999)\n"


def test_a_save_gives_up_the_run_of_what_stood_there_before(watch, submit):
    """Every call of it would wait for the wall limit; nothing is told or kept of it."""
    terminal = watch("middle", submit(SLEEPS))
    terminal.begins()
    submit(MEAN)
    terminal.sees("AC  Accepted")
    assert "TLE" not in terminal.written
    terminal.leaves()
    with History() as history:
        assert [run.verdict.value for run in history.runs("middle")] == ["AC"]


def test_the_first_kata_of_a_project_is_in_a_folder_of_its_own(watch, tmp_path):
    (tmp_path / ".git").mkdir()
    terminal = watch(rows=24)
    terminal.sees("Created katas/distance_squared.py. Open it in your editor.")
    (tmp_path / "katas" / "distance_squared.py").write_text("def distance_squared(P, Q):\n    return 1\n")
    terminal.sees("Wrong answer  katas/distance_squared.py")
    terminal.leaves()


def test_a_new_kata_is_shown_before_it_is_judged_and_started_over(watch, tmp_path):
    terminal = watch("which-side", rows=24)
    lines = terminal.sees("Created which_side.py. Open it in your editor.")
    assert lines[0].startswith("which-side  Which side of the line")
    assert lines[0].endswith("first steps, kata 2 of 6")
    assert any("Write which_side(A, B, P)" in row and row.endswith("  P") for row in lines), (
        "its figure is beside"
    )
    assert any(row.endswith("    true scale") for row in lines)
    assert "stand at A and" in " ".join(" ".join(lines).split())
    assert last(lines).strip() == "Write the function, then save. I judge it on every save."
    assert len(lines) < 24
    mine = tmp_path / "which_side.py"
    stub = mine.read_text()
    mine.write_text("def which_side(A, B, P):\n    return 0\n")
    assert terminal.sees("WA  Wrong answer")[0].startswith("WA  Wrong answer  which_side.py")
    terminal.press("x")
    assert last(terminal.sees("Press x again.")).startswith("WA  ")
    terminal.press("x")
    terminal.sees("Created which_side.py.", without=["WA  "])
    assert mine.read_text() == stub
    assert "return 0" in (tmp_path / "which_side.py.bak").read_text()
    terminal.leaves()
    with History() as history:
        assert [run.verdict.value for run in history.runs()] == ["WA"]  # not the stub


def test_a_verdict_is_shown_before_it_is_explained(watch, submit):
    terminal = watch("middle", submit(FLOOR))
    terminal.until("21 of 52 cases pass. Looking for the smallest that fails …")
    assert "Smallest failing case" not in terminal.written
    assert last(terminal.sees("Smallest failing case")).startswith("WA  21 of 52 cases pass, 40 of 100")
    terminal.leaves()


def test_what_is_judged_is_said_with_its_time(watch, submit):
    terminal = watch("middle", submit(SLEEPS))
    terminal.until("judging mine.py  1.")
    terminal.leaves()

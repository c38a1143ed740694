"""`judge` alone, `judge start`, and which file commands mean that name none: looking changes nothing.

What is shown is in the transcripts screens/home and kata/current.
"""

from __future__ import annotations

from datetime import UTC, datetime, timedelta

import msgspec
import pytest
from cli_support import FLOOR, MEAN

from judge.practice.events import Answer, Rating, Run, Started
from judge.practice.history import History

pytestmark = pytest.mark.slow

SIDE = (
    "def which_side(A, B, P):\n"
    "    cross = (B[0] - A[0]) * (P[1] - A[1]) - (B[1] - A[1]) * (P[0] - A[0])\n"
    "    return (cross > 0) - (cross < 0)\n"
)


def label(ended, name):
    """What stands beside a label of the screen."""
    return next((line.split(None, 1)[1] for line in ended.lines if line.split(None, 1)[:1] == [name]), "")


def test_looking_writes_nothing_and_moves_nothing(judge, submit, tmp_path, own_history):
    for words in ((), ("list",), ("progress",), ("show", "count"), ("history",)):
        assert judge(*words).status == 0
    assert (list(tmp_path.iterdir()), own_history.exists()) == ([], False)
    submit(SIDE, "which_side.py")
    assert judge("run", "-q", "which_side.py").status == 0
    before = sorted(tmp_path.iterdir())
    for words in ((), ("list",), ("show", "count"), ("progress",)) * 3:
        judge(*words)
    assert sorted(tmp_path.iterdir()) == before
    assert judge("run").lines[0].startswith("AC  Accepted  which_side.py")


def test_the_current_kata_is_the_file_last_started_or_judged_in_this_folder(
    judge, submit, tmp_path, monkeypatch
):
    judge("start", "middle")
    submit(MEAN, "middle.py")
    submit(SIDE, "mine.py")
    assert judge("run", "-q").status == 0
    judge("run", "-q", "mine.py")
    assert judge("run").lines[0].startswith("AC  Accepted  mine.py")
    judge("start", "middle")
    assert judge("run").lines[0].startswith("AC  Accepted  middle.py")
    (tmp_path / "middle.py").unlink()  # the one before it is still there
    assert judge("run").lines[0].startswith("AC  Accepted  mine.py")
    (tmp_path / "deeper").mkdir()
    monkeypatch.chdir(tmp_path / "deeper")
    for words in (("run",), ("hint",), ("solution",)):
        ended = judge(*words)
        assert (ended.status, ended.out) == (2, "")
        assert f"You have not started a kata here. The last one is {tmp_path}/mine.py." in ended.err
    assert judge("start").out.startswith("Created circle_side.py.")


@pytest.mark.parametrize("mark", [".git", "pyproject.toml", "setup.py", "package.json"])
def test_a_project_has_its_katas_in_a_folder_of_their_own(mark, judge, tmp_path):
    (tmp_path / mark).touch()
    made = judge("start")
    assert made.out == "Created katas/distance_squared.py. Write distance_squared, then: judge run\n"
    assert {path.name for path in tmp_path.iterdir()} == {mark, "katas"}
    assert (tmp_path / "katas" / ".gitignore").read_text() == "*\n"
    assert judge("start", "middle").out.startswith("Created katas/middle.py.")
    assert judge("start", "middle").out.startswith("katas/middle.py exists.")
    assert judge("start").out.startswith("katas/middle.py exists.")
    assert "goes on with katas/middle.py in this folder" in judge().out
    assert judge("start", "middle", "--language", "go").out.startswith("Created katas/middle.go.")


def test_katas_in_the_folder_below_are_found_from_above(judge, tmp_path, monkeypatch):
    (tmp_path / ".git").mkdir()
    judge("start", "middle")
    (tmp_path / "katas" / "middle.py").write_text(MEAN)
    assert judge("run").lines[0].startswith("AC  Accepted  katas/middle.py")
    assert judge("run", "middle").lines[0].startswith("AC  Accepted  katas/middle.py")
    assert judge("try", "middle", "1, 2").lines[0] == "AC  Accepted  katas/middle.py"
    assert judge("start", "which-side").out.startswith("Created katas/which_side.py.")
    assert judge("hint").out.startswith("Start at A")
    monkeypatch.chdir(tmp_path / "katas")
    assert judge("run", "middle").lines[0].startswith("AC  Accepted  middle.py")
    assert judge("start", "diameter").out.startswith("Created diameter.py.")


def test_a_project_with_a_kata_of_its_own_gets_no_folder(judge, submit, tmp_path):
    submit(MEAN, "middle.py")
    judge("run", "-q", "middle.py")
    (tmp_path / "setup.py").touch()
    assert judge("start", "diameter").out.startswith("Created diameter.py.")
    assert judge("start", "new.go").status == 2
    assert judge("start", "crossings", "mine.py").out.startswith("Created mine.py.")
    assert not (tmp_path / "katas").exists()


def test_a_kata_in_another_folder_is_said_to_be_there(judge, tmp_path, monkeypatch):
    judge("start", "middle")
    (tmp_path / "deeper").mkdir()
    monkeypatch.chdir(tmp_path / "deeper")
    ended = judge()
    assert f"middle.py is in another folder: cd {tmp_path}" in ended.out
    monkeypatch.chdir(tmp_path)
    assert "goes on with middle.py in this folder" in judge().out


def test_a_file_that_is_gone_is_named(judge, tmp_path):
    judge("start", "middle")
    (tmp_path / "middle.py").unlink()
    assert judge("run").err == "judge: middle.py is not in this folder. Create it: judge start middle\n"


def test_what_an_older_judge_took_up_without_a_file_is_not_current(judge, submit, tmp_path):
    submit(FLOOR, "middle.py")
    judge("run", "-q", "middle.py")
    with History() as history:
        history.keep(Started("diameter", str(tmp_path / "diameter.py")))
    assert judge("run").lines[0].startswith("WA  Wrong answer  middle.py")


def test_the_next_kata_follows_in_the_same_set(judge, submit):
    submit(SIDE, "which_side.py")
    assert judge("run", "-q", "which_side.py").status == 0
    assert label(judge(), "Next").startswith("circle-side")
    assert judge("start").out == "Created circle_side.py. Write circle_side, then: judge run\n"
    assert judge("start").out.startswith("circle_side.py exists.")
    assert label(judge(), "Now").startswith("circle-side")


def test_a_kata_that_was_left_out_comes_back_before_the_next_set(judge, submit, tmp_path):
    submit(SIDE, "which_side.py")
    judge("run", "-q", "which_side.py")
    with History() as history:
        (run,) = history.runs()
        for kata in ("distance-squared", "diameter", "axis-foot", "crossings"):
            history.keep(solved(run, kata, tmp_path, days=0))
    assert label(judge(), "Next").startswith("circle-side")


def test_what_is_due_again_and_the_cards(judge, submit, tmp_path):
    submit(SIDE, "which_side.py")
    judge("run", "-q", "which_side.py")
    with History() as history:
        (run,) = history.runs()
        history.keep(solved(run, "crossings", tmp_path, days=8))
        old = datetime.now(UTC) - timedelta(days=30)
        history.keep(Answer("junior/equality-test", "choice", Rating.GOOD, judged=True, when=old))
    ended = judge()
    assert label(ended, "Again") == "crossings        solved 8 days ago; solve it once more from memory"
    assert "judge start crossings --reset" in ended.out
    assert "1 card due" in ended.out
    assert ended.lines[0].endswith("2 of 38 katas")
    steps = [" ".join(line.split()) for line in judge("drill").lines if " min " in line]
    assert [each for each in steps if each.startswith("1 ") and each.endswith("1 due")]
    assert steps[-1] == "4 5 min judge start crossings --reset solved 8 days ago; from memory"
    assert "judge start crossings --reset" in judge("progress", "--due").out


def solved(run: Run, kata: str, folder, *, days: int) -> Run:
    """The run of another kata, so many days ago."""
    path = str(folder / f"{kata.replace('-', '_')}.py")
    when = datetime.now(UTC) - timedelta(days=days)
    return msgspec.structs.replace(run, problem=kata, path=path, source_hash=kata, when=when, id=0)


def test_start_goes_on_with_a_file_and_over_it_only_when_asked(judge, submit, tmp_path):
    mine = tmp_path / submit(FLOOR, "middle.py")
    assert judge("start", "middle").out == "middle.py exists. Go on: judge run. Start over: add --reset\n"
    assert mine.read_text() == FLOOR
    for number in ("", "-2"):
        mine.write_text(FLOOR + number)
        ended = judge("start", "middle", "--reset")
        assert f"The old text is in middle.py.bak{number}." in ended.out
        assert (tmp_path / f"middle.py.bak{number}").read_text() == FLOOR + number
    assert "is still to be written" in mine.read_text()
    judge("start", "middle", "--reset")  # nothing would be lost
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        "middle.py",
        "middle.py.bak",
        "middle.py.bak-2",
    ]


def test_a_file_says_its_kata_and_its_language(judge, submit, tmp_path):
    submit(SIDE, "mine.py")
    assert judge("start", "mine.py").out.startswith("mine.py exists.")
    assert judge("run").lines[0].startswith("AC  Accepted  mine.py")
    assert judge("start", "middle.go").out.startswith("Created middle.go.")
    assert judge("start", "middle", "--language", "rust").out.startswith("Created middle.rs.")
    assert judge("start", "middle", "--language", "rust", "--no-watch").out.startswith("middle.rs exists.")
    assert (tmp_path / "middle.go").read_text().startswith("// middle: The middle.")

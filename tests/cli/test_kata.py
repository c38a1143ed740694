"""Hints and solutions that were seen, katas of a pack, and katas of one's own.

What these commands show is in the transcripts of `kata/`.
"""

from __future__ import annotations

import json
import re
import shutil
import tomllib
from pathlib import Path

import pytest
from cli_support import FLOOR, MEAN

from judge.packs import begin
from judge.practice.events import Help
from judge.practice.history import History
from judge.problem.find import find_problem
from judge.problem.solutions import SolutionKind, read_solutions

pytestmark = pytest.mark.slow


def refused(ended, *words):
    assert (ended.status, ended.out) == (2, ""), ended
    assert ended.err.count("\n") == 1, ended.err
    for word in words:
        assert word in ended.err


def test_what_was_seen_of_hints_and_solutions_is_kept(judge, submit):
    judge("hint", "middle")
    judge("hint", "middle", "--step", "2")
    judge("hint", "middle", "--step", "1")
    assert judge("solution", "middle", "--give-up").status == 0
    assert judge("solution", "middle").status == 0  # it is known now
    assert judge("solution", "middle", "--give-up").status == 0
    with History() as history:
        assert [each.hints for each in history.events(Help, "middle")] == [1, 2, 0]


def test_times_are_measured_for_who_asks_for_them(judge, submit):
    judge("run", "-q", "middle", submit(MEAN, "middle.py"))
    unmeasured = json.loads(judge("solution", "middle", "--json").out)
    assert [each["taken"] for each in (*unmeasured["approaches"], unmeasured["yours"])] == [None, None]
    found = json.loads(judge("solution", "middle", "--times", "--json").out)
    assert found["approaches"][0]["taken"]["ratio"] == 1
    assert found["yours"]["taken"]["ratio"] > 0
    assert "yours" in judge("solution", "middle", "--times").out


# -- a pack that only --problems finds -------------------------------------------------------------------


@pytest.fixture
def lone(pack, tmp_path, monkeypatch):
    """The folder of a pack that nothing but its name leads to."""
    monkeypatch.delenv("JUDGE_PROBLEMS")
    shutil.copytree(pack, tmp_path / "elsewhere" / "pack")
    return tmp_path / "elsewhere" / "pack" / "problems"


def test_a_packs_kata_is_gone_on_with_by_every_command_that_names_the_pack(lone, judge, submit):
    named = ("--problems", lone)
    assert judge("start", "middle", *named).status == 0
    submit(FLOOR, "middle.py")
    assert judge("run", "-q", *named).status == 1
    assert judge("hint", *named).lines[0].endswith("middle, hint 1 of 3")
    submit(MEAN, "middle.py")
    assert judge("run", "-q", *named).status == 0
    assert judge("solution", *named).status == 0
    refused(judge("run"), "no kata is called 'middle'; add --problems elsewhere/pack/problems")


def test_a_kata_whose_pack_is_gone_says_where_it_was(lone, judge, tmp_path):
    judge("start", "middle", "--problems", lone)
    (tmp_path / "elsewhere" / "pack").rename(tmp_path / "moved")
    for words in (["run"], ["hint"], ["start"]):
        refused(judge(*words), f"it was in {lone}", "--problems")
    assert judge("run", "-q", "--problems", tmp_path / "moved" / "problems").status == 1


# -- a kata of one's own ---------------------------------------------------------------------------------


FILES = {
    "problems/{}/problem.toml",
    "problems/{}/problem.py",
    "problems/{}/statement.md",
    "problems/{}/hints.md",
    "problems/{}/pins.json",
    "solutions/{}/accepted/pythagoras.py",
    "solutions/{}/wrong/sum-of-legs.py",
}


def files(folder: Path) -> set[str]:
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}


def test_a_kata_is_whole_and_sound_at_once(judge, tmp_path):
    written = json.loads(judge("new", "pack", "my-own", "--json").out)
    assert (written["problem"], written["problems"]) == ("my-own", "pack/problems")
    assert files(tmp_path / "pack") == {name.format("my-own") for name in FILES}
    assert set(written["files"]) == {f"pack/{name.format('my-own')}" for name in FILES}

    verified = judge("verify", "--problems", "pack/problems", "my-own", "--json")
    report = json.loads(verified.out)
    assert (verified.status, report["faults"], report["pins"]) == (0, [], "matching")
    assert [solution["file"] for solution in report["solutions"]] == [
        "accepted/pythagoras.py",
        "wrong/sum-of-legs.py",
    ]

    problem = find_problem("my-own", [tmp_path / "pack" / "problems"])
    for kind, status in ((SolutionKind.ACCEPTED, 0), (SolutionKind.WRONG, 1)):
        (program,) = read_solutions(problem, kind).programs
        ended = judge("run", "--problems", "pack/problems", "my-own", program.path, "--json")
        assert ended.status == status
    assert json.loads(ended.out)["pitfall"]["names"] == ["sum-of-legs"]


@pytest.mark.parametrize("kind", begin.KINDS)
def test_a_kata_of_each_kind_is_sound_and_has_its_own_name(kind, judge, tmp_path):
    assert judge("new", ".", "my-own", "--like", kind).status == 0
    report = json.loads(judge("verify", "--problems", "problems", "my-own", "--json").out)
    assert (report["faults"], report["pins"]) == ([], "matching")
    problem = find_problem("my-own", [tmp_path / "problems"])
    assert problem.entry.lower().replace("_", "") in ("", "myown")
    assert not problem.sets


def test_a_kata_like_another_one_takes_what_they_share(judge, tmp_path):
    judge("new", ".", "square-apart", "--like", "distance-squared")
    report = json.loads(judge("verify", "--problems", "problems", "square-apart", "--json").out)
    assert (report["faults"], report["pins"]) == ([], "matching")
    assert (tmp_path / "solutions" / "mistakes.toml").is_file()
    assert "squareApart(" in (tmp_path / "solutions/square-apart/accepted/reference.java").read_text()
    (tmp_path / "problems/square-apart/photo.png").write_bytes(b"\x89PNG\xff")
    again = json.loads(
        judge("new", ".", "b-c", "--like", "square-apart", "--problems", "problems", "--json").out
    )
    assert "solutions/mistakes.toml" not in again["files"]
    assert (tmp_path / "problems/b-c/photo.png").read_bytes() == b"\x89PNG\xff"


def test_what_is_no_kind_and_no_kata(judge):
    ended = judge("new", ".", "my-own", "--like", "progam")
    assert (ended.status, ended.err.count("\n")) == (2, 1)
    assert "did you mean 'program'?" in ended.err


def test_a_pack_has_its_own_name_in_the_list(judge, tmp_path):
    assert judge("new", "texts", "my-texts", "--pack").status == 0
    assert judge("new", "texts", "my-texts", "--pack").status == 2
    assert judge("new", "texts/my_texts/problems", "my-own").status == 0
    assert (tmp_path / "texts/my_texts/solutions/my-own/accepted").is_dir()
    pyproject = tomllib.loads((tmp_path / "texts/pyproject.toml").read_text())
    assert pyproject["project"]["entry-points"]["judge.problems"] == {"my_texts": "my_texts.problems"}
    said = judge("list", "--problems", "texts/my_texts/problems").out
    assert said.index("My texts") < said.index("first-steps")
    shutil.copytree(tmp_path / "texts/my_texts/problems/my-own", tmp_path / "texts/my_texts/problems/count")
    ended = judge("list", "--problems", "texts/my_texts/problems")
    assert ended.err.count("two katas are called 'count'") == 1


def test_the_page_shows_the_kata_of_texts():
    page = (Path(begin.__file__).parents[1] / "manual" / "new-kata.md").read_text()
    shown = re.findall(r"(?ms)^## `([^`]+)`\n\n```\w+\n(.*?)^```$", page)
    assert len(shown) == 1
    for path, text in shown:
        file = (
            Path(begin.__file__).parents[1]
            / "manual"
            / "katas"
            / path.replace("my-kata", begin.KINDS["text"])
        )
        assert file.read_text() == text.replace("my_kata", begin.KINDS["text"])


@pytest.mark.parametrize(
    ("words", "home"),
    [
        (["pack", "a-b"], "pack"),
        ([".", "a-b"], "."),
        (["problems", "a-b"], "."),  # a folder of problems, empty as yet
        (["course/week-1", "a-b"], "course"),  # one of another name, that holds a problem
        (["course", "a-b"], "course"),  # which holds no problem itself
    ],
)
def test_where_it_goes(words, home, judge, tmp_path):
    (tmp_path / "problems").mkdir()
    judge("new", "course", "first")
    (tmp_path / "course" / "problems").rename(tmp_path / "course" / "week-1")
    ended = judge("new", *words, "--json")
    assert (ended.status, ended.err) == (0, "")
    problems = json.loads(ended.out)["problems"]
    assert (tmp_path / home / "solutions" / "a-b" / "accepted" / "pythagoras.py").is_file()
    assert (tmp_path / problems / "a-b" / "problem.toml").is_file()
    assert (tmp_path / problems).parent.resolve() == (tmp_path / home).resolve()


def test_a_link_to_nothing_is_not_followed(judge, tmp_path):
    (tmp_path / "pack" / "problems").mkdir(parents=True)
    (tmp_path / "pack" / "problems" / "mine").symlink_to(tmp_path / "elsewhere")
    assert judge("new", "pack", "mine").status == 2
    assert not (tmp_path / "elsewhere").exists()


def test_a_link_to_itself_is_answered_in_a_line(judge, tmp_path):
    (tmp_path / "mine").symlink_to("mine")
    ended = judge("new", "mine")
    assert (ended.status, ended.err.count("\n")) == (2, 1)
    assert "symbolic links" in ended.err


@pytest.mark.parametrize("fault", [OSError(28, "No space left on device", "x"), KeyboardInterrupt()])
def test_what_cannot_be_written_whole_is_not_written_at_all(fault, judge, tmp_path, monkeypatch):
    def fail(*_, **__):
        raise fault

    (tmp_path / "pack" / "problems").mkdir(parents=True)
    monkeypatch.setattr(begin, "verify_problem", fail)
    ended = judge("new", "pack", "mine")
    assert ended.status == (2 if isinstance(fault, OSError) else 130)
    assert list((tmp_path / "pack").iterdir()) == [tmp_path / "pack" / "problems"]
    assert list((tmp_path / "pack" / "problems").iterdir()) == []

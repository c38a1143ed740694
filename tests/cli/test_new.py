"""`judge new`: a kata to begin with, sound at once, and nothing of anybody's written over."""

from __future__ import annotations

import json
import os
import stat
import tomllib
from pathlib import Path

import pytest
from cli_support import ROOT

from judge.kata import begin
from judge.problem.find import find_problem
from judge.problem.solutions import Kind, read_solutions

FILES = {
    "problems/{}/problem.toml",
    "problems/{}/problem.py",
    "problems/{}/statement.md",
    "problems/{}/hints.md",
    "problems/{}/hashes.json",
    "solutions/{}/accepted/pythagoras.py",
    "solutions/{}/wrong/sum-of-legs.py",
}


@pytest.fixture(autouse=True)
def _here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def files(folder: Path) -> set[str]:
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}


def test_a_kata_is_whole_and_sound_at_once(judge, tmp_path):
    written = json.loads(judge("new", "pack", "my-own", "--json").out)
    assert (written["problem"], written["problems"]) == ("my-own", "pack/problems")
    assert files(tmp_path / "pack") == {name.format("my-own") for name in FILES}
    assert set(written["files"]) == {f"pack/{name.format('my-own')}" for name in FILES}

    verified = judge("verify", "--problems", "pack/problems", "my-own", "--json")
    report = json.loads(verified.out)
    assert (verified.status, report["ok"], report["faults"], report["pins"]) == (0, True, [], "matching")
    assert [solution["file"] for solution in report["solutions"]] == [
        "accepted/pythagoras.py",
        "wrong/sum-of-legs.py",
    ]

    problem = find_problem("my-own", [tmp_path / "pack" / "problems"])
    for kind, status in ((Kind.ACCEPTED, 0), (Kind.WRONG, 1)):
        (program,) = read_solutions(problem, kind).programs
        ended = judge("run", "--problems", "pack/problems", "my-own", program.path, "--json")
        assert ended.status == status
    assert json.loads(ended.out)["pitfall"]["name"] == "sum-of-legs"


def test_it_goes_through_the_commands_of_a_person(judge):
    judge("new", ".", "mine")
    assert "mine" in judge("list", "--problems", "problems").out
    practised = json.loads(judge("practice", "--problems", "problems", "--json").out)
    assert "mine" in [each["problem"] for each in practised["problems"]]
    skills = json.loads(judge("progress", "--problems", "problems", "--json").out)["skills"]
    assert skills[-1]["needs"][0]["problem"] == "mine"
    assert judge("init", "mine", "--problems", "problems").status == 0
    assert judge("run", "mine", "mine.py", "--problems", "problems").status == 1
    assert judge("hint", "mine", "--problems", "problems").status == 0


def test_what_a_person_is_shown_can_be_typed(judge, tmp_path):
    (tmp_path / "my packs").mkdir()
    shown = judge("new", "my packs/two-points")
    assert shown.status == 0
    assert "  my packs/two-points/problems/two-points/problem.toml" in shown.lines
    (line,) = [line for line in shown.lines if "  checks it" in line and "--pin" not in line]
    assert line.strip().startswith("judge verify --problems 'my packs/two-points/problems' two-points")


@pytest.mark.parametrize(
    ("words", "home"),
    [
        (["pack", "a-b"], "pack"),
        (["a-b"], "a-b"),
        (["deep/er/a-b"], "deep/er/a-b"),
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
    assert judge("verify", "a-b", "--problems", problems).status == 0


def test_a_second_kata_joins_the_first(judge):
    judge("new", "pack", "first")
    assert judge("new", "pack", "second").status == 0
    assert judge("verify", "--problems", "pack/problems", "first", "second").status == 0


@pytest.mark.parametrize("name", ["class", "a1", "x-2-y", "lambda"])
def test_any_name_that_a_problem_may_have_will_do(name, judge):
    assert judge("new", "pack", name).status == 0
    assert judge("verify", "--problems", "pack/problems", name).status == 0
    entry = tomllib.loads(Path(f"pack/problems/{name}/problem.toml").read_text())["entry"]
    assert entry.rstrip("_") == name.replace("-", "_")


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (
            ["pack", "My_Kata"],
            "'My_Kata' is no name for a kata; use small letters, digits and single hyphens",
        ),
        (["pack", "../out"], "'../out' is no name for a kata; use small letters, digits and single hyphens"),
        (["pack", ""], "'' is no name for a kata; use small letters, digits and single hyphens"),
        (["/"], "'' is no name for a kata; name it: judge new / NAME, with small letters, digits and single"),
        (
            ["My Pack"],
            "'My Pack' is no name for a kata; name it: judge new 'My Pack' NAME, with small letters",
        ),
        (["problems"], "problems: the new kata has no name; name it: judge new problems NAME"),
        (["file"], "file: this is no folder; name a folder for the new kata"),
        (["pack", "count"], "a kata is called 'count' already; choose another name: runs are kept by it"),
        (["pack", "a" * 300], "cannot be written (file name too long); name another folder"),
    ],
)
def test_what_cannot_be_is_one_line_and_leaves_nothing(words, message, judge, tmp_path):
    (tmp_path / "problems").mkdir()
    (tmp_path / "file").write_text("mine")
    ended = judge("new", *words)
    assert (ended.status, ended.out) == (2, "")
    assert message in ended.err
    assert ended.err.startswith("judge: ")
    assert ended.err.count("\n") == 1
    assert files(tmp_path) == {"file"}
    assert not (tmp_path / "pack").exists()


def test_no_folder_is_named(judge):
    ended = judge("new")
    assert ended.status == 2
    assert "missing argument 'DIR'" in ended.err


@pytest.mark.parametrize("there", ["problems/mine/notes.md", "solutions/mine/old.py", "problems/mine"])
def test_nothing_is_written_over(there, judge, tmp_path):
    path = tmp_path / "pack" / there
    path.parent.mkdir(parents=True)
    path.write_text("precious")
    before = files(tmp_path)
    ended = judge("new", "pack", "mine")
    assert ended.status == 2
    assert "it is there already; choose another name, or take it away first" in ended.err
    assert files(tmp_path) == before
    assert path.read_text() == "precious"


def test_a_link_to_nothing_is_not_followed(judge, tmp_path):
    (tmp_path / "pack" / "problems").mkdir(parents=True)
    (tmp_path / "pack" / "problems" / "mine").symlink_to(tmp_path / "elsewhere")
    assert judge("new", "pack", "mine").status == 2
    assert not (tmp_path / "elsewhere").exists()


def test_an_empty_folder_is_filled(judge, tmp_path):
    (tmp_path / "pack" / "problems" / "mine").mkdir(parents=True)
    assert judge("new", "pack", "mine").status == 0


@pytest.mark.parametrize("fault", [OSError(28, "No space left on device", "x"), KeyboardInterrupt()])
def test_what_cannot_be_written_whole_is_not_written_at_all(fault, judge, tmp_path, monkeypatch):
    def fail(*_, **__):
        raise fault

    (tmp_path / "pack" / "problems").mkdir(parents=True)
    monkeypatch.setattr(begin, "write_pins", fail)
    ended = judge("new", "pack", "mine")
    assert ended.status == (2 if isinstance(fault, OSError) else 130)
    assert list((tmp_path / "pack").iterdir()) == [tmp_path / "pack" / "problems"]
    assert list((tmp_path / "pack" / "problems").iterdir()) == []


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
def test_a_folder_that_may_not_be_written(judge, tmp_path):
    (tmp_path / "pack").mkdir()
    (tmp_path / "pack").chmod(stat.S_IRUSR | stat.S_IXUSR)
    ended = judge("new", "pack", "mine")
    assert ended.status == 2
    assert "cannot be written (permission denied)" in ended.err


def test_the_template_names_its_kata_only_as_itself():
    text = (ROOT / "judge" / "manual" / "new-kata.md").read_text(encoding="utf-8")
    told = dict(begin._files("my-kata"))
    assert {name.format("my-kata") for name in FILES} - {"problems/my-kata/hashes.json"} == set(told)
    assert text.count("```") == 2 * len(told), "every block is a file"
    for name, content in begin._files("else-where"):
        assert "my-kata" not in name + content
        assert "my_kata" not in content

"""`judge new`: a kata to begin with, sound at once, and nothing of anybody's written over."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path

import pytest

from judge.kata import begin
from judge.problem.find import find_problem
from judge.problem.solutions import Kind, read_solutions

pytestmark = pytest.mark.slow

FILES = {
    "problems/{}/problem.toml",
    "problems/{}/problem.py",
    "problems/{}/statement.md",
    "problems/{}/hints.md",
    "problems/{}/hashes.json",
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


def test_any_name_that_a_problem_may_have_will_do(judge):
    names = ["class", "x-2-y"]  # each joins those before
    for name in names:
        assert judge("new", "pack", name).status == 0
        entry = tomllib.loads(Path(f"pack/problems/{name}/problem.toml").read_text())["entry"]
        assert entry.rstrip("_") == name.replace("-", "_")
    assert judge("verify", "--problems", "pack/problems", *names).status == 0


def test_a_link_to_nothing_is_not_followed(judge, tmp_path):
    (tmp_path / "pack" / "problems").mkdir(parents=True)
    (tmp_path / "pack" / "problems" / "mine").symlink_to(tmp_path / "elsewhere")
    assert judge("new", "pack", "mine").status == 2
    assert not (tmp_path / "elsewhere").exists()


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

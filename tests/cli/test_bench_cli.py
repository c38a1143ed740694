"""`judge bench` from the command line."""

from __future__ import annotations

import json
import shutil

import pytest
from chromium import CHROMIUM, measured
from cli_support import MEAN, PACK

from judge.languages import find
from judge.languages.model import language_called

pytestmark = pytest.mark.slow

CPP = "// Mean.\ndouble middle(double a, double b) { return (a + b) / 2; }\n"


@pytest.fixture
def two_languages(tmp_path, monkeypatch):
    """The problem `middle` with a reference in C++."""
    if find.why_not(language_called("cpp")):
        pytest.skip("no C++ here")
    shutil.copytree(PACK, tmp_path / "two")
    (tmp_path / "two" / "solutions" / "middle" / "accepted" / "reference.cpp").write_text(CPP)
    toml = tmp_path / "two" / "problems" / "middle" / "problem.toml"
    rule = '[time]\nlimit = 50\nfunction = "mean.py"\n\n[time.references]\ncpp = "reference.cpp"\n\n'
    toml.write_text(toml.read_text().replace("[tolerance]", f"{rule}[tolerance]", 1))
    monkeypatch.setenv("JUDGE_PROBLEMS", str(tmp_path / "two" / "problems"))
    return tmp_path


def test_every_language_and_ones_own_file(judge, two_languages, submit):
    mine = submit(MEAN.replace("/ 2", "/ 2.0"))
    ended = judge("bench", "middle", mine, "--rounds", "2", "--json")
    assert (ended.status, ended.err) == (0, "")
    found = json.loads(ended.out)
    assert (found["rounds"], found["wanted_rounds"], found["interrupted"]) == (2, 2, False)
    python, cpp, own = found["rows"]
    assert (python["language"], python["file"], python["own"]) == ("Python", "mean.py", False)
    assert python["ratio"] == {"median": 1.0, "low": 1.0, "high": 1.0}
    assert (cpp["language"], cpp["file"], own["own"]) == ("C++", "reference.cpp", True)
    assert all(row["ns"]["low"] <= row["ns"]["median"] <= row["ns"]["high"] for row in found["rows"])
    assert all(row["passes"] > 1 and row["why_not"] is None for row in found["rows"])
    assert cpp["memory_bytes"] > 0


def test_a_person_sees_a_table_and_a_plot(judge, two_languages, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    ended = judge("bench", "middle", "--rounds", "1", "--languages", "c++")
    assert ended.status == 0, ended
    assert ended.lines[0].startswith("middle  52 cases, 1 round")
    first = [row.split()[0] for row in ended.lines if row.startswith(("  Python ", "  C++ "))]
    assert first == ["Python", "C++"] * 2
    assert any("●" in row for row in ended.lines)


def test_what_is_not_installed_is_a_line(judge, two_languages, monkeypatch):
    monkeypatch.setattr(find, "missing", lambda language: ["g++"])
    monkeypatch.setattr(find, "remedy", lambda language: "apt-get install g++")
    ended = judge("bench", "middle", "--rounds", "1")
    assert ended.status == 0
    assert ended.lines[-1] == "  C++  not measured here: no g++ (apt-get install g++)"


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["nowhere"], "no problem is called 'nowhere'"),
        (["middle", "gone.py"], "gone.py: no such file"),
        (["middle", "--languages", "jova"], "there is no language jova; did you mean java?"),
        (["middle", "--languages", " , "], "--languages names none; name some, as --languages go,cpp"),
        (["middle", "--group", "hal"], "middle has no group 'hal'; did you mean 'half'?"),
        (["middle", "--rounds", "0"], "invalid value for '--rounds'"),
        (["middle", "--html", "notes.txt"], "it is there already and is no page of judge bench"),
        (["middle", "--html", "gone/a.html"], "its folder does not exist"),
    ],
)
def test_a_wrong_use_is_one_line(judge, tmp_path, words, said):
    (tmp_path / "notes.txt").write_text("mine\n")
    ended = judge("bench", *words)
    assert (ended.status, ended.out) == (2, "")
    assert said in ended.err
    assert len(ended.err.splitlines()) == 1


def test_a_language_without_a_solution_is_said(judge):
    ended = judge("bench", "middle", "--rounds", "1", "--languages", "go")
    assert ended.status == 0
    assert "middle has no solution in Go" in ended.err


def test_the_page_is_written_and_written_over(judge, tmp_path):
    for _ in range(2):
        ended = judge("bench", "middle", "--rounds", "1", "--html", "bench.html")
        assert (ended.status, ended.err) == (0, "judge: the page is bench.html\n")
    page = tmp_path / "bench.html"
    assert page.read_bytes().startswith(b"<!doctype html>")
    if CHROMIUM:
        for width in (1000, 360):
            seen = measured(page, width=width, dark=width == 360)
            assert seen["needed"] <= seen["width"], seen
            assert seen["faint"] == []


def test_an_interruption_shows_what_is_there(judge, monkeypatch):
    starts = []

    def bare():
        starts.append(0.01)
        if len(starts) == 3:
            raise KeyboardInterrupt
        return starts[-1]

    monkeypatch.setattr("judge.run.bench._bare_start", bare)
    ended = judge("bench", "middle", "--rounds", "99", "--json")
    assert (ended.status, ended.err) == (130, "")
    found = json.loads(ended.out)
    assert (found["interrupted"], found["rounds"]) == (True, 2)
    assert found["rows"][0]["ns"]["median"] > 0

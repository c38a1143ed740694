"""Sets, skills and spaced review: what ships is sound, what is broken says so, what runs make of them."""

from __future__ import annotations

import shutil
from datetime import timedelta
from pathlib import Path

import pytest
from msgspec.structs import replace
from past_runs import START, past_result

from judge.errors import ProblemError
from judge.kata.events import Help, Rating, Run
from judge.kata.history import run_of
from judge.kata.review import LADDER, reviews
from judge.kata.sets import find_set
from judge.kata.skills import Need, Skill, SkillState, assess, skills_of
from judge.problem.find import all_problems, find_problem
from judge.problem.load import load_problem

ROOT = Path(__file__).parents[2]
PACK = ROOT / "tests" / "fixtures" / "pack"


@pytest.fixture(autouse=True)
def _no_other_pack(monkeypatch):
    monkeypatch.delenv("JUDGE_PROBLEMS", raising=False)


@pytest.fixture
def folder(tmp_path):
    """A folder of problems of one's own, empty but for what the test writes."""
    (tmp_path / "problems" / "sets").mkdir(parents=True)

    def write(name, text):
        (tmp_path / "problems" / name).write_bytes(text.encode(errors="surrogateescape"))
        return [tmp_path / "problems"]

    return write


@pytest.fixture
def problem(tmp_path):
    """Write a small problem into a folder of one's own; its problem.toml begins and ends with these lines."""

    def write(name, head="", tail=""):
        place = tmp_path / "problems" / name
        shutil.copytree(PACK / "problems" / "middle", place)
        text = (place / "problem.toml").read_text(encoding="utf-8")
        (place / "problem.toml").write_text(f"{head}\n{text}\n{tail}\n", encoding="utf-8")
        return [tmp_path / "problems"]

    return write


def ids(chosen):
    return [problem.id for problem in chosen.problems]


def test_the_shipped_skills_are_shown_by_every_group_and_each_by_some():
    problems = all_problems()
    needs = [need for skill in skills_of(problems) for need in skill.needs]
    needed = {(need.problem, group) for need in needs for group in need.groups}
    there = {(problem.id, group.name) for problem in problems for group in problem.groups}
    assert {(problem, group) for problem, group in there - needed if group != "examples"} == set()


def test_a_new_problem_joins_sets_and_skills_from_its_own_folder(problem):
    extra = problem("halves", 'sets = ["junior"]\nplace = 1')
    page = extra[0] / "halves" / "problem.py"
    text = page.read_text(encoding="utf-8")
    text = text.replace("points=40", 'points=40, skills="no slopes"').replace(
        "points=50", 'points=50, skills="half"'
    )
    page.write_text(text, encoding="utf-8")
    (extra[0] / "skills.toml").write_text(
        '[[skills]]\nname = "half"\nabout = "Halves are kept."\n', encoding="utf-8"
    )
    junior = find_set("junior", extra)
    assert ids(junior) == ["halves", *ids(find_set("junior"))], "its place comes first"
    skills = {skill.name: skill for skill in skills_of(junior.problems, extra)}
    assert Need("halves", ("whole",)) in skills["no slopes"].needs
    assert skills["half"] == Skill("half", "Halves are kept.", (Need("halves", ("half",)),))


@pytest.mark.parametrize(
    ("head", "tail", "wanted"),
    [
        ('sets = "path"', "", r"mine/problem.toml:1: sets is text; give a list"),
        ('sets = ["Path"]', "", r"mine/problem.toml:1: 'Path' is no name for a practice set; use small"),
        ('sets = ["path", "path"]', "", r"mine/problem.toml:1: 'path' is there twice in sets; remove one"),
        ("", '[skills]\na = ["half"]', r"mine/problem.toml:\d+: unknown key 'skills'; the keys are"),
    ],
)
def test_what_a_problem_says_wrongly_of_sets_and_skills_is_one_clear_line(head, tail, wanted, problem):
    (folder,) = problem("mine", head, tail)
    last = len((folder / "mine" / "problem.toml").read_text(encoding="utf-8").splitlines())
    with pytest.raises(ProblemError) as caught:
        load_problem(folder / "mine")
    assert caught.match(wanted.replace("LAST", str(last)))
    assert "\n" not in str(caught.value)


CLAMP = Skill("clamp", "…", (Need("segment", ("beyond", "tangent-beyond")),))


@pytest.fixture
def after():
    """The progress of a skill after results, a day apart; those of all calls follow each other."""
    runs: list[Run] = []

    def run(skill, *results):
        for result in results:
            when = START + timedelta(days=len(runs))
            runs.append(replace(run_of(result, repr(result).encode(), ""), when=when))
        return assess([skill], runs, [find_problem(name) for name in ("segment", "count")])[0]

    return run


def test_a_skill_is_shown_by_one_run_that_passes_all_its_groups(after):
    parts = after(
        CLAMP,
        past_result(passed=("beyond",), failed=("tangent-beyond",)),
        past_result(passed=("tangent-beyond",), failed=("beyond",)),
    )
    assert (parts.state, parts.attempts, parts.since) == (SkillState.OPEN, 2, None)
    both = after(CLAMP, past_result(passed=("beyond", "tangent-beyond")), past_result(passed=("beyond",)))
    assert (both.state, both.attempts) == (SkillState.SHOWN, 3)
    assert both.since == START + timedelta(days=2)


def test_a_skill_is_lost_by_the_latest_run_and_keeps_its_date(after):
    lost = after(
        CLAMP,
        past_result(passed=("beyond", "tangent-beyond")),
        past_result(passed=("tangent-beyond",), failed=("beyond",)),
        past_result(passed=("grid",)),  # says nothing of it
    )
    assert (lost.state, lost.since, lost.attempts) == (SkillState.LOST, START, 1)
    assert lost.needs[0].failing == ("beyond",)
    again = after(
        CLAMP,
        past_result(passed=("beyond", "tangent-beyond")),
        past_result(passed=(), failed=("beyond", "tangent-beyond")),  # a file that is begun anew
    )
    assert (again.state, again.since) == (SkillState.SHOWN, START)


WRONG = past_result(passed=("grid",), failed=("tangent",))
RIGHT = past_result()


class Person:
    """A person at work: results follow each other by minutes, each of a new source."""

    def __init__(self):
        self.runs, self.helps, self.now = [], [], START

    def judge(self, *results):
        for result in results:
            source = b"%d" % len(self.runs)
            self.runs.append(replace(run_of(result, source, ""), when=self.now))
            self.now += timedelta(minutes=5)

    def help(self, hints):
        self.helps.append(Help("segment", hints, when=self.now))

    def pause(self, days):
        self.now += timedelta(days=days)

    def stands(self):
        return [(each.rating, each.sittings, each.days) for each in reviews(self.runs, self.helps)]


@pytest.fixture
def person():
    return Person()


def test_the_ladder(person):
    days = []
    for _ in range(len(LADDER)):
        person.judge(RIGHT)
        (review,) = reviews(person.runs, [])
        assert review.due == review.last + timedelta(days=review.days)
        days.append(review.days)
        person.pause(review.days)
    assert days == [3, 8, 21, 60, 180, 180]
    assert review.in_a_row == len(LADDER)
    person.judge(WRONG, RIGHT)
    assert person.stands() == [(Rating.HARD, 7, 60)]
    person.pause(60)
    person.judge(WRONG)
    assert person.stands() == [(Rating.AGAIN, 8, 1)]


def test_hints_and_giving_up(person):
    person.help(2)
    assert person.stands() == []
    person.judge(RIGHT)
    assert person.stands() == [(Rating.HARD, 1, 1)]
    person.pause(1)
    person.help(0)
    person.judge(RIGHT)
    assert person.stands() == [(Rating.AGAIN, 2, 1)]

"""Sets and skills: what ships is sound, what is broken says so in one line, and runs tick skills off."""

from __future__ import annotations

from collections import Counter
from datetime import timedelta

import pytest
from past_runs import START, StoppedClock, past_result

from judge.errors import ProblemError, UsageError
from judge.kata.history import History
from judge.kata.sets import find_set, set_names
from judge.kata.skills import Need, Skill, SkillState, assess, load_skills
from judge.kata.standing import State, standings
from judge.spec.find import all_problems, find_problem


@pytest.fixture(autouse=True)
def _no_other_pack(monkeypatch):
    monkeypatch.delenv("JUDGE_PROBLEMS", raising=False)


@pytest.fixture
def folder(tmp_path):
    """A folder of problems of one's own, empty but for what the test writes."""
    (tmp_path / "problems" / "sets").mkdir(parents=True)

    def write(name, text):
        (tmp_path / "problems" / name).write_text(text, encoding="utf-8")
        return [tmp_path / "problems"]

    return write


def test_the_shipped_sets_name_every_problem_in_order():
    assert set_names() == ["junior", "middle", "senior", "professional", "path"]
    tiers = ["junior", "middle", "senior", "professional"]
    shipped = {problem.id: problem for problem in all_problems()}
    path = find_set("path").problems
    assert set(path) == set(shipped)
    places = [tiers.index(shipped[name].tier.value) for name in path]
    assert places == sorted(places)
    for name in tiers:
        chosen = find_set(name)
        assert name in [shipped[problem].tier.value for problem in chosen.problems]
        assert [problem for problem in path if problem in chosen.problems] == list(chosen.problems)
        assert chosen.about.endswith(".")


def test_the_shipped_skills_need_every_group_and_none_that_is_not_there():
    skills, problems = load_skills()
    for skill in skills:
        assert skill.about.endswith("."), skill.name
        assert len(skill.name) <= 28  # a row of the checklist
        assert len({need.problem for need in skill.needs}) == len(skill.needs), skill.name
    needed = Counter(
        (need.problem, group) for skill in skills for need in skill.needs for group in need.groups
    )
    there = {(problem.id, group.name) for problem in problems.values() for group in problem.groups}
    assert set(problems) == {problem.id for problem in all_problems()}
    assert {(problem, group) for problem, group in there - set(needed) if group != "examples"} == set()
    assert set(needed) <= there


def test_an_own_set_comes_first_and_may_mix_packs(folder):
    extra = folder("sets/junior.toml", 'title = "Mine"\nabout = "Own."\nproblems = ["count", "segment"]\n')
    assert find_set("junior", extra).title == "Mine"
    folder("sets/zz.toml", "")
    assert set_names(extra)[-1] == "zz"


def test_a_set_that_is_not_there():
    with pytest.raises(UsageError, match="did you mean 'senior'"):
        find_set("seniro")
    with pytest.raises(UsageError, match="there are junior, middle"):
        find_set("qqq")


GOOD = 'title = "T"\nabout = "A"\n'


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        (GOOD + "problems = [", r"sets/mine.toml:3: no TOML: .*; repair this line"),
        (GOOD + "problems = " + "[" * 3000, r"sets/mine.toml: no TOML: its lists or tables are nested too"),
        (GOOD, r"sets/mine.toml:1: the key 'problems' is missing; add problems = …"),
        (GOOD + "problems = []\n", r"sets/mine.toml:3: the set holds no problem; name at least one"),
        (GOOD + 'problems = "count"\n', r"sets/mine.toml:3: problems is text; give a list"),
        (GOOD + "problems = [1]\n", r"sets/mine.toml:3: problems is a number; give text"),
        (
            GOOD + 'problems = ["cuont"]\n',
            r"sets/mine.toml:3: no problem is called 'cuont'; did you mean 'count'",
        ),
        (GOOD + 'problems = ["count", "count"]\n', r"sets/mine.toml:3: 'count' is listed twice"),
        (GOOD + 'problem = ["count"]\nproblems = ["count"]\n', r"sets/mine.toml:3: unknown key 'problem'"),
    ],
)
def test_a_broken_set_is_one_clear_line(text, wanted, folder):
    with pytest.raises(ProblemError) as caught:
        find_set("mine", folder("sets/mine.toml", text))
    assert caught.match(wanted)
    assert "\n" not in str(caught.value)


SKILL = '[[skills]]\nname = "n"\nabout = "a"\n'


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        (SKILL + "needs = []\n", r"skills.toml:4: 'n' needs nothing"),
        (
            SKILL + 'needs = [{problem = "count", groups = ["tangnet"]}]\n',
            r"skills.toml:4: count has no group 'tangnet'; did you mean 'tangent'",
        ),
        (SKILL + 'needs = [{problem = "count", groups = []}]\n', r"skills.toml:4: a need names no group"),
        (
            SKILL + 'needs = [{problem = "cuont", groups = ["x"]}]\n',
            r"skills.toml:4: no problem is called 'cuont'; did you mean 'count'",
        ),
        (SKILL + 'needs = [{problem = "count"}]\n', r"skills.toml:4: the key 'groups' is missing"),
        (
            (SKILL + 'needs = [{problem = "count", groups = ["band"]}]\n') * 2,
            r"skills.toml:5: 'n' is there twice",
        ),
        ("skill = 1\n", r"skills.toml:1: (unknown key 'skill'|the key 'skills' is missing)"),
    ],
)
def test_broken_skills_are_one_clear_line(text, wanted, folder):
    with pytest.raises(ProblemError) as caught:
        load_skills(folder("skills.toml", text))
    assert caught.match(wanted)
    assert "\n" not in str(caught.value)


def test_a_file_that_is_no_text(folder, tmp_path):
    extra = folder("skills.toml", "")
    (tmp_path / "problems" / "skills.toml").write_bytes(b"\xff")
    with pytest.raises(ProblemError, match="byte 0 is not UTF-8"):
        load_skills(extra)


CLAMP = Skill("clamp", "…", (Need("segment", ("beyond", "tangent-beyond")),))
SMALL = Skill("small", "…", (Need("segment", ("small",)), Need("count", ("small",))))


@pytest.fixture
def after():
    """The progress of skills after results, a day apart."""
    clock = StoppedClock()

    def run(skill, *results):
        with History.open(clock=clock) as history:
            for result in results:
                history.add(result, repr(result).encode(), "")
                clock.forward(days=1)
            problems = {name: find_problem(name) for name in ("segment", "count")}
            return assess([skill], history.runs(), problems)[0]

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
    again = after(CLAMP, past_result(passed=("beyond", "tangent-beyond")))
    assert (again.state, again.since) == (SkillState.SHOWN, START)


def test_a_file_that_is_begun_anew_loses_nothing(after):
    shown = after(
        CLAMP,
        past_result(passed=("beyond", "tangent-beyond")),
        past_result(passed=(), failed=("beyond", "tangent-beyond")),
    )
    assert (shown.state, shown.since, shown.attempts) == (SkillState.SHOWN, START, 1)


def test_a_skill_of_two_problems(after):
    half = after(SMALL, past_result(passed=("small",)))
    assert (half.state, half.met, half.since) == (SkillState.PART, 1, None)
    whole = after(SMALL, past_result("count", passed=("small",)))
    assert (whole.state, whole.since) == (SkillState.SHOWN, START + timedelta(days=1))
    assert SMALL.within(["count"]).needs == SMALL.needs[1:]
    assert SMALL.within(["ray-nearest"]) is None


def test_only_mistakes_that_its_groups_are_there_for_are_counted(after):
    found = after(
        CLAMP,
        past_result(passed=(), failed=("beyond",), mistake="no-clamp"),
        past_result(passed=(), failed=("beyond", "grid"), mistake="forgotten-centre + no-clamp"),
        past_result(passed=("beyond", "tangent-beyond"), failed=("small",), mistake="absolute-epsilon"),
    )
    assert found.mistakes == {"no-clamp": 2}


def test_how_each_problem_stands():
    clock = StoppedClock()
    with History.open(clock=clock) as history:
        for result in (
            past_result("count", failed=("band",)),
            past_result("count"),
            past_result("count", passed=(), failed=("band",)),
            past_result("segment", passed=("grid",)),
        ):
            history.add(result, b"", "")
            clock.forward(days=1)
        history.add(past_result("ray-nearest"), b"", "/x/solutions/ray-nearest/accepted/quadratic.py")
        found = standings(history.runs())
    assert (found["count"].state, found["count"].attempts, found["count"].best) == (State.PASSED, 2, 100)
    assert found["count"].passed == START + timedelta(days=1)
    assert (found["segment"].state, found["segment"].best) == (State.TRIED, 50)
    assert found["ray-nearest"].state is State.NEW

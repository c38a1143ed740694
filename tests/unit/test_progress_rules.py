"""Sets, skills and spaced review: what ships is sound, what is broken says so, what runs make of them."""

from __future__ import annotations

import shutil
from datetime import timedelta
from pathlib import Path
from types import SimpleNamespace

import pytest
from msgspec.structs import replace
from past_runs import START, past_result

from judge.errors import ProblemError
from judge.mistakes.puzzles import read_puzzles
from judge.practice.cards import AnyForm, Card, cards_of
from judge.practice.drill import evening
from judge.practice.events import Answer, Hack, Help, Outcome, Rating
from judge.practice.history import run_of
from judge.practice.progress import State, levels_passed, questions, skills, solved, tried
from judge.practice.quiz import Wanted, next_due, plan, usual_kata
from judge.practice.review import LADDER, Learner, card_reviews, reviews
from judge.practice.syllabus import Checklist, ChecklistRow, Section, find_set, read_checklist, sound_sets
from judge.problem.find import find_problem, sound_problems
from judge.problem.load import load_problem
from judge.problem.model import KataLevel

ROOT = Path(__file__).parents[2]
PACK = ROOT / "tests" / "fixtures" / "pack"

FORMS = {each.__struct_config__.tag: each for each in AnyForm.__args__}


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


def test_every_group_shows_a_skill_that_is_explained_and_each_skill_is_shown_by_some():
    problems = sound_problems()[0]
    named = {shown.name for problem in problems for shown in problem.skills}
    assert named == {skill.name for skill in read_checklist().skills}
    for problem in problems:
        needed = {group for shown in problem.skills for group in shown.groups}
        assert {group.name for group in problem.groups} - needed <= {"examples"}


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
    junior = find_set("junior", sound_problems(extra)[0], extra)
    assert ids(junior) == ["halves", *ids(find_set("junior", sound_problems()[0]))], "its place comes first"
    found = {each.name: each for each in skills(junior.problems, {}, read_checklist(extra).skills)}
    assert ("halves", ("whole",)) in [(need.problem, need.groups) for need in found["no slopes"].needs]
    assert found["half"].about == "Halves are kept."
    assert [(need.problem, need.groups) for need in found["half"].needs] == [("halves", ("half",))]


@pytest.mark.parametrize(
    ("head", "tail", "wanted"),
    [
        ('sets = "path"', "", r"mine/problem.toml:1: sets is text; give a list"),
        ('sets = ["Path"]', "", r"mine/problem.toml:1: sets = 'Path'; use small letters"),
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


# -- what runs, answers and hacks show -------------------------------------------------------------------


def days(count):
    return START + timedelta(days=count)


def run(result, when=START):
    return replace(run_of(result, repr(result).encode(), ""), when=when)


KATAS = [find_problem("segment"), find_problem("count")]


def runs_of(results):
    """Runs that came to these results, a day apart."""
    return [run(result, days(day)) for day, result in enumerate(results)]


def skill(name, *results):
    """How a skill stands in segment."""
    found = skills(KATAS[:1], tried(runs_of(results)), read_checklist().skills)
    return next((each for each in found if each.name == name), None)


CLAMP = "clamp to a segment"
(GROUPS,) = (each.groups for each in find_problem("segment").skills if each.name == CLAMP)
ALL = past_result(passed=GROUPS)
FAILED = past_result(passed=GROUPS[1:], failed=GROUPS[:1])


def test_a_skill_is_shown_by_one_run_that_passes_all_its_groups():
    halves = [past_result(passed=GROUPS[:1], failed=GROUPS[1:]), FAILED]
    parts = skill(CLAMP, *halves)
    assert (parts.state, parts.since) == (State.OPEN, None)
    whole = skill(CLAMP, *halves, ALL, past_result(passed=GROUPS[:1]))
    assert (whole.state, whole.since) == (State.SHOWN, days(2))
    others = skills(KATAS[1:], tried(runs_of([ALL])), read_checklist().skills)
    assert [skill for skill in others if any(need.since for need in skill.needs)] == []


def test_a_skill_is_lost_by_the_latest_run_and_keeps_its_date():
    lost = skill(CLAMP, ALL, FAILED, past_result(passed=("examples",)))  # the last says nothing of it
    assert (lost.state, lost.since) == (State.LOST, START)
    assert lost.needs[0].failing == GROUPS[:1]
    begun_anew = skill(CLAMP, ALL, past_result(passed=(), failed=GROUPS))
    assert (begun_anew.state, begun_anew.since) == (State.SHOWN, START)


def levels_of(*results):
    return levels_passed(KATAS[0], runs_of(results))


def test_levels_are_counted_in_todays_groups_and_what_was_accepted_stays_so():
    interview, production = KataLevel
    names = [group.name for group in find_problem("segment").of_level(interview)]
    rest = [group.name for group in find_problem("segment").of_level(production)]
    assert levels_of(past_result(passed=names, failed=rest[:1])) == [interview]
    assert levels_of(past_result(passed=names[1:], failed=names[:1])) == []
    accepted = past_result(passed=("old", "older"))
    assert levels_of(accepted) == [interview, production]
    assert solved(runs_of([past_result(failed=("older",)), accepted, accepted])) == {"segment": days(1)}


def card(name, *rows, form="recall", **keys):
    return Card("deck", FORMS[form](id=name, front="?", back=".", rows=rows, **keys))


def answer(name, rating, when=START):
    return Answer(f"deck/{name}", "choice", rating, True, when=when)


def question(row, *results, cards=(), answers=(), hacks=()):
    checklist = Checklist((), (Section("s", "S"),), (row,))
    runs = runs_of(results)
    skilled = skills(KATAS, tried(runs), read_checklist().skills)
    mine = SimpleNamespace(problems=KATAS, solved=solved(runs), answers=answers)
    (found,) = questions(mine, skilled, checklist, cards, hacks)
    return found


def test_a_question_is_ticked_by_all_of_its_katas_that_are_here():
    row = ChecklistRow("J1", "s", "?", katas=("count", "segment", "later"))
    assert question(row, past_result("count")).state is State.OPEN
    ticked = question(row, past_result("count"), past_result("segment"))
    assert (ticked.state, ticked.since) == (State.SHOWN, days(1))
    assert ticked.drills == ("judge start count", "judge start segment")
    assert question(ChecklistRow("J1", "s", "?", katas=("later",))).by == ()


def test_or_by_all_of_its_skills_and_a_lost_one_is_lost():
    other = next(each for each in find_problem("segment").skills if not {*each.groups} & {*GROUPS})
    row = ChecklistRow("J1", "s", "?", skills=(CLAMP, other.name))
    assert question(row, ALL).state is State.OPEN
    assert question(row, ALL, past_result(passed=other.groups)).since == days(1)
    assert question(row, ALL, past_result(passed=other.groups), FAILED).state is State.LOST


def test_or_by_all_of_its_cards_if_they_were_known_when_they_were_last_answered():
    row = ChecklistRow("J1", "s", "?")
    cards = (
        card("a", "J1"),
        card("b", "J1", "J2"),
        card("c", "J2"),
        card("d", "J1", form="order", problem="later"),
    )
    known = [answer("a", Rating.GOOD), answer("b", Rating.HARD)]
    assert question(row, cards=cards, answers=known[:1]).state is State.OPEN
    assert question(row, cards=cards, answers=known).state is State.SHOWN
    forgotten = [*known, answer("b", Rating.AGAIN, days(1))]
    assert question(row, cards=cards, answers=forgotten).state is State.LOST
    again = [*forgotten, answer("b", Rating.GOOD, days(2))]
    assert question(row, cards=cards, answers=again).since == START


def test_or_by_one_mistake_that_was_broken():
    row = ChecklistRow("J1", "s", "?", broken=("count/a", "count/b", "later/c"))
    assert [each.name for each in question(row).by] == ["count/a", "count/b"]
    ticked = question(row, hacks=[Hack("count", "b", "0 0 1", Outcome.WON, when=days(1))])
    assert (ticked.state, ticked.since) == (State.SHOWN, days(1))
    assert ticked.drills == ("judge hack count a", "judge hack count b")


# -- what comes again ------------------------------------------------------------------------------------


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


def test_cards_that_are_due_come_first_then_those_that_are_new(learner_of):
    cards = [card("new"), card("good"), card("bad"), card("drawn", form="count", problem="count")]
    answers = [
        answer("good", Rating.GOOD),
        answer("bad", Rating.AGAIN, START + timedelta(minutes=1)),
        answer("drawn", Rating.EASY, START + timedelta(minutes=2)),
    ]
    found, now = card_reviews(answers), START + timedelta(days=1, hours=1)
    wanted = Wanted("", learner_of(answers=answers), [], Checklist())
    assert [each.content.id for each in wanted.of(cards, now, 10)] == ["bad", "new"]
    ahead = [each.content.id for each in wanted.of(cards, now, 10, ahead=True)]
    assert ahead == ["bad", "new", "good", "drawn"]
    assert next_due(cards[1:2], found) == next(each.due for each in found if each.name == "deck/good")
    assert next_due(cards[:1], found) is None


# -- topics ------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def learner_of():
    """A person who has solved all katas of these sets and skills, and has given these answers."""
    problems, _ = sound_problems()
    sets, _ = sound_sets(problems)

    def learner(*names, answers=()):
        there = [kata for each in sets if each.name in names for kata in each.problems]
        own = {kata.id: [passed(kata)] for kata in there}
        return Learner(problems, sets, dict.fromkeys(own, START), [], own, [], answers, [], [])

    return learner


def passed(kata):
    """What is looked at of a run that passed all groups."""
    return SimpleNamespace(passed=[each.name for each in kata.groups], failed=[], when=START, solved=True)


def drilled(mine, count):
    """The topics of a person who has answered no card, and so many cards that are asked next."""
    cards = cards_of("path")
    wanted = Wanted("", mine, cards, read_checklist())
    asked = wanted.of(cards, START, count)
    return wanted.topics, asked, plan(asked, count, wanted.topics)


def test_half_of_the_cards_are_of_what_is_open(learner_of):
    beginner, senior = (learner_of("first-steps", "junior"), learner_of("junior", "middle", "senior"))
    _, asked, planned = drilled(beginner, 8)
    keys = [each.key for each in asked[:8]]
    assert keys[:4] == [
        "middle/segment-clamp",
        "first-steps/one-point",
        "middle/segment-drawn",
        "junior/points-drawn",
    ]
    assert {each.deck for each in asked[4:8]} == {"junior"}
    assert [each.deck for each in planned] == ["first-steps", *["junior"] * 5, "middle", "middle"]
    _, asked, _ = drilled(senior, 8)
    assert [each.content.id for each in asked[:8]] == [
        *("segment-clamp", "units-of-delta", "segment-drawn", "fixed-epsilon"),
        *("many-circles", "two-phases", "far-end", "simd"),
    ]


def test_an_interview_has_a_card_of_each_open_topic(learner_of):
    cards = [each for each in cards_of("path") if each.deck == "senior"]
    found, asked, _ = drilled(learner_of("senior"), 8)
    chosen = plan([each for each in cards if not each.topics] + asked, 3, found)
    assert {topic for each in chosen for topic in each.topics} == {"clamp", "near-tangent"}


def test_the_kata_of_an_interview_is_of_the_own_set(learner_of):
    assert usual_kata("", learner_of()).id == "distance-squared"
    assert usual_kata("", learner_of("first-steps", "junior")).id == "line-points"
    assert usual_kata("senior", learner_of("first-steps")).id == "ray-nearest"


def test_a_skill_is_known_if_its_run_shows_it_and_its_last_card_was_right(learner_of):
    every = ("first-steps", "junior", "middle", "senior", "professional")
    clamping = [card for card in cards_of("path") if "clamp to a segment" in card.skills]
    right = [Answer(each.key, each.form, Rating.GOOD, judged=True, when=START) for each in clamping]
    wrong = Answer(clamping[0].key, "recall", Rating.AGAIN, judged=True, when=START + timedelta(days=1))
    later = Answer(clamping[1].key, "choice", Rating.GOOD, judged=True, when=START + timedelta(days=2))

    def open_(mine):
        return next(each.open for each in drilled(mine, 8)[0] if each.name == "clamp")

    assert "clamp to a segment" in open_(learner_of(answers=right))
    assert "clamp to a segment" in open_(learner_of(*every))
    assert "clamp to a segment" not in open_(learner_of(*every, answers=right))
    assert "clamp to a segment" in open_(learner_of(*every, answers=[*right, wrong]))
    assert "clamp to a segment" not in open_(learner_of(*every, answers=[*right, wrong, later]))
    assert "ends no wider than rounding" not in open_(learner_of(*every))  # which has no card


# -- an evening --------------------------------------------------------------------------------------------


def drill(mine, cards, checklist, hacks=(), now=START):
    """The commands of an evening."""
    return list(evening(Wanted("", mine, cards, checklist), cards, hacks, now))


def test_an_evening_is_cards_a_wrong_program_and_a_kata(learner_of):
    cards, checklist = cards_of("path"), read_checklist()
    steps = drill(learner_of("first-steps", "junior"), cards, checklist)
    assert [each.command for each in steps] == [
        "judge quiz clamp",
        "judge hack segment 2",
        "judge start line-points",
    ]
    (first, *_) = read_puzzles(find_problem("segment"), checklist.drilled())[1:]
    broken = [Hack("segment", first.mistake, "", Outcome.WON)]
    steps = drill(learner_of("first-steps", "junior"), cards, checklist, broken)
    assert steps[1].command == "judge hack segment 3"
    missed = Answer("junior/equality-test", "choice", Rating.AGAIN, judged=True, when=START)
    tomorrow = START + timedelta(days=1)
    steps = drill(learner_of("junior", answers=[missed]), cards, checklist, now=tomorrow)
    asked = [(each.command, each.due) for each in steps if each.command.startswith("judge quiz")]
    assert asked == [("judge quiz clamp", 0), ("judge quiz near-tangent", 1)]


def test_a_newcomer_writes_a_program_before_breaking_one(learner_of):
    steps = drill(learner_of(), cards_of("path"), read_checklist())
    assert [each.command for each in steps] == [
        "judge quiz near-tangent",  # the other topic has no card for beginners
        "judge start distance-squared",
    ]


def test_an_evening_of_whom_nothing_is_open(learner_of):
    every = ("first-steps", "junior", "middle", "senior", "professional")
    cards = cards_of("path")
    right = [Answer(each.key, each.form, Rating.GOOD, judged=True, when=START) for each in cards]
    mine = learner_of(*every, answers=right)
    assert not any(each.open for each in Wanted("", mine, cards, read_checklist()).topics)
    left = [each.id for each in mine.problems if each.id not in mine.solved]
    assert [each.command for each in drill(mine, cards, read_checklist())] == [
        f"judge start {each}" for each in left
    ]


def test_a_pack_without_topics_has_an_evening_too(learner_of):
    plain = Checklist(rows=(ChecklistRow("A", "s", "?"),))
    cards = [card("one"), card("two")]
    assert drill(learner_of("junior"), cards, plain)[0].command == "judge quiz"
    assert drill(learner_of("junior"), cards, plain)[0].new == 2
    assert [each.command for each in drill(learner_of("junior"), [], plain)] == ["judge start line-points"]

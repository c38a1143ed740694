"""What ticks a row of the checklist, what takes the tick away, and when a card comes again."""

from __future__ import annotations

from datetime import timedelta

from past_runs import START

from judge.kata.checklist import Kind, Record, Row, assess_rows
from judge.kata.events import Answer, Rating
from judge.kata.quiz.cards import Card
from judge.kata.quiz.choose import due_cards, new_cards, next_cards, next_due
from judge.kata.review import card_reviews
from judge.kata.skills import Need, NeedProgress, Skill, SkillProgress, SkillState
from judge.kata.standing import Standing

LATER = START + timedelta(days=1)


def card(name, *rows, form="choice", sets=(), problem=""):
    return Card("deck", name, form, "?", ".", rows=rows, sets=sets, problem=problem)


def answered(name, rating, when=START):
    return Answer(f"deck/{name}", "choice", rating, True, when=when)


def skill(name, since, failing=()):
    need = NeedProgress(Need("count", ("grid",)), since, failing, 1, {})
    return SkillProgress(Skill(name, "", (need.need,)), (need,))


def state(row, *, passed=(), skills=(), answers=(), broken=None, cards=(), here=("count", "segment")):
    standings = {name: Standing(1, 100, START, START) for name in passed}
    record = Record(standings, skills, answers, broken or {})
    (found,) = assess_rows([row], record, cards, here)
    return found


def test_all_of_its_katas_that_are_here_must_be_passed():
    row = Row("J1", "s", "?", katas=("count", "segment", "later"))
    assert state(row, passed=("count",)).state is SkillState.OPEN
    ticked = state(row, passed=("count", "segment"))
    assert (ticked.state, ticked.since) == (SkillState.SHOWN, START)
    assert ticked.drills == ("judge init count", "judge init segment")
    assert state(row, here=()).evidence == ()
    assert state(row, here=()).state is SkillState.OPEN


def test_all_of_its_skills_must_be_shown_and_a_lost_one_is_lost():
    row = Row("J1", "s", "?", skills=("a", "b"))
    assert state(row, skills=[skill("a", START), skill("b", None)]).state is SkillState.OPEN
    assert state(row, skills=[skill("a", START), skill("b", LATER)]).since == LATER
    assert state(row, skills=[skill("a", START), skill("b", START, ("grid",))]).state is SkillState.LOST


def test_all_of_its_cards_must_be_known_when_they_were_last_answered():
    row = Row("J1", "s", "?")
    cards = (card("a", "J1"), card("b", "J1", "J2"), card("c", "J2"), card("d", "J1", problem="later"))
    known = [answered("a", Rating.GOOD), answered("b", Rating.HARD)]
    assert state(row, cards=cards, answers=known[:1]).state is SkillState.OPEN
    assert state(row, cards=cards, answers=known).state is SkillState.SHOWN
    forgotten = [*known, answered("b", Rating.AGAIN, LATER)]
    assert state(row, cards=cards, answers=forgotten).state is SkillState.LOST
    assert state(row, cards=cards, answers=[*forgotten, answered("b", Rating.GOOD, LATER)]).since == START


def test_one_mistake_that_was_broken_is_enough():
    row = Row("J1", "s", "?", broken=("count/a", "count/b", "later/c"))
    assert [each.name for each in state(row).of(Kind.BROKEN)] == ["count/a", "count/b"]
    ticked = state(row, broken={"count/b": LATER})
    assert (ticked.state, ticked.since) == (SkillState.SHOWN, LATER)
    assert ticked.drills == ("judge hack count a", "judge hack count b")


def test_what_is_due_comes_first_then_what_is_new():
    cards = [card("new"), card("good"), card("bad"), card("drawn", form="count")]
    answers = [
        answered("good", Rating.GOOD),
        answered("bad", Rating.AGAIN, START + timedelta(minutes=1)),
        answered("drawn", Rating.EASY, START + timedelta(minutes=2)),
    ]
    found, now = card_reviews(answers), START + timedelta(days=1, hours=1)
    assert [each.id for each in due_cards(cards, found, now)] == ["bad"]
    assert [each.id for each in new_cards(cards, found)] == ["new"]
    assert [each.id for each in next_cards(cards, found, now, 5)] == ["bad", "new"]
    ahead = [each.id for each in next_cards(cards, found, now, 7, ahead=True)]
    assert ahead == ["bad", "new", "good", "drawn", "drawn", "drawn", "drawn"]
    assert next_due(cards[1:2], found) == next(each.due for each in found if each.name == "deck/good")
    assert next_due(cards[:1], found) is None

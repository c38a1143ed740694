"""Every question of the topic is in the checklist, and can be drilled with what is here."""

from __future__ import annotations

from collections import Counter

import pytest

from judge.kata.checklist import Kind, Record, assess_rows, read_checklist
from judge.kata.quiz.cards import all_cards
from judge.kata.skills import assess, skills_of
from judge.mistakes.puzzles import read_puzzles
from judge.problem.find import all_problems, find_problem

# How many questions each table of the topic has, by what the rows' ids begin with.
TABLES = {
    "Q": 14,  # the self-assessment, one to one
    "J": 19,  # junior, with the extended ones
    "M": 21,
    "S": 19,
    "P": 14,  # professional
    "R": 8,  # rapid fire
    "D": 4,  # told at length
    "X": 7,  # beyond the topic
    "W": 7,  # scenarios at the whiteboard
    "C": 7,  # complexity
    "F": 8,  # pitfalls
    "U": 4,  # follow-ups of the challenge
}


@pytest.fixture(autouse=True)
def _no_other_pack(monkeypatch):
    monkeypatch.delenv("JUDGE_PROBLEMS", raising=False)


@pytest.fixture(scope="module")
def rows():
    return read_checklist().rows


def test_no_question_of_the_tables_is_missing(rows):
    wanted = [f"{table}{number}" for table, many in TABLES.items() for number in range(1, many + 1)]
    assert [row.id for row in rows] == wanted
    assert len({row.ask for row in rows}) == len(rows) - 1  # the exact count is a question and a follow-up


def test_each_section_is_one_table_and_the_first_is_what_to_be_ready_for(rows):
    sections = read_checklist().sections
    assert sections[0].id == "ready"
    tables = {section.id: {row.id[0] for row in rows if row.section == section.id} for section in sections}
    assert [table for found in tables.values() for table in found] == list(TABLES)


def test_every_row_can_be_drilled_by_a_card_and_names_only_what_is_here(rows):
    problems = all_problems()
    here = {problem.id for problem in problems}
    assert {name for row in rows for name in row.katas} <= here
    explained = {skill.name for skill in skills_of(problems)}
    assert {name for row in rows for name in row.skills} <= explained
    cards = all_cards()
    record = Record({}, assess(skills_of(problems), [], problems), (), {})
    for progress in assess_rows(rows, record, cards, here):
        assert progress.of(Kind.CARD), progress.row.id
        assert progress.drills, progress.row.id
        assert f"judge quiz --row {progress.row.id}" in progress.drills


def test_every_card_belongs_to_a_row():
    assert [card.key for card in all_cards() if not card.rows] == []


def test_every_mistake_that_ticks_a_row_is_there_to_be_broken(rows):
    named = {name for row in rows for name in row.broken}
    assert len(named) > 20
    of_problem = {}
    for name in named:
        problem, mistake = name.split("/")
        of_problem.setdefault(problem, set()).add(mistake)
    for problem, mistakes in of_problem.items():
        assert mistakes <= {puzzle.mistake for puzzle in read_puzzles(find_problem(problem))}, problem


def test_the_forms_are_mixed():
    forms = Counter(card.form for card in all_cards())
    assert set(forms) == {"recall", "choice", "number", "count", "first-hit", "order", "tags", "spot"}
    assert forms["recall"] < sum(forms.values()) / 2  # most are judged

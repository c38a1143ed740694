"""Decks and the checklist: what ships keeps to its schema and is whole; a fault is told in one line."""

from __future__ import annotations

import tomllib
from collections import Counter
from pathlib import Path

import pytest
from jsonschema import Draft202012Validator

from judge.errors import ProblemError, UsageError
from judge.kata.checklist import Kind, Record, assess_rows, find_row, in_set, read_checklist
from judge.kata.quiz.cards import all_cards, cards_of, sound_decks
from judge.kata.quiz.forms import WANTS
from judge.kata.skills import assess, skills_of
from judge.mistakes.puzzles import read_puzzles
from judge.problem.find import all_problems, find_problem
from judge.schema import files, schema_of_file

ROOT = Path(__file__).parents[2]
DECKS = sorted((ROOT / "problems" / "quiz").glob("*.toml"))
HEAD = 'title = "Mine"\n\n'
CARD = '[[cards]]\nid = "a"\nform = "recall"\nfront = "F?"\nback = "B."\n'
CHOICE = '[[cards]]\nid = "a"\nform = "choice"\nfront = "F?"\nback = "B."\nright = "r"\n'
ROW = 'id = "a"\nsection = "s"\nask = "?"\n'
WRONG = '[[cards.wrong]]\ntext = "w"\nmistake = "m"\nwhy = "y"\n'


@pytest.fixture(autouse=True)
def _no_other_pack(monkeypatch):
    monkeypatch.delenv("JUDGE_PROBLEMS", raising=False)


@pytest.fixture
def deck(tmp_path):
    """Write a deck into a folder of problems of one's own."""
    folder = tmp_path / "problems"
    (folder / "quiz").mkdir(parents=True)

    def write(text, name="mine"):
        (folder / "quiz" / f"{name}.toml").write_text(text, encoding="utf-8")
        return [folder]

    return write


def test_decks_are_there():
    assert [path.stem for path in DECKS] == ["junior", "middle", "professional", "quick", "senior"]
    assert files() == ["cards", "checklist"]


@pytest.mark.parametrize("path", DECKS, ids=lambda path: path.stem)
def test_a_shipped_deck_keeps_to_the_schema(path):
    Draft202012Validator(schema_of_file("cards")).validate(tomllib.loads(path.read_text(encoding="utf-8")))


def test_the_shipped_checklist_keeps_to_the_schema():
    text = (ROOT / "problems" / "checklist.toml").read_text(encoding="utf-8")
    Draft202012Validator(schema_of_file("checklist")).validate(tomllib.loads(text))


def test_the_schema_knows_every_form_with_its_keys():
    forms = schema_of_file("cards")["properties"]["cards"]["items"]["anyOf"]
    told = {}
    for each in forms:
        form = each["properties"]["form"]
        for name in form.get("enum") or [form["const"]]:
            told[name] = (set(each["required"]), set(each["properties"]))
    assert set(told) == set(WANTS)
    for name, wants in WANTS.items():
        required, known = told[name]
        back = set() if "back" in wants.takes else {"back"}
        assert required == {"id", "form", "front", *wants.needs, *back}
        assert known == {"id", "form", "front", "back", "rows", *wants.needs, *wants.takes}


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("title = 3\n", "quiz/mine.toml:1: title is a whole number; give text"),
        ('title = "M"\n', "the key 'cards' is missing"),
        (HEAD + "cards = []\n", "the deck has no card"),
        ('title = "M"\nsets = ["juniro"]\n' + CARD, "mine.toml:2: no practice set is called 'juniro'"),
        (HEAD + CARD + CARD, "quiz/mine.toml:9: the card 'a' is there twice"),
        (HEAD + CARD.replace('"a"', '"A b"'), "quiz/mine.toml:4: 'A b' is no id"),
        (HEAD + CARD.replace("recall", "recal"), "mine.toml:5: no form of cards is called 'recal'; did you"),
        (HEAD + CARD.replace('back = "B."\n', ""), "mine.toml:3: the key 'back' is missing, which recall"),
        (HEAD + CARD + 'right = "r"\n', "quiz/mine.toml:8: 'right' is no key of the form recall; remove it"),
        (HEAD + CARD + 'sort = "r"\n', "unknown key 'sort'"),
        (HEAD + CARD.replace('"F?"', '" "'), "quiz/mine.toml:6: front is empty"),
        (HEAD + CARD + 'rows = ["J1", "J99"]\n', "quiz/mine.toml:8: the checklist has no row 'J99'"),
        (HEAD + CHOICE, "the key 'wrong' is missing, which choice asks for"),
        (HEAD + CHOICE + WRONG.replace('"w"', '"r"'), "two options say 'r'"),
        (HEAD + CHOICE + WRONG.replace('"m"', '""'), "a wrong option is empty"),
        (HEAD + CHOICE + WRONG * 8, "there are 8 wrong options; write 1 to 7"),
        (HEAD + CARD.replace("recall", "number") + 'answer = "x"\n', "answer = 'x' is no number"),
        (HEAD + CARD.replace("recall", "number") + 'answer = "1"\nwithin = 2.0\n', "within is 2.0"),
        (HEAD + CARD.replace("recall", "count"), "the key 'problem' is missing, which count asks for"),
        (HEAD + CARD.replace("recall", "count") + 'problem = "count"\nlargest = -1\n', "largest is -1"),
        ("title = \n", "quiz/mine.toml:1: no TOML"),
    ],
)  # fmt: skip
def test_a_fault_of_a_deck_is_one_line_with_its_place(deck, text, said):
    where = deck(text)
    with pytest.raises(ProblemError) as fault:
        all_cards(where)
    assert said in str(fault.value)
    assert "\n" not in str(fault.value)
    assert str(fault.value).startswith("quiz/mine.toml")
    decks, faults = sound_decks(where)  # the others are there all the same
    assert len(faults) == 1
    assert {each.name for each in decks} == {path.stem for path in DECKS}


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (f"{ROW}\n[[rows]]\n{ROW}", ":11: the row 'a' is there twice"),
        (ROW.replace('"s"', '"t"'), ":7: no section is called 't'; the sections are s"),
        (ROW + 'broken = ["x"]\n', ":9: 'x' names no mistake"),
    ],
)  # fmt: skip
def test_a_fault_of_a_checklist_is_one_line_with_its_place(tmp_path, text, said):
    file = tmp_path / "checklist.toml"
    file.write_text(f'[[sections]]\nid = "s"\ntitle = "S"\n\n[[rows]]\n{text}', encoding="utf-8")
    with pytest.raises(ProblemError) as fault:
        read_checklist([tmp_path])
    assert said in str(fault.value)


def test_a_deck_of_ones_own_is_asked_by_its_name_and_with_its_sets(deck):
    where = deck(HEAD.replace("\n\n", '\nsets = ["senior"]\n') + CARD)
    cards = all_cards(where)
    assert [card.key for card in cards_of("mine", cards, where)] == ["mine/a"]
    assert "mine/a" in [card.key for card in cards_of("senior", cards, where)]
    assert "mine/a" not in [card.key for card in cards_of("junior", cards, where)]
    assert len(cards_of("path", cards, where)) == len(cards)
    with pytest.raises(UsageError, match="no set of cards is called 'mien'; did you mean 'mine'"):
        cards_of("mien", cards, where)
    with pytest.raises(UsageError, match="the set 'first-steps' has no cards; cards are in junior, "):
        cards_of("first-steps", cards, where)


def test_a_row_is_found_in_any_case_and_a_set_has_its_sections():
    checklist = read_checklist()
    assert find_row("j4", checklist).id == "J4"
    with pytest.raises(UsageError, match="no row 'J40'; did you mean 'J"):
        find_row("J40", checklist)
    assert {row.section for row in in_set(checklist, "senior", "path").rows} == {"senior"}
    assert in_set(checklist, "path", "path") == checklist


# -- every question of the topic can be drilled with what is here ----------------------------------

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


@pytest.mark.slow
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

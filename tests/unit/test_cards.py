"""Decks and the checklist: what ships keeps to its schema and is whole; a fault is told in one line."""

from __future__ import annotations

import tomllib
from pathlib import Path
from types import SimpleNamespace

import pytest
from jsonschema import Draft202012Validator

from judge.errors import ProblemError, UsageError
from judge.mistakes.puzzles import read_puzzles
from judge.practice.cards import cards_of, read_decks
from judge.practice.progress import EvidenceKind, questions, skills
from judge.practice.syllabus import read_checklist
from judge.problem.find import find_problem, sound_problems
from judge.schema import schema_of_file

ROOT = Path(__file__).parents[2]
DECKS = sorted((ROOT / "problems" / "quiz").glob("*.toml"))
CHECKLIST = ROOT / "problems" / "checklist.toml"
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


@pytest.mark.parametrize("path", [*DECKS, CHECKLIST], ids=lambda path: path.stem)
def test_what_is_shipped_keeps_to_its_schema(path):
    schema = schema_of_file("checklist" if path == CHECKLIST else "cards")
    Draft202012Validator(schema).validate(tomllib.loads(path.read_text(encoding="utf-8")))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("title = 3\n", "quiz/mine.toml:1: title is a whole number; give text"),
        (HEAD + "cards = []\n", "the deck has no card"),
        (HEAD + CARD + CARD, "quiz/mine.toml:9: 'a' is there twice"),
        (HEAD + CARD.replace("recall", "recal"), ":5: form = 'recal' is unknown; did you mean 'recall'?"),
        (HEAD + CARD.replace('back = "B."\n', ""), ":3: the key 'back' is missing in cards; add back"),
        (HEAD + CARD + 'right = "r"\n', ":8: unknown key 'right'; the keys are id, front, back, rows"),
        (HEAD + CARD.replace('"F?"', '""'), "quiz/mine.toml:6: cards.front = ''; use a sentence"),
        (HEAD + CARD.replace('"F?"', '" "'), "quiz/mine.toml:6: cards.front = ' '; use a sentence"),
        (HEAD + CARD + 'rows = ["J1", "J99"]\n', "quiz/mine.toml:8: the checklist has no row 'J99'"),
        (HEAD + CHOICE, "the key 'wrong' is missing in cards"),
        (HEAD + CHOICE + WRONG.replace('"w"', '"r"'), "two options say 'r'"),
        (HEAD + CHOICE + WRONG * 8, "there are 8 wrong options; write 1 to 7"),
        (HEAD + CARD.replace("recall", "number") + 'answer = "x"\n', "answer = 'x' is not a number"),
        (HEAD + CARD.replace("recall", "count"), "the key 'problem' is missing in cards"),

    ],
)  # fmt: skip
def test_a_fault_of_a_deck_is_one_line_with_its_place(deck, text, said):
    where = deck(text)
    with pytest.raises(ProblemError) as fault:
        cards_of("path", where)
    assert said in str(fault.value)
    assert "\n" not in str(fault.value)
    assert str(fault.value).startswith("quiz/mine.toml")
    cards, faults = read_decks(where)  # the others are there all the same
    assert len(faults) == 1
    assert {card.deck for card in cards} == {path.stem for path in DECKS}


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (f"{ROW}\n[[rows]]\n{ROW}", ":11: 'a' is there twice"),
        (ROW + 'broken = ["x"]\n', ":9: 'x' does not name a mistake"),
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
    assert [card.key for card in cards_of("mine", where)] == ["mine/a"]
    assert "mine/a" in [card.key for card in cards_of("senior", where)]
    assert "mine/a" not in [card.key for card in cards_of("junior", where)]
    assert len(cards_of("path", where)) == len(read_decks(where)[0])
    with pytest.raises(UsageError, match="There is no set of cards 'mien'; did you mean 'mine'"):
        cards_of("mien", where)


def test_a_topic_is_asked_by_its_name(deck):
    clamp, near = ({card.key for card in cards_of(name)} for name in ("clamp", "near-tangent"))
    assert (len(clamp), len(near), clamp & near) == (7, 14, set())
    where = deck(HEAD + CARD + 'rows = ["M18"]\n')
    assert "mine/a" in [card.key for card in cards_of("clamp", where)]


@pytest.fixture(scope="module")
def rows():
    return read_checklist().rows


def test_every_row_can_be_drilled_by_a_card_and_names_only_what_is_here(rows):
    problems = sound_problems()[0]
    here = {problem.id for problem in problems}
    assert {name for row in rows for name in row.katas} <= here
    assert {name for row in rows for name in row.skills} <= {each.name for each in read_checklist().skills}
    cards = cards_of("path")
    assert [card.key for card in cards if not card.content.rows] == []
    checklist, mine = read_checklist(), SimpleNamespace(problems=problems, solved={}, answers=[])
    found = questions(mine, skills(problems, {}, checklist.skills), checklist, cards, [])
    assert [progress.row for progress in found] == [row.id for row in rows]
    for progress in found:
        assert EvidenceKind.CARD in [each.kind for each in progress.by], progress.row
        assert progress.drills, progress.row
        assert any(drill.startswith("judge quiz") for drill in progress.drills), progress.row


@pytest.mark.nightly
def test_every_mistake_that_ticks_a_row_is_there_to_be_broken(rows):
    named = {name for row in rows for name in row.broken}
    assert len(named) > 20
    of_problem = {}
    for name in named:
        problem, mistake = name.split("/")
        of_problem.setdefault(problem, set()).add(mistake)
    for problem, mistakes in of_problem.items():
        assert mistakes <= {puzzle.mistake for puzzle in read_puzzles(find_problem(problem))}, problem

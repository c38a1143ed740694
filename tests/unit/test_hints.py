"""Steps of hints.md, and one clear line for every fault in it."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from judge.errors import ProblemError
from judge.problem.load import load_problem
from judge.problem.texts import read_hints

ROOT = Path(__file__).parents[2]
SOUND = ROOT / "tests" / "fixtures" / "problems" / "root-count"


@pytest.fixture
def hinting(tmp_path):
    """Reads the hints of the sound problem with that text as its hints.md."""

    def read(text):
        folder = tmp_path / "problems" / "root-count"
        shutil.copytree(SOUND, folder, dirs_exist_ok=True)
        (folder / "hints.md").write_bytes(text if isinstance(text, bytes) else text.encode())
        return read_hints(load_problem(folder))

    return read


def test_steps_have_a_number_a_title_and_a_text(hinting):
    hints = hinting("# Hints\n\n## A nudge\n\nBetween {{c.low}} and {{c.high}}.\n\n## More\nx\n\n    y = 2\n")
    assert [(hint.number, hint.title, hint.text) for hint in hints] == [
        (1, "A nudge", "Between -9 and 9."),
        (2, "More", "x\n\n    y = 2"),
    ]


def test_a_comment_in_a_code_block_is_no_step(hinting):
    (hint,) = hinting("## One\n```python\n## not two\n```\n### nor this\n")
    assert hint.text == "```python\n## not two\n```\n### nor this"
    assert read_hints(load_problem(SOUND)) == (), "without a file there are none"


@pytest.mark.parametrize(
    ("text", "where", "words"),
    [
        ("", "hints.md", "it has no step; begin each step with a line '## Its title'"),
        ("# Hints\n\nThink.\n", "hints.md:3", "belongs to no step"),
        ("## One\nx\n##\ny\n", "hints.md:3", "the step '' has no title or says nothing"),
        ("## One\n\n## Two\ny\n", "hints.md:1", "'One' has no title or says nothing"),
        ("## One\n{{c.hihg}}\n", "hints.md:2", "did you mean {{c.high}}?"),
        (b"## One\n\xff\n", "hints.md", "byte 7 is not UTF-8"),
    ],
)
def test_a_fault_is_one_line(hinting, text, where, words):
    with pytest.raises(ProblemError) as raised:
        hinting(text)
    told = str(raised.value)
    assert told.startswith(f"root-count/{where}: ")
    assert words in told
    assert "\n" not in told

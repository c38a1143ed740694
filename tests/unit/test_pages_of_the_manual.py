"""Pages of the manual say what is true: every key, type and hook, and formulas that compute."""

from __future__ import annotations

import doctest
import inspect
import re
import tomllib
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import msgspec

from judge.drawing.braille import to_braille
from judge.drawing.svg import panel_svg
from judge.problem.declare import Hooks, group
from judge.problem.model import GroupLimits, KataLevel, Parameter, Source, TimeRule
from judge.problem.read import Head
from judge.values.answers import Tolerance, Words
from judge.values.grammar import NAMES

ROOT = Path(__file__).parents[2]
MANUAL = ROOT / "judge" / "manual"
PAGE = (MANUAL / "problem.md").read_text(encoding="utf-8")
TABLES = {
    "The file": Head,
    "Parameters": Parameter,
    "Limits": GroupLimits,
    "Tolerance": Tolerance,
    "Time": TimeRule,
    "Words": Words,
    "Source": Source,
}


def sections() -> dict[str, str]:
    parts = re.split(r"^## (.*)$", PAGE, flags=re.MULTILINE)
    return dict(zip(parts[1::2], parts[2::2], strict=True))


def told(section: str) -> dict[str, bool]:
    """The keys that a section lists, each with whether it may be missing."""
    rows = re.findall(r"^- `(\w+)`(, required)?: ", sections()[section], re.MULTILINE)
    return {key: not required for key, required in rows}


def test_every_key_of_the_loader_is_told_and_no_other_with_an_example():
    for section, table in TABLES.items():
        keys = {field.name: not field.required for field in msgspec.structs.fields(table)}
        if table is Parameter:  # its name is the row's own key
            del keys["name"]
        assert told(section) == keys
        (example, *_) = re.findall(r"^```toml\n(.*?)^```$", sections()[section], re.MULTILINE | re.DOTALL)
        assert tomllib.loads(example), section


def test_every_type_of_the_loader_is_told():
    rows = set(re.findall(r"`([^`]+)`", re.sub(r"^```.*?^```$", "", sections()["Types"], flags=re.M | re.S)))
    told = {word for row in rows for word in re.findall(r"^[a-z][a-z0-9-]*", row)}
    assert set(NAMES) <= told


def test_every_name_and_every_hook_of_a_problem_py_is_told():
    rows = re.findall(r"^- `(\w+)", sections()["problem.py"], re.MULTILINE)
    names = ["solve", *(level.name for level in KataLevel), "GROUPS", "HOOKS", "FORMAT", "EXAMPLES"]
    arguments = [*inspect.signature(group).parameters]
    assert rows == [*names, *arguments, *Hooks.__struct_fields__]


def test_every_formula_computes_what_its_example_shows():
    text = (MANUAL / "formulas.md").read_text(encoding="utf-8")
    examples = "\n".join(re.findall(r"(?ms)^```py\n(.*?)^```$", text))
    ended = doctest.DocTestRunner().run(
        doctest.DocTestParser().get_doctest(examples, {}, "formulas.md", None, 0)
    )
    assert (ended.failed, ended.attempted > 20) == (0, True)


def test_the_picture_of_the_example_is_drawn():
    (example,) = re.findall(r"^```py\n(.*?)^```$", sections()["Pictures"], re.MULTILINE | re.DOTALL)
    names: dict[str, Any] = {}
    exec(example, names)
    picture = names["HOOKS"].picture(SimpleNamespace(values={"xs": [3, 141, 59]}))
    rows = ["".join(piece.text for piece in row) for row in to_braille(picture)]
    assert re.search(r" 3 .*141o .* 59", "\n".join(rows))
    assert rows[-1] == "o expected"
    assert panel_svg(picture.whole, "a", picture.description).count(">141<") == 1


SECURITY = (MANUAL / "sandbox.md").read_text(encoding="utf-8")


def test_every_file_it_names_is_there():
    named = re.findall(r"`((?:tests|judge)/[\w./-]+\.(?:py|toml))`", SECURITY)
    assert len(named) > 15
    assert [path for path in named if not (ROOT / path).exists()] == []

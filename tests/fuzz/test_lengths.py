"""What reads a text from outside takes time as the text grows, and the fuzz would see what does not."""

from __future__ import annotations

import re

import lengths
import pytest
from lengths import READERS, Case, counted, growth, halved, repeated, steep
from sampling import nightly

PAIRS = 30  # of tokens, for each reader

# Each of these once took the square of its length, or its cube, or had no end: one of a kind every day.
ONCE = [
    ("c problem", halved("x line_count(", ")")),
    ("cpp problem", repeated("auto line_count()->")),
    ("cpp normal", repeated('R"(')),
    nightly("go sources", repeated("Pt struct{")),
    nightly("java sources", repeated("int lineCount(")),
    ("java sources", halved("<", ">", "class A { static int lineCount(", ") {")),
    nightly("javascript sources", repeated("\nimport {")),
    ("javascript sources", repeated("=/[")),
    ("rust sources", repeated("a", "struct Pt {")),
    nightly("rust sources", repeated("#![", "//")),
    ("toml", repeated("a.", "", "a=1")),
    ("students", repeated("\u0301\u0316", "a")),
    ("annotation", counted("a_name_of_forty_letters_that_nobody_has_N = 1\n")),
    nightly("complaint", repeated("1")),
    ("complaint", repeated(" ", "a.c:1:", "warning")),
]


@pytest.mark.parametrize(
    ("reader", "text"), ONCE, ids=lambda each: each if isinstance(each, str) else repr(each(40))
)
def test_a_text_that_took_its_square(reader, text):
    found = growth(Case(reader, repr(text(40)), text))
    assert found is None or not found.steep or not growth(found.case).steep, str(found)


@pytest.mark.parametrize("reader", [nightly(reader) for reader in READERS])
def test_no_text_takes_its_square(reader):
    assert [str(found) for found in steep(reader, PAIRS)] == []


@pytest.mark.parametrize(
    ("pattern", "token", "steep"), [(r"a\s+b", " ", False), (r"\s+b", " ", True), (r"(?:a|aa)+b", "a", True)]
)
def test_what_takes_its_square_is_seen(pattern, token, steep, monkeypatch):
    monkeypatch.setitem(READERS, "made up", re.compile(pattern).search)
    monkeypatch.setattr(lengths, "ENDLESS", 0.2)
    found = growth(Case("made up", pattern, repeated(token)))
    assert (found is not None and found.steep) == steep

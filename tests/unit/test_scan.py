"""A stranger's text is looked through once: comments, strings, heads, and what a pattern may cost."""

from __future__ import annotations

import random
import re

import pytest
from steps import steps

from judge.errors import JudgeError
from judge.languages import scan
from judge.languages.model import language_called, languages
from judge.languages.scan import changed, met, reading, stripped, usual_tokens

MOST_STEPS = 200_000
RAW = language_called("cpp").tokens


@pytest.mark.parametrize(
    ("language", "source", "left"),
    [
        ("c", 'a // b "\nc /* d */ e', "a  \nc   e"),
        ("c", 'a "b\\"c" d', "a   d"),
        ("c", "a /* b\nc // d", "a  \n"),  # a comment without an end goes to the end of the text
        ("c", 'a "b\nc', "a  \nc"),  # and such a string to that of its line
        ("cpp", 'a R"x(b)" c" )x" d', "a   d"),
        ("rust", "fn f<'a>(b: &'a str) r#\"c\"d\"# e '\"'", "fn f<'a>(b: &'a str)   e  "),
        ("javascript", "a = /[/\"]'/; b 'it' `c\n${d}`", "a = ; b    \n"),
        ("java", 'a """b "c\n""" d', "a  \n d"),
        ("pypy", "a # it's\nb '''c\nd''' e", "a  \nb  \n e"),
        ("go", "a `b\n\\` c '`' d", "a  \n c   d"),
    ],
)
def test_comments_and_strings_are_taken_out(language, source, left):
    assert stripped(source.encode(), language_called(language).tokens) == left


PIECES = ['"', "'", "\\", "/", "*", "//", "/*", "*/", "`", "\n", "a", 'R"', "(", ")", 'R"a(', ')a"', "'a'"]


@pytest.mark.parametrize("seed", range(6))
def test_windows_change_nothing(seed, monkeypatch):
    chance = random.Random(seed)
    text = "".join(chance.choice(PIECES) * chance.choice((1, 1, 1, 300)) for _ in range(200))
    words = re.compile(r"\w+|[(*]{1,9}")
    once = stripped(text.encode(), RAW), [each.span() for each in met(words, text)]
    swapped = changed(text.encode(), "a", lambda found: "A", RAW)
    monkeypatch.setattr(scan, "AT_ONCE", 40)
    monkeypatch.setattr(scan, "WINDOW", 400)
    assert once == (stripped(text.encode(), RAW), [each.span() for each in met(words, text)])
    assert once[1] == [each.span() for each in words.finditer(text)]
    assert swapped == changed(text.encode(), "a", lambda found: "A", RAW)


def test_a_change_keeps_comments_strings_and_every_byte():
    source = 'á b // b\n"b" b\xff'.encode("latin-1")
    assert changed(source, r"\bb\b", lambda found: "c", usual_tokens("//")) == source.replace(
        b" b", b" c"
    ).replace(b"// c", b"// b")


@pytest.mark.parametrize(
    "pattern",
    [
        *(r"\s+f\s*\(", r"(a*)*b", r"(?:a|aa)+b", r"a*a*b", r".{0,999}.{0,999}x", r"(?:ab?){0,99}c"),
        *(r"(?>a*a*b)", r"(?:[^x]*y|z)*", r"(?>(?:a*a*b){1,9})", r"(?:(?:a{0,99}){0,99}+){0,99}+b"),
        *(r"(?P<b>a*)(?P=b)*c", r"(?>(?:a|aa){40,99})b", r"(a)?(?(1)a*|b*)a*c"),
    ],
)
def test_a_pattern_that_may_take_many_steps_is_seen(pattern):
    assert steps(pattern) > MOST_STEPS


def test_no_pattern_of_a_language_takes_many_steps():
    taken = {(each.name, key, one): steps(one) for each in languages() for key, one in each.patterns()}

    assert len(taken) > 40
    assert {place: count for place, count in taken.items() if count > MOST_STEPS} == {}


SLOW = re.compile("a{0,7000}b")


def test_a_text_that_takes_too_long_is_given_up(monkeypatch):
    """However long it is: it is looked at only until the time is up."""
    monkeypatch.setattr(scan, "SECONDS", 0.2)
    assert steps(SLOW.pattern) < MOST_STEPS
    with pytest.raises(JudgeError) as fault, reading("a.c"):
        list(met(SLOW, "a" * 10**8))
    assert str(fault.value) == (
        "a.c: it takes more than 0.2 s to look through this text; take out what no person would write"
    )

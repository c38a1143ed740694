"""What a function prints is shown with the failing case, harmless, bounded and never taken for an answer."""

from __future__ import annotations

import json

import pytest

from judge.run.printed import LENGTH, LINES, message_of, text_of

pytestmark = pytest.mark.slow

PRINTED = "print('at import')\ndef middle(a, b):\n    print({what})\n"
WRONG = "def middle(a, b):\n    print('a is', a)\n    return a\n"
RAISED = "def middle(a, b):\n    print('here', b)\n    raise ValueError('no')\n"


def only(ended):
    (result,) = (json.loads(line) for line in ended.lines)
    return result


def test_an_answer_that_is_printed_and_not_returned(judge, submit):
    name = submit(PRINTED.format(what="a"))
    result = only(judge("run", "middle", name, "--json"))
    found = result["counterexample"]
    assert result["failure"]["printed"] == str(result["failure"]["input"]["a"])
    assert found["printed"] == str(found["input"]["a"])
    assert found["message"] == f"it printed {found['printed']} and returned nothing: return it"
    replayed = only(judge("replay", found["replay"], name, "--json"))["failure"]
    assert (replayed["printed"], replayed["message"]) == (found["printed"], found["message"])
    lines = [line.split(None, 1) for line in judge("replay", found["replay"], name).lines]
    assert ["printed", found["printed"]] in lines
    assert ["why", found["message"]] in lines


@pytest.mark.parametrize(("source", "first"), [(WRONG, "a is "), (RAISED, "here ")])
def test_what_is_printed_beside_an_answer_or_before_an_exception(source, first, judge, submit):
    result = only(judge("run", "middle", submit(source), "--json"))
    for part in (result["failure"], result["counterexample"]):
        assert part["printed"].startswith(first)
        assert "printed" not in part["message"]
    assert only(judge("run", "middle", "mine.py", "--json", "--no-shrink"))["failure"]["printed"]
    shown = [line.split(None, 1) for line in judge("run", "middle", "mine.py").lines]
    assert ["printed", result["counterexample"]["printed"]] in shown


def test_nothing_is_said_of_a_function_that_prints_nothing_or_only_at_import(judge, submit):
    result = only(judge("run", "middle", submit("print('x')\ndef middle(a, b):\n    return a\n"), "--json"))
    assert "printed" not in result["failure"]
    assert "printed" not in result["counterexample"]


def test_no_terminal_obeys_it_and_a_flood_is_cut(judge, submit):
    what = r"'\x1b[2J\x1b]0;title\x07\u202e' + 300 * 'x', *range(50), sep='\n'"
    ended = judge("run", "middle", submit(PRINTED.format(what=what)), "--all")
    assert not {"\x1b", "\x07", "\u202e"} & set(ended.out)
    assert r"\x1b[2J\x1b]0;title\x07\u202e" in ended.out
    assert any(line.split() == ["…"] for line in ended.lines)
    result = only(judge("run", "middle", "mine.py", "--json"))
    assert len(result["failure"]["printed"].splitlines()) == LINES + 1


@pytest.mark.parametrize("what", ["chr(0xDC80)", "'[0,1],'", "'\\x00'"])
def test_what_is_printed_is_no_answer_and_breaks_nothing(what, judge, submit):
    source = f"def middle(a, b):\n    print({what})\n    return (a + b) / 2\n"
    result = only(judge("run", "middle", submit(source), "--json"))
    assert result["verdict"] == "AC"


def test_a_child_that_lies_about_where_its_printing_begins_only_hides_it(judge, submit):
    source = "import os\nprint('x' * 9)\nos.lseek(1, 0, 0)\ndef middle(a, b):\n    print('y')\n"
    result = only(judge("run", "middle", submit(source), "--json"))
    assert result["verdict"] == "WA"
    assert result["failure"]["got"] == "None"


def test_lines_are_short_and_few():
    assert text_of(b"") == text_of(b" \n\n") == ""
    assert text_of(b"1\n2\n") == "1\n2"
    assert len(text_of(b"x" * 4000)) == LENGTH + 1
    assert text_of("\udc80\n".encode(errors="surrogatepass")).isprintable()
    assert message_of("why", "None", "1\n2") == "it printed 2 lines and returned nothing: return it"
    assert message_of("why", "3", "1\n2") == message_of("why", "None", "") == "why"

"""`judge help`: the manual's topics, its pages on a terminal and in a pipe, and what is found in them."""

from __future__ import annotations

import re

import pytest
from test_run_screen import on_a_terminal

from judge.cli.table import COMMANDS
from judge.manual import page, pages, search, topics


def test_the_topics_are_listed_each_with_its_title(judge):
    shown = judge("help").out
    for each in pages():
        assert re.search(rf"^  {each.name} +{re.escape(each.title)}$", shown, re.MULTILINE)


@pytest.mark.parametrize("name", topics())
def test_a_page_goes_into_a_pipe_as_it_is(name, judge):
    ended = judge("help", name)
    assert (ended.status, ended.out.rstrip()) == (0, page(name).text.rstrip())


def test_the_words_of_a_topic_may_stand_apart(judge):
    assert judge("help", "problem", "toml").out == judge("help", "problem-toml").out


@pytest.mark.parametrize("name", sorted({*COMMANDS} - {*topics()}))
def test_the_name_of_a_command_shows_its_help(name, judge):
    assert judge("help", name).out == judge(name, "--help").out


def test_a_page_that_is_longer_than_the_terminal_goes_through_the_pager(tmp_path):
    seen, pager = tmp_path / "seen", tmp_path / "pager"
    pager.write_text(f"#!/bin/sh\ncat > {seen}\n")
    pager.chmod(0o755)
    _, shown = on_a_terminal("help", "problem-toml", PAGER=str(pager))
    paged = seen.read_text(encoding="utf-8")
    assert "Sets and skills" in paged
    assert "## " not in paged  # it is rendered
    assert "Sets and skills" not in shown


def test_a_short_page_is_shown_at_once():
    assert "The report loads and runs nothing" in on_a_terminal("help", "privacy", PAGER="false")[1]


def test_words_are_found_wherever_they_stand_headings_first(judge):
    ended = judge("help", "--search", "Exit", "status")
    assert ended.status == 0
    assert ended.lines[0].startswith("scripts: Exit status")
    assert next(hit.heading for hit in search(["fresh", "cases"])) == "Fresh cases"


def test_words_that_are_nowhere_say_so(judge):
    ended = judge("help", "--search", "zeppelin")
    assert (ended.status, ended.out) == (1, "The manual does not have 'zeppelin'.\n")


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["help", "tiem"], "the manual has no topic 'tiem'; did you mean 'time'?"),
        (["help", "qqq"], "the manual has no topic 'qqq'; judge help lists the topics"),
        (["help", "--search"], "nothing to search for; write judge help --search WORD"),
    ],
)
def test_what_is_not_there_is_one_line(words, said, judge):
    ended = judge(*words)
    assert ended.status == 2
    assert said in ended.err
    assert ended.err.count("\n") == 1


def test_no_heading_within_a_block_is_a_section():
    assert "my-kata" not in "".join(each.heading for each in page("problem-toml").sections)
    for each in pages():
        headings = [section.heading for section in each.sections]
        assert len(headings) == len(set(headings)), each.name

"""`judge help`: the manual, on a terminal as it is on the web."""

from __future__ import annotations

import click

from judge.cli.options import json_option, write_json
from judge.cli.table import COMMANDS
from judge.errors import ExitCode, UsageError, nearest
from judge.manual import Page, page, pages, search, topics
from judge.report.manual import found_lines, show_page, topic_lines
from judge.report.screen import out

_FORM = 1


@click.command("help")
@click.argument("words", metavar="[TOPIC]", nargs=-1)
@click.option("-s", "--search", "sought", is_flag=True, help="Find the sections that have all these words.")
@json_option
def command(words: tuple[str, ...], sought: bool, as_json: bool) -> ExitCode:
    """Read the manual, or search it.

    Without words, it lists the pages. A page that is longer than the terminal is shown by your pager
    ($PAGER); into a pipe it goes as Markdown. The name of a command shows that command's --help.

    \b
    Examples: judge help time
              judge help --search exit status
    """
    if sought:
        return _search(words, as_json=as_json)
    if not words:
        _list(as_json=as_json)
        return ExitCode.ACCEPTED
    name = "-".join(words).lower()
    try:
        _read(page(name), as_json=as_json)
    except KeyError:
        if name not in COMMANDS or as_json:
            raise _unknown(name) from None
        _usage_of(name)
    return ExitCode.ACCEPTED


def _unknown(name: str) -> UsageError:
    meant = nearest(name, [*topics(), *COMMANDS])
    remedy = (
        f"did you mean '{meant}'?"
        if meant
        else "judge help lists the topics, judge help --search finds words"
    )
    return UsageError(f"the manual has no topic '{name}'", remedy=remedy)


def _list(*, as_json: bool) -> None:
    if as_json:
        for each in pages():
            _read(each, as_json=True)
        return
    screen = out()
    screen.show(topic_lines(pages(), screen.width))


def _read(topic: Page, *, as_json: bool) -> None:
    if as_json:
        write_json({"schema": _FORM, "topic": topic.name, "title": topic.title, "text": topic.text})
        return
    show_page(topic.text, out())


def _search(words: tuple[str, ...], *, as_json: bool) -> ExitCode:
    """Show where all the words are; 1 where nowhere, as `grep` has it."""
    if not words:
        raise UsageError("nothing to search for", remedy="write judge help --search WORD")
    hits = list(search(words))
    if as_json:
        for hit in hits:
            write_json({"schema": _FORM, "topic": hit.page, "section": hit.heading, "line": hit.line})
    else:
        screen = out()
        screen.show(found_lines(hits, " ".join(words), screen.width))
    return ExitCode.ACCEPTED if hits else ExitCode.NOT_ACCEPTED


def _usage_of(name: str) -> None:
    from judge.cli.app import app  # which imports this module only when it is asked for

    command = app.get_command(None, name)
    assert command is not None
    with click.Context(command, info_name=f"judge {name}", **app.context_settings) as context:
        click.echo(command.get_help(context))

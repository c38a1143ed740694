"""`judge help`: the manual, and the schemas of the JSON."""

from __future__ import annotations

import json
from contextlib import suppress
from typing import Any, cast

import click
from msgspec import Struct
from msgspec.structs import fields

from judge import manual
from judge.cli.options import Common, Option, command, opt
from judge.cli.table import COMMANDS
from judge.errors import UsageError, nearest
from judge.manual import Page, SearchHit
from judge.report.published_look import Document, Mentions, Topics
from judge.schema import files, schema_of, schema_of_file

_OPTIONS = "options"  # the page that is made of Common


class HelpAsk(Struct, frozen=True):
    """What to read, besides the manual."""

    schema: str | None = opt("--schema COMMAND", "The JSON Schema of what it writes with --json.")


@command("help", Page, SearchHit, ask=HelpAsk)
@click.argument("words", metavar="[TOPIC|WORDS]...", nargs=-1)
@click.pass_context
def read(context: click.Context, words: tuple[str, ...], ask: HelpAsk, common: Common) -> Struct:
    """Read the manual, or search it.

    Without words you see its topics. Words that name no topic and no command are searched for. A page that is
    longer than the terminal is shown by your pager ($PAGER); into a pipe it goes as Markdown.

    Exit status: 0, 1 no page has the words, 2 usage.
    """
    app: Any = context.find_root().command
    if ask.schema is not None:
        return _schema(app, ask.schema)
    if not words:
        return Topics([*manual.pages(), _options_page()])
    name = "-".join(words).lower()
    with suppress(KeyError):
        return _shown(manual.page(name))
    if name in COMMANDS and not common.json:
        made = app.get_command(None, name)
        with click.Context(made, info_name=f"judge {name}", **app.context_settings) as shown:
            return Document(made.get_help(shown), ())
    if name == _OPTIONS:
        return _shown(_options_page())
    near = nearest(name, [*manual.topics(), *COMMANDS]) or ""
    return Mentions(" ".join(words), manual.search(words), near)


def _shown(page: Page) -> Document:
    return Document(page.text, (page,), paged=True)


def _schema(app: Any, name: str) -> Document:
    """The schema of a command's JSON, or of a file that a setter writes. Raises UsageError."""
    if name in files():
        schema = schema_of_file(name)
    elif name in COMMANDS:
        schema = schema_of(app.get_command(None, name))
    else:
        near = nearest(name, [*COMMANDS, *files()])
        remedy = f"did you mean {near}?" if near else f"name a command, or {' or '.join(files())}"
        raise UsageError(f"There is no schema of {name!r}", remedy=remedy)
    return Document("", (schema,), plain=json.dumps(schema, indent=2) + "\n")


def _options_page() -> Page:
    """The page of the options of every command."""
    title, rows = "Options of every command", list[str]()
    for field in fields(Common):
        option = cast("Option", field.default_factory)
        shown = " ".join(filter(None, (*option.names, option.settings.get("metavar"))))
        rows.append(f"- `{shown}`: {option.settings['help']}")
    text = "\n".join((f"# {title}", "", *rows, "- `--debug`: Show the traceback of a fault.", ""))
    return Page(topic=_OPTIONS, title=title, text=text)

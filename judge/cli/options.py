"""How a command is written: its options are the fields of frozen structs, and it returns what it has to say.

class ListAsk(Struct, frozen=True):
    todo: bool = opt("--todo", "Only what you have not solved yet.")
    level: str | None = opt("--level", "Only this level.", choices=LEVELS)

@command("list", KataRow, ask=ListAsk)
@click.argument("name", metavar="[SET]", required=False)
def katas(name: str | None, ask: ListAsk, common: Common) -> Struct: ...

It returns a frozen Struct, or an iterator of them where the work is long; it never prints. A value may have
`exit_code`, `published` (what goes out as JSON instead of it: a tuple of structs, one a line), `plain` (text
for another program, which is written as it is), `line` (all that is shown, where that is one line) and
`paged` (whether the pager shows what is longer than the terminal).
"""

from __future__ import annotations

import functools
import re
import sys
from collections.abc import Callable, Generator, Iterable
from contextlib import suppress
from pathlib import Path
from typing import Any, get_args

import click
import msgspec
from msgspec import Struct, field
from msgspec.structs import fields

from judge.errors import ExitCode, UnknownKataError, UsageError

_DURATION = re.compile(r"([0-9]{1,9}(?:\.[0-9]{1,9})?)(ms|s|m|h)?", re.ASCII)
_SECONDS = {"ms": 0.001, "s": 1.0, "m": 60.0, "h": 3600.0}
_LONGEST = 1000 * 3600.0
_LEVELS = ("full", "strong", "limits")  # those of the sandbox, which is slow to import


class Option(Struct, frozen=True):
    """What click is told about an option: its names, and its settings."""

    names: list[str]
    settings: dict[str, Any]

    def __call__(self) -> Any:
        """The default."""
        return self.settings.get("default")


def opt(usage: str, about: str, *, choices: Iterable[str] = (), default: Any = None, **settings: Any) -> Any:
    """An option as its help shows it, such as `-j --jobs N`; further settings are those of click.option.

    Without a word for its value, and without choices, it is a flag. With () as default it may be repeated.
    """
    *names, last = usage.split()
    if last[0] == "-":
        names.append(last)
    else:
        settings["metavar"] = last
    if choices:
        settings = {"type": click.Choice([*choices]), "metavar": "|".join(choices), **settings}
    if "metavar" not in settings:
        settings["is_flag"], default = True, False
    if "required" not in settings:
        settings |= {"default": default, "multiple": default == ()}
    return field(default_factory=Option(names, {"help": about, **settings}))


def _options(struct: type[Struct]) -> Iterable[click.Option]:
    """click's options for the fields of a struct."""
    for each in fields(struct):
        option: Any = each.default_factory
        kind, *_ = get_args(each.type) or [each.type]  # of `kind | None` and `tuple[kind, ...]` too
        settings = {"type": click.Path(path_type=Path) if kind is Path else kind, **option.settings}
        yield click.Option([*option.names, each.name], **settings)


class Common(Struct, frozen=True):
    """The options of every command; its help leaves them out, since the page options.md has them."""

    json: bool = opt("--json", "", hidden=True)
    problems: tuple[Path, ...] = opt("--problems DIR", "", default=(), hidden=True)
    db: Path | None = opt("--db FILE", "", hidden=True)
    isolation: str | None = opt("--isolation", "", choices=_LEVELS, hidden=True)


def command(
    name: str, *writes: Any, ask: type[Struct] | None = None, numbers: bool = False
) -> Callable[[Callable[..., Struct | Iterable[Struct]]], click.Command]:
    """A command of the table, its value written by `emit`; a line of its JSON is one of `writes`.

    Its function gets the options of `ask` as that argument, and those of every command as `common`. With
    `numbers` an argument may be a number below 0, which is no option then.
    """
    groups: dict[str, type[Struct]] = {**({"ask": ask} if ask else {}), "common": Common}

    def decorate(function: Callable[..., Struct | Iterable[Struct]]) -> click.Command:
        @functools.wraps(function)
        def ended(**given: Any) -> int:
            for into, struct in groups.items():
                given[into] = struct(**{each.name: given.pop(each.name) for each in fields(struct)})
            common: Common = given["common"]
            try:
                return emit(function(**given), common)
            except UnknownKataError as fault:
                from judge.cli.resolve import say_where  # only for the one who is told

                say_where(fault, common.db)
                raise

        made = click.command(name, context_settings={"ignore_unknown_options": numbers})(ended)
        for struct in groups.values():
            made.params += _options(struct)
        made.writes = writes  # type: ignore[attr-defined]  # for judge help --schema
        return made

    return decorate


def emit(found: Struct | Iterable[Struct], common: Common) -> ExitCode:
    """Write each value as soon as it is there; the greatest `exit_code` of them all.

    Ctrl-C between two values goes to who makes them, who may have something to say before it ends.
    """
    values = iter((found,) if isinstance(found, Struct) else found)
    worst = ExitCode.ACCEPTED
    try:
        for value in values:
            worst = max(worst, _written(value, common))
    except KeyboardInterrupt as pressed:
        if isinstance(values, Generator):
            with suppress(StopIteration):
                _written(values.throw(pressed), common)
        raise
    return worst


def _written(value: Struct, common: Common) -> ExitCode:
    """Write the value; its exit code."""
    if common.json:
        for each in getattr(value, "published", (value,)):
            sys.stdout.write(_json(each) + "\n")
        sys.stdout.flush()
    elif plain := getattr(value, "plain", ""):
        sys.stdout.write(plain)
        sys.stdout.flush()
    else:
        from judge.report.screen import out, show  # --json does without the screen

        screen = out()
        line = "" if screen.colour or screen.width else getattr(value, "line", "")
        if line and line.isprintable():
            screen.write(f"{line}\n")
        else:
            from judge.report.views import view

            show(view(value, screen), screen, paged=getattr(value, "paged", False))
    return getattr(value, "exit_code", ExitCode.ACCEPTED)


def _json(value: Struct) -> str:
    """The value on one line; paths, types and exact numbers are text."""
    with suppress(UnicodeEncodeError):  # half of a surrogate pair in a name, or a stream of few letters
        text = msgspec.json.encode(value, enc_hook=str).decode()
        text.encode(getattr(sys.stdout, "encoding", None) or "utf-8")
        if text.isprintable():
            return text
    import json

    return json.dumps(msgspec.to_builtins(value, enc_hook=str))


def exclusive(ask: Struct, one: str, *others: str) -> None:
    """Refuse an option beside any of the others, each named by its field of `ask`. Raises UsageError."""
    options: dict[str, Any] = {each.name: each.default_factory for each in fields(ask)}
    given = {name: option.names[0] for name, option in options.items() if getattr(ask, name) != option()}
    for other in others:
        if one in given and other in given:
            said = f"{given[one]} and {given[other]} contradict each other"
            raise UsageError(said, remedy="leave one out")


def seconds_of(text: str) -> float:
    """The seconds that 30, 30s, 2m or 1h stand for, above 0: a type of an option. Raises UsageError."""
    found = _DURATION.fullmatch(text)
    seconds = float(found[1]) * _SECONDS[found[2] or "s"] if found else 0
    if not 0 < seconds <= _LONGEST:
        raise UsageError(f"{text!r} is not a time", remedy="write 30, 30s, 2m or 1h")
    return seconds

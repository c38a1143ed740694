"""Options as the fields of structs: a group of options is a frozen Struct, a field of it is an option.

class ListAsk(Struct, frozen=True):
    todo: bool = opt("--todo", "Only what you have not solved yet.")
    level: str | None = opt("--level", "Only this level.", choices=LEVELS)

@command("list", KataRow, ask=ListAsk)
@click.argument("name", metavar="[SET]", required=False)
def katas(name: str | None, ask: ListAsk, common: Common) -> Struct: ...
"""

from __future__ import annotations

import functools
import re
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any, get_args

import click
from msgspec import Struct, field
from msgspec.structs import fields

from judge.cli.emit import emit
from judge.errors import UnknownKataError, UsageError

_DURATION = re.compile(r"([0-9]{1,9}(?:\.[0-9]{1,9})?)(ms|s|m|h)?", re.ASCII)
_SECONDS = {"ms": 0.001, "s": 1.0, "m": 60.0, "h": 3600.0}
_LONGEST = 1000 * 3600.0


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
    """The options of every command; its help leaves them out, since `judge help options` has them."""

    json: bool = opt("--json", "Write JSON, one object on each line, and nothing else.", hidden=True)
    problems: tuple[Path, ...] = opt(
        "--problems DIR", "Look for katas in this folder first.", default=(), hidden=True
    )
    db: Path | None = opt("--db FILE", "The file of your runs, instead of $JUDGE_DB.", hidden=True)
    isolation: str | None = opt(
        "--isolation",
        "Demand this level; the best there is without it. See judge doctor.",
        choices=("full", "strong", "limits"),  # LEVELS of the sandbox, which is slow to import
        hidden=True,
    )


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


def seconds_of(text: str, option: str) -> float:
    """The seconds that 30, 30s, 2m or 1h stand for, above 0. Raises UsageError for what is no duration."""
    found = _DURATION.fullmatch(text)
    seconds = float(found[1]) * _SECONDS[found[2] or "s"] if found else 0
    if not 0 < seconds <= _LONGEST:
        why = "no duration" if found is None else "too long" if seconds else "no time at all"
        raise UsageError(f"{text!r} is {why}", where=option, remedy="write 30, 30s, 2m or 1h")
    return seconds

"""Options as the fields of structs: a group of options is a frozen Struct, a field of it is an option.

class ListAsk(Struct, frozen=True):
    todo: Annotated[bool, opt("--todo", help="Only what you have not solved yet.")] = False

@command("list", writes=KataRow)
@click.argument("name", metavar="[SET]", required=False)
@takes(ListAsk, "ask")
def katas(name: str | None, ask: ListAsk, common: Common) -> Struct: ...
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable
from pathlib import Path
from types import UnionType
from typing import Annotated, Any, NamedTuple, TypeVar, get_args, get_origin

import click
from msgspec import NODEFAULT, Struct
from msgspec.structs import fields

from judge.cli.emit import emit
from judge.sandbox.boundary import LEVELS as ISOLATION

F = TypeVar("F", bound=Callable[..., Any])


class Option(NamedTuple):
    """What click is told about an option: its names, and its settings."""

    names: tuple[str, ...]
    settings: dict[str, Any]


def opt(*names: str, **settings: Any) -> Option:
    """An option of these names; `help`, `type`, `metavar`, `hidden` are those of click.option.

    The field's own type and default say the rest: a bool is a flag, a tuple may be given again,
    what has no default is required.
    """
    return Option(names, settings)


def takes(struct: type[Struct], into: str) -> Callable[[F], F]:
    """Give a command the options of `struct`; its function gets them as one argument `into`."""

    def decorate(function: F) -> F:
        @functools.wraps(function)
        def gathered(**given: Any) -> Any:
            own = {field.name: given.pop(field.name) for field in fields(struct)}
            return function(**given, **{into: struct(**own)})

        for field in reversed(fields(struct)):
            gathered = _option(field.name, field.type, field.default)(gathered)
        return gathered  # type: ignore[return-value]

    return decorate


def _option(field: str, type_: Any, default: Any) -> Callable[[F], F]:
    """click's option for a field of the type Annotated[type, opt(...)]."""
    plain, option = get_args(type_)
    settings = dict(option.settings)
    if plain is bool:
        settings["is_flag"] = True
    elif get_origin(plain) is tuple:
        plain, settings["multiple"] = get_args(plain)[0], True
    if isinstance(plain, UnionType):
        plain = get_args(plain)[0]
    if default is NODEFAULT:
        settings["required"] = True
    else:
        settings["default"] = default
    if plain is not bool:
        settings.setdefault("type", click.Path(path_type=Path) if plain is Path else plain)
    return click.option(*option.names, field, **settings)


class Common(Struct, frozen=True):
    """The options of every command; its help leaves them out, since `judge help options` has them."""

    json: Annotated[
        bool, opt("--json", help="Write JSON, one object a line, and nothing else.", hidden=True)
    ] = False
    problems: Annotated[
        tuple[Path, ...],
        opt("--problems", metavar="DIR", help="Look for katas in this folder first.", hidden=True),
    ] = ()
    db: Annotated[
        Path | None,
        opt("--db", metavar="FILE", help="The file of your runs, instead of $JUDGE_DB.", hidden=True),
    ] = None
    isolation: Annotated[
        str | None,
        opt(
            "--isolation",
            metavar="LEVEL",
            type=click.Choice(ISOLATION),
            help="Demand full, strong or limits; the best there is without it. See judge doctor.",
            hidden=True,
        ),
    ] = None


def command(
    name: str, *writes: Any, numbers: bool = False
) -> Callable[[Callable[..., Struct | Iterable[Struct]]], click.Command]:
    """A command of the table, its value written by `emit`; a line of its JSON is one of `writes`.

    With `numbers` an argument may be a number below 0, which is no option then.
    """

    def decorate(function: Callable[..., Struct | Iterable[Struct]]) -> click.Command:
        @functools.wraps(function)
        def ended(common: Common, **given: Any) -> int:
            return emit(function(common=common, **given), common)

        made = click.command(name, context_settings={"ignore_unknown_options": numbers})(
            takes(Common, "common")(ended)
        )
        made.writes = writes  # type: ignore[attr-defined]  # for judge help --schema
        return made

    return decorate

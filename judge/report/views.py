"""What a command says: the base of its values, and how the view of a value is found.

The view of a class `KataShown` of `published_look.py` is the function `kata_shown` of `look.py`, which is
imported only then. It takes the value and the screen and returns what rich can draw; it writes nothing.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from importlib import import_module
from typing import TYPE_CHECKING, Any, TypeVar

from msgspec import Struct

if TYPE_CHECKING:
    from rich.console import RenderableType

    from judge.report.screen import Screen

S = TypeVar("S", bound=Struct)
_NONE = object()


class Published(Struct, frozen=True, kw_only=True):
    """One line of a command's JSON; `schema` rises where a key changes its meaning or goes."""

    schema: int = 1


def copied(kind: type[S], of: object, **more: Any) -> S:
    """A value of that kind with the fields that `of` has too; `more` has the others."""
    found = {name: getattr(of, name, _NONE) for name in kind.__struct_fields__ if name not in more}
    return kind(**{name: value for name, value in found.items() if value is not _NONE}, **more)


def in_words(kind: type[S], of: object) -> S:
    """A value of that kind, whose fields are texts, with what `of` has by their names."""
    return kind(*(str(getattr(of, name)) for name in kind.__struct_fields__))


def view_of(kind: type) -> Callable[[Any, Screen], RenderableType]:
    """What draws the values of a class. Raises AttributeError for one that has no view."""
    module = import_module(kind.__module__.replace("published_", ""))
    name = re.sub("(?<=[a-z])(?=[A-Z])", "_", kind.__name__).lower()
    found: Callable[[Any, Screen], RenderableType] = getattr(module, name)
    return found


def view(value: object, screen: Screen) -> RenderableType:
    """What the screen shows of `value`."""
    return view_of(type(value))(value, screen)

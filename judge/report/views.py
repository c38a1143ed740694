"""How the view of what a command says is found, and how its values are made of others.

The view of a class `KataShown` of `published_look.py` is the function `kata_shown` of `look.py`, which is
imported only then, that of one of `practice/review.py` in `progress.py`; of a class of another room it is
in `setter.py`. It takes the value and the screen and
returns what rich can draw; it writes nothing.
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


def copied(kind: type[S], *of: object, **more: Any) -> S:
    """A value of that kind with the fields that one of these values has too; `more` has the others."""
    names = [name for name in kind.__struct_fields__ if name not in more]
    return kind(**{name: getattr(each, name) for each in of for name in names if hasattr(each, name)}, **more)


def view_of(kind: type) -> Callable[[Any, Screen], RenderableType]:
    """What draws the values of a class. Raises AttributeError for one that has no view."""
    home = kind.__module__.replace("published_", "").replace("practice.review", "report.progress")
    module = import_module(home if home.startswith("judge.report.") else "judge.report.setter")
    name = re.sub("(?<=[a-z])(?=[A-Z])", "_", kind.__name__).lower()
    found: Callable[[Any, Screen], RenderableType] = getattr(module, name)
    return found


def view(value: object, screen: Screen) -> RenderableType:
    """What the screen shows of `value`."""
    return view_of(type(value))(value, screen)

"""What a command says, as a line of its JSON: the base of such values, in whichever room they are made."""

from __future__ import annotations

from msgspec import Struct


class Published(Struct, frozen=True, kw_only=True):
    """One line of a command's JSON; `schema` rises where a key changes its meaning or goes."""

    schema: int = 1

"""What a problem, a test group or a set may be called."""

from __future__ import annotations

import re

_NAME = re.compile(r"[a-z][a-z0-9]*(-[a-z0-9]+)*")


def is_name(text: str) -> bool:
    """Whether it is made of small letters, digits and single hyphens."""
    return _NAME.fullmatch(text) is not None

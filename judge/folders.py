"""The person's own folders: for the cache, which $JUDGE_CACHE may name, and for data.

On Linux they follow two variables, which are read here: importing platformdirs, which knows every system,
takes longer than many a judging. Whatever is not as usual is asked of it.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path

CACHE_VARIABLE = "JUDGE_CACHE"
_NAME = "circle-line-judge"


def cache_folder() -> Path:
    """Where the judge keeps what it can make again: $JUDGE_CACHE, or its folder among the person's caches.

    Raises RuntimeError where there is no home folder.
    """
    own = os.environ.get(CACHE_VARIABLE)
    if own:
        return Path(own)
    return _usual("XDG_CACHE_HOME", ".cache") or _asked("user_cache_path")


def user_data() -> Path:
    """The judge's folder among the person's data. Raises RuntimeError where there is no home folder."""
    return _usual("XDG_DATA_HOME", ".local/share") or _asked("user_data_path")


def _usual(variable: str, below_home: str) -> Path | None:
    """The folder by the XDG Base Directory Specification; None off Linux, on Android, without a home."""
    if sys.platform != "linux" or "ANDROID_ROOT" in os.environ:
        return None
    base, home = os.environ.get(variable, ""), os.environ.get("HOME", "")
    if base.startswith("/"):
        return Path(base, _NAME)
    return Path(home, below_home, _NAME) if home.startswith("/") else None


def _asked(function: str) -> Path:
    import platformdirs  # seldom

    path: Path = getattr(platformdirs, function)(_NAME, appauthor=False)
    return path

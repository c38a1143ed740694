"""The history's SQLite file: where it is, and what kind of file it is (`judge.database` opens it).

<data folder>/history.sqlite3       the runs; the folder is the user's own, the file may be $JUDGE_DB
"""

from __future__ import annotations

import os
from pathlib import Path

from judge.database import Kind
from judge.errors import HistoryError
from judge.folders import user_data
from judge.kata.migrations import APPLICATION, MIGRATIONS

VARIABLE = "JUDGE_DB"
HISTORY = Kind(
    "history",
    APPLICATION,
    MIGRATIONS,
    f"name another file with --db or ${VARIABLE}",
    HistoryError,
    damaged="move it away, or keep what can be read of it with 'judge history --repair'",
)


def history_path() -> Path:
    """Where the history is: $JUDGE_DB, or a file in the user's own data folder. Raises HistoryError."""
    own = os.environ.get(VARIABLE)
    if own:
        return Path(own)
    try:
        return user_data() / "history.sqlite3"
    except RuntimeError:
        remedy = f"set ${VARIABLE} to a file"
        raise HistoryError("there is no home folder for the history", remedy=remedy) from None

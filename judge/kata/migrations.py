"""The history's tables, as numbered steps: a file at version n has had the first n of them.

The version is the file's `user_version`. A step is never changed once it was released: a file that had it
would not get the change. Times are microseconds since 1970 (UTC); names of files are bytes, as the system has
them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sqlite3 import Connection

APPLICATION = 0x4A554447  # "JUDG": tells this file from any other program's database

_RUNS = (
    """CREATE TABLE sources (
        hash TEXT PRIMARY KEY,              -- sha256 of the source, in hex
        body BLOB NOT NULL                  -- the source, compressed by zlib
    ) WITHOUT ROWID""",
    """CREATE TABLE runs (
        id INTEGER PRIMARY KEY AUTOINCREMENT,
        time INTEGER NOT NULL,
        problem TEXT NOT NULL,
        submission BLOB NOT NULL,           -- the file as the person named it
        path BLOB NOT NULL,                 -- the same, absolute; empty where it was no ordinary file
        verdict TEXT NOT NULL,
        score INTEGER NOT NULL,
        mode TEXT NOT NULL,
        mistake TEXT,
        ratio REAL,
        passed TEXT NOT NULL,               -- the test groups accepted, by name, a space between them
        failed TEXT NOT NULL,               -- the other groups that were run
        source TEXT NOT NULL REFERENCES sources,
        result BLOB NOT NULL                -- what `judge run --json` wrote, compressed by zlib
    )""",
    "CREATE INDEX runs_of_a_problem ON runs (problem, id)",
)
_PRACTICE = (
    """CREATE TABLE current (
        id INTEGER PRIMARY KEY CHECK (id = 1),
        problem TEXT NOT NULL,
        path BLOB NOT NULL
    )""",
    """CREATE TABLE help (
        id INTEGER PRIMARY KEY AUTOINCREMENT,
        time INTEGER NOT NULL,
        problem TEXT NOT NULL,
        hints INTEGER NOT NULL              -- how many hints had been seen; 0 where it was given up
    )""",
    "CREATE INDEX help_with_a_problem ON help (problem, id)",
)
_FOLDER_IN_HAND = (
    "ALTER TABLE current ADD COLUMN problems BLOB NOT NULL DEFAULT x''",  # the folder its problem lies in
)
MIGRATIONS: tuple[tuple[str, ...], ...] = (_RUNS, _PRACTICE, _FOLDER_IN_HAND)


def version_of(connection: Connection) -> int:
    """How many of the steps the file has had."""
    (version,) = connection.execute("PRAGMA user_version").fetchone()
    return int(version)


def migrate(connection: Connection) -> None:
    """Take the steps that the file has not had: all of them or none. Safe where two do it at once."""
    if version_of(connection) >= len(MIGRATIONS):
        return
    connection.execute("BEGIN IMMEDIATE")
    try:
        for step in MIGRATIONS[version_of(connection) :]:  # asked again: another process may have been first
            for statement in step:
                connection.execute(statement)
        connection.execute(f"PRAGMA application_id = {APPLICATION}")
        connection.execute(f"PRAGMA user_version = {len(MIGRATIONS)}")
        connection.execute("COMMIT")
    except BaseException:
        if connection.in_transaction:
            connection.execute("ROLLBACK")
        raise

"""The history's tables, as numbered steps: a file at version n has had the first n of them.

The version is the file's `user_version`. A step is never changed once it was released: a file that had it
would not get the change. Times are microseconds since 1970 (UTC); names of files are bytes, as the system has
them.
"""

from __future__ import annotations

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
_HACKS = (
    """CREATE TABLE hacks (
        id INTEGER PRIMARY KEY AUTOINCREMENT,
        time INTEGER NOT NULL,
        problem TEXT NOT NULL,
        mistake TEXT NOT NULL,              -- the wrong program that was to be broken
        line TEXT NOT NULL,                 -- the case, as a program reads it
        outcome TEXT NOT NULL               -- won, lost or given-up: then it is the case that was shown
    )""",
    "CREATE INDEX hacks_of_a_problem ON hacks (problem, id)",
)
_QUIZ = (
    """CREATE TABLE answers (
        id INTEGER PRIMARY KEY AUTOINCREMENT,
        time INTEGER NOT NULL,
        card TEXT NOT NULL,                 -- its deck and its id: junior/three-counts
        form TEXT NOT NULL,
        rating INTEGER NOT NULL,            -- 1 again, 2 hard, 3 good, 4 easy
        judged INTEGER NOT NULL,            -- 1 where the judge decided that, 0 where the person did
        given TEXT NOT NULL
    )""",
)
MIGRATIONS: tuple[tuple[str, ...], ...] = (_RUNS, _PRACTICE, _FOLDER_IN_HAND, _HACKS, _QUIZ)

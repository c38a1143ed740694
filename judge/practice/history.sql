-- The steps by which the tables of a history came to be: a file at version n has had the first n. A step is
-- never changed: a file that had it would not get the change. Times are microseconds since 1970 (UTC), names of
-- files bytes as the system has them, groups names with a space between them; sources (by their sha256) and
-- results are compressed by zlib.

-- step
CREATE TABLE sources (hash TEXT PRIMARY KEY, body BLOB NOT NULL) WITHOUT ROWID;
CREATE TABLE runs (id INTEGER PRIMARY KEY AUTOINCREMENT, time INTEGER NOT NULL, problem TEXT NOT NULL,
    submission BLOB NOT NULL, path BLOB NOT NULL, verdict TEXT NOT NULL, score INTEGER NOT NULL, mode TEXT NOT
    NULL, mistake TEXT, ratio REAL, passed TEXT NOT NULL, failed TEXT NOT NULL, source TEXT NOT NULL
    REFERENCES sources, result BLOB NOT NULL);
CREATE INDEX runs_of_a_problem ON runs (problem, id);

-- step
CREATE TABLE current (id INTEGER PRIMARY KEY, problem TEXT NOT NULL, path BLOB NOT NULL);
CREATE TABLE help (id INTEGER PRIMARY KEY AUTOINCREMENT, time INTEGER NOT NULL, problem TEXT NOT NULL,
    hints INTEGER NOT NULL);
CREATE INDEX help_with_a_problem ON help (problem, id);

-- step
ALTER TABLE current ADD COLUMN problems BLOB NOT NULL DEFAULT x'';

-- step
CREATE TABLE hacks (id INTEGER PRIMARY KEY AUTOINCREMENT, time INTEGER NOT NULL, problem TEXT NOT NULL,
    mistake TEXT NOT NULL, line TEXT NOT NULL, outcome TEXT NOT NULL);
CREATE INDEX hacks_of_a_problem ON hacks (problem, id);

-- step
CREATE TABLE answers (id INTEGER PRIMARY KEY AUTOINCREMENT, time INTEGER NOT NULL, card TEXT NOT NULL,
    form TEXT NOT NULL, rating INTEGER NOT NULL, judged INTEGER NOT NULL, given TEXT NOT NULL);

-- step
CREATE TABLE started (id INTEGER PRIMARY KEY AUTOINCREMENT, time INTEGER NOT NULL, problem TEXT NOT NULL,
    path BLOB NOT NULL, problems BLOB NOT NULL);
INSERT INTO started (time, problem, path, problems) SELECT 0, problem, path, problems FROM current;
DROP TABLE current;

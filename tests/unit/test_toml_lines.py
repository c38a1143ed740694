"""Where a key of a TOML text stands."""

from __future__ import annotations

import pytest

from judge.problem.lines import key_lines, line_of

TEXT = '''title = "a"
summary = """
entry = "not a key"
[[groups]]
"""
[limits]  # of a group
cpu_seconds = 1

[[groups]]
name = "first"

  [groups.tolerance]
  ulps = 4

[[groups]]
"name" = "second"
parameters = { size = 3 }
tolerance.relative = 1
'''


@pytest.mark.parametrize(
    ("path", "line"),
    [
        ((), 1),
        (("title",), 1),
        (("summary",), 2),
        (("entry",), 1),  # only text inside a string: the file itself
        (("limits",), 6),
        (("limits", "cpu_seconds"), 7),
        (("groups", 0), 9),
        (("groups", 0, "name"), 10),
        (("groups", 0, "tolerance", "ulps"), 13),
        (("groups", 1), 15),
        (("groups", 1, "name"), 16),
        (("groups", 1, "parameters", "size"), 17),  # inside an inline table: its key
        (("groups", 1, "tolerance", "relative"), 18),
        (("groups", 1, "seed"), 15),  # missing: its table
    ],
)
def test_line_of_a_path(path, line):
    assert line_of(path, key_lines(TEXT)) == line

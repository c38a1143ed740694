"""Cases as a pytest file of a person's own: each test asks the judge about one."""

from __future__ import annotations

import os
import re
from itertools import count
from pathlib import Path

from judge.diagnose.replay import encode
from judge.run.tried import Tried

MARK = b"# Written by `judge "  # how the file begins, those of earlier versions too
_IMPORT = "from judge.testing import check_case\n"
_HEAD = f"""# Written by `judge try --pytest`, which adds more cases at the end.
from pathlib import Path

{_IMPORT}"""


def with_case(content: str, path: Path, submission: Path, tried: Tried) -> str:
    """The text of the pytest file at `path`, with a test of the submission on this case at its end.

    `content` is the text that is there, or empty; a test that it has already is not added again.
    """
    replay = encode(tried.problem, tried.group, tried.case)
    place = os.path.relpath(submission.resolve(), path.resolve().parent)
    body = f"    check_case({replay!r}, Path(__file__).parent / {place!r})\n"
    if body in content:
        return content
    content = content if _IMPORT in content else content + _HEAD
    return content + f"\n\ndef {_free_name(place, replay, content)}():\n{body}"


def _free_name(place: str, replay: str, content: str) -> str:
    """A name that no other test of the file has: two files of the same name may get the same case."""
    problem, group, *_, check = replay.split(":")
    words = f"test_{Path(place).stem}_{problem}_{group}_{check}"
    # Not every letter of a file's name may stand in a function's: not "²", nor a half of a surrogate pair.
    name = "".join(letter if f"_{letter}".isidentifier() else "_" for letter in words)
    taken = set(re.findall(r"def (\w++)\(\)", content))
    names = (name if number == 1 else f"{name}_{number}" for number in count(1))
    return next(each for each in names if each not in taken)

"""The text of a problem's files, or a fault that says what is wrong with one."""

from __future__ import annotations

from pathlib import Path

from judge.errors import ProblemError
from judge.files import read_ordinary_text


def read_text(path: Path) -> str:
    """The text of one of a problem's files. Raises ProblemError."""
    where = f"{path.parent.name}/{path.name}"
    try:
        return read_ordinary_text(path)
    except FileNotFoundError:
        raise ProblemError("the file is missing", where=where, remedy=f"create {path}") from None
    except UnicodeDecodeError as error:
        what = f"byte {error.start} is not UTF-8"
        raise ProblemError(what, where=where, remedy="save the file as UTF-8") from None
    except OSError as error:
        what = f"cannot be read: {error.strerror}"
        raise ProblemError(what, where=where, remedy=f"make {path} a readable file") from None

"""Programs that are submitted inside of something else: a zip, a notebook, a name that an editor spoilt."""

from __future__ import annotations

import io
import json
import stat
import zipfile
from collections.abc import Iterator
from pathlib import PurePath

from judge.errors import JudgeError
from judge.languages import SUFFIX, is_program

_ZIP, _NOTEBOOK, _TEXT = ".zip", ".ipynb", ".txt"
_MOST, _LARGEST = 100, 2 << 20  # files, and bytes of all of them
_MAGIC = ("%", "!")  # lines of a notebook that are no Python


def is_packed(name: str) -> bool:
    """Whether a file of that name holds programs under other names."""
    path = PurePath(name)
    ends = path.suffix.lower()
    return ends in (_ZIP, _NOTEBOOK, SUFFIX) or (ends == _TEXT and is_program(path.stem))


def unpacked(name: str, content: bytes) -> Iterator[tuple[str, bytes]]:
    """The programs in it, each by its name. Raises JudgeError, which says why there is none."""
    path = PurePath(name)
    ends = path.suffix.lower()
    if ends == _ZIP:
        yield from _zipped(name, content)
    else:  # of a text the second ending stays
        whole = _cells(content) if ends == _NOTEBOOK else content
        yield str(path.with_suffix("" if ends == _TEXT else SUFFIX)), whole


def _zipped(name: str, content: bytes) -> Iterator[tuple[str, bytes]]:
    try:
        archive = zipfile.ZipFile(io.BytesIO(content))
        files = [each for each in archive.infolist() if not each.is_dir()]
        if len(files) > _MOST:
            raise JudgeError(f"{len(files)} files are more than {_MOST}")
        if (size := sum(each.file_size for each in files)) > _LARGEST:
            raise JudgeError(f"{size >> 20} MB is more than {_LARGEST >> 20} MB")
        programs = [each for each in files if is_program(each.filename) and not _is_link(each)]
        if not programs:
            raise JudgeError("no program is in this zip")
        for each in programs:
            with archive.open(each) as file:
                yield f"{name}/{each.filename}", file.read(_LARGEST)
    except (zipfile.BadZipFile, NotImplementedError, RuntimeError, EOFError, ValueError, OSError) as fault:
        raise JudgeError(f"this zip cannot be opened ({fault})") from fault


def _is_link(each: zipfile.ZipInfo) -> bool:
    return stat.S_ISLNK(each.external_attr >> 16)


def _cells(content: bytes) -> bytes:
    """The code cells of a notebook, one after the other."""
    try:
        cells = [each for each in json.loads(content)["cells"] if each["cell_type"] == "code"]
        texts = ["".join(each["source"]) for each in cells]
    except (ValueError, TypeError, KeyError, RecursionError) as fault:
        raise JudgeError("this notebook cannot be read") from fault
    rows = (row for text in texts for row in (*text.splitlines(), ""))
    return "\n".join(row for row in rows if not row.startswith(_MAGIC)).encode("utf-8", "backslashreplace")

"""Rows as CSV that spreadsheets open as it is meant, wherever they are opened.

Every field is quoted, so that it stays one where another sign parts them, as `;` does in half of Europe. A
cell that would be calculated, such as a student called `=1+1`, gets an apostrophe before it; so does what
would begin one where a spreadsheet takes no notice of the quotes.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterable

from judge.report.words import printable

_FORMULA = re.compile(r"""(^|[;,"'|\t])(\s*)(?=[=+\-@＝＋－＠])""")


def csv_text(rows: Iterable[Iterable[object]], end: str = "\r\n") -> str:
    """The rows, each with that end; what is no text is written as it is."""
    written = io.StringIO()
    writer = csv.writer(written, quoting=csv.QUOTE_ALL, lineterminator=end)
    writer.writerows([cell(each) if isinstance(each, str) else each for each in row] for row in rows)
    return written.getvalue()


def cell(text: str) -> str:
    """Text as a cell that no spreadsheet calculates; control characters are written out."""
    return _FORMULA.sub(r"\1\2'", printable(text))

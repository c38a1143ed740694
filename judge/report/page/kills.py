"""The kill matrix as a table: a row for each known-wrong program, a column for each group."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from pathlib import PurePath

from judge.report.page.parts import KillCell, KillLine, KillTable
from judge.report.values import percent
from judge.run.matrix import Kill, Matrix, Row

_SHADES = (Fraction(0), Fraction(1, 10), Fraction(1, 4), Fraction(1, 2), Fraction(3, 4))


def kill_table(matrix: Matrix, made: Counter[str]) -> KillTable | None:
    """The table; None where there are no known-wrong programs. `made` counts the runs of each mistake."""
    if not matrix.rows:
        return None
    return KillTable(matrix.groups, tuple(_line(matrix, row, made) for row in matrix.rows))


def _line(matrix: Matrix, row: Row, made: Counter[str]) -> KillLine:
    kills = {kill.group: kill for kill in row.kills}
    cells = tuple(_cell(group, kills.get(group), row) for group in matrix.groups)
    name = PurePath(row.file).stem
    return KillLine(name, made[row.mistake], cells)


def _cell(group: str, kill: Kill | None, row: Row) -> KillCell:
    share = kill.share if kill else Fraction(0)
    shade = sum(share > step for step in _SHADES)
    return KillCell(group, percent(share) if share or group in row.aimed else "", shade, group in row.aimed)

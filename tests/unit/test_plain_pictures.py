"""Tables and graphs, drawn as SVG and for a terminal."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree

import pytest

from judge.drawing import Role, graph, table
from judge.drawing.braille import LEAST_COLUMNS, to_braille
from judge.drawing.svg import panel_svg

WIDTHS = [LEAST_COLUMNS, 76]


def drawn(picture, columns):
    return ["".join(piece.text for piece in row) for row in to_braille(picture, columns=columns)]


def texts(picture):
    root = ElementTree.fromstring(panel_svg(picture.whole, "a", picture.description))
    return [(each.text, each.get("class")) for each in root.iter("{http://www.w3.org/2000/svg}text")]


@pytest.mark.parametrize("columns", WIDTHS)
def test_a_table_has_its_values_in_rows_and_its_marks(columns):
    picture = table([[1, "ab", None], [40, 50]], {(0, 1): Role.WANTED, (1, 0): Role.GOT})
    rows = [row.split() for row in drawn(picture, columns) if any(map(str.isalnum, row))]
    plain = [[word for word in row if word[0].isalnum()] for row in rows]
    assert plain == [["1", "abo", "None"], ["40x", "50"], ["o", "expected", "x", "got"]]
    assert all(len(row) <= columns for row in drawn(picture, columns))
    assert ("ab", "halo t-wanted") in texts(picture)
    assert ("40", "halo t-got") in texts(picture)


@pytest.mark.parametrize("columns", WIDTHS)
def test_what_has_no_room_in_a_cell_is_cut(columns):
    (row,) = drawn(table([["x" * 99, "<&\x1b"]]), columns)
    assert "x…" in row
    assert "\x1b" not in row
    assert texts(table([["<&\x1b"]]))[0][0] == "<&\\x1b"


def test_nothing_is_drawn_of_no_rows():
    assert drawn(table([]), 76) == []


@pytest.mark.parametrize("columns", WIDTHS)
def test_a_graph_has_its_names_and_marks(columns):
    picture = graph("ABCD", ["AB", "CD"], {"A": Role.WANTED, ("C", "D"): Role.GOT}, arrows=True)
    rows = "\n".join(drawn(picture, columns))
    assert [rows.count(letter) for letter in ("Ao", "B", "C", "D")] == [1, 1, 1, 1]
    assert rows.index("A") < rows.index("D") < rows.index("C")
    assert {role for stroke in picture.whole.strokes for role in [stroke.role]} == {Role.LINE, Role.GOT}
    assert {text for text, _ in texts(picture)} == {*"ABCD"}


def test_a_name_that_an_edge_has_and_the_graph_has_not_is_an_error():
    with pytest.raises(KeyError):
        graph("AB", ["AC"])

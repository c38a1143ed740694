"""Some pictures as they were when somebody last looked at them, and what holds of all of them."""

from __future__ import annotations

import random
import xml.etree.ElementTree as ElementTree
from dataclasses import replace
from itertools import pairwise

import pytest
from picture_cases import CASES, FOLDER, ROOT, picture, picture_of, to_svg, wanted_words
from sampling import daily

from judge.data.load import load_data
from judge.drawing import labels
from judge.drawing.braille import COLUMNS, LEAST_COLUMNS, LEAST_ROWS, MOST_ROWS, ROWS, to_braille
from judge.drawing.shapes import Role
from judge.problem.declare import Shown
from judge.problem.load import load_problem
from judge.problem.module import load_module

SVG = "{http://www.w3.org/2000/svg}"
ANSWERS = ["1", "None", "[]", "[(1.5, 2.0), (-3e9, 1e-300)]", "[(1e300, -4)]", "2 1 2 3 4", "0.25", "\x00<&"]
KATAS = sorted(path.parent.name for path in ROOT.glob("problems/*/problem.toml"))


def coordinates(root, x=0.0, y=0.0):
    """Every coordinate of the drawing, groups moved to their place."""
    for item in root:
        left, top = x, y
        if moved := item.get("transform"):
            a, b = moved.removeprefix("translate(").removesuffix(")").split()
            left, top = x + float(a), y + float(b)
        for pair in (item.get("points") or "").split():
            a, b = pair.split(",")
            yield left + float(a), top + float(b)
        for names in (("x", "y"), ("cx", "cy")):
            if item.get(names[0]) is not None:
                yield left + float(item.get(names[0])), top + float(item.get(names[1]))
        yield from coordinates(item, left, top)


def check_svg(text):
    for each in text.removesuffix("</svg>\n").split("</svg>\n"):
        check_panel(ElementTree.fromstring(f"{each}</svg>"))


def check_panel(root):
    left, top, width, height = map(float, root.get("viewBox").split())
    for x, y in coordinates(root):
        assert left <= x <= left + width
        assert top <= y <= top + height
    for label in root.iter(f"{SVG}text"):
        if "halo" in label.get("class", "") and label.get("text-anchor") == "middle":
            assert labels.width(label.text) / 2 <= min(float(label.get("x")), 400 - float(label.get("x")))
    assert root.get("role") == "img"
    assert root.find(f"{SVG}title").text
    assert root.find(f"{SVG}desc").text
    return root


CROWDED = {"nearest": 3, "beams": 1}  # cases with more than six circles, and O, in one character
LEGEND = ("true scale", "o expected", "x got", "* both")


def lines_of(drawn, rows=ROWS, columns=COLUMNS):
    """The drawing itself, and the words around it."""
    found = ["".join(piece.text for piece in row) for row in to_braille(drawn, rows, columns)]
    assert len(found) <= max(rows, LEAST_ROWS)
    assert max(map(len, found)) <= columns
    words = [found.pop(0)] if drawn.lens else []
    while " away" in found[-1] or found[-1].startswith(LEGEND):
        words.append(found.pop())
    return found, "  ".join(words)


def check_braille(drawn):
    """It is as low and as narrow as the terminal asks, and names what it draws."""
    heights = [len(to_braille(drawn, rows)) for rows in (0, LEAST_ROWS, 12, ROWS, MOST_ROWS, 99)]
    assert all(more >= less - 1 for less, more in pairwise(heights))  # blank rows at the ends are left out
    assert heights[0] == heights[1]
    assert heights[-2] == heights[-1]
    for rows in (0, LEAST_ROWS, 12, ROWS, MOST_ROWS):
        for columns in (LEAST_COLUMNS, COLUMNS, 76):
            body, words = lines_of(drawn, rows, columns)
            marks = "".join(body)
            assert [each for each in "ox*" if each in words.split()] == [
                each for each in "ox*" if each in marks
            ]
            assert body[0].strip()
            assert body[-1].strip()
            assert ("true scale" in words.lower()) or columns == LEAST_COLUMNS


@pytest.mark.parametrize("name", CASES)
def test_the_picture_is_the_one_that_was_looked_at(name):
    drawn = to_svg(picture(name))
    assert drawn == (FOLDER / f"{name}.svg").read_text(encoding="utf-8")
    check_svg(drawn)
    check_braille(picture(name))


@pytest.mark.slow
@pytest.mark.parametrize("name", daily(KATAS, ["circle-circle", "csg"]))
def test_any_case_can_be_drawn_with_any_answer(name, built, monkeypatch):
    monkeypatch.setenv("JUDGE_CACHE", str(built))
    problem = load_problem(ROOT / "problems" / name)
    module = load_module(problem)
    if module.hooks.picture is None:
        assert name in ("stable-roots", "test-writer")  # their cases are no figures
        return
    chosen = random.Random(name)
    for group in load_data(problem).groups:
        if group.group.size is not None:
            continue  # a big case is not shown at all
        for case in chosen.sample(group.cases, min(2, len(group.cases))):
            right = wanted_words(problem, module.solve(*case))
            for got in (right, chosen.choice(ANSWERS)):
                drawn = picture_of(problem, case, got, module)
                if drawn is None:
                    assert group.group.name == "empty"  # where there is nothing to draw
                    continue
                check_svg(to_svg(drawn))
        if drawn is not None:
            check_braille(drawn)


@pytest.mark.slow
@pytest.mark.parametrize("name", daily(KATAS, ["polygon", "beams"]))
def test_no_named_point_is_lost(name, built, monkeypatch):
    """Of the first six cases of each group; `CROWDED` says where more meet than can be named."""
    monkeypatch.setenv("JUDGE_CACHE", str(built))
    problem = load_problem(ROOT / "problems" / name)
    module = load_module(problem)
    lost = []
    for group in load_data(problem).groups if module.hooks.picture else ():
        for case in group.cases[:6]:
            drawn = picture_of(problem, case, wanted_words(problem, module.solve(*case)), module)
            if drawn is None:
                continue
            body, words = lines_of(drawn, 14, 76)
            signs = {mark.sign for mark in drawn.whole.marks if mark.sign and mark.role is Role.CASE}
            lost += [case] * any(sign not in "".join(body) for sign in signs)
            for mark in drawn.whole.marks:
                assert not mark.away or f" {mark.away} away" in words
    assert len(lost) <= CROWDED.get(name, 0), lost


def test_a_point_far_away_is_an_arrow_where_its_own_line_leaves():
    """As in README's count: A lies far to the right on the line through B, which misses C."""
    problem = load_problem(ROOT / "problems" / "count")
    body, words = lines_of(picture_of(problem, (0, 0, 0, (6e-5, 0), (0, 1e-9)), "1"), 14)
    (row,) = (line for line in body if "A→" in line)
    assert "B" in row
    assert "A→ 6e-5 away" in words


def test_what_is_drawn_is_near_one():
    """However large the coordinates and however small the gap."""
    drawn = picture("exact-hairline")
    assert drawn.lens is not None
    for panel in drawn.panels:
        dots = [dot for stroke in panel.strokes for dot in stroke.dots] + [mark.at for mark in panel.marks]
        assert all(abs(x) <= 1 + 1e-9 and abs(y) <= 1 + 1e-9 for x, y in dots)
    assert sum("expected" in mark.text for mark in drawn.lens.marks) == 2
    assert drawn.lens.bars[0].text == "1e-200 e across"


def test_the_lens_shows_on_which_side_the_end_of_the_segment_is():
    lens = picture("segment-end").lens
    marks = {mark.text: mark.at for mark in lens.marks}
    assert marks["B"] == (0, 0)
    assert marks["got"][0] < -0.4
    assert lens.note == "B is outside the circle by 2.9e-7·e"


def test_what_is_no_figure_of_the_topic_has_no_picture():
    middle = load_problem(ROOT / "tests" / "fixtures" / "pack" / "problems" / "middle")
    assert load_module(middle).hooks.picture is None
    problem = load_problem(ROOT / "problems" / "count")
    shown = Shown(problem, {"a": 1, "b": [1, 2]}, None, "1", "2")
    assert load_module(problem).hooks.picture(shown) is None


def test_a_panel_needs_no_scale_bar():
    drawn = picture("offset")
    bare = to_svg(replace(drawn, whole=replace(drawn.whole, bars=()), lens=None))
    check_svg(bare)
    assert 'class="bar"' not in bare
    assert 'class="bar"' in to_svg(drawn)

"""`judge try --open`: the page on which a case is dragged, as a file and as a browser shows it."""

from __future__ import annotations

import json
import os
import random
import re
from html import unescape
from pathlib import Path

import msgspec
import pytest
from chromium import CHROMIUM, dom
from sampling import nightly

import judge.cli.commands.cases as cases
import judge.geometry.explore as explore
from judge.data.build import bounds_fault, draw_cases
from judge.errors import ProblemError
from judge.geometry.views import VIEWS
from judge.problem.declare import InvalidCase, Real, decisions
from judge.problem.find import find_problem, sound_problems
from judge.problem.module import load_module

pytestmark = pytest.mark.slow

browser = pytest.mark.skipif(CHROMIUM is None, reason="Chromium is not installed")
TOUCH = "0, 0, 1, (-1, 1), (1, 1)"


@pytest.fixture(autouse=True)
def _nothing_is_opened(monkeypatch):
    monkeypatch.setattr(cases, "opened_in_browser", lambda place: bool(place))


def start_of(page):
    (text,) = re.findall(r'<script type="application/json" id="start">(.*?)</script>', page, re.DOTALL)
    return json.loads(text)


def test_it_writes_one_file_that_loads_nothing(judge):
    ended = judge("try", "count", "--open")
    assert (ended.status, ended.out, ended.err) == (0, "Wrote judge-try.html: count\n", "")
    page = Path("judge-try.html").read_text(encoding="utf-8")
    assert not re.search(
        r"""(src|href)=|@import|url\(|fetch\(|XMLHttp|WebSocket|https?://(?!www\.w3\.org/2000/svg)""", page
    )
    assert "default-src 'none'" in page
    assert start_of(page)["kind"] == "line"
    assert start_of(page)["cases"][0][0] == "Example 1"
    assert judge("try", "count", "--open").status == 0  # over its own page


@pytest.mark.parametrize(
    ("words", "kind", "numbers"),
    [
        (("count", TOUCH), "line", ["0", "0", "1", "-1", "1", "1", "1"]),
        (
            ("exact-count", f"0, 0, {10**40}, (1, 2), (3, 4)"),
            "line",
            ["0", "0", str(10**40), "1", "2", "3", "4"],
        ),
        (("segment", "0, 0, 5, (-6, 3), (6, 3.5)"), "segment", ["0", "0", "5", "-6", "3", "6", "3.5"]),
    ],
)
def test_a_case_of_ones_own(judge, words, kind, numbers):
    _, line = judge("try", *words, "--open", "--json").lines
    assert json.loads(line) == {"schema": 1, "problem": words[0], "file": "judge-try.html"}
    start = start_of(Path("judge-try.html").read_text(encoding="utf-8"))
    assert (start["kind"], start["problem"], start["cases"][0][0]) == (
        kind,
        words[0],
        "The case it was opened with",
    )
    assert list(explore._flat([each["value"] for each in start["args"]])) == numbers
    assert (start["clear"], start["whole"]) == ((0, True) if words[0] == "exact-count" else (10**7, False))


def test_the_case_that_broke_a_file(judge, submit):
    name = submit("def line_count(cx, cy, r, A, B):\n    return 2\n", "mine.py")
    found = json.loads(judge("run", "count", name, "--no-name", "--group", "grid", "--json").out)[
        "counterexample"
    ]
    assert judge("try", "--open").status == 1
    start = start_of(Path("judge-try.html").read_text(encoding="utf-8"))
    case = found["input"]
    numbers = explore._flat([each["value"] for each in start["args"]])
    assert list(map(float, numbers)) == [case["cx"], case["cy"], case["r"], *case["A"], *case["B"]]


def test_it_is_opened_in_the_browser_or_that_is_said(judge, monkeypatch):
    addresses = []
    for found, said in ((True, ""), (False, "judge: No browser here. Open judge-try.html\n")):
        monkeypatch.setattr(cases, "opened_in_browser", lambda at, found=found: addresses.append(at) or found)
        ended = judge("try", "count", TOUCH, "--open")
        assert (ended.status, ended.err) == (0, said)
        assert ended.out.endswith("Wrote judge-try.html: count\n")
    assert addresses == ["judge-try.html"] * 2


def test_what_the_browser_says_goes_nowhere(process, submit, tmp_path):
    for name in ("xdg-open", "open"):
        (tmp_path / submit("#!/bin/sh\necho noise\necho noise >&2\n", name)).chmod(0o755)
    ended = process("try", "count", TOUCH, "--open", PATH=f"{tmp_path}:{os.environ['PATH']}")
    assert (ended.status, ended.err) == (0, "")
    assert "noise" not in ended.out


def test_a_kata_without_a_page_and_a_case_too_large_for_one(judge):
    ended = judge("try", "sphere", "--open")
    assert (ended.status, ended.out) == (2, "")
    assert ended.err == "judge: There is no page for sphere yet\n"
    rays = ", ".join(f"(({x}, 0), (1, 0))" for x in range(200))
    ended = judge("try", "nearest", f"[(0, 0, 1)], [{rays}]", "--open")
    assert ended.status == 2
    assert not Path("judge-try.html").exists()
    assert "the case has 803 numbers, and a page has 600 at most" in ended.err


# -- in a browser --------------------------------------------------------------------------------------------


def shown(tmp_path, problem, values, script=""):
    """The page's text after a script has run in it, which may say more in a <pre id="said">."""
    html = load_module(found := find_problem(problem)).hooks.explore(found, values)
    html = re.sub(r"<meta http-equiv=[^>]*>", "", html)
    page = tmp_path / "judge-try.html"
    page.write_text(
        html.replace("</body>", f"<pre id='said'></pre><script>{script}</script></body>"), encoding="utf-8"
    )
    return dom(page)


def text_of(page, name):
    (found,) = re.findall(rf'<(\w+)[^>]* id="{name}"[^>]*>(.*?)</\1>', page, re.DOTALL)
    return unescape(re.sub(r"<[^>]+>", "", found[1])).strip()


def values(*case):
    return dict(zip(("cx", "cy", "r", "A", "B"), case, strict=True))


@browser
@pytest.mark.parametrize(
    ("problem", "case", "answer", "promise"),
    [
        (
            "count",
            (0, 0, 1, (-1, 1 + 1e-9), (1, 1 + 1e-9)),
            "0 points",
            "The line is almost a tangent: not a valid input",
        ),
        nightly("segment", (0, 0, 5, (3, 4), (3, 4)), "1 point", "A is exactly on the circle"),
        nightly("ray-nearest", (0, 0, 1, (-3, 0), (2, 0)), "a hit at t = 1", "clear"),
    ],
)
def test_what_it_says(tmp_path, problem, case, answer, promise):
    page = shown(tmp_path, problem, values(*case))
    assert text_of(page, "answer") == answer
    assert promise in text_of(page, "promise")
    cx, cy, r, a, b = case
    assert text_of(page, "case") == f'judge try {problem} "{cx}, {cy}, {r}, {a}, {b}"'


MOVES = """
const handle = name => document.querySelector(`[data-handle="${name}"]`);
const press = (name, key, more = {}) =>
  handle(name).dispatchEvent(new KeyboardEvent("keydown", {key, bubbles: true, ...more}));
document.getElementById("step").value = "0.1";
press("p1", "ArrowUp"); press("p1", "ArrowLeft", {shiftKey: true}); press("r0", "ArrowRight");
document.getElementById("step").value = "1e-13";
press("p2", "ArrowDown");
const keyed = document.getElementById("case").textContent;
const scene = document.getElementById("scene"), box = scene.getBoundingClientRect();
const grip = handle("p0").querySelector(".grip").getBoundingClientRect();
scene.setPointerCapture = () => {};
document.getElementById("step").value = "1";
const point = (kind, x, y, target) => target.dispatchEvent(new PointerEvent(kind,
  {bubbles: true, pointerId: 1, pointerType: "touch", clientX: x, clientY: y}));
const [x, y] = [grip.x + grip.width / 2, grip.y + grip.height / 2];
point("pointerdown", x, y, handle("p0").querySelector(".reach"));
point("pointermove", x + box.width / 4, y, scene);
point("pointerup", x + box.width / 4, y, scene);
const dragged = document.getElementById("case").textContent;
const examples = document.getElementById("examples");
examples.value = "1"; examples.dispatchEvent(new Event("change"));
const example = document.getElementById("case").textContent;
const field = document.querySelector('#numbers input');
field.value = "1e999"; field.dispatchEvent(new Event("input"));
const invalid = field.getAttribute("aria-invalid");
document.getElementById("said").textContent = JSON.stringify([keyed, dragged, example, invalid]);
"""


@browser
@pytest.mark.nightly
def test_keys_fingers_and_fields_move_it(tmp_path):
    page = shown(tmp_path, "count", values(0, 0, 5, (-7, -1), (6, 4)), MOVES)
    keyed, dragged, example, invalid = json.loads(text_of(page, "said"))
    assert keyed == 'judge try count "0, 0, 5.1, (-8, -0.9), (6, 3.9999999999999)"'
    moved = re.fullmatch(r'judge try count "(\d+), 0, 5\.1, \(-8, -0\.9\), \(6, 3\.9999999999999\)"', dragged)
    assert moved is not None, dragged
    assert int(moved[1]) in range(3, 12)
    assert example == 'judge try count "0, 0, 5, (-6, 3), (-5, 3)"'
    assert invalid == "true"


BELOW = """
const fields = [...document.querySelectorAll("#numbers input")], shown = [];
for (const [i, text] of CHANGES) {
  const before = document.getElementById("case").textContent, field = fields[i], old = field.value;
  field.value = text; field.dispatchEvent(new Event("input"));
  shown.push([document.getElementById("promise").textContent, field.getAttribute("aria-invalid"),
    document.getElementById("case").textContent === before]);
  field.value = old; field.dispatchEvent(new Event("input"));
}
document.getElementById("said").textContent = JSON.stringify(shown);
"""


@browser
@pytest.mark.parametrize(
    ("problem", "changes", "bounds"),
    [
        (
            "silhouette",
            [(-1, "-0.25"), (-1, "0.5"), (2, "-1")],
            ["0.0001 to 0.4999"] * 2 + ["0 to 1073741824"],
        ),
        nightly(
            "circle-side", [(2, "0"), (0, "1000000001")], ["1 to 1000000000", "-1000000000 to 1000000000"]
        ),
        nightly("exact-count", [(2, "-1"), (3, f"1{'0' * 120}1")], ["0 to 1e+120", "-1e+120 to 1e+120"]),
    ],
)
def test_a_number_out_of_its_bounds_is_no_valid_input(tmp_path, problem, changes, bounds):
    last = sum(1 for _ in explore._flat(find_problem(problem).examples[0].case))
    places = json.dumps([(at % last, text) for at, text in changes])
    page = shown(tmp_path, problem, None, BELOW.replace("CHANGES", places))
    for (_, text), ends, (said, refused, same) in zip(
        changes, bounds, json.loads(text_of(page, "said")), strict=True
    ):
        assert said.endswith(f" has {text}, outside {ends}: not a valid input")
        assert (refused, same) == ("true", True)
    assert "not a valid" not in text_of(page, "promise")


@browser
def test_a_first_case_that_is_none_gives_way_to_an_example(tmp_path):
    page = shown(tmp_path, "count", values(0, 0, -1, (0, 0), (1, 1)))
    assert "The case it was opened with" in page
    assert text_of(page, "case") == 'judge try count "0, 0, 5, (-6, 3), (-5, 3)"'


# -- what the page decides against each kata's `solve` ------------------------------------------------------

FOLDER = Path(explore.__file__).parent
PAGE = """<!doctype html><meta charset="utf-8"><pre id="told"></pre><script>EXACT
FIGURES
const shortened = text => text;
const told = CASES.map(([start, texts, args]) => {
  const { broken, decisions, rows, answer } = figure(start.kind, start, Exact.arithmetic(texts), args);
  return [broken, decisions.map(each => [each.almost, each.gap]), rows.flatMap(each => each[1]), answer];
});
document.getElementById("told").textContent = JSON.stringify(told);
</script></html>"""
CASES = 2  # of each group, and each of them once more a little off
WORDS = {  # how what is said of an answer begins, where it is no real number
    "line": str,
    "count in a segment": lambda answer: f"{answer} point",
    "frames": lambda answer: " ".join(map(str, answer)),
    "rows": lambda answer: " ".join(map(str, answer)),
    "light": str,
}
CUT = {"rows", "many"}  # kinds whose `solve` asks only where doubles leave a doubt


def moved(problem, case, chance):
    """The case with one number off by so little that the promise may notice; no word of a program is."""
    flat, integers = list(explore._flat(case)), all(isinstance(x, int) for x in explore._flat(case))
    words = [
        "integer" in parameter.type.text and not integers
        for parameter, value in zip(problem.parameters, case, strict=True)
        for _ in explore._flat((value,))
    ]
    place, size = chance.choice([at for at, word in enumerate(words) if not word]), max(map(abs, flat)) or 1
    off = (
        chance.choice((-1, 1))
        if integers
        else size * 10.0 ** chance.uniform(-17, -5) * chance.choice((-1, 1))
    )
    found = iter([x + off if at == place and x else x for at, x in enumerate(flat)])

    def rebuilt(value):
        return tuple(map(rebuilt, value)) if isinstance(value, tuple) else next(found)

    return rebuilt(case)


def merged(case):
    """The case with one of its points at the place of the one before."""
    for at in range(1, len(case)):
        if case[at - 1] != case[at] and all(
            isinstance(each, tuple) and len(each) == 2 for each in case[at - 1 : at + 1]
        ):
            yield (*case[:at], case[at - 1], *case[at + 1 :])
            return


def asked():
    """(kata, kind, what the page starts with, case, its answer or InvalidCase, what was decided)."""
    chance = random.Random(20261127)
    for problem in sound_problems()[0]:
        module = load_module(problem)
        page = module.hooks and module.hooks.explore and module.hooks.explore(problem, None)
        if not page:
            continue
        start = start_of(page)
        for group in problem.groups[1:]:
            if group.size is not None or sum(1 for _ in explore._flat(problem.examples[0].case)) > 600:
                continue
            for case, *_ in draw_cases(problem, module, msgspec.structs.replace(group, count=CASES)):
                if sum(1 for _ in explore._flat(case)) > 120:
                    continue
                other = moved(problem, case, chance)
                beside = () if bounds_fault(problem, other) else (other,)  # a length may be below 0
                for each in (case, *beside, *merged(case)):
                    with decisions() as made:
                        try:
                            found = module.solve(*each)
                        except InvalidCase as broken:
                            found = broken
                        except ProblemError:  # a radius below 0
                            continue
                    yield problem, start, each, found, made


def numbers_of(answer):
    """The real numbers of an exact answer."""
    if isinstance(answer, Real):
        yield float(answer.x)
    elif isinstance(answer, list | tuple):
        for each in answer:
            yield from numbers_of(each)


def close(x, y):
    return abs(x - y) <= 1e-6 * max(abs(x), abs(y))


@browser
def test_it_decides_as_the_reference_does(tmp_path):
    cases = list(asked())
    plain = [
        [start, list(map(repr, explore._flat(case))), explore._texts(case)] for _, start, case, _, _ in cases
    ]
    text = PAGE.replace("EXACT", (FOLDER / "exact.js").read_text(encoding="utf-8"), 1)
    figures = "\n".join((FOLDER / name).read_text(encoding="utf-8") for name in ("plane.js", "figures.js"))
    text = text.replace("FIGURES", figures, 1)
    page = tmp_path / "exact.html"
    page.write_text(text.replace("CASES", json.dumps(plain), 1), encoding="utf-8")
    (told,) = re.findall(r'<pre id="told">(.*?)</pre>', dom(page), re.DOTALL)
    faults, broken, kinds = [], 0, set()
    for (problem, start, case, answer, made), (refused, decided, rows, said) in zip(
        cases, json.loads(unescape(told)), strict=True
    ):
        kinds.add(start["kind"])
        if isinstance(answer, InvalidCase):
            broken += 1
            if refused is None or not (refused in str(answer) or refused.endswith(("small", "0", "solid"))):
                faults.append((problem.id, case, str(answer), refused))
            continue
        if refused is not None:
            faults.append((problem.id, case, "valid", refused))
        if start["kind"] not in CUT:
            gaps = [float(gap) for _, gap in decided]
            faults += [
                (problem.id, case, each, decided)
                for each in made
                if not any(close(each.gap, gap) for gap in gaps)
            ]
            asked_for = [each.gap for each in made]
            if made:
                faults += [
                    (problem.id, case, f"not asked: {name} {gap}")
                    for name, gap in decided
                    if not any(close(float(gap), each) for each in asked_for)
                ]
        shown = list(map(float, rows))
        missing = [x for x in numbers_of(answer) if not any(close(x, y) for y in shown)]
        words = WORDS.get(start["kind"], lambda answer: "")(answer)
        if missing or not said.startswith(words):
            faults.append((problem.id, case, answer, said, missing))
    assert faults[:3] == []
    assert broken > 60  # or the edges of the promise were not asked for
    assert kinds == VIEWS.keys() - {"sphere"}

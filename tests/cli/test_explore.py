"""`judge explore`: the page as a file and as a browser shows it."""

from __future__ import annotations

import json
import re
from html import unescape
from pathlib import Path

import pytest
from chromium import CHROMIUM, dom

from judge.problem.find import find_problem
from judge.topics.circles.explore import explored
from judge.topics.circles.part import Part

pytestmark = pytest.mark.slow

browser = pytest.mark.skipif(CHROMIUM is None, reason="there is no Chromium (apt-get install chromium)")
TOUCH = "0, 0, 1, (-1, 1), (1, 1)"


def start_of(page):
    (text,) = re.findall(r'<script type="application/json" id="start">(.*?)</script>', page, re.DOTALL)
    return json.loads(text)


def test_it_writes_one_file_that_loads_nothing(judge):
    ended = judge("explore", "count")
    assert (ended.status, ended.out, ended.err) == (0, "judge-explore.html\n", "")
    page = Path("judge-explore.html").read_text(encoding="utf-8")
    assert not re.search(
        r"""(src|href)=|@import|url\(|fetch\(|XMLHttp|WebSocket|https?://(?!www\.w3\.org/2000/svg)""", page
    )
    assert "default-src 'none'" in page
    assert start_of(page)["kind"] == "line"
    assert judge("explore", "count").status == 0  # over its own page


@pytest.mark.parametrize(
    ("words", "kind", "numbers"),
    [
        (("count", TOUCH), "line", ["0", "0", "1", "-1", "1", "1", "1"]),
        (
            ("count", *["0", "0", "1", "-1", "1e-7", "1", "0.5"]),
            "line",
            ["0", "0", "1", "-1", "1e-07", "1", "0.5"],
        ),
        (
            ("exact-count", f"0, 0, {10**40}, (1, 2), (3, 4)"),
            "line",
            ["0", "0", str(10**40), "1", "2", "3", "4"],
        ),
        (("segment", "0, 0, 5, (-6, 3), (6, 3.5)"), "segment", ["0", "0", "5", "-6", "3", "6", "3.5"]),
    ],
)
def test_a_case_of_ones_own(judge, words, kind, numbers):
    (line,) = judge("explore", *words, "--out", "page.html", "--json").lines
    written = Path("page.html").read_bytes()
    assert json.loads(line) == {"schema": 1, "problem": words[0], "out": "page.html", "bytes": len(written)}
    start = start_of(written.decode())
    assert (start["kind"], start["numbers"], start["problems"][kind]) == (kind, numbers, words[0])
    bands = [["0", "1"]] * 2 if words[0] == "exact-count" else [["1", str(10**12)], ["1", str(10**7)]]
    assert [start["bands"]["snap"], start["bands"]["clear"]] == bands


def test_the_case_that_broke_a_file(judge, submit):
    name = submit("def line_count(cx, cy, r, A, B):\n    return 2\n", "mine.py")
    found = json.loads(judge("run", "count", name, "--no-name", "--group", "grid", "--json").out)[
        "counterexample"
    ]
    assert judge("explore", found["replay"]).status == 0
    start = start_of(Path("judge-explore.html").read_text(encoding="utf-8"))
    case = found["input"]
    assert [float(x) for x in start["numbers"]] == [case["cx"], case["cy"], case["r"], *case["A"], *case["B"]]


def test_open_asks_for_the_browser_and_nothing_else_does(judge, monkeypatch):
    asked = []
    monkeypatch.setattr("webbrowser.open", lambda address: asked.append(address) or len(asked) < 2)
    assert judge("explore", "count").status == 0
    assert asked == []
    ended = judge("explore", "count", "--open")
    assert (ended.status, asked, ended.err) == (0, [Path("judge-explore.html").absolute().as_uri()], "")
    ended = judge("explore", "count", "--open")
    assert (ended.status, ended.err) == (
        0,
        "judge: there is no browser here; open judge-explore.html yourself\n",
    )


# -- in a browser --------------------------------------------------------------------------------------------


def shown(tmp_path, problem, part, values, script=""):
    """The page's text after a script has run in it, which may say more in a <pre id="said">."""
    html = explored(part, find_problem(problem), values)
    html = re.sub(r"<meta http-equiv=[^>]*>", "", html)
    page = tmp_path / "page.html"
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
    ("problem", "part", "case", "answer", "promise"),
    [
        ("count", Part.LINE, (0, 0, 1, (-1, 1), (1, 1)), "1 point", "keeps the promise"),
        ("count", Part.LINE, (0, 0, 1, (-1, 1 + 1e-9), (1, 1 + 1e-9)), "0 points", "between the bands"),
        ("segment", Part.SEGMENT, (0, 0, 5, (3, 4), (3, 4)), "1 point", "keeps the promise"),
        ("ray-nearest", Part.RAY, (0, 0, 1, (-3, 0), (2, 0)), "t = 1", "keeps the promise"),
    ],
)
def test_what_it_says(tmp_path, problem, part, case, answer, promise):
    page = shown(tmp_path, problem, part, values(*case))
    assert text_of(page, "answer") == answer
    assert promise in text_of(page, "promise")
    cx, cy, r, a, b = case
    assert text_of(page, "case") == f'judge try {problem} "{cx}, {cy}, {r}, {a}, {b}"'


MOVES = """
const handle = name => document.querySelector(`[data-handle="${name}"]`);
const press = (name, key, more = {}) =>
  handle(name).dispatchEvent(new KeyboardEvent("keydown", {key, bubbles: true, ...more}));
document.getElementById("step").value = "0.1";
press("A", "ArrowUp"); press("A", "ArrowLeft", {shiftKey: true}); press("R", "ArrowRight");
document.getElementById("step").value = "1e-13";
press("B", "ArrowDown");
const keyed = document.getElementById("case").textContent;
const scene = document.getElementById("scene"), box = scene.getBoundingClientRect();
const grip = handle("C").querySelector(".grip").getBoundingClientRect();
scene.setPointerCapture = () => {};
document.getElementById("step").value = "1";
const point = (kind, x, y, target) => target.dispatchEvent(new PointerEvent(kind,
  {bubbles: true, pointerId: 1, pointerType: "touch", clientX: x, clientY: y}));
const [x, y] = [grip.x + grip.width / 2, grip.y + grip.height / 2];
point("pointerdown", x, y, handle("C").querySelector(".reach"));
point("pointermove", x + box.width / 4, y, scene);
point("pointerup", x + box.width / 4, y, scene);
const dragged = document.getElementById("case").textContent;
document.querySelector('input[value="ray"]').click();
const turned = document.getElementById("case").textContent;
const field = document.querySelector('#numbers input');
field.value = "1e999"; field.dispatchEvent(new Event("input"));
const invalid = field.getAttribute("aria-invalid");
document.getElementById("said").textContent = JSON.stringify([keyed, dragged, turned, invalid]);
"""


@browser
def test_keys_fingers_and_fields_move_it(tmp_path):
    page = shown(tmp_path, "count", Part.LINE, values(0, 0, 5, (-7, -1), (6, 4)), MOVES)
    keyed, dragged, turned, invalid = json.loads(text_of(page, "said"))
    assert keyed == 'judge try count "0, 0, 5.1, (-8, -0.9), (6, 3.9999999999999)"'
    moved = re.fullmatch(r'judge try count "(\d+), 0, 5\.1, \(-8, -0\.9\), \(6, 3\.9999999999999\)"', dragged)
    assert moved is not None, dragged
    assert int(moved[1]) in range(3, 12)
    assert turned.startswith(f'judge try ray-nearest "{moved[1]}, 0, 5.1, (-8, -0.9), (14, 4.8999999')
    assert invalid == "true"

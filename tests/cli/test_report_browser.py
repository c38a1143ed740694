"""The pages as a browser shows them: nothing that a person typed runs, and everybody can read them."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from chromium import CHROMIUM, dom, measured, without_policy
from cli_support import ROOT
from mistaken import mistaken

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(CHROMIUM is None, reason="Chromium is not installed"),
]

PWN = "document.title='pwned';alert(1)"
MARKUP = f"</code></pre></title></svg><script>{PWN}</script><img src=x onerror={PWN}><svg onload={PWN}>"
NAMES = [f"<img src=x onerror={PWN}>.py", "'\"><svg onload=\"document.title='pwned'\">.py", "</title><b>.py"]
HOSTILE = [
    f'"""{MARKUP}"""\n\ndef middle(a, b):\n    return {MARKUP!r}\n',
    f"def middle(a, b):\n    raise ValueError({MARKUP!r})\n",
    f"print({MARKUP!r})\n",
]


@pytest.fixture
def hostile(judge, submit):
    """The report on submissions whose names, answers, exceptions, output and sources are markup."""
    for name, source in zip(NAMES, HOSTILE, strict=True):
        name = name.replace("/", "\u2215")  # what no file's name can hold
        assert judge("run", "middle", submit(source, name), "--no-shrink", "--no-name").status == 1
    assert judge("progress", "--html", "--name", MARKUP).status == 0
    return Path("judge-report.html").absolute()


def test_no_submission_gets_its_script_run(hostile):
    assert hostile.read_text(encoding="utf-8").count("document.title=") >= 8
    shown = dom(hostile)
    (title,) = re.findall(r"<title>(.*?)</title>", shown.split("</head>")[0], re.DOTALL)
    assert title.startswith("Progress: &lt;/code&gt;")
    assert not re.findall(r"<(script|img|b)\b|<svg[^>]* onload", shown)


def test_the_policy_would_stop_what_the_escaping_let_through(hostile):
    script = "document.title = 'pwned'"
    opened = without_policy(hostile, script)
    assert "<title>pwned</title>" in dom(opened)  # so this would be noticed
    html = hostile.read_text(encoding="utf-8")
    hostile.write_text(html.replace("</body>", f"<script>{script}</script></body>"), encoding="utf-8")
    assert "<title>pwned</title>" not in dom(hostile)


@pytest.fixture(scope="module")
def shown(tmp_path_factory):
    return tmp_path_factory.mktemp("shown")


@pytest.fixture
def pages(judge, submit, shown):
    """A report, the page of a class with a student whose name is markup, and the page of that student."""
    found = [shown / "report.html", shown / "class.html", shown / "pages" / "eve.html"]
    if not found[0].exists():
        wrong = [mistaken("count", name) for name in ("forgotten-centre", "absolute-epsilon")]
        for source in (*wrong, (ROOT / "solutions" / "count" / "accepted" / "tolerant.py").read_bytes()):
            name = submit(source, "count.py")
            assert judge("run", "count", name, "--no-shrink").status in (0, 1)
        for student, source in zip(("eve", "zoe"), wrong, strict=True):
            for kata in ("count", "segment", "sphere", "which-side")[: 4 if student == "eve" else 3]:
                submit(source, f"homework/{student}/{kata}.py")
        submit(f"id,name\neve,{PWN}{MARKUP.replace(',', ' ')}\n", "list.csv")
        files = ("--students", "list.csv", "--html", found[1], "--feedback", found[2].parent)
        assert judge("class", "homework", *files).status in (1, 3)
        assert judge("progress", "--html", "--out", found[0], "--name", "Ada").status == 0
    return found


@pytest.mark.parametrize("place", [0, 1, 2])
@pytest.mark.parametrize(("width", "dark"), [(360, True), (1400, False)])
def test_it_fits_and_every_word_stands_out(pages, place, width, dark):
    page = pages[place]
    assert not re.findall(r"<(script|img)\b|<svg[^>]* onload", dom(page))
    found = measured(page, width=width, dark=dark)
    assert found["width"] == width
    assert found["needed"] <= width
    assert found["dark"] is dark
    assert found["paper"] == ("rgb(17, 17, 19)" if dark else "rgb(244, 244, 245)")
    assert found["words"] > 40
    assert found["faint"] == []
    assert found["least"] >= 9  # pixels, of the words in pictures too

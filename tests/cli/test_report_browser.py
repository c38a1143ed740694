"""The pages as a browser shows them: nothing that a person typed runs, and everybody can read them."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from chromium import CHROMIUM, dom, measured, without_policy
from mistaken import mistaken

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(CHROMIUM is None, reason="Chromium is not installed"),
]

PWN = "document.title='pwned';alert(1)"
MARKUP = f"</code></pre></title></svg><script>{PWN}</script><img src=x onerror={PWN}><svg onload={PWN}>"
NAMES = [f"<img src=x onerror={PWN}>", "'\"><svg onload=\"document.title='pwned'\">", "<\u2215title><b>"]
HOSTILE = [
    f'"""{MARKUP}"""\n\ndef middle(a, b):\n    return {MARKUP!r}\n',
    f"def middle(a, b):\n    raise ValueError({MARKUP!r})\n",
    f"print({MARKUP!r})\n",
]


@pytest.fixture
def hostile(judge, submit):
    """The pages of a class whose names, answers, exceptions, output and sources are markup."""
    for name, source in zip(NAMES, HOSTILE, strict=True):
        submit(source, f"homework/{name}/middle.py")
    assert judge("class", "homework", "--html", "class.html", "--feedback", "pages").status in (0, 1, 3)
    pages = [Path("class.html"), *Path("pages").glob("*.html")]
    assert len(pages) == 4
    return [page.rename(f"{at}.html").absolute() for at, page in enumerate(pages)]


def test_no_submission_gets_its_script_run(hostile):
    assert sum(page.read_text(encoding="utf-8").count("document.title=") for page in hostile) >= 8
    for page in hostile:
        shown = dom(page)
        (title,) = re.findall(r"<title>(.*?)</title>", shown.split("</head>")[0], re.DOTALL)
        assert title != "pwned"
        assert not re.findall(r"<(script|img|b)\b|<svg[^>]* onload", shown)


def test_the_policy_would_stop_what_the_escaping_let_through(hostile):
    page, script = hostile[0], "document.title = 'pwned'"
    opened = without_policy(page, script)
    assert "<title>pwned</title>" in dom(opened)  # so this would be noticed
    html = page.read_text(encoding="utf-8")
    page.write_text(html.replace("</body>", f"<script>{script}</script></body>"), encoding="utf-8")
    assert "<title>pwned</title>" not in dom(page)


@pytest.fixture(scope="module")
def shown(tmp_path_factory):
    return tmp_path_factory.mktemp("shown")


@pytest.fixture
def pages(judge, submit, shown):
    """The page of a class with a student whose name is markup, and the page of that student."""
    found = [shown / "class.html", shown / "pages" / "eve.html"]
    if not found[0].exists():
        wrong = [mistaken("count", name) for name in ("forgotten-centre", "absolute-epsilon")]
        for student, source in zip(("eve", "zoe"), wrong, strict=True):
            for kata in ("count", "segment", "sphere", "which-side")[: 4 if student == "eve" else 3]:
                submit(source, f"homework/{student}/{kata}.py")
        submit(f"id,name\neve,{PWN}{MARKUP.replace(',', ' ')}\n", "list.csv")
        files = ("--students", "list.csv", "--html", found[0], "--feedback", found[1].parent)
        assert judge("class", "homework", *files).status in (1, 3)
    return found


@pytest.mark.parametrize("place", [0, 1])
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

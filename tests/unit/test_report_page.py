"""The HTML report: what it tells, that it is sound HTML, and that nothing gets out of its place."""

from __future__ import annotations

import base64
import hashlib
import re
from collections import Counter

import pytest
from msgspec.structs import replace
from page_support import Outline, check_html, html_of, kept, known, outcome, page_of

from judge.kata.skills import Need, NeedProgress, Skill, SkillProgress
from judge.problem import Verdict
from judge.report.page.compose import MOST_RUNS
from judge.report.page.plot import MOST
from judge.report.page.render import is_report

EVIL = (
    "</style></title><script>document.title='pwned'</script>\"'><img src=x onerror=alert(1)>&amp;\x00\u202e"
)


NEED = Need("count", ("tangent",))


def met(since, attempts, *mistakes):
    return NeedProgress(NEED, since, (), attempts, dict.fromkeys(mistakes, 1))


def progress(name, *needs):
    return SkillProgress(Skill(name, f"About {name}.", (NEED,) * len(needs)), needs)


@pytest.fixture
def path(tmp_path):
    return tmp_path / "history.sqlite3"


def test_it_tells_the_way_to_a_solved_problem(path):
    results = [
        outcome(mistake="forgotten-centre"),
        outcome(verdict=Verdict.TLE, ratio=130.0),
        outcome(mistake="forgotten-centre"),
        outcome(verdict=Verdict.AC, ratio=1.5),
    ]
    page = page_of(kept(path, results), known("count", "segment"), {"count": b"def line_count(): ..."})
    (part,) = page.problems
    assert [line.number for line in part.runs] == [4, 3, 2, 1]
    assert [line.mistake for line in part.runs] == ["", "forgotten-centre", "", "forgotten-centre"]
    assert [line.ratio for line in part.runs] == ["1.5 ×", "", "130 ×", ""]
    assert [(case.title, case.number, case.times) for case in part.cases] == [
        ("forgotten-centre", 3, 2),
        ("Time limit exceeded in tangent", 2, 1),
    ]
    assert part.cases[0].overcome is not None
    assert part.cases[0].explained[0].advice.startswith("The circle is treated as if its centre")
    assert [line.part is not None for line in page.overview] == [True, False]
    assert page.untried == (("middle", ("segment",)),)
    assert [(tile.value, tile.label) for tile in page.tiles] == [
        ("1 of 2", "problems solved"),
        ("4", "runs on 1 day"),
        ("1 of 1", "mistakes overcome"),
    ]


def test_the_problems_own_solutions_are_listed_but_count_for_nothing(path):
    (run,) = kept(path, [outcome(verdict=Verdict.AC, ratio=1.0)])
    page = page_of([replace(run, path="/judge/solutions/count/accepted/exact.py")])
    (part,) = page.problems
    assert (part.solved, part.best, part.attempts, part.plot, len(part.runs)) == (None, "0", 0, None, 1)
    assert "no runs of your own" in html_of([replace(run, path="/judge/solutions/count/wrong/blind.py")])


def test_the_page_is_sound_and_the_same_every_time(path):
    results = [
        outcome(mistake="absolute-epsilon"),
        outcome(mistake="forgotten-centre + absolute-epsilon"),
        outcome("segment", expected="[(0.0, 1.0)]", got="[(0.0, 1.0), (0.5, 1.0)]"),
        *(outcome(name) for name in ("gone", "main", 'a" onclick="b', "<b>")),
        outcome(verdict=Verdict.AC, ratio=0.8),
    ]
    runs = kept(path, results)
    skills = [
        progress("tangents", met(runs[0].when, 2)),
        progress("scale", met(runs[1].when, 1), met(None, 1, "absolute-epsilon")),
        progress("rays", met(None, 0)),
        progress("ends", NeedProgress(NEED, runs[0].when, ("tangent",), 3, {})),
    ]
    sources = {"count": b"x = 1\n"}
    html = html_of(runs, known("count", "segment"), sources, skills=skills, person="Ada")
    outline = check_html(html)
    drawn = [svg for svg in outline.all("svg") if "case" in svg.get("aria-labelledby", "")]
    assert len(drawn) >= 3
    states = [line.state for line in page_of(runs, skills=skills).skills]
    assert states == ["shown", "shown", "open", "lost"]
    for words in ("Since 1 Mar 2026, 2 runs", ", on 1 of 2 problems, 1 run; met absolute-epsilon", "Not yet"):
        assert words in outline.text
    assert "Shown once, but the latest run fails it, 3 runs" in outline.text
    assert "This problem is not there any more." in outline.text
    assert html == html_of(runs, known("count", "segment"), sources, skills=skills, person="Ada")


def test_nothing_that_a_submission_says_gets_out_of_its_place(path):
    plain = Outline(html_of(kept(path, [outcome()]), sources={"count": b"x"}, person="Ada"))
    evil = outcome(name=EVIL, mistake=EVIL, got=EVIL, message=EVIL)
    evil = replace(evil, counterexample={"input": None, "expected": EVIL, "got": EVIL, "message": EVIL,
                                         "replay": None})  # fmt: skip
    runs = kept(path.with_name("other"), [evil], EVIL.encode())
    html = html_of(runs, sources={"count": EVIL.encode()}, person=EVIL)
    outline = check_html(html)
    assert outline.text.count("document.title='pwned'") >= 6
    assert "\\x00\\u202e" in outline.text
    assert not set("\x00\u202e") & set(html)
    assert Counter(tag for tag, _ in outline.tags)["style"] == Counter(tag for tag, _ in plain.tags)["style"]


def test_only_the_pages_own_style_sheet_is_allowed(path):
    html = html_of(kept(path, [outcome()]))
    (policy,) = [m["content"] for m in Outline(html).all("meta") if "http-equiv" in m]
    (sheet,) = re.findall("<style>(.*?)</style>", html, re.DOTALL)
    digest = base64.b64encode(hashlib.sha256(sheet.encode()).digest()).decode()
    allowed = f"style-src 'sha256-{digest}'"
    assert policy == f"default-src 'none'; {allowed}; base-uri 'none'; form-action 'none'"


def test_a_result_of_another_form_is_told_of_without_its_details(path):
    runs = kept(path, [outcome(), outcome(verdict=Verdict.AC, ratio=1.0)])
    broken = [replace(runs[0], packed=b"rubbish"), runs[1]]
    (part,) = page_of(broken).problems
    assert part.cases[0].facts == ()
    assert part.cases[0].drawings == ()
    check_html(html_of(broken))


@pytest.mark.parametrize(
    "values",
    [{"cx": 0, "cy": 0, "r": -1, "A": [0, 1], "B": [1, 1]}, {"cx": 0, "cy": 0, "r": 1, "A": 5, "B": [1]}],
)
def test_a_case_that_is_none_of_the_problems_is_not_drawn(path, values):
    (part,) = page_of(kept(path, [outcome(input=values)])).problems
    assert part.cases[0].drawings == ()
    assert part.cases[0].facts[0][0] == "input"


def test_long_histories_are_cut_and_say_so(path):
    (run,) = kept(path, [outcome(verdict=Verdict.AC, ratio=2.0)])
    many = [replace(run, id=place + 1) for place in range(MOST_RUNS + 40)]
    (part,) = page_of(many).problems
    assert len(part.runs) + len(part.earlier) == MOST_RUNS
    assert part.more == 40
    assert part.plot is not None
    assert len(part.plot.dots) == MOST
    assert part.plot.left_out == MOST_RUNS + 40 - MOST
    html = html_of(many, sources={"count": b"#" * 100_000})
    assert "(the rest is left out)" in html
    assert len(html) < 1_000_000
    check_html(html)


def test_a_report_is_known_by_its_head(path):
    page = html_of(kept(path, [outcome()])).encode()
    assert is_report(page[:2000])
    assert not is_report(b"<!doctype html><title>mine</title>")
    assert not is_report(b"")

"""The page's exact arithmetic, as Chromium runs it, against the Python reference on thousands of cases."""

from __future__ import annotations

import json
import random
import re
from fractions import Fraction
from html import unescape
from pathlib import Path

import pytest
from chromium import CHROMIUM, dom

import judge.topics.circles.explore as explore
from judge.data.load import load_data
from judge.exact.surd import Surd
from judge.problem.find import find_problem
from judge.topics.circles import Bands, CircleLine

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(CHROMIUM is None, reason="there is no Chromium (apt-get install chromium)"),
]

DIGITS = 24
SCRIPT = Path(explore.__file__).with_name("exact.js")
PAGE = """<!doctype html><meta charset="utf-8"><pre id="told"></pre><script>SCRIPT
const bands = {snap: [1n, 10n ** 12n], clear: [1n, 10n ** 7n]};
const none = {snap: [0n, 1n], clear: [0n, 1n]};
const told = CASES.map(([kind, exact, texts]) => Exact.analyse(texts, kind, exact ? none : bands));
document.getElementById("told").textContent = JSON.stringify(told);
</script></html>"""
PROBLEMS = {"count": "line", "segment": "segment", "ray-nearest": "ray", "exact-count": "line"}
EACH = 500


def flat(case):
    """The seven numbers of a case as Python writes them."""
    return [repr(number) for value in case for number in (value if isinstance(value, tuple) else (value,))]


def moved(case, chance):
    """A case in which a number is off by so little that a band or the promise may notice."""
    numbers = [number for value in case for number in (value if isinstance(value, tuple) else (value,))]
    place = chance.randrange(7)
    size = max(map(abs, numbers)) or 1
    numbers[place] = float(numbers[place]) + size * 10.0 ** chance.uniform(-17, -5) * chance.choice((-1, 1))
    numbers[2] = abs(numbers[2])
    cx, cy, r, ax, ay, bx, by = numbers
    return cx, cy, r, (ax, ay), (bx, by)


def cases():
    """(kind, whether there are no bands, case): of the data, and each once more a little off."""
    chance = random.Random(20261122)
    for name, kind in PROBLEMS.items():
        data = load_data(find_problem(name))
        every = [case for group in data.groups for case in group.cases]
        for case in chance.sample(every, EACH):
            yield kind, name == "exact-count", case
            if name != "exact-count":
                yield kind, False, moved(case, chance)


def wanted(kind, exact, case):
    """What the page must say."""
    build = CircleLine.ray if kind == "ray" else CircleLine.through
    line = build(*case)
    bands = Bands(Fraction(0), Fraction(0)) if exact else Bands(Fraction(1, 10**12), Fraction(1, 10**7))
    found = bands.meets(line)
    kept, least, broken = found, None, bands.broken_count(line)
    if kind == "segment":
        kept, broken = bands.segment(line), bands.broken_segment(line)
    elif kind == "ray":
        least, broken = bands.ray(line), bands.broken_ray(line)
    unit = 1 << line.shift

    def text(x):
        return Surd.of(x).decimal(DIGITS)

    told = {
        "count": bands.count(line),
        "broken": broken is not None,
        "delta": text(Fraction(line.delta, unit**4)),
        "extent": text(Fraction(line.extent, unit)),
        "all": [[which, text(line.root(which)), [text(x) for x in line.point(which)]] for which in found],
        "least": None if least is None else text(least),
        "kept": None if kind == "ray" else list(kept),
    }
    if not line.degenerate:
        told["foot"] = [text(line.root(0)), [text(x) for x in line.point(0)]]
        told["distance"] = text(Surd(0, abs(line.k), line.a, line.a * unit))
        told["half"] = text(Surd(0, 1, line.delta * line.a, line.a * unit)) if line.delta >= 0 else None
    return told


def said(kind, found):
    """The page's answer in the same form."""
    told = {
        "count": found["count"],
        "broken": found["broken"] is not None,
        "delta": found["delta"],
        "extent": found["extent"],
        "all": [[each["which"], each["t"], each["point"]] for each in found["all"]],
        "least": found.get("least"),
        "kept": None if kind == "ray" else found["kept"],
    }
    if not found["lone"]:
        told["foot"] = [found["foot"]["t"], found["foot"]["point"]]
        told["distance"], told["half"] = found["distance"], found["half"]
    return told


def in_the_browser(tmp_path, asked):
    page = tmp_path / "exact.html"
    plain = json.dumps([[kind, exact, flat(case)] for kind, exact, case in asked])
    text = PAGE.replace("SCRIPT", SCRIPT.read_text(encoding="utf-8"), 1).replace("CASES", plain, 1)
    page.write_text(text, encoding="utf-8")
    (found,) = re.findall(r'<pre id="told">(.*?)</pre>', dom(page), re.DOTALL)
    return json.loads(unescape(found))


def test_it_answers_as_the_reference_does(tmp_path):
    asked = list(cases())
    assert len(asked) >= 3_500
    found = in_the_browser(tmp_path, asked)
    assert len(found) == len(asked)
    differing = []
    broken = 0
    for (kind, exact, case), each in zip(asked, found, strict=True):
        right = wanted(kind, exact, case)
        broken += right["broken"]
        if said(kind, each) != right:
            differing.append((kind, case, said(kind, each), right))
    assert differing[:3] == []
    assert broken > 100  # or the edges of the promise were not asked for

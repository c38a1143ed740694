"""The site in a real browser: from the first visit to an accepted program, hostile ones, no network."""

from __future__ import annotations

import json
import re
import shutil
import threading
import time
from contextlib import ExitStack, contextmanager
from datetime import datetime
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer

import pytest
from chromium import CHROMIUM
from devtools import NAMED, chromium
from marionette import FIREFOX, firefox

from judge.errors import JudgeError
from judge.problem.find import find_problem
from judge.site.build import Site
from judge.site.fetch import parts

pytestmark = [pytest.mark.slow, pytest.mark.timeout(400)]
IN_CHROMIUM = pytest.param(
    chromium, id="chromium", marks=pytest.mark.skipif(CHROMIUM is None, reason="Chromium is not installed")
)
IN_FIREFOX = pytest.param(
    firefox,
    id="firefox",
    marks=[
        pytest.mark.nightly,
        pytest.mark.skipif(FIREFOX is None, reason="Firefox is not installed"),
    ],
)

RIGHT = """
def which_side(A, B, P):
    cross = (B[0] - A[0]) * (P[1] - A[1]) - (B[1] - A[1]) * (P[0] - A[0])
    return (cross > 0) - (cross < 0)
"""
WRONG = RIGHT.replace(" - (B[1]", " + (B[1]")
LOOP = "def which_side(A, B, P):\n    while True:\n        pass\n"
STUCK = "def which_side(A, B, P):\n    return 10 ** 10 ** 9\n"
HOSTILE = """
found = []
def tried(name, attempt):
    try:
        value = attempt()
        found.append(f"{name}: {'there' if value is not None else 'gone'}")
    except BaseException as fault:
        found.append(f"{name}: {type(fault).__name__}")
import js
HERE, THERE = "HERE", "THERE"
for name in ("fetch", "XMLHttpRequest", "WebSocket", "EventSource", "WebTransport", "importScripts", "Worker",
             "SharedWorker", "BroadcastChannel", "indexedDB", "caches", "postMessage", "navigator",
             "RTCPeerConnection"):
    tried(name, lambda: getattr(js, name, None))
def via_pyodide(address):
    from pyodide.http import open_url
    return open_url(address)
def via_urllib(address):
    import urllib.request
    return urllib.request.urlopen(address, timeout=2).read()
def via_package(address):
    import pyodide_js
    return pyodide_js.loadPackage(address)
def via_import(address):
    from pyodide.code import run_js
    return run_js(f"import('{address}')")
def via_function(address):
    return js.Function.new(f"return fetch('{address}')")()
def via_prototype(address):
    return js.Object.getPrototypeOf(js.Object.getPrototypeOf(js.self)).fetch(address)
def via_emscripten(address):
    import pyodide_js
    return pyodide_js._module.fetch(address)
for way in (via_pyodide, via_urllib, via_package, via_import, via_function, via_prototype, via_emscripten):
    for address in (f"{THERE}/leak", f"{HERE}/leak"):
        tried(f"{way.__name__} {address[-10:]}", lambda: way(address))
def which_side(A, B, P):
    raise ValueError("; ".join(found))
"""


class Counting(SimpleHTTPRequestHandler):
    """Serves a folder, or nothing; the server's `asked` are the addresses."""

    def do_GET(self):
        self.server.asked.append(self.path)
        if self.server.folder is None:
            self.send_error(404)
        else:
            super().do_GET()

    def log_message(self, *_):
        pass


@contextmanager
def served(folder):
    handler = partial(Counting, directory=str(folder)) if folder else Counting
    server = ThreadingHTTPServer(("127.0.0.1", 0), handler)
    server.asked, server.folder = [], folder
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        yield server, f"http://127.0.0.1:{server.server_address[1]}"
    finally:
        server.shutdown()
        server.server_close()


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    """The site of two katas."""
    out = tmp_path_factory.mktemp("site")
    try:
        brought = parts(None)
    except JudgeError as fault:
        pytest.skip(f"what a site needs cannot be fetched here: {fault}")
    problems = [find_problem("which-side"), find_problem("distance-squared")]
    assert [*Site(out, problems, [], brought).build()][-1] == "quiz.json"
    return out


def judged(tab, source):
    """What the page says of a program, from Run to the last word."""
    tab.until("document.querySelector('.ace_editor') !== null")
    tab.ask(f"ace.edit(document.querySelector('.ace_editor')).setValue({json.dumps(source)}, -1)")
    tab.ask("document.querySelector('#run').click()")
    tab.until("document.querySelector('#run').disabled === false")
    return tab.ask("document.querySelector('#result').textContent")


READY = "document.querySelector('#state').className === 'ready'"


@pytest.mark.parametrize("page", [IN_CHROMIUM, IN_FIREFOX])
def test_a_kata_from_the_first_visit_to_the_next_kata_without_a_network(page, site, tmp_path):
    with ExitStack() as servers, page(tmp_path / "profile") as tab:
        here, address = servers.enter_context(served(site))
        there, elsewhere = servers.enter_context(served(None))
        tab.go(f"{address}/#which-side")
        tab.until(READY)
        assert "Not written yet" in judged(tab, "def which_side(A, B, P):\n    raise NotImplementedError\n")
        said = judged(tab, WRONG)
        assert "Wrong answer" in said
        assert "Smallest failing case" in said
        assert tab.until("document.querySelector('.case img')?.naturalWidth > 0")
        assert "expected ':'" in judged(tab, RIGHT.replace("P):", "P)"))
        assert "Time limit exceededStopped after" in judged(tab, LOOP)
        assert tab.ask(READY)  # the worker is the same
        hostile = judged(tab, HOSTILE.replace('"HERE"', f'"{address}"').replace('"THERE"', f'"{elsewhere}"'))
        assert "ValueError" in hostile
        assert re.findall(r"(\w+): there", hostile.partition("via_")[0]) == []
        time.sleep(1)  # for promises
        assert there.asked == []
        assert [each for each in here.asked if "leak" in each] == []
        tab.ask("document.querySelectorAll('.work button')[2].click()")
        assert tab.ask("document.querySelectorAll('.hint').length") == 1
        assert "Accepted" in judged(tab, RIGHT)
        assert "The model solution" in tab.ask("document.querySelector('.work').textContent")
        assert not tab.faults
        assert all(each.startswith((address, "blob:", "data:")) for each in tab.addresses)

        for name in ("pyodide/pyodide.asm.wasm", "kata/distance-squared.zip"):  # the next kata too
            tab.until(f"caches.match('{name}').then(found => found !== undefined)")
        servers.close()  # and now nobody serves it
        tab.go(f"{address}/?later#")
        assert tab.until("document.querySelectorAll('.mark.done').length") == 1
        tab.go(f"{address}/?later#distance-squared")
        tab.until(READY)
        assert "Wrong answer" in judged(tab, "def distance_squared(P, Q):\n    return 1\n")


@pytest.mark.parametrize("page", [IN_CHROMIUM, IN_FIREFOX])
def test_by_plain_http_and_stopped_by_the_person(page, site, tmp_path):
    with served(site) as (_, address), page(tmp_path / "profile") as tab:
        tab.go(f"{address.replace('127.0.0.1', NAMED)}/#which-side")
        tab.until(READY)
        assert tab.ask("isSecureContext") is False
        assert "Wrong answer" in judged(tab, WRONG)
        tab.ask("document.querySelector('#run').click()")
        tab.ask("document.querySelector('#run').nextSibling.click()")
        assert tab.ask("document.querySelector('#result').textContent") == "Stopped."
        assert tab.ask("JSON.parse(localStorage['judge.progress.1']).katas['which-side'].tries") == 1
        tab.until(READY)
        assert "Accepted" in judged(tab, RIGHT)
        assert not tab.faults


CARDS = [
    {"number": {"answer": "2/3", "within": 0.01, "unit": "m"}, "typed": "a number", "answer": "2/3 m"},
    {"options": [{"text": each, "right": each == "1", "why": ""} for each in ("0", "1", "2", "none")]},
]
CARD = {
    "key": "a",
    "sets": ["first-steps"],
    "front": "?",
    "given": [],
    "svg": "",
    "drawn": "",
    "why": "",
}
CARD |= {"options": [], "number": None, "typed": "", "answer": ""}


@pytest.mark.parametrize("page", [IN_CHROMIUM, IN_FIREFOX])
def test_a_path_progress_and_cards_with_the_terminals_history(page, site, tmp_path):
    out = shutil.copytree(site, tmp_path / "out")
    (out / "quiz.json").write_text(json.dumps([CARD | each for each in CARDS]))
    solved = {"stars": 0, "tries": 3, "hints": 1, "solved": "2026-03-02T09:00:00Z"}
    mine = {"katas": {"which-side": solved}, "days": [f"{datetime.now():%Y-%m-%d}"], "skills": []}
    (out / "mine.json").write_text(json.dumps(mine))
    with served(out) as (here, address), page(tmp_path / "profile") as tab:
        tab.go(address)
        tab.until("document.querySelectorAll('.tile').length > 1")
        assert tab.ask("document.querySelector('.tile.solved').hash") == "#which-side"
        assert tab.ask("document.querySelector('.tile.here').hash") == "#distance-squared"
        assert tab.until("[...document.querySelectorAll('.tile img')].every(each => each.naturalWidth > 0)")
        tab.go(f"{address}/#progress")
        tab.until("document.querySelector('.curve img')?.naturalWidth > 0")
        told = tab.ask("[...document.querySelectorAll('.figures dd')].map(each => each.textContent).join()")
        assert told.startswith("1 of 2,0 of 0,0 of ")
        assert told.endswith(",1 of 7")
        assert "3 runs1 hint2026-03-0" in tab.ask("document.querySelector('td').parentNode.textContent")
        tab.go(f"{address}/#quiz")
        tab.until("document.querySelector('.answer')")
        for typed in ("two", "0.66 m"):
            tab.ask(f"document.querySelector('.answer input').value = '{typed}'")
            tab.ask("document.querySelector('.answer button').click()")
        assert "Right." in tab.ask("document.querySelector('.quiz').textContent")
        tab.ask("document.querySelector('.card > div:last-child .main').click()")
        tab.until("document.querySelectorAll('.options button').length === 4")
        tab.ask("document.querySelectorAll('.options button')[1].click()")
        assert tab.ask("document.querySelectorAll('.options .wrong').length") == 0
        assert tab.ask("fetch('explore/').then(found => found.text())").count('class="tile"') == 2
        assert not tab.faults
        assert all((out / each.lstrip("/").partition("?")[0]).exists() for each in here.asked)


@pytest.mark.parametrize("page", [IN_CHROMIUM, IN_FIREFOX])
def test_another_site_at_the_same_address_is_shown_at_once(page, site, tmp_path):
    out = shutil.copytree(site, tmp_path / "out")
    with served(out) as (_, address), page(tmp_path / "profile") as tab:
        tab.go(address)
        tab.until("navigator.serviceWorker.controller !== null")
        for name, old, new in (
            ("index.html", "Nothing you type", "Another site"),
            ("sw.js", "judge-", "judge-2"),
        ):
            text = (out / name).read_text(encoding="utf-8")
            (out / name).write_text(text.replace(old, new, 1), encoding="utf-8")
        tab.go(f"{address}/?again")
        tab.until("(document.body?.textContent ?? '').includes('Another site')")
        assert not tab.faults


@pytest.mark.nightly
@pytest.mark.parametrize("page", [IN_CHROMIUM, IN_FIREFOX])
def test_what_is_stuck_inside_one_call_costs_the_worker_and_no_more(page, site, tmp_path):
    with served(site) as (_, address), page(tmp_path / "profile") as tab:
        tab.go(f"{address}/#which-side")
        tab.until(READY)
        assert "one call did not end" in judged(tab, STUCK)
        tab.until(READY)
        assert "Accepted" in judged(tab, RIGHT)

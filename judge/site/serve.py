"""A site on this machine alone: it is served at once, and its pieces are made when they are asked for.

Each request has a thread; the pieces are made by whoever calls `SiteServer.build`, one at a time.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterable
from contextlib import suppress
from http import HTTPStatus
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from io import BytesIO
from queue import Empty, SimpleQueue
from threading import Event, Thread
from typing import Any, BinaryIO
from urllib.parse import unquote, urlsplit

import msgspec

from judge.errors import UsageError, told
from judge.practice.history import History
from judge.practice.progress import State, levels_passed, skills, solved, tried
from judge.practice.syllabus import Skill
from judge.problem import Problem
from judge.report.screen import note
from judge.site.build import EXPLORE, Site, Stage

PORTS = range(8731, 8741)  # the first that is free: a browser keeps progress by the address


class SiteServer(ThreadingHTTPServer):
    """Serves a site, and as mine.json what `mine` gives, while its context lasts; `asked` for are pieces.

    Raises UsageError where all `PORTS` are taken.
    """

    daemon_threads = True

    def __init__(self, site: Site, mine: Callable[[], bytes]) -> None:
        self.site, self.mine = site, mine
        self.asked: SimpleQueue[str] = SimpleQueue()
        self._over = {name: Event() for name in site.missing}
        for port in PORTS:
            try:
                super().__init__(("127.0.0.1", port), _Handler)
                return
            except OSError as fault:
                why = (fault.strerror or str(fault)).lower()
        what = f"no port of {PORTS[0]} to {PORTS[-1]} can be used: {why}"
        raise UsageError(what, remedy="end what uses one, or put the site on a web server")

    def __enter__(self) -> SiteServer:
        Thread(target=self.serve_forever, daemon=True).start()
        return self

    def __exit__(self, *_: object) -> None:
        self.shutdown()
        self.server_close()

    @property
    def address(self) -> str:
        """Where it is served."""
        return f"http://127.0.0.1:{self.server_port}/"

    def build(self, stage: Stage | None) -> None:
        """Make all that is missing, first what is asked for. Raises OSError."""
        for name in self.site.build(stage, self._next):
            self._over[name].set()

    def _next(self) -> str:
        with suppress(Empty):
            while (name := self.asked.get_nowait()) not in self.site.missing:
                pass
            return name
        return ""

    def wait_for(self, name: str) -> None:
        """Wait for a file that is a piece, or comes with one, until it is made or cannot be."""
        folder, _, file = name.partition("/")
        if folder == "explore" and name != EXPLORE:
            name = f"kata/{file.removesuffix('.html')}.json"
        if (over := self._over.get(name)) and not over.is_set():
            if name != EXPLORE:  # which comes after all that it lists
                self.asked.put(name)
            over.wait()

    def handle_error(self, *_: Any) -> None:
        """Nothing where the client has left; any other fault in a line."""
        fault = sys.exception()
        if isinstance(fault, Exception) and not isinstance(fault, ConnectionError | TimeoutError):
            note(f"a request was not answered: {told(fault)}")


class _Handler(SimpleHTTPRequestHandler):
    server: SiteServer

    def __init__(self, *args: Any) -> None:
        super().__init__(*args, directory=str(args[2].site.out))

    def send_head(self) -> BytesIO | BinaryIO | None:
        """The answer's head, and what follows it."""
        port = self.server.server_port
        if self.headers.get("Host") not in (f"127.0.0.1:{port}", f"localhost:{port}"):
            self.send_error(HTTPStatus.FORBIDDEN, "this site is served to this machine alone")
            return None
        name = unquote(urlsplit(self.path).path).lstrip("/")
        name = EXPLORE if name == "explore/" else name
        if name == "mine.json":
            body = self.server.mine()
            self.send_response(HTTPStatus.OK)
            self.send_header("Content-Type", "application/json")
            self.send_header("Content-Length", str(len(body)))
            self.end_headers()
            return BytesIO(body)
        self.server.wait_for(name)
        root, place = map(os.path.realpath, (self.directory, self.translate_path(self.path)))
        if place != root and not place.startswith(root + os.sep):
            self.send_error(HTTPStatus.FORBIDDEN, "this is a link out of the site")
            return None
        return super().send_head()

    def list_directory(self, path: str | os.PathLike[str]) -> None:  # noqa: ARG002 - its name
        """No list of files."""
        self.send_error(HTTPStatus.NOT_FOUND)

    def end_headers(self) -> None:
        """Nothing is kept by the browser but by its own program: another site may be served here tomorrow."""
        self.send_header("Cache-Control", "no-store")
        super().end_headers()

    def log_message(self, *_: Any) -> None:
        """Nothing: a person watches the page."""


def own_history(history: History, problems: Iterable[Problem], named: Iterable[Skill]) -> bytes:
    """A person's runs as mine.json has them, by kata and by day, and the skills shown. Raises StoreError."""
    problems, runs = list(problems), history.runs()
    own, done = tried(runs), solved(runs)
    katas = {
        each.id: {
            "stars": len(levels_passed(each, own[each.id])),
            "tries": len(own[each.id]),
            "hints": history.hints_seen(each.id),
            "solved": done.get(each.id, ""),
        }
        for each in problems
        if each.id in own
    }
    days = sorted({run.when.astimezone().date() for of_kata in own.values() for run in of_kata})
    shown = [each.name for each in skills(problems, own, named) if each.state is State.SHOWN]
    return msgspec.json.encode({"katas": katas, "days": days, "skills": shown})

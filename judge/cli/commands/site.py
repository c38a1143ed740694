"""`judge site`: practise in a browser tab; a folder that any web server can hold."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import click
from msgspec import Struct

from judge.cli.files import writing
from judge.cli.options import Common, command, opt
from judge.errors import UsageError
from judge.files import cache_folder
from judge.problem.find import find_problem, sound_problems
from judge.report.published_setter import SiteBuilt
from judge.report.screen import note
from judge.report.wait import stages
from judge.site.build import build, check_folder
from judge.site.fetch import parts


class SiteAsk(Struct, frozen=True):
    """Where the site is written, and what becomes of it."""

    out: Path | None = opt("--out DIR", "Write the site into this folder; into one of the cache without it.")
    pyodide: str | None = opt("--pyodide DIR|URL", "Take Pyodide from here, not from the npm registry.")
    opened: bool = opt("--open", "Serve it on this machine and open it in the browser, until Ctrl-C.")


@command("site", SiteBuilt, ask=SiteAsk)
@click.argument("names", metavar="[KATA...]", nargs=-1)
def site(names: tuple[str, ...], ask: SiteAsk, common: Common) -> Iterator[SiteBuilt]:
    """Write a site on which the katas are practised in a browser tab.

    Without a KATA: all of them. Any web server can hold the folder. Python runs in the page, and nothing that
    is typed there is sent anywhere. A second build makes only what has changed.
    """
    out = ask.out or cache_folder() / "site" / "out"
    with writing(out, "name another folder with --out"):
        check_folder(out)
    problems = [find_problem(name, common.problems) for name in dict.fromkeys(names)]
    if not names:
        problems, faults = sound_problems(common.problems)
        for fault in faults:
            note(f"a kata is left out: {fault}")
    with stages("fetching") as advance:
        brought = parts(ask.pyodide, advance)
    with stages("building") as advance, writing(out, "name another folder with --out"):
        built = build(out, problems, common.problems, brought, advance, opened=ask.opened)
    yield built
    if ask.opened:
        _serve(out)


def _serve(folder: Path) -> None:
    """Serve the folder on loopback until Ctrl-C, and open it."""
    from functools import partial
    from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer

    class Quiet(SimpleHTTPRequestHandler):
        def log_message(self, *_: object) -> None:
            """Nothing: a person watches the page."""

    try:
        server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=str(folder)))
    except OSError as fault:
        raise UsageError(
            f"it cannot be served here: {fault.strerror}", remedy="put it on a web server"
        ) from None
    address = f"http://127.0.0.1:{server.server_address[1]}/"
    note(f"{address} until you press Ctrl-C")
    click.launch(address)
    with server:
        server.serve_forever()

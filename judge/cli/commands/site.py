"""`judge site`: practise in a browser tab; a folder that any web server can hold."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from threading import Event

import click
from msgspec import Struct

from judge.cli.files import opened_in_browser, writing
from judge.cli.options import Common, command, opt
from judge.cli.resolve import history_at
from judge.errors import StoreError
from judge.files import cache_folder
from judge.practice.syllabus import read_checklist
from judge.problem.find import find_problem, sound_problems
from judge.report.published_setter import SiteBuilt
from judge.report.screen import note
from judge.report.wait import stages
from judge.site.build import Site, check_folder
from judge.site.fetch import parts
from judge.site.serve import PORTS, SiteServer, own_history


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
    is typed there is sent anywhere. A second build makes only what has changed. With --open the page is there
    at once; katas are built when you open them, and the rest meanwhile.
    """
    out = ask.out or cache_folder() / "site" / "out"
    with writing(out, "name another folder with --out"):
        check_folder(out)
    problems = [find_problem(name, common.problems) for name in dict.fromkeys(names)]
    if not names:
        problems, faults = sound_problems(common.problems)
        for fault in faults:
            note(f"a kata is left out: {fault}")
    with stages("MB: fetching Python and the editor for the browser, once") as advance:
        in_megabytes = (lambda _, done, size: advance("", done >> 20, size >> 20)) if advance else None
        brought = parts(ask.pyodide, in_megabytes)
    with writing(out, "name another folder with --out"):
        made = Site(out, problems, common.problems, brought)
        if ask.opened:
            yield from _served(made, common)
            return
        with stages("building") as advance:
            for _ in made.build(advance):
                pass
    if made.faults:
        raise made.faults[0]
    yield made.built(opened=False)


def _served(made: Site, common: Common) -> Iterator[SiteBuilt]:
    """Serve the site on this machine until Ctrl-C; what it holds is told once all of it is made."""
    skills = read_checklist(common.problems).skills

    def mine() -> bytes:
        try:
            with history_at(common.db, reading=True) as history:
                return own_history(history, made.problems, skills)
        except StoreError as fault:
            note(f"your runs in the terminal are not shown: {fault}")
            return b"{}"

    with SiteServer(made, mine) as server:
        note(f"{server.address}  open until Ctrl-C")
        if server.server_port != PORTS[0]:
            note(f"Your progress of port {PORTS[0]} is not seen here.")
        if not opened_in_browser(server.address):
            note("No browser here. Open the address above.")
        with stages("building") as advance:
            server.build(advance)
        for fault in made.faults:
            note(f"left out: {fault}", bad=True)
        yield made.built(opened=True)
        Event().wait()

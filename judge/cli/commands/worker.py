"""`judge worker`: a machine that judges for others, the place where they meet, and the keys to it."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from judge.cli.judging_options import isolation_option
from judge.cli.options import json_option, problems_option, write_json
from judge.cluster.where import HERE, Address
from judge.errors import ExitCode, UsageError
from judge.report.layout import Span, Style, line
from judge.report.names import shown_name
from judge.report.screen import note, out
from judge.report.values import counted

if TYPE_CHECKING:
    from judge.cluster.greeting import Offer
    from judge.cluster.keys import Keys
    from judge.cluster.serve import Plan

SCHEMA = 1
_STANDARD_INPUT = "-"


@click.command("worker")
@click.argument("address", metavar="[ADDRESS]", default=HERE)
@click.option(
    "--scheduler", is_flag=True, help="Be the scheduler, at ADDRESS, that workers and classes go to."
)
@click.option(
    "-j",
    "--jobs",
    type=click.IntRange(0, 256),
    metavar="N",
    help="Judge so many submissions at once; a worker one for each core, a scheduler none.",
)
@click.option(
    "--new-keys", metavar="DIR", type=click.Path(path_type=Path), help="Make keys in a new folder; no more."
)
@click.option(
    "--keys", metavar="DIR", help="The folder of keys, instead of $JUDGE_KEYS or the one in your data folder."
)
@click.option(
    "--problem",
    "names",
    metavar="PROBLEM",
    multiple=True,
    help="Prepare it first; may be given again.",
)
@isolation_option
@json_option
@problems_option
def command(
    address: str,
    scheduler: bool,
    jobs: int | None,
    new_keys: Path | None,
    keys: str | None,
    names: tuple[str, ...],
    level: str | None,
    as_json: bool,
    folders: tuple[Path, ...],
) -> ExitCode:
    """Judge for others: a machine of a cluster, its scheduler, its keys.

    Whoever runs `judge class FOLDER --on ADDRESS` has their submissions judged by its workers.

    ADDRESS is the scheduler's: tls://HOST:PORT, or tcp://127.0.0.1:PORT on one machine. One of the machines
    is the scheduler, and they all hold a copy of its keys. Whoever holds the keys can run any program on
    every machine of the cluster, and nobody else can reach it.

    \b
      judge worker --new-keys keys      once; copy the folder to each machine
      judge worker --scheduler tls://0.0.0.0:8786 --keys keys   on machine A
      judge worker tls://A:8786 --keys keys                     on the others
      judge class homework --on tls://A:8786 --keys keys        anywhere

    With -j N the scheduler's machine judges too.

    A worker judges at isolation full or strong. One on a machine that has only limits does not start, unless
    you ask for --isolation limits. It ends with Ctrl-C, and ten minutes after its scheduler.

    Exit status: 0 ended as it should, 2 usage, 3 no scheduler, 130 interrupted.
    """
    if new_keys is not None:
        return _make_keys(new_keys, as_json=as_json)
    place = Address.of(address)
    count = jobs if jobs is not None else 0 if scheduler else _cores()
    if not count and not scheduler:
        raise UsageError("a worker of no submissions does nothing", remedy="use a larger -j, or --scheduler")
    from judge.cluster.need import distributed
    from judge.cluster.reach import check_reached
    from judge.cluster.serve import Plan, serve

    distributed()
    if not scheduler:
        check_reached(place)
    held = _keys(place, keys)
    plan = Plan(
        place,
        scheduler,
        count,
        _prepared(names, level, folders) if count else None,
        held,
        _environment(folders),
        attended=keys == _STANDARD_INPUT,
    )
    interrupted = serve(plan, lambda found: _tell(plan, found, as_json=as_json), note)
    return ExitCode.INTERRUPTED if interrupted else ExitCode.ACCEPTED


def _make_keys(folder: Path, *, as_json: bool) -> ExitCode:
    from judge.cluster.keys import FILES, new_keys

    new_keys().write(folder)
    if as_json:
        write_json({"schema": SCHEMA, "keys": str(folder), "files": list(FILES)})
    else:
        about = f"  {', '.join(FILES)}: copy the folder to each machine of the cluster, and to nobody else"
        out().show([line(Span(shown_name(str(folder)), Style.STRONG), about)])
    return ExitCode.ACCEPTED


def _cores() -> int:
    """The cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _keys(place: Address, named: str | None) -> Keys | None:
    """The keys, where the address asks for some."""
    from judge.cluster.keys import of_lines, read_keys

    if named == _STANDARD_INPUT:
        return of_lines(iter(sys.stdin.buffer.readline, b""))
    return read_keys(Path(named) if named else None) if place.safe else None


def _prepared(names: tuple[str, ...], level: str | None, folders: tuple[Path, ...]) -> Offer:
    """What this machine offers, the problems that are named being ready."""
    from judge.cluster.station import offer_here, warm
    from judge.problem.find import find_problem, sound_problems
    from judge.report.progress import progress

    wanted = [find_problem(name, folders) for name in names]
    problems, faults = sound_problems(folders)
    for fault in faults:
        note(str(fault))
    offer = offer_here(problems, level)
    for each in wanted:
        with progress(f"preparing {each.id}"):
            failed = warm(each, offer.levels[0], folders)
        if failed:
            note(f"{each.id} is not prepared: {failed}")
    return offer


def _environment(folders: tuple[Path, ...]) -> dict[str, str]:
    """Where the workers find the problems that were found here."""
    if not folders:
        return {}
    places = [str(folder.resolve()) for folder in folders]
    return {"JUDGE_PROBLEMS": os.pathsep.join([*places, *filter(None, [os.environ.get("JUDGE_PROBLEMS")])])}


def _tell(plan: Plan, address: str, *, as_json: bool) -> None:
    """Say that it is ready, and at which address."""
    offer = plan.offer
    told = {
        "schema": SCHEMA,
        "address": address,
        "scheduler": plan.scheduler,
        "workers": plan.slots,
        "keys": plan.keys is not None,
        "isolation": list(offer.levels) if offer else [],
        "problems": len(offer.problems) if offer else 0,
    }
    if as_json:
        write_json(told)
    else:
        _show(told)


def _show(told: dict[str, Any]) -> None:
    parts = ["scheduler"] if told["scheduler"] else []
    if told["workers"]:
        parts += [
            counted(told["workers"], "worker"),
            f"isolation {' or '.join(told['isolation'])}",
            counted(told["problems"], "problem"),
        ]
    address = told["address"]
    lines = [line(Span(address, Style.STRONG), f"  {', '.join(parts)}")]
    if told["scheduler"]:
        keys = " --keys DIR" if told["keys"] else ""
        lines.append(line(Span(f"  judge worker {address}{keys}", Style.FAINT)))
        lines.append(line(Span(f"  judge class FOLDER --on {address}{keys}", Style.FAINT)))
    out().show(lines)

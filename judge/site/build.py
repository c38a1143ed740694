"""`judge site`: everything that the page needs, as files of one folder that any web server can hold.

index.html style.css app.js python.js sw.js icon.svg    the page (judge/site/page)
katas.json quiz.json                                    what there is, and the cards
kata/<id>.json <id>.svg <id>.zip                        a kata: its texts, its figure, what judging it needs
explore/<id>.html                                       the page on which its cases are dragged
judge.zip                                               this package's modules that a tab needs
pyodide/ wheels/ ace/                                   Python and the editor (judge.site.fetch)
site.json                                               what each kata was made from, for the next build
"""

from __future__ import annotations

import json
import shutil
import zipfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import nullcontext, suppress
from pathlib import Path
from typing import Any, TypeVar

import msgspec

from judge.cache import DISK, code_key, digest
from judge.data.load import load_data
from judge.drawing.svg import panel_svg
from judge.errors import JudgeError, UsageError
from judge.files import replace_file
from judge.mistakes.namer import Namer
from judge.practice.cards import Card, read_decks
from judge.practice.questions import Question, Sources, ask
from judge.practice.syllabus import USUAL, sound_sets
from judge.problem import Problem
from judge.problem.module import load_module
from judge.report.published_setter import SiteBuilt
from judge.run.settings import Settings
from judge.site.texts import kata_page
from judge.version import __version__

T = TypeVar("T")
Stage = Callable[[str, int, int], None]  # what is at work, katas done, katas in all
PAGE = Path(__file__).parent / "page"
MARK = b'name="generator" content="judge site"'
_PACKAGE = Path(__file__).parent.parent
_IN_A_TAB = (  # of this package; the rest is for processes, terminals and machines
    *("__init__.py", "cache.py", "errors.py", "files.py", "version.py"),
    *("exact", "values", "drawing", "problem", "data", "geometry", "sandbox", "languages", "run", "diagnose"),
    *("repair", "mistakes", "judging", "report", "site"),
)
_LEFT_OUT = {"drivers", "html", "page", "__pycache__"}
_SEED = 1  # of what is left to chance in cards


class _Keeping:
    """The judge's cache; every value that is asked for or written stays known as JSON, by its folder."""

    def __init__(self) -> None:
        self.found: dict[str, bytes] = {}

    def read(self, name: str, key: str, kind: type[T]) -> T | None:
        value, body = DISK.read(name, key, kind), DISK.read(name, key, bytes)
        if value is not None and body is not None:
            self.found[name.partition("/")[0]] = body
        return value

    def write(self, name: str, key: str, value: Any, what: str = "test data") -> str | None:
        body = json.dumps(value, separators=(",", ":")).encode()
        self.found[name.partition("/")[0]] = body
        return DISK.write(name, key, body, what)


def check_folder(out: Path) -> None:
    """Raise UsageError where `out` is something else than a site or an empty folder."""
    index, what = out / "index.html", ""
    if out.exists() and not out.is_dir():
        what = "this is not a folder"
    elif out.is_dir() and any(out.iterdir()) and not (index.is_file() and MARK in index.read_bytes()):
        what = "this folder holds something else"
    if what:
        raise UsageError(what, where=str(out), remedy="name a new one with --out")


def build(
    out: Path,
    problems: Sequence[Problem],
    folders: Sequence[Path],
    parts: Path,
    stage: Stage | None = None,
    *,
    opened: bool = False,
) -> SiteBuilt:
    """Write the site; `parts` holds what `judge.site.fetch` brought. What has not changed is left alone.

    `opened` says that it will be looked at now.

    Raises JudgeError.
    """
    before = _before(out)
    for name in ("kata", "explore"):
        (out / name).mkdir(parents=True, exist_ok=True)
    shutil.copytree(PAGE, out, dirs_exist_ok=True, ignore=shutil.ignore_patterns("sw.js"))  # so it is ours
    katas, made, after = [], [], {}
    for done, problem in enumerate(problems):
        if stage:
            stage(problem.id, done, len(problems))
        elsewhere = _elsewhere(problem)
        if not elsewhere:
            after[problem.id] = key = digest(f"{__version__}/{problem.key}/{code_key()}".encode())
            if before.get(problem.id) != key or not (out / "kata" / f"{problem.id}.zip").is_file():
                _write_kata(out, problem)
                made.append(problem.id)
                _write(out / "site.json", before | after)  # whoever stops here goes on from here
        explore = (out / "explore" / f"{problem.id}.html").is_file()
        katas.append(_listed(problem, elsewhere) | {"explore": explore})
    for path in (*(out / "kata").iterdir(), *(out / "explore").iterdir()):
        if path.stem not in after:  # of an earlier build
            path.unlink()
    if stage:
        stage("the page", len(problems), len(problems))
    sets = [
        {
            "name": each.name,
            "title": each.title,
            "about": each.about,
            "katas": [one.id for one in each.problems],
        }
        for each in sound_sets(problems, folders)[0]
        if each.problems and each.name != USUAL
    ]
    shutil.copytree(parts, out, dirs_exist_ok=True)
    _zip(out / "judge.zip", {f"judge/{path.relative_to(_PACKAGE)}": path for path in _modules()})
    _write(out / "katas.json", {"editor": (parts / "ace").is_dir(), "sets": sets, "katas": katas})
    _write(out / "quiz.json", _cards(problems, folders))
    _write(out / "site.json", after)
    _write_worker(out)
    return SiteBuilt(
        str(out),
        tuple(made),
        tuple(name for name in after if name not in made),
        tuple(problem.id for problem in problems if problem.id not in after),
        sum(path.stat().st_size for path in out.rglob("*") if path.is_file()),
        opened,
    )


def _before(out: Path) -> dict[str, str]:
    try:
        return msgspec.json.decode((out / "site.json").read_bytes(), type=dict[str, str])
    except (OSError, msgspec.DecodeError):
        return {}


def _elsewhere(problem: Problem) -> str:
    """Why a kata is not one for a tab; empty where it is."""
    where = f"In the terminal: judge start {problem.id}"
    if problem.growth is not None:
        return f"{where}. It measures how your time grows."
    if problem.time is not None and problem.time.needs:
        return f"{where}. It is timed beside {', '.join(problem.time.needs)}."
    return ""


def _listed(problem: Problem, elsewhere: str) -> dict[str, Any]:
    """The kata as the page lists it; `elsewhere` says why it is not one for a tab."""
    names = ", ".join(parameter.name for parameter in problem.parameters)
    return {
        "id": problem.id,
        "title": problem.title,
        "summary": problem.summary,
        "stub": f"def {problem.entry}({names}):\n    raise NotImplementedError\n",
        "levels": bool(problem.levels),
        "elsewhere": elsewhere,
    }


def _write_kata(out: Path, problem: Problem) -> None:
    """The files of one kata. Raises JudgeError."""
    store, name = _Keeping(), problem.id
    for path in (out / "kata" / f"{name}.svg", out / "explore" / f"{name}.html"):
        path.unlink(missing_ok=True)
    data = load_data(problem, store=store)
    Namer(data, None, Settings(measured=False), nullcontext, store=store).learn()
    problems, solutions = problem.folder.parent, problem.solutions.parent
    files: dict[str, Path | bytes] = {f"{kind}.json": content for kind, content in store.found.items()}
    for root, folder in (("problems", problem.folder), ("solutions", problem.solutions)):
        files |= {f"{root}/{name}/{path.relative_to(folder)}": path for path in _shipped(folder)}
    for path in (*problems.glob("types/*.py"), *problems.glob("skills.toml")):
        files[f"problems/{path.relative_to(problems)}"] = path
    files |= {f"solutions/{path.name}": path for path in solutions.glob("mistakes.toml")}
    _zip(out / "kata" / f"{name}.zip", files)
    _write(out / "kata" / f"{name}.json", kata_page(problem))
    figure = problem.folder / "figure.svg"
    if figure.is_file():
        shutil.copy(figure, out / "kata" / f"{name}.svg")
    hooks = load_module(problem).hooks
    page = hooks.explore(problem, None) if hooks.explore else None
    if page:
        replace_file(out / "explore" / f"{name}.html", page.encode())


def _shipped(folder: Path) -> Iterator[Path]:
    """The files of a kata's folder that a tab needs: no programs in other languages, no slow ones."""
    for path in folder.rglob("*"):
        first, *_ = parts = path.relative_to(folder).parts
        unwanted = first == "slow" or (first in ("accepted", "wrong") and path.suffix != ".py")
        if path.is_file() and not unwanted and "__pycache__" not in parts:
            yield path


def _modules() -> Iterator[Path]:
    """The files of this package that a tab needs."""
    for name in _IN_A_TAB:
        place = _PACKAGE / name
        for path in place.rglob("*") if place.is_dir() else [place]:
            if path.is_file() and not _LEFT_OUT & {*path.relative_to(_PACKAGE).parts}:
                yield path


def _write_worker(out: Path) -> None:
    """The service worker, whose version is the hash of all other files."""
    own = out / "sw.js"
    files = sorted(path for path in out.rglob("*") if path.is_file() and path != own)
    version = digest(*(digest(path.read_bytes()).encode() for path in files))[:16]
    replace_file(own, (PAGE / "sw.js").read_text(encoding="utf-8").replace("{{version}}", version).encode())


def _cards(problems: Sequence[Problem], folders: Sequence[Path]) -> list[dict[str, Any]]:
    """The cards of all sets whose problems are here."""
    sources = Sources(folders, _SEED, lambda _label: nullcontext())
    names: set[str] = {"", *(problem.id for problem in problems)}
    found = []
    for card in read_decks(folders)[0]:
        if card.problem in names:
            with suppress(JudgeError):  # `judge verify` tells of it
                found.append(_card(card, ask(card, sources, "site")))
    return found


def _card(card: Card, asked: Question) -> dict[str, Any]:
    """A card with its answer; of `options` one is right, and the others say why they are not."""
    replies = [(text, asked.check(letter) if asked.check else None) for letter, text in asked.options]
    figure = asked.picture
    return {
        "key": card.key,
        "sets": card.sets,
        "front": card.front,
        "given": asked.given,
        "program": asked.program,
        "svg": panel_svg(figure.whole, "figure", figure.description, alone=True) if figure else "",
        "options": [
            {"text": text, "right": bool(reply and reply.right), "why": reply.why if reply else ""}
            for text, reply in replies
        ],
        "answer": asked.answer,
        "why": asked.why,
    }


def _write(path: Path, value: Any) -> None:
    replace_file(path, msgspec.json.encode(value))


def _zip(path: Path, files: Mapping[str, Path | bytes]) -> None:
    """An archive, the same bytes for the same files."""
    part = path.with_suffix(".part")
    with zipfile.ZipFile(part, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name, file in sorted(files.items()):
            content = file if isinstance(file, bytes) else file.read_bytes()
            archive.writestr(zipfile.ZipInfo(name), content, zipfile.ZIP_DEFLATED)
    part.replace(path)

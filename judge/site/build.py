"""`judge site`: everything that the page needs, as files of one folder that any web server can hold.

index.html style.css app.js python.js sw.js icon.svg    the page (judge/site/page)
katas.json                                              what there is
mine.json                                               a person's own history, where the judge serves it
kata/<id>.svg                                           a statement's figure
judge.zip                                               this package's modules that a tab needs
pyodide/ wheels/ ace/                                   Python and the editor (judge.site.fetch)

The rest are pieces, which are made one by one; site.json says what each was made from, for the next build:

kata/<id>.json                                          its texts, and with it
explore/<id>.html                                       the page on which its cases are dragged
explore/index.html                                      all such pages
kata/<id>.zip                                           what judging it needs
quiz.json                                               the cards
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

from judge import __version__
from judge.cache import DISK, code_key, content_key, digest
from judge.data.load import load_data
from judge.drawing import Picture
from judge.drawing.svg import panel_svg
from judge.errors import JudgeError, UsageError
from judge.files import replace_file
from judge.mistakes.namer import Namer
from judge.practice.cards import NONE, Card, Count, Drawn, Number, read_decks
from judge.practice.questions import Question, ask
from judge.practice.stub import make_stub
from judge.practice.syllabus import USUAL, PracticeSet, read_checklist, read_pack, sound_sets
from judge.problem import Problem
from judge.problem.module import load_module
from judge.report.published_setter import SiteBuilt
from judge.run.settings import Settings
from judge.site.texts import explore_index, has_figure, kata_page

T = TypeVar("T")
Stage = Callable[[str, int, int], None]  # what is at work, katas done, katas in all
PAGE = Path(__file__).parent / "page"
MARK = b'name="generator" content="judge site"'
EXPLORE, QUIZ = "explore/index.html", "quiz.json"
_PACKAGE = Path(__file__).parent.parent
_IN_A_TAB = (  # of this package; the rest is for processes, terminals and machines
    *("__init__.py", "cache.py", "errors.py", "files.py"),
    *("exact", "values", "drawing", "problem", "data", "geometry", "sandbox", "languages", "run", "diagnose"),
    *("repair", "mistakes", "judging", "report", "site"),
)
_LEFT_OUT = {"html", "page", "__pycache__"}  # folders
_UNCALLED = {"driver", "hook"}  # of another language, whatever their ending
_BROUGHT = ("pyodide", "wheels", "ace")
_COUNTS = ("0", "1", "2")  # of things, to choose from
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


class Site:
    """A site in the folder `out`, whose page is written at once; `missing` pieces are not yet made.

    `parts` holds what `judge.site.fetch` brought. What has not changed is left alone.
    """

    def __init__(self, out: Path, problems: Sequence[Problem], folders: Sequence[Path], parts: Path) -> None:
        self.out, self.problems = out, problems
        self._folders = folders
        self._here = {each.id: each for each in problems if not _elsewhere(each)}
        for name in ("kata", "explore"):
            (out / name).mkdir(parents=True, exist_ok=True)
        made_here = shutil.ignore_patterns("sw.js", "explore")
        shutil.copytree(PAGE, out, dirs_exist_ok=True, ignore=made_here)  # first, so that it is ours
        self._keys, self._before = self._pieces(), _before(out)
        self.missing = [
            name
            for name, key in self._keys.items()
            if self._before.get(name) != key or not (out / name).is_file()
        ]
        self._made = {Path(name).stem for name in self.missing if name.endswith(".zip")}
        self.faults: list[JudgeError] = []
        self._write_page(parts)

    def _pieces(self) -> dict[str, str]:
        """Each piece with the key of what it is made from: the texts first, then the katas by their path."""
        code = f"{__version__}/{code_key()}/"
        keys = {
            name: digest(code.encode(), content_key(_files_of(each).values()).encode())
            for name, each in self._here.items()
        }
        path = [each.id for part in self._sets() for each in part.problems if each.id in keys]
        order = dict.fromkeys([*path, *keys])
        every = digest(repr((keys, read_decks(self._folders)[0])).encode())
        found = {f"kata/{name}.json": keys[name] for name in order} | {EXPLORE: every}
        return found | {f"kata/{name}.zip": keys[name] for name in order} | {QUIZ: every}

    def _sets(self) -> list[PracticeSet[Problem]]:
        sets = sound_sets(self.problems, self._folders)[0]
        return [each for each in sets if each.problems and each.name != USUAL]

    def _write_page(self, parts: Path) -> None:
        """All but the pieces; what an earlier build left is taken away."""
        out = self.out
        known = {self._page(each) for each in self.problems} | {out / name for name in self._keys}
        for problem in filter(has_figure, self.problems):
            known.add(place := out / "kata" / f"{problem.id}.svg")
            shutil.copy(problem.folder / "figure.svg", place)
        for path in (*(out / "kata").iterdir(), *(out / "explore").iterdir()):
            if path not in known:
                path.unlink()
        shutil.copytree(parts, out, dirs_exist_ok=True)
        _zip(out / "judge.zip", {f"judge/{path.relative_to(_PACKAGE)}": path for path in _modules()})
        sets = [
            {
                "name": each.name,
                "title": each.title,
                "about": each.about,
                "katas": [one.id for one in each.problems],
            }
            for each in self._sets()
        ]
        named = read_checklist(self._folders).skills
        topics = list(dict.fromkeys(filter(None, (each.topic for each in named))))
        skills = {each.name for each in named if each.topic or not topics}
        katas = [
            _listed(each) | {"skills": [one.name for one in each.skills if one.name in skills]}
            for each in self.problems
        ]
        packs = dict.fromkeys(read_pack(each.folder.parent).title for each in self.problems)
        found = {
            "title": ", ".join(packs),
            "editor": (parts / "ace").is_dir(),
            "sets": sets,
            "katas": katas,
            "topics": topics,
        }
        _write(out / "katas.json", found)
        _write(out / "mine.json", {})
        _write_worker(out, repr(self._keys))

    def build(self, stage: Stage | None = None, asked: Callable[[], str] = lambda: "") -> Iterator[str]:
        """Make what is missing, first what is `asked` for; each piece once it is there or cannot be.

        What could not be made is one of the `faults`. Raises OSError.
        """
        total = sum(map(_takes_long, self.missing))
        while self.missing:
            name = asked() or self.missing[0]
            if stage:
                stage(Path(name).stem, total - sum(map(_takes_long, self.missing)), total)
            try:
                self._make(name)
                self._before[name] = self._keys[name]
                _write(self.out / "site.json", self._before)  # whoever stops here goes on from here
            except JudgeError as fault:
                self.faults.append(fault)
            self.missing.remove(name)
            yield name
        if stage:
            stage("", total, total)

    def _make(self, name: str) -> None:
        if name == QUIZ:
            _write(self.out / name, _cards(self.problems, self._folders))
        elif name == EXPLORE:  # all pages are there, since they came first
            there = [each for each in self._here.values() if self._page(each).is_file()]
            replace_file(self.out / name, explore_index(there).encode())
        elif name.endswith(".zip"):
            _write_kata(self.out / name, self._here[Path(name).stem])
        else:
            problem = self._here[Path(name).stem]
            hooks = load_module(problem).hooks
            page = hooks.explore(problem, None) if hooks.explore else None
            self._page(problem).unlink(missing_ok=True)
            if page:
                replace_file(self._page(problem), page.encode())
            _write(self.out / name, kata_page(problem) | {"explore": bool(page)})

    def _page(self, problem: Problem) -> Path:
        return self.out / "explore" / f"{problem.id}.html"

    def built(self, *, opened: bool) -> SiteBuilt:
        """What came of it; `opened` says that it is looked at now."""
        return SiteBuilt(
            str(self.out),
            tuple(name for name in self._here if name in self._made),
            tuple(name for name in self._here if name not in self._made),
            tuple(each.id for each in self.problems if each.id not in self._here),
            sum(path.stat().st_size for path in self.out.rglob("*") if path.is_file()),
            opened,
        )


def _takes_long(piece: str) -> bool:
    return piece == QUIZ or piece.endswith(".zip")


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
    if problem.talks:
        return f"{where}. A dialogue is judged on the command line only."
    if problem.time is not None and problem.time.needs:
        return f"{where}. It is timed beside {', '.join(problem.time.needs)}."
    return ""


def _listed(problem: Problem) -> dict[str, Any]:
    """The kata as the page lists it."""
    names = ", ".join(parameter.name for parameter in problem.parameters)
    stub = f"def {problem.entry}({names}):\n    raise NotImplementedError\n"
    if problem.methods or not problem.entry:
        stub = make_stub(problem)
    return {
        "id": problem.id,
        "title": problem.title,
        "summary": problem.summary,
        "stub": stub,
        "levels": bool(problem.levels),
        "elsewhere": _elsewhere(problem),
        "figure": has_figure(problem),
    }


def _write_kata(place: Path, problem: Problem) -> None:
    """What judging a kata needs. Raises JudgeError."""
    store = _Keeping()
    data = load_data(problem, store=store)
    Namer(data, None, Settings(measured=False), nullcontext, store=store).learn()
    found = {f"{kind}.json": content for kind, content in store.found.items()}
    _zip(place, {**_files_of(problem), **found})


def _files_of(problem: Problem) -> dict[str, Path]:
    """The files of a kata that a tab needs, by their names there."""
    problems, solutions = problem.folder.parent, problem.solutions.parent
    files = {
        f"{root}/{problem.id}/{path.relative_to(folder)}": path
        for root, folder in (("problems", problem.folder), ("solutions", problem.solutions))
        for path in _shipped(folder)
    }
    for path in (*problems.glob("types/*.py"), *problems.glob("skills.toml")):
        files[f"problems/{path.relative_to(problems)}"] = path
    return files | {f"solutions/{path.name}": path for path in solutions.glob("mistakes.toml")}


def _shipped(folder: Path) -> Iterator[Path]:
    """The files of a kata's folder that a tab needs: no other languages, slow programs or libraries."""
    for path in folder.rglob("*"):
        first, *_ = parts = path.relative_to(folder).parts
        unwanted = first in ("slow", "libraries") or (first in ("accepted", "wrong") and path.suffix != ".py")
        if path.is_file() and not unwanted and "__pycache__" not in parts:
            yield path


def _modules() -> Iterator[Path]:
    """The files of this package that a tab needs."""
    for name in _IN_A_TAB:
        place = _PACKAGE / name
        for path in place.rglob("*") if place.is_dir() else [place]:
            left_out = _LEFT_OUT & {*path.relative_to(_PACKAGE).parts} or path.stem in _UNCALLED
            if path.is_file() and not left_out:
                yield path


def _write_worker(out: Path, pieces: str) -> None:
    """The service worker, whose version is the hash of the page and of what the pieces are made from."""
    files = [path for path in sorted(out.iterdir()) if path.is_file()]
    files += sorted(path for name in _BROUGHT for path in (out / name).rglob("*") if path.is_file())
    known = [digest(path.read_bytes()) for path in files if path.name not in ("sw.js", "site.json", QUIZ)]
    version = digest(*(each.encode() for each in (*known, pieces)))[:16]
    worker = (PAGE / "sw.js").read_text(encoding="utf-8").replace("{{version}}", version)
    replace_file(out / "sw.js", worker.encode())


def _cards(problems: Sequence[Problem], folders: Sequence[Path]) -> list[dict[str, Any]]:
    """The cards of all sets whose problems are here."""
    names: set[str] = {"", *(problem.id for problem in problems)}
    found = []
    for card in read_decks(folders)[0]:
        if card.problem in names:
            with suppress(JudgeError):  # `judge verify` tells of it
                found.append(_card(card, ask(card, folders, _SEED, "site")))
    return found


def _card(card: Card, asked: Question) -> dict[str, Any]:
    """A card with its answer; of `options` one is right, and the others say why they are not."""
    options = asked.options
    if isinstance(card.content, Count):
        options = tuple((each, each) for each in dict.fromkeys([*_COUNTS, asked.answer, NONE]))
    replies = [(text, asked.check(letter) if asked.check else None) for letter, text in options]
    number = card.content if isinstance(card.content, Number) else None
    return {
        "key": card.key,
        "sets": card.sets,
        "front": card.front,
        "given": asked.given,
        "svg": _figure(asked.picture),
        "drawn": _figure(asked.drawn),
        "options": [
            {"text": text, "right": bool(reply and reply.right), "why": reply.why if reply else ""}
            for text, reply in replies
        ],
        "number": number and {"answer": number.answer, "within": number.within, "unit": number.unit},
        "typed": asked.expects if isinstance(card.content, Number | Drawn) else "",
        "answer": asked.answer,
        "why": asked.why,
    }


def _figure(picture: Picture | None) -> str:
    return panel_svg(picture.whole, "figure", picture.description, alone=True) if picture else ""


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

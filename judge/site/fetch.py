"""What a site needs of others: Python for a tab, two libraries, an editor. Pinned, and checked by hash.

They are fetched once, from the npm registry and from PyPI, and kept in the cache. Their licences come along.
"""

from __future__ import annotations

import hashlib
import io
import shutil
import tarfile
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple
from urllib.error import URLError
from urllib.request import urlopen

from judge.errors import JudgeError, UsageError
from judge.files import cache_folder, replace_file

Progress = Callable[[str, int, int], None]  # what is fetched, bytes so far, bytes in all
_NPM, _PYPI = "https://registry.npmjs.org", "https://files.pythonhosted.org/packages"
_PIECE = 1 << 18
_SECONDS = 60  # without a byte


class Part(NamedTuple):
    """A file of others: where it is, the hash of its bytes, and what a site takes of it."""

    name: str
    address: str
    sha256: str


PYODIDE = Part(
    "pyodide-314.0.7.tgz",
    f"{_NPM}/pyodide/-/pyodide-314.0.7.tgz",
    "66b7949e5a0cba2250b586d7e368bf12fb482800748d182c4618254b685ffaa0",
)
EDITOR = Part(
    "ace-builds-1.45.2.tgz",
    f"{_NPM}/ace-builds/-/ace-builds-1.45.2.tgz",
    "5260354a14533fa8e94572597b1ff53025b1bb0a9b2e25d50ecf2a01e57aa9e0",
)
MSGSPEC = Part(
    "msgspec-0.22.0-cp314-cp314-pyemscripten_2026_0_wasm32.whl",
    f"{_PYPI}/75/5d/c0e6bdb81a87f6bd56a663a330c271af7670490c80d8d635d9fa21ad1adf/"
    "msgspec-0.22.0-cp314-cp314-pyemscripten_2026_0_wasm32.whl",
    "a66b1766311e42371e509c996c3933b161c7ae0eabdf361af5316dec197e1022",
)
EXTRA = (  # for the search for small cases; the page is used without them until they are there
    Part(
        "hypothesis-6.170.17-cp314-cp314-pyemscripten_2026_0_wasm32.whl",
        f"{_PYPI}/99/6e/d678cb8cf1a1900c265a99051a89c2315689283820fd6075049af157538a/"
        "hypothesis-6.170.17-cp314-cp314-pyemscripten_2026_0_wasm32.whl",
        "dc3512b8619b627c7feffac5937abe985fc49745c85335c1753e7d0738add85b",
    ),
    Part(
        "sortedcontainers-2.4.0-py2.py3-none-any.whl",
        f"{_PYPI}/32/46/9cb0e58b2deb7f82b84065f37f3bffeb12413f947f9388e4cac22c4621ce/"
        "sortedcontainers-2.4.0-py2.py3-none-any.whl",
        "a163dcaede0f1c021485e957a39245190e74249897e2ae4b2aa38595db237ee0",
    ),
)
_PYTHON = (
    "pyodide.mjs",
    "pyodide.asm.mjs",
    "pyodide.asm.wasm",
    "python_stdlib.zip",
    "pyodide-lock.json",
    "README.md",
)
_ACE = {
    "LICENSE": "LICENSE",
    "src-min-noconflict/ace.js": "ace.js",
    "src-min-noconflict/mode-python.js": "mode-python.js",
    "src-min-noconflict/theme-github_light_default.js": "theme-github_light_default.js",
    "src-min-noconflict/theme-github_dark.js": "theme-github_dark.js",
    "css/ace.css": "ace.css",
    "css/main-17.png": "main-17.png",
    "css/theme/github_light_default.css": "theme/github_light_default.css",
    "css/theme/github_dark.css": "theme/github_dark.css",
    "css/github_light_default-1.png": "github_light_default-1.png",
    "css/github_light_default-2.png": "github_light_default-2.png",
    "css/github_dark-1.png": "github_dark-1.png",
    "css/github_dark-2.png": "github_dark-2.png",
}


def parts(pyodide: str | None, progress: Progress | None = None) -> Path:
    """A folder with `pyodide/`, `wheels/` and `ace/`, as a site has them.

    `pyodide` is a folder or an address that has Pyodide's files; by default its archive is fetched. Raises
    JudgeError where something cannot be had.
    """
    kept = cache_folder() / "site"
    out = kept / "parts"
    shutil.rmtree(out, ignore_errors=True)
    for name in ("pyodide", "wheels", "ace/theme"):
        (out / name).mkdir(parents=True)
    if pyodide is None:
        _unpack(_fetched(PYODIDE, kept, progress), {name: name for name in _PYTHON}, out / "pyodide")
    else:
        for name in _PYTHON[:-1]:
            (out / "pyodide" / name).write_bytes(_given(pyodide, name))
    (out / "wheels" / "msgspec.whl").write_bytes(_fetched(MSGSPEC, kept, progress))
    with zipfile.ZipFile(out / "wheels" / "extra.zip", "w", zipfile.ZIP_DEFLATED) as archive:
        for part in EXTRA:
            with zipfile.ZipFile(io.BytesIO(_fetched(part, kept, progress))) as wheel:
                for info in sorted(wheel.infolist(), key=lambda each: each.filename):
                    archive.writestr(zipfile.ZipInfo(info.filename), wheel.read(info), zipfile.ZIP_DEFLATED)
    _unpack(_fetched(EDITOR, kept, progress), _ACE, out / "ace")
    return out


def _given(place: str, name: str) -> bytes:
    """A file of a folder or of an address. Raises UsageError."""
    try:
        if place.startswith(("https://", "http://")):
            with urlopen(f"{place.rstrip('/')}/{name}", timeout=_SECONDS) as answer:
                found: bytes = answer.read()
                return found
        return (Path(place) / name).read_bytes()
    except OSError as fault:
        remedy = "name a folder or an address that holds the files of the npm package pyodide"
        raise UsageError(
            f"there is no {name}: {_why(fault)}", where=f"--pyodide {place}", remedy=remedy
        ) from None


def _fetched(part: Part, kept: Path, progress: Progress | None) -> bytes:
    """The bytes of a part, from the cache or from its address. Raises JudgeError."""
    path = kept / part.name
    if path.is_file() and _sound(found := path.read_bytes(), part):
        return found
    try:
        with urlopen(part.address, timeout=_SECONDS) as answer:
            size, pieces = int(answer.headers.get("Content-Length") or 0), []
            while piece := answer.read(_PIECE):
                pieces.append(piece)
                if progress:
                    progress(part.name, min(size, sum(map(len, pieces))), size)
        found = b"".join(pieces)
    except OSError as fault:
        remedy = f"fetch {part.address} yourself and put it into {kept}"
        raise JudgeError(f"{part.name} cannot be fetched: {_why(fault)}", remedy=remedy) from None
    if not _sound(found, part):
        raise JudgeError(
            f"{part.name} is not what it was when it was pinned", where=part.address, remedy="try again later"
        )
    path.parent.mkdir(parents=True, exist_ok=True)
    replace_file(path, found)
    return found


def _sound(content: bytes, part: Part) -> bool:
    return hashlib.sha256(content).hexdigest() == part.sha256


def _why(fault: OSError) -> str:
    reason = fault.reason if isinstance(fault, URLError) else fault.strerror or fault
    return str(getattr(reason, "strerror", None) or reason).lower()


def _unpack(archive: bytes, wanted: dict[str, str], folder: Path) -> None:
    """These files of an npm archive, which has them all below `package/`."""
    with tarfile.open(fileobj=io.BytesIO(archive)) as tar:
        for name, target in wanted.items():
            found = tar.extractfile(f"package/{name}")
            assert found is not None
            (folder / target).write_bytes(found.read())

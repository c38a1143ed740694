"""Results without what differs from run to run, each submission judged once and kept.

Times, memory and what a machine says of itself become constants, so that a screen drawn from a result is the
same text everywhere. Kept results make a second look at the same submission free.
"""

from __future__ import annotations

import pickle
import re
from collections.abc import Iterator
from contextlib import contextmanager
from hashlib import sha256
from pathlib import Path
from unittest.mock import patch

from msgspec.structs import replace

from judge.judging import version_of
from judge.judging.session import Session
from judge.problem import Verdict
from judge.run.result import Growth, Ratio, Result

_RATIO = Ratio(0.8, 0.75, 0.9, 3)
_GROWTH = re.compile(r"n\^\d\.\d")
_SECONDS = re.compile(r"\d+(\.\d+)?(?= s\b)")
_BUSY = re.compile(r"took more than \S+ s, with \S+ s of CPU time")
_NOISE = re.compile(r"^(waited|isolation is|its time)")


def steady(result: Result) -> Result:
    """The result with constants for all that another run would measure otherwise."""
    time = replace(
        result.time,
        cpu_seconds=0.0125,
        wall_seconds=0.025,
        ratio=_RATIO if result.time.ratio else None,
        borderline=False,
        growth=_grown(result.time.growth) if result.time.growth else None,
        import_seconds=0.05 if result.time.import_tells else 0.0,
    )
    failure = result.failure
    smallest = result.counterexample
    if failure is not None and result.verdict is Verdict.TLE:
        failure = replace(failure, message=_timeless(failure.message))
    if smallest is not None and result.verdict is Verdict.TLE:
        smallest = replace(smallest, message=_timeless(smallest.message))
    return replace(
        result,
        counterexample=smallest,
        groups=tuple(replace(group, cpu_seconds=0.001) for group in result.groups),
        failure=failure,
        time=time,
        memory_bytes=8 << 20,
        isolation="full",
        notes=tuple(note for note in result.notes if not _NOISE.match(note)),
    )


def _timeless(message: str) -> str:
    message = _BUSY.sub("used more than 1 s of CPU time", message)
    return _SECONDS.sub("1", _GROWTH.sub("n^1.0", message))


def _grown(growth: Growth) -> Growth:
    return replace(growth, exponent=1.0, reference=1.0, pairs=3, borderline=False, points=())


@contextmanager
def steadied(folder: Path) -> Iterator[None]:
    """Within, each submission is judged once by a session, its steady result kept in `folder`."""
    judge, boot, folder = Session.judge, Session.boot, folder / "results"
    folder.mkdir(parents=True, exist_ok=True)
    versions: dict[Path, str] = {}

    def judged(session: Session, source: bytes, name: str, _on_verdict: object = None) -> Result:
        problem = session.problem
        version = versions.setdefault(problem.folder, "") or version_of(problem)
        versions[problem.folder] = version
        options = [getattr(session.options, field) for field in session.options.__struct_fields__]
        key = sha256(repr((problem.id, version, options, Path(name).name, source)).encode()).hexdigest()
        path = folder / key
        if path.exists():
            result: Result = pickle.loads(path.read_bytes())
        else:
            boot(session, source, name)
            result = steady(judge(session, source, name))
            new = path.with_suffix(f".{id(result)}")
            new.write_bytes(pickle.dumps(result))
            new.replace(path)
        return replace(result, submission=name)

    with (
        patch.object(Session, "judge", judged),
        patch.object(Session, "boot", lambda *_: None),
    ):
        yield

"""What the known-wrong programs answer on a problem's data: judged once, in containment, and kept.

<cache folder>/mistakes/<id>-<place>-<seed>-<key>.json
    [[file, {group: [reached, [[case, form, [number, …]], …]], …}], …]
"""

from __future__ import annotations

import hashlib
import sys
from collections.abc import Callable, Sequence
from typing import Any

from judge.data.cache import cache_folder, code_files, content_key, data_key, kept_stem
from judge.data.kept import KeptFile
from judge.data.model import ProblemData
from judge.diagnose.answers import Answers, Behaviour, behaviour
from judge.problem.solutions import Solution
from judge.run.parallel import in_order
from judge.run.settings import Settings

FORMAT = 2  # raise it when the form of the file changes

Progress = Callable[[int, int], None]  # programs judged, programs in all
_CODE = ("run", "sandbox")  # beside the packages that the data depend on
_WHAT = "the known mistakes' answers"


def known_behaviours(
    data: ProblemData,
    seed: int | None,
    mistakes: Sequence[Solution],
    *,
    settings: Settings,
    workers: int = 1,
    progress: Progress | None = None,
) -> tuple[list[Behaviour], str | None]:
    """The behaviour of each known-wrong program, from the cache or found by judging it now.

    Beside them a note for the person where they cannot be kept. `settings` say how a program is judged,
    `workers` how many are at once. Raises JudgeError where nothing can be run.
    """
    file = KeptFile(cache_folder, "mistakes", kept_stem(data.problem, seed), _key(data, seed), _WHAT)
    kept = _from_plain(file.read())
    keys = [hashlib.sha256(mistake.source).hexdigest() for mistake in mistakes]
    missing = {key: mistake for key, mistake in zip(keys, mistakes, strict=True) if key not in kept}
    if not missing:
        return [kept[key] for key in keys], None

    from judge.run.execute import run_submission

    def judge(mistake: Solution) -> Behaviour:
        name = mistake.path.name
        return behaviour(run_submission(data.problem, data, mistake.source, name, settings=settings))

    found = {key: kept[key] for key in keys if key in kept}
    done = 0
    try:
        for key, each in zip(missing, in_order(list(missing.values()), workers, judge), strict=True):
            found[key] = each
            done += 1
            if progress:
                progress(done, len(missing))
    finally:
        note = file.write({key: _as_plain(each) for key, each in found.items()})
    return [found[key] for key in keys], note


def _key(data: ProblemData, seed: int | None) -> str:
    """The hash of all that the behaviours depend on beside the programs."""
    start = f"{FORMAT}/{sys.version}/{data_key(data.problem, seed)}"
    return content_key(start, code_files(_CODE))


def _as_plain(known: Behaviour) -> dict[str, Any]:
    return {name: _plain_answers(answers) for name, answers in known.items()}


def _plain_answers(answers: Answers) -> list[Any]:
    return [answers.reached, [[case, *outline] for case, outline in answers.wrong.items()]]


def _from_plain(plain: Any) -> dict[str, Behaviour]:
    """The behaviours that were written, by program; none if this is anything else."""
    try:
        return {
            key: {
                name: Answers(reached, {case: (form, tuple(numbers)) for case, form, numbers in wrong})
                for name, (reached, wrong) in groups.items()
            }
            for key, groups in plain.items()
        }
    except (TypeError, ValueError, AttributeError):  # whatever a foreign file can hold
        return {}

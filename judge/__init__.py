"""A judge and kata kit for circle-line geometry.

>>> import judge
>>> problem = judge.find_problem("count")
>>> options = judge.RunOptions(groups=("examples",), timed=False, diagnosed=False, named=False)
>>> source = "def line_count(cx, cy, r, A, B): return 2"
>>> result = judge.judge(problem, source, name="mine.py", options=options)  # a judge.Result
>>> result.verdict.value, result.failure.case, result.failure.got
('WA', 2, '2')

For many submissions, a session builds the data once; a job is a submission that can be sent elsewhere:

>>> job = judge.Job.of(problem, source.encode(), "mine.py", options)
>>> with judge.Session(problem, options) as session:
...     session.judge(job.source, job.name).verdict.value
'WA'

What a person is told in one line is a JudgeError: a UsageError, a ProblemError or a ShortageError.

>>> judge.find_problem("cuont")
Traceback (most recent call last):
judge.errors.UnknownKataError: no kata is called 'cuont'; did you mean 'count'?

Nothing of it is imported before it is asked for; judge/manual/testing.md has more examples. Imports
point one way: cli → site → batch → judging → report → practice → geometry → mistakes → diagnose → run →
data → problem → drawing, values → exact → errors. `sandbox` knows nothing of problems, `exact` nothing of
judging, and none of them but `geometry` what a problem is about.

A type checker reads `__init__.pyi`.
"""

from __future__ import annotations

__version__ = "0.1.0"

TYPE_CHECKING = False  # typing's takes longer to import than all of this
if TYPE_CHECKING:
    from typing import Any

_FROM = {
    "Job": "judge.judging",
    "JudgeError": "judge.errors",
    "ProblemError": "judge.errors",
    "Result": "judge.run.result",
    "RunOptions": "judge.judging",
    "Session": "judge.judging.session",
    "ShortageError": "judge.errors",
    "UsageError": "judge.errors",
    "find_problem": "judge.problem.find",
    "judge": "judge.judging.api",
}
__all__ = [*_FROM, "__version__"]


def __getattr__(name: str) -> Any:
    """Import what `judge` has to offer when it is asked for: `import judge` costs nothing."""
    if name not in _FROM:
        raise AttributeError(f"module 'judge' has no attribute {name!r}")
    from importlib import import_module

    if name in ("Result", "Session", "judge"):  # the report is above the result, and shows it in a notebook
        import_module("judge.run.result").Result._repr_html_ = _notebook  # type: ignore[attr-defined]
    return getattr(import_module(_FROM[name]), name)


def _notebook(result: Any) -> str:
    from judge.report.html.pages import notebook

    return notebook(result)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})

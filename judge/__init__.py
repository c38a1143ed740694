"""A judge and kata kit for circle-line geometry.

    import judge

    result = judge.judge("count", pathlib.Path("mine.py"))

Nothing of it is imported before it is asked for; judge/manual/testing.md has more examples. Imports
point one way: cli → batch → judging → report → kata → geometry → mistakes → diagnose → run → data →
problem → drawing, values → exact → errors. `sandbox` knows nothing of problems, `exact` nothing of judging,
and none of them but `geometry` what a problem is about.

A type checker reads `__init__.pyi`.
"""

from __future__ import annotations

TYPE_CHECKING = False  # typing's takes longer to import than all of this
if TYPE_CHECKING:
    from typing import Any

__version__ = "0.1.0"
_FROM = {
    "Job": "judge.judging.api",
    "JudgeError": "judge.errors",
    "ProblemError": "judge.errors",
    "Result": "judge.run.result",
    "RunOptions": "judge.judging.api",
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
    from judge.report.notebook import notebook

    return notebook(result)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})

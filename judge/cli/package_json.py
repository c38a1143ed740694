"""What `judge run PACKAGE --json` writes: one object a submission."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from judge.packs.foreign.judging import Judged
from judge.packs.foreign.package import Package
from judge.packs.foreign.timing import TimeLimit

if TYPE_CHECKING:
    from judge.cli.packages import Ruled

SCHEMA = 1


def row_object(package: Package, ruled: Ruled, limit: TimeLimit) -> dict[str, Any]:
    """A submission's result, and what bound it."""
    judged = ruled.judged
    return {
        "schema": SCHEMA,
        "package": package.name,
        "format": package.form,
        "submission": judged.name,
        "language": judged.language,
        "verdict": judged.verdict.value,
        "folder": ruled.entrant.folder or None,
        "as_expected": ruled.as_expected,
        "passed": judged.passed,
        "test_files": judged.out_of,
        "tests": [
            {
                "name": test.name,
                "verdict": test.verdict.value,
                "cpu_seconds": test.cpu_seconds,
                "memory_bytes": test.memory_bytes,
            }
            for test in judged.tests
        ],
        "failure": _failure(judged),
        "sensitive": judged.sensitive or None,
        "limits": {
            "time_seconds": limit.seconds,
            "margin_seconds": limit.margin,
            "slowest_accepted_seconds": limit.slowest,
            "memory_bytes": package.memory_bytes,
            "output_bytes": package.output_bytes,
            "lowered": [*package.lowered.values(), *filter(None, [limit.lowered])],
        },
        "isolation": judged.isolation or None,
    }


def _failure(judged: Judged) -> dict[str, Any] | None:
    failure = judged.failure
    if failure is None:
        return None
    found: dict[str, Any] = {"message": failure.message, "test": failure.test or None}
    if failure.test:
        found |= {
            "input": failure.given,
            "answer": failure.answer,
            "output": failure.output,
            "judge_message": failure.told,
        }
    return found

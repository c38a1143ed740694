"""The verdicts and what they mean to a person."""

from __future__ import annotations

from enum import Enum

FULL_SCORE = 100  # what the points of a problem's groups sum to


class Verdict(Enum):
    """The outcome of a test group or of a whole submission; the value is its name in JSON."""

    AC = "AC"
    WA = "WA"
    TLE = "TLE"
    MLE = "MLE"
    OLE = "OLE"
    RTE = "RTE"
    CE = "CE"
    JE = "JE"

    @property
    def meaning(self) -> str:
        """The verdict in words."""
        return _MEANING[self]


_MEANING = {
    Verdict.AC: "accepted",
    Verdict.WA: "wrong answer",
    Verdict.TLE: "time limit exceeded",
    Verdict.MLE: "memory limit exceeded",
    Verdict.OLE: "output limit exceeded",
    Verdict.RTE: "run-time error",
    Verdict.CE: "does not compile",
    Verdict.JE: "could not be judged",
}

"""What came back from running a submission on a series of cases, whichever way it is run."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from judge.problem import Verdict
from judge.sandbox.boundary import Reply, Stop, Usage

NO_ANSWER = "no answer"  # what is shown in place of one
VERDICTS = {
    Stop.EXCEPTION: Verdict.RTE,
    Stop.EXITED: Verdict.RTE,
    Stop.TAMPERED: Verdict.RTE,
    Stop.CPU: Verdict.TLE,
    Stop.WALL: Verdict.TLE,
    Stop.WAITING: Verdict.TLE,
    Stop.MEMORY: Verdict.MLE,
    Stop.OUTPUT: Verdict.OLE,
}


class Breakdown(NamedTuple):
    """What is wrong with a run as a whole, where no case in particular is to blame.

    `verdict` is what it earns and `detail` says why, for a person. It is shown at `case` (from 0), with `got`
    in place of an answer; `so_far` says how much of the run there was.
    """

    verdict: Verdict
    detail: str
    case: int
    got: str = NO_ANSWER
    so_far: str = ""


class Replies(NamedTuple):
    """One reply for each case of a series, in order, as far as the run came.

    An answer is what the submission gave: a value in its JSON form, or a line of its output. A call that
    raised or ended its process is a reply too. `stop` is how the process ended, ANSWERED if by itself.
    """

    replies: Sequence[Reply]
    usage: Usage
    stop: Stop = Stop.ANSWERED
    lost: bool = False  # the process was ended by force or in mid-call
    breakdown: Breakdown | None = None
    imported: Usage = Usage()  # what the import took, where that was measured apart from the calls
    printed: bytes = b""  # the beginning of what its calls printed

    @property
    def trouble(self) -> str:
        """The first thing that is not as it should be, for a person; empty where all replies are answers."""
        stopped = next((reply for reply in self.replies if reply.stop is not Stop.ANSWERED), None)
        if stopped is not None:
            return stopped.detail
        return self.breakdown.detail if self.breakdown is not None else ""

    def told(self, detail: str) -> Replies:
        """The same, with another text for how the process ended."""
        if self.breakdown is not None:
            if self.breakdown.verdict is Verdict.WA:  # which says what was printed
                return self
            return self._replace(breakdown=self.breakdown._replace(detail=detail))
        return self._replace(replies=[*self.replies[:-1], self.replies[-1]._replace(detail=detail)])

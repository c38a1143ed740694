"""Judging a submission on fresh cases, and explaining what breaks as `judge run` does."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec import Struct
from msgspec.structs import replace

from judge.data.build import Fresh
from judge.data.load import ProblemData, load_data
from judge.judging.diagnosis import diagnosed
from judge.judging.naming import NAMED, Naming
from judge.judging.session import Session
from judge.problem import Group
from judge.problem.module import load_module
from judge.run.execute import judge_submission
from judge.run.hurdle import with_hurdle
from judge.run.runner import Runner
from judge.run.stress import Broken, OnCases, Stressed, stress
from judge.sandbox.boundary import Box


class Stressing(Struct, frozen=True):
    """What is asked for: which submission, on which groups, from which seed and for how long."""

    source: bytes
    name: str
    groups: Sequence[Group]
    seed: int
    seconds: float

    def run(self, session: Session, on_cases: OnCases | None = None) -> Stressed:
        """Stress the submission within a session, which says whether what breaks is shrunk and named.

        Ctrl-C ends it early; what broke by then is kept. Raises JudgeError.
        """
        containment, problem = session.containment, session.problem
        containment.boot(self.source, self.name)
        module = load_module(problem)  # while the boxes boot
        data = ProblemData(problem, (), module=module)
        fresh = Fresh(problem, module, self.groups, self.seed)
        with containment.take(self.source, self.name) as box:
            stressed = stress(
                data,
                fresh,
                box,
                self.source,
                self.name,
                seconds=self.seconds,
                on_cases=on_cases,
                turnstile=session.turnstile,
            )
            if stressed.broken and stressed.runner:
                stressed = replace(
                    stressed, result=with_hurdle(stressed.result, stressed.runner, box, self.source)
                )
            if stressed.result.hurdle is not None:
                return stressed
            try:
                runner = stressed.runner if session.options.diagnosed else None
                with session.turnstile.judging():
                    if stressed.broken and runner:
                        stressed = _shrunk(stressed, stressed.broken, runner, fresh, box, session)
                if stressed.broken and session.options.named and stressed.result.verdict in NAMED:
                    stressed = self._named(stressed, session)
            except KeyboardInterrupt:  # what broke is known, and worth more than the rest
                stressed = replace(stressed, interrupted=True)
            result = stressed.result.noting(*containment.notes(box.isolation))
        return replace(stressed, result=result)

    def _named(self, stressed: Stressed, session: Session) -> Stressed:
        """With the mistake's name, which the wrong answers to the pinned cases tell, if there are any."""
        data = load_data(session.problem)
        settings = session.settings
        pinned = judge_submission(
            session.problem, data, self.source, self.name, settings=replace(settings, measured=False)
        )
        naming = Naming(data, None, settings, session.bars)
        named = naming.named(pinned.result, pinned.behaviour, self.source)
        result = replace(stressed.result, pitfall=named.pitfall).noting(*named.notes)
        return replace(stressed, result=result)


def _shrunk(
    stressed: Stressed, broken: Broken, runner: Runner, fresh: Fresh, box: Box, session: Session
) -> Stressed:
    """With its counterexample."""
    series = broken.series
    failed = diagnosed(
        replace(stressed.result, failure=broken.failure),
        ProblemData(session.problem, (series,), module=fresh.module),
        runner,
        box,
        session.containment.open_box,
        choices=lambda _group, _builder, number, _case: series.choices[number],
    )
    result = replace(
        stressed.result,
        counterexample=failed.counterexample,
        notes=failed.notes,
    )
    return replace(stressed, result=result)

"""`judge stress`: judge a submission on fresh cases until the time is up or something breaks."""

from __future__ import annotations

import math
import random
from pathlib import Path
from typing import TYPE_CHECKING

import click
from msgspec import Struct
from msgspec.structs import replace

from judge.cli.containment import Containment, isolation_option
from judge.cli.diagnosis import Diagnosis, no_shrink_option, save_regression_option
from judge.cli.duration import duration
from judge.cli.naming import Naming
from judge.cli.options import chosen_groups, group_option, json_option, problems_option, write_json
from judge.cli.picture import Drawing, check_svg, svg_option
from judge.cli.submissions import Submission, read_submissions
from judge.data import ProblemData, load_data
from judge.errors import ExitCode, JudgeError, UsageError
from judge.report.progress import stages
from judge.report.results import lines_beside
from judge.report.screen import out
from judge.report.stress import stress_lines
from judge.run import Settings, judge_fault, run_submission
from judge.run.stress import Broken, Stressed, stress
from judge.sandbox import Box, BoxFactory
from judge.spec import Group, Problem, Verdict
from judge.spec.find import find_problem

if TYPE_CHECKING:
    from judge.data.fresh import Fresh

_NAMED = (Verdict.WA, Verdict.RTE)
_SEEDS = 10**9  # a fresh seed is below it: short enough to be typed again


@click.command("stress")
@click.argument("name", metavar="PROBLEM")
@click.argument("file", metavar="FILE")
@click.option(
    "--for",
    "seconds",
    callback=duration,
    default="30s",
    metavar="TIME",
    show_default=True,
    help="How long: 30, 30s, 2m, 1h.",
)
@json_option
@group_option
@click.option("--seed", type=int, metavar="N", help="Repeat the cases of this seed; without it, new ones.")
@click.option("--no-name", is_flag=True, help="Do not look for the mistake behind wrong answers.")
@isolation_option
@no_shrink_option
@save_regression_option
@svg_option
@problems_option
def command(
    name: str,
    file: str,
    seconds: float,
    as_json: bool,
    groups: tuple[str, ...],
    seed: int | None,
    no_name: bool,
    level: str | None,
    unshrunk: bool,
    regression: Path | None,
    svg: Path | None,
    folders: tuple[Path, ...],
) -> ExitCode:
    """Judge a submission on fresh cases until the time is up or something breaks.

    The test groups take turns. Each time a group's builder makes cases from new parameters, drawn from the
    seed, and each of them is proved and solved exactly like the pinned ones; three of its mirror images
    follow it where the problem has them. What breaks is shrunk and shown as `judge run` does.

    Ctrl-C ends it early and keeps what was found.

    Exit status: 0 the time was up and nothing broke, 1 something broke, 2 usage, 3 the judge's or the
    problem's own fault, 130 interrupted before anything broke.
    """
    seed = random.randrange(_SEEDS) if seed is None else seed
    submission: Submission | None = None
    try:
        problem = find_problem(name, folders)
        submission = _submission(file)
        if regression is not None:
            from judge.cli.regression import agree_on  # only who asks for it waits for it

            agree_on(regression)
        check_svg(svg, 1)
        asked = _Asked(
            problem,
            submission,
            seconds,
            chosen_groups(problem, groups),
            seed,
            named=not no_name,
            shrunk=not unshrunk or regression is not None,
            regression=regression,
        )
        with Containment(problem, level) as containment:
            stressed, data = asked.stressed(containment)
    except JudgeError as fault:
        if as_json and not isinstance(fault, UsageError):  # a script misses none
            judged = submission or _submission(file)
            write_json(Stressed(judge_fault(name, judged.name, str(fault)), seed, 0.0).as_json())
        raise
    drawing = Drawing(problem, data, stressed.result)
    if as_json:
        write_json(stressed.as_json())
    else:
        screen = out()
        drawn = drawing.lines(screen, beside=lines_beside(stressed.result, screen.width))
        screen.show(stress_lines(stressed, screen.width, drawn))
    drawing.save(svg)
    if stressed.interrupted and stressed.result.verdict is Verdict.AC:
        return ExitCode.INTERRUPTED
    return stressed.result.exit_code


def _submission(file: str) -> Submission:
    submissions = read_submissions([file])
    if len(submissions) > 1:
        raise UsageError("this folder holds several submissions", where=file, remedy="name one file")
    return submissions[0]


class _Asked(Struct, frozen=True):
    """What the person asked for."""

    problem: Problem
    submission: Submission
    seconds: float
    groups: tuple[Group, ...]
    seed: int
    named: bool
    shrunk: bool
    regression: Path | None

    def stressed(self, containment: Containment) -> tuple[Stressed, ProblemData]:
        """What it comes to, and what answers for the problem's exact answers."""
        problem, submission = self.problem, self.submission
        containment.boot(submission.source, submission.name)
        from judge.data.fresh import Fresh  # while the boxes boot
        from judge.data.module import load_module

        module = load_module(problem)
        data = ProblemData(problem, (), module=module)
        fresh = Fresh(problem, module, self.groups, self.seed)
        settings = containment.settings(submissions=1)
        with settings.box_factory(submission.source, submission.name) as box:
            containment.warn_of(box.isolation)
            stressed = self._run(data, fresh, box)
            try:
                if stressed.broken and self.shrunk:
                    stressed = self._shrunk(stressed, stressed.broken, fresh, box, containment.open_box)
                if stressed.broken and self.named and stressed.result.verdict in _NAMED:
                    stressed = self._with_name(stressed, settings)
            except KeyboardInterrupt:  # what broke is known, and worth more than the rest
                stressed = replace(stressed, interrupted=True)
        return stressed, data

    def _run(self, data: ProblemData, fresh: Fresh, box: Box) -> Stressed:
        whole = math.ceil(self.seconds)
        source, name = self.submission.source, self.submission.name
        with stages(Path(name).name) as stage:

            def tell(cases: int, seconds: float) -> None:
                if stage:
                    stage(
                        f"{cases:,} cases, {cases / seconds:,.0f} a second", min(int(seconds), whole), whole
                    )

            return stress(data, fresh, box, source, name, seconds=self.seconds, on_cases=tell)

    def _shrunk(
        self, stressed: Stressed, broken: Broken, fresh: Fresh, box: Box, open_box: BoxFactory
    ) -> Stressed:
        """With its counterexample."""
        series = broken.series
        diagnosis = Diagnosis(
            ProblemData(self.problem, (series.data,), module=fresh.module),
            open_box,
            self.regression,
            lambda _group, _builder, number, _case: fresh.choices_of(series, number),
        )
        result = diagnosis(self.submission, replace(stressed.result, failure=broken.failure), box)
        return replace(stressed, result=replace(stressed.result, counterexample=result.counterexample))

    def _with_name(self, stressed: Stressed, settings: Settings) -> Stressed:
        """With the mistake's name, which the wrong answers to the pinned cases tell, if there are any."""
        data = load_data(self.problem)
        pinned = run_submission(
            self.problem,
            data,
            self.submission.source,
            self.submission.name,
            settings=replace(settings, measured=False),
        )
        pitfall = Naming(data, None, settings, 1).named(pinned).pitfall
        return replace(stressed, result=replace(stressed.result, pitfall=pitfall))

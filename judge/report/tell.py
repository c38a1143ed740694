"""What a result says to a person, in words and in their order; screens, pages and tests lay it out.

Nothing here writes, knows a terminal or reads the history.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from msgspec import Struct

from judge.problem import Problem, Verdict
from judge.problem.find import typed
from judge.problem.model import FIRST, Mode
from judge.report.words import argument, counted, seconds, shown_name, times
from judge.run.result import EntryKind, Failure, GroupResult, LevelResult, MistakeStep, Pitfall, Result

_PLACE = re.compile(r" \(line (\d{1,9})\)")
# As judge.run.execute writes a compiler's complaint, whose quotation of the line follows it.
_COMPILED = re.compile(r" \(line (\d{1,9})(?:, column (\d{1,9}))?\)(?:: .*)?")
_IN_CALL = re.compile(r", in call \d{1,9}: .*")
_SPENT = re.compile(r"used more than (\S+ s) of CPU time")
_SLOW = 1.5  # times as long as the reference, from which on an accepted program hears of it
_LIKELY = 0.9  # the score from which on a mistake is very likely
_MOST_FAILS = 3  # groups that are named


class Summary(Struct, frozen=True, kw_only=True):
    """A result in words.

    `meaning` is the verdict's, `how` says that it was run as a program, `stars` are the levels passed.
    `happened` says what ended the program or keeps it from running, `source` is its line there, with a caret
    below where the column is known. `case` titles the failing case: `input` has its arguments, `facts` what
    was expected and got, by their labels. `mistake` names what is probably wrong, `advice` says it. `time` is
    a sentence where the time matters, `fails` are the first groups that fail, `more` how many others do.
    `last` is what all of it comes to.
    """

    verdict: Verdict
    meaning: str
    how: str = ""
    stars: str = ""
    happened: str = ""
    source: tuple[str, ...] = ()
    case: str = ""
    input: tuple[str, ...] = ()
    facts: tuple[tuple[str, str], ...] = ()
    mistake: str = ""
    advice: tuple[str, ...] = ()
    time: str = ""
    fails: tuple[str, ...] = ()
    more: int = 0
    commands: tuple[tuple[str, str], ...] = ()
    last: str = ""

    def line(self, name: str) -> tuple[str, str, str]:
        """The verdict, the file of that name, and what all of it comes to."""
        meaning = f"{self.meaning}: " if self.verdict is not Verdict.AC else ""
        last = self.happened if self.last == "nothing was run" else self.last
        return self.verdict.value, shown_name(name), f"{meaning}{last}"

    @property
    def lines(self) -> list[str]:
        """All of it but the verdict as plain lines, for files and annotations."""
        found = [self.happened, *self.source, self.case]
        found += [f"  {', '.join(self.input)}"] if self.input else []
        rows = ((label, text.split("\n")) for label, text in self.facts)
        found += [f"  {'' if at else label:8}  {row}" for label, text in rows for at, row in enumerate(text)]
        found += [self.mistake, *(f"  {text}" for text in self.advice), self.time]
        return [each for each in found if each]


def tell(
    problem: Problem | None,
    result: Result,
    source: bytes = b"",
    why: str = "",
    *,
    whole: bool = False,
    fresh: bool = False,
) -> Summary:
    """What the result says, as far as that can be said without the problem where there is none.

    A wrong answer of which nothing more is known says `why`, what its case turns on. The time of an accepted
    one is told where it is worth a word, or `whole` of it is asked for. After a run on `fresh` cases the
    mistake is one that the kata's own cases show.
    """
    hurdle, pitfall = result.hurdle, result.pitfall
    shown = None if hurdle else shown_failure(result)
    failing = [] if hurdle else _failing(result)
    stub = hurdle is not None and hurdle.kind is EntryKind.STUB
    talks = problem is not None and problem.talks
    values = shown.input if shown and shown.input and (talks or not shown.shown) else {}
    text = source.decode("utf-8", "replace")
    order = ""
    if problem is not None and failing:
        from judge.run.unreadable import other_order

        order = other_order(problem, text)
    return Summary(
        verdict=result.verdict,
        meaning="Not written yet" if stub else result.verdict.meaning.capitalize(),
        how="run as a program" if result.mode is Mode.PROGRAM and result.groups else "",
        stars="★" * sum(level.passed for level in result.levels),
        happened=_happened(problem, result, text),
        source=() if hurdle else _source(result, text),
        case=_case(result, shown),
        input=tuple(f"{name} = {argument(value)}" for name, value in values.items()),
        facts=tuple(_facts(problem, result, shown, why)),
        mistake=order or (mistake_text(pitfall, result.submission) if pitfall else ""),
        advice=_advice(pitfall, " in the kata's own cases" if fresh else "") if pitfall and not order else (),
        time=_time(problem, result, whole=whole),
        fails=tuple(_share(each) for each in failing[:_MOST_FAILS]),
        more=max(0, len(failing) - _MOST_FAILS),
        commands=tuple(_commands(problem, result, shown)),
        last=_last(result),
    )


def shown_failure(result: Result) -> Failure | None:
    """The failing case that is shown: the smallest one, if it fails by itself, or else the first one."""
    small = result.counterexample
    return small if small is not None and small.replay is not None else result.failure


def _ended(result: Result) -> Failure | None:
    """The failure that says what ended the program: that of the case that is shown.

    How long it was waited for is said of the first one: the search for a smaller one is less patient.
    """
    return result.failure if result.verdict is Verdict.TLE or result.hurdle else shown_failure(result)


def place_of(failure: Failure | None) -> str:
    """`grid, case 7`; nothing where a failure has no place."""
    if failure is None or failure.group is None:
        return ""
    return failure.group if failure.case is None else f"{failure.group}, case {failure.case}"


def mistake_text(pitfall: Pitfall, submission: str) -> str:
    """`Very likely mistake: above-for-left`; without a name where it was found.

    Of a routine, a library and another language than Python only the answers are known.
    """
    if not pitfall.names:
        return _changes(pitfall.steps)
    if pitfall.library or not submission.endswith(".py"):
        return f"It answers like {' and '.join(pitfall.names)}"
    likely = "Very likely" if pitfall.score >= _LIKELY else "Likely"
    return f"{likely} mistake{'s' * (len(pitfall.names) > 1)}: {' and '.join(pitfall.names)}"


def _changes(steps: Sequence[MistakeStep]) -> str:
    """What was tried and is true, where there is no name."""
    gone, of = sum(step.gone for step in steps), max((step.of for step in steps), default=0)
    mends = "most of it" if 2 * gone > of else "a part of it"
    if len(steps) > 1:
        return "Several changes together make it right" if gone >= of else f"Several changes mend {mends}"
    lines = [step.line for step in steps if step.line and step.kind != "rounding"]
    if lines:
        return f"A change in line {lines[0]} {'makes it right' if gone >= of else f'mends {mends}'}"
    return "Mistake found: rounding" if any(step.kind == "rounding" for step in steps) else "Mistake found"


def _advice(pitfall: Pitfall, where: str) -> tuple[str, ...]:
    pairs = zip(pitfall.names, pitfall.advice, strict=False)  # a kept result may be damaged
    told = [f"{name}: {text}" if len(pitfall.names) > 1 else text for name, text in pairs if text]
    steps = [_step(pitfall, at, where) for at in range(len(pitfall.steps))]
    placed = any(step.line or step.name is None for step in pitfall.steps)  # else nothing is new
    return (*told, *(steps if placed else ()))


def _step(pitfall: Pitfall, at: int, where: str) -> str:
    """`line 19: a change here mends 73 of 531 failures`; what was seen there where the step has no name."""
    step, several = pitfall.steps[at], len(pitfall.steps) > 1
    place = [("First", "With that changed", "With these changed")[min(at, 2)]] if several else []
    place += [f"line {step.line}"] if step.line else []
    name = f" ({step.name})" if several and step.name else ""
    seen = step.why if step.name is None else ""
    tried = seen or ("a change here mends" if step.line else "so it is with")
    share = f"{tried} {step.gone:,} of {counted(step.of, 'failure')}{where}"
    return f"{', '.join(place)}{name}{': ' if place else ''}{share}"


def _happened(problem: Problem | None, result: Result, text: str) -> str:
    """What ended the program, or keeps it from running; nothing for a wrong answer."""
    failure, verdict = _ended(result), result.verdict
    if failure is None or verdict is Verdict.AC:
        return ""
    from judge.report.entry import entry_text  # most submissions come to an end
    from judge.run.unreadable import why_ended

    message, unplaced, place = failure.message, failure.input is None, fault_place(result)
    line = place.line if place else result.hurdle.line if result.hurdle else 0
    row = text.split("\n")[line - 1 : line] if line else ()
    if verdict is Verdict.RTE and (ended := why_ended(message, "".join(row), result.submission)):
        return f"line {line}: {ended}" if line else ended
    if result.hurdle is not None and problem is not None:
        return entry_text(result.hurdle, problem, result.submission, verdict, message)
    if verdict is Verdict.JE or (verdict is Verdict.WA and not unplaced):
        return ""
    if verdict is Verdict.CE:
        return f"line {place.line}: {_COMPILED.sub('', message)}" if place else message
    if verdict is Verdict.TLE and (spent := _SPENT.search(message)):
        where = f", at line {found[1]}" if (found := _PLACE.search(message)) else ""
        call = (
            found[0] if (small := shown_failure(result)) and (found := _IN_CALL.search(small.message)) else ""
        )
        return f"Stopped after {spent[1]} of CPU time{where}{call}. An endless loop?"
    slow = result.time.ratio is not None or result.time.growth is not None
    if verdict is Verdict.TLE and unplaced and failure.case is None and slow:
        return ""  # it is too slow beside the reference, and was not stopped
    return _PLACE.sub(r", at line \1", message)


def _time(problem: Problem | None, result: Result, *, whole: bool) -> str:
    """How long it took beside the reference, where that was measured."""
    time, ratio, growth = result.time, result.time.ratio, result.time.growth
    late = result.verdict is Verdict.TLE
    said = []
    first = problem is not None and FIRST in problem.sets
    slow = ratio is not None and ratio.median > _SLOW and not first
    grown = late and growth is not None and ratio is not None and ratio.median <= ratio.limit
    if ratio is not None and not grown and (late or (not ratio.unreliable and (slow or whole))):
        whose = " ".join(filter(None, ("the", time.reference, "reference's")))
        doubts = "; ".join(filter(None, (ratio.busy, "near the limit" if time.borderline else "")))
        limit = f" (limit {ratio.limit:g} ×)" if late and ratio.limit else ""
        said.append(f"{times(ratio.median)} × {whose} time{limit}{f' ({doubts})' if doubts else ''}")
    if growth is not None:
        said.append(f"Your time grows {growth.law}, the reference's like n^{growth.reference:.1f}")
    if time.import_tells and result.verdict in (Verdict.AC, Verdict.TLE):
        said.append(f"Its import alone takes {seconds(time.import_seconds)}")
    if late and said and result.failure and result.failure.group:
        said[0] = f"Too slow in {result.failure.group}: {said[0]}"
    return ". ".join(said) + ("." if said and result.verdict is not Verdict.AC else "")


def _source(result: Result, text: str) -> tuple[str, ...]:
    """The line of the submission where it was stopped or does not compile."""
    place = fault_place(result)
    rows = text.splitlines()
    if place is None or not 0 < place.line <= len(rows):
        return ()
    row = rows[place.line - 1].expandtabs(4)[:200].rstrip()
    shown = [f"{place.line} | {row}"]
    if place.column:
        shown.append(" " * (len(f"{place.line} | ") + min(place.column - 1, len(row))) + "^")
    return tuple(shown)


def _case(result: Result, shown: Failure | None) -> str:
    first, small = result.failure, result.counterexample
    if shown is None or first is None:
        return ""
    place = f" ({place_of(first)})" if first.case else ""
    if small is None or shown is not small:
        return f"First failing case{place}" if place or shown.input is not None else ""
    later = "; a smaller case may exist" if small.cut_short else ""
    return f"Smallest failing case{place if small.input == first.input else ''}{later}"


def _facts(
    problem: Problem | None, result: Result, shown: Failure | None, why: str
) -> Iterator[tuple[str, str]]:
    if shown is None:
        return
    wrong = result.verdict is Verdict.WA
    in_a_row, talks = (problem.methods, problem.talks) if problem else (False, False)
    if shown.shown:
        yield "calls" if in_a_row else "dialogue" if talks else "input", shown.shown
    if shown.expected is not None and not (in_a_row or talks):
        yield "expected", shown.expected
        if shown.got is not None and wrong:
            yield "got", shown.got
    if shown.printed:
        yield "printed", shown.printed
    plain = [f"{shown.expected} expected, {shown.got} {how}" for how in ("given", "got")]
    if shown.input is not None and shown.message not in plain:
        why = shown.message
    if wrong and why:
        yield "why", why
    if wrong and (small := result.counterexample) and small.replay is None:
        yield "alone", small.message


def _failing(result: Result) -> list[GroupResult]:
    return [group for group in result.groups if group.verdict is not Verdict.AC and group.run]


def _share(group: GroupResult) -> str:
    failed, rest = group.cases - group.passed - group.undecided, group.undecided
    share = f" {failed} of {group.cases}" if failed else ""  # else it fails as a whole
    return f"{group.name}{share}{f' ({rest} not judged)' if rest else ''}"


def _commands(problem: Problem | None, result: Result, shown: Failure | None) -> Iterator[tuple[str, str]]:
    if problem is None or result.verdict in (Verdict.AC, Verdict.CE, Verdict.JE):
        return
    if problem.has_hints:
        yield f"judge hint {typed(problem)}", "one hint"
    if shown and shown.replay:
        yield f"judge try {typed(problem)}", "runs this case alone"


def _last(result: Result) -> str:
    """What it comes to: the cases, the points, the level that was passed, what was not run."""
    if result.verdict is Verdict.JE:
        return result.failure.message if result.failure else ""
    if not result.groups:
        return "nothing was run"
    passed, cases = _passed(result)
    every = "the only case passes" if cases == 1 else f"all {cases:,} cases pass"
    share = every if passed == cases else f"{passed:,} of {counted(cases, 'case')} pass"
    only = f", on {result.partial} only" if result.partial else ""
    if result.verdict is Verdict.AC:
        return share + only
    skipped = sum(not group.run for group in result.groups)
    ends = {group.verdict.meaning for group in result.groups if not group.run} - {result.verdict.meaning}
    ended = f": {', '.join(sorted(ends))}" if ends else ""
    parts = [level_text(result.levels) or share, _points(result)]
    parts += [f"{counted(skipped, 'group')} not run{ended}"] if skipped else []
    return ", ".join(filter(None, parts)) + only


def _passed(result: Result) -> tuple[int, int]:
    """The cases that passed, and all of them."""
    return sum(each.passed for each in result.groups), sum(each.cases for each in result.groups)


def looking(result: Result) -> str:
    """What is known of a failure as long as it is being explained."""
    passed, cases = _passed(result)
    sought = "the line" if result.counterexample else "the smallest that fails"
    return f"{passed:,} of {counted(cases, 'case')} pass. Looking for {sought} …"


def _points(result: Result) -> str:
    if result.score < result.points:
        return f"{result.score} of {counted(result.points, 'point')}"
    extra = f"extra groups that fail: {len(_failing(result))}"
    return f"all {counted(result.points, 'point')}; {extra}" if result.points else ""


def level_text(levels: Sequence[LevelResult]) -> str:
    """`Interview level passed; production: 9 of 23 groups`; nothing where no level was passed, or all are."""
    said = [f"{each.level.value.capitalize()} level passed" for each in levels if each.passed]
    rest = [f"{each.level.value}: {level_share(each)}" for each in levels if not each.passed]
    return "; ".join([*said, *rest]) if said and rest else ""


def level_share(result: LevelResult) -> str:
    """`passed`, `22 of 36 groups`, or that it was not judged."""
    if result.passed or not result.run:
        return "passed" if result.passed else "not judged"
    judged = f", {result.run} judged" if result.run < result.groups else ""
    return f"{result.accepted} of {counted(result.groups, 'group')}{judged}"


# As judge.sandbox.inside.child writes an exception, which may have such words in its own text before, or the
# place where a call stood that did not end.
_RAISED = re.compile(
    r".*\(line (\d{1,9})\)(?:$|, after |, when |, in call |; its input|; it was run as a program)"
)


class FilePlace(Struct, frozen=True):
    """A line of a file, and a column where it is known; both from 1, 0 for unknown."""

    line: int
    column: int = 0


def fault_place(result: Result) -> FilePlace | None:
    """Where a submission does not compile, raised its exception or stood when its time was up.

    Its failure's message says so.
    """
    failure = _ended(result)
    message = failure.message if failure else ""
    if result.verdict is Verdict.CE:
        found = _COMPILED.search(message)
        return FilePlace(int(found[1]), int(found[2] or 0)) if found else None
    found = _RAISED.match(message) if result.verdict in (Verdict.RTE, Verdict.TLE) else None
    return FilePlace(int(found[1])) if found else None


def annotated_place(result: Result, source: bytes, entry: str) -> FilePlace:
    """Where to show a person the result: at the fault, else at the entry function, else at the top.

    A line that the file does not have, which an exception's text may claim, is not believed.
    """
    place = fault_place(result)
    if place is not None and place.line <= source.count(b"\n") + 1:
        return place
    name = re.escape(entry.encode())
    # Not by parsing: the file is nobody's yet, and a compiler can be made to crash.
    defined = re.search(rb"^(?:async[ \t]+)?(?:def[ \t]+%s\b|%s[ \t]*(?::.*)?=)" % (name, name), source, re.M)
    return FilePlace(source.count(b"\n", 0, defined.start()) + 1 if defined and entry else 1)

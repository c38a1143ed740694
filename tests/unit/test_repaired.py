"""What is said of a repair: a name where it is sure, else the line; never against what is proved."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from judge.mistakes.catalogue import KindWords, MistakeText
from judge.mistakes.computed import ComputedProgram
from judge.mistakes.family import Maker
from judge.mistakes.likeness import Known, Likeness
from judge.mistakes.repaired import SEEN, Repaired, with_steps
from judge.problem import Verdict
from judge.repair.changed import WAYS
from judge.repair.edits import KINDS as EDITS
from judge.repair.search import Repair, Step
from judge.report.tell import mistake_text
from judge.run.result import Answers, Pitfall, Result

CASES = 40
KINDS = {
    "room": KindWords("No room for {which}.", ("no-room", "other-room")),
    "rounding": KindWords("Rounding alone.", ("rounds",)),
    "fresh": KindWords("Kept.", ("keeps",)),
    "guard-same": KindWords("{which} is wrong.", ()),
    "sign": KindWords("A sign.", ()),
}
RESULT = Result(problem="sum", submission="a.py", verdict=Verdict.WA)


def one(count):
    return ("count", (float(count),))


def known(name, wrong, count=1):
    maker = Maker(name, "", f"why {name}", MistakeText(), ComputedProgram(b"", ""))
    return Known(maker, {"g": Answers(CASES, {case: one(count) for case in wrong})})


def asked(wrong):
    group = SimpleNamespace(group=SimpleNamespace(name="g"))
    return SimpleNamespace(
        all=[SimpleNamespace(group=group, place=case) for case in range(CASES)], wrong=[*wrong]
    )


def said(repair, *programs, wrong=range(10), today=None, few=False):
    """The pitfall of a program that answers 1 in these cases, and is right after those steps."""
    cases = asked(wrong)
    does = {"g": Answers(CASES, {case: one(1) for case in wrong})}
    made = Repair(cases=cases, **repair)
    result = Result(problem="sum", submission="a.py", verdict=Verdict.WA, pitfall=today)
    return with_steps(result, Repaired(made, Likeness(programs, does), KINDS, few=few)).pitfall


def whole(*steps, **more):
    return {"whole": (tuple(Step(kind, line, frozenset(gone)) for kind, line, gone in steps),), **more}


def test_a_name_is_told_where_its_failures_are_those_that_go():
    found = said(whole(("room", 7, range(10))), known("no-room", range(10)), known("far", range(20, 30)))
    assert (found.names, found.advice) == (("no-room",), ("why no-room",))
    assert [(step.name, step.line, step.gone, step.of) for step in found.steps] == [("no-room", 7, 10, 10)]


@pytest.mark.parametrize(
    "programs",
    [
        [],
        [known("no-room", range(4))],  # too few of them
        [known("no-room", range(30))],  # and many others
        [known("no-room", range(10)), known("twin", range(10))],  # another one has them, too
        [known("no-room", range(10), count=2)],  # another answer
    ],
)
def test_else_the_line_alone_is(programs):
    found = said(whole(("room", 7, range(10)), rounding=True), *programs)
    assert found.names == ()
    assert [(step.name, step.line, step.why) for step in found.steps] == [(None, 7, "No room for .")]


def test_too_few_failures_are_like_nothing():
    found = said(whole(("room", 7, range(4))), known("no-room", range(4)), wrong=range(4))
    assert found.names == ()


def test_a_name_that_the_kind_does_not_know_must_be_far_ahead():
    far = known("far", range(8))
    assert said(whole(("sign", 3, range(10))), far).names == ("far",)
    assert said(whole(("sign", 3, range(10))), far, known("near", range(7))).names == ()


def test_what_is_wrong_on_paper_has_no_name_of_rounding_by_likeness():
    alike, same = known("rounds", range(8)), known("rounds", range(10))
    step = whole(("sign", 3, range(10)))
    assert said(step, alike).names == ("rounds",)
    today = Pitfall(("rounds",), 0.8, ("words",))
    for given in (None, today):
        assert said({**step, "wrong_on_paper": True}, alike, today=given).names == ()
    assert said({**step, "wrong_on_paper": True}, same).names == ("rounds",)  # all of its answers


def test_a_weak_kind_is_not_told_of_few_failures():
    for kind, why in (("dropped", SEEN["line"]), ("sign", "A sign.")):
        found = said(whole((kind, 3, range(3))), wrong=range(3))
        assert [step.why for step in found.steps] == [why]


def test_the_name_that_is_known_already_gets_the_line():
    today = Pitfall(("far",), 0.9, ("why far",))
    found = said(whole(("sign", 3, range(10))), known("far", range(8)), today=today)
    assert (found.names, found.advice) == (("far",), ("why far",))
    assert [(step.name, step.line) for step in found.steps] == [("far", 3)]


def test_where_answers_are_few_a_name_must_be_the_kinds_own_and_nearly_all_the_same():
    far, near = known("far", range(8)), known("no-room", range(8))
    assert said(whole(("sign", 3, range(10))), far, few=True).names == ()
    assert said(whole(("room", 3, range(10))), near).names == ("no-room",)
    assert said(whole(("room", 3, range(10))), near, few=True).names == ()
    assert said(whole(("room", 3, range(10))), known("no-room", range(10)), few=True).names == ("no-room",)


def test_what_is_proved_is_not_contradicted():
    today = Pitfall(("far",), 0.9, ("words",))
    found = said(whole(("rounding", 5, range(10)), rounding=True), today=today)
    assert found.names == ()
    assert [step.why for step in found.steps] == ["Rounding alone."]
    kept = Pitfall(("rounds",), 0.9, ("words",))
    assert said(
        whole(("rounding", 5, range(10)), rounding=True), known("rounds", range(10)), today=kept
    ).names == ("rounds",)


def test_a_comparison_that_rounding_turns_is_no_mistake_of_its_line():
    steps = whole(("rounding:turns", 5, range(10)), rounding=True)
    assert mistake_text(said(steps), "a.py") == "Mistake found: rounding"
    assert mistake_text(said(whole(("sign", 5, range(10)))), "a.py") == "A change in line 5 makes it right"


def test_state_is_named_only_where_a_fresh_process_proves_it():
    keeps = known("keeps", range(10))
    assert said({"ways": ("fresh",)}, keeps).names == ("keeps",)
    assert said(whole(("sign", 3, range(10))), keeps).names == ()


def test_what_is_kept_in_a_way_that_nobody_knows_is_told_in_the_kinds_words():
    assert said({"ways": ("fresh",)}, known("keeps", range(2))).advice == ("Kept.",)


def test_of_three_steps_only_the_lines_are_told_and_what_is_proved():
    steps = whole(("room", 7, range(4)), ("sign", 4, range(4, 7)), ("rounding", 9, range(7, 10)))
    told = [(step.line, step.why) for step in said(steps).steps]
    assert told == [(7, ""), (4, ""), (9, "Rounding alone.")]


def test_each_step_has_its_own_name():
    steps = whole(("room", 7, range(6)), ("guard-same:A=B", 4, range(6, 10)))
    found = said(steps, known("no-room", range(6)), known("far", range(20, 30)))
    assert found.names == ("no-room",)
    assert [(step.name, step.why) for step in found.steps] == [
        ("no-room", "No room for ."),
        (None, "A = B is wrong."),
    ]


@pytest.mark.parametrize("score", [0.9, 0.99])
def test_a_name_that_no_step_bears_out_is_kept_only_where_nearly_all_is_the_same(score):
    today = Pitfall(("far",), score, ("words",))
    found = said(whole(("room", 7, range(6)), ("sign", 4, range(6, 10))), today=today)
    if score > 0.98:
        assert found == today
    else:
        assert (found.names, [step.line for step in found.steps]) == ((), [7, 4])


def test_a_name_of_the_kind_gives_way_where_another_one_is_more_alike():
    programs = known("no-room", range(7)), known("far", range(8))
    assert said(whole(("room", 7, range(10))), *programs).names == ()


def test_of_equal_repairs_the_line_is_told_that_most_of_them_change():
    def lines(*given):
        chains = tuple((Step("sign", line, frozenset(range(10))),) for line in given)
        return [step.line for step in said({"whole": chains}).steps]

    assert lines(3, 5, 5) == [5]
    assert lines(3, 3, 5) == [3]


def test_a_line_is_told_before_a_way_that_has_none():
    found = said(whole(("name", 7, range(10)), ways=("moved",)))
    assert [(step.kind, step.line) for step in found.steps] == [("name", 7)]


def test_a_step_on_which_nothing_hangs_is_not_told():
    found = said(whole(("room", 7, range(10)), ("sign", 4, ())))
    assert [step.line for step in found.steps] == [7]


def test_a_very_likely_name_is_told_with_its_own_steps_alone():
    steps = whole(("room", 7, range(6)), ("room", 7, range(6, 8)), ("sign", 4, range(8, 10)))
    programs = known("no-room", range(8)), known("far", range(20, 30))
    sure = said(steps, *programs, today=Pitfall(("no-room",), 0.95, ("a",)))
    assert [(step.name, step.line, step.gone) for step in sure.steps] == [("no-room", 7, 6)]
    likely = said(steps, *programs, today=Pitfall(("no-room",), 0.6, ("a",)))
    assert [(step.name, step.line) for step in likely.steps] == [("no-room", 7), (None, 7), (None, 4)]


def test_of_a_part_only_the_line_is_told():
    part = (Step("sign", 3, frozenset(range(6))),)
    found = said({"part": part}, known("far", range(6)))
    assert [(step.name, step.line, step.gone, step.why) for step in found.steps] == [(None, 3, 6, "")]
    assert said({"part": (Step("sign", 3, frozenset(range(4))),)}) is None
    assert said({}) is None


def test_no_name_is_told_whose_program_does_not_fail_the_case_that_is_shown():
    made = Repair(cases=asked(range(10)), **whole(("sign", 7, range(10))))
    does = {"g": Answers(CASES, {case: one(1) for case in range(10)})}
    repaired = Repaired(made, Likeness([known("far", range(10))], does), KINDS, few=False)
    assert with_steps(RESULT, repaired, lambda _: True).pitfall.names == ("far",)
    told = with_steps(RESULT, repaired, lambda _: False).pitfall
    assert (told.names, [step.line for step in told.steps]) == ((), [7])


def seen(*chains, **more):
    found = said({"whole": tuple((Step(*each, frozenset(range(10))),) for each in chains), **more})
    return [step.why for step in found.steps]


def test_only_the_line_is_told_where_it_is_not_proved_what_is_wrong_in_it():
    assert seen(("sign", 3)) == ["A sign."]
    assert seen(("sign", 3), ("name", 3)) == [SEEN["line"]]
    assert seen(("sign", 3), ("sign", 3), ("name", 4)) == ["A sign."]
    assert seen(("guard-same:A=B", 3), ("name", 3)) == ["A = B is wrong."]
    assert seen(("room", 3)) == [SEEN["line"]]  # it is wrong without rounding as well
    assert seen(("room", 3), tolerance=True) == ["No room for ."]


def test_a_pack_without_words_gets_those_of_every_topic():
    assert seen(("turned", 3)) == [SEEN["turned"]]
    assert {*EDITS, *WAYS, "rounding", "once", "filter", "order", "guard-same", "guard-zero"} <= {*SEEN}


def test_a_later_step_is_not_named_after_a_mistake_that_fails_what_is_right_before_it():
    steps = whole(("sign", 7, range(6)), ("name", 9, range(6, 12)))
    programs = known("near", range(6, 12)), known("far", range(12))
    assert said(steps, programs[0], wrong=range(12)).names == ("near",)
    told = said(steps, programs[1], wrong=range(12)).steps
    assert [(step.name, step.line) for step in told] == [("far", 7), (None, 9)]


def test_of_a_change_in_two_lines_and_one_in_a_single_line_the_second_is_told():
    """Of all tolerances at once, say, of which one alone does harm."""
    both, alone = (
        (Step("tolerance-smaller", *place),)
        for place in ((7, frozenset(range(10)), 2), (15, frozenset(range(10))))
    )
    found = said({"whole": (both, alone), "tolerance": True})
    assert [(step.line, step.why) for step in found.steps] == [(15, SEEN["tolerance-smaller"])]
    found = said({"whole": (both,), "tolerance": True})
    assert [(step.line, step.why) for step in found.steps] == [(7, SEEN["tolerances"])]


def test_a_part_that_spoils_other_cases_is_not_told():
    part = (Step("without", 7, frozenset(range(10))),)
    assert said({"part": part, "broken": 1}) is None
    assert said({"part": part}).steps[0].line == 7


def test_that_the_rest_is_rounding_takes_no_words_from_the_line_where_it_happens():
    assert seen(("sign", 3), ("rounding:loses", 3)) == ["A sign."]
    assert seen(("tolerance-smaller:turns", 3), tolerance=True) == [SEEN["tolerance-smaller-turns"]]


def test_two_steps_of_one_kind_in_one_line_are_one():
    """Both ends of a comparison, say."""
    found = said(whole(("room", 7, range(6)), ("room", 7, range(6, 10))))
    assert [(step.line, step.gone, step.of) for step in found.steps] == [(7, 10, 10)]


def test_a_line_that_was_made_to_fit_some_cases_and_then_others_is_not_told():
    constants = tuple(Step("constant", 7, frozenset(gone)) for gone in (range(5), range(5, 9)))
    assert said({"part": constants}) is None
    apart = constants[0], Step("constant", 8, constants[1].gone)
    assert [step.line for step in said({"part": apart}).steps] == [7, 8]

"""The record of all behaviour holds: every day a sample of each kata and each kind, by night all of it."""

from __future__ import annotations

import json
import re

import pytest
from record import programs, transcripts
from record.compare import differences
from record.parts import Item, kept, keys, now
from record.programs import Program
from sampling import daily, nightly

from judge.problem.find import all_problems, find_problem
from judge.problem.level import KataLevel

pytestmark = pytest.mark.slow

KATAS = keys("programs")
KINDS = ("accepted", "wrong", "mistake", "slow", "textbook", "everyday", "changed", "edge", "challenge")
BY_DAY = 2  # programs of each kata
AT_NIGHT = re.compile(r"(?!count/)[^/]+/slow/|nearest/textbook/")  # half a minute and more each
DRAWN = ("count", "segment", "polygon", "csg", "sphere", "swept-wall", "silhouette")  # a kata for each kind


@pytest.fixture(autouse=True)
def _cache(built, monkeypatch):
    monkeypatch.setenv("JUDGE_CACHE", str(built))


def unchanged(item, fresh):
    """Nothing of it differs from what was kept; `python -m tests.record` says the same."""
    stale = kept(item)
    assert stale, f"{item.path} is missing: python -m tests.record {item.part} --only {item.key} --write"
    assert list(differences(stale, fresh)) == []


def sampled(kata: str, number: int) -> list[Program]:
    """Programs of kinds that take turns from kata to kata, Python's own."""
    found: dict[str, Program] = {}
    for program in programs.programs(kata):
        if program.name.endswith(".py") and not AT_NIGHT.match(program.key):
            found.setdefault(program.key.split("/")[1], program)
    kinds = [kind for kind in KINDS if kind in found]
    return [found[kinds[(number + turn) % len(kinds)]] for turn in range(min(BY_DAY, len(kinds)))]


@pytest.mark.parametrize(("number", "kata"), [*enumerate(KATAS)], ids=KATAS)
def test_a_sample_of_programs_is_judged_as_it_was(number, kata):
    chosen = sampled(kata, number)
    stale = kept(Item("programs", kata))
    fresh = json.loads(json.dumps(programs.record(kata, chosen)))
    assert list(differences({each.key: stale[each.key] for each in chosen}, fresh)) == []


@pytest.mark.nightly
@pytest.mark.parametrize("kata", KATAS)
def test_all_programs_are_judged_as_they_were(kata):
    unchanged(Item("programs", kata), now(Item("programs", kata), None))


@pytest.mark.parametrize("kata", daily(KATAS, DRAWN))
def test_pictures_are_as_they_were(kata):
    if problem_has_pictures(kata):
        unchanged(Item("pictures", kata), now(Item("pictures", kata), None))
    else:
        assert kept(Item("pictures", kata)) == {}


def problem_has_pictures(kata):
    from judge.data.module import load_module

    return load_module(find_problem(kata)).topic.picture is not None


@pytest.mark.parametrize("kata", daily(KATAS, ("count", "nearest")))
def test_packages_are_as_they_were(kata):
    unchanged(Item("packages", kata), now(Item("packages", kata), None))


def of_the_day(name: str) -> bool:
    return not name.startswith("screens/") or name.endswith("80x24")


@pytest.mark.parametrize(
    "name", [name if of_the_day(name) else nightly(name) for name in transcripts.names()]
)
def test_a_transcript_is_as_it_was(name, tmp_path, shared):
    item = Item("transcripts", name)
    unchanged(item, now(item, shared / "world" / name.replace("/", "-")))


# -- what the record says, whoever wrote it ------------------------------------------------------------------

RECORDED = {
    (key.split("/")[1], key): told for kata in KATAS for key, told in kept(Item("programs", kata)).items()
}


def of_kind(kind: str) -> dict[str, dict]:
    return {key: told for (each, key), told in RECORDED.items() if each == kind}


@pytest.mark.parametrize(
    ("kind", "verdicts"),
    [
        ("accepted", {"AC"}),
        ("wrong", {"WA", "RTE"}),
        ("mistake", {"WA", "RTE"}),
        ("slow", {"TLE"}),
        ("edge", {"WA"}),
    ],
)
def test_every_program_of_a_kind_has_its_verdict(kind, verdicts):
    programs = of_kind(kind)
    assert programs
    assert {key: told["verdict"] for key, told in programs.items() if told["verdict"] not in verdicts} == {}


@pytest.mark.parametrize("kind", ["everyday", "changed"])
def test_a_file_that_is_called_like_a_mistake_is_given_its_name(kind):
    """Its name is that of the mistakes, joined by -and-; silent where no name fits."""
    mended = {}
    for key, told in of_kind(kind).items():
        stem = re.sub(r"(-\d)?\.py$", "", key.rpartition("/")[2])
        if stem == "right":
            continue
        names = told.get("names") or "silent"
        mended[key] = (stem.replace("-and-", " + "), " + ".join(sorted(names.split(" + "))))
    assert {key: pair for key, pair in mended.items() if pair[0] != pair[1]} == {}


def test_every_kata_of_two_levels_has_a_textbooks_program_that_passes_the_interview_only():
    levelled = {each.id for each in all_problems() if any(group.level for group in each.groups)}
    passed = {key.split("/")[0]: told for key, told in of_kind("textbook").items()}
    assert set(passed) == levelled
    for kata, told in passed.items():
        problem = find_problem(kata)
        assert told["levels"] == ["interview"], kata
        assert len(told["fails"]) >= (5 if len(problem.groups) > 16 else 2), kata
        assert {problem.group(name).level for name in told["fails"]} == {KataLevel.PRODUCTION}, kata


def test_the_challenge_is_answered_alike_in_three_languages():
    found = of_kind("challenge")
    assert len(found) == 3
    assert {told["names"] for told in found.values()} == {"absolute-epsilon"}
    assert len({json.dumps(told["fails"]) for told in found.values()}) == 1

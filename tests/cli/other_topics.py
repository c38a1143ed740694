"""The fixture katas of other topics, with what the judge must say of a mistake in each."""

from __future__ import annotations

import json
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from cli_support import ROOT
from jsonschema import Draft202012Validator

from judge.schema import schema_of

KATAS = ROOT / "tests" / "fixtures" / "katas"
PROBLEMS, SOLUTIONS = KATAS / "problems", KATAS / "solutions"

# What is said of circles and lines; a "line" of output is none of them.
_TOPIC = re.compile(
    r"\b(circles?|rays?|tangents?|tangency|segments?|extents?|radius|radii|chords?|secants?|intersections?"
    r"|straight line|infinite line|lines? and circles?|circle-line|figure)\b",
    re.IGNORECASE,
)
_BROKEN = re.compile(
    r"internal fault|\w*internal error|Traceback \(most recent|NotImplementedError(?! *\()", re.IGNORECASE
)


@dataclass(frozen=True)
class Kata:
    """A kata, the mistake that is looked at closely, and what is told of it.

    `program` changes the accepted program so that it makes a mistake too, whose name is `program_mistake`.
    """

    id: str
    entry: str
    answer: str
    right: str
    mistake: str
    smallest: dict[str, Any]
    wanted: str
    got: str
    why: str
    program: tuple[str, str]
    program_mistake: str | None
    printed: tuple[str, str]  # wanted and got of the smallest case, as programs print them
    called: str  # the smallest case as a person reads it
    fresh: dict[str, Any] | None = None  # what stress finds, where that is another mistake's smallest case
    own: tuple[str, ...] = ()  # words of the kata's own statement or types

    @property
    def accepted(self) -> Path:
        return SOLUTIONS / self.id / "accepted" / f"{self.right}.py"

    @property
    def accepted_program(self) -> Path:
        return SOLUTIONS / self.id / "accepted" / "program.py"

    @property
    def wrong(self) -> Path:
        return SOLUTIONS / self.id / "wrong" / f"{self.mistake}.py"

    @property
    def wrong_program(self) -> str:
        source, (old, new) = self.accepted_program.read_text(encoding="utf-8"), self.program
        assert source.count(old) == 1
        return source.replace(old, new)

    def sound(self, *texts: str) -> None:
        """No text has a word of another topic, or what a person must never see."""
        for text in texts:
            for word in (*self.own, '"extent": '):  # a key of [tolerance]
                text = text.replace(word, "")
            assert _TOPIC.findall(text) == [], text
            assert _BROKEN.findall(text) == [], text


TABLE = [
    Kata(
        id="divisors",
        entry="divisors",
        answer="[int; 1..240]",
        right="trial",
        mistake="as-found",
        smallest={"n": 4},
        wanted="[1, 2, 4]",
        got="[1, 4, 2]",
        why="the right items in the wrong order: the divisors come smallest first",
        program=("range(1, n + 1) if n % each == 0]", "range(1, n) if n % each == 0] or [1]"),
        program_mistake="proper-ones",
        printed=("2 1 2", "1 1"),
        called="n=4",
    ),
    Kata(
        id="positive-root",
        entry="positive_root",
        answer="real?",
        right="formula",
        mistake="two-roots-only",
        smallest={"b": -2, "c": 1},
        wanted="1.0",
        got="None",
        why="None given, a positive root is there: x = 1.0",
        program=("min((root", "max((root"),
        program_mistake="larger-root",
        printed=("0.38196601125010515", "2.618033988749895"),
        called="b=-2, c=1",
    ),
    Kata(
        id="unit-vector",
        entry="unit_vector",
        answer="vec3",
        right="hypot",
        mistake="flat",
        smallest={"v": [0, 1, 1]},
        wanted="(0.0, 0.7071067811865476, 0.7071067811865476)",
        got="(0.0, 1.0, 1.0)",
        why="y is off by 0.29, relative error 0.41 (2.64e+15 ulps)",
        program=("hypot(*v) for", "sum(map(abs, v)) for"),
        program_mistake="sum-of-parts",
        printed=("0.0 0.7071067811865476 0.7071067811865476", "0.0 0.5 0.5"),
        called="v=(0, 1, 1)",
    ),
    Kata(
        id="larger-fraction",
        entry="compare",
        answer="word(less|equal|more)",
        right="crosswise",
        mistake="sign-forgotten",
        smallest={"p": [0, -1], "q": [1, 1]},
        wanted="'less'",
        got="'more'",
        why="'less' wanted, 'more' given",
        program=(" * b * d", ""),
        program_mistake="sign-forgotten",
        printed=("less", "more"),
        called="p=(0, -1), q=(1, 1)",
    ),
    Kata(
        id="by-size",
        entry="by_size",
        answer="([(int, word(even|odd)); 0..8], int?)",
        right="sorted",
        mistake="remainder",
        smallest={"numbers": [-1]},
        wanted="([(0, 'odd')], 1)",
        got="([(0, 'even')], 1)",
        why="part 2 of item 1 of part 1: 'odd' wanted, 'even' given",
        program=("(sizes[place], -place)", "(numbers[place], -place)"),
        program_mistake=None,  # of several right sizes it takes others than the known mistakes do
        printed=("2 0 even 1 odd 0", "2 1 odd 0 even 1"),
        called="numbers=[-1]",
    ),
    Kata(
        id="root-enclosed",
        entry="enclose",
        answer="enclosure",
        right="isqrt",
        mistake="one-wide",
        smallest={"n": 0, "digits": 1},
        wanted="an interval around 0.0 at most 0.1 wide",
        got="(0, 1)",
        why="it is 1 wide, 0.1 is allowed",
        program=("(low, low + 1)", "(low + 1, low + 2)"),
        program_mistake=None,  # it is none of the wrong programs' mistakes
        printed=("0.0 0.0", "0.1 0.2"),
        called="n=0, digits=1",
    ),
    Kata(
        id="rises",
        entry="rises",
        answer="array(i8; 100000)",
        right="pairs",
        mistake="no-standstill",
        smallest={"xs": [0.0]},
        wanted="[0]",
        got="[-1]",
        why="item 1: 0 wanted, -1 given",
        program=("len(xs), *((b > a) - (b < a)", "len(xs), *((1 if b > a else -1)"),
        program_mistake="no-standstill",
        printed=("1 0", "1 -1"),
        called="xs=[0.0]",
    ),
    Kata(
        id="lamps",
        entry="first_lamp",
        answer="int?",
        right="squares",
        mistake="last-one",
        smallest={"lamps": [[0, 1, 0], [0, 0, 0], [0, 0, 0]]},
        wanted="1",
        got="2",
        why="1 wanted, 2 given",
        program=("<= r * r", "< r * r"),
        program_mistake="border-dark",
        printed=("1", "none"),
        called="lamps=[(0, 1, 0), (0, 0, 0), (0, 0, 0)]",
        fresh={"lamps": [[0, 0, 0], [0, 0, 0]]},
        own=("[circle; 1..6]", "Circle"),
    ),
]
BY_ID = {kata.id: kata for kata in TABLE}


def checked(command: str, out: str) -> list[Any]:
    """The objects that a command wrote, each valid by its schema."""
    validator = Draft202012Validator(schema_of(command))
    objects = [json.loads(line) for line in out.splitlines()]
    assert objects
    for each in objects:
        validator.validate(each)
    return objects

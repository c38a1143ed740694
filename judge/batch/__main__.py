"""A class in parts, on machines that share no network: `python -m judge.batch shard|merge`.

    python -m judge.batch shard K/N FOLDER     judges part K of N, into FOLDER.judge.K-of-N.sqlite3
    python -m judge.batch merge FOLDER PART... puts the parts together, into FOLDER.judge.sqlite3

`judge class FOLDER` then shows the class. The options that decide a verdict must be the same in both.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from judge.batch.folder import root_of
from judge.batch.run import Classroom
from judge.batch.shards import Shard, merged
from judge.batch.store import Store, store_of
from judge.errors import ExitCode, JudgeError
from judge.judging.pool import Here, Processes
from judge.problem.model import LEVELS
from judge.report.screen import note
from judge.sandbox.boundary import LEVELS as ISOLATION


def main(words: list[str] | None = None) -> int:
    """Do what the words of the command line ask for; the exit status, as that of judge class."""
    asked = _parser().parse_args(words)
    try:
        root_of(asked.folder)  # before a file is made beside it
        return _merge(asked) if asked.what == "merge" else _shard(asked)
    except JudgeError as fault:
        note(str(fault))
        return fault.exit_code
    except KeyboardInterrupt:
        return ExitCode.INTERRUPTED


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser("python -m judge.batch", description="Judge a class in parts.")
    each = parser.add_subparsers(dest="what", required=True)
    shard = each.add_parser("shard", help="judge part K of N")
    shard.add_argument("part", metavar="K/N")
    shard.add_argument("folder", metavar="FOLDER", type=Path)
    shard.add_argument("-j", "--jobs", type=int, default=1, metavar="N", help="judge N files at once")
    shard.add_argument("--students", type=Path, metavar="CSV", help="the list of students")
    shard.add_argument("--level", choices=LEVELS, help="only this level of each kata")
    shard.add_argument("--isolation", choices=ISOLATION, help="demand this level of isolation")
    shard.add_argument("--problems", type=Path, action="append", default=[], metavar="DIR")
    merge = each.add_parser("merge", help="put the parts together")
    merge.add_argument("folder", metavar="FOLDER", type=Path)
    merge.add_argument("parts", metavar="PART", nargs="+", type=Path)
    return parser


def _shard(asked: argparse.Namespace) -> int:
    shard = Shard.read(asked.part)
    with Store.open(shard.beside(store_of(asked.folder))) as store:
        classroom = Classroom(
            asked.folder,
            store,
            students=asked.students,
            folders=asked.problems,
            isolation=asked.isolation,
            level=asked.level,
            shard=shard,
            say=note,
        )
        for row in classroom.judge(Processes(asked.jobs) if asked.jobs > 1 else Here()):
            line = f"{row.verdict.value} {row.score} {row.file}\n"
            sys.stdout.write(line.encode("ascii", "backslashreplace").decode())
        return classroom.cohort().exit_code


def _merge(asked: argparse.Namespace) -> int:
    with Store.open(store_of(asked.folder)) as store:
        for said in merged(store, asked.parts):
            note(said)
    return ExitCode.ACCEPTED


if __name__ == "__main__":
    sys.exit(main())

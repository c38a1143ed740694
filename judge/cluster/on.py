"""The executor that `--on WHERE` names."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path

from judge.cluster.greeting import offered
from judge.cluster.keys import read_keys
from judge.cluster.ring import Ring
from judge.cluster.where import Address, read_where
from judge.problem import Problem


@contextmanager
def executor_at(
    where: str,
    problems: Sequence[Problem],
    *,
    level: str | None = None,
    keys: Path | None = None,
    say: Callable[[str], None] = lambda _: None,
) -> Iterator[Ring]:
    """The workers at WHERE, each known to judge those problems as this machine does, at that level.

    `keys` is the folder of keys, where it is not the usual one. `say` is told what a person should know.

    Raises:
        UsageError: WHERE is no such place, distributed is not installed, or a worker differs.
        JudgeError: the scheduler cannot be reached, or has no workers.
    """
    place, wait = read_where(where), 0.0
    wanted = offered(problems, (level,) if level else ())
    with ExitStack() as stack:
        if isinstance(place, Address):
            address, held = place, read_keys(keys) if place.safe else None
        elif place.by == "ssh":
            from judge.cluster import ssh

            assert place.file is not None
            address, held = stack.enter_context(ssh.started(place.file, say))
        else:
            from judge.cluster import slurm

            config = slurm.read_config(place.file)
            address, held = stack.enter_context(slurm.started(config))
            wait = config.wait
        yield stack.enter_context(Ring(address, held, wanted, wait=wait, say=say))

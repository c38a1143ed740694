"""A judge that is killed at any moment leaves nothing alive a second later."""

from __future__ import annotations

import json
import os

import pytest
from residents import CROWD, RIGHT, WRONG, Resident

KILLS = int(os.environ.get("JUDGE_KILLS", "20"))  # in all, for both users and levels together
SEED = int(os.environ.get("JUDGE_KILLS_SEED", "1"))
SECONDS_EACH = 40


@pytest.mark.parametrize("level", ["full", "strong"])
def test_nothing_is_alive_a_second_after_a_kill_at_a_random_moment(resident: Resident, level: str) -> None:
    resident.require(level)
    files = resident.submissions(
        resident.home / "killed",
        right=RIGHT,
        wrong=WRONG,
        works=f"{RIGHT}while True: pass\n",
        sleeps=f"import time\n{RIGHT}time.sleep(60)\n",
        crowd=CROWD,
        deaf=f"import signal\nfor n in 2, 15: signal.signal(n, signal.SIG_IGN)\n{RIGHT}while True: pass\n",
    )
    script = str(resident.attacker.home / "security" / "kills.py")
    count = max(1, KILLS // 4)
    ended = resident.run([script, str(count), str(SEED), level, *files], seconds=count * SECONDS_EACH)
    assert ended.returncode == 0, ended.stderr[-2000:]
    found = json.loads(ended.stdout)
    assert found["survivors"] == []
    assert sum(found["ends"].values()) == count
    assert found["ends"].keys() & {"SIGKILL", "SIGINT"}, "none was under way when its end came"

"""Problems with the arguments (circles, rays) or (circles, O, directions), all of them whole numbers.

MANY    their topic
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from judge.problem.topic import Shown, Topic

if TYPE_CHECKING:
    from judge.drawing import Picture


def _picture(shown: Shown) -> Picture | None:
    from judge.topics.circles.picture.crowded import crowded  # late: most problems are judged, not drawn

    return crowded(shown)


MANY = Topic(picture=_picture)

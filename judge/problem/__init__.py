"""What a problem is, and the words it is judged in."""

from judge.problem.model import (
    Case as Case,
)
from judge.problem.model import (
    Example as Example,
)
from judge.problem.model import (
    Group as Group,
)
from judge.problem.model import (
    GroupLimits as GroupLimits,
)
from judge.problem.model import (
    GrowthRule as GrowthRule,
)
from judge.problem.model import (
    Parameter as Parameter,
)
from judge.problem.model import (
    Problem as Problem,
)
from judge.problem.model import (
    Tier as Tier,
)
from judge.problem.model import (
    TimeRule as TimeRule,
)
from judge.problem.model import (
    Verdict as Verdict,
)
from judge.values.answers import Tolerance as Tolerance

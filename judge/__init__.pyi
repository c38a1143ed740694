from judge.errors import JudgeError as JudgeError
from judge.errors import ProblemError as ProblemError
from judge.errors import ShortageError as ShortageError
from judge.errors import UsageError as UsageError
from judge.judging import Job as Job
from judge.judging import RunOptions as RunOptions
from judge.judging.api import judge as judge
from judge.judging.session import Session as Session
from judge.problem.find import find_problem as find_problem
from judge.run.result import Result as Result

__version__: str

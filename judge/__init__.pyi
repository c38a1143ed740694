from judge.judging.job import Job as Job
from judge.judging.job import Terms as Terms
from judge.judging.public import judge as judge
from judge.run.result import Result as Result

__version__: str

"""Studies: many variants of a case in one table, here or on many machines, in a store that survives any kill.

`orbearing.study(case, {...})` computes one; `orbearing.open_study(folder)` reads one; `python3 -m orbearing.studies` is the command.
"""

from orbearing.studies.result import StudyResult, open_study
from orbearing.studies.run import study

__all__ = ["StudyResult", "open_study", "study"]

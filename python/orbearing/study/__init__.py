"""Studies: many variants of a case in one table, here or on many machines, in a store that survives any kill.

`orbearing.study(case, {...})` computes one; `orbearing.study.open_study(folder)` reads one; `python3 -m orbearing.study` is the command.
"""

from __future__ import annotations

import sys
import types

from orbearing.study.result import StudyResult, open_study
from orbearing.study.run import study

__all__ = ["StudyResult", "open_study", "study"]


class _Study(types.ModuleType):
    """The module is the function too: `import orbearing.study` must not hide `orbearing.study(...)`."""

    __call__ = staticmethod(study)


sys.modules[__name__].__class__ = _Study

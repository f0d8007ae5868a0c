"""Studies: many variants of a case in one table, here or on many machines, in a store that survives any kill.

`orbearing.study(case, {...})` computes one; `orbearing.study.open_study(folder)` reads one; `python3 -m orbearing.study` is the command.
"""

from __future__ import annotations

import inspect
import sys
import types

from orbearing.study.result import StudyResult, open_study
from orbearing.study.run import study

__all__ = ["StudyResult", "open_study", "study"]


class _Study(types.ModuleType):
    """The module is the function too: whichever of both `orbearing.study` names, orbearing.study(case, {...}) and orbearing.study.open_study work."""

    __call__ = staticmethod(study)


_module = sys.modules[__name__]
_module.__class__ = _Study
__signature__ = inspect.signature(study)
__doc__ = f"{__doc__}\n\n{study.__doc__}"
study = _module

"""Results of a case tabulated over some of its inputs by `orbearing table`, with the error of each answer."""

from __future__ import annotations

import functools
import os
from typing import NamedTuple, Optional

import numpy as np

from orbearing import _core
from orbearing.errors import CaseError


class Answer(NamedTuple):
    """value: of each query, in the unit that ends the result's name; NaN where a computation failed.
    error: stated by the table, or scatter of a computed value, in the same unit.
    computed: whether the program computed the value; failures: reasons by the number of the query."""

    value: np.ndarray
    error: np.ndarray
    computed: np.ndarray
    failures: dict[int, str]


class Table:
    """The table of a folder: `table = Table("results/table")`, `table.life_h(speed="6000 rpm")`.

    Each result is a method. Its arguments are the inputs by the last part of their path, or by the whole path with _ for
    each dot: numbers in SI, texts with units, or arrays of them, which are broadcast. An input that is left out has the value of
    the table's case. A query outside the box, or where the stated error is above `bound`, is computed by the program;
    with compute=False it is refused. Returns an Answer.
    """

    def __init__(self, file):
        self._file = os.path.abspath(file)
        self._core = _core.CoreTable(str(file))
        self.inputs = {path: (low, high) for path, low, high in self._core.inputs()}
        self.results = tuple(self._core.results())
        self.bound = self._core.bound()
        self.case = self._core.case()
        self._own = {path: self.case.value(path) for path in self.inputs}
        self._paths = {}
        for path in self.inputs:
            last = path.rpartition(".")[2]
            alone = sum(other.rpartition(".")[2] == last for other in self.inputs) == 1
            self._paths.update({path.replace(".", "_"): path, **({last: path} if alone else {})})

    def __reduce__(self):
        return Table, (self._file,)

    def __getattr__(self, name: str):
        if name.startswith("_") or name not in self.results:
            raise AttributeError(f"the table has no result {name}; it has {', '.join(self.__dict__.get('results', ()))}")
        return functools.partial(self.answer, name)

    def answer(self, result: str, *, bound: Optional[float] = None, compute: bool = True, jobs: int = 0, **inputs) -> Answer:
        """A result by its name; see the class."""
        unknown = [name for name in inputs if name not in self._paths]
        if unknown:
            raise CaseError([f"{name}: found no input of the table; required: one of {', '.join(self._paths)}" for name in unknown])
        given = {self._paths[name]: value for name, value in inputs.items()}
        columns = [self._in_si(path, given.get(path, self._own[path])) for path in self.inputs]
        columns = np.broadcast_arrays(*columns)
        rows = np.stack([np.ravel(column) for column in columns], axis=1)
        value, error, computed, failures = self._core.answers(result, rows, bound, compute, jobs)
        shape = columns[0].shape
        return Answer(value.reshape(shape), error.reshape(shape), computed.astype(bool).reshape(shape), failures)

    def _in_si(self, path: str, value) -> np.ndarray:
        if isinstance(value, str):
            return np.asarray(self.case.si(path, value))
        values = np.asarray(value)
        if values.dtype.kind in "US":
            return np.reshape(self.case.si(path, [str(one) for one in values.ravel()]), values.shape)
        return values.astype(float)

    def __repr__(self) -> str:
        return f"<orbearing.Table {self.case.name()}: {', '.join(self.results)} over {', '.join(self.inputs)}>"

"""The program within Python by the C functions of its shared library (include/orbearing/c_interface.h), for any Python from 3.9 on."""

from __future__ import annotations

import ctypes
import json
import os
import sys
from ctypes import POINTER, byref, c_char_p, c_double, c_int, c_size_t, c_void_p
from pathlib import Path
from typing import Optional

import numpy as np

from orbearing.errors import CaseError, ComputationError

_PROGRESS = ctypes.CFUNCTYPE(c_int, c_size_t, c_size_t, c_char_p, c_void_p)
_Numbers = POINTER(c_double)


def _library_file() -> Path:
    """Of a wheel, a build folder, an installation, or as Debian has it. ORBEARING_LIBRARY names another one."""
    package = Path(__file__).absolute().parent
    named = os.environ.get("ORBEARING_LIBRARY")
    files = [Path(named)] if named else [package / "lib" / "liborbearing.so", package.parents[1] / "lib" / "liborbearing.so"]
    if package.parts[-4:-1] == ("share", "orbearing", "python") or package.parent.name == "dist-packages":
        files += [file for pattern in ("lib*", "lib/*") for file in sorted(package.parents[3].glob(f"{pattern}/liborbearing.so.1"))]
    for file in files:
        if file.exists():
            return file
    raise ImportError(f"no library of Orbearing in {', '.join(map(str, files))}; install Orbearing again, or build the target orbearing_library")


# Arguments of each function; all but those of _PLAIN return a failure or nothing.
_FUNCTIONS = {
    "use_python": (c_char_p, c_char_p),
    "case_read": (c_char_p, POINTER(c_void_p)),
    "case_with": (c_void_p, c_char_p, POINTER(c_void_p)),
    "case_without_sweep": (c_void_p, POINTER(c_void_p)),
    "case_query": (c_void_p, c_char_p, POINTER(c_void_p)),
    "request": (c_void_p, c_char_p, _PROGRESS, c_void_p, POINTER(c_void_p), POINTER(c_void_p)),
    "evaluate": (c_void_p, c_char_p, _Numbers, c_size_t, _PROGRESS, c_void_p, POINTER(c_void_p), POINTER(c_void_p)),
    "table_read": (c_char_p, POINTER(c_void_p)),
    "table_case": (c_void_p, POINTER(c_void_p)),
    "table_content": (c_void_p, POINTER(c_void_p)),
    "table_answers": (c_void_p, c_char_p, _Numbers, c_size_t, POINTER(c_void_p), POINTER(c_void_p)),
    "machine_make": (c_void_p, c_char_p, POINTER(c_void_p)),
    "machine_ports": (c_void_p, POINTER(c_void_p)),
    "machine_set_input": (c_void_p, c_char_p, c_double, _Numbers),
    "machine_input": (c_void_p, c_char_p, _Numbers),
    "machine_initialize": (c_void_p, c_double),
    "machine_advance": (c_void_p, c_double),
    "machine_output": (c_void_p, c_char_p, _Numbers),
    "machine_outputs": (c_void_p, POINTER(c_void_p), POINTER(c_size_t)),
    "machine_slope": (c_void_p, c_char_p, c_char_p, _Numbers),
    "machine_save": (c_void_p, POINTER(c_void_p), POINTER(c_size_t)),
    "machine_restore": (c_void_p, _Numbers, c_size_t),
}
_PLAIN = {
    "version": (c_char_p, ()),
    "instruction_set": (c_char_p, ()),
    "free": (None, (c_void_p,)),
    "command_line": (c_int, (c_int, POINTER(c_char_p))),
    "case_delete": (None, (c_void_p,)),
    "table_delete": (None, (c_void_p,)),
    "machine_delete": (None, (c_void_p,)),
    "machine_time": (c_double, (c_void_p,)),
}

_library = ctypes.CDLL(str(_library_file()))
for _name, _arguments in _FUNCTIONS.items():
    getattr(_library, f"orbearing_{_name}").argtypes = _arguments
    getattr(_library, f"orbearing_{_name}").restype = c_void_p
for _name, (_result, _arguments) in _PLAIN.items():
    getattr(_library, f"orbearing_{_name}").argtypes = _arguments
    getattr(_library, f"orbearing_{_name}").restype = _result
_free = _library.orbearing_free


def _bytes(text) -> bytes:
    """With the bytes of names of files that are not UTF-8."""
    try:
        return os.fsencode(text)
    except UnicodeEncodeError as error:
        raise CaseError(f"found the character {ascii(error.object[error.start])}; required: text in UTF-8") from None


def _taken(pointer: c_void_p) -> str:
    """A text of the library, which is given back."""
    try:
        return ctypes.string_at(pointer.value).decode("utf-8")
    finally:
        _free(pointer)


def _numbers(pointer: c_void_p, *shape: int) -> np.ndarray:
    """Numbers of the library as an array of their own."""
    count = int(np.prod(shape))
    try:
        return np.frombuffer(ctypes.string_at(pointer.value, 8 * count), dtype=float).reshape(shape).copy()
    finally:
        _free(pointer)


def _call(name: str, *arguments) -> None:
    """Calls a function of the library, which releases Python's lock meanwhile. Raises its failure."""
    failure = getattr(_library, f"orbearing_{name}")(*arguments)
    if failure is not None:
        _raise(**json.loads(_taken(c_void_p(failure))))


def _raise(kind: str, messages: list[str]) -> None:
    if kind == "input":
        raise CaseError(messages)
    raise {"computation": ComputationError, "interrupted": KeyboardInterrupt}.get(kind, RuntimeError)("\n".join(messages))


class _Watched:
    """A progress function for the library. What it raises stops the computation, and is raised behind the call."""

    def __init__(self, progress, whole: bool):
        self._raised, self._progress, self._whole = None, progress, whole
        self.function = _PROGRESS(self._report) if progress is not None else _PROGRESS()

    def _report(self, done, total, doing, _) -> int:
        try:
            if self._raised is None:
                self._progress(*((done, total, doing.decode("utf-8")) if self._whole else (done,)))
            return int(self._raised is not None)
        except BaseException as raised:  # pylint: disable=broad-except
            self._raised = raised
            return 1

    def __enter__(self):
        return self

    def __exit__(self, kind, value, traceback):
        if self._raised is not None:
            raise self._raised from None


class CoreCase:
    """A case with every value checked; it never changes."""

    def __init__(self, function: str, *arguments):
        self.handle = None
        handle = c_void_p()
        _call(function, *arguments, byref(handle))
        self.handle = handle

    def __del__(self, delete=_library.orbearing_case_delete):
        if getattr(self, "handle", None) is not None:
            delete(self.handle)

    def with_settings(self, settings):
        """A copy with values replaced, by (path, text as in a case file); what follows from them is derived anew."""
        return CoreCase("case_with", self.handle, _json([[path, str(text)] for path, text in settings]))

    def with_numbers(self, settings):
        """The same by (path, number in SI)."""
        return CoreCase("case_with", self.handle, _json([[path, float(number)] for path, number in settings]))

    def without_sweep(self):
        """The single operating point of its values."""
        return CoreCase("case_without_sweep", self.handle)

    def si(self, path: str, text):
        """A text, or each of many texts, for that input as the case's reader has it, in SI."""
        return _query(self.handle, of="si", path=path, text=text)

    def value(self, path: str):
        """The present value, in SI; None where there is none."""
        return _query(self.handle, of="value", path=path)

    def given(self, path: str):
        """The present value as written, with its unit; None where there is none."""
        return _query(self.handle, of="given", path=path)

    def inputs(self) -> list[dict]:
        """All inputs of this case: dicts of path, kind, unit (customary), si_unit, meaning, given, source and reason."""
        return _query(self.handle, of="inputs")

    def axes(self) -> dict[str, list[str]]:
        """Swept inputs and their values as written."""
        return _query(self.handle, of="axes")

    def resolved(self) -> str:
        """The resolved case as YAML, from which the same numbers follow."""
        return _query(self.handle, of="resolved")

    def source(self) -> dict:
        """What it was read from: name, text and the files that it names; parse() makes the same case of it."""
        return _query(self.handle, of="source")

    def without_effect(self, paths, fidelity: Optional[str] = None) -> dict[str, str]:
        """Of varied inputs, those without effect on this case, with a message each for users."""
        return _query(self.handle, of="without_effect", paths=list(paths), fidelity=fidelity or "")

    def stated_beside_designation(self, paths) -> list[str]:
        """A message for each varied designation beside which the case states ratings, or sizes of a cage, that would not vary with it."""
        return _query(self.handle, of="stated_beside_designation", paths=list(paths))

    def hash(self) -> str:
        """Of the resolved case."""
        return _query(self.handle, of="hash")

    def file(self) -> str:
        """As it was named."""
        return _query(self.handle, of="file")

    def name(self) -> str:
        """That the case gives itself."""
        return _query(self.handle, of="name")

    def model(self) -> str:
        """planetary-drivetrain, ball-bearing, ..."""
        return _query(self.handle, of="model")


class CoreTable:
    """Results of a case over some of its inputs, with errors."""

    def __init__(self, file: str):
        self._table = None
        table = c_void_p()
        _call("table_read", _bytes(file), byref(table))
        self._table, result = table, c_void_p()
        _call("table_content", table, byref(result))
        self._content = json.loads(_taken(result))

    def __del__(self, delete=_library.orbearing_table_delete):
        if getattr(self, "_table", None) is not None:
            delete(self._table)

    def case(self) -> CoreCase:
        """The case of the table."""
        return CoreCase("table_case", self._table)

    def bound(self) -> float:
        """Largest error of an answer."""
        return self._content["bound"]

    def results(self) -> list[str]:
        """Their names."""
        return self._content["results"]

    def inputs(self) -> list[tuple[str, float, float]]:
        """Path and range of each input, in SI."""
        return [tuple(row) for row in self._content["inputs"]]

    def answers(self, result: str, values, bound: Optional[float] = None, compute: bool = True,
                jobs: int = 0) -> tuple[np.ndarray, np.ndarray, np.ndarray, dict[int, str]]:
        """A result at rows of `values` (queries, inputs) [SI]: values, errors, which of them the program computed, and reasons of failures."""
        rows = np.ascontiguousarray(values, dtype=float)
        if rows.ndim != 2 or rows.shape[1] != len(self._content["inputs"]):
            raise CaseError("values: found an array of another shape; required: (queries, inputs of the table)")
        answers, failures = c_void_p(), c_void_p()
        _call("table_answers", self._table, _json({"result": result, "bound": bound, "compute": compute, "jobs": jobs}), rows.ctypes.data_as(_Numbers),
              len(rows), byref(answers), byref(failures))
        value, error, computed = _numbers(answers, len(rows), 3).T
        return value, error, computed, dict(json.loads(_taken(failures)))


class Machine:
    """A participant of the co-simulation in this process."""

    def __init__(self, case: CoreCase, model: str = "bearing"):
        self._machine = None
        machine = c_void_p()
        _call("machine_make", case.handle, _bytes(model), byref(machine))
        self._machine, self._ports = machine, None

    def __del__(self, delete=_library.orbearing_machine_delete):
        if getattr(self, "_machine", None) is not None:
            delete(self._machine)

    def _ports_of(self, kind: str) -> list[tuple[str, str, str]]:
        if self._ports is None:
            result = c_void_p()
            _call("machine_ports", self._machine, byref(result))
            self._ports = json.loads(_taken(result))
        return [tuple(row) for row in self._ports[kind]]

    inputs = property(lambda self: self._ports_of("inputs"))
    output_list = property(lambda self: self._ports_of("outputs"))
    time = property(lambda self: _library.orbearing_machine_time(self._machine))

    def set_input(self, name: str, value: float, slope=None) -> None:
        """In SI."""
        _call("machine_set_input", self._machine, _bytes(name), value, None if slope is None else c_double(slope))

    def input(self, name: str) -> float:
        """In SI."""
        return self._number("machine_input", _bytes(name))

    def initialize(self, time: float = 0.0) -> None:
        """Takes the inputs as they are."""
        _call("machine_initialize", self._machine, time)

    def advance(self, length: float) -> None:
        """By a time [s]."""
        _call("machine_advance", self._machine, length)

    def output(self, name: str) -> float:
        """In SI."""
        return self._number("machine_output", _bytes(name))

    def outputs(self) -> list[float]:
        """All of them."""
        return self._list("machine_outputs")

    def slope(self, output: str, input: str) -> float:  # pylint: disable=redefined-builtin
        """Of an output by an input, the inner state held."""
        return self._number("machine_slope", _bytes(output), _bytes(input))

    def save(self) -> list[float]:
        """Everything the future depends on."""
        return self._list("machine_save")

    def restore(self, state) -> None:
        """A state that save() gave."""
        held = (c_double * len(state))(*state)
        _call("machine_restore", self._machine, held, len(state))

    def _number(self, function: str, *arguments) -> float:
        value = c_double()
        _call(function, self._machine, *arguments, byref(value))
        return value.value

    def _list(self, function: str) -> list[float]:
        values, count = c_void_p(), c_size_t()
        _call(function, self._machine, byref(values), byref(count))
        return _numbers(values, count.value).tolist()


def _json(value) -> bytes:
    return _bytes(json.dumps(value, ensure_ascii=False))


def _query(handle, **query):
    result = c_void_p()
    _call("case_query", handle, _json(query), byref(result))
    return json.loads(_taken(result))


def si_units(path: str):
    """(unit, [(column, unit), ...]) of the numbers at a path, in SI, empty where they have none; None where no input has that path."""
    units = _query(None, of="si_units", path=path)
    return None if units is None else (units[0], [tuple(column) for column in units[1]])


def load(file: str, settings=(), as_set: bool = False) -> CoreCase:
    """Reads and checks a case file. as_set: settings that another input replaces are refused."""
    return CoreCase("case_read", _json({"file": file, "settings": [list(one) for one in settings], "as_set": as_set}))


def parse(text: str, name: str = "case", settings=(), files=None, as_set: bool = False) -> CoreCase:
    """The same of a text; `name` stands for the file in messages. files: those that it names, as CoreCase.source() has them."""
    return CoreCase("case_read", _json({"text": text, "name": name, "settings": [list(one) for one in settings], "files": files or {}, "as_set": as_set}))


def compute(case, command: str, options=None, progress=None) -> tuple[str, list[str]]:
    """The result of a command as JSON text, and lines about points that failed. `options` are those of the command line with _ for -;
    `progress(done, all, doing)` receives how far it is."""
    result, failures = c_void_p(), c_void_p()
    with _Watched(progress, True) as watched:
        _call("request", case.handle if case else None, _json({"command": command, "options": options or {}}), watched.function, None,
              byref(result), byref(failures))
    return _taken(result), json.loads(_taken(failures))


def command_line(arguments) -> int:
    """The command line in this process; returns its exit code."""
    words = [b"orbearing", *map(os.fsencode, arguments)]
    return _library.orbearing_command_line(len(words), (c_char_p * (len(words) + 1))(*words, None))


def evaluate(case: CoreCase, paths, values, fidelity: str = "quasi-static", jobs: int = 0, progress=None,
             without_effect: bool = False) -> tuple[list[str], np.ndarray, list[str]]:
    """Operating points of the case with the numbers at `paths` replaced by rows of `values` (variants, paths) [SI]: the columns of a sweep's
    table, their numbers (variants, columns) and the status of each variant. `progress(done)` receives how many are done.
    without_effect: whether paths without effect are allowed, for those who asked of them before."""
    table = np.ascontiguousarray(values, dtype=float)
    if table.ndim != 2 or table.shape[1] != len(paths) or not len(paths):
        raise CaseError("values: found an array of another shape; required: (variants, paths), at least one path")
    result, numbers = c_void_p(), c_void_p()
    with _Watched(progress, False) as watched:
        _call("evaluate", case.handle, _json({"paths": list(paths), "fidelity": fidelity, "jobs": jobs, "without_effect": without_effect}), table.ctypes.data_as(_Numbers), len(table),
              watched.function, None, byref(result), byref(numbers))
    found = json.loads(_taken(result))
    return found["columns"], _numbers(numbers, len(found["status"]), len(found["columns"])), found["status"]


version: str = _library.orbearing_version().decode()
instruction_set: str = _library.orbearing_instruction_set().decode()
_call("use_python", _bytes(sys.executable or ""), _bytes(str(Path(__file__).absolute().parents[1])))

"""Orbearing: planet bearings inside planetary drivetrains and ball bearings: loads, roller dynamics, fatigue life.

    import orbearing
    case = orbearing.load("cases/reducer_150kW/case.yaml")
    case["bearing.radial_clearance"] = "10 um"
    sweep = case.sweep(fidelity="quasi-static")
    print(sweep.peak["refined_speed_rpm"], sweep.peak["refined_life_h"])
    sweep.to_xarray()

Attributes are read when they are first asked for, so that a page can be drawn where the program's library is missing.
"""

from __future__ import annotations

import importlib

# Name: module that has it.
_PARTS = {
    "Case": "case",
    "load": "case",
    "parse": "case",
    "cases": "case",
    "evaluate": "case",
    "Bearing": "machine",
    "Gears": "machine",
    "Result": "results",
    "SweepResult": "results",
    "Page": "opened_page",
    "open": "opened_page",
    "CaseError": "errors",
    "ComputationError": "errors",
    "Table": "table",
    "study": "studies",
    "open_study": "studies",
    "StudyResult": "studies.result",
    "uncertainty": "uncertainties",
    "UncertaintyResult": "uncertainties.result",
}
__all__ = sorted([*_PARTS, "__version__"])


def __getattr__(name: str):
    if name == "__version__":
        value = importlib.import_module("orbearing._core").version
    elif name in _PARTS:
        module = importlib.import_module(f"orbearing.{_PARTS[name]}")
        value = getattr(module, name)
    else:
        raise AttributeError(f"module 'orbearing' has no attribute {name!r}")
    globals()[name] = value
    return value


def __dir__():
    return __all__

"""A study from its design to its result."""

from __future__ import annotations

import json
import os
import shutil
import sys
import tempfile
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from orbearing.errors import MOST_THREADS, CaseError, require_whole
from orbearing.studies.dataset import peaks
from orbearing.studies.design import Design, design_of
from orbearing.studies.engine import CoreEngine
from orbearing.studies.executors import executor_of
from orbearing.studies.folder import POINTS, StudyFolder, header_of, point_file_name
from orbearing.studies.plan import Plan
from orbearing.studies.result import StudyResult
from orbearing.studies.table import DONE

POINT_FILES = ("none", "peak", "all")
METHOD = "life.method"
Progress = Callable[[int, int], None]


def study(case, vary: Mapping[str, Any] | None = None, *, sampler: str = "grid", samples: int | None = None, seed: int = 1,
          paired: Sequence[Mapping[str, Any]] = (), fidelity: str = "quasi-static", executor=None, jobs: int = 0, output=None, resume: bool = False,
          points: str = "none", progress: bool | Progress | None = None) -> StudyResult:
    """Computes many variants of a case, each over the speeds of its own sweep, into one table.

    case      a Case, or the path of a case file
    vary      {"bearing.radial_clearance": ["0 um", "10 um"], ...}: values as in a case file, {"from", "to", "step"} or {"from", "to", "count"}, or
              numbers with their unit, (numpy.linspace(0, 40, 9), "um"). Of a sample: {"from", "to"}, or a list of equally likely values.
    sampler   "grid": all combinations; "sobol": scrambled Sobol points, a power of two of them; "lhs": a Latin hypercube
    samples, seed   of a sample: how many, and which
    paired    rows of a table, [{"bearing.rollers": 14, "bearing.roller_diameter": "6 mm"}, ...]: what stands in a row goes together, beside `vary`
    fidelity  as of a sweep
    executor  None: this process, on the threads of the core; "threads": portions on threads; a dask.distributed Client: its workers
    jobs      threads of this process; 0: one for each core
    output    folder for the store; None: memory alone
    resume    go on with the points that `output` lacks; another case, program or design is refused
    points    which points get a file of their own below `output`: "none", "peak" of each variant, or "all"
    progress  True or None: by tqdm where it is installed; or a function of points done and points in all

    The result does not depend on executor, jobs, order or interruptions to the last bit. Raises CaseError for what cannot be,
    orbearing.studies.executors.Lost where a cluster is lost: what is finished stands in `output` then.
    """
    core = _core_of(case)
    if points not in POINT_FILES:
        raise CaseError(f"points: found '{points}'; required: none, peak or all")
    for name, value, least, most in (("samples", samples, 1, 10**8), ("seed", seed, 0, 10**18), ("jobs", jobs, 0, MOST_THREADS)):
        if value is not None:
            require_whole(name, value, least, most)
    if output is not None and not os.fspath(output):
        raise CaseError("output: found an empty name; required: a folder")
    if output is None and (resume or points != "none"):
        raise CaseError(f"{'resume' if resume else 'points'}: found without a folder; required: output, the folder of the study")
    design = design_of(core, dict(vary or {}), sampler=sampler, samples=samples, seed=seed, paired=list(paired))
    if points == "peak" and not design.over_speed:
        raise CaseError("points: found 'peak' where the speed is no dimension of the study; required: all or none")
    require_effect(core, design, fidelity)
    engine = CoreEngine(core.resolved(), [p.path for p in design.numbers()], fidelity)
    checked = checked_variant(core, design)
    return compute(core, design, engine, executor_of(executor, jobs), life_key=life_key_of(design, checked), output=output, resume=resume, points=points,
                   progress=progress, warnings=warnings_of(core))


def checked_variant(core, design: Design) -> dict[str, Any]:
    """What `check` says of the first variant."""
    from orbearing import _core

    return json.loads(_core.compute(core.without_sweep().with_settings(list(design.settings(0, every=True))), "check", {})[0])


def life_key_of(design: Design, checked: Mapping[str, Any]) -> str:
    """The governing life of all variants. Raises CaseError where its method is varied."""
    method = next((p for p in design.parameters if p.path == METHOD), None)
    if method is not None:
        raise CaseError(f"{METHOD}: varied, {', '.join(dict.fromkeys(method.texts))} found; required: one method, whose life the variants are compared by. Every life "
                        "is in the study, whatever the method")
    return checked["governing_life"]["key"]


def compute(core, design: Design, engine, executor, *, life_key: str, output=None, resume: bool = False, points: str = "none",
            progress: bool | Progress | None = None, warnings: Sequence[str] = ()) -> StudyResult:
    """Computes what is missing of a design, whose peaks go by the life `life_key`. `engine` has `program`, `fidelity` and `compute`, as CoreEngine."""
    header = header_of(core.name(), core.hash(), engine.program, engine.fidelity, life_key, design)
    attributes = attributes_of(core, design, engine, life_key, warnings)
    folder = StudyFolder(None if output is None else Path(output), header, design, attributes, core.resolved(), resume)
    try:
        plan = Plan(design, folder.table.missing(), getattr(executor, "jobs", 1))
        tell = _teller(progress, design.points)
        done = design.points - plan.left
        tell(done, design.points)

        def keep(chunk):
            nonlocal done
            done += folder.keep(chunk)
            tell(done, design.points)

        for line in folder.damaged:
            _say(line)
        try:
            if plan.left:
                executor.run(engine, plan, keep)
        finally:
            folder.write()
        if points != "none":
            write_points(core, design, folder, engine.fidelity, points)
    finally:
        folder.close()
    return StudyResult(header, design, folder.table, folder.attributes, folder.folder)


def require_effect(core, design: Design, fidelity: str) -> None:
    """Raises CaseError with each varied input that has no effect on any point of the study, or whose ratings stay as stated."""
    if beside := core.stated_beside_designation([p.path for p in design.parameters]):
        raise CaseError(beside)
    without = None
    for settings in _settings_of_each_value(design):
        try:
            variant = core.without_sweep().with_settings(list(settings))
        except CaseError:
            continue  # no case: the point says so
        found = variant.without_effect([p.path for p in design.parameters], fidelity)
        without = found if without is None else {path: line for path, line in without.items() if path in found}
        if not without:
            return
    if without:
        raise CaseError(list(without.values()))


def _settings_of_each_value(design: Design):
    """Settings of points in which each choice and both ends of each number occur."""
    points = {0, design.points - 1}
    for parameter in design.parameters:
        if parameter.is_number:
            wanted = {int(np.argmin(parameter.si)), int(np.argmax(parameter.si))}
        else:
            wanted = {parameter.texts.index(text) for text in set(parameter.texts)}
        place = [name for name, _ in design.dimensions].index(parameter.dimension)
        for index in wanted:
            start = tuple(index if k == place else 0 for k in range(len(design.shape)))
            points.add(int(np.ravel_multi_index(start, design.shape)))
    return (design.settings(point, every=True) for point in sorted(points))


def warnings_of(core) -> list[str]:
    """What a study leaves out of the case."""
    if "\nspectrum:" not in core.resolved():
        return []
    return ["spectrum: found in the case, and not used by a study: it computes the speeds of the sweep alone"]


def attributes_of(core, design: Design, engine, life_key: str, warnings: Sequence[str] = ()) -> dict[str, Any]:
    """What a study's file says of where its numbers come from."""
    varied = {parameter.path for parameter in design.parameters}
    assumed = [{"key": entry["path"], "value": entry["given"], "reason": entry["reason"]} for entry in core.inputs()
               if entry["source"] == "assumed" and entry["path"] not in varied]
    return {"title": f"study of {core.name()}", "case": core.name(), "case_hash": core.hash(), "fidelity": engine.fidelity, "life_key": life_key,
            "source": f"Orbearing {engine.program['program_version']}, {engine.program['instruction_set']}",
            "assumptions": json.dumps(assumed, ensure_ascii=False), "warnings": "\n".join(warnings)}


def write_points(core, design: Design, folder: StudyFolder, fidelity: str, which: str) -> None:
    """One file for each point that is asked for, as a sweep writes it; those that stand there are kept."""
    from orbearing import _core

    if which == "peak":
        numbers = [int(number) for number in peaks(design, folder.table, folder.attributes["life_key"])[0] if number >= 0]
    else:
        numbers = [number for number in range(design.points) if folder.table.status[number] == DONE]
    (folder.folder / POINTS).mkdir(exist_ok=True)
    for number in numbers:
        target = folder.folder / point_file_name(number)
        if target.is_file():
            continue
        aside = Path(tempfile.mkdtemp(prefix=".point_", suffix=".tmp", dir=folder.folder / POINTS))
        try:
            point = core.without_sweep().with_settings(list(design.settings(number, every=True)))
            _core.compute(point, "run", {"output": os.fspath(aside / "run"), "fidelity": fidelity})
            os.replace(aside / "run" / "points" / "00000.nc", target)
        finally:
            shutil.rmtree(aside, ignore_errors=True)


def _core_of(case):
    if isinstance(case, (str, os.PathLike)):
        from orbearing import _core

        return _core.load(os.fspath(case))
    return getattr(case, "core", case)


def _say(line: str) -> None:
    print(line, file=sys.stderr)


def _teller(progress: bool | Progress | None, points: int) -> Progress:
    """What is reported of each finished portion."""
    if callable(progress):
        return progress
    if progress is False:
        return lambda done, all_points: None
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return lambda done, all_points: None
    bar = tqdm(total=points, unit="point", disable=None)

    def tell(done: int, all_points: int) -> None:
        bar.update(done - bar.n)
        if done == all_points:
            bar.close()

    return tell

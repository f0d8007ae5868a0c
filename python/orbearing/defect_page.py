"""The page of a bearing with scratches."""

from __future__ import annotations

from typing import Sequence

from orbearing import run_page
from orbearing.blocks import FigureBlock, Table, format_number, format_quantity
from orbearing.result_folder import Report, numbers


def page(report: Report, blocks: Sequence[FigureBlock]) -> str:
    """The whole document."""
    study = Report(report.record("defect"), report.folder)
    return run_page.page(study, "vibration of a bearing with scratches", headline(study), _summary(study), blocks)


def headline(study: Report) -> str:
    """The strongest line of the envelope in one sentence."""
    run_up = study.content.get("orders") is not None
    peaks = study.records("orders" if run_up else "envelope_peaks")
    if not peaks:
        return "The envelope of the vibration has no line that stands out."
    most = peaks[0]
    if run_up:
        return f"The strongest line of the envelope stands at {format_number(most.get('order'), 4)} turns of the shaft: {most.get('is')}."
    return f"The strongest line of the envelope stands at {format_quantity(most.get('frequency_Hz'), 'Hz', 4)}: {most.get('is')}."


def _summary(study: Report) -> Table:
    get = study.content.get
    element = "roller" if "roller_pass_Hz" in study.content else "ball"
    moving, resting, band = study.record("acceleration"), study.record("at_rest"), numbers(get("band_Hz"))
    rows = [("Shaft, cage", f"{format_quantity(get('shaft_Hz'), 'Hz')}, {format_quantity(get('cage_Hz'), 'Hz')}"),
            (f"{element.capitalize()}s over a place of the outer race", format_quantity(get("outer_pass_Hz"), "Hz")),
            (f"{element.capitalize()}s over a place of the inner race", format_quantity(get("inner_pass_Hz"), "Hz")),
            (f"A place of a {element} over either race", format_quantity(get(f"{element}_pass_Hz"), "Hz")),
            ("Passings of the defect", format_quantity(get("defect_Hz"), "Hz") if get("defect_Hz") is not None else "no defect"),
            ("Outer ring at rest", f"{format_quantity(resting.get('displacement_um'), 'µm', 4)} along the load; it would vibrate at "
                                   f"{format_quantity(get('natural_frequency_Hz'), 'Hz', 4)}"),
            ("Acceleration of the outer ring", f"{format_quantity(moving.get('rms_m_s2'), 'm/s²', 3)} rms, at most "
                                               f"{format_quantity(moving.get('max_m_s2'), 'm/s²', 3)}"),
            ("Largest contact load", f"{format_quantity(get('contact_load_max_N'), 'N', 4)}; at rest "
                                     f"{format_quantity(resting.get('contact_load_max_N'), 'N', 4)}")]
    if len(band) == 2:
        rows.append(("Band of the envelope", f"{format_number(band[0], 4)} to {format_number(band[1], 4)} Hz, spectral kurtosis "
                                             f"{format_number(get('band_kurtosis'), 3)}"))
    return Table(("Quantity", "Value"), rows)


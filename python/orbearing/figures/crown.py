"""Figures of a crowning study: profiles, pressure, life over drop and tilt, what life costs in pressure, life over speed."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from matplotlib.ticker import MaxNLocator

from orbearing import style
from orbearing.blocks import FigureBlock, Table, format_number, is_number
from orbearing.drawn import states_map
from orbearing.figures import roller_pressure
from orbearing.result_folder import Report, record, records

CHIEF = 3  # straight, the standard's profile, the best: first in all lists
LIFE_COLOURS = "viridis"
COLOURS = (*style.SERIES, style.GREY, "#8c564b")


def blocks(report: Report) -> list[FigureBlock]:
    """In the order of the page."""
    crown, figures = report.record("crown"), report.record("figures")
    return [
        drops(record(crown.get("recommended"))),
        life_map(record(figures.get("map")), crown),
        fronts(records(figures.get("fronts")), crown),
        profiles(records(figures.get("profiles")), figures),
        roller_pressure.block(records(figures.get("pressure"))),
        zones(records(figures.get("zone"))),
        speeds(records(figures.get("speeds")), life_key_of(crown)),
    ]


def life_key_of(crown: dict) -> str:
    """The life that the study makes longest, the governing one."""
    return str(crown.get("life_key") or "life_h")


def half_space_life_key(crown: dict) -> str:
    """The life from half-space pressures: the governing one, of ISO 16281 where that is by laminae alone."""
    return "L10rh" if life_key_of(crown) == "life_h" else life_key_of(crown)


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]


def drops(advice: dict) -> FigureBlock:
    """What is left of the longest life over the drop, the band, and what other drops cost."""
    title = "Which drop, and how closely"
    curve = records(advice.get("curve"))
    if not curve:
        return FigureBlock("crown-drop", title, missing="This study holds no lives over the drop.")
    figure, axes = style.panel((6.0, 4.0))
    drop, share = ([100 * p["life_share"] if key == "life_share" else p[key] for p in curve] for key in ("drop_um", "life_share"))
    least, most, kept = advice["least_drop_um"], advice["most_drop_um"], 100 * advice["life_kept_in_band"]
    axes.axvspan(least, most, color=style.SKY, alpha=0.25, linewidth=0, label=f"at least {format_number(kept)} % is left")
    axes.plot(drop, share, color=style.BLACK)
    axes.plot([advice["drop_um"]], [100], color=style.VERMILION, marker="*", markersize=13, linestyle="", clip_on=False, zorder=3, label="recommended")
    marks = [("straight rollers", 0.0, advice.get("straight_life_share"), "s", style.BLACK)]
    marks += [("missed by one tolerance", p["drop_um"], p["life_share"], "o", style.ORANGE) for p in records(advice.get("missed"))]
    laminae = record(advice.get("by_laminae"))
    marks.append(("by laminae", laminae.get("drop_um"), laminae.get("life_share"), "D", style.BLUE))
    for name, place, left, marker, colour in marks:
        if is_number(place) and is_number(left):
            known = axes.get_legend_handles_labels()[1]
            axes.plot([place], [100 * left], color=colour, marker=marker, linestyle="", clip_on=False, label=None if name in known else name)
    axes.set_xlim(0, max(drop))
    axes.set_ylim(0, 105)
    axes.set_xlabel("drop of one roller at the outermost of 40 laminae (µm)")
    axes.set_ylabel("life left (% of the longest)")
    style.legend_above(axes, columns=3)
    caption = ("Life from half-space pressures of both races of all bearings studied, over the drop. Where tolerances are given, each drop stands for all "
               "rollers and pins made to it within them.")
    rows = [(name, place, None if not is_number(left) else 100 * left) for name, place, left, _, _ in marks]
    return FigureBlock("crown-drop", title, caption, (style.to_svg(figure, "crown-drop", "Life left over the drop"),),
                       summary=Table(("rollers", "drop (µm)", "life left (%)"), [("recommended", advice["drop_um"], 100.0), *rows]),
                       data=Table(("drop (µm)", "life left (%)"), list(zip(drop, share))))


def life_map(found: dict, crown: dict) -> FigureBlock:
    """Contours of life, the optimum, the tilts studied and, where asked for, the band of tolerance."""
    title = "Life over drop and tilt"
    drop, tilt = np.asarray(found.get("drop_um") or []), np.asarray(found.get("tilt_mrad") or [])
    life = np.asarray(found.get("governing_life_h") or [], float)
    if life.shape != (len(drop), len(tilt)) or life.size == 0:
        return FigureBlock("crown-map", title, missing="This study holds no lives over drop and tilt.")
    figure, axes = style.panel((6.0, 4.4))
    levels = np.geomspace(life.min(), life.max(), 15)
    filled = states_map(axes.contourf(drop, tilt, life.T, levels=levels, norm=LogNorm(levels[0], levels[-1]), cmap=LIFE_COLOURS), drop, tilt, life.T)
    axes.plot(_ridge(drop, life), tilt, color=style.BLACK, linewidth=1.2, linestyle="--", label="best drop at each tilt")
    _mark_optima(axes, found, crown)
    bar = figure.colorbar(filled, ax=axes, pad=0.02, ticks=levels[::2])
    bar.set_label(style.life_label(life_key_of(crown)))
    bar.ax.yaxis.set_major_formatter(lambda value, _: format_number(value, 3))
    bar.ax.minorticks_off()
    axes.set_xlabel("drop of one roller at the outermost of 40 laminae (µm)")
    computed = crown.get("tilt") == "computed"
    axes.set_ylabel("inclination of the pin ahead (mrad)" if computed else "tilt of the bore on its pin (mrad)")
    axes.grid(False)
    style.legend_above(axes, columns=1)
    caption = (f"{_capital(style.life_name(life_key_of(crown)))} of one bearing by laminae with the profile {found.get('profile')}, colours in steps of equal ratio. A crown costs life where "
               "the bore stands straight and saves it where the bore leans. ")
    caption += ("Tilts are computed; the unloaded pin is inclined besides in the sense of the carrier's rotation." if computed else
                "The optimum is the crown under which the shortest life over the tilts studied is longest.")
    picture = style.to_svg(figure, "crown-map", "Contours of life over drop and tilt")
    return FigureBlock("crown-map", title, caption, (picture,), summary=_design_table(crown))


def _ridge(drop: np.ndarray, life: np.ndarray) -> np.ndarray:
    """The best drop at each tilt, between the drops of the grid by a parabola through three of them."""
    best = []
    for column in np.log(life).T:
        i = int(np.argmax(column))
        if 0 < i < len(drop) - 1:
            low, middle, high = column[i - 1:i + 2]
            best.append(drop[i] + 0.5 * (drop[1] - drop[0]) * (low - high) / (low - 2 * middle + high))
        else:
            best.append(drop[i])
    return np.asarray(best)


def _mark_optima(axes: Axes, found: dict, crown: dict) -> None:
    computed = crown.get("tilt") == "computed"
    tilts = [0.0] if computed else sorted({point["tilt_mrad"] for point in records(crown.get("points"))})
    best = record(crown.get("optimum"))
    label = "optimum by laminae" if computed else "optimum, at the tilts studied"
    axes.plot([best["drop_um"]] * len(tilts), tilts, color=style.VERMILION, marker="o", markersize=6, clip_on=False, label=label)
    if computed:
        wide, high = found.get("drop_tolerance_um") or 0.0, found.get("tilt_tolerance_mrad") or 0.0
        drop = record(crown.get("recommended"))["drop_um"]
        axes.plot([drop], [0.0], color=style.ORANGE, marker="*", markersize=12, linestyle="", clip_on=False, label="recommended")
        if wide or high:
            low = max(drop - wide, 0.0)
            axes.add_patch(Rectangle((low, 0.0), drop + wide - low, high, fill=False, edgecolor=style.ORANGE, linewidth=1.8, label="its tolerances"))
    robust = record(crown.get("robust"))
    if not robust:
        return
    wide, high = found.get("drop_tolerance_um") or 0.0, found.get("tilt_tolerance_mrad") or 0.0
    low = max(tilts[0] - high, 0.0)
    axes.add_patch(Rectangle((robust["drop_um"] - wide, low), 2 * wide, tilts[-1] + high - low, fill=False,
                             edgecolor=style.ORANGE, linewidth=1.8, label="best within the tolerances, with its band"))


def _design_table(crown: dict) -> Table:
    rows = []
    straight = record(crown.get("straight")).get("governing_life_h")
    life = style.life_name(life_key_of(crown))
    for name, key in (("straight", "straight"), ("ISO/TS 16281, as in the standard", "reference"), ("optimum by laminae", "optimum"),
                      ("best within the tolerances, by laminae", "robust"), ("recommended, by half-space pressures", "recommended")):
        one = record(crown.get(key))
        if one:
            ratio = one["governing_life_h"] / straight if is_number(one.get("governing_life_h")) and straight else None
            rows.append((name, one.get("profile"), one.get("drop_um"), one.get("governing_life_h"), ratio, one.get("untilted_governing_life_h"),
                         one.get("peak_pressure_MPa"), one.get("edge_ratio"), one.get("half_space_life_h"), one.get("governing_life_in_band_h")))
    return Table(("rollers", "profile", "drop (µm)", f"shortest {life} over the tilts (h)", "times straight", f"{life} without tilt (h)",
                  "greatest peak pressure (MPa)", "edge ratio there", "shortest life from half-space pressures (h)",
                  f"shortest {life} within the tolerances (h)"), rows)


def fronts(found: list[dict], crown: dict) -> FigureBlock:
    """Shortest life against greatest pressure, each kind of profile a curve over its drop."""
    title = "Life against pressure"
    drawn = [front for front in found if records(front.get("points"))]
    if not drawn:
        return FigureBlock("crown-front", title, missing="This study holds no lives against pressures.")
    figure, axes = style.panel((6.4, 4.8))
    rows = []
    for number, front in enumerate(drawn):
        points = records(front["points"])
        pressure, life = ([point[key] for point in points] for key in ("peak_pressure_MPa", "governing_life_h"))
        colour = COLOURS[number % len(COLOURS)]
        axes.plot(pressure, life, color=colour, linewidth=1.0, linestyle=style.DASHES[number % len(style.DASHES)], label=front.get("profile"))
        good = [point for point in points if point.get("efficient")]
        axes.plot([p["peak_pressure_MPa"] for p in good], [p["governing_life_h"] for p in good], color=colour, linestyle="", marker="o", markersize=4.5)
        rows += [(front.get("profile"), p["drop_um"], p["governing_life_h"], p["peak_pressure_MPa"], "yes" if p.get("efficient") else "") for p in points]
    straight = record(crown.get("straight"))
    axes.plot([straight["peak_pressure_MPa"]], [straight["governing_life_h"]], color=style.BLACK, marker="s", linestyle="", label="straight")
    best = record(crown.get("optimum"))
    axes.plot([best["peak_pressure_MPa"]], [best["governing_life_h"]], color=style.VERMILION, marker="*", markersize=13, linestyle="", label="optimum")
    axes.set_xlabel("greatest peak pressure over the tilts (MPa)")
    style.thousands(axes.xaxis)
    style.life_axis(axes)
    axes.set_ylabel(f"shortest {style.life_name(life_key_of(crown))} over the tilts (h)")
    style.legend_above(axes, columns=3)
    caption = ("Each curve is one kind of profile as its drop grows from the straight roller. Dots are the drops that are worth a thought: no other "
               "drop of that kind lives longer at a lower pressure. Kinds with a straight middle have their usual crowned share here.")
    head = ("profile", "drop (µm)", f"shortest {style.life_name(life_key_of(crown))} (h)", "greatest peak pressure (MPa)", "on the front")
    return FigureBlock("crown-front", title, caption, (style.to_svg(figure, "crown-front", "Life against peak pressure for each kind of profile"),),
                       data=Table(head, rows))


def profiles(found: list[dict], figures: dict) -> FigureBlock:
    """The rollers' outlines: true to scale, and the drop stretched."""
    title = "The profiles"
    if not found:
        return FigureBlock("crown-profiles", title, missing="This study holds no profiles.")
    true = _true_outlines(found[:CHIEF], figures)
    stretched = _stretched(found[:CHIEF], "crown-chief", "compared in this study")
    kinds = _stretched(found[CHIEF:], "crown-kinds", "every kind at the recommended drop")
    times = format_number(_magnification(found[:CHIEF], figures), 3)
    caption = (f"Above: rollers to scale, nothing stretched; the second row shows the same with the drop {times} times as large. Below: "
               "the drop alone, over one roller's length. Logarithmic profiles end in a lip that the lowest part of the picture leaves out.")
    return FigureBlock("crown-profiles", title, caption, (true, stretched, kinds))


def _magnification(found: list[dict], figures: dict) -> float:
    """So that the deepest drop takes a tenth of the diameter, as a round number."""
    deepest = max(max(profile["drop_um"][1:-1]) for profile in found)
    raw = 1e2 * figures["roller_diameter_mm"] / max(deepest, 1e-3)
    decade = 10.0 ** np.floor(np.log10(raw))
    return float(decade * max(step for step in (1, 2, 5) if step * decade <= raw))


def _true_outlines(found: list[dict], figures: dict) -> str:
    figure = Figure(figsize=(6.4, 4.6))
    panels = figure.subplots(2, len(found), sharex=True, sharey=True, squeeze=False)
    radius, times = 0.5 * figures["roller_diameter_mm"], _magnification(found, figures)
    for row, factor in zip(panels, (1.0, times)):
        for axes, profile in zip(row, found):
            x, drop = np.asarray(profile["x_mm"]), 1e-3 * factor * np.asarray(profile["drop_um"])
            edge = np.maximum(radius - drop, 0.0)
            axes.fill_between(x, -edge, edge, color="#cfd8dc", edgecolor=style.BLACK, linewidth=0.9)
            axes.set_aspect("equal")
            axes.grid(False)
            if factor == 1.0:
                axes.set_title(style.legend_label(str(profile["profile"])).replace(", ", ",\n"), fontsize=9)
    for axes in panels[-1]:
        axes.set_xlabel("mm")
    panels[0][0].set_ylabel("to scale (mm)")
    panels[1][0].set_ylabel(f"drop × {format_number(times)}")
    return style.to_svg(figure, "crown-outlines", "Rollers to scale")


def _stretched(found: list[dict], slug: str, heading: str) -> str:
    figure, axes = style.panel((5.2, 4.6))
    deepest = 0.0
    for number, profile in enumerate(found):
        drop = np.asarray(profile["drop_um"])
        deepest = max(deepest, float(np.max(drop[3:-3])))  # logarithms end far below
        axes.plot(profile["x_mm"], drop, color=COLOURS[number % len(COLOURS)], linestyle=style.DASHES[number % len(style.DASHES)],
                  label=style.legend_label(str(profile["profile"])))
    axes.set_ylim(1.15 * max(deepest, 0.1), -0.03 * max(deepest, 0.1))
    axes.set_xlabel("place along the roller (mm)")
    axes.set_ylabel("drop of one roller (µm)")
    style.legend_above(axes)
    axes.annotate(heading, (0.5, 0.02), xycoords="axes fraction", ha="center", color=style.GREY)
    return style.to_svg(figure, slug, f"Drop over the length, {heading}")


def zones(found: list[dict]) -> FigureBlock:
    """Pressure along the rollers over the load zone."""
    title = "Pressure over the load zone"
    drawn = [zone for zone in found if any(place.get("pressure_MPa") for place in records(zone.get("places")))]
    if not drawn:
        return FigureBlock("crown-zone", title, missing="This study holds no pressures over the load zone.")
    figure = Figure(figsize=(7.4, 6.0))
    panels = figure.subplots(2, len(drawn) // 2 or 1, sharex=True, sharey=True, squeeze=False)
    grids = [_zone_grid(zone) for zone in drawn]
    top = max(float(np.nanmax(grid[2][:, 2:-2])) for grid in grids)
    step = 100.0 * np.ceil(top / 1200.0)
    levels = np.arange(0.0, top + step, step)
    levels[0] = 1.0  # what carries nothing stays white
    rows = []
    for axes, zone, (angle, x, pressure) in zip(panels.flat, drawn, grids):
        axes.grid(False)
        filled = states_map(axes.contourf(angle, x, pressure.T, levels=levels, cmap="viridis", extend="max"), angle, x, pressure.T)
        where = style.tilt_text(zone.get("tilt_mrad")) if zone.get("bearing") is None else f"bearing {zone['bearing']} of a planet"
        axes.set_title(f"{zone.get('profile')}, {where}", loc="left", fontsize=9)
        rows.append((zone.get("profile"), where, float(np.nanmax(pressure[:, 2:-2]))))
    for axes in panels[:, 0]:
        axes.set_ylabel("along the roller (mm)")
    for axes in panels[-1]:
        axes.set_xlabel("place around the pin (degree)")
        axes.xaxis.set_major_locator(MaxNLocator(6))
    bar = figure.colorbar(filled, ax=list(panels.flat), pad=0.02, aspect=30)
    bar.set_label("pressure (MPa)")
    bar.set_ticks(levels[1::2])
    style.thousands(bar.ax.yaxis)
    caption = ("Pressure on the pin's race along every loaded roller, at the operating point with the greatest load. Places count from outward, in the sense of the "
               "carrier's rotation. White: no contact. The two outermost of 64 elements at a sharp end lie beyond the colours.")
    return FigureBlock("crown-zone", title, caption, (style.to_svg(figure, "crown-zone", "Pressure along the rollers over the load zone"),),
                       summary=Table(("profile", "at", "greatest pressure but at the outermost elements (MPa)"), rows))


def _zone_grid(zone: dict) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Angles from the zone's middle outwards so that the zone is not cut, places, pressures (angles, places)."""
    places, x = records(zone["places"]), np.asarray(zone["x_mm"], float)
    angle = np.array([place["angle_deg"] for place in places])
    pressure = np.array([place["pressure_MPa"] or np.zeros(len(x)) for place in places], float)
    weight = pressure.mean(axis=1)
    centre = np.degrees(np.angle(np.sum(weight * np.exp(1j * np.radians(angle)))))
    turned = centre + (angle - centre + 180.0) % 360.0 - 180.0
    order = np.argsort(turned)
    near = [i for i in order if abs(turned[i] - centre) <= 110.0]
    return turned[near], x, pressure[near]


def speeds(found: list[dict], life_key: str) -> FigureBlock:
    """Life over input speed with and without crown."""
    title = "Life over speed, with and without crown"
    drawn = [line for line in found if len(line.get("speed_rpm") or []) > 1]
    if not drawn:
        return FigureBlock("crown-speeds", title, missing="The case sweeps no speeds, so there is no curve over them.")
    tilts = list(dict.fromkeys(line["tilt_mrad"] for line in drawn))
    figure = Figure(figsize=(4.4 * len(tilts), 4.4))
    panels = figure.subplots(1, len(tilts), sharey=True, squeeze=False)[0]
    for axes, tilt in zip(panels, tilts):
        for number, line in enumerate(line for line in drawn if line["tilt_mrad"] == tilt):
            axes.plot(line["speed_rpm"], line["governing_life_h"], color=style.SERIES[number], linestyle=style.DASHES[number], marker="o",
                      markersize=3.5, label=style.legend_label(str(line["profile"])))
        axes.set_title(style.tilt_text(tilt), loc="left")
        style.speed_axis(axes)
    style.life_axis(panels[0], life_key)
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper left", ncol=3)
    figure.get_layout_engine().set(rect=(0, 0, 1, 1 - 0.3 / figure.get_figheight()))
    data = [(line["profile"], line["tilt_mrad"], speed, life) for line in drawn for speed, life in zip(line["speed_rpm"], line["governing_life_h"])]
    return FigureBlock("crown-speeds", title, f"{_capital(style.life_name(life_key))} of one bearing by laminae at each speed alone, at constant power; of stated tilts without and at the greatest.",
                       (style.to_svg(figure, "crown-speeds", "Life over input speed with and without crown"),),
                       data=Table(("profile", "tilt (mrad)", "input speed (rpm)", f"{style.life_name(life_key)} (h)"), data))

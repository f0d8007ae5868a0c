"""The load spectrum: where its bins lie, how long each lasts and how much of the life it uses up."""

from __future__ import annotations

import re

import numpy as np

from orbearing import style
from orbearing.blocks import FigureBlock, Table, columns_table, format_number, format_quantity, is_number
from orbearing.lives import LIVES
from orbearing.result_folder import Report, lies_on, numbers, record, records

SLUG, TITLE = "load-spectrum", "Load spectrum and what it uses up"
LARGEST = 900.0  # [pt^2] of the circle of the largest share
MOST_BARS = 12
DAMAGE_COLOURS = "viridis_r"


def block(report: Report) -> FigureBlock:
    """Circles over speed and torque, bars of time and damage."""
    result = spectrum_of(report)
    bins = [one for one in records(result.get("bins")) if one.get("speed_rpm")]
    key = in_words(worst_key(result))
    names = ("speed_rpm", "torque_N_m", "share", "damage_share")
    speed, torque, share, damage = (numbers([one.get(name) for one in bins]) for name in names)
    life = numbers([life_in_bin(one, result) for one in bins])
    if not len(speed):
        return FigureBlock(SLUG, TITLE, missing="The spectrum has no bin that turns.")
    uses = np.nan_to_num(damage)
    places = [number for number, one in enumerate(records(result.get("bins")), start=1) if one.get("speed_rpm")]
    pictures = (_map(speed, torque, share, uses), _bars(places, share, uses))
    data = columns_table(("bin", "speed (rpm)", "torque (N m)", "share of time", "share of damage", f"{key} at this bin alone (h)"),
                         [float(place) for place in places], speed, torque, share, damage, life)
    return FigureBlock(SLUG, TITLE, _caption(result, places, share, uses), pictures, summary=files_table(result), data=data)


def life_key(result: dict) -> str:
    """The governing life (`life.method`)."""
    return result.get("life_key") or "life_h"


def worst_key(result: dict) -> str:
    """The same of the bearing that requirements are judged by, of which the damage is summed."""
    return result.get("worst_bearing_key") or life_key(result)


def worst_life(result: dict) -> float | None:
    """Life of that bearing under the spectrum [h]."""
    return result.get("worst_bearing_h", result.get(life_key(result)))


def life_in_bin(one: dict, result: dict) -> float | None:
    """The same in one bin alone [h]."""
    return one.get("worst_bearing_h", one.get(life_key(result)))


def in_words(key: str) -> str:
    """"shortest L10mrh" of `shortest_L10mrh`."""
    return re.sub("^(shortest|carrier)_", "shortest ", key)


def of_set(result: dict) -> str:
    """Of several sets, the one with that bearing; else empty."""
    return f" of set {result['limiting_set']}" if result.get("limiting_set") else ""


def skid_text(result: dict) -> str:
    """Time in skid risk, in words."""
    share, hours = result.get("skid_risk_share"), result.get("skid_risk_hours")
    if not is_number(share):
        return ""
    in_hours = f", {format_quantity(hours, 'h')}" if is_number(hours) else ""
    return f"Skid risk, P/C below {format_number(result.get('minimum_load'))} (life.minimum_load): {format_number(100 * share, 3)} % of the time{in_hours}."


def files_table(result: dict, most: int | None = None) -> Table | None:
    """Time, damage and skid risk of the records that the rows name, largest damage first."""
    files = sorted(records(result.get("files")), key=lambda one: -(one.get("damage_share") or 0.0))[:most]
    columns = {"Time [%]": "share", **damage_columns(worst_key(result)), "Skid risk [% of time]": "skid_risk_share"}
    percent = [[100 * one[name] if is_number(one.get(name)) else None for name in columns.values()] for one in files]
    head = ("Record", *columns, "Skid risk [h]")
    rows = [(str(one.get("file")), *shares, one.get("skid_risk_hours")) for one, shares in zip(files, percent)]
    return Table(head, rows) if rows else None


def damage_columns(life: str) -> dict[str, str]:
    """Heads of columns with the name of their share: of the governing life, and of L10mh, which is often the same."""
    return {f"Damage by {in_words(life)} [%]": "damage_share"} | ({} if life == "L10mh" else {"Damage by L10mh [%]": "damage_share_L10mh"})


def spectrum_of(report: Report) -> dict:
    """Of a sweep over other values the spectrum on the line that the other figures show."""
    found = report.content.get("spectrum")
    if not isinstance(found, list):
        return record(found)
    line = report.record("slice")
    return next((one for one in records(found) if lies_on(one, line)), next(iter(records(found)), {}))


def _map(speed: np.ndarray, torque: np.ndarray, share: np.ndarray, damage: np.ndarray) -> str:
    figure, axes = style.panel((5.0, 4.3))
    order = np.argsort(-share)  # small circles before large ones
    size = LARGEST * share / share.max() if share.max() > 0 else np.full(len(share), LARGEST)
    drawn = axes.scatter(speed[order], torque[order], s=size[order], c=100 * damage[order], cmap=DAMAGE_COLOURS, vmin=0,
                         vmax=max(100 * damage.max(), 1e-9), edgecolors=style.BLACK, linewidths=0.6, alpha=0.85)
    figure.colorbar(drawn, ax=axes, pad=0.02).set_label("share of the damage (%)")
    axes.margins(0.15)  # room for circles at the edge
    style.speed_axis(axes)
    axes.set_ylabel("input torque (N m)")
    style.thousands(axes.yaxis)
    return style.to_svg(figure, f"{SLUG}-map", "Bins over input speed and torque: area by time, colour by damage")


def _bars(bins: list[int], share: np.ndarray, damage: np.ndarray) -> str:
    figure, axes = style.panel((5.0, 4.3))
    first = np.argsort(-damage, kind="stable")[:MOST_BARS]
    place = np.arange(len(first))
    axes.barh(place - 0.2, 100 * share[first], height=0.38, color=style.SKY, label="time")
    axes.barh(place + 0.2, 100 * damage[first], height=0.38, color=style.VERMILION, label="damage")
    axes.set_yticks(place, [f"{bins[index]}" for index in first])
    axes.invert_yaxis()
    axes.set_xlabel("share (%)")
    axes.set_ylabel("bin, in the order of the spectrum")
    style.legend_above(axes)
    return style.to_svg(figure, f"{SLUG}-bars", "Shares of time and of damage of the bins that use up most")


def _caption(result: dict, bins: list[int], share: np.ndarray, damage: np.ndarray) -> str:
    worst, key = int(np.argmax(damage)), life_key(result)
    text = (f"Left: each circle is a bin, its area the share of time, its colour the share of the damage by the rule of Palmgren and Miner. Right: "
            f"the bins that use up most. By {in_words(worst_key(result))} one bearing{of_set(result)} reaches {format_quantity(worst_life(result), 'h')} "
            f"under the spectrum, all together {format_quantity(result.get('system_' + key), 'h')}; bin {bins[worst]} takes {format_number(100 * share[worst], 3)} % of the "
            f"time and {format_number(100 * damage[worst], 3)} % of the life.")
    others = [f"{name} {format_quantity(result.get(name), 'h')}" for name in LIVES if name != worst_key(result) and is_number(result.get(name))]
    text += f" The other lives of one bearing under the spectrum: {', '.join(others)}." if others else ""
    return f"{text} {skid_text(result)}".rstrip()

"""One page about a wheel on a rail, for a browser: it loads nothing, and prints on A4."""
from __future__ import annotations

import base64
import csv
import datetime
import hashlib
import io
import math
import os
import shutil
import warnings
from collections.abc import Mapping, Sequence
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any, Union

import numpy as np

from ._library import lib, string
from ._report_head import HEAD
from ._warnings import GRADES
from .conicity import STANDARD, over_defaults
from .errors import ContactWarning, Error, InvalidArgument
from .plot import NOTE, picture_style
from .profile import Profile, files_of, refuse_overwriting
from .scene import Scene, solve

if TYPE_CHECKING:
    from .result import Result

Limits = Union[Mapping[str, "tuple[float | None, float | None]"], str, "os.PathLike[str]", None]

_REACH, _STEP = 6.0, 0.5  # mm, positions on both sides
_SMOOTHINGS = (0, 3, 5, 8, 15)  # mm
_OF_PAIRS = {"equivalent_conicity": ("1", "equivalent conicity at an amplitude of 3 mm"),
             "pmax_centred": ("MPa", "largest pressure, centred"),
             "pmax": ("MPa", "largest pressure at any position")}


class _Page:
    def __init__(self, title: str) -> None:
        self.parts = [f"{HEAD}<title>{escape(title)}</title>\n<h1>{escape(title)}</h1>\n"]

    def add(self, tag: str, text: str) -> None:
        self.parts.append(f"<{tag}>{escape(text)}</{tag}>\n")

    def listed(self, items: Sequence[str]) -> None:
        self.parts.append("<ul>" + "".join(f"<li>{escape(item)}</li>\n" for item in items) + "</ul>\n")

    def table(self, rows: Sequence[Sequence[Any]]) -> None:
        """The first row has the titles; numbers are given with their decimals as (value, decimals)."""
        numeric = [isinstance(cell, tuple) for cell in (rows[1] if len(rows) > 1 else rows[0])]
        for number, row in enumerate(rows):
            tag = "th" if number == 0 else "td"
            cells = (f"<{tag}{' class=number' if is_number else ' class=fail' if cell == 'fail' else ''}>"
                     f"{escape(_shown(cell))}</{tag}>" for cell, is_number in zip(row, numeric))
            self.parts.append(("<table>\n" if number == 0 else "") + f"<tr>{''.join(cells)}</tr>\n")
        self.parts.append("</table>\n")

    def picture(self, figure: Any, meaning: str) -> None:
        file = io.BytesIO()
        figure.savefig(file, dpi=110, bbox_inches="tight")
        code = base64.b64encode(file.getvalue()).decode()
        self.parts.append(f'<img alt="{escape(meaning)}" src="data:image/png;base64,{code}">\n')


def _shown(cell: Any) -> str:
    if not isinstance(cell, tuple):
        return str(cell)
    value, decimals = cell
    return "-" if value is None or math.isnan(value) else f"{value:.{decimals}f}"


def _origin(profile: Profile) -> str:
    """The file of a profile and its checksum, or that it is built in."""
    made, arguments, options = profile._made
    words = "".join(f", {name} = {value}" for name, value in options.items())
    if made == Profile.from_file:
        return f"{profile.kind}: {Path(arguments[0]).name}{words}; SHA-256 {profile._digest}"
    if made == Profile:
        return f"{profile.kind}: {profile.name}, built in"
    digest = hashlib.sha256(np.concatenate(arguments[1:]).tobytes()).hexdigest()
    return f"{profile.kind}: {profile.name}, points of the program{words}; SHA-256 of their doubles {digest}"


def limits_of(limits: Limits, known: Sequence[str]) -> list[tuple[str, float | None, float | None, str]]:
    """Quantity, least, greatest and source: of a file with these columns, or of a dict. InvalidArgument."""
    if limits is None:
        return []
    if isinstance(limits, Mapping):
        name = "limits"
        given: list[tuple[str, Any, str]] = [(quantity, pair, "the caller") for quantity, pair in limits.items()]
    else:
        name, given = os.fspath(limits), _limits_in(limits)
    rows = []
    for quantity, pair, source in given:
        if quantity not in known:
            raise InvalidArgument(f"{name}: {quantity!r} is no quantity of a report; must be one of {', '.join(known)}")
        try:
            least, greatest = (None if one is None else float(one) for one in pair)
            numbers = [one for one in (least, greatest) if one is not None]
            if not numbers or not all(map(math.isfinite, numbers)) or numbers != sorted(numbers):
                raise ValueError
        except (TypeError, ValueError):
            raise InvalidArgument(f"{name}: the limits of {quantity} are {pair!r}; must be two finite numbers, the least one "
                                  "first, one of which may be missing (None, or nothing in a file)") from None
        rows.append((quantity, least, greatest, source))
    if not rows:
        raise InvalidArgument(f"{name}: has no limits; must have one or more")
    return rows


def _limits_in(path: str | os.PathLike[str]) -> list[tuple[str, Any, str]]:
    with open(path, encoding="utf-8-sig", newline="") as file:  # Excel begins with a mark
        table = csv.DictReader(file)
        try:
            if len(set(table.fieldnames or ())) < len(table.fieldnames or ()):
                raise ValueError("a column is given twice")
            rows = list(table)
            if any(None in row or None in row.values() for row in rows):
                raise ValueError("a row has another number of entries than the first line")
            return [(row["quantity"], (row["least"] or None, row["greatest"] or None), row["source"]) for row in rows]
        except (KeyError, ValueError) as error:
            raise InvalidArgument(f"{os.fspath(path)}: must have the columns quantity, least, greatest, source ({error})") from error


def verdict(value: float, spread: float, least: float | None, greatest: float | None) -> str:
    """pass, fail, or what is between: a limit within the spread, or no value or spread."""
    if math.isnan(value):
        return "not known"
    low, high = -math.inf if least is None else least, math.inf if greatest is None else greatest
    if not low <= value <= high:
        return "fail"
    if math.isnan(spread):
        return "pass, spread unknown"
    return "pass" if low <= value - spread and value + spread <= high else "pass, within its spread of the limit"


def report(wheel: Profile | str, rail: Profile | str, path: str | os.PathLike[str] = "report.html", *,
           nominal_wheel: Profile | str | None = None, nominal_rail: Profile | str | None = None, limits: Limits = None,
           **keys: Any) -> Path:
    """Writes one page about a wheel on a rail, to be opened in a browser, printed on A4 or sent to others.

    Dimensions, beside those of nominal profiles, equivalent conicity with its spread, pressures and contact points over the
    lateral position, largest pressure over the smoothing wavelength, warnings; date, version and checksums of files. limits: a
    dict such as {"flange_height": (27, 36), "pmax": (None, 2500)}, or a file with the columns quantity, least, greatest,
    source. keys: of all scenes. Returns the path.
    """
    values = over_defaults({"accuracy": 1e-2}, keys, "the report")
    pair = [one if isinstance(one, Profile) else Profile(one) for one in (wheel, rail)]
    nominal = [Profile(one) if isinstance(one, str) else one for one in (nominal_wheel, nominal_rail)]
    refuse_overwriting(path, files_of(*pair, *(one for one in nominal if one is not None))
                       + ([] if limits is None or isinstance(limits, Mapping) else [os.fspath(limits)]))
    rows = limits_of(limits, [*(name for one in pair for name in one.dimensions), *_OF_PAIRS])
    conicity = pair[0].conicity(pair[1], **values)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ContactWarning)  # they are in the page
        centre = _solved(wheel=pair[0], rail=pair[1], **values)
        lateral = np.arange(-_REACH, _REACH + 0.5 * _STEP, _STEP)
        positions: dict[str, Any] = {str(name): array for name, array in solve(
            lateral=lateral, wheel=pair[0], rail=pair[1], outputs=[f"left.{name}" for name in (
                "pmax", "area", "angle", "rigid_contact.rolling_radius", "rigid_contact.s_wheel",
                "rigid_contact.t_rail")], **values).items()}
    facts = _facts(pair, conicity, centre, np.asarray(positions["left.pmax"]))
    page = _Page(" on ".join(Path(one.name).name for one in pair))
    shown = ", ".join(f"{key} = {value}" for key, value in keys.items())
    page.add("p", f"{datetime.datetime.now().astimezone():%Y-%m-%d %H:%M %z}, wrcontact {string(lib.wrc_version())}, by "
                  f"wrcontact.report in Python{': ' + shown if shown else ''}. mm, N, MPa, rad.")
    page.listed([_origin(one) for one in pair])
    _add_brief(page, facts, conicity, lateral, np.asarray(positions["left.pmax"]))
    if rows:
        page.add("h2", "Limits")
        decimals = {"mm": 2, "MPa": 0, "1": 4}
        page.table([("quantity", "verdict", "value", "least", "greatest", "unit", "source"), *(
            (meaning, verdict(value, spread, least, greatest),
             *((one, decimals[unit]) for one in (value, least, greatest)), unit.replace("1", ""), source)
            for name, least, greatest, source in rows for value, spread, unit, meaning in [facts[name]])])
    _add_warnings(page, centre, positions, lateral)
    if not isinstance(centre, str):
        page.add("h2", "Centred on the track")
        page.picture(centre.plot(), "profiles in contact and pressures of both wheels")
        _add_smoothing(page, centre)
    _add_positions(page, lateral, positions)
    page.add("h2", "Equivalent conicity")
    page.picture(conicity.plot(), "equivalent conicity over the amplitude")
    page.table([("amplitude, mm", "equivalent conicity", "±", ""), *(
        ((amplitude, 0), (value, 4), (spread, 4), reason) for amplitude, value, spread, reason in zip(
            conicity.amplitude, conicity.conicity, conicity.spread, conicity.reasons)
        if amplitude % 1 == 0 and (not reason or amplitude == STANDARD))])
    for profile, other in zip(pair, nominal):
        _add_profile(page, profile, other)
    _write_whole(os.path.realpath(path), "".join(page.parts) + "</html>\n")
    return Path(path)


def _write_whole(path: str, text: str) -> None:
    """Aside first, so that the file is whole or as it was; a device or pipe has no aside."""
    aside = path if os.path.exists(path) and not os.path.isfile(path) else f"{path}.{os.getpid()}.part"
    try:
        Path(aside).write_text(text, encoding="utf-8")
        if aside != path:
            if os.path.exists(path):
                shutil.copymode(path, aside)
            os.replace(aside, path)
    finally:
        if aside != path:
            Path(aside).unlink(missing_ok=True)


def _solved(**values: Any) -> Result | str:
    """The result, or why there is none."""
    try:
        return Scene(**values).solve()
    except Error as error:
        return str(error)


def _facts(pair: Sequence[Profile], conicity: Any, centre: Result | str, pmax: Any) -> dict[str, tuple[float, float, str, str]]:
    """What limits can be set to: value, spread, unit, meaning."""
    facts = {}
    for profile in pair:
        dimensions = profile.dimensions
        for name, value in dimensions.items():
            facts[name] = (value, 0.0, dimensions.units[name], dimensions.long_name[name])
    numbers = {"equivalent_conicity": (conicity.value, conicity.standard_spread), "pmax_centred": (math.nan, 0.0),
               "pmax": (float(np.nanmax(pmax)) if np.isfinite(pmax).any() else math.nan, 0.0)}
    if not isinstance(centre, str):
        numbers["pmax_centred"] = (centre.left.pmax, centre["left.spread.pmax"])
    facts.update({name: (*found, *_OF_PAIRS[name]) for name, found in numbers.items()})
    return facts


def _add_brief(page: _Page, facts: Mapping[str, Any], conicity: Any, lateral: Any, pmax: Any) -> None:
    page.add("h2", "In brief")
    lines = []
    for name, decimals in (("equivalent_conicity", 4), ("pmax_centred", 0)):
        value, spread, unit, meaning = facts[name]
        more = f" ± {spread:.{decimals}f}" if spread > 0.0 else ""
        text = "not known" if math.isnan(value) else f"{value:.{decimals}f}{more} {unit}".replace(" 1", "")
        lines.append(f"{meaning[0].upper()}{meaning[1:]}: {text}.")
    if not math.isnan(conicity.nonlinearity):
        lines.append(f"Nonlinearity parameter: {conicity.nonlinearity:.4f} per mm.")
    if np.isfinite(pmax).any():
        worst = int(np.nanargmax(pmax))
        lines.append(f"Largest pressure between y = {lateral[0]:g} and {lateral[-1]:g} mm: {pmax[worst]:.0f} MPa, at y = "
                     f"{lateral[worst]:g} mm.")
    page.listed(lines)


def _add_warnings(page: _Page, centre: Result | str, positions: Mapping[str, Any], lateral: Any) -> None:
    page.add("h2", "Warnings")
    lines = [f"Centred: {centre}"] if isinstance(centre, str) else [
        f"centred: {GRADES[grade]}: {text}" for grade, text in centre._graded()]
    grades, texts, statuses, messages = (np.asarray(positions[name]) for name in ("grade", "warnings", "status", "message"))
    lines += [f"y = {lateral[i]:g} mm: {messages[i]}" for i in np.flatnonzero(statuses)]
    for grade in (2, 1):
        for text in dict.fromkeys(" | ".join(texts[grades == grade]).split(" | ")):
            at = [f"{lateral[i]:g}" for i in np.flatnonzero(grades == grade) if text and text in texts[i].split(" | ")]
            if at:
                lines.append(f"y = {', '.join(at)} mm ({GRADES[grade]}): {text}")
    if lines:
        page.listed(lines)
    else:
        page.add("p", "None.")


def _add_smoothing(page: _Page, centre: Result) -> None:
    """pmax and area over the wavelength that profiles of points are smoothed with."""
    if "left.smoothed_0mm.area" not in centre._names:
        return
    import matplotlib
    from matplotlib.figure import Figure

    page.add("p", "The largest pressure over the wavelength that the profiles are smoothed with: waves of this length are halved.")
    with matplotlib.rc_context(picture_style()):
        figure = Figure(figsize=(7.0, 3.5), layout="constrained")
        axes = figure.subplots()
    rows: list[tuple[Any, ...]] = [("", "unit", "as solved", *(f"{one} mm" for one in _SMOOTHINGS))]
    for side in ("left", "right"):
        for name, unit, decimals in (("pmax", "MPa", 0), ("area", "mm²", 1)):
            numbers = [centre[f"{side}.smoothed_{one}mm.{name}"] for one in _SMOOTHINGS]
            rows.append((f"{side} {name}", unit, *((one, decimals) for one in [centre[f"{side}.{name}"], *numbers])))
            if name == "pmax":
                axes.plot(_SMOOTHINGS, numbers, "o-", label=f"{side} wheel")
                axes.axhline(centre[f"{side}.pmax"], linestyle=":", color=axes.lines[-1].get_color())
    axes.set(xlabel="smoothing wavelength, mm", ylabel="largest pressure, MPa", title="dotted: as solved")
    axes.legend()
    page.picture(figure, "largest pressure over the smoothing wavelength")
    page.table(rows)
    page.listed(_spread_warnings(centre))


def _spread_warnings(centre: Result) -> list[str]:
    """As drivers/reports/smoothing.cpp."""
    lines = []
    for side in ("left", "right"):
        shares = {name: centre[f"{side}.spread.{name}"] / (centre[f"{side}.{name}"] or math.nan) for name in ("pmax", "area")}
        if math.isnan(shares["area"]):
            lines.append(f"Note: {side}: how far noise moves pmax and area is not known: the points of a profile are too far apart")
        if any(share > centre.scene["solve.accuracy"] for share in shares.values()):
            text = ", ".join(f"{name} by {1e2 * share:.1f} %" for name, share in shares.items() if not math.isnan(share))
            lead = ("Note", "A little over", "Do not use")[centre[f"{side}.spread.grade"]]
            lines.append(f"{lead}: {side}: uncertain by noise or short waves of the profiles: {text}")
    return lines


def _add_positions(page: _Page, lateral: Any, positions: Mapping[str, Any]) -> None:
    import matplotlib
    from matplotlib.figure import Figure

    page.add("h2", "Left wheel over the lateral position")
    columns = (("pmax", "pmax, MPa", 0), ("area", "area, mm²", 1), ("angle", "contact angle, rad", 4),
               ("rigid_contact.rolling_radius", "rolling radius, mm", 3), ("rigid_contact.s_wheel", "s on the wheel, mm", 2),
               ("rigid_contact.t_rail", "t on the rail, mm", 2))
    arrays = [np.asarray(positions[f"left.{name}"]) for name, _, _ in columns]
    with matplotlib.rc_context(picture_style()):
        figure = Figure(figsize=(7.5, 9.0), layout="constrained")
        panels = figure.subplots(4, 1, sharex=True)
    for axes, array, (_, label, _) in zip(panels, [*arrays[:2], *arrays[4:]],
                                          [*columns[:2], *columns[4:]]):
        axes.plot(lateral, array, "o-", markersize=3)
        axes.set_ylabel(label)
    axes.set_xlabel("lateral displacement, mm (to the left)")
    page.picture(figure, "largest pressure, area and contact points over the lateral position")
    page.table([("y, mm", *(label for _, label, _ in columns)), *(
        ((lateral[i], 1), *((array[i], decimals) for array, (_, _, decimals) in zip(arrays, columns)))
        for i in range(lateral.size))])


def _add_profile(page: _Page, profile: Profile, nominal: Profile | None) -> None:
    page.add("h2", f"{profile.kind.title()} {Path(profile.name).name}")
    page.add("p", f"{profile.title}. Source: {profile.source}.")
    own = profile.dimensions
    head: tuple[Any, ...] = ("dimension", "value", "unit")
    rows: list[tuple[Any, ...]] = [(own.long_name[name], (value, 3), own.units[name].replace("1", "")) for name, value in own.items()]
    if nominal is not None:
        others = profile._dimensions_of(nominal)
        head = ("dimension", "value", f"nominal: {nominal.name}", "difference", "unit")
        rows = [(label, value, (others[name], 3), (own[name] - others[name], 3), unit)
                for name, (label, value, unit) in zip(own, rows)]
    page.table([head, *rows])
    figure = profile.plot()
    if nominal is not None:
        curve = nominal.at(np.arange(0.0, nominal.length, 0.1))
        figure.axes[0].plot(curve.lateral, curve.height, "--", color=NOTE, linewidth=1, label=f"nominal: {nominal.name}")
        figure.axes[0].legend()
        found = profile.compare(nominal)
        page.add("p", f"The nominal profile is at most {found.largest:.3f} mm away, at lateral {found.largest_at[0]:.1f} mm; "
                      f"{found.missing_area:.1f} mm² are missing, {found.added_area:.1f} mm² are added.")
    page.picture(figure, f"shape of {profile.name}")
    if profile.corrections:
        page.add("p", "Corrected on reading:")
        page.listed(profile.corrections)

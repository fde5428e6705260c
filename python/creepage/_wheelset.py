"""Wheelsets on their rails: profiles and a load in, contacts and forces out."""

from __future__ import annotations

import copy
import json
import os
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from . import _creepage
from ._contact import floats
from ._report import FromFile, ReportedList
from ._report_parts import Wheel
from ._map import ContactMap
from ._results import Floats
from ._toml import dumps
from ._wheelset_solver import WheelsetSolver


@dataclass(frozen=True, slots=True, eq=False)
class WheelsetSolution(ReportedList):
    """A wheelset, solved. Track axes: x forward, y right, z down; all in SI units."""

    status: str
    """ "solved", or why not."""
    caution: str | None
    """Cautions about the solution, in words."""
    left: Wheel | None
    """The left wheel: `force` on the rail, `patches` by falling load; also a dictionary, as in report.json. None where
    the other wheel was solved alone."""
    right: Wheel | None
    """The right wheel."""
    derivatives: Floats | None
    """Total derivatives of the forces on the rails, of shape (2, 6, 8), where they were asked for.
    The axes are the left and the right wheel; force along and moment about x, y, z; y, z, roll,
    yaw, speed, pitch_rate, lateral_velocity, yaw_rate. NaN by what is found and not given."""
    derivative_errors: Floats | None
    """What the differences may have made of each."""
    _report: dict[str, Any]
    _solved: _creepage.SolvedWheelset
    _again: Callable[[], Any]

    @property
    def y(self) -> float:
        """Lateral position, to the right (m)."""
        return float(self._report["y_m"])

    @property
    def z(self) -> float:
        """Height, down (m)."""
        return float(self._report["z_m"])

    @property
    def roll(self) -> float:
        """Turn about x (rad)."""
        return float(self._report["roll_rad"])

    @property
    def yaw(self) -> float:
        """Turn about z (rad)."""
        return float(self._report["yaw_rad"])

    @property
    def speed(self) -> float:
        """m/s."""
        return float(self._report["speed_m_per_s"])

    @property
    def pitch_rate(self) -> float:
        """Given or found (rad/s); independent wheels have their own each."""
        return float(self._report["pitch_rate_rad_per_s"])

    @property
    def lateral_velocity(self) -> float:
        """m/s."""
        return float(self._report["lateral_velocity_m_per_s"])

    @property
    def vertical_velocity(self) -> float:
        """m/s."""
        return float(self._report["vertical_velocity_m_per_s"])

    @property
    def roll_rate(self) -> float:
        """rad/s."""
        return float(self._report["roll_rate_rad_per_s"])

    @property
    def yaw_rate(self) -> float:
        """rad/s."""
        return float(self._report["yaw_rate_rad_per_s"])

    @property
    def friction(self) -> float:
        """Coefficient of friction mu; where places of the rail differ, the largest."""
        return float(self._report["friction"])

    @property
    def s(self) -> float | None:
        """Place along the track (m), where wheels or rails vary along rolling."""
        found: float | None = self._report.get("s_m")
        return found

    @property
    def pitch(self) -> float | None:
        """How far the wheels have rolled on (rad), where wheels or rails vary along rolling."""
        found: float | None = self._report.get("pitch_rad")
        return found

    @property
    def least_friction(self) -> float | None:
        """The least coefficient of friction, where places of the rail differ."""
        found: float | None = self._report.get("least_friction")
        return found


def _profile(name: str, profile: str | os.PathLike[str] | ArrayLike) -> dict[str, Any]:
    """A profile by its name or file, or by its points; slices by their file."""
    if isinstance(profile, (str, os.PathLike)):
        file = os.fspath(profile)
        key = "slices" if file.lower().endswith((".toml", ".slcs", ".slcw")) else "profile"
        return {key: file}
    points = floats(name, profile)
    if points.ndim != 2 or points.shape[1] != 2:
        raise ValueError(f"{name} must be a name, a file or points of shape (n, 2), got {points.shape}")
    return {"points": points.tolist()}


class Wheelset(FromFile):
    """Two wheels and two rails by their profiles, where the wheelset stands, how it moves.

    Profiles are names of standard ones ("S1002", "UIC60"), files, or arrays of points (y to the field side, z
    down, in metres) of shape (n, 2) along the profile. Raises CaseError, which names
    section and key, OSError for files that cannot be read.
    """

    def __init__(
        self,
        *,
        wheel: str | os.PathLike[str] | ArrayLike,
        rail: str | os.PathLike[str] | ArrayLike,
        wheel_reading: Mapping[str, Any] | None = None,
        rail_reading: Mapping[str, Any] | None = None,
        axle_load: float | None = None,
        z: float | None = None,
        radius: float = 0.46,
        cant: float = 0.0,
        gauge: float = 1.435,
        gauge_height: float = 0.014,
        back_to_back: float = 1.360,
        y: float = 0.0,
        yaw: float = 0.0,
        roll: float | Literal["free"] = "free",
        speed: float = 30.0,
        pitch_rate: float | Literal["free"] = "free",
        lateral_velocity: float = 0.0,
        yaw_rate: float = 0.0,
        s: float | None = None,
        pitch: float | None = None,
        flat: Mapping[str, Any] | Sequence[Mapping[str, Any]] | None = None,
        waviness: Sequence[Mapping[str, Any]] | None = None,
        corrugation: Sequence[Mapping[str, Any]] | None = None,
        roller_radius: float | None = None,
        guard: Mapping[str, Any] | None = None,
        friction: float = 0.3,
        shear_modulus: float = 82e9,
        poisson: float = 0.28,
        directory: str | os.PathLike[str] = ".",
        **options: Any,
    ) -> None:
        """axle_load (N) presses it on its rails, or z (m, down) is its height. Lengths are in
        metres: radius of the wheels at the tape circle, gauge, gauge_height, back_to_back and y.
        cant of the rails, yaw and roll are in radians. speed and lateral_velocity are in m/s,
        pitch_rate and yaw_rate in rad/s, shear_modulus in Pa. Profile files are looked for in
        directory. options are those of `[solve]`, theory among them. wheel_reading and rail_reading
        say what a profile's file does not show, and smooth it: {"unit": 0.001, "y": "field-side",
        "z": "up", "smooth": 0.006}, each where it is needed.

        wheel and rail may be files of slices too (.toml, or CONTACT's .slcw and .slcs): profiles
        around the wheel and along the rail. flat, of both wheels, is {"length": m, "depth": m,
        "angle": rad, "shape": "chord" or "haversine"} or several of these. waviness, of both
        wheels, is [{"order": n, "amplitude": m, "phase": rad}]. corrugation, of both rails, is
        [{"wavelength": m, "amplitude": m, "phase": rad}]. s is the place along the track (m), pitch
        how far the wheels have rolled on (rad). roller_radius (m) puts a roller in place of each
        rail, whose rim touches the track plane. guard is a guard rail beside each rail, on which
        the back of the flange runs. It is {"profile": name, file or points, "flangeway": m,
        "height": m, "cant": rad, "friction": mu}. "position": [y, z] may replace flangeway and
        height; {"grooved": True} is for a rail whose own profile has it. What this leaves out,
        `from_toml` and `from_dict` know.
        """
        def waves(value: Any) -> Any:
            if value is None or isinstance(value, Mapping):
                return value
            return [dict(one) for one in value]

        def beside(value: Mapping[str, Any] | None) -> dict[str, Any] | None:
            if value is None:
                return None
            own = dict(value)
            profile = own.pop("profile", None)
            return own if profile is None else {**_profile("guard profile", profile), **own}

        sections: dict[str, Mapping[str, Any]] = {
            "wheel": {
                **_profile("wheel", wheel),
                "reading": wheel_reading,
                "radius": radius,
                "flat": waves(flat),
                "waviness": waves(waviness),
            },
            "rail": {
                **_profile("rail", rail),
                "reading": rail_reading,
                "cant": cant,
                "corrugation": waves(corrugation),
                "roller_radius": roller_radius,
                "guard": beside(guard),
            },
            "track": {"gauge": gauge, "gauge_height": gauge_height},
            "wheelset": {
                "back_to_back": back_to_back,
                "y": y,
                "yaw": yaw,
                "roll": roll,
                "axle_load": axle_load,
                "z": z,
                "s": s,
                "pitch": pitch,
            },
            "motion": {
                "speed": speed,
                "pitch_rate": pitch_rate,
                "lateral_velocity": lateral_velocity,
                "yaw_rate": yaw_rate,
            },
            "contact": {"friction": friction},
            "materials": {"shear_modulus": shear_modulus, "poisson": poisson},
        }
        if options:
            sections["solve"] = {"theory": "exact", **options}
        self._read(dumps(sections), Path(directory))

    def _read(self, text: str, directory: Path) -> None:
        super()._read(text, directory)
        self._data = _creepage.WheelsetData(text, directory)

    @property
    def notes(self) -> list[str]:
        """What was found in the profile files and repaired: nothing is guessed silently."""
        return self._data.notes()

    def solve(self, *, derivatives: bool = False) -> WheelsetSolution:
        """Finds the contacts and solves them; with derivatives by position and motion where they are
        asked for, which take five to ten times as long. Raises CaseError where the wheelset cannot rest
        on its rails. A caution is warned of."""
        solved = self._data.solve(derivatives)
        report = json.loads(solved.json())
        if report["caution"] is not None:
            warnings.warn(report["caution"], UserWarning, stacklevel=2)
        found = solved.derivatives()
        values, errors = (None, None) if found is None else (a.reshape(2, 6, 8) for a in found)
        left, right = (None if report[side] is None else Wheel(report[side]) for side in ("left", "right"))
        return WheelsetSolution(
            report["status"],
            report["caution"],
            left,
            right,
            values,
            errors,
            report,
            solved,
            partial(self.solve, derivatives=derivatives),
        )

    def at(self, s: float | None = None, pitch: float | None = None) -> Wheelset:
        """The same at another place along the track (m), its wheels rolled on to another pitch (rad): where rails or
        wheels vary. What is left out stays."""
        nan = float("nan")
        other = copy.copy(self)
        other._data = self._data.at(nan if s is None else s, nan if pitch is None else pitch)
        other._text = other._data.text()
        return other

    def solver(self, theory: str | None = None, **options: Any) -> WheelsetSolver:
        """Prepared to be asked in many positions and motions, by its own theory or by another one with
        these options. Raises CaseError for a theory that does not take areas of any shape."""
        if theory is None:
            if options:
                raise TypeError("options need a theory")
            return WheelsetSolver(self._data, (self, None, {}))
        lines = [f"{name} = {json.dumps(value)}" for name, value in options.items()]
        return WheelsetSolver(self._data.by_theory(theory, lines), (self, theory, options))

    def roll(
        self,
        history: Mapping[str, ArrayLike],
        *,
        start: Literal["none", "steady"] | None = None,
    ) -> dict[str, Any]:
        """Rolls in steps, so that contacts remember their tractions: the numbers of `creepage roll` with a wheelset
        file.

        history: arrays of one length, or a frame of pandas, with the columns of the command's table. These are
        `distance` (m), which rises, and what differs from the wheelset: `s`, `pitch`, `wheel_load`, `y`, `z`, `roll`,
        `yaw`, `axle_load`, `roll_moment`, `speed`, `pitch_rate`, `lateral_velocity`, `vertical_velocity`, `roll_rate`,
        `yaw_rate`; NaN is the wheelset's own. A row's motion acts from the distance of the row before, or zero, to its
        own. start: "none" is without traction, "steady" as if the first row's motion had always been; by default as the
        file says, or none. Gives arrays named as the columns of `history.csv`; numbers of a side that is not solved are
        NaN. Raises ValueError for columns that are not known and rows without numbers, CaseError for what cannot roll in steps, such as
        theories other than "exact", a free pitch_rate, and rails on springs. Warns of what the rows are in doubt for.
        """
        if start not in (None, "none", "steady"):
            raise ValueError(f'start must be "none" or "steady", not {start!r}')
        columns = [(str(name), floats(str(name), values).ravel()) for name, values in history.items()]
        if len({values.size for _, values in columns}) > 1:
            sizes = ", ".join(f"{name}: {values.size}" for name, values in columns)
            raise ValueError(f"columns must have one length, not {sizes}")
        given = [(name, values.tolist()) for name, values in columns]
        found, cautions = self._data.roll(given, None if start is None else start == "steady")
        if cautions:
            warnings.warn("; ".join(cautions), UserWarning, stacklevel=2)
        return {
            name: np.array(values) if name == "status" else values for name, values in found.items()
        }

    def map(self, **plan: Any) -> ContactMap:
        """The contact map of the wheelset, built on all cores: `ContactMap.build` with this plan."""
        return ContactMap.build(self, **plan)

    def _poisson(self) -> float:
        return self._data.poisson()

    def table(
        self,
        y: ArrayLike,
        yaw: ArrayLike = 0.0,
        *,
        roll: ArrayLike | None = None,
        z: ArrayLike | None = None,
        axle_load: ArrayLike | None = None,
    ) -> dict[str, Floats]:
        """Forces over lateral positions (m), yaws (rad), and where they are given rolls (rad), heights (m)
        or axle loads (N), solved on all cores.

        Gives arrays of shape (axle_load, z, roll, yaw, y), of those that are given, by the names of
        `creepage wheelset --table`, such as `left_lateral_n`. Arrays of the three most loaded
        places of contact, such as `left_contact_area_m2`, have a last axis of length 3 more. NaN
        where a position could not be solved or there are fewer contacts.
        """
        given = {"axle_load": axle_load, "z": z, "roll": roll, "yaw": yaw, "y": y}
        axes = {
            name: np.atleast_1d(floats(name, values)).ravel()
            for name, values in given.items()
            if values is not None
        }
        columns = self._data.table([(name, values.tolist()) for name, values in axes.items()])
        shape = tuple(values.size for values in axes.values())
        positions = int(np.prod(shape))
        return {
            name: column.reshape(shape if column.size == positions else (*shape, 3))
            for name, column in columns.items()
        }

    def radius_difference(self, *, roll: bool = False) -> tuple[Floats, Floats]:
        """(y, right wheel's rolling radius less the left's), both in metres, as far as contact
        exists. With roll the wheelset is rolled until both wheels touch, else it is as EN 15302 has
        it.
        """
        y, difference = np.array(self._data.radius_difference(roll)).reshape(-1, 2).T
        return y, difference

    def conicity(self, amplitude: ArrayLike, *, roll: bool = False) -> Floats:
        """Equivalent conicity of EN 15302 at amplitudes (m), half of y_max - y_min; NaN where
        contact ends before or nothing steers. Warns where wheels stand on their flanges, up to the
        largest amplitude, and of rough profiles."""
        amplitudes = floats("amplitude", amplitude)
        found, cautions = self._data.conicity(amplitudes.ravel().tolist(), roll)
        for words in cautions:
            warnings.warn(words, UserWarning, stacklevel=2)
        return np.array(found).reshape(amplitudes.shape)

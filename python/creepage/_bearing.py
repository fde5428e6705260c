"""Ball bearings, by the files of `creepage bearing`."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

from . import _creepage
from ._report import ReportedList
from ._toml import Source, text_of


@dataclass(frozen=True, slots=True)
class BearingRace:
    """One contact of a ball and a ring, in SI units; the ball above the ring, `x` the way the contact travels."""

    contact_angle: float
    """(rad)"""
    normal_force: float
    """(N)"""
    semi_axes: tuple[float, float]
    """Along rolling and across (m)."""
    peak_pressure: float
    """(Pa)"""
    approach: float
    """(m)"""
    rolling_speed: float | None
    """(m/s); None, here and below, where nothing rolls."""
    creepage: tuple[float, float] | None
    """Of the ball against the ring in the middle, along rolling and across."""
    spin: float | None
    """(rad/m)"""
    heathcote_creepage: float | None
    """At the end of the ellipse, beyond that in its middle."""
    force: tuple[float, float] | None
    """Of the ball on the ring, along rolling and across (N)."""
    moment: float | None
    """About the normal (N m)."""
    adhesion_share: float | None
    """Adhesion area over contact area."""
    sliding_speed: float
    """The largest (m/s)."""
    heat: float
    """(W)"""


@dataclass(frozen=True, slots=True)
class BearingBall:
    """One ball of a bearing."""

    azimuth: float
    """Its place, from that of the radial load (rad)."""
    orbit: float | None
    """Angular velocity of its orbit, that of a cage (rad/s); None, here and below, where nothing turns."""
    rotation: float | None
    """Its own angular velocity in the frame of the orbit (rad/s)."""
    pitch: float | None
    """Angle of its axis from the bearing's (rad)."""
    yaw_rate: float | None
    """Its angular velocity about the direction around the bearing (rad/s): gyroscopic slip."""
    centrifugal_force: float
    """(N)"""
    gyroscopic_moment: float
    """(N m)"""
    inner: BearingRace | None
    """The inner contact; None where the ball does not reach the inner race."""
    outer: BearingRace | None
    """The outer contact."""


@dataclass(frozen=True, slots=True, eq=False)
class BearingSolution(ReportedList):
    """A ball bearing, solved, in SI units."""

    status: str
    """ "solved", or the worst of all contacts."""
    caution: str | None
    """What is doubtful, with its number; else None."""
    heat: float
    """Of all contacts (W)."""
    race_heat: tuple[float, float]
    """Of those at the inner and at the outer race (W)."""
    friction_moment: float
    """About the axis (N m)."""
    load: tuple[float, float]
    """What the balls carry along the axis and radially (N)."""
    displacement: tuple[float, float]
    """Of the inner ring along the axis and radially (m)."""
    orbit: float | None
    """Mean angular velocity of the balls' orbit (rad/s)."""
    peak_pressure: float
    """The largest (Pa)."""
    sliding_speed: float
    """The largest (m/s)."""
    alike: int
    """How many balls are like each of those in `balls`."""
    balls: tuple[BearingBall, ...]
    """Every ball that differs from others."""
    _solved: _creepage.SolvedBearing
    _again: Callable[[], Any]


def bearing(source: Source | Mapping[str, Mapping[str, Any]]) -> BearingSolution:
    """Solves a ball bearing: loads, spin, sliding and heat of every ball.

    source: the path of a bearing file, its text (a string with line breaks), or its sections as a mapping.
    Raises CaseError for what is no bearing, loads that nothing carries, and balls that slide about; OSError for
    what cannot be read.
    """
    text = text_of(source)
    solved = _creepage.SolvedBearing(text)
    report = json.loads(solved.json())
    return BearingSolution(
        report["status"],
        report["caution"],
        report["heat_w"],
        (report["inner_heat_w"], report["outer_heat_w"]),
        report["friction_moment_n_m"],
        (report["axial_load_n"], report["radial_load_n"]),
        (report["axial_displacement_m"], report["radial_displacement_m"]),
        report["orbit_rad_per_s"],
        report["peak_pressure_pa"],
        report["largest_sliding_speed_m_per_s"],
        report["alike"],
        tuple(_ball(ball) for ball in report["balls"]),
        solved,
        partial(bearing, text),
    )


def _ball(ball: Mapping[str, Any]) -> BearingBall:
    return BearingBall(
        ball["azimuth_rad"],
        ball["orbit_rad_per_s"],
        ball["rotation_rad_per_s"],
        ball["pitch_rad"],
        ball["yaw_rate_rad_per_s"],
        ball["centrifugal_force_n"],
        ball["gyroscopic_moment_n_m"],
        _race(ball["inner"]),
        _race(ball["outer"]),
    )


def _race(race: Mapping[str, Any] | None) -> BearingRace | None:
    if race is None:
        return None
    rolls = race["rolling_speed_m_per_s"] is not None
    return BearingRace(
        race["contact_angle_rad"],
        race["normal_force_n"],
        (race["semi_axis_rolling_m"], race["semi_axis_lateral_m"]),
        race["peak_pressure_pa"],
        race["approach_m"],
        race["rolling_speed_m_per_s"],
        (race["longitudinal_creepage"], race["lateral_creepage"]) if rolls else None,
        race["spin_rad_per_m"],
        race["heathcote_creepage"],
        (race["longitudinal_n"], race["lateral_n"]) if rolls else None,
        race["moment_n_m"],
        race["adhesion_share"],
        race["sliding_speed_m_per_s"],
        race["heat_w"],
    )

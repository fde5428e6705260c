"""A vehicle with two bogies in Exudyn: irregular track, a transition, a curve; contact forces by a map.

    pip install exudyn matplotlib
    python exudyn_vehicle.py                             # a hundredth of a second by `fastsim`
    python exudyn_vehicle.py wheelset.nc                 # six seconds of motion, a picture, three theories timed
    python exudyn_vehicle.py wheelset.nc --seconds 0.1   # a short one

Exudyn has the bodies (a car, two bogies, four wheelsets and their rotation), the suspension and the steps in time;
creepage has the contacts. Coordinates are those of a frame that goes along the track with the car, x forward, y right,
z down: a curve is where the rails lie under each wheelset, with a centrifugal load. Height, roll and pitch rate of the
wheelsets are states, so nothing is left for the map to find; it is asked for all wheelsets at once, in every stage
of every step. Loads of standing still are in balance with the springs from the start.

Left out: flexible rails, cant, gyroscopic moments of the wheels, gravity's share in the sway of the bodies.
"""

from __future__ import annotations

import argparse
import importlib
import importlib.util
import math
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import creepage
import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Asked = dict[str, Array]
"""Position and motion of all wheelsets, by the names of `ContactMap.solve`."""

SPEED, AXLE_LOAD, FRICTION, RADIUS = 22.0, 100e3, 0.3, 0.46
CURVATURE, RAMP = 1.0 / 900.0, (25.0, 75.0)  # 1/m, to the right; m: where the transition begins and ends
WHEELSET, BOGIE, CAR = (  # kg; kg m^2 about x, y, z
    (1500.0, (900.0, 100.0, 900.0)),
    (2600.0, (1700.0, 1500.0, 3100.0)),
    (28e3, (50e3, 1.3e6, 1.3e6)),
)
AXLES, PIVOTS = 1.25, 8.75  # m: half the distance of a bogie's wheelsets, and of the bogies
BOGIE_HEIGHT, CAR_HEIGHT = -0.6, -1.6  # m, from the top of the rails
# Of a wheelset in its bogie, of a bogie under the car: along x, y, z (N/m), about x, y, z (N m/rad); dampers.
PRIMARY = (10e6, 5e6, 1.6e6, 1.6e6, 1e6, 6e6), (30e3, 20e3, 30e3, 30e3, 10e3, 20e3)
SECONDARY = (0.4e6, 0.32e6, 0.8e6, 0.9e6, 1e6, 0.2e6), (40e3, 50e3, 60e3, 60e3, 40e3, 150e3)
TRACTION = (0.2e6, 0, 0, 0, 0, 0), (60e3, 0, 0, 0, 0, 0)
CAR_BODY, BOGIES = 0, (1, 2)


def wheelset(theory: str = "exact") -> creepage.Wheelset:
    """One wheelset on its track; the map is built of the same."""
    return creepage.Wheelset(
        wheel="S1002",
        rail="UIC60",
        cant=math.atan(1 / 40),
        axle_load=AXLE_LOAD,
        friction=FRICTION,
        radius=RADIUS,
        theory=theory,
    )


@dataclass(frozen=True)
class Track:
    """A curve behind a transition, and waves of both rails, every centimetre along the track."""

    rows: Array
    """Rails aside (m), down (m), roll (rad), their slopes; heading, its integral, curvature, the slope of that."""

    STEP, FIRST = 0.01, -20.0

    @classmethod
    def irregular(cls, length: float, seed: int = 52) -> Track:
        """Twenty waves of 6 to 40 m, each as high as it is long, random in phase."""
        random = np.random.default_rng(seed)
        s = np.arange(cls.FIRST, length, cls.STEP)
        lengths = np.geomspace(6.0, 40.0, 20)
        heights = lengths / 40.0 * random.uniform(0.5, 1.0, (3, 20)) * [[6e-4], [8e-4], [5e-4]]
        number, phase = 2.0 * np.pi / lengths, random.uniform(0.0, 2.0 * np.pi, 20)
        angle = np.multiply.outer(number, s) + phase[:, None]
        # From nothing over the first ten metres, where the vehicle stands true.
        part = np.clip((s - PIVOTS - AXLES) / 10.0, 0.0, 1.0)
        waves = part * part * (3.0 - 2.0 * part) * (heights @ np.sin(angle))
        begin, end = RAMP
        rise, inside, beyond = CURVATURE / (end - begin), np.clip(s, begin, end) - begin, np.maximum(s - end, 0.0)
        slope = np.where((s > begin) & (s < end), rise, 0.0)
        heading = 0.5 * rise * inside**2 + CURVATURE * beyond
        aside = rise * inside**3 / 6.0 + 0.5 * CURVATURE * ((end - begin) * beyond + beyond**2)
        slopes = np.gradient(waves, cls.STEP, axis=1)
        return cls(np.column_stack((*waves, *slopes, heading, aside, rise * inside, slope)))

    def at(self, s: Array) -> Array:
        """The columns of `rows` at places along the track, a row each."""
        place = (s - self.FIRST) / self.STEP
        before = place.astype(int)
        part = (place - before)[..., None]
        found: Array = (1.0 - part) * self.rows[before] + part * self.rows[before + 1]
        return found.T


@dataclass(frozen=True)
class Vehicle:
    """Where the contacts are asked, from the bodies' coordinates: those of four wheelsets, six each, then pitch."""

    track: Track
    forces: Callable[[Asked], Array]
    """Wrenches on the wheelsets, a row each."""
    places: Array
    """Of the wheelsets, from the car's centre (m)."""
    mass: Array
    """Of all bodies (kg): wheelsets, car, bogies."""
    inertia: Array
    """About z (kg m^2)."""
    ahead: Array
    """Of all bodies, from the car's centre (m)."""
    lateral = np.r_[1:24:6, 29:46:6]
    turning = np.r_[5:24:6, 33:46:6]

    def asked(self, t: float, q: Array, q_t: Array) -> tuple[Asked, Array]:
        """Position and motion of the wheelsets over their track, and the track's directions at them."""
        aside, down, roll, *slopes, heading, line, curvature, _ = self.track.at(
            np.append(SPEED * t + self.places, SPEED * t)
        )
        turned = (heading - heading[4] + slopes[0])[:4]
        off = (line - line[4] + aside)[:4] - heading[4] * self.places
        turning = SPEED * curvature[4]
        place, motion = q[:24].reshape(4, 6), q_t[:24].reshape(4, 6)
        asked = {
            "y": place[:, 1] - off,
            "z": place[:, 2] - down[:4],
            "roll": place[:, 3] - roll[:4],
            "yaw": place[:, 5] - turned,
            "speed": SPEED + motion[:, 0],
            "pitch_rate": q_t[24:28],
            "lateral_velocity": motion[:, 1] + turning * self.places - SPEED * turned,
            "vertical_velocity": motion[:, 2] - SPEED * slopes[1][:4],
            "roll_rate": motion[:, 3] - SPEED * slopes[2][:4],
            "yaw_rate": motion[:, 5] + turning,
        }
        return asked, turned

    def loads(self, t: float, q: Array, q_t: Array) -> Array:
        """On all coordinates: contacts, the static load that presses them, centrifugal forces."""
        asked, turned = self.asked(t, q, q_t)
        wrench = self.forces(asked)
        found = np.zeros(len(q))
        on_wheelsets = found[:24].reshape(4, 6)
        on_wheelsets[:, :4] = wrench[:, :4]
        on_wheelsets[:, 0] -= turned * wrench[:, 1]
        on_wheelsets[:, 1] += turned * wrench[:, 0]
        on_wheelsets[:, 2] += AXLE_LOAD
        on_wheelsets[:, 5] = wrench[:, 5]
        found[24:28] = -wrench[:, 4]
        *_, curvature, slope = self.track.at(np.array(SPEED * t))
        found[self.lateral] -= self.mass * SPEED**2 * (curvature + slope * self.ahead)
        found[self.turning] -= self.inertia * SPEED**2 * slope
        return found


def by_map(contacts: creepage.ContactMap) -> Callable[[Asked], Array]:
    """All wheelsets at once."""

    def forces(asked: Asked) -> Array:
        found = contacts.solve_many(friction=FRICTION, **asked)
        if not np.isfinite(found.wrench).all():
            raise ValueError("; ".join(one for one in found.status if one != "solved"))
        return found.wrench

    return forces


def by_solver(solver: creepage.WheelsetSolver) -> Callable[[Asked], Array]:
    """Each wheelset from where it was."""
    before: list[creepage.WheelsetResult | None] = [None] * 4

    def forces(asked: Asked) -> Array:
        rows = []
        for k in range(4):
            one: dict[str, Any] = {name: float(values[k]) for name, values in asked.items()}
            found = solver.solve(start=before[k], **one)
            before[k] = found
            rows.append(found.wrench)
        return np.array(rows)

    return forces


def diagonal(numbers: tuple[float, ...]) -> list[list[float]]:
    """The matrix of a connector."""
    return [list(row) for row in np.diag(np.array(numbers, dtype=float))]


@dataclass(frozen=True)
class Run:
    """What was simulated: times, coordinates and velocities as `Vehicle.asked` takes them."""

    vehicle: Vehicle
    times: Array
    coordinates: Array
    velocities: Array
    took: float
    """Seconds on the clock."""
    asking: float
    """Of these in the contacts."""

    @property
    def real_time_factor(self) -> float:
        """Time on the clock over time of the motion."""
        return self.took / float(self.times[-1])

    def asked(self, row: int) -> Asked:
        """Position and motion of the wheelsets."""
        return self.vehicle.asked(float(self.times[row]), self.coordinates[row], self.velocities[row])[0]


def simulate(
    forces: Callable[[Asked], Array], rest: creepage.MapResult | creepage.WheelsetResult, seconds: float, step: float = 4e-4
) -> Run:
    """The vehicle from straight track on."""
    # Without types, and not everywhere to be had.
    exu: Any = importlib.import_module("exudyn")
    made_of: Any = importlib.import_module("exudyn.utilities")

    mbs: Any = exu.SystemContainer().AddSystem()

    def body(of: tuple[float, tuple[float, ...]], place: list[float]) -> dict[str, int]:
        mass, inertia = of
        made: dict[str, int] = mbs.CreateRigidBody(
            inertia=made_of.RigidBodyInertia(mass=mass, inertiaTensor=np.diag(inertia)),
            nodeType=exu.NodeType.RotationRxyz,
            referencePosition=place,
            initialDisplacement=[0.0, 0.0, rest.z],
            returnDict=True,
        )
        return made

    def connect(one: int, at: list[float], other: int, by: tuple[tuple[float, ...], tuple[float, ...]], on: list[float]) -> None:
        markers = [
            mbs.AddMarker(made_of.MarkerBodyRigid(bodyNumber=body, localPosition=place))
            for body, place in ((one, at), (other, on))
        ]
        stiffness, damping = (diagonal(numbers) for numbers in by)
        mbs.AddObject(
            made_of.ObjectConnectorRigidBodySpringDamper(markerNumbers=markers, stiffness=stiffness, damping=damping)
        )

    places = np.array([PIVOTS + AXLES, PIVOTS - AXLES, -PIVOTS + AXLES, -PIVOTS - AXLES])
    wheelsets = [body(WHEELSET, [x, 0.0, -RADIUS]) for x in places]
    rotors = [mbs.AddNode(made_of.Node1D(initialVelocities=[rest.pitch_rate])) for _ in wheelsets]
    car = body(CAR, [0.0, 0.0, CAR_HEIGHT])
    bogies = [body(BOGIE, [x, 0.0, BOGIE_HEIGHT]) for x in (PIVOTS, -PIVOTS)]
    for k, wheels in enumerate(wheelsets):
        aside = AXLES if k % 2 == 0 else -AXLES
        bogie = bogies[k // 2]["bodyNumber"]
        connect(bogie, [aside, 0.0, -RADIUS - BOGIE_HEIGHT], wheels["bodyNumber"], PRIMARY, [0.0] * 3)
    for x, bogie_body in zip((PIVOTS, -PIVOTS), bogies, strict=True):
        connect(car["bodyNumber"], [x, 0.0, BOGIE_HEIGHT - CAR_HEIGHT], bogie_body["bodyNumber"], SECONDARY, [0.0] * 3)
    ground = mbs.AddObject(made_of.ObjectGround())
    connect(ground, [0.0, 0.0, CAR_HEIGHT], car["bodyNumber"], TRACTION, [0.0] * 3)
    nodes = [one["nodeNumber"] for one in wheelsets] + rotors + [one["nodeNumber"] for one in (car, *bogies)]
    asking = 0.0

    def timed(asked: Asked) -> Array:
        nonlocal asking
        began = time.perf_counter()
        wrench = forces(asked)
        asking += time.perf_counter() - began
        return wrench

    bodies = [WHEELSET] * 4 + [CAR] + [BOGIE] * 2
    vehicle = Vehicle(
        Track.irregular(SPEED * seconds + 30.0),
        timed,
        places,
        mass=np.array([mass for mass, _ in bodies]),
        inertia=np.array([inertia[2] for _, inertia in bodies]),
        ahead=np.r_[places, 0.0, PIVOTS, -PIVOTS],
    )

    def push(_mbs: Any, t: float, _item: int, q: Any, q_t: Any) -> Array:
        return vehicle.loads(t, np.asarray(q), np.asarray(q_t))

    size = 28 + 18
    zero, masses = np.zeros((2, size, size))
    # The wheels' rotation; bodies have their own masses.
    masses[range(24, 28), range(24, 28)] = WHEELSET[1][1]
    mbs.AddObject(
        made_of.ObjectGenericODE2(
            nodeNumbers=nodes, massMatrix=masses, stiffnessMatrix=zero, dampingMatrix=zero, forceUserFunction=push
        )
    )
    def kept(_mbs: Any, _t: float, _sensors: Any, _factors: Any, _kind: Any) -> Array:
        # Nodes are numbered as they were made: in the order of `nodes`.
        state: Array = np.r_[mbs.systemData.GetODE2Coordinates(), mbs.systemData.GetODE2Coordinates_t()]
        return state

    sensor = mbs.AddSensor(made_of.SensorUserFunction(sensorUserFunction=kept, storeInternal=True))
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = max(round(seconds / step), 1)
    settings.timeIntegration.endTime = settings.timeIntegration.numberOfSteps * step
    settings.timeIntegration.verboseMode = 0
    settings.solution.file.write = False
    settings.solution.sensors.writePeriod = max(step, min(5e-3, seconds / 10.0))
    started = time.perf_counter()
    mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.RK44)
    took = time.perf_counter() - started
    stored = np.asarray(mbs.GetSensorStoredData(sensor))
    return Run(vehicle, stored[:, 0], stored[:, 1 : 1 + size], stored[:, 1 + size :], took, asking)


@dataclass(frozen=True)
class Histories:
    """Over time: of each wheelset its place, of each wheel Y/Q and T gamma; shape (times, 4) and (times, 4, 2)."""

    y: Array
    guiding: Array
    wear: Array


def histories(run: Run, contacts: creepage.ContactMap) -> Histories:
    """Looked up again at the times that were kept."""
    count = len(run.times)
    y, guiding, wear = np.empty((count, 4)), np.empty((count, 4, 2)), np.empty((count, 4, 2))
    for row in range(count):
        asked = run.asked(row)
        y[row] = asked["y"]
        for k in range(4):
            one: dict[str, Any] = {name: float(v[k]) for name, v in asked.items()}
            found = contacts.solve(friction=FRICTION, **one)
            for side, wheel in enumerate((found.left, found.right)):
                guiding[row, k, side] = wheel.force[1] / wheel.force[2] if wheel.force[2] > 0.0 else 0.0
                wear[row, k, side] = sum(np.dot(one.force, one.creepage) for one in wheel.patches)
    return Histories(y, guiding, wear)


def compared(
    run: Run, contacts: creepage.ContactMap, solver: creepage.WheelsetSolver, count: int = 40
) -> dict[str, tuple[float, float]]:
    """Root mean square and largest difference of the map from the solver on states of the leading wheelset: lateral
    forces of both wheels over mu times half the axle load, loads over the solver's."""
    lateral, loads = [], []
    start = None
    for row in np.linspace(0, len(run.times) - 1, count).astype(int):
        asked = {name: values[:1] for name, values in run.asked(int(row)).items()}
        one: dict[str, Any] = {name: float(values[0]) for name, values in asked.items()}
        start = solver.solve(start=start, **one)
        found = contacts.solve(friction=FRICTION, **one)
        for mine, exact in ((found.left, start.left), (found.right, start.right)):
            lateral.append((mine.force[1] - exact.force[1]) / (FRICTION * 0.5 * AXLE_LOAD))
            loads.append(mine.force[2] / exact.force[2] - 1.0)
    return {
        name: (float(np.sqrt(np.mean(np.square(values)))), float(np.abs(values).max()))
        for name, values in (("lateral force", lateral), ("load", loads))
    }


def picture(run: Run, found: Histories, path: Path) -> None:
    """Track, places, Y/Q of the leading wheelset, wear numbers of the outer wheels."""
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(4, 1, figsize=(7.5, 8.5), sharex=True, layout="constrained")
    s = SPEED * run.times
    aside, down, *_, curvature, _ = run.vehicle.track.at(s)
    axes[0].plot(s, 1e3 * aside, label="rails aside (mm)")
    axes[0].plot(s, 1e3 * down, label="rails down (mm)")
    axes[0].plot(s, 1e3 * curvature, "k", label="curvature (1/km)")
    for k in range(4):
        axes[1].plot(s, 1e3 * found.y[:, k], label=f"wheelset {k + 1}")
        axes[3].plot(s, found.wear[:, k].sum(axis=1), label=f"wheelset {k + 1}")
    for side, name in enumerate(("left (outer)", "right (inner)")):
        axes[2].plot(s, found.guiding[:, 0, side], label=name)
    axes[1].set_ylabel("y on the track (mm)")
    axes[2].set_ylabel("Y/Q, leading wheelset")
    axes[3].set(ylabel="T gamma of both wheels (N)", xlabel="along the track (m)")
    for ax in axes:
        ax.legend(loc="upper left", fontsize="small", ncols=4)
    figure.savefig(path, dpi=120)
    plt.close(figure)


def main() -> None:
    """Runs, prints, draws."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("map", nargs="?", help="by `creepage map`, of the wheelset above")
    parser.add_argument("--seconds", type=float, default=6.0)
    parser.add_argument("--picture", type=Path, default=Path("exudyn-vehicle.png"))
    options = parser.parse_args()
    if importlib.util.find_spec("exudyn") is None:
        print("exudyn is not installed here: pip install exudyn")
        return
    if options.map is None:
        solver = wheelset("fastsim").solver()
        short = simulate(by_solver(solver), solver.solve(y=0.0, speed=SPEED), 0.01)
        print(f"fastsim: {short.real_time_factor:.0f} s on the clock for a second of motion")
        return
    contacts = creepage.ContactMap.load(options.map)
    rest = contacts.solve(y=0.0, axle_load=AXLE_LOAD, speed=SPEED, friction=FRICTION)
    run = simulate(by_map(contacts), rest, options.seconds)
    share = run.asking / run.took
    print(f"map: {run.real_time_factor:.2f} s on the clock for a second of motion, {100 * share:.0f} % of it contacts")
    for theory in ("fastsim", "exact"):
        # Twenty steps, the first of which finds its contacts from nothing.
        short = simulate(by_solver(wheelset(theory).solver()), rest, 0.008)
        print(f"{theory}: {short.real_time_factor:.0f} s")
    for name, (rms, worst) in compared(run, contacts, wheelset().solver()).items():
        print(f"map against exact on the way, {name}: {100 * rms:.2f} % rms, worst {100 * worst:.2f} %")
    found = histories(run, contacts)
    print(f"largest Y/Q {np.abs(found.guiding).max():.2f}, largest T gamma of a wheel {found.wear.max():.0f} N")
    picture(run, found, options.picture)


if __name__ == "__main__":
    main()

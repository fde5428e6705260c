"""A contact map, and a wheelset's file for the solver itself, as an FMU, validated and simulated by FMPy, and by an importer in Rust: both versions, both kinds."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import creepage
import numpy as np
import pytest

fmpy = pytest.importorskip("fmpy")
validation = pytest.importorskip("fmpy.validation")

ROOT = Path(__file__).parents[2]
INPUTS = ("y", "yaw", "axle_load", "speed", "lateral_velocity", "yaw_rate", "friction")


def _library() -> Path:
    """The library of the FMU: that of the wheel's build, or built here where that was elsewhere."""
    suffix = {"linux": ".so", "darwin": ".dylib"}.get(sys.platform, ".dll")
    name = ("" if suffix == ".dll" else "lib") + "creepage_fmu" + suffix
    target = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "debug"
    beside = target / "deps" / name
    if beside.exists():
        return beside
    subprocess.run(["cargo", "build", "-p", "creepage-fmu", "--locked"], cwd=ROOT, check=True)
    return target / name


@pytest.fixture(scope="module")
def fmus(contact_map: creepage.ContactMap, tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """Of FMI 2 and 3, in a folder with a blank in its name."""
    folder = tmp_path_factory.mktemp("two units")
    path, library = folder / "wheelset.nc", _library()
    contact_map.save(path)
    made = []
    for version in ("2", "3"):
        out = folder / f"W{version}.fmu"
        command = [sys.executable, "-m", "creepage", "fmu", str(path), "--fmi", version]
        subprocess.run([*command, "--out", str(out), "--library", str(library)], check=True)
        made.append(out)
    return made


def test_they_are_valid(fmus: list[Path]) -> None:
    for path in fmus:
        assert validation.validate_fmu(str(path)) == []


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_forces_are_those_of_the_map(
    fmus: list[Path], contact_map: creepage.ContactMap, kind: str
) -> None:
    time = np.linspace(0.0, 0.1, 11)
    y = 0.0004 * np.sin(30.0 * time)
    yaw = 0.002 * np.cos(30.0 * time)
    rows = np.array(
        list(zip(time, y, yaw, strict=True)), dtype=[("time", float), ("y", float), ("yaw", float)]
    )
    for path in fmus:
        result = fmpy.simulate_fmu(
            str(path),
            fmi_type=kind,
            stop_time=0.1,
            output_interval=0.01,
            step_size=0.01,
            input=rows,
            output=["wrench_y", "right_x", "found_z", "y", "yaw"],
        )
        for row in result[1:]:
            found = contact_map.solve(y=row["y"], yaw=row["yaw"])
            # The inputs of each row are those that the host set: the same bits, but for what Co-Simulation
            # shows at the end of a step, one step late.
            if kind == "ModelExchange":
                assert row["right_x"] == pytest.approx(found.right.force[0], rel=1e-12, abs=1e-9)
                assert row["wrench_y"] == pytest.approx(found.wrench[1], rel=1e-12, abs=1e-9)
            assert abs(row["found_z"] - found.z) < 1e-4


@pytest.fixture(scope="module")
def importer() -> Path:
    """The importer in Rust, built here; without a compiler of C and Clang's library there is none."""
    clang = pytest.importorskip("clang")
    headers = subprocess.run(
        ["cc", "-print-file-name=include"], capture_output=True, text=True, check=False
    ).stdout.strip()
    built = ROOT / "target" / "fmu-importer"
    done = subprocess.run(
        ["cargo", "build", "--quiet", "--locked"],
        cwd=Path(__file__).parent / "fmu-importer",
        env={
            **os.environ,
            "CARGO_TARGET_DIR": str(built),
            "LIBCLANG_PATH": str(Path(clang.__file__).parent / "native"),
            "BINDGEN_EXTRA_CLANG_ARGS": f"-I{headers}",
        },
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode != 0:
        pytest.skip(f"the importer in Rust does not build here: {done.stderr.strip()[-200:]}")
    return built / "debug" / "fmu-importer"


@pytest.mark.parametrize("kind", ["me", "cs"])
def test_another_importer_finds_the_same_forces(
    fmus: list[Path], contact_map: creepage.ContactMap, importer: Path, kind: str
) -> None:
    found = contact_map.solve(y=3e-4, yaw=-1e-3)
    for path in fmus:
        variables = fmpy.read_model_description(str(path)).modelVariables
        at = {variable.name: variable.valueReference for variable in variables}
        inputs, outputs = f"{at['y']}=3e-4,{at['yaw']}=-1e-3", f"{at['wrench_y']},{at['right_x']}"
        done = subprocess.run(
            [importer, path, kind, inputs, outputs], capture_output=True, text=True, check=True
        )
        forces = [float(line) for line in done.stdout.split()]
        # The same search from the same start: only rounding may differ.
        assert forces == pytest.approx([found.wrench[1], found.right.force[0]], rel=1e-12, abs=1e-9)


def test_outside_the_map_a_step_is_discarded(fmus: list[Path]) -> None:
    messages: list[str] = []
    with pytest.raises(Exception):
        fmpy.simulate_fmu(
            str(fmus[0]),
            fmi_type="CoSimulation",
            stop_time=0.01,
            start_values={"y": 0.05},
            logger=lambda *arguments: messages.append(str(arguments)),
        )


def test_derivatives_and_states(fmus: list[Path]) -> None:
    for path in fmus:
        description = fmpy.read_model_description(str(path))
        references = {variable.name: variable.valueReference for variable in description.modelVariables}
        unit = fmpy.instantiate_fmu(fmpy.extract(str(path)), description, fmi_type="ModelExchange")
        is_two = description.fmiVersion == "2.0"
        get, put = (unit.getReal, unit.setReal) if is_two else (unit.getFloat64, unit.setFloat64)
        if is_two:
            unit.setupExperiment()
        unit.enterInitializationMode()
        unit.exitInitializationMode()
        y, force = references["y"], references["wrench_y"]
        state = unit.getFMUstate() if is_two else unit.getFMUState()
        step, yaw = 2e-5, references["yaw"]
        at = []
        for turn in (1e-3 - step, 1e-3 + step):
            put([yaw], [turn])
            at.append(get([force])[0])
        put([yaw], [1e-3])
        slope = unit.getDirectionalDerivative([force], [yaw], [1.0])[0]
        # What the search for roll and pitch rate leaves is worth some newtons.
        assert slope == pytest.approx((at[1] - at[0]) / (2.0 * step), rel=1e-2)
        # Kalker's C22 of both wheels is about 1.2e7 N/rad with the areas of 50 kN.
        assert 4e6 < abs(slope) < 2e7
        put([yaw], [0.0])
        put([y], [3e-4])
        moved = get([force])[0]
        kept = unit.serializeFMUstate(state) if is_two else unit.serializeFMUState(state)
        (unit.setFMUstate if is_two else unit.setFMUState)(state)
        assert get([y])[0] == 0.0
        assert get([force])[0] != moved
        assert len(kept) > 0
        (unit.freeFMUstate if is_two else unit.freeFMUState)(state)
        unit.terminate()
        unit.freeInstance()


def _chatter(path: Path, part: float, delayed: bool) -> float:
    """By how much the change of the motion from step to step grows over 300 steps of Co-Simulation at 10 m/s, of a wheelset on
    springs whose host holds the forces over each step, of `part` of the guide's longest one."""
    mass, inertia, stiffness, speed = 1500.0, 900.0, (0.7e6, 0.7e6), 10.0
    description = fmpy.read_model_description(str(path))
    at = {variable.name: variable.valueReference for variable in description.modelVariables}
    unit = fmpy.instantiate_fmu(fmpy.extract(str(path)), description, fmi_type="CoSimulation")
    unit.enterInitializationMode()
    unit.setFloat64([at["speed"]], [speed])
    unit.exitInitializationMode()
    pairs = (("wrench_y", "lateral_velocity"), ("wrench_moment_z", "yaw_rate"))
    damping = [
        -unit.getDirectionalDerivative([at[force]], [at[rate]], [1.0])[0] for force, rate in pairs
    ]
    step = part * 2.0 * min(mass / damping[0], inertia / damping[1]) * (0.5 if delayed else 1.0)
    y, yaw, velocity, turning = 1e-4, 0.0, 0.0, 0.0
    held, changes = [0.0, 0.0], []
    for k in range(300):
        inputs = [at[name] for name in ("y", "yaw", "lateral_velocity", "yaw_rate")]
        unit.setFloat64(inputs, [y, yaw, velocity, turning])
        unit.doStep(currentCommunicationPoint=k * step, communicationStepSize=step)
        found = list(unit.getFloat64([at["wrench_y"], at["wrench_moment_z"]]))
        force, moment = held if delayed else found
        held = found
        change = step * (force - stiffness[0] * y) / mass, step * (moment - stiffness[1] * yaw) / inertia
        velocity, turning = velocity + change[0], turning + change[1]
        changes.append(max(map(abs, change)))
        y, yaw = y + step * velocity, yaw + step * turning
    unit.terminate()
    unit.freeInstance()
    # Of the first steps: after thirty friction may bound what grows.
    return float(max(changes[-30:]) / max(changes[:3]))


@pytest.mark.parametrize("delayed", [False, True])
def test_the_longest_step_of_co_simulation_is_that_of_the_guide(fmus: list[Path], delayed: bool) -> None:
    # Below it the changes of the start die out. Above, they grow by 1.3 a step, by 1.07 with the delay, until friction
    # bounds them, far above those of a start .1 mm off.
    assert _chatter(fmus[1], 0.85, delayed) < 1.0
    assert _chatter(fmus[1], 1.15, delayed) > 10.0


def test_a_hundred_loads_and_unloads_leave_neither_threads_nor_memory(
    fmus: list[Path], tmp_path: Path
) -> None:
    system = Path("/proc/self")
    if not (system / "maps").exists():
        pytest.skip("threads and memory are counted on Linux")

    def threads() -> int:
        return len(list((system / "task").iterdir()))

    def memory() -> int:
        return int((system / "statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")

    unpacked = str(fmpy.extract(str(fmus[1]), str(tmp_path / "W")))
    description = fmpy.read_model_description(unpacked)

    def once() -> None:
        unit = fmpy.instantiate_fmu(unpacked, description, fmi_type="CoSimulation")
        unit.enterInitializationMode()
        unit.exitInitializationMode()
        unit.doStep(currentCommunicationPoint=0.0, communicationStepSize=1e-3)
        unit.terminate()
        unit.freeInstance()

    for _ in range(3):
        once()
    before = threads(), memory()
    for _ in range(100):
        once()
    assert threads() <= before[0]
    # The library is unloaded: no copy of it stays mapped.
    assert unpacked not in (system / "maps").read_text()
    # A map that were kept would be as large as its file at least, a hundred times; this is a tenth of that.
    grown = memory() - before[1]
    assert grown < 10 * (fmus[1].parent / "wheelset.nc").stat().st_size, grown


@pytest.fixture(scope="module")
def solvers(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, list[Path]]:
    """A wheelset's file with a profile from a folder of its own, and FMUs of FMI 2 and 3 that solve it."""
    folder, library = tmp_path_factory.mktemp("solved"), _library()
    (folder / "scans").mkdir()
    scan = ROOT / "crates" / "creepage-rail" / "samples" / "worn_rail.ban"
    (folder / "scans" / "rail 1.ban").write_bytes(scan.read_bytes())
    path = folder / "wheelset.toml"
    path.write_text(
        """
[wheel]
profile = "S1002"
radius = 0.46
[rail]
profile = "scans/rail 1.ban"
cant = 0.025
[track]
gauge = 1.435
gauge_height = 0.014
[wheelset]
back_to_back = 1.360
axle_load = 100e3
[motion]
speed = 20.0
[contact]
friction = 0.3
[materials]
shear_modulus = 82e9
poisson = 0.28
[solve]
theory = "exact"
resolution = "fast"
"""
    )
    made = []
    for version in ("2", "3"):
        out = folder / f"W{version}.fmu"
        command = [sys.executable, "-m", "creepage", "fmu", str(path), "--exact", "--fmi", version]
        subprocess.run([*command, "--out", str(out), "--library", str(library)], check=True)
        made.append(out)
    return path, made


@pytest.mark.filterwarnings("ignore::UserWarning")
@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_forces_are_those_of_the_solver(solvers: tuple[Path, list[Path]], kind: str) -> None:
    path, made = solvers
    solver = creepage.Wheelset.from_toml(path).solver()
    given: dict[str, Any] = {"y": 0.0005, "yaw": -0.002, "lateral_velocity": 0.01, "axle_load": 110e3}
    exact = solver.solve(**given)
    text = path.read_text().replace("friction = 0.3", "friction = 0.2")
    friction = creepage.Wheelset.from_toml(text, path.parent).solver().solve(**given)
    for fmu in made:
        assert validation.validate_fmu(str(fmu)) == []
        for more, right in (({}, exact), ({"friction": 0.2}, friction)):
            messages: list[str] = []
            # FMPy has one logger for all units of FMI 2, that of the last call: an earlier one may be gone.
            result = fmpy.simulate_fmu(
                str(fmu),
                logger=lambda *arguments, told=messages: told.append(str(arguments)),
                fmi_type=kind,
                stop_time=0.002,
                output_interval=0.001,
                step_size=0.001,
                start_values={**given, **more},
                output=["wrench_y", "wrench_moment_z", "left_x", "right_z", "found_roll", "left_error"],
            )
            assert any("rough" in message for message in messages), messages
            for row in result:
                # The same solution from nothing: only the sums may differ by rounding.
                assert row["left_x"] == pytest.approx(right.left.force[0], rel=1e-9)
                assert row["right_z"] == pytest.approx(right.right.force[2], rel=1e-9)
                assert row["wrench_y"] == pytest.approx(right.wrench[1], rel=1e-9, abs=1e-6)
                assert row["wrench_moment_z"] == pytest.approx(right.wrench[5], rel=1e-9, abs=1e-6)
                assert row["found_roll"] == pytest.approx(right.roll, rel=1e-9)
                assert 0.0 < row["left_error"] < 0.02


def test_a_solver_has_its_derivatives_and_leaves_no_thread(
    solvers: tuple[Path, list[Path]], tmp_path: Path
) -> None:
    fmu = solvers[1][1]
    unpacked = str(fmpy.extract(str(fmu), str(tmp_path / "W")))
    description = fmpy.read_model_description(unpacked)
    at = {variable.name: variable.valueReference for variable in description.modelVariables}
    tasks = Path("/proc/self/task")

    def threads() -> int:
        return len(list(tasks.iterdir())) if tasks.exists() else 0

    before = 0
    messages: list[str] = []
    for turn in range(5):
        unit = fmpy.instantiate_fmu(
            unpacked,
            description,
            fmi_type="ModelExchange",
            logger=lambda *arguments: messages.append(str(arguments)),
        )
        unit.enterInitializationMode()
        unit.exitInitializationMode()
        messages.clear()
        slope = unit.getDirectionalDerivative([at["wrench_y"]], [at["lateral_velocity"]], [1.0])[0]
        # Twice Kalker's C22 c^2 G over the speed of 20 m/s; areas of 50 kN have 8e6 to 1e7 N a wheel.
        assert 7e5 < -slope < 1.1e6
        # What is odd about the states that it comes from.
        assert any("rough" in message for message in messages), messages
        # A place where no wheel stands: nothing is answered, and the instance goes on.
        unit.setFloat64([at["y"]], [0.2])
        with pytest.raises(Exception):
            unit.getFloat64([at["wrench_y"]])
        unit.setFloat64([at["y"]], [0.0])
        assert np.isfinite(unit.getFloat64([at["wrench_y"]])[0])
        unit.terminate()
        unit.freeInstance()
        # The host's own may come with the first call.
        before = threads() if turn == 0 else before
    # One left behind each time would be four more; the host's own may have ended.
    assert threads() <= before

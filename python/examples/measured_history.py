"""A measured history of creepages and normal forces, in SI units."""

import creepage
import numpy as np

case = creepage.Case.from_toml("wheel-on-rail.toml")
time = np.linspace(0.0, 1.0, 1000)
force = case.force(
    longitudinal=1e-3 * np.sin(20.0 * time),
    lateral=5e-4 * np.cos(7.0 * time),
    normal_force=80e3 + 5e3 * np.sin(3.0 * time),
    speed=30.0,
    theory="fastsim",
)
along, across, moment = force
solved = force.status == creepage.Status.SOLVED
print(f"{solved.sum()} of {len(time)} solved, largest force {np.abs(along).max():.0f} N")
assert force.power is not None
print(f"mean frictional power {force.power.mean():.0f} W")

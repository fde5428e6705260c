"""Creep-force curves of a wheel in a curve by several theories."""

import creepage
import matplotlib.pyplot as plt

wheel = creepage.Body(shear_modulus=82e9, poisson=0.28, radius_rolling=0.46)
rail = creepage.Body(shear_modulus=82e9, poisson=0.28, radius_lateral=0.30)
case = creepage.Case(
    upper=wheel, lower=rail, normal_force=80e3, friction=0.3, lateral=2e-3, spin=0.19
)
curve = case.curve("lateral", theories=["exact", "fastsim", "polach", "linear"])
for name, (_, lateral, _) in curve.forces.items():
    print(f"{name:8} {1e-3 * lateral[-1]:8.3f} kN at {1e3 * curve.values[-1]:.2f} per mille")
curve.plot()
plt.savefig("curves.png")

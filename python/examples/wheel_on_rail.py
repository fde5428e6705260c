"""A driven wheel on a rail, in SI units."""

import creepage

wheel = creepage.Body(shear_modulus=82e9, poisson=0.28, radius_rolling=0.46)
rail = creepage.Body(shear_modulus=82e9, poisson=0.28, radius_lateral=0.30)
case = creepage.Case(
    upper=wheel, lower=rail, normal_force=80e3, friction=0.3, longitudinal=-1.5e-3
)
solution = case.solve()
force, error = solution.force, solution.details["fx_error"] * 0.3 * 80e3
print(f"on the rail: {force.longitudinal:.0f} +- {error:.0f} N along the rolling direction")
print(f"adhesion: {100 * solution.adhesion_share:.1f} % of the contact area")
print(f"heat: {solution.heat_per_metre:.2f} J per metre")
print("wrote", *(path.name for path in solution.save("out")))

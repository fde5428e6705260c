"""A hundred thousand cases at once, the derivative, and the inverse problem."""

import creepage
import numpy as np

xi = np.linspace(-2.0, 2.0, 400)[:, None]
chi = np.linspace(-1.0, 1.0, 250)
force = creepage.fastsim(a_over_b=1.2, poisson=0.28, grid=(10, 10)).force(xi, 0.0, chi)
print(force.fx.shape, "forces; the largest uses", f"{force.magnitude.max():.3f}", "of mu N")
print("all solved:", bool((force.status == creepage.Status.SOLVED).all()))

exact = creepage.exact(a_over_b=1.2, poisson=0.28, resolution="fast")
print("d(fx, fy, mz)/d(xi, eta, chi):")
print(exact.derivative(0.4, 0.1, 0.2).round(3))
found = exact.find(fx=0.5, fy=0.0, chi=0.2)
print(f"half of mu N along, nothing across, at xi = {found.xi:.4f}, eta = {found.eta:.4f}")

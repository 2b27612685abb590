"""Creep curves: the force that a wheel transmits over its longitudinal creepage.

Of Kalker's full theory and of two cheaper models in scenes (left wheel, 80 kN, centred), and of an
ellipse of pressures given by hand. Writes creep_curves.png.
"""
import matplotlib
import numpy as np
from matplotlib.figure import Figure

import wrcontact

FRICTION = 0.3
LOAD = 80e3  # N
creepages = np.array([1, 2, 3, 5, 7, 10, 15, 20, 30, 50]) * 1e-4

# A scene for each combination; forces act on the wheel, so driving ones are positive.
data = wrcontact.study({"creep": ["full", "polach", "fastsim"],
                        "creepage_longitudinal": -creepages},
                       ["left.patches.0.creep_force.longitudinal", "left.normal_force"],
                       threads=2, accuracy=1e-2, friction_coefficient=FRICTION, side="left")
shares = data["left.patches.0.creep_force.longitudinal"] / (FRICTION * data["left.normal_force"])

# The same pressures as arrays, with spin: tractions of any pressures, without a scene.
patch = wrcontact.solve(side="left", accuracy=1e-2).left.patches[0]
size = patch.element_size
rolling = wrcontact.RollingContact(patch.pressure, size.lateral, size.longitudinal, friction=FRICTION)
spinning = [rolling.set(longitudinal_creepage=-creepage, spin_creepage=1e-4).solve()
            .creep_force.longitudinal / (FRICTION * patch.normal_force) for creepage in creepages]

print("creepage  " + "  ".join(f"{name:>8}" for name in [*shares["solve.creep"].values, "spinning"]))
for row, creepage in enumerate(creepages):
    values = [*shares.values[:, row], spinning[row]]
    print(f"{creepage:8.4f}  " + "  ".join(f"{value:8.3f}" for value in values))

matplotlib.rcParams.update(wrcontact.picture_style())
figure = Figure(figsize=(7, 4.5), layout="constrained")
axes = figure.subplots()
for name in shares["solve.creep"].values:
    axes.plot(creepages, shares.sel({"solve.creep": name}), label=name)
axes.plot(creepages, spinning, "--", label="full, with spin 0.1 / m")
axes.set(xlabel="longitudinal creepage", ylabel="force / (friction x normal force)",
         title="S1002 on 60E1, left wheel, 80 kN", xlim=(0, None), ylim=(0, 1.05))
axes.legend()
figure.savefig("creep_curves.png", dpi=110)

"""The shakedown map with the contacts of a wheelset that moves sideways and brakes.

S1002 on 60E1, 80 kN, left wheel, five creepages. Writes shakedown_map.png.
"""
import numpy as np

import wrcontact

data = wrcontact.study({"lateral": np.arange(-6.0, 4.1, 1.0), "creepage_longitudinal": [0.0005, 0.001, 0.002, 0.003, 0.005]},
                       [f"left.fatigue.{name}" for name in ("friction", "pressure_ratio", "surface_index")],
                       threads=2, accuracy=1e-2, side="left", solve_results="fatigue")
friction, ratio, index = (data[f"left.fatigue.{name}"] for name in ("friction", "pressure_ratio", "surface_index"))
wrcontact.shakedown_map(friction, ratio, "shakedown_map.png")
print(f"{int((index > 0).sum())} of {index.size} contacts have a surface fatigue index above 0")
print(f"largest p0/k {float(ratio.max()):.2f}, at most {float(friction.max()):.2f} of the normal force as friction")

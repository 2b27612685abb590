"""A wheelset on the track: thrown aside by an irregularity of the left rail, it runs on in waves.

Lateral position and yaw by the equations of motion, height and roll so that both wheels touch, one
solution a step, at 20 m/s. Writes wheelset_on_track.png and, where the wheelset was farthest to one
side, wheelset_farthest.png.
"""
import warnings

import numpy as np
import matplotlib
from matplotlib.figure import Figure

import wrcontact

warnings.simplefilter("ignore", wrcontact.AccuracyNote)  # up to twice the requested error is fine here

SPEED = 20e3  # mm/s
MASS, INERTIA = 1.2, 7.0e5  # t, t mm^2: N are t mm/s^2
STIFFNESS, DAMPING = 2.0e8, 1.0e3  # N mm/rad in yaw, N s/mm sideways, of the suspension
STEP, STEPS = 1e-3, 600  # s

scene = wrcontact.Scene(accuracy_of="forces", accuracy=1e-2, creep="fastsim", speed=SPEED)
solver = wrcontact.Solver()
lateral, yaw, lateral_rate, yaw_rate = 0.0, 0.0, 0.0, 0.0
steps = []
for number in range(STEPS):
    place = number * STEP * SPEED / 1000.0  # m
    bump = 3.0 * np.exp(-((place - 1.5) / 0.4) ** 2)  # of the left rail, mm to the left
    scene.set(lateral=lateral, yaw=yaw, motion_lateral=lateral_rate, motion_yaw=yaw_rate,
              track_left_displacement=[bump, 0, 0])
    result = solver.solve(scene)
    force, moment = result.wheelset.force.y, result.wheelset.moment.z
    steps.append((place, bump, lateral, yaw, *(wheel.total.force.y / 1e3 for wheel in
                                               (result.left, result.right))))
    # Semi-implicit Euler: rates first, then positions with the new rates.
    lateral_rate += STEP * (force - DAMPING * lateral_rate) / MASS
    yaw_rate += STEP * (moment - STIFFNESS * yaw) / INERTIA
    lateral += STEP * lateral_rate
    yaw += STEP * yaw_rate

track = np.array(steps)
farthest = track[np.argmax(np.abs(track[:, 2]))]
print(f"farthest: {farthest[2]:.3f} mm at {farthest[0]:.2f} m")
print(f"at the end: {lateral:.3f} mm, yaw {1e3 * yaw:.4f} mrad")

matplotlib.rcParams.update(wrcontact.picture_style())
figure = Figure(figsize=(7, 7), layout="constrained")
panels = figure.subplots(3, 1, sharex=True)
panels[0].plot(track[:, 0], track[:, 1], "--", label="left rail")
panels[0].plot(track[:, 0], track[:, 2], label="wheelset")
panels[0].set(ylabel="lateral, mm (to the left)", title="S1002 on 60E1, 20 m/s")
panels[1].plot(track[:, 0], 1e3 * track[:, 3])
panels[1].set(ylabel="yaw, mrad")
panels[2].plot(track[:, 0], track[:, 4], label="left wheel")
panels[2].plot(track[:, 0], track[:, 5], label="right wheel")
panels[2].set(ylabel="lateral force on wheel, kN", xlabel="along the track, m")
for panel in panels[::2]:
    panel.legend()
figure.savefig("wheelset_on_track.png", dpi=110)

farthest_scene = wrcontact.Scene(lateral=farthest[2], yaw=farthest[3], speed=SPEED,
                                 track_left_displacement=[farthest[1], 0, 0])
farthest_scene.plot("wheelset_farthest.png")

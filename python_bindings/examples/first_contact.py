"""First contact in ten lines: S1002 on 60E1, the wheelset 5 mm to the left."""
import wrcontact

result = wrcontact.solve(wheel="S1002", rail="60E1", lateral=5, load_both=80e3)
print(result)
for side in (result.left, result.right):
    for patch in side.patches:
        across, along = patch.pressure.shape
        print(f"{patch.pmax:7.1f} MPa over {patch.area:6.2f} mm2, on {across} x {along} elements")
result.plot("first_contact.png")

#!/usr/bin/python3
"""The map of the mass between two bumpers over gap and stiffness: lowest peaks of the acceleration,
what belongs to them, and the stiffnesses from which on the response curves jump.

usage: check_map.py PROGRAM SOURCE [--page FILE] [--keep FOLDER] [--ranks N]
"""
from systems import Table, nearest

GAPS = [0, 0.0657506, 0.1989975, 0.4, 0.7]
# gap: eta_a*, and at the best stiffness eta_d*, eta_F*, eta_B*, beta_R
PEAKS = {0.7: (1.23832, .7960, .4587, .0960, 1.0625),
         0.4: (0.99739, .5513, .5015, .1513, 1.1359),
         0.1989975: (0.74288, .3712, .4438, .1722, 1.2133),
         0.0657506: (0.53132, .2354, .3473, .1697, 1.3189),
         0: (0.40652, .1505, .2783, .1505, 1.4577)}
# gap: stiffness at which the hysteresis is 0.005 and 0.01 wide, and at which it reaches sqrt(2)
JUMPS = {0.7: (1.62, 2.63, None), 0.4: (0.77, 1.23, 12.29), 0.1989975: (1.69, 1.88, 2.022),
         0.0657506: (4.31, 4.31, None)}

table = Table(__file__)
values = ", ".join(map(str, GAPS))
results = table.run("bumpers-map.prm", "map", f"Analysis map/Parameter grid/Key gap/Values={values}",
                    f"Analysis folds/Parameter grid/Key gap/Values={values}")

# The best stiffness is flat: 1 % more of the peak spans a factor of two. What belongs to it is read
# at the nearest stiffness of the grid, 2 % of which changes it by as much.
MAP = results["analysis/map"]
for gap, (least, *others) in PEAKS.items():
    i = nearest(MAP["Variables.delta0"][:], gap)
    table.add(f"lowest peak of η_a at gap {gap}", least, MAP["derived/eta_a_least"][i], 2e-3)
    for name, reference in zip(("eta_d_opt", "eta_F_opt", "eta_B_opt", "beta_R_opt"), others):
        table.add(f"{name} at gap {gap}", reference, MAP["derived/" + name][i], 0.04)

# Stiffnesses are interpolated between those of the grid, 2 to 10 % apart.
FOLDS = results["analysis/folds"]
for gap, references in JUMPS.items():
    i = nearest(FOLDS["Variables.delta0"][:], gap)
    for name, reference in zip(("lambda_H_005", "lambda_H_01", "lambda_c"), references):
        if reference is not None:
            table.add(f"{name} at gap {gap}", reference, FOLDS["derived/" + name][i], 0.03)

table.finish()

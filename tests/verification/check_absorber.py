#!/usr/bin/python3
"""Vibro-impact damper with Hertz contact: the rows of the tables without bursts.

The references were integrated with located contact at tight tolerance; A and V are half the
peak-to-peak excursion of displacement and velocity over 460 periods after 1500.
"""
import math

from systems import Table

table = Table(__file__)
results = table.run("vibro-impact-absorber.prm", "absorber",
                    "Analyses=rows, linear, left_only", "Analysis/left_only/Initial conditions=none")
rows = results["analysis/rows"]

#        row; A1, V1, A2, V2, F_left, F_right; the paper's A1, V1, A2, V2, F_left, F_right
ROWS = [("Table 1, row 2", (".055767", ".40146", ".065053", ".58948", None, "50233"), None),
        ("Table 1, row 3", (".054042", ".38722", ".073675", ".65569", None, "56562.8"),
         (.0540, .387, .0758, .684, None, 65619)),
        ("Table 1, row 5", (".055402", ".40017", ".071453", ".57827", None, "37836"),
         (.0552, .400, None, None, None, None)),
        ("Table 2, row 2", (".053920", ".38601", ".076119", ".67813", None, "1966.8"),
         (.0537, .385, .0760, .678, None, 1979)),
        ("Table 2, row 3", (".053923", ".38605", ".076037", ".67736", None, "2026.3"),
         (.0537, .385, .0759, .677, None, 2040)),
        ("Table 2, row 4", (".053927", ".38609", ".075939", ".67642", None, "2103.8"),
         (.0538, .385, .0758, .676, None, 2117)),
        ("Table 5, row 1", (".049436", ".35989", ".084608", ".51683", "4315", "64633"),
         (.0532, .386, .0890, .787, 5351, 150339)),
        ("Table 5, row 3", (".049421", ".35957", ".085362", ".53149", "4491.6", "2351.9"),
         (.0492, .358, .0851, .532, 4505, 2359)),
        ("Table 5, row 4", (".049435", ".35985", ".084726", ".51904", "4342.1", "13517"),
         (.0493, .360, .0851, .533, 4482, 13851))]
CHAOTIC = [("Table 3, row 1", .04970, (123.6e3, 66.1e3)), ("Table 3, row 2", .04970, (128.1e3, 2194))]
IMPACTS = [(0, 2), (0, 2), (0, 3), (0, 2), (0, 2), (0, 2), (1, 2), (1, 2), (1, 2)]
NAMES = ("A1", "V1", "A2", "V2", "F left", "F right")


def figures(analysis, index):
    half = [analysis[f"point/{point}/{quantity}/peak_to_peak_excursion"][index].item() / 2
            for point in ("structure.floor", "damper.ball")
            for quantity in ("displacement_x", "velocity_x")]
    return half + [analysis[f"contact/{side}/normal_force/maximum"][index].item()
                   for side in ("left", "right") if f"contact/{side}" in analysis]


for case, (name, wanted, paper) in enumerate(ROWS):
    found = figures(rows, case)
    for i, (symbol, reference) in enumerate(zip(NAMES, wanted)):
        if reference is not None:
            table.add_digits(f"{symbol}, {name}", reference, found[i], paper and paper[i])
    for side, impacts in zip(("left", "right"), IMPACTS[case]):
        table.add(f"impacts per period {side}, {name}", impacts,
                  rows[f"contact/{side}/impacts_per_period"][case].item(), 0, absolute=True)
for case, (name, amplitude, forces) in enumerate(CHAOTIC, start=len(ROWS)):
    found = figures(rows, case)
    table.add(f"A1, {name} (chaotic)", amplitude, found[0], 2e-4 / amplitude)
    for i, (force, symbol) in enumerate(zip(forces, ("F left", "F right"))):
        table.add(f"{symbol}, {name} (chaotic)", force, found[4 + i], 3e-2)
linear = figures(results["analysis/linear"], 0)
for symbol, reference, paper, found in zip(NAMES, (.051975, .37578, .097712, .70646),
                                           (.0517, .374, .0974, .705), linear):
    table.add(f"{symbol}, linear damper", reference, found, 1.2e-5, paper=paper)

# Without the damper the floor is a linear oscillator.
omega = 7.23
free = 800 / math.hypot(3.95e4 - 1000 * omega**2, 452 * omega)
table.add("A1, no damper (closed form)", .060678, free, 1.2e-5, paper=.0602)
soft = figures(rows, 7)
table.add("reduction of A1, steel, Table 3 row 1, in %", 18.1, 100 * (1 - figures(rows, 9)[0] / free),
          0.1, paper=13.3, absolute=True)
table.add("reduction of A1, both sides soft, Table 5 row 3, in %", 18.55, 100 * (1 - soft[0] / free),
          0.1, paper=18.3, absolute=True)
table.finish()

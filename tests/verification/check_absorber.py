#!/usr/bin/python3
"""Vibro-impact damper with Hertz contact: the rows of the tables of the paper.

The references were integrated with located contact at tight tolerance; A and V are half the
peak-to-peak excursion of displacement and velocity over 460 periods after 1500. Rows without a
reference are held against the paper where its motion has no bursts. Takes about two minutes.
"""
import math

from systems import Table

FILE = "vibro-impact-absorber.prm"
NAMES = ("A1", "V1", "A2", "V2", "F left", "F right")
HEAVY = ("Variables/m2=37.88", "Variables/k2=414.6", "Variables/C=0.0747")

#   row of the grid: (name; references; the paper's figures; regime k, n, m), in the order of NAMES
REFERENCE = {
    0: ("Table 1, row 2", (".055767", ".40146", ".065053", ".58948", None, "50233"),
        (.0557, .401, None, None, None, None), (1, 0, 2)),
    1: ("Table 1, row 3 = Table 2, row 1",
        (".054042", ".38722", ".073675", ".65569", None, "56562.8"),
        (.0540, .387, .0758, .684, None, 65619), (1, 0, 2)),
    2: ("Table 1, row 5", (".055402", ".40017", ".071453", ".57827", None, "37836"),
        (.0552, .400, None, None, None, None), (1, 0, 3)),
    3: ("Table 2, row 2", (".053920", ".38601", ".076119", ".67813", None, "1966.8"),
        (.0537, .385, .0760, .678, None, 1979), (1, 0, 2)),
    4: ("Table 2, row 3", (".053923", ".38605", ".076037", ".67736", None, "2026.3"),
        (.0537, .385, .0759, .677, None, 2040), (1, 0, 2)),
    5: ("Table 2, row 4", (".053927", ".38609", ".075939", ".67642", None, "2103.8"),
        (.0538, .385, .0758, .676, None, 2117), (1, 0, 2)),
    14: ("Table 5, row 1", (".049436", ".35989", ".084608", ".51683", "4315", "64633"),
         (.0532, .386, .0890, .787, 5351, 150339), (2, 2, 4)),
    16: ("Table 5, row 3", (".049421", ".35957", ".085362", ".53149", "4491.6", "2351.9"),
         (.0492, .358, .0851, .532, 4505, 2359), (2, 2, 4)),
    17: ("Table 5, row 4", (".049435", ".35985", ".084726", ".51904", "4342.1", "13517"),
         (.0493, .360, .0851, .533, 4482, 13851), (2, 2, 4))}
PAPER_ONLY = {
    6: ("Table 2, row 5", (.0537, .385, .0768, .685, None, 1584)),
    7: ("Table 2, row 6", (.0537, .385, .0766, .684, None, 1641)),
    15: ("Table 5, row 2", (.0493, .360, .0850, .527, 26830, 2343))}
#   chaotic rows: references of A1, forces, exponent in 1/s; the paper's A1 and forces
CHAOTIC = {
    8: ("Table 1, row 4 = Table 3, row 1", (.04970, 123.6e3, 66.1e3, .12), (.0522, None, 149419)),
    9: ("Table 3, row 2", (.04970, 128.1e3, 2194, .31), (.0494, None, 2188))}
APERIODIC = {10: ("Table 3, row 3", .0518), 11: ("Table 3, row 4", .0514),
             12: ("Table 3, row 5", .0515), 13: ("Table 3, row 6", .0513)}


def figures(analysis, index):
    half = [analysis[f"point/{point}/{quantity}/peak_to_peak"][index].item() / 2
            for point in ("structure.floor", "damper.ball")
            for quantity in ("displacement_x", "velocity_x")]
    return half + [analysis[f"contact/{side}/normal_force/maximum"][index].item()
                   for side in ("left", "right") if f"contact/{side}" in analysis]


def periodic_rows(table, rows):
    for case, (name, wanted, paper, regime) in REFERENCE.items():
        found = figures(rows, case)
        for i, (symbol, reference) in enumerate(zip(NAMES, wanted)):
            if reference is not None:
                table.add_digits(f"{symbol}, {name}", reference, found[i], paper[i])
        repetition = [rows["regime/period_multiple"][case].item()] + [
            rows[f"regime/impacts_per_repetition/{side}"][case].item() for side in ("left", "right")]
        table.add_whole(f"k, n, m, {name}", regime, repetition, regime)
    for case, (name, paper) in PAPER_ONLY.items():
        found = figures(rows, case)
        for i, (symbol, printed) in enumerate(zip(NAMES, paper)):
            if printed is not None:
                table.add(f"{symbol}, {name} (held against the paper)", printed, found[i], 9e-3,
                          paper=printed)


def chaotic_rows(table, rows):
    for case, (name, (amplitude, left, right, exponent), paper) in CHAOTIC.items():
        found = figures(rows, case)
        table.add(f"A1, {name} (chaotic)", amplitude, found[0], 2e-4 / amplitude, paper=paper[0])
        for i, (force, symbol) in enumerate([(left, "F left"), (right, "F right")]):
            table.add(f"{symbol}, {name} (chaotic)", force, found[4 + i], 3e-3, paper=paper[1 + i])
        table.add(f"largest Lyapunov exponent in 1/s, {name}", exponent,
                  rows["regime/exponent"][case].item(),
                  4 * rows["regime/exponent_error"][case].item(), absolute=True)
        impacts(table, rows, case, name)
    for case, (name, paper) in APERIODIC.items():
        table.add(f"A1, {name} (does not repeat)", .0497, figures(rows, case)[0], 2e-3, paper=paper)
        impacts(table, rows, case, name)


def impacts(table, rows, case, name):
    found = [rows[f"contact/{side}/impacts_per_period"][case].item() for side in ("left", "right")]
    table.add_whole(f"impacts per period left, right, {name}", (1, 2), found, (1, 2))


def linear_cases(table, results, rows):
    linear = figures(results["analysis/linear"], 0)
    for symbol, reference, paper, found in zip(NAMES, (".051975", ".37578", ".097712", ".70646"),
                                               (.0517, .374, .0974, .705), linear):
        table.add_digits(f"{symbol}, linear damper", reference, found, paper)
    # Without the damper the floor is a linear oscillator.
    omega = 7.23
    free = 800 / math.hypot(3.95e4 - 1000 * omega**2, 452 * omega)
    table.add("A1, no damper (closed form)", .060678, free, 1.2e-5, paper=.0602)
    for name, case, wanted, paper in [("steel, Table 3, row 1", 8, 18.1, 13.3),
                                      ("right side soft, Table 3, row 2", 9, 18.1, 17.9),
                                      ("both sides soft, Table 5, row 3", 16, 18.55, 18.3)]:
        table.add(f"reduction of A1, {name}, in %", wanted,
                  100 * (1 - figures(rows, case)[0] / free), 0.1, paper=paper, absolute=True)


def one_wall(table):
    """Table 6: the heavy damper without the right barrier."""
    motion = table.run(FILE, "left-only", "Analyses=left_only", *HEAVY)["analysis/left_only"]
    found = figures(motion, 0)
    for symbol, reference, value, paper in zip(
            NAMES, (".068821", ".49631", ".120908", ".83362", "225403"), found,
            (.0685, .494, .121, .828, 223793)):
        table.add_digits(f"{symbol}, Table 6", reference, value, paper)
    table.add("impacts per period left, Table 6", 1,
              motion["contact/left/impacts_per_period"][0].item(), 0, paper=1, absolute=True)


def bursts(table):
    """Row 1 of Table 3 just below and above the force from which on its motion bursts, over 20 000 periods; held
    against the forces without bursts at 800 N and, above, against the paper."""
    for force, largest, tolerance, paper in ((804, 66.1e3, 0.02, None), (808, 149419, 0.05, 149419)):
        motion = table.run(FILE, f"force-{force}", "Analyses=motion", *HEAVY,
                           f"Excitation/wind/Amplitude={force} N",
                           "Analysis motion/Record=extreme values, impacts",
                           "Analysis motion/Stepped sweep/Recorded cycles=20000")["analysis/motion"]
        table.add(f"F right, Table 3, row 1, force of {force} N", largest, figures(motion, 0)[5], tolerance, paper)


def check(table):
    results = table.run(FILE, "absorber", "Analyses=rows, linear")
    rows = results["analysis/rows"]
    periodic_rows(table, rows)
    chaotic_rows(table, rows)
    linear_cases(table, results, rows)
    one_wall(table)


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    bursts(main)
    main.finish()

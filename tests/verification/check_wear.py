#!/usr/bin/python3
"""Wear by formulas of the work rate against the values of Code_Aster's tests ZZZZ405 (laws and depths) and SDND104 (work rate of a
shaken block), in digits that were computed anew from their definitions.
"""
from systems import Table

YEAR = 31536000.0
# Derived, years, values.
LAWS = [
    ("saturating", (1, 3, 5, 7), (9.58595507705e-7, 1.6131418113e-6, 1.75925778387e-6, 1.7962621362e-6)),
    ("flat", (2, 4, 6), (1.77037693409e-5, 2.01981942451e-5, 2.07572004243e-5)),
    ("flat_both", (2, 4, 6), (1.40514910377e-5, 1.60313173962e-5, 1.64750008948e-5)),
    ("archard", (2, 4, 6), (2.239056e-7, 4.478112e-7, 6.717168e-7)),
    ("inclined", (1, 3, 5, 7), (3.67586404898e-4, 5.70437335472e-4, 6.99757307502e-4, 8.00568792779e-4)),
    ("archard_soft", (1, 3, 5, 7), (0.0015768, 0.0047304, 0.007884, 0.0110376)),
    ("inclined_both", (1, 3, 5, 7), (0.00960013454866, 0.0148979263083, 0.0182753339458, 0.0209081947094)),
    ("archard_bore", (1, 3), (2.52288e-6, 7.56864e-6)),
    ("bore", (2, 4, 6), (8.03057645655e-8, 1.60611529131e-7, 2.40917293697e-7)),
]
WORK_RATE = {0.99: 0.0, 1.01: 2.261641213e-4, 1.5: 0.4090624510, 15.0: 15.26709959}
DIGITS = 5e-12  # half a unit in the last of twelve


def check(table):
    results = table.run("verification/wear-laws.prm", "wear")
    years = results["analysis/years"]
    for rate in years["recorded/contact/belt/friction/work_rate"][:2]:
        table.add("work rate of the block on the belt, W", 0.5, rate, 1e-14)
    for name, places, values in LAWS:
        unit = "m" if name.startswith(("flat", "inclined")) or name == "bore" else "m^3"
        for place, value in zip(places, values):
            table.add(f"{name} after {place} years, {unit}", value, years[f"derived/{name}"][place - 1], DIGITS)
    # The volume grows with the cube of sqrt(depth) between two circles that nearly fit: the digits of the depth count 1.5 times, and
    # the terms of the formula cancel to a part in 10^4 and less.
    for place, value in zip((1, 3, 5, 7), results["analysis/depths/derived/life"][:]):
        table.add(f"bore with radii: time until the depth of {place} years, s", place * YEAR, value, 1e-11)
    shaking = results["analysis/shaking"]
    for amplitude, value in zip(shaking["Variables.amplitude"][:], shaking["contact/table/friction/work_rate"][:]):
        expected = WORK_RATE[round(float(amplitude), 3)]
        table.add(f"shaken block, {amplitude:g} m/s^2: work rate, W", expected, value, 2e-9 * max(expected, 1e-4), absolute=True)


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()

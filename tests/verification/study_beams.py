#!/usr/bin/python3
"""The figures of check_beams.py as a table."""
from check_beams import IMPACT, SOURCE, summary
from systems import Table

CONTACT = ("peak_force", "impulse", "duration", "restitution_coefficient")
UNITS = {"peak_force": "N", "impulse": "N s", "duration": "s", "time": "s",
         "approach_speed": "m/s"}
CASES = [("0.2 m/s, elastic", [], (220.879, 1.166983e-2, 97.261e-6, .98711)),
         ("1 m/s, elastic", ["Variables/V=1 m/s"], (1522.66, 5.82540e-2, 70.421e-6, .98902)),
         ("0.2 m/s, damped", ["Contact/heads/Law=hunt-crossley"],
          (199.577, 9.93377e-3, 102.167e-6, .68800))]
RELEASE = {"time": .0896910, "approach_speed": 1.005842, "peak_force": 1533.33,
           "impulse": .0585934, "restitution_coefficient": .98902}


def named(name):
    return name.replace("_", " ") + (f", {UNITS[name]}" if name in UNITS else "")


def main():
    table = Table(__file__)
    for case, overrides, wanted in CASES:
        found = summary(SOURCE / "params/verification/beam-contact.prm", *overrides)
        for name, value in zip(CONTACT, wanted):
            table.add(f"{case}: {named(name)}", value, found[IMPACT.format("impact") + name], 1e-4)
    found = summary(SOURCE / "params/verification/beam-release.prm")
    for name, value in RELEASE.items():
        table.add(f"release: {named(name)}", value, found[IMPACT.format("release") + name], 1e-5)
    table.finish()


if __name__ == "__main__":
    main()

#!/usr/bin/python3
"""Design of an isolator between damped elastic stops: transition set, conditions and corners by closed
forms, and folds of stops by averaging and exact, against an independent evaluation of the same equations and
an independent shooting solver.
"""
import numpy

from systems import Table, nearest

#     z     alpha_1       alpha_2
CUSPS = ((.25, "0.05922766", "-0.88056799"), (.5, "0.21588542", "-0.57036812"),
         (.75, "0.45822776", "-0.14075808"), (.9, "0.65886056", "0.18726431"))
#     alpha_1, alpha_2, mu, f, folds by averaging, exact
STOPS = ((.7, 0, "0.471239", "0.509296", (), ()), (.4, -.8, "0.824668", "1.068355", (), ()),
         (.3, -.2, "1.099557", "0.807083", (1.324645, 1.328215), (1.324758, 1.326452)),
         (.1, -.1, "3.298672", "1.422456", None, (1.548395, 1.755699)))
LISTED = 9
# Points of curves, so that z = 0.25 and alpha_1 = 0.5 are among them.
POINTS = "Analysis/design/Isolator design/Points=199"


def check(table):
    design = table.run("isolator-design.prm", "isolator-design", POINTS)["analysis/design"]
    plane(table, design)
    conditions(table, design)
    for number, stop in enumerate(STOPS):
        folds(table, design["stop"], number, stop)
    chosen(table, design)


def plane(table, design):
    for z, first, second in CUSPS:
        row = nearest(design["hysteresis/z"][:], z)
        table.add_digits(f"H at z = {z}: α₁", first, design["hysteresis/alpha_1"][row])
        table.add_digits(f"H at z = {z}: α₂", second, design["hysteresis/alpha_2"][row])
    row = nearest(design["set/alpha_1"][:], .5)
    for name, text, value in (("b2", "B₂", "0.367605"), ("b3_plus", "B₃⁺", "0.348191"),
                              ("b3_minus", "B₃⁻", "0.008114")):
        table.add_digits(f"{text} at α₁ = 0.5: α₂", value, design[f"set/{name}"][row])


def conditions(table, design):
    table.add_digits("largest f", "6.5627305", design["largest_force"][()])
    table.add_digits("least μ with the clearance of the file", "865",
                     design["present/least_stiffness"][()])
    table.add_digits("largest μ with the clearance of the file", "0.62",
                     design["present/largest_stiffness"][()])
    corner = design["corner/resonance_and_jump"]
    for name, text, value in (("force", "f", "1.75952"), ("stiffness", "μ", "1.69256"),
                              ("alpha_1", "α₁", "0.19489"), ("alpha_2", "α₂", "-0.61077")):
        table.add_digits(f"corner of allowed displacement and H: {text}", value, corner[name][()])


def folds(table, stops, number, stop):
    first, second, stiffness, force, averaged, exact = stop
    row = numpy.flatnonzero(stops["kind"][:] == LISTED)[number]
    at = f"(α₁, α₂) = ({first}, {second})"
    table.add_digits(f"{at}: μ", stiffness, stops["stiffness"][row])
    table.add_digits(f"{at}: f", force, stops["force"][row])
    for method, wanted, tolerance in (("averaged", averaged, 1e-6), ("exact", exact, 1e-6)):
        if wanted is None:
            continue
        table.add(f"{at}: folds, {method}", len(wanted), stops[f"{method}/folds"][row], 0,
                  absolute=True)
        for value, found in zip(wanted, stops[f"{method}/fold_ratio"][row]):
            table.add(f"{at}: λ of a fold, {method}", value, found, tolerance, absolute=True)


def chosen(table, design):
    """The first stop: the exact resonance is at most as large as allowed, and does not jump."""
    stops = design["stop"]
    table.add("chosen stop: region", 4, stops["region"][0], 0, absolute=True)
    table.add("chosen stop: folds, exact", 0, stops["exact/folds"][0], 0, absolute=True)
    table.add("chosen stop: exact resonance over the allowed displacement", 1,
              stops["exact/peak"][0] / 1.2, .005)


if __name__ == "__main__":
    main_table = Table(__file__)
    check(main_table)
    main_table.finish()

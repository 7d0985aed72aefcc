#!/usr/bin/python3
"""Elements with friction whose limit is constant, in a chain (NLvib, example 07), under a capsule that drives itself, and under a
pressed block: against integrations by other means (tests/support/friction_reference.py) and a closed form.
"""
import numpy

from systems import Table

# Frequency: standard deviation of q1, q2, q3 over a period of the settled motion. The mean depends on the start where springs stay
# stuck, and is compared at the frequencies at which they do not.
CHAIN = {0.8: (0.03624643, 0.07125143, 0.05236175), 1.0: (0.03946773, 0.07681195, 0.07652208),
         1.2: (0.15612207, 0.19015948, 0.28125150), 1.5: (0.11411178, 0.14706189, 0.60161463),
         2.0: (0.11608103, 0.15847580, 0.09065943)}
MEAN = {1.2: (-0.00921726, -0.02080645, -0.02199321), 1.5: (-0.03367590, -0.09186117, -0.10513021)}
# Drive, mass of the capsule, frequency: ways in one period, or in two, the larger one first.
CAPSULES = [(1.6, 5, 0.95, (1.09485123423,)), (1.0, 5, 0.95, (0.568739664045,)),
            (1.6, 3, 0.95, (1.49690013195,)), (1.6, 5, 1.1, (0.889891921413, 0.125349569392))]


def check_chain(table):
    for frequency, deviations in CHAIN.items():
        settling = [] if frequency in MEAN else ["Analysis/motion/Transient/Duration=2000 * pi / w"]
        motion = table.run("verification/friction-chain.prm", f"chain-{frequency:g}", f"Variables/w={frequency:g}",
                           *settling)["analysis/motion"]
        for number, deviation in enumerate(deviations):
            place = motion[f"point/q{number + 1}.head/displacement_x"][-128:]
            table.add(f"chain, w {frequency:g}: deviation of q{number + 1}", deviation, place.std(), 1.5e-8, absolute=True)
            if frequency in MEAN:
                table.add(f"chain, w {frequency:g}: mean of q{number + 1}", MEAN[frequency][number], place.mean(), 1.5e-8,
                          absolute=True)


def check_capsules(table):
    for drive, mass, frequency, ways in CAPSULES:
        place = table.run("capsule.prm", f"capsule-{drive:g}-{mass:g}-{frequency:g}", "Analyses=way",
                          f"Variables/w={frequency:g}", f"Variables/drive={drive:g}",
                          f"Variables/gamma={mass:g}")["analysis/way/point/capsule.head/displacement_x"][:]
        found = sorted(numpy.diff(place)[-len(ways):], reverse=True)
        for number, way in enumerate(ways):
            table.add(f"capsule, drive {drive:g}, mass {mass:g}, w {frequency:g}: way {number + 1}", way, found[number], 2e-9)


def check_block(table):
    """Turns after each half period: 2 (F - mu N)/k, then 4 mu N/k less."""
    motion = table.run("verification/friction-block.prm", "press")["analysis/press"]
    time, place = motion["time"][:], motion["point/block.head/displacement_x"][:]
    half, pushed, lost = numpy.pi * numpy.sqrt(7000 / 24000), 179000 / 24000, 4 * 21000 / 24000
    exact = []
    for at in time:
        number = int(at // half)
        centre = pushed + (lost / 2 if number % 2 else 0)
        start = (0, 2 * pushed, lost, 2 * pushed - lost)[number]
        exact.append(centre + (start - centre) * numpy.cos((at - number * half) * numpy.pi / half))
    table.add_curve("block: displacement", place - numpy.array(exact), 1e-10)


def check(table):
    check_chain(table)
    check_capsules(table)
    check_block(table)


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()

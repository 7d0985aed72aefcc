#!/usr/bin/python3
"""How far the response of the two masses has converged in the stiffness of the contact spring."""
import numpy

from studies import Study

GAPS = ("0 mm", "2 mm")


def amplitudes(study, gap):
    """Frequencies, stiffnesses, and the upward amplitudes of both masses in mm."""
    analysis = study.run("bilinear-oscillator.prm", "penalties-" + gap.replace(" ", ""),
                         "Analyses=penalties", f"Variables/gap={gap}")["analysis/penalties"]
    path = "point/{}.mass/absolute_displacement_x/peak_to_peak"
    return (analysis["frequency"][:], analysis["Variables.penalty"][:],
            [analysis[path.format(body)][:, :, 0] * 500 for body in ("first", "second")])


def main():
    study = Study(__file__, "gap", "k*, N/m", "largest A1, mm", "largest A2, mm",
                  "A1 off 1e6 N/m, up to 4.5 Hz", "A2, up to 4.5 Hz", "A1, above", "A2, above")
    for gap in GAPS:
        frequency, stiffnesses, masses = amplitudes(study, gap)
        low = frequency <= 4.5
        for case, stiffness in enumerate(stiffnesses):
            off = [numpy.abs(mass[case] / mass[-1] - 1) for mass in masses]
            study.row(gap, f"{stiffness:.0e}", *(f"{mass[case].max():.3f}" for mass in masses),
                      *(f"{o[part].max():.1%}" for part in (low, ~low) for o in off))
    study.finish()


if __name__ == "__main__":
    main()

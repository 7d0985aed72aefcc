#!/usr/bin/python3
"""How far the bilinear amplitude approximation is from a contact spring, over the sweep."""
import numpy

from studies import Study
from study_figures import legend, panels, save

AMPLITUDE = "point/{}.mass/absolute_displacement_x/peak_to_peak"
NAMES = ("gap 0, base 10 mm", "gap 2 mm, base 10 mm", "gap 11 mm, base 11 mm")


def percent(differences):
    return f"{100 * numpy.abs(differences).max():.1f} %"


def main():
    study = Study(__file__, "gap", "mass", "amplitude at 2.4 Hz, mm", "with a contact spring",
                  "largest difference up to 4.5 Hz", "above", "share of 2.4 Hz in contact",
                  "with a contact spring")
    results = study.run("bilinear-approximation.prm", "bilinear-approximation-study",
                        "Analyses=approximations,elastic")["analysis"]
    tied, spring = results["approximations"], results["elastic"]
    frequency = tied["frequency"][:]
    at, low = int(numpy.argmin(numpy.abs(frequency - 2.4))), frequency <= 4.5
    figure, axes, colours = panels(study, len(NAMES))
    for case, name in enumerate(NAMES):
        shares = (tied["contact/tied/contact_fraction"][case, at],
                  spring["contact/spring/contact_fraction"][case, at, 0])
        for body, colour in zip(("first", "second"), colours):
            first, other = (500 * tied[AMPLITUDE.format(body)][case],
                            500 * spring[AMPLITUDE.format(body)][case, :, 0])
            difference = first / other - 1
            study.row(name, body, f"{first[at]:.4f}", f"{other[at]:.4f}", percent(difference[low]),
                      percent(difference[~low]), *(f"{share:.4f}" for share in shares))
            axes[case].plot(frequency, first, color=colour, label=f"{body}, tied")
            axes[case].plot(frequency, other, "--", color=colour, label=f"{body}, contact spring")
        axes[case].set_ylabel(f"Amplitude (mm),\n{name.split(',')[0]}")
    legend(axes[0])
    axes[-1].set_xlabel("Frequency (Hz)")
    save(study, figure, "bilinear-approximation.png")
    study.finish()


if __name__ == "__main__":
    main()

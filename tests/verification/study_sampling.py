#!/usr/bin/python3
"""What a sampled, noisy force record says of impacts: pulses read from CSV at several sampling rates.

Twelve releases of the two beams of params/impact-identification.prm, half a second each, one behind the
other; the force of the perfect pulses is sampled, noise is added, and the program identifies from the file.
"""
import pathlib
import subprocess
import tempfile

import h5py
import numpy

from studies import Study
from study_figures import panels, save

RATES = (200, 400, 20_000, 100_000, 400_000)
NOISE = 0.3  # N, standard deviation
THRESHOLD = 3  # N
FASTEST = 400_000  # Hz, of the record that is thinned
LENGTH = 0.5  # s, of a release
HARD = 0.1  # m/s
RESTITUTION = 0.33377


def releases(study):
    """Instants, force, and start, approach speed, restitution, impulse and peak of all impacts."""
    grid = study.run("impact-identification.prm", "sampling-releases", "Analyses=speeds",
                     f"Analysis/record/Identify/Sampling frequency={FASTEST} Hz",
                     f"Analysis/record/Identify/Duration={LENGTH} s")["analysis/speeds/contact/heads"]
    force = grid["identification/record/force"][:]
    time = numpy.arange(force.shape[1]) / FASTEST
    shifts = LENGTH * numpy.arange(len(force))[:, None]
    impacts = {name: grid[f"impact/{name}"][:] for name in
               ("time", "approach_speed", "restitution_coefficient", "impulse", "peak_force")}
    impacts["time"] = impacts["time"] + shifts
    there = numpy.isfinite(impacts["time"]) & numpy.isfinite(impacts["restitution_coefficient"])
    return (time + shifts).ravel(), force.ravel(), {key: value[there]
                                                    for key, value in impacts.items()}


def write(path, time, force, rate, random):
    """Every so many samples with noise; what is far from any pulse only where the file stays small, as of
    a triggered recorder. The force of the first sample decides the phase of the sampling."""
    step = FASTEST // rate
    time, force = time[step // 3::step], force[step // 3::step]
    noisy = force + NOISE * random.standard_normal(len(force))
    kept = numpy.ones(len(time), bool)
    if rate > 1000:
        near = numpy.convolve(force > 0, numpy.ones(21), "same") > 0
        kept = near
    rows = [f"{x:.9g},{y:.6g}" for x, y in zip(time[kept], noisy[kept])]
    path.write_text("\n".join(["time_s,force_n", *rows, ""]), encoding="utf-8")


def identified(study, folder, rate):
    """The identification of the program from the file."""
    text = (study.arguments.source / "params" / "measured-pulses.prm").read_text(encoding="utf-8")
    file = folder / "pulses.prm"
    file.write_text(text, encoding="utf-8")
    out = folder / f"out-{rate}"
    done = subprocess.run(
        [study.arguments.program, str(file), "--output", str(out), "--overwrite", "--set",
         f"Analysis/pulses/Identify/File={rate}.csv", "--set",
         f"Analysis/pulses/Identify/Threshold={THRESHOLD} N"], capture_output=True, check=False)
    if done.returncode:
        return None
    return h5py.File(out / "results.h5")["analysis/pulses/contact/heads/identification"]


def matched(found, impacts, rate):
    """For each pulse the impact of the motion that it belongs to, or -1."""
    start = found["pulse/start"][:]
    which = numpy.searchsorted(impacts["time"], start, side="right") - 1
    late = start - impacts["time"][numpy.maximum(which, 0)]
    which[(which < 0) | (late > 2e-2)] = -1
    return which


def percent(values):
    return f"{100 * numpy.median(numpy.abs(values)):.2g} %" if len(values) else ""


def row(study, rate, found, impacts):
    hard = impacts["approach_speed"] >= HARD
    if found is None:
        study.row(f"{rate:,}", f"0 of {hard.sum()}", *[""] * 7)
        return
    which = matched(found, impacts, rate)
    belongs = which >= 0
    belongs[belongs] &= hard[which[belongs]]
    seen = len(set(which[belongs]))
    truth = {key: value[which[belongs]] for key, value in impacts.items()}
    of = {key: found[key][:][belongs] for key in
          ("impulse", "peak_force", "exact/approach_speed", "exact/restitution_coefficient")}
    known = numpy.isfinite(of["exact/restitution_coefficient"])
    interval = [f"{found['exact/' + name][()]:.3g} ({found['exact/' + name + '_low'][()]:.3g} to "
                f"{found['exact/' + name + '_high'][()]:.3g})"
                if numpy.isfinite(found["exact/" + name][()]) else ""
                for name in ("fit_coefficient", "fit_exponent")]
    study.row(f"{rate:,}", f"{seen} of {hard.sum()}", str(known.sum()),
              percent(of["impulse"] / truth["impulse"] - 1),
              percent(of["peak_force"] / truth["peak_force"] - 1),
              percent(of["exact/approach_speed"][known] / truth["approach_speed"][known] - 1),
              percent(of["exact/restitution_coefficient"][known] / RESTITUTION - 1), *interval)


def main():
    study = Study(__file__, "sampling, Hz", "hard impacts seen", "identified", "error of J",
                  "of f_m", "of v_c", "of e", "a (95 %)", "b (95 %)")
    time, force, impacts = releases(study)
    folder = pathlib.Path(tempfile.mkdtemp())
    figure, axes, colours = panels(study, 2, share_x=False)
    order = numpy.argsort(impacts["approach_speed"])
    axes[0].plot(impacts["approach_speed"][order], impacts["restitution_coefficient"][order], "k+",
                 label="motion")
    for rate, colour in zip(RATES, colours):
        write(folder / f"{rate}.csv", time, force, rate, numpy.random.default_rng(rate))
        found = identified(study, folder, rate)
        row(study, rate, found, impacts)
        if found is None:
            continue
        axes[0].plot(found["exact/approach_speed"][:], found["exact/restitution_coefficient"][:],
                     "o", markersize=3, color=colour, label=f"{rate:,} Hz")
        which = matched(found, impacts, rate)
        axes[1].plot(impacts["peak_force"][which[which >= 0]],
                     found["peak_force"][:][which >= 0], "o", markersize=3, color=colour)
    axes[0].set_xscale("log")
    axes[0].set_ylim(0, 1)
    axes[0].set(xlabel="Approach speed (m/s)", ylabel="Restitution $e$")
    axes[0].legend(fontsize=7)
    axes[1].plot([1, 3e3], [1, 3e3], "k-", linewidth=0.7)
    axes[1].set(xscale="log", yscale="log", xlabel="Peak force of the pulse (N)",
                ylabel="Largest sample (N)")
    save(study, figure, "identification-sampling.png")
    study.finish()
    if study.arguments.keep:
        for rate in RATES:
            (study.arguments.keep / f"{rate}.csv").write_text(
                (folder / f"{rate}.csv").read_text(encoding="utf-8"), encoding="utf-8")


if __name__ == "__main__":
    main()

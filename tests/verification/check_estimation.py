#!/usr/bin/python3
"""Two oscillators fitted to many noisy sweeps: bias, spread and coverage of what the data determine.

check_estimation.py PROGRAM SOURCE [--all]: 20 fits with each noise, or 200 (from the peaks always 20).

Synthetic sweeps of params/bilinear-estimation.prm with noise of 1 and 5 % of the root mean
square of each sweep. Three fits of each:

    open     all of m, c, k between wide bounds, with the start of the paper
    paper    the same between the bounds of the paper
    peaks    c and k by the paper's (15)-(17): its two data, amplitude and frequency of the peak, weighted
             by its s and r; they are those of the noisy peak, each with the noise; m known, since two data
             do not determine three constants

The response depends on k/m and c/m alone; the estimates are looked at as natural frequency and damping ratio,
their intervals follow from direction and direction_error of the combinations that are not free.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

import h5py
import numpy

from systems import Table, arguments_of_checks

MASS, DAMPING, STIFFNESS = (1.80, 2.46), (31.14, 19.13), (430.00, 417.78)
WEIGHTS = (0.76, 0.49)  # s of the paper, r = 1 - s
BASE = 10.0  # mm
FREQUENCY = numpy.linspace(1, 6, 51)
CHUNK = 20  # fits in a run: every evaluation is kept
NAMES = ("m1", "c1", "k1", "m2", "c2", "k2")
TRUE = numpy.array([MASS[0], DAMPING[0], STIFFNESS[0], MASS[1], DAMPING[1], STIFFNESS[1]])


def amplitude(body, frequency):
    w = 2 * numpy.pi * frequency
    spring = STIFFNESS[body] + 1j * DAMPING[body] * w
    return BASE * numpy.abs(spring / (spring - MASS[body] * w ** 2))


def peak(body):
    """Amplitude [mm] and frequency [Hz] of the largest amplitude."""
    frequency = numpy.linspace(1, 4, 3_000_001)
    values = amplitude(body, frequency)
    return values.max(), frequency[values.argmax()]


def write_sweeps(folder, noise, seeds):
    for seed in seeds:
        random = numpy.random.default_rng([int(1000 * noise), seed])
        columns = []
        for body in (0, 1):
            values = amplitude(body, FREQUENCY)
            size = noise * numpy.sqrt(numpy.mean(values ** 2))
            columns.append(values + size * random.standard_normal(len(values)))
        rows = [",".join(f"{value:.10g}" for value in row) for row in zip(FREQUENCY, *columns)]
        (folder / f"n{noise}-{seed}.csv").write_text(
            "\n".join(["frequency_hz,first_mm,second_mm", *rows, ""]), encoding="utf-8")


def section(text, begin):
    """From the line `begin` to the end of its section."""
    start = text.index(begin)
    return text[start:text.index("\nend\n", start) + 5]


def fit_of(text, bounds):
    """The section of the analysis fit with one start, and other bounds by the letter of the key. The way along
    the free combinations is long."""
    fit = section(text, "subsection Analysis fit\n").replace(
        "set Starts = 3", "set Starts = 1\n    set Most evaluations = 1500")
    for letter, (lower, upper) in bounds.items():
        fit = re.sub(rf"(Variables/{letter}[12]\n\s+set Lower = )\S+(\n\s+set Upper = )\S+",
                     rf"\g<1>{lower}\g<2>{upper}", fit)
    return fit


def grid_over(files, name):
    listed = ", ".join(files)
    return f"""
subsection Analysis {name}
  set Type = parameter grid
  subsection Parameter grid
    set Repeat = fit
    subsection Key first
      set Path = Analysis/fit/Estimate/Data first/File
      set Values = {listed}
    end
    subsection Key second
      set Tied to = first
      set Path = Analysis/fit/Estimate/Data second/File
      set Values = {listed}
    end
  end
end
set Analyses = {name}
"""


def run(table, folder, name, text):
    file = folder / f"{name}.prm"
    file.write_text(text, encoding="utf-8")
    subprocess.run([table.arguments.program, str(file), "--output", str(folder / name), "--overwrite"],
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return h5py.File(folder / name / "results.h5")["analysis"]


def sweeps(table, folder, noise, seeds, bounds, name):
    """Best fits over the noisy sweeps."""
    text = (table.arguments.source / "params" / "bilinear-estimation.prm").read_text(encoding="utf-8")
    whole = re.sub(r"(?m)^set Analyses.*$", "", text)
    whole = whole.replace(section(text, "subsection Analysis fit\n"), fit_of(text, bounds))
    parts = []
    for first in range(0, len(seeds), CHUNK):
        files = [f"n{noise}-{seed}.csv" for seed in seeds[first:first + CHUNK]]
        parts.append(run(table, folder, f"{name}-{first}", whole + grid_over(files, "many"))["many"])
    return Joined(parts)


class Joined:
    """The results of the first starts of several runs."""

    def __init__(self, parts):
        self.parts = parts

    def __getitem__(self, name):
        return numpy.concatenate([part[name][:, :1, :1] for part in self.parts])


def combinations(many):
    """ln of natural frequency and damping ratio of both oscillators over the true ones, a row for each
    fit, and their standard errors."""
    keys = numpy.array([many[f"key/{name}"][:, 0, 0] for name in NAMES]).T
    rows = numpy.zeros((4, 6))
    for body in (0, 1):
        rows[2 * body, 3 * body:3 * body + 3] = -0.5, 0, 0.5     # ln sqrt(k/m)
        rows[2 * body + 1, 3 * body:3 * body + 3] = -0.5, 1, -0.5  # ln c/(2 sqrt(k m))
    found, errors = [], []
    for values, directions, known in zip(keys, many["direction"][:, 0, 0], many["direction_error"][:, 0, 0]):
        found.append(rows @ numpy.log(values / TRUE))
        determined = known < 1
        errors.append(numpy.sqrt((((rows @ directions[determined].T) * known[determined]) ** 2).sum(1)))
    return numpy.array(found), numpy.array(errors)


QUANTILE = 1.984984  # of Student's distribution with 102 - 6 degrees of freedom, 97.5 %
QUANTITIES = ("natural frequency of mass 1", "damping ratio of mass 1", "natural frequency of mass 2",
              "damping ratio of mass 2")


def judge_open(table, many, noise):
    """Bias within four standard errors, intervals as wide as the spread, and coverage of 95 %."""
    found, errors = combinations(many)
    count = len(found)
    for k, quantity in enumerate(QUANTITIES):
        what = f"{quantity}, noise {100 * noise:g} %, {count} fits"
        spread = found[:, k].std(ddof=1)
        table.add(f"{what}: bias in its standard errors", 0,
                  found[:, k].mean() / (spread / count ** 0.5), 4, absolute=True)
        table.add(f"{what}: standard error over the spread", 1,
                  (errors[:, k] ** 2).mean() ** 0.5 / spread, 4 * (2 * count) ** -0.5, absolute=True)
        covered = (numpy.abs(found[:, k]) <= QUANTILE * errors[:, k]).mean()
        table.add(f"{what}: share of intervals that hold it", 0.95, covered,
                  4 * (0.95 * 0.05 / count) ** 0.5, absolute=True)
    free = (many["direction_error"][:, 0, 0] > 1).sum(axis=1)
    table.add_whole(f"free combinations, least and most, noise {100 * noise:g} %", (2, 2),
                    (free.min(), free.max()))


def judge_paper(table, many, noise):
    """The scale that the data leave free is decided by bounds: at least one of each is active for the first
    mass, whose constants lie in the corner of two."""
    at = {name: many[f"search/bound/{name}"][:, 0, 0] for name in NAMES}
    both = (at["m1"] == -1) & (at["k1"] == 1)
    found, errors = combinations(many)
    table.add(f"fits with m1 and k1 both at a bound, noise {100 * noise:g} %", 0.5, both.mean(), 0.5,
              absolute=True)
    holds = numpy.abs(found[:, 2:]) <= QUANTILE * errors[:, 2:]
    table.add(f"share of intervals of the second mass, between the paper's bounds, noise "
              f"{100 * noise:g} %", 0.95, holds.mean(), 4 * (0.95 * 0.05 / holds.size) ** 0.5 + 0.02,
              absolute=True)
    print("ends of the searches:", numpy.unique(many["search/end"][:, 0, 0], return_counts=True))
    print(f"between the paper's bounds, noise {100 * noise:g} %: m1 and k1 both active in "
          f"{100 * both.mean():.0f} %, one of them in "
          f"{100 * ((at['m1'] == -1) ^ (at['k1'] == 1)).mean():.0f} %; m1 "
          f"{many['key/m1'][:, 0, 0].min():.3f} to {many['key/m1'][:, 0, 0].max():.3f}, m2 "
          f"{many['key/m2'][:, 0, 0].min():.3f} to {many['key/m2'][:, 0, 0].max():.3f}")


PEAK_DATA = """    subsection Data {name}
      set Repeat = curve
      set Quantity = peak/point/{point}.mass/absolute_displacement_x/{quantity}
      set Value = {value:.10g} {unit}
      set Standard deviation = {deviation:.10g} {unit}
    end
"""


def peaks(table, folder, noise, seeds):
    """The paper's (15)-(17) with known masses: as many data as unknowns, so that both residuals vanish and
    the weights decide nothing."""
    text = (table.arguments.source / "params" / "bilinear-estimation.prm").read_text(encoding="utf-8")
    scaled = section(text, "subsection Analysis scaled\n").replace("set Starts = 3", "set Starts = 1")
    scaled = scaled[:scaled.index("    subsection Data")]
    body = re.sub(r"(?m)^set Analyses.*$", "", text)
    body = body.replace(section(text, "subsection Analysis fit\n"), "")
    body = body.replace(section(text, "subsection Analysis scaled\n"), "")
    analyses, names = "", []
    for seed in seeds:
        random = numpy.random.default_rng([int(1000 * noise), seed, 1])
        data = ""
        for mass, point in enumerate(("first", "second")):
            height, place = (value * (1 + noise * random.standard_normal()) for value in peak(mass))
            for quantity, value, unit, weight in (("amplitude", height, "mm", WEIGHTS[mass]),
                                                  ("frequency", place, "Hz", 1 - WEIGHTS[mass])):
                data += PEAK_DATA.format(name=f"{point}-{quantity}", point=point, quantity=quantity,
                                         value=value, unit=unit, deviation=noise * value).replace(
                                             "    end\n", f"      set Weight = {weight:g}\n    end\n")
        analyses += scaled.replace("Analysis scaled", f"Analysis s{seed}") + data + "  end\nend\n"
        names.append(f"s{seed}")
    results = run(table, folder, f"peaks-{noise}", body + analyses + "set Analyses = " + ", ".join(names))
    left, found = [], []
    for name in names:
        fit = results[name]
        left.append(fit["sum_of_squares"][0, 0])
        found.append([fit[f"key/{key}"][0, 0] for key in ("c1", "k1", "c2", "k2")])
    inside = numpy.array([all(results[name][f"search/bound/{key}"][0, 0] == 0
                              for key in ("c1", "k1", "c2", "k2")) for name in names])
    table.add(f"largest sum of squares of peak amplitude and frequency with known masses, noise "
              f"{100 * noise:g} %", 0, numpy.array(left)[inside].max(), 1e-4, absolute=True)
    found = numpy.array(found)[inside] / (DAMPING[0], STIFFNESS[0], DAMPING[1], STIFFNESS[1]) - 1
    print(f"from the peaks, masses known, noise {100 * noise:g} %, {inside.sum()} fits inside the bounds: "
          "standard deviation of c1, k1, c2, k2 in % " +
          ", ".join(f"{100 * value:.2g}" for value in found.std(axis=0, ddof=1)))


def too_few(table, folder):
    """Three constants from two data are refused."""
    text = (table.arguments.source / "params" / "bilinear-estimation.prm").read_text(encoding="utf-8")
    fit = section(text, "subsection Analysis fit\n")
    first = fit[:fit.index("    subsection Key m2")]
    data = "".join(PEAK_DATA.format(name=quantity, point="first", quantity=quantity, value=1, unit=unit,
                                    deviation=1)
                   for quantity, unit in (("amplitude", "mm"), ("frequency", "Hz")))
    file = folder / "too-few.prm"
    file.write_text(text.replace(fit, first + data + "  end\nend\n"), encoding="utf-8")
    done = subprocess.run([table.arguments.program, str(file), "--check"], capture_output=True, text=True,
                          check=False)
    table.add_whole("exit code of three unknowns and two data", (1,), (done.returncode,))
    table.add_whole("the message names both numbers", (1,),
                    (int("there are 2 data and 3 keys" in done.stdout + done.stderr),))


def main():
    parser = arguments_of_checks()
    parser.add_argument("--all", action="store_true", help="200 fits with each noise instead of 20")
    table = Table(__file__, parser.parse_args())
    seeds = range(200 if table.arguments.all else 20)
    folder = pathlib.Path(tempfile.mkdtemp())
    too_few(table, folder)
    for noise in (0.01, 0.05):
        write_sweeps(folder, noise, seeds)
        wide = {"m": (0.9, 4), "c": (1, 100), "k": (190, 900)}
        judge_open(table, sweeps(table, folder, noise, seeds, wide, f"open-{noise}"), noise)
        judge_paper(table, sweeps(table, folder, noise, seeds, {}, f"paper-{noise}"), noise)
        peaks(table, folder, noise, seeds[:CHUNK])
    table.finish()


if __name__ == "__main__":
    sys.exit(main())

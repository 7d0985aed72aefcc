"""Small result files with known numbers, for the tests of figures."""

import h5py
import numpy as np

PARAMETERS = """
set Variables = low = 2 Hz
subsection Contact stop
  set Between   = first.mass, second.mass
  set Direction = x  # along the motion
end
subsection Excitation table
  set History = sine sweep
  subsection Sine sweep
    set From     = low
    set To       = 10 Hz
    set Duration = 4 s
  end
end
subsection Analysis family
  subsection Parameter grid
    subsection Key gap
      set Path   = Variables/gap
      set Values = 1 mm, 2 mm, 2 mm
    end
    subsection Key base
      set Tied to = gap
      set Path    = Variables/base
      set Values  = 5 mm, 5 mm, 6 mm
    end
  end
end
"""
FREQUENCY = np.array([1.0, 2.0, 3.0, 4.0, 5.0])
GAP = np.array([1e-3, 2e-3, 2e-3])
LAMBDA = np.array([1.0, 2.0, 3.0, 4.0])
DELTA = np.array([0.0, 0.5, 1.0])


class Writer:
    """Writes analyses in the schema of docs/results.md."""

    def __init__(self, folder):
        self.file = h5py.File(folder / "results.h5", "w")
        self.file.attrs.update(version="0", parameters=PARAMETERS)

    def analysis(self, name, kind, axes, grid=()):
        """`axes`: name, values and unit of each outer axis, those of the grid first."""
        self.group = self.file.create_group(f"analysis/{name}")
        self.group.attrs.update(name=name, type=kind)
        if grid:
            self.group.attrs["grid"] = list(grid)
        self.axes = [axis for axis, _, _ in axes]
        for axis, values, unit in axes:
            self.scale(axis, values, unit)
        self.shape = tuple(len(values) for _, values, _ in axes)
        self.field("status", np.zeros(self.shape), "1")
        return self

    def scale(self, name, values, unit):
        values = np.asarray(values)
        texts = values.dtype.kind == "U"
        data = self.group.create_dataset(name, data=values.astype(object) if texts else values,
                                         dtype=h5py.string_dtype() if texts else None)
        data.attrs["unit"] = unit
        data.make_scale(name)

    def field(self, path, values, unit, inner=(), dimensions=None, **attributes):
        """Over all outer axes and `inner`, or over `dimensions`."""
        data = self.group.create_dataset(path, data=values)
        data.attrs.update(unit=unit, description=path, **attributes)
        for i, name in enumerate([*self.axes, *inner] if dimensions is None else dimensions):
            data.dims[i].label = name
            if name in self.group:
                data.dims[i].attach_scale(self.group[name])


def write_sweep(writer):
    """Both directions; forward: a jump between 3 and 4 Hz, failed at 5 Hz; backward: not settled
    at 2 Hz. Sections with two points a period, at displacements 1 and 2 times the frequency."""
    writer.analysis("sweep", "stepped sweep",
                    [("frequency", FREQUENCY, "Hz"), ("direction", ["forward", "backward"], "1")])
    value = np.stack([np.array([1, 2, 9, 2, np.nan]), np.array([1, 2, 3, 2, 1])], axis=1)
    jump = np.full((5, 2), np.nan)
    jump[3, 0] = 3.25
    steady = np.ones((5, 2))
    steady[1, 1] = 0
    writer.field("point/first.mass/displacement_x/peak_to_peak", value, "m")
    writer.field("contact/stop/impacts_per_period", np.ones((5, 2)), "1")
    writer.field("jump_from", jump, "Hz")
    writer.field("jump_to", jump + 0.5, "Hz")
    writer.field("steady", steady, "1")
    add_sections(writer)
    add_spectra(writer)


def add_sections(writer):
    once = FREQUENCY[:, None, None] * np.ones((5, 2, 1)) * np.array([1, 2])
    once[4, 0] = np.nan
    for section, extra in [("period", 0.0), ("gap_extremum/stop", 0.5)]:
        base = f"section/{section}/point"
        for point, factor in [("first.mass", 1), ("second.mass", 3)]:
            writer.field(f"{base}/{point}/displacement_x", factor * once + extra, "m", ["sample"])
            writer.field(f"{base}/{point}/velocity_x", -factor * once, "m/s", ["sample"])


def add_spectra(writer):
    order = np.broadcast_to(np.arange(0, 3.5, 0.5), (5, 2, 7))
    amplitude = np.where(order == 1, 1.0, 1e-3)
    writer.field("spectrum/frequency", order * FREQUENCY[:, None, None], "Hz", ["line"])
    writer.field("spectrum/order", order, "1", ["line"])
    writer.field("spectrum/point/first.mass/displacement_x", amplitude, "m", ["line"])


def write_family(writer):
    """Three cases, two of them with the same gap and another base."""
    writer.analysis("family", "stepped sweep",
                    [("Variables.gap", GAP, "m"), ("frequency", FREQUENCY, "Hz"),
                     ("direction", ["forward"], "1")], ["Variables/gap"])
    value = np.arange(3)[:, None, None] + FREQUENCY[:, None]
    writer.field("point/first.mass/displacement_x/peak_to_peak", value, "m")


def write_receptances(writer):
    """A frequency response over a grid: amplitude gap times frequency."""
    writer.analysis("receptance", "frequency response", [("Variables.gap", GAP[:2], "m")],
                    ["Variables/gap"])
    writer.scale("frequency", FREQUENCY, "Hz")
    base = "point/first.mass/displacement_x"
    writer.field(f"{base}/amplitude", GAP[:2, None] * FREQUENCY, "m", ["frequency"])
    writer.field(f"{base}/phase", -GAP[:2, None] * FREQUENCY, "rad", ["frequency"])


def write_orbits(writer):
    """Over lambda: x = lambda cos, the contact closed where x > lambda / 2: twice in the record."""
    writer.analysis("orbits", "steady state", [("Variables.lambda", LAMBDA, "1")], ["Variables/lambda"])
    time = np.linspace(0, 2, 401)
    position = LAMBDA[:, None] * np.sin(2 * np.pi * time)
    gap = LAMBDA[:, None] / 2 - position
    writer.group.create_group("history")
    writer.scale("history/history_time", time, "s")
    for path, values, unit in [
        ("point/first.mass/velocity_x", 2 * np.pi * LAMBDA[:, None] * np.cos(2 * np.pi * time),
         "m/s"), ("point/first.mass/displacement_x", position, "m"),
        ("contact/stop/gap", gap, "m"), ("contact/stop/normal_force", np.maximum(-gap, 0), "N")]:
        writer.field(f"history/{path}", values, unit, ["history/history_time"])
    samples = np.repeat(LAMBDA[:, None], 3, axis=1)
    writer.field("section/period/point/first.mass/displacement_x", samples, "m", ["sample"])
    writer.field("section/period/point/first.mass/velocity_x", 0 * samples, "m/s", ["sample"])


def write_run(writer):
    """A transient motion with a wavelet transform."""
    writer.analysis("run", "transient", [])
    for name, values, unit in [("scale_frequency", np.geomspace(1, 16, 9), "Hz"),
                               ("wavelet_time", np.linspace(0, 5, 11), "s")]:
        writer.group.require_group("recorded")
        writer.scale(f"recorded/{name}", values, unit)
    writer.field("recorded/wavelet/point/first.mass/displacement_x",
                 np.outer(np.arange(1, 10), np.arange(1, 12)), "m",
                 ["recorded/scale_frequency", "recorded/wavelet_time"])
    writer.group["recorded/wavelet/point/first.mass/displacement_x"].dims[0].label = \
        "scale_frequency"
    writer.group["recorded/wavelet/point/first.mass/displacement_x"].dims[1].label = "wavelet_time"
    writer.field("recorded/wavelet_edge", 1 / np.geomspace(1, 16, 9), "s",
                 ["recorded/scale_frequency"])


def write_plane(writer):
    """A grid of two keys and what is derived from it."""
    writer.analysis("plane", "steady state",
                    [("Variables.lambda", LAMBDA, "1"), ("Variables.delta0", DELTA, "m")],
                    ["Variables/lambda", "Variables/delta0"])
    value = LAMBDA[:, None] + 10 * DELTA
    writer.field("point/first.mass/displacement_x/peak_to_peak", value, "m")
    both = ["Variables.lambda", "Variables.delta0"]
    writer.field("derived/largest", value, "m", dimensions=both, operation="maximum", axis="")
    writer.field("derived/best", np.array([2.0, 3.0, 4.0]), "1", dimensions=both[1:],
                 operation="position of minimum", axis="Variables.lambda")
    writer.field("derived/useful", np.array([[[1.0, 2.0]], [[1.5, 2.5]], [[2.0, 3.0]]]), "1",
                 dimensions=[both[1], "interval_useful", "bound"], operation="band",
                 axis="Variables.lambda")
    level = np.array([[1, 0, 5], [4, 0.5, 5], [np.nan] * 3, [1, 0.5, 8], [4, 1, 8]])
    writer.field("derived/level", level, "m", dimensions=["vertex", "coordinate"],
                 operation="contour", axes="Variables.lambda Variables.delta0")
    many = np.array([[1, 0, 1], [4, 0, 1], [1, 0.5, 2], [4, 0.5, 2], [1, 1, 3], [4, 1, 3]])
    writer.field("derived/many", many, "m", dimensions=["vertex", "coordinate"],
                 operation="contour", axes="Variables.lambda Variables.delta0")
    writer.field("derived/smallest", DELTA + 1, "m", dimensions=both[1:], operation="minimum",
                 axis="")
    writer.field("derived/mean", DELTA + 2, "m", dimensions=both[1:], operation="mean", axis="")


def write_all(folder):
    writer = Writer(folder)
    for write in (write_sweep, write_family, write_receptances, write_orbits, write_run,
                  write_plane):
        write(writer)
    writer.file.close()

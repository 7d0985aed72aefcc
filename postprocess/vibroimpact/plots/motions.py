"""Sampled motions in a result file: of a transient analysis, or of the recorder of histories."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .layout import Place
from .parameters_text import number
from .results import Analysis, Array

PERIODS_SHOWN = 6
SAMPLES_IN_CONTACT = 8


@dataclass(frozen=True)
class Motion:
    """The motion at one point of an analysis; `base` is the group of its fields with a slash."""

    analysis: Analysis
    base: str
    place: Place
    direction: str

    def signal(self, path: str) -> np.ndarray:
        """Samples in SI, without the padding of shorter motions."""
        return self.read(path)[self.filled()]

    def unit(self, path: str) -> str:
        return self.analysis.read(self.base + path).unit

    def has(self, path: str) -> bool:
        return self.analysis.has(self.base + path)

    def time(self) -> np.ndarray:
        return self.read(time_name(self.base))[self.filled()]

    def read(self, path: str) -> np.ndarray:
        return self.place.pick(self.analysis, self.analysis.read(self.base + path), self.direction)

    def filled(self) -> np.ndarray:
        return np.isfinite(self.read(time_name(self.base)))

    def recent(self) -> slice:
        """The last periods of a long steady motion, or everything."""
        time, period = self.time(), self.period()
        if period is None or not time.size or time[-1] - time[0] < 1.5 * PERIODS_SHOWN * period:
            return slice(None)
        return slice(int(np.searchsorted(time, time[-1] - (PERIODS_SHOWN + 1e-6) * period)), None)

    def period(self):
        """Of the excitation [s] where results or parameters tell it; None otherwise."""
        if "frequency" in self.analysis.axes:
            index = self.place.index["frequency"]
            return 1 / self.analysis.read("frequency").values[index]
        root = self.base.removesuffix("history/")
        if self.analysis.has(f"{root}section/period/time"):
            instants = self.analysis.read(f"{root}section/period/time")
            steps = np.diff(self.place.pick(self.analysis, instants, self.direction))
            return steps[0] if len(steps) and np.isfinite(steps[0]) else None
        return sample_period(self)


def time_name(base: str) -> str:
    return "history_time" if base.endswith("history/") else "time"


def sample_period(motion: Motion):
    """By the samples per period that the recorder was given."""
    history = motion.analysis.parameters.get(f"Analysis {motion.analysis.name}", {}).get(
        "History", {})
    samples = number(history.get("Samples per period", ""), {})
    if not motion.base or samples is None or history.get("Sampling interval"):
        return None
    time = motion.time()
    return samples * (time[1] - time[0]) if len(time) > 1 else None


def bases(analysis: Analysis) -> list[str]:
    """Groups with sampled motions, those of a recorder first."""
    found = [base for base in ("history/", "recorded/history/")
             if analysis.has(f"{base}history_time")]
    if analysis.type == "transient" and analysis.has("time"):
        found.append("")
    return found


def contacts_of(analysis: Analysis, base: str) -> list[str]:
    """Contacts with a history of force or gap."""
    return [contact for contact in analysis.members(f"{base}contact")
            if any(analysis.has(f"{base}contact/{contact}/{name}")
                   for name in ("normal_force", "gap"))]


def contact_intervals(motion: Motion, contact: str) -> list[tuple[float, float]]:
    """Begin and end of contacts: by the table of impacts where there is one, else where the sampled
    force acts, or without it the gap closed. Samples can miss short contacts."""
    table = f"contact/{contact}/impact/"
    if motion.analysis.has(table + "time"):
        start, length = (motion.place.pick(motion.analysis, motion.analysis.read(table + name),
                                           motion.direction) for name in ("time", "duration"))
        known = np.isfinite(start) & np.isfinite(length)
        return list(zip(start[known], start[known] + length[known]))
    closed = is_closed(motion, contact)
    time = motion.time()
    edges = np.flatnonzero(np.diff(np.concatenate([[0], closed.astype(int), [0]])))
    middles = np.concatenate([time[:1], (time[1:] + time[:-1]) / 2, time[-1:]])
    return [(middles[a], middles[b]) for a, b in zip(edges[::2], edges[1::2])]


def is_closed(motion: Motion, contact: str) -> np.ndarray:
    """A law without cut-off pulls too: its force is negative, and contact lasts."""
    if motion.has(f"contact/{contact}/normal_force"):
        return np.abs(motion.signal(f"contact/{contact}/normal_force")) > 0
    return motion.signal(f"contact/{contact}/gap") <= 0


def is_always_closed(motion: Motion, contact: str) -> bool:
    return bool(is_closed(motion, contact).all())


def parts(analysis: Analysis, base: str, contact: str) -> bool:
    """Whether the sides of a contact move along its normal: under a constant force they do not."""
    path = f"{base}contact/{contact}/gap"
    return not analysis.has(path) or bool(np.nanmax(np.abs(analysis.read(path).values), initial=0.0) > 0)


def finely_sampled(motion: Motion, contact: str) -> bool:
    """Whether the samples show the course of contacts: about eight in each, or more."""
    closed = is_closed(motion, contact)
    begun = np.count_nonzero(np.diff(closed.astype(int)) > 0) + int(closed[:1].any())
    return begun > 0 and np.count_nonzero(closed) >= SAMPLES_IN_CONTACT * begun

"""What a run wrote: its analyses and bodies as labelled arrays, and its summary."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:  # vibroimpact-plot --help answers without these
    import xarray


@dataclass(frozen=True)
class Quantity:
    """A number of the summary in the SI unit `unit` ("1" for a pure number); NaN where it is not known.
    `remark` says what it counts where its name cannot."""

    value: float
    unit: str
    remark: str = ""

    def __float__(self) -> float:
        return self.value


class Groups(Mapping):
    """Groups of results.h5 by name, each read as an xarray.Dataset when it is asked for."""

    def __init__(self, file: Path, group: str):
        self._file, self._group = file, group

    def __getitem__(self, name: str) -> xarray.Dataset:
        from .plots.labelled import open_group

        if name not in list(self):
            raise KeyError(f"{self._file}: there is no {self._group} {name}; there are: "
                           + ", ".join(self))
        return open_group(self._file, f"{self._group}/{name}")

    def __iter__(self) -> Iterator[str]:
        import h5py

        with h5py.File(self._file, "r") as results:
            return iter(list(results.get(self._group, {})))

    def __len__(self) -> int:
        return len(list(iter(self)))

    def __repr__(self) -> str:
        return f"<{self._group}: {', '.join(self)}>"


class ResultFolder(Groups):
    """The results of a run: its analyses by name, each an xarray.Dataset whose variables are the paths
    of results.h5 ("contact/heads/normal_force"), in SI, with the attribute `units`."""

    def __init__(self, folder: Path):
        super().__init__(folder / "results.h5", "analysis")
        self.folder = folder

    @property
    def bodies(self) -> Groups:
        """The bodies by name, each an xarray.Dataset."""
        return Groups(self._file, "body")

    @property
    def contacts(self) -> xarray.Dataset:
        """Clearance, flexibility share and impact error of all contacts."""
        from .plots.labelled import open_group

        return open_group(self._file, "contact")

    @property
    def attributes(self) -> dict:
        """Of the file: version, commit, parameters, command_line, libraries, ranks, processor."""
        import h5py

        with h5py.File(self._file, "r") as results:
            return dict(results.attrs)

    @property
    def summary(self) -> dict[str, Quantity]:
        """The entries of summary.json in their order."""
        return {name: Quantity(number(entry["value"]), entry["unit"], entry.get("remark", ""))
                for name, entry in self._summary_file()["values"].items()}

    @property
    def notes(self) -> dict[str, str]:
        """What finished points say in words, by the name of the analysis and the point."""
        return self._summary_file()["notes"]

    def _summary_file(self) -> dict:
        return json.loads((self.folder / "summary.json").read_text(encoding="utf-8"))

    def __repr__(self) -> str:
        return f"<results in {self.folder}: {', '.join(self)}>"


def number(value) -> float:
    """JSON has no NaN, and infinities as text."""
    return float("nan" if value is None else value)


def open_folder(folder) -> ResultFolder:
    """Opens a result folder; a run under way may be read too. ResultError when there is none."""
    from .plots.results import Results

    with Results(Path(folder)) as results:
        return ResultFolder(results.folder)

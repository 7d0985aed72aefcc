"""Other programs open results.h5 as labelled arrays: check_results.py FOLDER"""

import json
import re
import sys
import unittest
from pathlib import Path

import h5py
import numpy as np

FOLDER = Path(sys.argv.pop(1))
FILE = FOLDER / "results.h5"


class Hdf5(unittest.TestCase):
    def setUp(self):
        self.file = h5py.File(FILE, "r")
        self.addCleanup(self.file.close)

    def datasets(self):
        found = []
        self.file.visititems(
            lambda _, item: found.append(item) if isinstance(item, h5py.Dataset) else None
        )
        return found

    def test_every_dimension_has_a_scale_and_its_name(self):
        self.assertGreater(len(self.datasets()), 80)
        for dataset in self.datasets():
            for length, dimension in zip(dataset.shape, dataset.dims):
                if h5py.h5ds.is_scale(dataset.id):
                    continue
                with self.subTest(dataset.name):
                    self.assertEqual(len(dimension), 1)
                    self.assertEqual(dimension.label, dimension[0].name.rsplit("/", 1)[-1])
                    self.assertEqual(dimension[0].shape, (length,))

    def test_every_dataset_has_a_unit_and_a_description(self):
        for dataset in self.datasets():
            with self.subTest(dataset.name):
                self.assertTrue(dataset.attrs["unit"])
                self.assertIn("description", dataset.attrs)

    def test_axes(self):
        force = self.file["analysis/response/contact/heads/normal_force/maximum"]
        self.assertEqual([d.label for d in force.dims], ["frequency", "direction"])
        np.testing.assert_allclose(force.dims[0][0][:], np.linspace(1, 6, 61), rtol=1e-15)
        self.assertEqual(list(force.dims[1][0].asstr()), ["forward", "backward"])

    def test_time_is_the_coordinate_of_histories(self):
        force = self.file["analysis/release/contact/heads/normal_force"]
        self.assertEqual(force.dims[0][0].name, "/analysis/release/time")
        fit = self.file["analysis/release/fit/exact/restitution"]
        self.assertEqual(fit.dims[0][0].name, "/analysis/release/fit/ratio_axis")

    def test_attributes(self):
        self.assertEqual(self.file.attrs["version"], "0.1.0")
        self.assertEqual(list(self.file.attrs["libraries"]), ["deal.II 9.4.1", "HDF5 1.10.8"])
        self.assertEqual(self.file["analysis/response"].attrs["type"], "stepped sweep")
        self.assertEqual(list(self.file["analysis/map"].attrs["grid"]),
                         ["Contact/heads/Clearance"])

    def test_body(self):
        body = self.file["body/left"]
        self.assertAlmostEqual(body["frequency"][0], 2.95, places=10)
        self.assertEqual(body["shapes"].shape, (13, 6, 3))
        # The point at the free end moves as the last node does.
        np.testing.assert_array_equal(body["point_rows"][0], body["shapes"][12])


class Xarray(unittest.TestCase):
    def test_netcdf4_opens_every_group(self):
        try:
            import netCDF4  # noqa: F401
            import xarray
        except ImportError as error:
            self.skipTest(str(error))
        groups = ["/"]
        with h5py.File(FILE, "r") as file:
            file.visititems(
                lambda name, item: groups.append(name) if isinstance(item, h5py.Group) else None
            )
        for group in groups:
            with self.subTest(group), xarray.open_dataset(
                FILE, engine="netcdf4", group=group
            ) as data:
                data.load()
        with xarray.open_dataset(FILE, engine="netcdf4", group="analysis/map") as data:
            self.assertEqual(data.steady.dims, ("Contact.heads.Clearance", "frequency", "direction"))
            self.assertEqual(float(data.steady.sel(frequency=1, direction="forward")[0]), 1)


class Summary(unittest.TestCase):
    """summary.json has the entries of summary.txt with all digits: those of results.h5."""

    def setUp(self):
        self.text = (FOLDER / "summary.txt").read_text(encoding="utf-8")
        content = json.loads((FOLDER / "summary.json").read_text(encoding="utf-8"),
                             object_pairs_hook=self.without_repetition)
        self.values, self.notes = content["values"], content["notes"]

    def without_repetition(self, pairs):
        names = [name for name, _ in pairs]
        self.assertEqual(len(names), len(set(names)))
        return dict(pairs)

    @staticmethod
    def number(value):
        return float("nan" if value is None else value)

    def test_every_line_of_the_text_is_there_in_its_order(self):
        lines = re.findall(r"^(?!# )(.*?) = (\S+) \[(.*?)\](?:  (.*))?$", self.text, re.MULTILINE)
        self.assertGreater(len(lines), 50)
        self.assertEqual(
            lines, [(name, f"{self.number(entry['value']):.12g}", entry["unit"],
                     entry.get("remark", "")) for name, entry in self.values.items()])
        notes = re.findall(r"^# (.*?): (.*)$", self.text, re.MULTILINE)
        self.assertEqual(dict(notes), self.notes)

    def test_values_are_those_of_the_result_file(self):
        with h5py.File(FILE, "r") as file:
            for name in file["body"]:
                frequency = file[f"body/{name}/frequency"]
                for j, value in enumerate(frequency[:]):
                    entry = self.values[f"body.{name}.frequency[{j + 1}]"]
                    self.assertEqual(entry["unit"], frequency.attrs["unit"])
                    self.assertAlmostEqual(entry["value"] / value, 1, delta=4e-16)
            failed = np.count_nonzero(file["analysis/response/status"][:] == 1)
            self.assertGreater(failed, 0)
            self.assertEqual(self.values["analysis.response.failed_points"]["value"], failed)


if __name__ == "__main__":
    unittest.main()

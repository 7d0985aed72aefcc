"""The Python package on small models with closed forms."""
import math
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import vibroimpact

PACKAGE = Path(vibroimpact.__file__).parents[1]
MASS = 2.0  # [kg]
STIFFNESS = 1000.0  # [N/m]
FILE = f"""
set Title = oscillator
subsection Body oscillator
  set Type = lumped
  subsection Mass mass
    set Mass = {MASS} kg
    set Stiffness = {STIFFNESS} N/m
  end
end
subsection Contact stop
  set Between = oscillator.mass, stop
  set Clearance = 5 mm
  subsection Linear penalty
    set Stiffness = 1 MN/m
  end
end
subsection Initial condition start
  set At = oscillator.mass
  set Displacement = 1 mm
end
subsection Analysis motion
  set Type = transient
  subsection Transient
    set Duration = 1 s
    set Sampling interval = 5 ms
  end
end
subsection Analysis cases
  set Type = parameter grid
  subsection Parameter grid
    set Repeat = motion
    subsection Key start
      set Path = Initial condition/start/Displacement
      set Values = 1 mm, 2 mm, 3 mm
    end
  end
end
"""
MASS_KEY = "Body/oscillator/Mass mass/Mass"


@pytest.fixture(name="file")
def parameter_file(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "case.prm").write_text(FILE)
    return "case.prm"


def test_a_run_gives_labelled_arrays_in_si(file):
    results = vibroimpact.run(file, set={"Analyses": "motion"})
    assert results.folder == Path("output/case")
    assert list(results) == ["motion"]
    displacement = results["motion"]["point/oscillator.mass/displacement_x"]
    assert displacement.dims == ("time",)
    assert displacement.attrs["units"] == "m"
    assert results["motion"]["time"].attrs["units"] == "s"
    exact = 1e-3 * np.cos(math.sqrt(STIFFNESS / MASS) * displacement["time"].values)
    np.testing.assert_allclose(displacement.values, exact, atol=1e-12)


def test_axes_of_a_grid_are_coordinates(file):
    cases = vibroimpact.run(file, ranks=2)["cases"]
    displacement = cases["point/oscillator.mass/displacement_x"]
    at_start = displacement.sel({"time": 0, "Initial condition.start.Displacement": 0.002})
    assert float(at_start) == 0.002


def test_results_are_the_same_on_two_ranks(file):
    one = vibroimpact.run(file, output="one")["cases"]
    two = vibroimpact.run(file, output="two", ranks=2)["cases"]
    assert one.identical(two)


def test_keys_are_set_by_numbers_texts_and_lists(file):
    stiffness = "Body/oscillator/Mass mass/Stiffness"
    results = vibroimpact.run(file, set={MASS_KEY: np.float64(0.5), stiffness: "4 kN/m",
                                         "Analyses": ["motion"]})
    frequency = results.summary["body.oscillator.frequency[1]"]
    assert frequency.unit == "Hz"
    assert float(frequency) == pytest.approx(math.sqrt(4000 / 0.5) / (2 * math.pi), rel=1e-15)


@pytest.mark.parametrize("value, text", [
    (True, "true"), (np.bool_(False), "false"), (3, "3"), (np.int64(-4), "-4"), ("7 mm", "7 mm"),
    (0.1 + 0.2, "0.30000000000000004"), ([1, 2.5, "3 mm"], "1, 2.5, 3 mm"),
    (np.array([1.0, 0.0]), "1.0, 0.0"), (Path("a/b"), "a/b")])
def test_values_as_they_stand_in_a_file(value, text):
    assert vibroimpact.program.value_text(value) == text


@pytest.mark.parametrize("ranks", [1, 2])
def test_wrong_input_raises_the_message_of_the_program(file, ranks):
    with pytest.raises(vibroimpact.InputError) as caught:
        vibroimpact.run(file, set={MASS_KEY: "-1 kg"}, ranks=ranks)
    assert "Mass" in str(caught.value) and "-1 kg" in str(caught.value)
    assert "mpirun" not in str(caught.value)


def test_results_are_overwritten_only_when_asked(file):
    only_motion = {"Analyses": "motion"}
    vibroimpact.run(file, set=only_motion)
    with pytest.raises(vibroimpact.InputError, match="overwrite"):
        vibroimpact.run(file, set=only_motion)
    vibroimpact.run(file, set=only_motion, overwrite=True)


def test_failed_points_are_a_warning(file):
    limits = {"Analyses": "cases", "Integration/Method": "rk", "Integration/Maximum steps": 2}
    with pytest.warns(vibroimpact.PointsFailed, match="3 of 3 points failed:\n.*3: .*2 steps"):
        results = vibroimpact.run(file, set=limits)
    assert results["cases"]["status"].values.tolist() == [1, 1, 1]
    assert "2 steps" in results.summary["analysis.cases.failed_points[1]"].remark


def test_codes_become_exceptions():
    for code, kind in ((1, vibroimpact.InputError), (2, vibroimpact.RunError), (-9, vibroimpact.RunError)):
        with pytest.raises(kind, match="the reason"):
            vibroimpact.program.raise_error(subprocess.CompletedProcess([], code, "", "the reason\n"))


def test_an_end_without_a_message_is_not_wrong_input():
    with pytest.raises(vibroimpact.RunError, match="mpirun ended with code 1 and without a message"):
        vibroimpact.program.raise_error(subprocess.CompletedProcess(["mpirun"], 1, "", ""))


def test_ranks_need_mpirun(file, tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(vibroimpact.ProgramNotFound, match="mpirun is needed for 2 ranks"):
        vibroimpact.run(file, ranks=2)


def test_a_stopped_run_says_how_to_go_on(file, tmp_path):
    impatient = tmp_path / "impatient"
    # The journal is begun when signals are heeded already.
    impatient.write_text(f'#!/bin/sh\n{vibroimpact.program.find_program()} "$@" &\n'
                         'while [ ! -e output/case/journal ] && kill -0 $!; do sleep 0.05; done\n'
                         'kill -TERM $!\nwait $!\n')
    impatient.chmod(0o755)
    endless = {"Analyses": "motion", "Integration/Method": "rk",
               "Analysis/motion/Transient/Duration": "1e8 s",
               "Analysis/motion/Transient/Sampling interval": "1e6 s"}
    with pytest.raises(vibroimpact.Stopped, match="--resume output/case"):
        vibroimpact.run(file, set=endless, program=str(impatient))


def test_a_run_goes_on(file):
    first = vibroimpact.run(file)
    assert vibroimpact.resume(first.folder, ranks=2)["cases"].identical(first["cases"])
    with pytest.raises(vibroimpact.InputError):
        vibroimpact.resume("nowhere")


def test_check_runs_nothing(file):
    assert "The file can be run." in vibroimpact.check(file)
    assert not Path("output").exists()


def test_what_is_printed_can_be_seen(file, capsys):
    vibroimpact.run(file, set={"Analyses": "motion"}, echo=True)
    assert "Results: output/case/results.h5" in capsys.readouterr().out


def test_the_program_must_be_there(file, monkeypatch):
    monkeypatch.setenv("VIBROIMPACT_PROGRAM", "/nonexistent/vibroimpact")
    with pytest.raises(vibroimpact.ProgramNotFound, match="/nonexistent/vibroimpact"):
        vibroimpact.run(file)
    with pytest.raises(ValueError, match="ranks must be at least 1, but is 0"):
        vibroimpact.run(file, ranks=0)


def test_bodies_contacts_and_attributes(file):
    results = vibroimpact.open(vibroimpact.run(file, set={"Analyses": "motion"}).folder)
    assert float(results.bodies["oscillator"]["mass"].values[0]) == MASS
    assert results.contacts["clearance"].values.tolist() == [0.005]
    assert results.contacts["clearance"].attrs["units"] == "m"
    assert "set Title" in results.attributes["parameters"]
    assert results.notes == {}
    with pytest.raises(KeyError, match="there is no analysis sweep; there are: motion"):
        results["sweep"]


def test_a_file_without_units_has_arrays_and_figures_without(tmp_path, monkeypatch):
    from vibroimpact.plots.labels import SHOWN, scale_for, with_unit
    monkeypatch.chdir(tmp_path)
    plain = FILE.replace("set Title", "set Units = dimensionless\nset Title")
    for unit in (" kg", " N/m", " mm", " ms", " s\n", " MN/m"):
        plain = plain.replace(unit, "\n" if unit.endswith("\n") else "")
    plain = plain.replace("interval = 5", "interval = 0.005")
    Path("plain.prm").write_text(plain)
    results = vibroimpact.run("plain.prm", set={"Analyses": "motion"})
    arrays = [*results["motion"].variables.values(), *results.bodies["oscillator"].values()]
    assert all("units" not in array.attrs and array.attrs["unit"] == "1" for array in arrays)
    omega = results.bodies["oscillator"]["frequency"]
    np.testing.assert_allclose(omega.values, math.sqrt(STIFFNESS / MASS), rtol=1e-12)
    assert {entry.unit for entry in results.summary.values()} == {"1"}
    vibroimpact.plot(results, figure="motion*")
    monkeypatch.setitem(SHOWN, "units", False)
    assert scale_for("m", [1e-3]).label("Gap") == "Gap"
    assert with_unit("2.4", "Hz") == "2.4"


def test_a_folder_without_results_is_refused(tmp_path):
    from vibroimpact.plots.errors import ResultError
    with pytest.raises(ResultError, match="no results.h5 in it"):
        vibroimpact.open(tmp_path)


def test_figures(file):
    results = vibroimpact.run(file, set={"Analyses": "motion"})
    names = {path.name for path in vibroimpact.plot(results, format="svg", output="drawn")}
    assert names == {path.name for path in Path("drawn").iterdir()} and names
    with pytest.raises(vibroimpact.PlotError, match="no figure is called nothing"):
        vibroimpact.plot(results.folder, figure="nothing")
    with pytest.raises(vibroimpact.PlotError, match="--colour"):
        vibroimpact.plot(results, colour="red")


def test_options_of_figures():
    given = {"figure": ["a", "b"], "angular": True, "list": False, "size": (6, 4), "dpi": 200}
    assert vibroimpact.drawing.arguments(given) == [
        "--figure", "a", "--figure", "b", "--angular", "--size", "6x4", "--dpi", "200"]


def test_infinite_and_unknown_numbers_of_the_summary():
    values = [vibroimpact.folder.number(value) for value in (None, "inf", "-inf", 2)]
    assert math.isnan(values[0]) and values[1:] == [math.inf, -math.inf, 2.0]


def test_the_import_needs_no_library(tmp_path):
    for module in ("numpy", "h5py", "xarray", "matplotlib"):
        (tmp_path / f"{module}.py").write_text("raise ImportError('not wanted')\n")
    done = subprocess.run([sys.executable, "-B", "-c", "import vibroimpact"], check=False, text=True,
                          capture_output=True,
                          env=os.environ | {"PYTHONPATH": f"{tmp_path}:{PACKAGE}"})
    assert (done.returncode, done.stderr) == (0, "")


def test_warnings_keep_their_reasons():
    printed = "reading\nwarning: 1 of 3 points failed:\n  1: stuck\nnext\nwarning: doubtful\n"
    assert vibroimpact.program.warnings_in(printed) == ["1 of 3 points failed:\n  1: stuck", "doubtful"]

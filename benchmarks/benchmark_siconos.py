#!/usr/bin/python3
"""Dry friction by vibroimpact and by Siconos (python3-siconos), whose time-stepping scheme is of
first order: error and processor time.

usage: benchmark_siconos.py PROGRAM

free: x'' + x = -sgn x' from x = 12, x' = 6, its place at 14.74 s. driven: two masses, one driven, one
with friction 0.5, its place at 100 s. Says so and ends with exit code 0 where Siconos is not there.
"""
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

import h5py
import numpy as np

MASS = """
  subsection Mass {name}
    set Mass = 1 kg
    set Axis = x
    set Stiffness = {stiffness} N/m
  end
"""
FRICTION = """
subsection Contact ground
  set Between = b.{name}, stop
  set Direction = z
  set Law = constant force
  subsection Constant force
    set Force = {limit} N
  end
  subsection Friction
    set Law = coulomb
    set Direction = x
    subsection Coulomb
      set Coefficient = 1
    end
  end
end
"""
START = """
subsection Initial condition start
  set Direction = x
  set At = b.one
  set Displacement = {place} m
  set Velocity = {speed} m/s
end
"""
DRIVE = """
subsection Connection spring
  set Between = b.one, b.two
  set Direction = x
  set Stiffness = 1 N/m
end
subsection Excitation force
  set Type = force
  set At = b.one
  set Direction = x
  set Amplitude = 1 N
  set Frequency = 0.3 rad/s
  set Phase = 90 deg
end
"""
RUN = """
subsection Analysis run
  set Type = transient
  subsection Transient
    set Duration = {end} s
    set Sampling interval = {end} s
  end
end
"""
STEPS = (1e-1, 1e-2, 1e-3, 1e-4)


def body(*masses):
    return "subsection Body b\n  set Type = lumped\n" + "".join(masses) + "end\n"


CASES = {
    "free": {
        "text": body(MASS.format(name="one", stiffness=1)) + FRICTION.format(name="one", limit=1) +
                START.format(place=12, speed=6) + RUN.format(end=14.74),
        "stiffness": [[1.0]], "rubs": 0, "limit": 1.0, "drive": 0.0, "start": [12.0, 6.0],
        "end": 14.74, "expected": 0.2676911293},
    "driven": {
        "text": body(MASS.format(name="one", stiffness=1), MASS.format(name="two", stiffness=0)) +
                FRICTION.format(name="two", limit=0.5) + START.format(place=1, speed=0) + DRIVE +
                RUN.format(end=100),
        "stiffness": [[2.0, -1.0], [-1.0, 1.0]], "rubs": 1, "limit": 0.5, "drive": 1.0,
        "start": [1.0, 0.0, 0.0, 0.0], "end": 100.0, "expected": -0.36008914860786}}


def by_vibroimpact(program, case):
    """Place at the end, processor time of the whole process."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "case.prm"
        file.write_text(case["text"], encoding="utf-8")
        begin = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        subprocess.run([program, file, "--output", f"{folder}/out"], check=True,
                       stdout=subprocess.DEVNULL)
        seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - begin
        with h5py.File(f"{folder}/out/results.h5") as found:
            name = ("one", "two")[case["rubs"]]
            return found[f"analysis/run/point/b.{name}/displacement_x"][-1], seconds


def by_siconos(kernel, case, step):
    """Place at the end, processor time of the steps."""
    stiffness = np.array(case["stiffness"])
    n = len(stiffness)
    matrix = np.block([[np.zeros((n, n)), np.eye(n)], [-stiffness, np.zeros((n, n))]])
    system = kernel.FirstOrderLinearDS(case["start"], matrix)
    system.setbPtr(np.zeros(2 * n))
    into = np.zeros((2 * n, 1))
    into[n + case["rubs"], 0] = case["limit"]
    rate = np.zeros((1, 2 * n))
    rate[0, n + case["rubs"]] = 1
    steps = round(case["end"] / step)
    model = kernel.NonSmoothDynamicalSystem(0, case["end"])
    model.insertDynamicalSystem(system)
    model.link(kernel.Interaction(kernel.RelayNSL(1, -1, 1), kernel.FirstOrderLinearTIR(rate, into)),
               system)
    simulation = kernel.TimeStepping(model, kernel.TimeDiscretisation(0, step),
                                     kernel.EulerMoreauOSI(0.5), kernel.Relay())
    begin = time.process_time()
    for k in range(steps):
        load = np.zeros(2 * n)
        load[n] = case["drive"] * np.cos(0.3 * (k + 0.5) * step)
        system.setbPtr(load)
        simulation.computeOneStep()
        simulation.nextStep()
    return system.x()[case["rubs"]], time.process_time() - begin


def main():
    try:
        import siconos.kernel as kernel
    except ImportError:
        print("Siconos is not there (python3-siconos).")
        return
    print("motion   side               error     s")
    for name, case in CASES.items():
        place, seconds = by_vibroimpact(sys.argv[1], case)
        print(f"{name:8} vibroimpact     {abs(place - case['expected']):8.1e}  {seconds:.3g} "
              "(whole process)")
        for step in STEPS:
            place, seconds = by_siconos(kernel, case, step)
            print(f"{name:8} Siconos h {step:6g} {abs(place - case['expected']):8.1e}  {seconds:.3g}",
                  flush=True)


if __name__ == "__main__":
    main()

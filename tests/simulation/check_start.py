#!/usr/bin/python3
"""How the program starts: texts and refused arguments without MPI, a single process without the
daemon of Open MPI, and settings of the user left alone.

usage: check_start.py PROGRAM MPIEXEC
"""
import os
import subprocess

from program_runs import ProgramRuns, main

FILE = """
subsection Body oscillator
  set Type = lumped
  subsection Mass mass
    set Mass = 1 kg
    set Stiffness = 1 kN/m
  end
end
subsection Analysis motion
  set Type = transient
  subsection Transient
    set Duration = 0.1 s
  end
end
"""

# Where Open MPI looks for its daemon, and a transport that there is not: with the one it cannot
# start a process with a daemon, with the other it cannot start at all.
NO_DAEMON = {"OPAL_BINDIR": "/nonexistent"}
NO_MPI = {"OMPI_MCA_pml": "none_of_this_name"}


class Start(ProgramRuns):
    def run_with(self, environment, *arguments, ranks=1):
        return subprocess.run(self.command(*arguments, ranks=ranks), cwd=self.folder,
                              env=os.environ | environment, capture_output=True, text=True,
                              check=False, timeout=600)

    def run_file(self, environment):
        self.file.write_text(FILE)
        return self.run_with(environment, self.file, "--output", self.folder / "out", "--overwrite")

    def test_texts_need_no_mpi(self):
        for arguments, words in ((["--help"], "--print-parameters"), (["--version"], "deal.II"),
                                 (["--print-parameters", "json"], '"keys"')):
            done = self.run_with(NO_MPI, *arguments)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn(words, done.stdout)

    def test_bad_arguments_need_no_mpi(self):
        for arguments, words in ((["--outputs", "x"], "unrecognised option"), ([], "is needed"),
                                 (["a.prm", "b.prm"], "one parameter file at a time"),
                                 (["--print-parameters", "xml"], "markdown, prm or json")):
            done = self.run_with(NO_MPI, *arguments)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertIn(words, done.stderr)

    def test_a_single_process_needs_no_daemon(self):
        done = self.run_file(NO_DAEMON)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertTrue((self.folder / "out" / "results.h5").exists())

    def test_a_single_process_needs_no_folder_of_mpi(self):
        done = self.run_file({"OMPI_MCA_orte_tmpdir_base": "/proc/nowhere"})
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_settings_of_the_user_are_left_alone(self):
        self.assertNotEqual(self.run_file(NO_MPI).returncode, 0)
        with_daemon = NO_DAEMON | {"OMPI_MCA_ess_singleton_isolated": "0"}
        self.assertNotEqual(self.run_file(with_daemon).returncode, 0)

    def test_one_of_several_processes_speaks(self):
        done = self.run_with({}, "--help", ranks=2)
        self.assertEqual((done.returncode, done.stdout.count("Exit code:")), (0, 1))
        done = self.run_with({}, "--outputs", ranks=2)
        self.assertEqual((done.returncode, done.stderr.count("unrecognised option")), (1, 1))


if __name__ == "__main__":
    main()

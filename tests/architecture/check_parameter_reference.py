"""Checks that docs/parameters.md is what the program prints about its own parameters.

    check_parameter_reference.py PROGRAM REFERENCE     exit code 1 and the differences when it is not
    check_parameter_reference.py --self-test           proves that a stale reference is found
"""

import difflib
import pathlib
import subprocess
import sys
import tempfile


def differences(program, reference):
    """The lines of a message; empty when the file is up to date."""
    command = [*program, "--print-parameters", "markdown"]
    printed = subprocess.run(command, check=True, capture_output=True, encoding="utf-8").stdout
    stored = reference.read_text(encoding="utf-8") if reference.exists() else ""
    lines = list(difflib.unified_diff(stored.splitlines(), printed.splitlines(), str(reference),
                                      "printed by the program", lineterm=""))
    if lines:
        lines += ["", f"{reference.name} is out of date; refresh it by",
                  f"  {' '.join(command)} > {reference}"]
    return lines


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        reference = pathlib.Path(folder) / "parameters.md"
        program = [sys.executable, "-c", "print('# Parameters')"]
        missing = differences(program, reference)
        reference.write_text("# Old parameters\n", encoding="utf-8")
        stale = differences(program, reference)
        reference.write_text("# Parameters\n", encoding="utf-8")
        fresh = differences(program, reference)
    found = all(any("out of date" in line for line in lines) for lines in (missing, stale))
    return [] if found and not fresh else ["a stale reference is not told from a fresh one"]


def main():
    if sys.argv[1:] == ["--self-test"]:
        lines = self_test()
    elif len(sys.argv) == 3:
        lines = differences([sys.argv[1]], pathlib.Path(sys.argv[2]))
    else:
        sys.exit(__doc__)
    print("\n".join(lines) or "up to date")
    sys.exit(1 if lines else 0)


if __name__ == "__main__":
    main()

"""Checks the rules of docs/architecture.md on the source tree: which folder may include which, which
library may be used where, that no name is defined twice, how long a file may be, how tests are named,
and that each is built.

    check_sources.py TREE          prints every violation as FILE:LINE: what is wrong; exit code 1
    check_sources.py --self-test   proves on made-up trees that each rule can fail
"""

import pathlib
import re
import sys
import tempfile

import defined_names

# In the order data flows: a folder may include itself and what stands before it.
ORDER = ["common", "parameters", "continuation", "structure", "modes", "reduction", "model",
         "contact", "motion", "periodic", "analyses", "derived", "output"]
# These stand beside the flow; they know nothing of what the others do.
ALLOWED = {"common": {"common"}, "parameters": {"common", "parameters"},
           "continuation": {"common", "continuation"}}
# The files above all folders, each with those of its kind that it may include.
PROGRAM = {"command_line": set(), "launcher": set(), "run_information": set(),
           "simulation": {"run_information"},
           "simulation_cases": {"simulation"}, "simulation_checks": {"simulation"},
           "simulation_cost": {"simulation"},
           "program": {"command_line", "launcher", "run_information", "simulation"},
           "main": {"program"}}
GENERATED = {"version.h"}

# What is known in few places only: a pattern of the include, the files that may have it, the reason.
FENCES = [
    (r"deal\.II/base/", r"structure/|output/vtu_|program\.cc|run_information\.cc",
     "deal.II's base belongs to structure/, the VTU writer and the program's start"),
    (r"deal\.II/(?!base/)", r"structure/|output/vtu_",
     "deal.II belongs to structure/ and the VTU writer"),
    (r"slepcversion\.h", r"modes/|run_information\.cc", "SLEPc belongs to modes/"),
    (r"slepc(?!version)", r"modes/", "SLEPc belongs to modes/"),
    (r"nlopt\.h", r"analyses/design/", "NLopt belongs to analyses/design/"),
    (r"petscts\.h", r"motion/steps/", "PETSc TS belongs to motion/steps/"),
    (r"petscversion\.h", r"structure/|modes/|motion/|program\.cc|run_information\.cc",
     "PETSc belongs to structure/, modes/ and motion/"),
    (r"petsc(?!version|ts\.)",
     r"common/petsc_(error|stage)\.cc|structure/|modes/|motion/|program\.cc",
     "PETSc belongs to structure/, modes/ and motion/"),
    (r"(hdf5(_hl)?|H5\w+)\.h", r"common/hdf5_file(_driver)?\.",
     "HDF5 is used through common/hdf5_file.h"),
    (r"(structure|modes)/", r"structure/|modes/|reduction/",
     "after the reduced body there is no finite element left"),
    (r"contact/laws/", r"contact/", "nobody but the contacts knows which law it holds"),
    (r"(fstream|cstdio)$", r"(?!model/|contact/|motion/|analyses/)",
     "models and analyses write no files"),
]

ROOT = "vibroimpact"
# These folders stand in the namespace ROOT itself, as do the program's own files.
WITHOUT_NAMESPACE = {"common"}

INCLUDE = re.compile(r'\s*#\s*include\s*([<"])([^>"]+)[>"]')
# Spelled so that this file does not find itself.
UNFINISHED = re.compile(r"\b(T[O]DO|F[I]XME)\b")
TEST = re.compile(r"TEST(?:_F|_P)?\((\w+)")
LONGEST = 450
CHECKED_FOLDERS = ["src", "tests", "postprocess", "benchmarks", "scripts", "cmake"]
CHECKED_SUFFIXES = {".cc", ".h", ".py", ".sh", ".cmake", ".txt", ".in"}


def folder_problem(file, included, known_files):
    """Why `file` may not include "included" (both relative to src/), or None."""
    if "/" not in included:
        stem = pathlib.PurePosixPath(included).stem
        if "/" in file:
            return "an include names its folder, and no folder includes the program's own files"
        own = pathlib.PurePosixPath(file).stem
        if included in GENERATED or stem == own or stem in PROGRAM.get(own, set()):
            return None
        return f"{own} may not include {included}"
    target = included.split("/")[0]
    if target not in ORDER:
        return f"{target}/ is not in the order of the folders"
    if included not in known_files:
        return "there is no such file"
    if "/" not in file:
        return None
    source = file.split("/")[0]
    if source not in ORDER:
        return f"{source}/ is not in the order of the folders"
    if target not in ALLOWED.get(source, ORDER[:ORDER.index(source) + 1]):
        return f"{source}/ may not include {target}/, which comes after it"
    return None


def include_problems(file, included, quoted, known_files):
    problem = folder_problem(file, included, known_files) if quoted else None
    if problem:
        yield problem
    for pattern, allowed, reason in FENCES:
        if re.match(pattern, included) and not re.match(allowed, file):
            yield reason


def source_problems(tree):
    source = tree / "src"
    files = sorted(path.relative_to(source).as_posix() for path in source.rglob("*")
                   if path.suffix in {".cc", ".h"})
    known_files = set(files)
    for file in files:
        lines = (source / file).read_text(encoding="utf-8").splitlines()
        for number, line in enumerate(lines, 1):
            match = INCLUDE.match(line)
            if match:
                for problem in include_problems(file, match[2], match[1] == '"', known_files):
                    yield f"src/{file}:{number}: {match[2]}: {problem}"


def text_problems(tree):
    for folder in CHECKED_FOLDERS:
        for path in sorted((tree / folder).rglob("*")):
            if path.suffix not in CHECKED_SUFFIXES or not path.is_file():
                continue
            name = path.relative_to(tree).as_posix()
            lines = path.read_text(encoding="utf-8").splitlines()
            if len(lines) > LONGEST:
                yield f"{name}:{LONGEST + 1}: {len(lines)} lines, more than {LONGEST}"
            for number, line in enumerate(lines, 1):
                if UNFINISHED.search(line):
                    yield f"{name}:{number}: something is left to do"


def namespace_problem(file, path, only_forwards):
    """Why `file` (relative to src/) may not open the namespace, or None. Another folder's may be opened
    by those who may include it, to name its classes."""
    folder = file.split("/")[0] if "/" in file else ""
    before = ALLOWED.get(folder, ORDER[:ORDER.index(folder)] if folder in ORDER else ORDER)
    if only_forwards and list(path[:1]) == [ROOT] and len(path) == 2 and path[1] in before:
        return None
    own = [ROOT] + [folder] * (folder != "" and folder not in WITHOUT_NAMESPACE)
    if path[0] != ROOT or path[-1] == "":
        return None
    if list(path[:len(own)]) == own and not set(path[len(own):]) & set(ORDER):
        return None
    return f"namespace {'::'.join(path)} is opened, not {'::'.join(own)}"


def definition_problem(name, namespace, pair, first):
    """Why a pair of files may not define the name, or None; `first` holds which pair did so first."""
    if "" in namespace or namespace[:1] not in ((), (ROOT,)) or name == "main":
        return None
    qualified = "::".join([*namespace, name])
    other = first.setdefault(qualified, pair)
    return None if other == pair else f"{qualified} is defined in {other} already"


def name_problems(tree):
    """Names stand in the namespace of their folder, and no two pairs of .h and .cc define the same."""
    first = {}
    for path in sorted(path for folder in ("src", "tests", "benchmarks")
                       for path in (tree / folder).rglob("*") if path.suffix in {".cc", ".h"}):
        name = path.relative_to(tree).as_posix()
        for what, namespace, defined, line in defined_names.read(path.read_text(encoding="utf-8")):
            problem = None
            if what == "definition":
                problem = definition_problem(defined, namespace, name.rsplit(".", 1)[0], first)
            elif name.startswith("src/"):
                problem = namespace_problem(name.removeprefix("src/"), namespace, what == "forwards")
            if problem:
                yield f"{name}:{line}: {problem}"


def suite_of(stem):
    return "".join(word[:1].upper() + word[1:] for word in stem.split("_"))


def suite_problems(tree):
    """The tests of my_words.cc are found by suites named MyWords..., see tests/CMakeLists.txt."""
    for path in sorted((tree / "tests").rglob("*.cc")):
        own = suite_of(path.stem)
        longer = tuple(name for other in path.parent.glob("*.cc")
                       if (name := suite_of(other.stem)).startswith(own) and name != own)
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            test = TEST.match(line)
            if test and (not test[1].startswith(own) or test[1].startswith(longer)):
                yield (f"{path.relative_to(tree).as_posix()}:{number}: the name of the suite "
                       f"{test[1]} does not begin with the words of the file, {own}")


def built_problems(tree):
    """A source of tests that its folder's CMakeLists.txt does not name would never run."""
    for path in sorted((tree / "tests").rglob("*.cc")):
        listing = path.parent / "CMakeLists.txt"
        listed = listing.read_text(encoding="utf-8").split() if listing.is_file() else []
        names = {name.strip("()") for name in listed}
        if re.search(TEST.pattern, path.read_text(encoding="utf-8")) and path.name not in names:
            yield f"{path.relative_to(tree).as_posix()}:1: no test program has this source"


def problems(tree):
    return [*source_problems(tree), *name_problems(tree), *text_problems(tree),
            *suite_problems(tree), *built_problems(tree)]


SOUND_TREE = {
    "src/common/error.h": "#include <string>\n",
    "src/common/hdf5_file.cc": "#include <hdf5.h>\n#include <hdf5_hl.h>\n",
    "src/parameters/values.h": '#include "common/error.h"\n',
    "src/structure/mesh.h": "#include <deal.II/grid/tria.h>\n#include <petscmat.h>\n",
    "src/modes/solver.cc": '#include "structure/mesh.h"\n#include <slepceps.h>\n',
    "src/reduction/body.h": '#include "structure/mesh.h"\n#include <fstream>\n',
    "src/contact/laws/penalty.h": '#include "parameters/values.h"\n',
    "src/model/mass.h": "namespace vibroimpact::model {\nclass Mass;\ndouble total(const Mass &);\n}\n",
    "src/model/mass.cc": "namespace vibroimpact::model {\ndouble total(const Mass &) { return 1; }\n"
                         "double total(int mass) { return mass; }\n}\n",
    "src/model/names.h": "// class Mass {};\nnamespace vibroimpact::model {\n"
                         "template <class Mass> struct Sum : Mass {\n  struct Mass {};\n};\n"
                         "struct Gap { double total(int mass) const { return mass; } };\n"
                         "extern double total;\ndouble sum(const Mass &mass);\n}\n"
                         "namespace std {\ntemplate <> struct hash<Mass> {};\n}\n",
    "src/model/names.cc": 'const char *text = "class Mass {};";\nnamespace vibroimpact::model {\n'
                          "namespace {\nclass Mass {};\ndouble total() { return 1; }\n}\n"
                          "Gap::Gap(int total) : total_{total} { struct Mass {}; }\n"
                          "double Gap::total() { return 1; }\nstatic int total(char) { return 1; }\n}\n",
    "src/analyses/mass.h": "namespace vibroimpact::analyses {\nclass Mass {};\n}\n"
                           "namespace boost::serialization {\nclass Mass {};\n}\n",
    "src/contact/forward.h": "namespace vibroimpact::model {\nclass Mass;\nstruct Gap;\n}\n",
    "src/simulation.cc": "namespace vibroimpact::model {\nclass Mass;\n}\n",
    "src/common/log.h": "namespace vibroimpact::log {\nclass Mass {};\n}\n",
    "src/contact/laws.cc": '#include "contact/laws/penalty.h"\n',
    "src/motion/steps/stepper.cc": "#include <petscts.h>\n",
    "src/output/vtu_writer.cc": "#include <deal.II/base/data_out_base.h>\n",
    "src/simulation.h": '#include "output/vtu_writer.cc"\n',
    "src/run_information.cc": "#include <slepcversion.h>\n#include <petscversion.h>\n"
                              '#include "version.h"\n',
    "src/program.cc": '#include "simulation.h"\n#include <deal.II/base/mpi.h>\n',
    "src/program.h": "int run_program(int argc, char **argv);\n",
    "src/main.cc": '#include "program.h"\n',
    "tests/long.cc": "\n" * LONGEST,
    "tests/model/two_words.cc": "TEST(TwoWordsTest, Holds) {}\nTEST_P(TwoWords, Holds) {}\n",
    "tests/model/two_words_more.cc": "TEST(TwoWordsMoreTest, Holds) {}\n",
    "tests/model/CMakeLists.txt": "vibroimpact_test(model\n  SOURCES two_words.cc three.cc\n"
                                  "    two_words_more.cc)\n",
}

# File, what is put into it, and a part of the message that must come of it.
VIOLATIONS = [
    ("src/common/a.h", '#include "parameters/values.h"', "common/ may not include parameters/"),
    ("src/parameters/a.h", '#include "reduction/body.h"', "parameters/ may not include reduction/"),
    ("src/continuation/a.h", '#include "parameters/values.h"',
     "continuation/ may not include parameters/"),
    ("src/structure/a.h", '#include "reduction/body.h"', "structure/ may not include reduction/"),
    ("src/contact/a.h", '#include "motion/steps/stepper.cc"', "contact/ may not include"),
    ("src/analyses/a.h", '  #  include "output/vtu_writer.cc"', "analyses/ may not include"),
    ("src/analyses/a.h", '#include "simulation.h"', "an include names its folder"),
    ("src/analyses/a.h", '#include "a.h"', "an include names its folder"),
    ("src/command_line.cc", '#include "simulation.h"', "command_line may not include"),
    ("src/main.cc", '#include "simulation.h"', "main may not include"),
    ("src/model/a.h", '#include "common/absent.h"', "there is no such file"),
    ("src/model/a.h", '#include "helpers/a.h"', "helpers/ is not in the order"),
    ("src/helpers/a.h", '#include "common/error.h"', "helpers/ is not in the order"),
    ("src/output/a.cc", '#include "structure/mesh.h"', "no finite element left"),
    ("src/motion/a.cc", '#include "contact/laws/penalty.h"', "which law it holds"),
    ("src/modes/a.cc", "#include <deal.II/lac/vector.h>", "deal.II belongs"),
    ("src/output/a.cc", "#include <deal.II/base/point.h>", "deal.II's base belongs"),
    ("src/program.cc", "#include <deal.II/grid/tria.h>", "deal.II belongs"),
    ("src/structure/a.cc", "#include <slepceps.h>", "SLEPc belongs"),
    ("src/run_information.cc", "#include <slepceps.h>", "SLEPc belongs"),
    ("src/simulation.cc", "#include <slepcversion.h>", "SLEPc belongs"),
    ("src/analyses/a.cc", "#include <nlopt.h>", "NLopt belongs"),
    ("src/modes/a.cc", "#include <petscts.h>", "PETSc TS belongs"),
    ("src/contact/a.cc", "#include <petscvec.h>", "PETSc belongs"),
    ("src/run_information.cc", "#include <petscsys.h>", "PETSc belongs"),
    ("src/output/a.cc", "#include <hdf5.h>", "HDF5 is used through"),
    ("src/output/a.cc", "#include <H5Ppublic.h>", "HDF5 is used through"),
    ("src/analyses/a.cc", "#include <fstream>", "write no files"),
    ("src/model/a.cc", "// T" + "ODO: later", "left to do"),
    ("tests/a.py", "# F" + "IXME", "left to do"),
    ("tests/a.cc", "\n" * LONGEST + "one more", "more than 450"),
    ("src/analyses/z.h", "namespace vibroimpact::analyses {\nstruct Mass final : B<int> {\n};\n}",
     "vibroimpact::analyses::Mass is defined in src/analyses/mass already"),
    ("src/analyses/z.cc", "namespace vibroimpact::analyses {\nusing Mass = double;\n}",
     "vibroimpact::analyses::Mass is defined in src/analyses/mass already"),
    ("src/analyses/z.cc", "namespace vibroimpact::analyses {\nint f(int a) { return a; }\n"
     "enum class Mass : int { one };\n}",
     "vibroimpact::analyses::Mass is defined in src/analyses/mass already"),
    ("tests/model/z.h", "namespace vibroimpact::log {\ntemplate <class A> class Mass {};\n}",
     "vibroimpact::log::Mass is defined in src/common/log already"),
    ("tests/model/three.cc", "TEST(FourTest, Holds) {}", "FourTest does not begin with the words"),
    ("tests/model/two_words.cc", "TEST(TwoWordsMoreTest, Holds) {}", "does not begin with the"),
    ("tests/model/four.cc", "TEST(FourTest, Holds) {}", "no test program has this source"),
    ("src/model/a.h", "namespace vibroimpact {\nclass A;\n}", "is opened, not vibroimpact::model"),
    ("src/model/a.h", "namespace vibroimpact::contact {\nclass A;\n}", "not vibroimpact::model"),
    ("src/contact/laws/a.h", "namespace vibroimpact::laws {\nint a();\n}", "not vibroimpact::contact"),
    ("src/model/a.h", "namespace vibroimpact::model::contact {\nclass A;\n}", "not vibroimpact::model"),
    ("src/contact/a.h", "namespace vibroimpact::model {\nclass Mass {};\n}", "not vibroimpact::contact"),
    ("src/contact/a.h", "namespace vibroimpact::output {\nclass A;\n}", "not vibroimpact::contact"),
    ("src/common/a.h", "namespace vibroimpact::model {\nclass A;\n}", "not vibroimpact"),
    ("src/main.cc", "namespace vibroimpact::model {\nint a() { return 1; }\n}", "not vibroimpact"),
    ("src/model/z.cc", "namespace vibroimpact::model {\nint total() { return 1; }\n}",
     "vibroimpact::model::total is defined in src/model/mass already"),
    ("src/model/z.cc", "namespace vibroimpact::model {\ntemplate <class T> T total(T t) {\n"
     "  return t;\n}\n}", "vibroimpact::model::total is defined in src/model/mass already"),
    ("src/model/z.cc", "namespace vibroimpact::model {\nconst double total = 1;\n}",
     "vibroimpact::model::total is defined in src/model/mass already"),
]


def problems_of(files):
    with tempfile.TemporaryDirectory() as folder:
        tree = pathlib.Path(folder)
        for name, text in files.items():
            (tree / name).parent.mkdir(parents=True, exist_ok=True)
            (tree / name).write_text(text + "\n" * (not text.endswith("\n")), encoding="utf-8")
        return problems(tree)


def self_test():
    failures = [f"sound tree: {problem}" for problem in problems_of(SOUND_TREE)]
    for name, text, expected in VIOLATIONS:
        found = problems_of({**SOUND_TREE, name: text})
        if len(found) != 1 or not found[0].startswith(name + ":") or expected not in found[0]:
            failures.append(f"{name} with {text.strip()!r}: expected {expected!r}, found {found}")
    return failures


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    if sys.argv[1] == "--self-test":
        found = self_test()
        checked = f"{len(VIOLATIONS)} violations are found"
    else:
        found = problems(pathlib.Path(sys.argv[1]))
        checked = "no violation"
    print("\n".join(found) or checked)
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Plants small mistakes in a copy of the sources, one at a time, and looks whether the tests notice.

    scripts/plant-mistakes.py WORK [--number 100] [--seed 1] [--folders contact,model]
    scripts/plant-mistakes.py WORK --list scripts/known-mistakes.txt

A mistake is one small change of the code: an operator, a sign, a factor, a condition, a bound, a
statement left out. Places are drawn by lines of code, so that folders count by their size. Each
mistake is compiled in WORK/tree and WORK/build; then the tests of its folder run, and those of the
folders after it, until one fails or takes three times as long as without a mistake.

WORK/results.tsv gets a line for each: noticed, survived, or not compiled; the survivors stand as
patches in WORK/survivors. The same command goes on where it was stopped. The copy is made when WORK
is new, so that all its results belong to the same sources. Hours for a hundred mistakes.

A list has blocks of `@ FILE`, lines of old text behind `- ` and of new text behind `+ `, divided by
empty lines; lines from # on are comments. The old text must stand in the file once.
"""

import argparse
import collections
import difflib
import json
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
# What needs hours, says nothing of the code, or repeats on several ranks what one has done.
LEFT_OUT = r"^architecture|\.ranks\d|^simulation\.runs$|^output\.check_plots$"

Mistake = collections.namedtuple("Mistake", "file line kind start end new")


sys.path.insert(0, str(ROOT / "tests" / "architecture"))
from check_sources import ORDER as FOLDERS  # noqa: E402

ORDER = [*FOLDERS, "simulation"]


# ---- places ------------------------------------------------------------------------------------

HIDDEN = re.compile(r"""//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])'|^[ \t]*\#[^\n]*"""
                    r"""|\b(?:throw|static_assert|using|template)\b[^;{]*""",
                    re.DOTALL | re.MULTILINE)


def code_of(text):
    """The text with comments, strings, includes and messages blanked out, of the same length."""
    blank = lambda match: re.sub(r"[^\n]", '"' if match[0][0] == '"' else " ", match[0])
    return HIDDEN.sub(blank, text)


def pairs(*words):
    return {a: b for one, other in words for a, b in ((one, other), (other, one))}


OPERATORS = pairs((" + ", " - "), (" * ", " / "), (" += ", " -= "), (" && ", " || "),
                  (" < ", " <= "), (" > ", " >= "), (" == ", " != "), (" *= ", " /= "))
WORDS = pairs(("min", "max"), ("minCoeff", "maxCoeff"), ("cwiseMin", "cwiseMax"),
              ("min_element", "max_element"), ("sin", "cos"), ("sinh", "cosh"), ("head", "tail"),
              ("front", "back"), ("true", "false"), ("start", "end"), ("start_", "end_"),
              ("first", "last"), ("before", "after"), ("previous", "next"), ("lower", "upper"),
              ("topRows", "bottomRows"), ("start_state", "end_state"), ("begins_with", "ends_with"),
              ("floor", "ceil"), ("displacement", "velocity"), ("value", "rate"),
              ("gap", "gap_rate"), ("any_of", "all_of"), ("real", "imag"))
NUMBER = re.compile(r"(?<![\w.])(\d+\.?\d*(?:e[-+]?\d+)?)(?![\w.>])")
STATEMENT = re.compile(r"^\s+(?!return|throw|break|continue|case|using|else|delete|goto)"
                       r"[\w.:>\-\[\]()]*\w[\w.:>\-\[\]()]*(?: [-+*/]?= [^;{}]*|\([^;{}]*\));$")
CONDITION = re.compile(r"\b(?:if|while) \(")
SIGN = re.compile(r"(?:(?<=[(=,] )|(?<=return )|(?<=[(\[]))-(?=[\w(])")


def other_number(text):
    if "." in text or "e" in text:
        return "1.0" if text == "0.5" else f"(2 * {text})"
    return str(int(text) + 1)


def closing(line, opening):
    depth = 0
    for place in range(opening, len(line)):
        depth += {"(": 1, ")": -1}.get(line[place], 0)
        if depth == 0:
            return place
    return None


def in_line(code, line, words):
    """(kind, start, end, new text) of every mistake that a line allows; `words`: of the file."""
    for old, new in OPERATORS.items():
        if '"' in code and old == " + ":  # a message
            continue
        for match in re.finditer(re.escape(old), code):
            yield old.strip() + " to " + new.strip(), match.start(), match.end(), new
    for match in re.finditer(r"\b\w+\b", code):
        if WORDS.get(match[0]) in words:
            yield match[0] + " to " + WORDS[match[0]], *match.span(), WORDS[match[0]]
    for match in NUMBER.finditer(code):
        yield "number", *match.span(), other_number(match[0])
    for match in SIGN.finditer(code):
        yield "sign", *match.span(), ""
    for match in re.finditer(r"(?<=[ (])!(?=[\w(])", code):
        yield "negation", *match.span(), ""
    for match in re.finditer(r"std::abs(?=\()", code):
        yield "no abs", *match.span(), ""
    for match in CONDITION.finditer(code):
        end = closing(code, match.end() - 1)
        if end and ";" not in code[match.end():end]:
            yield "condition", match.end(), end, "!(" + line[match.end():end] + ")"
    if STATEMENT.match(code) and '"' not in code and ".reserve(" not in code:
        yield "left out", len(code) - len(code.lstrip()), len(code), ";"


def folder_of(file):
    parts = pathlib.PurePosixPath(file).parts
    return parts[1] if len(parts) > 2 else "simulation"


def places(tree, file):
    """For each line of code with at least one possible mistake: the list of them."""
    text = (tree / file).read_text(encoding="utf-8")
    found = []
    offset = 0
    code = code_of(text)
    words = set(re.findall(r"\w+", code)) | {"min", "max", "sin", "cos"}
    for number, (line, bare) in enumerate(zip(text.splitlines(), code.splitlines()), 1):
        mistakes = [Mistake(file, number, kind, offset + start, offset + end, new)
                    for kind, start, end, new in in_line(bare, line, words)]
        if mistakes:
            found.append(mistakes)
        offset += len(line) + 1
    return found


def drawn(tree, options):
    files = sorted(path.relative_to(tree).as_posix() for path in (tree / "src").rglob("*")
                   if path.suffix == ".cc" or (path.suffix == ".h" and options.headers))
    wanted = options.folders.split(",") if options.folders else ORDER
    lines = [line for file in files if folder_of(file) in wanted for line in places(tree, file)]
    chance = random.Random(options.seed)
    chance.shuffle(lines)
    return [chance.choice(line) for line in lines[:options.number]]


def listed(tree, file):
    """The mistakes of a list; one that fits the sources no longer has no place."""
    mistakes = []
    for block in re.split(r"\n\s*\n", file.read_text(encoding="utf-8")):
        lines = [line for line in block.splitlines() if line and not line.startswith("#")]
        if not lines:
            continue
        part = lambda mark: "\n".join(line[2:] for line in lines if line.startswith(mark))
        source, old, new = part("@"), part("-"), part("+")
        text = (tree / source).read_text(encoding="utf-8") if (tree / source).is_file() else ""
        start = text.find(old) if text.count(old) == 1 else -1
        line = text.count("\n", 0, start) + 1 if start >= 0 else 0
        mistakes.append(Mistake(source, line, "listed", start, start + len(old), new))
    return mistakes


# ---- the copy, its build and its tests ---------------------------------------------------------

class Copy:
    def __init__(self, work, jobs):
        self.tree, self.build = work / "tree", work / "build"
        self.pristine = work / "sources"
        self.jobs = jobs
        if not self.pristine.is_dir():
            self.take()
        self.restore()

    def take(self):
        files = subprocess.run(["git", "-C", ROOT, "ls-files", "-z"], check=True,
                               capture_output=True, text=True).stdout.split("\0")
        for file in filter(None, files):
            (self.tree / file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / file, self.tree / file)
        shutil.copytree(self.tree / "src", self.pristine)

    def restore(self):
        for path in self.pristine.rglob("*.*"):
            here = self.tree / "src" / path.relative_to(self.pristine)
            if here.read_bytes() != path.read_bytes():
                shutil.copyfile(path, here)  # with the time of now: it must be compiled again

    def configure(self):
        if (self.build / "CMakeCache.txt").is_file():
            return
        subprocess.run(["cmake", "-S", self.tree, "-B", self.build, "-G", "Ninja",
                        "-D", "CMAKE_BUILD_TYPE=Release", "-D", "VIBROIMPACT_BUILD_TESTS=ON",
                        "-D", "CMAKE_CXX_COMPILER_LAUNCHER=" + (shutil.which("ccache") or "")],
                       check=True, stdout=subprocess.DEVNULL)

    def compile(self, *targets):
        """False when that fails."""
        command = ["ninja", "-C", str(self.build), f"-j{self.jobs}", *targets]
        return subprocess.run(command, capture_output=True, check=False).returncode == 0

    def plant(self, mistake):
        """Returns the text with the mistake, as a patch."""
        path = self.tree / mistake.file
        before = path.read_text(encoding="utf-8")
        after = before[:mistake.start] + mistake.new + before[mistake.end:]
        path.write_text(after, encoding="utf-8")
        return "".join(difflib.unified_diff(
            before.splitlines(keepends=True), after.splitlines(keepends=True),
            "a/" + mistake.file, "b/" + mistake.file, n=2))


class Entry:
    """An entry of ctest."""

    def __init__(self, description):
        self.name, self.command = description["name"], description["command"]
        properties = {p["name"]: p["value"] for p in description.get("properties", [])}
        self.environment = dict(pair.split("=", 1) for pair in properties.get("ENVIRONMENT", []))
        self.folder = pathlib.Path(properties["WORKING_DIRECTORY"]).name
        self.directory = properties["WORKING_DIRECTORY"]
        self.labels = properties.get("LABELS", [])
        self.reads_another = bool(properties.get("FIXTURES_REQUIRED"))
        self.usual = 0.0

    def run(self, limit):
        """"passes", "fails" or "hangs", and the seconds."""
        start = time.monotonic()
        process = subprocess.Popen(self.command, cwd=self.directory, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                   env={**os.environ, **self.environment}, start_new_session=True)
        try:
            state = "passes" if process.wait(limit) == 0 else "fails"
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
            state = "hangs"
        return state, time.monotonic() - start


def entries(copy, left_out):
    shown = subprocess.run(["ctest", "--test-dir", copy.build, "--show-only=json-v1"], check=True,
                           capture_output=True, text=True).stdout
    found = [Entry(test) for test in json.loads(shown)["tests"]
             if "command" in test and not re.search(left_out, test["name"])]
    return [entry for entry in found if entry.folder in ORDER and not {"verification", "slow"} & set(entry.labels)]


def measure(tests, file):
    """The usual time of each test; those that fail as it is are no witnesses."""
    known = json.loads(file.read_text()) if file.is_file() else {}
    for entry in tests:
        if entry.name not in known:
            state, seconds = entry.run(1200)
            known[entry.name] = seconds if state == "passes" else None
            file.write_text(json.dumps(known, indent=1))
        if known[entry.name] is None:
            print(f"{entry.name} fails without a mistake and is left out", file=sys.stderr)
    sound = [entry for entry in tests if known[entry.name] is not None]
    for entry in sound:
        entry.usual = known[entry.name]
    return sound


def witnesses(tests, folder):
    """The quick ones first within a folder, but those that read what another one writes last."""
    first = ORDER.index(folder)
    later = [entry for entry in tests if ORDER.index(entry.folder) >= first]
    return sorted(later, key=lambda entry: (ORDER.index(entry.folder), entry.reads_another,
                                            entry.usual))


def judged(copy, mistake, tests):
    """(state, the test that noticed it)"""
    everything = mistake.file.endswith(".h")
    if not copy.compile(*([] if everything else ["vibroimpact", "vibroimpact_program"])):
        return "not compiled", ""
    for entry in witnesses(tests, folder_of(mistake.file)):
        state, _ = entry.run(3 * entry.usual + 20)
        if state != "passes":
            return "noticed", entry.name + (" (no end)" if state == "hangs" else "")
    return "survived", ""


# ---- results -----------------------------------------------------------------------------------

def key_of(mistake):
    return f"{mistake.file}:{mistake.line}\t{mistake.kind}\t{mistake.start}\t{mistake.new!r}"


def done(results):
    if not results.is_file():
        return set()
    return {line.split("\t", 2)[2] for line in results.read_text().splitlines()}


def keep(work, number, mistake, state, witness, patch):
    if state == "survived":
        folder = work / "survivors"
        folder.mkdir(exist_ok=True)
        name = f"{number:04d}-{mistake.file.replace('/', '-')}-{mistake.line}.patch"
        (folder / name).write_text(patch)
    with (work / "results.tsv").open("a") as file:
        file.write(f"{state}\t{witness}\t{key_of(mistake)}\n")
    print(f"{number:4d} {state:12s} {mistake.file}:{mistake.line} {mistake.kind}  {witness}",
          flush=True)


def table(results):
    counts = collections.defaultdict(collections.Counter)
    for line in results.read_text().splitlines():
        state, _, place = line.split("\t")[:3]
        counts[folder_of(place.split(":")[0])][state] += 1
    print(f"\n{'folder':14s} noticed  survived  not compiled")
    total = collections.Counter()
    for folder in [folder for folder in ORDER if folder in counts]:
        total += counts[folder]
        print(f"{folder:14s} {counts[folder]['noticed']:7d} {counts[folder]['survived']:9d} "
              f"{counts[folder]['not compiled']:13d}")
    judged_ones = total["noticed"] + total["survived"]
    print(f"{'all':14s} {total['noticed']:7d} {total['survived']:9d} {total['not compiled']:13d}   "
          f"{100 * total['noticed'] / max(judged_ones, 1):.0f} % noticed")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("--number", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--folders", help="only these, separated by commas")
    parser.add_argument("--list", type=pathlib.Path, help="plant the mistakes of this file")
    parser.add_argument("--headers", action="store_true",
                        help="in headers too, each of which compiles much of the tree again")
    parser.add_argument("--leave-out", default=LEFT_OUT, help="entries of ctest, as an expression")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    work = options.work.resolve()
    work.mkdir(parents=True, exist_ok=True)
    copy = Copy(work, options.jobs)
    copy.configure()
    if not copy.compile():
        sys.exit("the sources as they are do not compile")
    tests = measure(entries(copy, options.leave_out), work / "usual-times.json")
    mistakes = listed(copy.tree, options.list) if options.list else drawn(copy.tree, options)
    known = done(work / "results.tsv")
    for number, mistake in enumerate(mistakes, 1):
        if key_of(mistake) in known:
            continue
        if mistake.start < 0:
            print(f"{number:4d} has no place    {mistake.file}: {mistake.new.strip()}")
            continue
        patch = copy.plant(mistake)
        state, witness = judged(copy, mistake, tests)
        keep(work, number, mistake, state, witness, patch)
        copy.restore()
    copy.compile()
    table(work / "results.tsv")


if __name__ == "__main__":
    main()

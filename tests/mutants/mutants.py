"""Spoils parameter files, meshes and records as careless users and broken disks do: a few random
changes of lines, values, numbers and words, the same for the same seed.
"""
import dataclasses
import pathlib
import random
import re

NUMBERS = ["0", "-1", "-0.0", "nan", "inf", "1e308", "-1e308", "1e300", "1e-300", "1e-320", "1e15",
           "1e9", "1000000", "2147483648", "3000000000", "18446744073709551616", "1/0", "0.5", "1e-6"]
VALUES = NUMBERS + ["", "abc", "1 m", "5 kg", "3 Hz", "2 s", "90 deg", "0, 0, 0", "1, 2, 3, 4", ",",
                    "none", "all", "true", "((((", "1 +", "(" * 3000, "-" * 3000, "1+" * 8000 + "1",
                    "x" * 20000, "1 m\0", "\0", "\xff\xfe", "%s%n", "/dev/zero", "/", "..", "a = b",
                    "stop, stop", "µm", "1e9 m", "1e-9 s", "1e15 s", "1 1", "sqrt(-1)", "1 \\", "\"",
                    "0, 0, 0 -> 0, 0, 0", "1 m -> 1 m"]
UNITS = ["m", "mm", "kg", "s", "N", "N/m", "Hz", "rad/s", "GPa", "deg", "kg/m^3", "m/s^2", "furlong"]
NUMBER = re.compile(r"(?<![\w.])[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?")
WORD = re.compile(r"[A-Za-z_][\w.-]*")


@dataclasses.dataclass
class Mutant:
    name: str                # of the parameter file
    files: dict              # path below the folder of a mutant: bytes
    changes: list            # in words


def replaced(text, match, new):
    return text[:match.start()] + new + text[match.end():]


class Spoiler:
    """Changes one list of lines in place; every method says in words what it did."""

    def __init__(self, lines, choose):
        self.lines, self.choose = lines, choose

    def some_line(self, wanted=lambda line: line.strip() and not line.lstrip().startswith("#")):
        places = [place for place, line in enumerate(self.lines) if wanted(line)]
        return self.choose.choice(places) if places else None

    def change(self, place, new):
        self.lines[place] = new
        return f"line {place + 1}: {new.strip()[:60]!r}"

    def value(self):
        place = self.some_line(lambda line: re.match(r"\s*set .*=", line))
        return place is not None and self.change(
            place, self.lines[place].split("=", 1)[0] + "= " + self.choose.choice(VALUES))

    def part(self, pattern, new, wanted=lambda line: True):
        place = self.some_line(lambda line: wanted(line) and pattern.search(line.split("#")[0]))
        if place is None:
            return False
        line = self.lines[place]
        return self.change(place, replaced(line, self.choose.choice(
            list(pattern.finditer(line.split("#")[0]))), new))

    def number(self):
        return self.part(NUMBER, self.choose.choice(NUMBERS))

    def nudged_number(self):
        return self.part(NUMBER, str(self.choose.choice([1, 2, 3, 7, 100, -5, 1e-3, 12345678])))

    def unit(self):
        return self.part(re.compile(r"(?<=\d )[A-Za-z/^0-9]+"), self.choose.choice(UNITS))

    def word(self):
        words = sorted(set(WORD.findall(" ".join(line.split("#")[0] for line in self.lines))))
        return bool(words) and self.part(WORD, self.choose.choice(words))

    def letter(self):
        return self.part(re.compile(r"\S"), self.choose.choice("aZ0-/#=\\,.(\0\x80"))

    def deleted(self):
        place = self.some_line()
        return place is not None and f"line {place + 1} deleted: {self.lines.pop(place).strip()[:60]!r}"

    def doubled(self):
        place = self.some_line()
        if place is None:
            return False
        self.lines.insert(place, self.lines[place])
        return f"line {place + 1} doubled: {self.lines[place].strip()[:60]!r}"

    def swapped(self):
        one, other = self.some_line(), self.some_line()
        if one is None:
            return False
        self.lines[one], self.lines[other] = self.lines[other], self.lines[one]
        return f"lines {one + 1} and {other + 1} swapped"

    def cut(self):
        first = self.choose.randrange(len(self.lines) + 1)
        length = self.choose.choice([2, 5, 20, len(self.lines)])
        del self.lines[first:first + length]
        return f"{length} lines cut from line {first + 1}"

    def count(self):
        """The number of nodes or elements of a mesh."""
        heads = [i for i, line in enumerate(self.lines[:-1]) if re.match(r"\$(Nodes|Elements)", line)]
        if not heads:
            return False
        place = self.choose.choice(heads) + 1
        return self.change(place, " ".join(
            self.choose.choice(NUMBERS + ["1", "5"]) if self.choose.random() < 0.5 else number
            for number in self.lines[place].split()))


PARAMETERS = [(6, "value"), (4, "number"), (2, "nudged_number"), (2, "unit"), (3, "word"), (1, "letter"),
              (3, "deleted"), (2, "doubled"), (1, "swapped"), (1, "cut")]
# More of these can still be run.
GENTLE = [(2, "value"), (2, "number"), (8, "nudged_number"), (1, "unit"), (2, "word"), (3, "deleted"),
          (1, "swapped")]
DATA = [(3, "number"), (3, "nudged_number"), (3, "count"), (2, "deleted"), (1, "doubled"), (1, "swapped"),
        (2, "cut"), (1, "letter"), (1, "word")]


def spoil(content, kinds, choose):
    lines = content.decode("latin-1").split("\n")
    spoiler, changes = Spoiler(lines, choose), []
    for _ in range(choose.choice([1, 1, 1, 2, 3])):
        kind = choose.choices([name for _, name in kinds], [weight for weight, _ in kinds])[0]
        done = getattr(spoiler, kind)()
        if done:
            changes.append(f"{kind}: {done}")
    return "\n".join(spoiler.lines).encode("latin-1"), changes


def referred_files(content):
    """Meshes, records and included files that a parameter file names, as written."""
    return [name for name in re.findall(rb"(?:set (?:Mesh|File)\s*=|\ninclude) *(\S+)", content)]


def mutant(sources, seed, kinds=tuple(PARAMETERS), change=lambda content: content):
    """One mutant of one of the parameter files, spoilt in some of these ways, or of a mesh or record
    that it names; `change` is applied before."""
    choose = random.Random(seed)
    source = pathlib.Path(choose.choice(sources))
    content = change(source.read_bytes())
    referred = [name.decode() for name in referred_files(content)]
    files = {f"params/{name}": (source.parent / name).read_bytes() for name in referred}
    files[f"params/{source.name}"] = content
    spoilt = f"params/{source.name}"
    if referred and choose.random() < 0.6:
        spoilt = f"params/{choose.choice(referred)}"
    files[spoilt], changes = spoil(files[spoilt], kinds if spoilt.endswith(".prm") else DATA, choose)
    return Mutant(source.name, files, [f"{spoilt}: {what}" for what in changes])

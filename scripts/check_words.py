#!/usr/bin/env python3
"""Words and phrases that the field does not use, in pages and in the texts of the program.

    check_words.py ROOT [PLACE ...]   prints FILE:LINE: words -> what to write; exit code 1 where there are any
    check_words.py --self-test

A PLACE is a pattern of files below ROOT. Of pages the prose counts, without code; of C++ sources the text in quotes,
that is messages and descriptions of keys.
"""

import re
import sys
import tempfile
from pathlib import Path

PLACES = ("README.md", "CONTRIBUTING.md", "docs/*.md", "docs/developer/*.md", "docs/gallery/*.md", "docs/tutorials/*.md",
          "src/**/*.cc", "src/**/*.h")
# A pattern, in which a blank stands for any white space, and what to write instead.
WORDS = (
    (r"strikes? each other|strikes? a stop", "collide, impact"),
    (r"by the matrices of another program", "imported mass and stiffness matrices"),
    (r"giv(?:es?|ing) way", "yields; bumper with internal relaxation"),
    (r"say(?:ing)? anything twice", "without repetition"),
    (r"answers? statically|static answers?", "responds quasi-statically, static response"),
    (r"the mass they lack", "the missing effective mass"),
    (r"modes that matter(?: little)?", "out-of-band modes, the modes needed"),
    (r"(?:a sweep|what it) meets?", "coexisting solutions, contact"),
    (r"how far (?:do|does|it|a|averaging|harmonics)[^.?]{0,60}\bcarr(?:y|ies)", "how accurate"),
    (r"met without rebound", "perfectly plastic impact"),
    (r"dangerous motions?", "undesired attractor"),
    (r"the way there", "convergence history"),
    (r"factor of a deviation|growth of deviations", "growth of a perturbation, Lyapunov exponents"),
    (r"small deviations?|deviations grow", "small perturbations"),
    (r"unbalanced(?! (?:rotor|motor|mass|disc))", "energy balance not closed"),
    (r"thr[oe]ws? (?:the |its )?\w+ apart", "rebound"),
    (r"attenuates to a (?:quarter|half|third)", "reduces by a percentage"),
    (r"comes close to itself", "near a subharmonic resonance"),
    (r"grown together", "band merging"),
    (r"basins? of no size", "vanishing basin"),
    (r"in shares of", "normalised by"),
    (r"public cases", "benchmarks"),
    (r"needs? all the room", "use the full clearance"),
    (r"worked out from its flexibility", "flexibility-based"),
    (r"(?:a|an|the|each|every|this|no|at|behind|over|of) grazes?\b|^grazes?\b", "grazing bifurcation, grazing contact"),
    (r"ends? of the record shows?", "edge effects"),
    (r"frequency of running", "excitation frequency"),
    (r"(?:two|three) motions more", "three solutions"),
    (r"(?<!free[\s-])flights?|aloft|flying", "exact propagation, free flight"),
    (r"(?:take[ns]?|took) off", "subtract, separate"),
    (r"(?:un)?watch(?:ed|ers?|es|ing)?", "observe, monitor"),
    (r"ledgers?", "energy balance"),
    (r"pieces?", "segment, part"),
    (r"such a stretch|step courses?", "interval, time transformation"),
    (r"first fall|(?:falls?|fallen|falling) (?:through|to|below) zero", "down-crossing"),
    (r"undecided", "indeterminate (within round-off)"),
    (r"relaxing stops?|piecewise stops?", "Kelvin-Voigt bumper with internal state, bilinear stop"),
    (r"excursions?", "extreme values, peak-to-peak"),
    (r"tells?|told|deals?(?!\.II)|dealt", "report, distribute"),
    (r"(?:gives?|given|gave) up", "abandon"),
    (r"knocks?|creeps?|sound motions?|comes? to nothing", "a plain technical sentence"),
    (r"meetings?|company|wishes", "contact candidate, observer"),
)
PATTERNS = [(re.compile(r"\b(?:" + words.replace(" ", r"\s+") + r")\b", re.IGNORECASE | re.MULTILINE), better)
            for words, better in WORDS]
CODE = re.compile(r"(?ms)^```.*?^```$|`[^`\n]*`|\]\([^)\s]*\)|<!--.*?-->")
TEXT = re.compile(r'"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*')
NAME = re.compile(r'"[^" ]*"')  # of a file or a field


def blank(text):
    return re.sub(r"[^\n]", "\0", text)


def prose(page):
    return CODE.sub(lambda match: blank(match.group()), page)


def quoted(source):
    """The texts in quotes, each in its place; parts of one text are joined."""
    text, last = [], 0
    for match in TEXT.finditer(source):
        found = match.group()
        text += [blank(source[last:match.start()]),
                 blank(found) if NAME.fullmatch(found) else found.replace('"', " ")]
        last = match.end()
    return "".join(text) + blank(source[last:])


def hits(text):
    for pattern, better in PATTERNS:
        for match in pattern.finditer(text):
            yield text.count("\n", 0, match.start()) + 1, " ".join(match.group().split()), better


def violations(root, places):
    for file in sorted({file for place in places for file in root.glob(place)}):
        text = file.read_text(encoding="utf-8")
        text = prose(text) if file.suffix == ".md" else quoted(text)
        for line, words, better in sorted(hits(text)):
            yield f"{file.relative_to(root)}:{line}: {words} -> {better}"


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        (root / "README.md").write_text("Bodies strike\neach other.\n`unbalanced` and\nunbalanced rotors\n")
        (root / "a.cc").write_text('int flight;\nf("the contact gives "\n  "way");\n')
        found = list(violations(root, ("*.md", "*.cc")))
    wanted = ["README.md:1: strike each other", "a.cc:2: gives way"]
    good = [line.split(" -> ")[0] for line in found] == wanted
    print(f"{len(found)} phrases are found" if good else f"self-test: {found}")
    return 0 if good else 1


def main():
    if sys.argv[1] == "--self-test":
        return self_test()
    found = list(violations(Path(sys.argv[1]).resolve(), sys.argv[2:] or PLACES))
    print("\n".join(found) or "no phrase of the list")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

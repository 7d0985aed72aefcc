"""The sources that the pages name: check_citations.py SOURCE, or --self-test.

Every key in brackets stands in docs/references.bib, and every entry there is named in a page, an example or
the code, by its key or by author and year.
"""
import pathlib
import re
import sys
import tempfile

KEY = re.compile(r"\b[a-z][a-z-]*(?:19|20)\d\d[a-z]*\b")
PLACES = ("*.md", "docs/**/*.md", "params/**/*.prm", "src/**/*.h", "src/**/*.cc", "tests/**/*.py",
          "tests/**/*.cc", "benchmarks/*.cc")


def entries(source):
    text = (source / "docs" / "references.bib").read_text(encoding="utf-8")
    return set(re.findall(r"(?m)^@\w+\{(\S+),", text))


def unknown_sources(page, known):
    text = re.sub(r"(?ms)^```.*?^```$|`[^`\n]*`", "", page.read_text(encoding="utf-8"))
    for brackets in re.findall(r"\[([^\[\]]*)\](?!\()", text):
        for key in KEY.findall(brackets):
            if key not in known:
                yield f"{page.name}: {key} is not in references.bib"


def is_named(key, text):
    """As `key`, or as author and year, which comments may divide into two lines."""
    author, year = re.fullmatch(r"(.*?)(\d{4})?[a-z]*", key).groups()
    return key in text or bool(
        year and re.search(rf"{author}[\s/,]+(?:and \w+ )?{year}", text, re.IGNORECASE))


def violations(source):
    known = entries(source)
    pages = sorted(source.glob("docs/**/*.md"))
    text = "\n".join(file.read_text(encoding="utf-8", errors="replace")
                     for place in PLACES for file in source.glob(place))
    return ([line for page in pages for line in unknown_sources(page, known)]
            + [f"references.bib: nothing names {key}" for key in sorted(known)
               if not is_named(key, text)])


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder)
        (source / "docs").mkdir()
        (source / "docs" / "references.bib").write_text(
            "".join(f"@book{{{key},\n}}\n" for key in ("good2001", "idle2002", "spoken2004")))
        (source / "docs" / "page.md").write_text(
            "[good2001; for it bad2003] `[code2005]`\nand Spoken\n// 2004\n```\n[block2006]\n```\n")
        found = violations(source)
    good = found == ["page.md: bad2003 is not in references.bib", "references.bib: nothing names idle2002"]
    print(f"{len(found)} violations are found" if good else f"self-test: {found}")
    return good


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        sys.exit(0 if self_test() else 1)
    FOUND = violations(pathlib.Path(sys.argv[1]))
    print("\n".join(FOUND) or "no violation")
    sys.exit(1 if FOUND else 0)

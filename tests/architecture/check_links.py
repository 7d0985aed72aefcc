#!/usr/bin/env python3
"""Links and pictures of the pages lead somewhere: check_links.py ROOT, or check_links.py --self-test"""

import re
import sys
import tempfile
from pathlib import Path

LINK = re.compile(r"\]\(([^()\s]*[./#][^()\s]*)\)")  # formulas have brackets too
CODE = re.compile(r"(?ms)^```.*?^```$|`[^`\n]*`")


def anchors(page: Path) -> set[str]:
    """As GitHub makes them of headings; the second of the same name ends in -1."""
    found: dict[str, int] = {}
    names = set()
    text = re.sub(r"(?ms)^```.*?^```$", "", page.read_text(encoding="utf-8"))
    for heading in re.findall(r"(?m)^#+ (.*)$", text):
        name = re.sub(r"[^\w -]", "", heading.strip().lower()).replace(" ", "-")
        names.add(name if name not in found else f"{name}-{found[name]}")
        found[name] = found.get(name, 0) + 1
    return names


def dead_links(root: Path) -> list[str]:
    dead = []
    for page in [*root.glob("*.md"), *root.glob("docs/**/*.md")]:
        for link in LINK.findall(CODE.sub("", page.read_text(encoding="utf-8"))):
            if re.match(r"[a-z]+:", link):
                continue
            place, _, anchor = link.partition("#")
            target = page.parent / place if place else page
            if not target.exists() or (anchor and target.suffix == ".md" and anchor not in anchors(target)):
                dead.append(f"{page.relative_to(root)}: {link}")
    return dead


def self_test() -> int:
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        (root / "docs").mkdir()
        (root / "docs" / "a.md").write_text("# One: *two* (3 m)\n\n## Same\n\n## Same\n", encoding="utf-8")
        good = ["docs/a.md", "docs/a.md#one-two-3-m", "docs/a.md#same-1", "#here", "https://example.org/x#y"]
        bad = ["docs/b.md", "docs/a.md#same-2", "#there"]
        text = "# Here\n\n" + "\n".join(f"[x]({link})" for link in good + bad) + "\n`[x](code.md)`\n"
        (root / "README.md").write_text(text, encoding="utf-8")
        found = dead_links(root)
    wanted = [f"README.md: {link}" for link in bad]
    print(f"found {found}, wanted {wanted}" if found != wanted else f"{len(bad)} dead links are found")
    return 0 if found == wanted else 1


def main() -> int:
    if sys.argv[1] == "--self-test":
        return self_test()
    dead = dead_links(Path(sys.argv[1]).resolve())
    print("\n".join(dead) or "no dead link")
    return 1 if dead else 0


if __name__ == "__main__":
    sys.exit(main())

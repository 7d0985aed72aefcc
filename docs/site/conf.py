"""The pages as a site; scripts/build-site.sh runs this."""
import re
import sys
from pathlib import Path

from pygments.lexers.special import TextLexer

sys.path.insert(0, str(Path(__file__).parent))
import sources  # noqa: E402

project = "vibroimpact"
author = copyright = "The vibroimpact developers"  # noqa: A001
root_doc = "README"
include_patterns = ["README.md", "CHANGELOG.md", "CONTRIBUTING.md", "docs/*.md", "docs/developer/*.md",
                    "docs/gallery/*.md", "docs/parameters/*.md", "docs/tutorials/*.md"]
extensions = ["myst_parser", "sphinx.ext.mathjax"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 6
suppress_warnings = ["myst.header"]
highlight_language = "none"

html_theme = "furo"
html_title = "vibroimpact"
html_copy_source = False
# Equations are set by KaTeX, which is copied beside the pages: no network is needed to read them.
html_static_path = ["/usr/share/javascript/katex", "static"]
html_css_files = ["katex.min.css", "site.css"]
html_js_files = [("katex.min.js", {"defer": "defer", "priority": 100}),
                 ("contrib/auto-render.js", {"defer": "defer", "priority": 200})]
mathjax_path = "equations.js"
mathjax_options = {"defer": "defer"}

WORKS = sources.entries()
ROOT = Path(__file__).resolve().parents[2]
LINK = re.compile(r"\]\(([\w./-]+\.md)\)")
FOLDER = re.compile(r"\[([^\]]+)\]\((?:published|tables)\)")  # links to these have no page
FOLDERS = {"docs/gallery/README": "Gallery", "docs/parameters/README": "Parameters"}


def page(link):
    """The name of a page that docs/README.md links to."""
    return (ROOT / "docs" / link).resolve().relative_to(ROOT).with_suffix("").as_posix()


def toctree(caption, pages):
    return "\n".join(["", "```{toctree}", ":hidden:", f":caption: {caption}", "", *pages, "```", ""])


def contents():
    """The lists of docs/README.md as trees of the side bar."""
    parts = re.split(r"(?m)^\*\*(.+)\*\*$", (ROOT / "docs" / "README.md").read_text(encoding="utf-8"))
    for caption, text in zip(parts[1::2], parts[2::2]):
        yield toctree(caption, [page(link) for link in LINK.findall(text)])


def add_contents(app, name, source):
    source[0] = sources.linked(FOLDER.sub(r"\1", source[0]), WORKS)
    if name == "docs/references":
        source[0] += sources.listed(WORKS)
    if name == root_doc:
        source[0] += "".join(contents())
    elif name in FOLDERS:
        pages = sorted(file.stem for file in (ROOT / name).parent.glob("*.md") if file.stem != "README")
        source[0] += toctree(FOLDERS[name], pages)
    elif name == "docs/README":
        source[0] = "---\norphan: true\n---\n" + source[0]


def setup(app):
    for language in ("prm", "message"):
        app.add_lexer(language, TextLexer)
    app.connect("source-read", add_contents)

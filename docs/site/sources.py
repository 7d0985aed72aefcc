"""The works of docs/references.bib, as a list in the site and as targets of what stands in brackets."""
import re
import unicodedata
from pathlib import Path

BIB = Path(__file__).resolve().parents[1] / "references.bib"
ENTRY = re.compile(r"(?ms)^@(\w+)\{(\S+),\n(.*?)^\}")
FIELD = re.compile(r"(?ms)^\s*(\w+)\s*=\s*\{(.*?)\},?\s*$(?=\s*\w+\s*=|\s*\Z)")
ACCENT = {'"': "\u0308", "'": "\u0301", "`": "\u0300", "^": "\u0302", "~": "\u0303", "c": "\u0327", "v": "\u030c",
          "=": "\u0304", ".": "\u0307", "H": "\u030b"}
LETTER = re.compile(r"\\([\"'`^~=.]|[cvH](?=[\s{]))\s*\{?\\?([A-Za-z])\}?")
BRACKETS = re.compile(r"```.*?```|`[^`\n]*`|\[([^\[\]\n]*)\](?!\()", re.DOTALL)


def plain(text):
    """LaTeX's accents as letters, without braces."""
    text = LETTER.sub(lambda m: unicodedata.normalize("NFC", m.group(2) + ACCENT[m.group(1)]), text)
    text = text.replace(r"\&", "&").replace("--", "\u2013").replace(r"\o", "\u00f8").replace(r"\l", "\u0142")
    return " ".join(re.sub(r"[{}]", "", text).split())


def entries():
    text = BIB.read_text(encoding="utf-8")
    return {key: {name.lower(): plain(value) for name, value in FIELD.findall(body)}
            for _, key, body in ENTRY.findall(text)}


PLACE = ("journal", "booktitle", "institution", "school", "publisher", "howpublished", "volume", "pages", "note", "year")


def line(key, work):
    authors = work.get("author", "").replace(" and ", ", ")
    title = work.get("title", "").replace("*", r"\*")
    parts = [authors and f"{authors}:", f"*{title}*.", ", ".join(work[name] for name in PLACE if name in work) + ".",
             f"[doi:{work['doi']}](https://doi.org/{work['doi']})" if "doi" in work else ""]
    return f"\n({key})=\n**{key}** " + " ".join(part for part in parts if part.strip(".")) + "\n"


def listed(works):
    return "".join(line(key, works[key]) for key in sorted(works))


def linked(text, works):
    """A page whose works in brackets lead to the list."""
    def link(match):
        if match.group(1) is None:
            return match.group()
        keys = re.sub(r"[a-z][\w-]*", lambda word: f"[{word.group()}]({word.group()})"
                      if word.group() in works else word.group(), match.group(1))
        return match.group() if keys == match.group(1) else f"[{keys}]"
    return BRACKETS.sub(link, text)

"""Finds in a C++ source, without its libraries, which namespaces it opens and what it defines in them.

The text is cut into the statements at namespace scope. What stands before the first brace of a statement
says what it is; what stands inside the braces of a class, function or initialiser is left out.
"""

import re

TOKEN = re.compile(r"""
    (?P<skipped>\s+ | //[^\n]* | /\*.*?\*/ | ^[ \t]*\#(?:[^\n]*\\\n)*[^\n]*)
  | (?P<kept>(?:u8|[uUL])?R"(?P<mark>[^()\\\s]*)\(.*?\)(?P=mark)" | "(?:[^"\\\n]|\\.)*" | '(?:[^'\\\n]|\\.)+'
           | [A-Za-z_]\w* | \.?\d(?:[eEpP][+-]|'(?=\w)|[\w.])* | :: | -> | .)""", re.X | re.S | re.M)
CLOSING = {"(": ")", "[": "]", "{": "}"}
TYPES = {"class", "struct", "union", "enum"}
# Brackets behind these hold no parameters.
NO_FUNCTION = {"alignas", "decltype", "noexcept", "requires", "__attribute__"}
# Linkage of their own, specialisations, and what continues a statement cut at a brace.
NOT_DEFINING = {"static", "extern", "friend", "static_assert", ",", "catch", "try"}
MACRO = re.compile(r"[A-Z][A-Z0-9_]+$")
NAME = re.compile(r"[A-Za-z_]\w*$")


def tokens_of(text):
    """Pairs of a token and its line."""
    line = 1
    for match in TOKEN.finditer(text):
        if match["kept"]:
            yield match["kept"], line
        line += match[0].count("\n")


def end_of_group(tokens, begin):
    """The position behind the bracket that closes the one at `begin`."""
    depth = 0
    for i in range(begin, len(tokens)):
        depth += (tokens[i][0] in CLOSING) - (tokens[i][0] in CLOSING.values())
        if depth == 0:
            return i + 1
    return len(tokens)


def without_angles(head):
    """Without what stands in angle brackets; template parameters with the word before them."""
    kept, depth = [], 0
    for token, line in head:
        if token == "<" and kept and kept[-1][0] != "operator":
            if kept[-1][0] == "template":
                kept.pop()
            depth += 1
        elif token == ">" and depth > 0:
            depth -= 1
        elif depth == 0:
            kept.append((token, line))
    return kept


def defined_type(head, words):
    """class [[...]] alignas(...) NAME final : BASES"""
    for i in range(words.index(next(w for w in words if w in TYPES)) + 1, len(words)):
        if NAME.match(words[i]) and words[i] not in TYPES | NO_FUNCTION:
            return None if "::" in words[i + 1:i + 2] else head[i]
    return None


def defined_name(head, ends_with_body):
    """The name and line that a statement defines, or None. Groups in `head` are closed up: "()"."""
    specialised = [token for token, _ in head[:3]] == ["template", "<", ">"]
    head = without_angles(head)
    words = [token for token, _ in head]
    if not words or specialised or NOT_DEFINING & set(words[:1] + words[1:2]):
        return None
    if words[0] == "namespace":
        return None
    if words[0] == "using":
        return head[1] if "=" in words[2:4] else None
    if words[0] == "typedef":
        return head[-1]
    if "operator" in words:
        return None
    called = next((i for i in range(1, len(words)) if words[i] == "()" and NAME.match(words[i - 1])
                   and words[i - 1] not in NO_FUNCTION), len(words))
    assigned = words.index("=") if "=" in words else len(words)
    if TYPES & set(words[:min(called, assigned)]) and ends_with_body:
        return defined_type(head, words)
    last = min(called, assigned)
    is_function = called < assigned
    if is_function and not ends_with_body and words[assigned + 1:] != ["default"]:
        return None
    name = next((i for i in range(last - 1, -1, -1) if NAME.match(words[i])), None)
    # `struct A;` and `Function name;` only declare.
    if name is None or not is_function and not ends_with_body and assigned == len(words):
        return None
    qualified = name > 0 and words[name - 1] in ("::", "~")
    return None if qualified or MACRO.match(words[name]) else head[name]


def only_forwards(tokens, begin):
    """Does the group hold forward declarations of classes and nothing else?"""
    words = [token for token, _ in tokens[begin + 1:end_of_group(tokens, begin) - 1]]
    return len(words) > 0 and len(words) % 3 == 0 and all(
        words[i] in TYPES and words[i + 2] == ";" for i in range(0, len(words), 3))


def read_scope(tokens, begin, namespace):
    """Yields what `read` returns; ends behind the brace that closes the scope."""
    head, i = [], begin
    while i < len(tokens):
        token, line = tokens[i]
        words = [word for word, _ in head]
        if token == "}":
            return i + 1
        if token == "{" and "namespace" in words[:2]:
            path = [word for word in words if NAME.match(word) and word not in ("namespace", "inline")]
            inner = namespace + (tuple(path) or ("",))
            yield "forwards" if only_forwards(tokens, i) else "namespace", inner, "", line
            i = yield from read_scope(tokens, i + 1, inner)
            head = []
        elif token == ";" or token == "{" and "=" not in words:
            name = defined_name(head, token == "{")
            if name:
                yield "definition", namespace, *name
            i = i + 1 if token == ";" else end_of_group(tokens, i)
            head = []
        elif token in CLOSING:
            i = end_of_group(tokens, i)
            head.append((token + CLOSING[token], line))
            if len(head) == 2 and MACRO.match(words[0]) and tokens[i:i + 1] and tokens[i][0] not in "{;":
                head = []
        else:
            head.append((token, line))
            i += 1
    return i


def read(text):
    """Of a whole source, in order: (kind, namespace, name, line). The kinds are "namespace" where one is
    opened and "forwards" where it only declares classes, both without a name, and "definition". The namespace is a tuple of its names, "" for an unnamed one."""
    return list(read_scope(list(tokens_of(text)), 0, ()))

"""The parameters a run stored: sections as nested dictionaries, and the numbers in them.

Figures need them for what results do not repeat: which points a contact joins, how the frequency of
a sine sweep runs, values that follow a swept key.
"""

from __future__ import annotations

import ast
import math
import operator
import re

UNITS = {
    "m": 1.0, "mm": 1e-3, "cm": 1e-2, "um": 1e-6, "nm": 1e-9, "km": 1e3, "kg": 1.0, "g": 1e-3,
    "s": 1.0, "ms": 1e-3, "us": 1e-6, "min": 60.0, "h": 3600.0, "rad": 1.0, "deg": math.pi / 180,
    "Hz": 2 * math.pi, "kHz": 2e3 * math.pi, "rpm": math.pi / 30, "N": 1.0, "kN": 1e3, "mN": 1e-3,
}
NAMES = {"pi": math.pi, "sqrt": math.sqrt, "exp": math.exp, "ln": math.log, "log10": math.log10,
         "abs": abs, "min": min, "max": max, "sin": math.sin, "cos": math.cos, "tan": math.tan}
OPERATORS = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul,
             ast.Div: operator.truediv, ast.Pow: operator.pow, ast.USub: operator.neg,
             ast.UAdd: operator.pos}


def sections(text: str) -> dict:
    """Keys with their text; a subsection is a dictionary under its name."""
    root: dict = {}
    open_sections = [root]
    for line in re.sub(r"\\\n\s*", "", text).splitlines():  # long values go on in the next line
        line = line.split("#", 1)[0].strip()
        if line.startswith("subsection "):
            open_sections.append(open_sections[-1].setdefault(line[len("subsection "):].strip(), {}))
        elif line == "end" and len(open_sections) > 1:
            open_sections.pop()
        elif line.startswith("set "):
            key, _, value = line[len("set "):].partition("=")
            open_sections[-1][key.strip()] = value.strip()
    return root


def number(text: str, parameters: dict):
    """Value of an expression with units in SI, frequencies in rad/s; None when it is no number."""
    names = dict(UNITS) | NAMES
    for definition in parameters.get("Variables", "").split(","):
        name, _, value = definition.partition("=")
        if value:
            names[name.strip()] = evaluate(value, names)
    return evaluate(text, names)


def evaluate(text: str, names: dict):
    """`12 mm` reads as a product, `^` as a power."""
    product = re.sub(r"(?<=[\w.)])\s+(?=[A-Za-z(])", "*", text.strip().replace("^", "**"))
    product = re.sub(r"(?<![A-Za-z_\d.])(\d+\.?\d*(?:[eE][-+]?\d+)?)(?![eE][-+]?\d)(?=[A-Za-z(])",
                     r"\1*", product)
    try:
        return float(value_of(ast.parse(product, mode="eval").body, names))
    except (SyntaxError, KeyError, TypeError, ValueError, ZeroDivisionError):
        return None


def value_of(node, names: dict):
    if isinstance(node, ast.Constant):
        return node.value
    if isinstance(node, ast.Name):
        return names[node.id]
    if isinstance(node, ast.BinOp):
        return OPERATORS[type(node.op)](value_of(node.left, names), value_of(node.right, names))
    if isinstance(node, ast.UnaryOp):
        return OPERATORS[type(node.op)](value_of(node.operand, names))
    if isinstance(node, ast.Call):
        return names[node.func.id](*[value_of(argument, names) for argument in node.args])
    raise SyntaxError("no expression")


def contact_section(parameters: dict, contact: str) -> tuple[dict, float]:
    """The section of a contact, and -1 if the contact is its mirror image, else 1."""
    if f"Contact {contact}" in parameters:
        return parameters[f"Contact {contact}"], 1.0
    for name, section in parameters.items():
        if name.startswith("Contact ") and section.get("Mirrored as") == contact:
            return section, -1.0
    return {}, 1.0


def contact_sides(parameters: dict, contact: str) -> list[str]:
    """Points BODY.POINT that a contact joins: two, or one at a stop."""
    between = contact_section(parameters, contact)[0].get("Between", "")
    return [side.strip() for side in between.split(",") if "." in side]


def direction_of(parameters: dict, contact: str):
    """Axis and sign of a contact normal along an axis: ("x", -1); None for another direction."""
    section, sign = contact_section(parameters, contact)
    match = re.fullmatch(r"([-+]?)([xyz])", section.get("Direction", "x").replace(" ", ""))
    return (match[2], -sign if match[1] == "-" else sign) if match else None


def judges_steadiness(parameters: dict, analysis: str) -> bool:
    """Was it judged whether motions settle? With a tolerance of 0 no motion counts as steady."""
    section = parameters.get(f"Analysis {analysis}", {})
    repeated = section.get("Parameter grid", {}).get("Repeat", "")
    if repeated:
        return judges_steadiness(parameters, repeated)
    own = section.get(section.get("Type", "").capitalize(), {})
    return number(own.get("Steadiness tolerance", ""), parameters) != 0


def case_columns(table: str) -> list[tuple[str, list[str]]]:
    """Path and texts of values, with their unit, of each key of "PATH [UNIT], PATH; 1, 2; ..."."""
    rows = [[cell.strip() for cell in row.split(",")] for row in table.split(";") if row.strip()]
    columns = []
    for head, *values in zip(*rows):
        path, _, unit = head.partition("[")
        unit = unit.rstrip("] ")
        columns.append((path.strip(), [f"{value} {unit}".strip() for value in values]))
    return columns


def followers(parameters: dict, analysis: str, path: str) -> list[tuple[str, list[str]]]:
    """Keys that change together with the swept key `path` of a grid: path and texts of values."""
    grid = parameters.get(f"Analysis {analysis}", {}).get("Parameter grid", {})
    if grid.get("Cases"):
        return case_columns(grid["Cases"])[1:]
    keys = {name[4:]: section for name, section in grid.items() if name.startswith("Key ")}
    leaders = [name for name, key in keys.items() if key.get("Path") == path]
    return [
        (key["Path"], [value.strip() for value in key["Values"].split(",")])
        for key in keys.values()
        if key.get("Tied to") in leaders and key.get("Tied to") and key.get("Values")
    ]

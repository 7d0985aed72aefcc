"""Reads what a run writes for ParaView: the instants of a PVD file, and its VTU files."""

from __future__ import annotations

import base64
import struct
import zlib
from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

from .errors import ResultError

KINDS = {"Float32": "<f4", "Float64": "<f8", "Int32": "<i4", "UInt8": "u1"}
CORNERS_AROUND = {3: [0, 1], 5: [0, 1, 2], 9: [0, 1, 2, 3]}  # line, triangle, quadrilateral of VTK
FACES = {12: [[0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4], [3, 7, 6, 2], [0, 3, 2, 1], [4, 5, 6, 7]]}  # hexahedron of VTK
VERTEX = 1


@dataclass(frozen=True)
class Mesh:
    """Points, cells and point data of a file."""

    points: np.ndarray           # point, axis [m]
    cells: list[np.ndarray]      # nodes of lines, triangles and quadrilaterals; of solids the faces of their surface
    data: dict[str, np.ndarray]  # point, or point and component

    def moved(self, factor: float) -> np.ndarray:
        return self.points + factor * self.data["displacement"]


def instants(pvd: Path) -> list[tuple[float, list[Path]]]:
    """Times and files of each, in the order of the file."""
    found: dict[float, list[Path]] = {}
    for entry in parsed(pvd).iter("DataSet"):
        found.setdefault(float(entry.get("timestep")), []).append(pvd.parent / entry.get("file"))
    return list(found.items())


def read_mesh(file: Path) -> Mesh:
    piece = parsed(file).find("UnstructuredGrid/Piece")
    arrays = {array.get("Name"): values(array) for array in piece.find("Cells")}
    ends = arrays["offsets"]
    starts = np.concatenate([[0], ends[:-1]])
    points = values(piece.find("Points/DataArray")).astype(float)
    data = {array.get("Name"): values(array) for array in piece.find("PointData")}
    cells, faces = [], []
    for start, end, kind in zip(starts, ends, arrays["types"]):
        nodes = arrays["connectivity"][start:end]
        if kind in FACES:
            faces += [nodes[corners] for corners in FACES[kind]]
        elif kind != VERTEX:
            cells.append(nodes[CORNERS_AROUND[kind]])
    return Mesh(points, cells + outer(faces, points, data.get("body", np.zeros(len(points)))), data)


def outer(faces: list[np.ndarray], points: np.ndarray, body: np.ndarray) -> list[np.ndarray]:
    """Those that belong to one cell of a body alone; cells have points of their own, so that places are compared."""
    places = [(body[face[0]], *sorted(map(tuple, points[face]))) for face in faces]
    count = Counter(places)
    return [face for face, place in zip(faces, places) if count[place] == 1]


def parsed(file: Path):
    try:
        return ElementTree.parse(file).getroot()
    except (OSError, ElementTree.ParseError) as error:
        raise ResultError(f"{file}: cannot be read ({error})") from error


def values(array) -> np.ndarray:
    """Of an inline array: a header with the sizes of compressed blocks, then these."""
    text = "".join(array.text.split())
    count = struct.unpack("<I", base64.b64decode(text[:8])[:4])[0]
    length = 4 * ((4 * (3 + count) + 2) // 3)  # of the header in base 64
    header = struct.unpack(f"<{3 + count}I", base64.b64decode(text[:length])[:4 * (3 + count)])
    packed, data = base64.b64decode(text[length:]), b""
    for size in header[3:]:
        data, packed = data + zlib.decompress(packed[:size]), packed[size:]
    plain = np.frombuffer(data, KINDS[array.get("type")])
    components = int(array.get("NumberOfComponents") or 1)
    return plain.reshape(-1, components) if components > 1 else plain

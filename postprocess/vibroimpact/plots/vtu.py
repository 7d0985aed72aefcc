"""Reads what a run writes for ParaView: the instants of a PVD file, and its VTU files."""

from __future__ import annotations

import base64
import struct
import zlib
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

from .errors import ResultError

KINDS = {"Float32": "<f4", "Float64": "<f8", "Int32": "<i4", "UInt8": "u1"}
CORNERS_AROUND = {3: [0, 1], 5: [0, 1, 2], 9: [0, 1, 2, 3]}  # line, triangle, quadrilateral of VTK
VERTEX = 1


@dataclass(frozen=True)
class Mesh:
    """Points, cells and point data of a file."""

    points: np.ndarray           # point, axis [m]
    cells: list[np.ndarray]      # nodes of lines, triangles and quadrilaterals
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
    cells = [arrays["connectivity"][start:end][CORNERS_AROUND[kind]]
             for start, end, kind in zip(starts, ends, arrays["types"]) if kind != VERTEX]
    return Mesh(values(piece.find("Points/DataArray")).astype(float), cells,
                {array.get("Name"): values(array) for array in piece.find("PointData")})


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

"""Reads what the program writes for ParaView."""

import base64
import re
import struct
import zlib
from xml.etree import ElementTree

import numpy as np


def vtu_arrays(file):
    """Points, point data and cells of a VTU file with compressed inline arrays."""
    root = ElementTree.parse(file).getroot()
    piece = root.find("UnstructuredGrid/Piece")
    arrays = {}
    for array in [*piece.find("Points"), *piece.find("PointData"), *piece.find("Cells")]:
        text = re.sub(r"\s", "", array.text)
        count = struct.unpack("<I", base64.b64decode(text[:8])[:4])[0]
        length = 4 * ((4 * (3 + count) + 2) // 3)  # of the header in base 64
        header = struct.unpack(f"<{3 + count}I", base64.b64decode(text[:length])[:4 * (3 + count)])
        data, position = b"", 0
        packed = base64.b64decode(text[length:])
        for size in header[3:]:
            data += zlib.decompress(packed[position:position + size])
            position += size
        kind = {"Float32": "<f4", "Float64": "<f8", "UInt8": "u1", "Int32": "<i4", "UInt32": "<u4", "Int64": "<i8",
                "UInt64": "<u8"}[array.get("type")]
        values = np.frombuffer(data, kind)
        components = int(array.get("NumberOfComponents", 1))
        name = array.get("Name") or "Points"
        arrays[name] = values.reshape(-1, components) if components > 1 else values
    return arrays

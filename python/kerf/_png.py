"""Pictures as PNG."""

import struct
import zlib

import numpy as np
import numpy.typing as npt


def encoded(picture: "npt.NDArray[np.uint8]") -> bytes:
    """The file of an array [height, width, 4]."""
    height, width, _ = picture.shape
    rows = np.insert(picture.reshape(height, width * 4), 0, 0, axis=1)  # each begins with its filter
    header = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + _chunk(b"IHDR", header) +
            _chunk(b"IDAT", zlib.compress(rows.tobytes())) + _chunk(b"IEND", b""))


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

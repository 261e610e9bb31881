#!/usr/bin/env python3
"""Makes a wheel of a folder that holds the package kerf, with its program and libraries in it.

  make_wheel.py FOLDER VERSION PLATFORM OUT    prints the path of the wheel, in the folder OUT

The tag names no Python: the package runs the program on any, and has compiled modules for some.
"""
import base64
import hashlib
import pathlib
import stat
import sys
import zipfile

METADATA = """\
Metadata-Version: 2.1
Name: kerf
Version: {version}
Summary: Cut soft 3D models while they move
Requires-Python: >=3.11
Requires-Dist: numpy>=1.24
Description-Content-Type: text/plain

Cuts soft 3D models: a desktop editor, the command line `kerf`, and `import kerf` for scripts.
It needs OpenGL 4.5 of the system (libEGL and a driver), which Mesa also gives without a GPU.
"""
WHEEL = """\
Wheel-Version: 1.0
Generator: kerf
Root-Is-Purelib: false
Tag: {tag}
"""
# pip puts its own interpreter into the first line. Finding the package does not import it.
START = """\
#!python
import importlib.util
import os
import sys

package = importlib.util.find_spec("kerf")
program = os.path.join(os.path.dirname(package.origin), "program", "bin", "kerf")
os.execv(program, [program, *sys.argv[1:]])
"""


class Wheel:
    """A wheel that is being written. The same files make the same bytes."""

    def __init__(self, path):
        self.zip = zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9)
        self.record = []

    def add(self, name, content, executable=False):
        entry = zipfile.ZipInfo(name)
        entry.compress_type = zipfile.ZIP_DEFLATED
        entry.external_attr = (stat.S_IFREG | (0o755 if executable else 0o644)) << 16
        self.zip.writestr(entry, content)
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        self.record.append(f"{name},sha256={digest},{len(content)}\n")

    def close(self, record):
        self.zip.writestr(zipfile.ZipInfo(record), "".join(self.record) + f"{record},,\n")
        self.zip.close()


def main():
    folder, version, platform, out = sys.argv[1:]
    tag = f"py3-none-{platform}"
    path = pathlib.Path(out) / f"kerf-{version}-{tag}.whl"
    info = f"kerf-{version}.dist-info"
    wheel = Wheel(path)
    for file in sorted(pathlib.Path(folder).rglob("*")):
        if file.is_file():
            wheel.add(str(file.relative_to(folder)), file.read_bytes(), file.stat().st_mode & 0o100)
    wheel.add(f"kerf-{version}.data/scripts/kerf", START.encode(), True)
    wheel.add(f"{info}/METADATA", METADATA.format(version=version).encode())
    wheel.add(f"{info}/WHEEL", WHEEL.format(tag=tag).encode())
    wheel.close(f"{info}/RECORD")
    print(path)


if __name__ == "__main__":
    main()

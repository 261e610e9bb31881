"""Refuses an interpreter that the module was not built for, with a clear message."""

import importlib.util
import pathlib
import platform
import sys


def refuse_another() -> None:
    """Raises ImportError where the compiled part is only for another version of Python."""
    folder = pathlib.Path(__file__).parent
    versions = [file.name.split("-")[1] for file in folder.glob("_native.cpython-*.so")]
    if versions and importlib.util.find_spec(f"{__package__}._native") is None:
        mine = " and ".join(f"{digits[0]}.{digits[1:]}" for digits in sorted(versions))
        raise ImportError(
            f"{folder}: this module is for Python {mine}, and this is Python "
            f"{platform.python_version()}; start python{mine}, or build Kerf with "
            f"-DPython_EXECUTABLE={sys.executable}.")

"""What is said where the compiled module can't be used; replays don't need it."""

import pathlib
import platform


def reason(error: ImportError) -> str:
    """A clause on why importing the module ended in this error."""
    if error.name == "numpy":
        return "needs NumPy, which is not installed"
    folder = pathlib.Path(__file__).parent
    versions = {file.name.split("-")[1] for file in folder.glob("_native.cpython-*.so")}
    if error.name != "kerf._native" or not versions:
        return f"can't be used: {error}"
    mine = " or ".join(f"{digits[0]}.{digits[1:]}" for digits in sorted(versions))
    return f"needs Python {mine}, and this is Python {platform.python_version()}"

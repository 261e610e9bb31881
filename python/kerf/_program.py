"""The program kerf that this package belongs to: it replays sessions and reads models."""

import pathlib
import subprocess

from ._errors import Error


def folder() -> pathlib.Path:
    """The folder of the program: in the package, else the nearest one above it, or a bin there.

    Raises kerf.Error where there is none.
    """
    here = pathlib.Path(__file__).parent.resolve()
    for above in (here / "program", *here.parents):
        for candidate in (above, above / "bin"):
            if (candidate / "kerf").is_file():
                return candidate
    raise Error(f"{here}: there is no program kerf above this module, which needs it; install both "
                "at one place.")


def path() -> str:
    """The program."""
    return str(folder() / "kerf")


def version() -> str:
    """As `kerf --version` says."""
    done = subprocess.run([path(), "--version"], stdout=subprocess.PIPE, text=True, check=True)
    return done.stdout.split()[1]

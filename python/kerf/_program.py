"""The program kerf that the module belongs to: it reads models, and its data is the module's."""

import pathlib

from . import _native


def folder() -> pathlib.Path:
    """The folder of the program: the nearest one above the module that holds it, or whose bin does.

    Raises kerf.Error where there is none.
    """
    here = pathlib.Path(_native.__file__).resolve()
    for above in here.parents[1:]:
        for candidate in (above, above / "bin"):
            if (candidate / "kerf").is_file():
                return candidate
    raise _native.Error(f"{here.parent}: there is no program kerf above this module, which needs "
                        "it; install both at one place.")


def tell_native() -> None:
    """Lets the module find the program, and the data where that finds it."""
    _native.set_program_folder(str(folder()))

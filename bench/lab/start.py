"""Starts the laboratory, or says what it lacks."""

import sys

NO_INPUT = 3  # exit code: see program.py


def main():
    try:
        from .program import main as run
    except ModuleNotFoundError as missing:
        name = str(missing.name).split(".", maxsplit=1)[0]
        what = ("the Python module kerf" if name == "kerf"
                else f"the Python module {name}, of Debian's package python3-{name}")
        print(f"kerf: experiments need {what}, which is not there; scripts/build brings all that "
              "they need.", file=sys.stderr)
        return NO_INPUT
    except ImportError as error:  # this is another Python than the module is for
        print(f"kerf: {error}", file=sys.stderr)
        return NO_INPUT
    try:
        return run()
    except KeyboardInterrupt:
        return 130

"""Starts the laboratory, or says what it lacks."""

import sys

NO_INPUT, INTERRUPTED = 3, 130  # exit codes


def lack(error):
    """A sentence on what can't be imported."""
    module = (error.name or "").split(".", maxsplit=1)[0]
    if not module:  # this is another Python than kerf is for: it says so itself
        return str(error)
    what = ("the Python module kerf" if module == "kerf"
            else f"the Python module {module}, of Debian's package python3-{module}")
    return f"experiments need {what}, which is not there; scripts/build brings all that they need."


def main():
    try:
        from .program import main as run
    except ImportError as error:
        print(f"kerf: {lack(error)}", file=sys.stderr)
        return NO_INPUT
    try:
        return run()
    except KeyboardInterrupt:
        return INTERRUPTED

"""Complete runs of sessions."""

import json
import os
import tempfile
from typing import Any, Dict, Mapping, Optional, Union

from . import _native, _text
from ._text import PathLike


def replay(session: Union[PathLike, Mapping[str, Any]], out: Optional[PathLike] = None, *,
           params: Optional[Mapping[str, Any]] = None, material: Optional[PathLike] = None,
           until: Optional[int] = None, hashes: bool = False, pieces: bool = False,
           forces: bool = False, fine: bool = False, keep_going: bool = False,
           check_hashes: bool = True) -> Dict[str, Any]:
    """Runs a session to its end, as `kerf replay` does, and returns its summary.

    session: a file, or its content as a dict, with paths relative to the working folder.
    out: the folder for metrics.csv, summary.json, final.ply and the session's own files. Without
        one nothing is kept.
    params, material: replace those at the start of the session.
    until: ends after that many steps.
    hashes, pieces: also write hashes.csv, pieces.csv.
    forces: measures the force of the body on a blade that pushes; see Report.blade_force.
    fine: screenshots with smooth edges and soft shadows.
    keep_going: runs all steps, also after a check failed.
    check_hashes: False ignores the state hashes in the session's own checks.

    Raises kerf.CheckFailed at the end where a check or an invariant failed; its `summary` is that
    of the run. Other kinds of kerf.Error correspond to the exit codes of the command line.
    """
    options = _native.ReplayOptions()
    options.hashes = hashes
    options.pieces = pieces
    options.forces = forces
    options.keep_going = keep_going
    options.hash_checks = check_hashes
    options.set_fine(fine)
    if until is not None:
        options.until = until
    source = _text.source(session, material, params)
    if out is not None:
        return _finished(json.loads(_native.replay(source, os.fspath(out), options)))
    with tempfile.TemporaryDirectory(prefix="kerf-") as folder:
        return _finished(json.loads(_native.replay(source, folder, options)))


def _finished(summary: Dict[str, Any]) -> Dict[str, Any]:
    """The summary of a run in which all checks held."""
    if summary["failures"]:
        error = _native.CheckFailed(" ".join(summary["failures"]))
        error.summary = summary
        raise error
    return summary

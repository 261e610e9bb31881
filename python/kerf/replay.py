"""Complete runs of sessions."""

import json
import logging
import os
import subprocess
import tempfile
from typing import Any, Dict, List, Mapping, Optional, Union

from . import _program, _text
from ._errors import CheckFailed, Error, InputError, LimitError, OpenGLError
from ._text import PathLike

_KINDS = {2: InputError, 3: InputError, 4: OpenGLError, 5: LimitError}  # by the exit code
_LEVELS = {"info": logging.INFO, "warning": logging.WARNING, "error": logging.ERROR}


def replay(session: Union[PathLike, Mapping[str, Any]], out: Optional[PathLike] = None, *,
           params: Optional[Mapping[str, Any]] = None, material: Optional[PathLike] = None,
           until: Optional[int] = None, hashes: bool = False, pieces: bool = False,
           forces: bool = False, fine: bool = False, keep_going: bool = False,
           check_hashes: bool = True) -> Dict[str, Any]:
    """Runs a session to its end by `kerf replay`, and returns its summary.

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
    options = [f"--set={name}={_text.to_json(value)}" for name, value in (params or {}).items()]
    options += [] if material is None else [f"--material={os.fspath(material)}"]
    options += [] if until is None else [f"--until={until}"]
    flags = {"--hashes": hashes, "--pieces": pieces, "--forces": forces, "--fine": fine,
             "--keep-going": keep_going, "--no-hash-checks": not check_hashes}
    options += [flag for flag, wanted in flags.items() if wanted]
    with tempfile.TemporaryDirectory(prefix="kerf-") as folder:
        if isinstance(session, Mapping):
            file = os.path.join(folder, "session.kerf.json")
            with open(file, "w", encoding="utf-8") as stream:
                json.dump(_text.movable(session), stream)
        else:
            file = os.fspath(session)
        kept = os.path.join(folder, "out") if out is None else os.fspath(out)
        return _run([f"--out={kept}", *options, "--", file])


def _run(words: List[str]) -> Dict[str, Any]:
    """What `kerf replay` says of a run in which all checks held."""
    done = subprocess.run([_program.path(), "replay", "--json", *words], text=True, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    sentence = f"kerf replay ended by signal {-done.returncode}."
    for line in done.stderr.splitlines():
        level, _, said = line.partition(": ")
        if level == "kerf":
            sentence = said
        elif level in _LEVELS:  # other lines are the failures of the summary
            logging.getLogger("kerf").log(_LEVELS[level], "%s", said)
    if done.returncode not in (0, 1):
        raise _KINDS.get(done.returncode, Error)(sentence)
    summary: Dict[str, Any] = json.loads(done.stdout)
    if done.returncode == 0:
        return summary
    error = CheckFailed(" ".join(summary["failures"]))
    error.summary = summary
    raise error

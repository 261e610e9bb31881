"""What the tests of the laboratory share."""

import pathlib
import subprocess
import tempfile
import unittest

from kerf import _program

ROOT = pathlib.Path(__file__).resolve().parents[2]
KERF = _program.folder() / "kerf"


class LabCase(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="kerf-lab-test-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)


def experiment(*words, **environment):
    """What `kerf experiment` does with these words."""
    return subprocess.run([KERF, "experiment", *map(str, words)], capture_output=True, text=True,
                          check=False, env=environment or None)

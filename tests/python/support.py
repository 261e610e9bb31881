"""What the tests of the Python module share."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import kerf
from kerf import _program

ROOT = pathlib.Path(__file__).resolve().parents[2]
KERF = _program.folder() / "kerf"


class TestCase(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="kerf-python-test-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)


def command_line(*words):
    """What the program kerf does with these words."""
    return subprocess.run([KERF, *map(str, words)], capture_output=True, text=True, check=False)


def replayed(session, folder, *options):
    """The summary of `kerf replay`, where all checks held."""
    done = command_line("replay", session, "--out", folder, "--json", *options)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def halved(**options):
    """A small sphere before a blade has gone through it, and the pose that the blade goes to."""
    sim = kerf.Simulation("sphere20", params={"gravity": [0, 0, 0], "floor": None}, **options)
    sim.move_blade([-0.8, 0.7, 0.02], [0.8, 0.7, 0.05])
    return sim, ([-0.8, -0.75, 0.02], [0.8, -0.75, 0.05])

"""Where the compiled module can't be used, replays work, and the rest says why not."""

import json
import shutil
import subprocess
import sys
import unittest

from support import KERF, ROOT, TestCase, replayed

SESSION = ROOT / "assets/sessions/sphere20.kerf.json"


class Interpreter(TestCase):
    def setUp(self):
        super().setUp()
        shutil.copytree(ROOT / "python/kerf", self.folder / "kerf")
        (self.folder / "kerf/_native.cpython-399-x86_64-linux-gnu.so").touch()
        (self.folder / "bin").mkdir()
        (self.folder / "bin/kerf").symlink_to(KERF)

    def python(self, *words):
        """What an interpreter with that package alone says on standard output and error."""
        return subprocess.run([sys.executable, "-B", *words], capture_output=True, text=True,
                              check=False, env={"PYTHONPATH": str(self.folder),
                                                "LIBGL_ALWAYS_SOFTWARE": "1"})

    def test_another_version_is_named_with_the_modules_own(self):
        for code in ("import kerf; kerf.Simulation('sphere20')", "from kerf import Simulation"):
            said = self.python("-c", code).stderr.splitlines()[-1]
            self.assertIn("ImportError: kerf.Simulation needs Python 3.99, and this is Python 3.",
                          said)
        self.assertIn("AttributeError", self.python("-c", "import kerf; kerf.Blade").stderr)

    def test_without_numpy_that_is_said(self):
        (self.folder / "kerf/_native.cpython-399-x86_64-linux-gnu.so").unlink()
        (self.folder / "kerf/_native.py").write_text("import numpy")
        (self.folder / "numpy.py").write_text("raise ImportError('none', name='numpy')")
        said = self.python("-c", "import kerf; kerf.Simulation").stderr
        self.assertIn("kerf.Simulation needs NumPy, which is not installed", said)

    def test_replay_and_program_need_no_module(self):
        code = "import kerf, sys; print(kerf.replay(sys.argv[1], until=3)['state_hash'])"
        done = self.python("-c", code, str(SESSION))
        expected = replayed(SESSION, self.folder / "out", "--until", 3)["state_hash"]
        self.assertEqual(done.stdout, expected + "\n", done.stderr)
        self.assertEqual(self.python("-m", "kerf", "--version").stdout,
                         "kerf " + self.python("-c", "import kerf; print(kerf.__version__)").stdout)

    def test_a_session_as_a_dict_finds_its_files(self):
        model = ROOT / "assets/models/sphere20.obj"
        session = {**json.loads(SESSION.read_text()), "model": {"path": "ball.obj"}, "steps": 2,
                   "events": []}
        shutil.copy(model, self.folder / "ball.obj")
        code = f"import kerf, os; os.chdir({str(self.folder)!r}); print(kerf.replay({session})['steps'])"
        done = self.python("-c", code)
        self.assertEqual(done.stdout, "2\n", done.stderr)


if __name__ == "__main__":
    unittest.main()

"""Another Python than the module's is refused with a sentence."""

import shutil
import subprocess
import sys
import unittest

from support import ROOT, TestCase


class Interpreter(TestCase):
    def test_another_version_is_named_with_the_modules_own(self):
        package = self.folder / "kerf"
        shutil.copytree(ROOT / "python/kerf", package)
        (package / "_native.cpython-399-x86_64-linux-gnu.so").touch()
        done = subprocess.run([sys.executable, "-B", "-c", "import kerf"], capture_output=True,
                              text=True, check=False, env={"PYTHONPATH": str(self.folder)})
        said = done.stderr.splitlines()[-1]
        self.assertIn("ImportError", said)
        self.assertIn("for Python 3.99, and this is Python 3.", said)


if __name__ == "__main__":
    unittest.main()

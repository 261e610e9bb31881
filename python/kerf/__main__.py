"""`python -m kerf`: the program, and without words its window."""

import os
import sys

from . import _program

os.execv(_program.path(), [_program.path(), *sys.argv[1:]])

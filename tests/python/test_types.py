"""What the types promise is there."""

import ast
import inspect
import unittest

import kerf
from kerf import _native
from support import ROOT, TestCase, replayed

STUB = ast.parse((ROOT / "python/kerf/_native.pyi").read_text())


def public(names):
    return {name for name in names if not name.startswith("_")}


class Types(TestCase):
    def test_the_stub_has_what_the_module_has(self):
        classes = {node.name: node for node in STUB.body if isinstance(node, ast.ClassDef)}
        functions = {node.name for node in STUB.body if isinstance(node, ast.FunctionDef)}
        self.assertEqual(classes.keys() | functions | {"version"}, public(vars(_native)))
        for name, node in classes.items():
            if issubclass(getattr(_native, name), Exception):
                continue
            promised = {member.name for member in node.body if isinstance(member, ast.FunctionDef)}
            promised |= {member.target.id for member in node.body
                         if isinstance(member, ast.AnnAssign)}
            self.assertEqual(public(promised), public(vars(getattr(_native, name))), name)

    def test_measures_are_the_columns_of_metrics(self):
        replayed(ROOT / "assets/sessions/sphere20.kerf.json", self.folder, "--until", 1)
        columns = (self.folder / "metrics.csv").read_text().splitlines()[0].split(",")
        forces = {"blade_force_x", "blade_force_y", "blade_force_z",
                  "blade_moment_x", "blade_moment_y", "blade_moment_z"}
        attributes = public(vars(kerf.Report)) - {"as_dict"}
        self.assertEqual(attributes - {"blade_force", "blade_moment"}, set(columns) - forces)

    def test_all_that_people_call_is_explained(self):
        for name in kerf.__all__:
            thing = getattr(kerf, name)
            if name == "__version__":
                continue
            self.assertTrue(thing.__doc__, name)
            if inspect.isclass(thing) and thing.__module__.startswith("kerf."):
                for member in public(vars(thing)):
                    self.assertTrue(inspect.getdoc(getattr(thing, member)), f"{name}.{member}")

    def test_it_is_marked_as_typed(self):
        self.assertTrue((ROOT / "python/kerf/py.typed").exists())


if __name__ == "__main__":
    unittest.main()

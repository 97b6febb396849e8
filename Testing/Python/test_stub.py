"""The stub that type checkers read: it says what the compiled module holds, class by class."""

import ast
import inspect
import pathlib
import re
import unittest

from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass

from vitrine import vtkVitrineRendering

STUB = pathlib.Path(vtkVitrineRendering.__file__).with_name("vtkVitrineRendering.pyi")
HAS_PROPERTIES = hasattr(vtkRenderStepsPass, "translucent_pass")  # VTK 9.4 and later


def classes():
    return {name: cls for name, cls in vars(vtkVitrineRendering).items() if isinstance(cls, type)}


def stub_classes():
    tree = ast.parse(STUB.read_text())
    return {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}


def signature(function):
    """Types without names, which VTK's methods do not take: "(self, int) -> None"."""
    arguments = [
        ast.unparse(argument.annotation or ast.Name(argument.arg))
        for argument in function.args.args
    ]
    return f"({', '.join(arguments)}) -> {ast.unparse(function.returns)}"


def method(cls, name):
    """What VTK's wrapping tools wrote at the head of the docstring, which overloads follow one another in."""
    found = re.findall(rf"^{name}(\(.*?\)\s+-> .+?)\nC\+\+:", getattr(cls, name).__doc__, re.M | re.S)
    # VTK's tools write an array that is written into as a list of types.
    texts = [re.sub(r":\[float.*?\]", ":list[float]", " ".join(text.split())) for text in found]
    return " or ".join(sorted(signature(ast.parse(f"def f{text}: ...").body[0]) for text in texts))


def member(cls, name):
    value = getattr(cls, name)
    if isinstance(value, type):
        return f"class of {value.__base__.__name__}"
    if inspect.isroutine(value):
        return method(cls, name)
    if inspect.isgetsetdescriptor(value):
        access, getter = re.match(r"(\S+), calls (\w+)", value.__doc__).groups()
        return f"{access} {method(cls, getter).split('-> ')[-1]}"
    return f"constant {type(value).__name__}"


def added_members(cls):
    """What a class has that its base lacks or has otherwise."""
    base = cls.__base__
    return {
        name: member(cls, name)
        for name in vars(cls)
        if not name.startswith("__")
        and not (hasattr(base, name) and member(base, name) == member(cls, name))
    }


def stub_member(node):
    """The name of a member in the stub, and what member() should say of it."""
    if isinstance(node, ast.ClassDef):
        return node.name, f"class of {ast.unparse(node.bases[0])}"
    if isinstance(node, ast.AnnAssign):
        kind = "read-write" if node.target.id.islower() else "constant"
        return node.target.id, f"{kind} {ast.unparse(node.annotation)}"
    decorators = [ast.unparse(decorator) for decorator in node.decorator_list]
    if decorators == ["property"]:
        return node.name, f"read-only {ast.unparse(node.returns)}"
    text = signature(node)
    decorators = [decorator for decorator in decorators if decorator != "overload"]
    fits = text.startswith("(self") != (decorators == ["staticmethod"])
    return node.name, text if fits else f"{text}, decorated by {decorators}"


def stub_members(node):
    members = {}
    without_docstring = (item for item in node.body if not isinstance(item, ast.Expr))
    for name, text in map(stub_member, without_docstring):
        overloads = [*members[name].split(" or "), text] if name in members else [text]
        members[name] = " or ".join(sorted(overloads))
    if HAS_PROPERTIES:
        return members
    return {name: text for name, text in members.items() if not text.startswith("read-")}


class Stub(unittest.TestCase):
    maxDiff = None

    def test_has_the_classes_of_the_module_with_their_bases(self):
        self.assertEqual(
            {
                name: [ast.unparse(base) for base in node.bases]
                for name, node in stub_classes().items()
            },
            {
                # VTK 9.3 put vtkCompositePolyDataMapper2 in the place of vtkCompositePolyDataMapper.
                name: [base.__name__.replace("Mapper2", "Mapper") for base in cls.__bases__]
                for name, cls in classes().items()
            },
        )

    def test_has_what_each_class_adds_to_its_base(self):
        for name, cls in classes().items():
            with self.subTest(name):
                added = added_members(cls)
                self.assertGreater(len(added), 1)
                stub = stub_members(stub_classes()[name])
                self.assertEqual({key: stub.get(key) for key in added}, added)

    def test_has_the_briefs_of_the_headers(self):
        for name, cls in classes().items():
            with self.subTest(name):
                brief = " ".join(cls.__doc__.split("\n\n")[0].split())
                self.assertEqual(f"{name} - {ast.get_docstring(stub_classes()[name])}", brief)

    def test_has_nothing_that_is_not_there(self):
        for name, cls in classes().items():
            with self.subTest(name):
                stub = stub_members(stub_classes()[name])
                there = {key: member(cls, key) if hasattr(cls, key) else None for key in stub}
                self.assertEqual(stub, there)


if __name__ == "__main__":
    unittest.main()

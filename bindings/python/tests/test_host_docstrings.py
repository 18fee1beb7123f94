"""Public callables of the adapters say what goes in and what comes out: read, not imported, since few machines have all hosts."""

import ast
from pathlib import Path

import pytest
from numpydoc_sections import named, sections

HOSTS = Path(__file__).parents[3] / "hosts"
PACKAGES = sorted(HOSTS.glob("*/src/fmc_contact_*/__init__.py"))


def public(package):
    """Public functions and classes of an adapter, and the public methods of these classes, by name."""
    trees = {path.stem: ast.parse(path.read_text(encoding="utf-8")) for path in package.parent.glob("*.py")}
    definitions = {
        (stem, node.name): node for stem, tree in trees.items() for node in tree.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))
    }
    classes = {name: node for (_, name), node in definitions.items() if isinstance(node, ast.ClassDef)}
    for line in trees["__init__"].body:
        for alias in line.names if isinstance(line, ast.ImportFrom) else ():
            node = definitions[line.module, alias.name]
            yield alias.name, node
            if isinstance(node, ast.ClassDef):
                bases = [classes[base.id] for base in node.bases if isinstance(base, ast.Name) and base.id in classes]
                for method in [one for kind in (node, *bases) for one in kind.body if isinstance(one, ast.FunctionDef)]:
                    if not method.name.startswith("_"):
                        yield f"{alias.name}.{method.name}", method


FOUND = {f"{path.parent.name}.{name}": node for path in PACKAGES for name, node in public(path)}


def arguments(function):
    given = function.args
    every = [*given.posonlyargs, *given.args, *given.kwonlyargs, given.vararg, given.kwarg]
    return {one.arg for one in every if one is not None} - {"self", "cls"}


def test_all_adapters_are_read():
    assert {path.parent.name for path in PACKAGES} == {"fmc_contact_dolfinx", "fmc_contact_getfem", "fmc_contact_skfem"}


@pytest.mark.parametrize("name", FOUND)
def test_every_callable_has_its_sections(name):
    node = FOUND[name]
    text = ast.get_docstring(node)
    assert text
    found = sections(text)
    if isinstance(node, ast.ClassDef):
        begin = [one for one in node.body if isinstance(one, ast.FunctionDef) and one.name == "__init__"]
        assert not begin or named(found.get("Parameters", "")) == arguments(begin[0])
        assert not begin or ">>> " in found["Examples"]
        return
    if any(isinstance(one, ast.Name) and one.id == "property" for one in node.decorator_list):
        return
    assert named(found.get("Parameters", "")) == arguments(node)
    assert ("Returns" in found) == (ast.unparse(node.returns) != "None")
    assert "." in name.split(".", 1)[1] or ">>> " in found["Examples"]

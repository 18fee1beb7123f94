"""Every public callable says what goes in, what comes out, what it raises and how it is used; its types can be asked for."""

import dataclasses
import doctest
import inspect
import sys
import typing

import fmc_contact
import pytest
from fmc_contact import Contact, PartitionedContact, errors
from fmc_contact.partition import PartitionedFriction
from numpydoc_sections import named, sections

PARTS = [kind for kind in typing.get_type_hints(Contact).values() if inspect.isclass(kind)] + [PartitionedFriction]
CLASSES = [one for name in fmc_contact.__all__ if inspect.isclass(one := getattr(fmc_contact, name))] + PARTS
CLASSES = list(dict.fromkeys(CLASSES))
# Exceptions are told by a sentence each, which docs/errors.md goes on about.
DOCUMENTED = [kind for kind in CLASSES if not issubclass(kind, BaseException)]


def members(kind):
    """Public methods and properties that a class has of its own, by name."""
    for name, one in vars(kind).items():
        if not name.startswith("_") and (callable(one) or isinstance(one, (classmethod, property))):
            yield f"{kind.__name__}.{name}", getattr(one, "__func__", one)


FUNCTIONS = {name: one for name in fmc_contact.__all__ if inspect.isfunction(one := getattr(fmc_contact, name))}
METHODS = dict(item for kind in DOCUMENTED for item in members(kind))
CALLABLES = {**FUNCTIONS, **{name: one for name, one in METHODS.items() if not isinstance(one, property)}}
# They fail for nothing that a caller does.
NEVER_RAISE = {"has_feature", "Tangent.triplets"}


@pytest.mark.parametrize("name", CALLABLES)
def test_every_callable_has_its_sections(name):
    function = CALLABLES[name]
    found = sections(function.__doc__ or "")
    arguments = set(inspect.signature(function).parameters) - {"self", "cls"}
    assert named(found.get("Parameters", "")) == arguments
    returns = typing.get_type_hints(function)["return"]
    assert ("Returns" in found) == (returns is not type(None))
    assert "Raises" in found or name in NEVER_RAISE
    assert ">>> " in found["Examples"]


@pytest.mark.parametrize("kind", DOCUMENTED)
def test_every_class_tells_of_its_fields(kind):
    found = sections(kind.__doc__ or "")
    assert ">>> " in found["Examples"]
    if dataclasses.is_dataclass(kind):
        assert named(found["Attributes"]) == {field.name for field in dataclasses.fields(kind)}
    elif kind not in PARTS and not issubclass(kind, (tuple, dict)):
        arguments = set(inspect.signature(kind.__init__).parameters) - {"self"}
        assert named(found.get("Parameters", "")) == arguments
    if hasattr(kind, "_fields"):
        assert named(found["Attributes"]) == set(kind._fields)


def test_options_and_parts_stand_in_help():
    options = set(typing.get_type_hints(fmc_contact.Options))
    assert named(sections(fmc_contact.Options.__doc__)["Attributes"]) == options
    assert named(sections(Contact.__doc__)["Attributes"]) == set(typing.get_type_hints(Contact))
    for name in [name for name, one in METHODS.items() if isinstance(one, property)]:
        assert METHODS[name].fget.__doc__, name


@pytest.mark.parametrize("name", [*CALLABLES, *(kind.__name__ for kind in DOCUMENTED)])
def test_types_can_be_asked_for(name):
    target = CALLABLES.get(name) or next(kind for kind in DOCUMENTED if kind.__name__ == name)
    if name in CALLABLES:
        hints = typing.get_type_hints(target)
        assert set(inspect.signature(target).parameters) - {"self", "cls"} <= set(hints)
    else:
        typing.get_type_hints(target)
        typing.get_type_hints(target.__init__)


def scene():
    """The names that examples use: those of the example of ``Contact``, and the same contact in parts, all on one rank."""
    names = {name: getattr(fmc_contact, name) for name in ("Condensation", "Options", "Pose")}
    for example in doctest.DocTestParser().get_examples(Contact.__doc__):
        if not example.want:
            exec(example.source, names)
    numbers = {"node_numbers": range(8), "cell_numbers": range(2), "bodies": range(2)}
    coords, squares = names["coords"], names["squares"]
    names["partitioned"] = PartitionedContact(Alone(), coords, squares, "quad", **numbers, stiffness=1000.0)
    names["partitioned"].set_coords(coords)
    return names


class Alone:
    """The communicator of one rank."""

    rank, size = 0, 1

    def Allgatherv(self, sendbuf, recvbuf):
        recvbuf[0][:] = sendbuf


EXAMPLES = {**{kind.__name__: kind for kind in DOCUMENTED}, **CALLABLES}
EXAMPLES.update({name: one for name, one in METHODS.items() if isinstance(one, property)})


@pytest.mark.parametrize("name", EXAMPLES)
def test_examples_run(name):
    pytest.importorskip("scipy")
    text = EXAMPLES[name].__doc__
    if ">>> " not in text:
        pytest.skip("a property that is a number")
    test = doctest.DocTestParser().get_doctest(text, scene(), name, None, None)
    runner = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE)
    runner.run(test)
    assert runner.summarize(verbose=False).failed == 0, name


def test_every_exception_has_a_sentence():
    for kind in vars(errors).values():
        if inspect.isclass(kind) and issubclass(kind, errors.FmcError):
            assert kind.__doc__, kind
    assert sys.modules["fmc_contact.errors"].__doc__

"""The tables of the package against include/fmc_contact.h, read as text and by a C compiler."""

import ctypes
import re
import shutil
import subprocess
from pathlib import Path

import pytest
from fmc_contact import _signatures, _structs, errors
from fmc_contact._library import library

HEADER = Path(__file__).parents[3] / "include" / "fmc_contact.h"
CODE = re.sub(r"//[^\n]*|/\*.*?\*/", "", HEADER.read_text(), flags=re.S)

NUMBERS = {
    "double": ctypes.c_double,
    "int32_t": ctypes.c_int32,
    "int64_t": ctypes.c_int64,
    "uint32_t": ctypes.c_uint32,
    "uint64_t": ctypes.c_uint64,
    "size_t": ctypes.c_size_t,
    "ptrdiff_t": ctypes.c_ssize_t,
    "fmc_status": _signatures.STATUS,
}
CALLBACKS = {"fmc_signed_distance": _signatures.SIGNED_DISTANCE, "fmc_log_callback": _signatures.LOG}
CALLBACKS["fmc_place"], CALLBACKS["fmc_all_gather"] = _signatures.PLACE, _signatures.ALL_GATHER
CALLBACKS["fmc_all_to_all"] = _signatures.ALL_TO_ALL
STRUCTS = {
    name: getattr(_structs, name)
    for name in ("fmc_options", "fmc_coords", "fmc_forces", "fmc_cell_block", "fmc_cell_block_i64", "fmc_result")
    + ("fmc_facet_block", "fmc_facet_block_i64")
    + ("fmc_resultant", "fmc_pair", "fmc_pair_options", "fmc_contact_side", "fmc_contact_point", "fmc_boundary_facet")
    + ("fmc_gap_constraint", "fmc_pose", "fmc_part", "fmc_friction_step")
    + ("fmc_contact_step_options", "fmc_contact_step_result", "fmc_communicator", "fmc_rank_counts")
    + ("fmc_mesh_part", "fmc_carried_slip", "fmc_gathered_counts", "fmc_augmentation", "fmc_multiplier")
}
# Pointers that stand for an array (by the argument's name) take numpy arrays; the others one struct or number.
ARRAYS = {"double": _signatures.Float64Array, "int32_t": _signatures.Int32Array, "int64_t": _signatures.Int64Array}
SCALARS = {"renumbered", "volume", "stiffness", "factor", "code", "step", "shape"}


HANDLES = {"fmc_context": _signatures.Context, "fmc_condensation": _signatures.CondensationPointer}


def pointee(kind):
    if kind in HANDLES:
        return HANDLES[kind]
    return NUMBERS.get(kind) or STRUCTS[kind]


def declared(declaration):
    """ctypes of an argument, ``const double *coords``."""
    kind, stars, name = re.fullmatch(r"(?:const )?(\w+) ?(\**)(\w+)", declaration.strip()).groups()
    if kind == "char":
        return ctypes.c_char_p if stars == "*" else ctypes.POINTER(ctypes.c_char_p)
    if kind == "void":
        return ctypes.c_void_p
    if kind in CALLBACKS:
        return CALLBACKS[kind]
    if not stars:
        return NUMBERS[kind]
    if kind in HANDLES:
        return HANDLES[kind] if stars == "*" else ctypes.POINTER(HANDLES[kind])
    # What is read is an array, whatever its name: one number is passed by value.
    if kind in ARRAYS and (name not in SCALARS or declaration.strip().startswith("const")):
        return ARRAYS[kind]
    return ctypes.POINTER(pointee(kind))


def functions():
    body = CODE[CODE.index('extern "C" {') :]
    pattern = r"(fmc_status|int32_t|const char \*) ?(fmc_\w+)\(([^)]*)\);"
    return {name: (result, arguments) for result, name, arguments in re.findall(pattern, body)}


def test_every_function_of_the_header_has_its_signature():
    found = functions()
    assert len(found) == len(re.findall(r"\bfmc_\w+\(", CODE)), "a function is declared in a way that this test misses"
    assert found.keys() == _signatures.FUNCTIONS.keys()
    results = {"fmc_status": _signatures.STATUS, "int32_t": ctypes.c_int32, "const char *": ctypes.c_char_p}
    for name, (result, arguments) in found.items():
        listed = [] if arguments.strip() == "void" else re.sub(r"\s+", " ", arguments).split(",")
        expected = results[result], [declared(argument) for argument in listed]
        assert _signatures.FUNCTIONS[name] == expected, name


def test_callbacks_have_their_signatures():
    pattern = r"typedef (\w+) \(\*(\w+)\)\(([^)]*)\);"
    found = {name: (result, arguments) for result, name, arguments in re.findall(pattern, CODE)}
    assert found.keys() == CALLBACKS.keys()
    for name, (result, arguments) in found.items():
        of_pointers = {"double": ctypes.POINTER(ctypes.c_double), "uint64_t": ctypes.POINTER(ctypes.c_uint64)}
        expected = []
        for argument in arguments.split(","):
            kind, star = re.match(r"\s*(?:const )?(\w+) ?(\*?)", argument).groups()
            expected.append(of_pointers[kind] if star and kind in of_pointers else declared(argument))
        assert list(CALLBACKS[name]._argtypes_) == expected, name
        assert CALLBACKS[name]._restype_ == NUMBERS.get(result), name


def structs():
    return {name: body for body, name in re.findall(r"typedef struct \{(.*?)\} (\w+);", CODE, flags=re.S)}


def test_structs_have_the_fields_of_the_header():
    assert structs().keys() == STRUCTS.keys()
    for name, body in structs().items():
        fields = []
        for field in filter(None, (line.strip() for line in body.split(";"))):
            kind, star, field_name, length = re.fullmatch(r"(?:const )?(\w+) (\*?)(\w+)(?:\[(\d+)\])?", field).groups()
            if star:
                element = ctypes.POINTER(STRUCTS[kind]) if kind in STRUCTS else ctypes.c_void_p
            else:
                element = STRUCTS.get(kind) or CALLBACKS.get(kind) or NUMBERS[kind]
            fields.append((field_name, element * int(length) if length else element))
        listed = [field for base in reversed(STRUCTS[name].__mro__) for field in base.__dict__.get("_fields_", [])]
        # Arrays of numbers are given as addresses, with or without their type.
        of_numbers = [ctypes.POINTER(number) for number in NUMBERS.values() if number]
        listed = [(field, ctypes.c_void_p if kind in of_numbers else kind) for field, kind in listed]
        assert listed == fields, name


@pytest.mark.skipif(shutil.which("cc") is None, reason="no C compiler")
def test_the_compiler_lays_structs_out_as_ctypes_does(tmp_path):
    lines, expected = [], []
    for name, struct in STRUCTS.items():
        lines.append(f'printf("%zu\\n", sizeof({name}));')
        expected.append(ctypes.sizeof(struct))
        for field in (field for base in reversed(struct.__mro__) for field, _ in base.__dict__.get("_fields_", [])):
            lines.append(f'printf("%zu\\n", offsetof({name}, {field}));')
            expected.append(getattr(struct, field).offset)
    source = tmp_path / "layout.c"
    source.write_text(f'#include "{HEADER}"\n#include <stdio.h>\nint main(void) {{ {"".join(lines)} return 0; }}\n')
    subprocess.run(["cc", "-o", tmp_path / "layout", source], check=True)
    printed = subprocess.run([tmp_path / "layout"], check=True, capture_output=True, text=True).stdout
    assert [int(line) for line in printed.split()] == expected


def enumeration(name):
    body = re.search(rf"typedef enum \{{([^}}]*)\}} {name};", CODE).group(1)
    return {key: int(value) for key, value in re.findall(r"(\w+) = (\d+)", body)}


def test_numbers_of_the_header_are_those_of_the_package():
    assert re.search(r"#define FMC_ABI_VERSION (\d+)", CODE).group(1) == str(_structs.ABI_VERSION)
    for flag in ("FMC_ADD", "FMC_SEMIDEFINITE", "FMC_BLOCKS", "FMC_OBSTACLES", "FMC_FROM_ONE", "FMC_LAW_OF_CONTEXT"):
        assert re.search(rf"#define {flag} (-?\d+)", CODE).group(1) == str(getattr(_structs, flag))
    for option, values in _structs.CHOICES.items():
        prefix = f"FMC_{option.upper()}_"
        assert enumeration(f"fmc_{option}") == {prefix + text.upper(): number for number, text in values.items()}
    partners = {f"FMC_PARTNER_{text.upper()}": number for number, text in _structs.PARTNERS.items()}
    assert enumeration("fmc_partner") == partners
    shapes = {f"FMC_SHAPE_{text.upper()}": number for number, text in enumerate(_structs.SHAPES)}
    assert enumeration("fmc_shape") == shapes
    states = {f"FMC_STEP_{text.upper()}": number for number, text in _structs.STEP_STATES.items()}
    assert enumeration("fmc_contact_step_state") == states
    warnings = {f"FMC_WARNING_{text.upper()}": number for number, text in _structs.WARNINGS.items()}
    assert enumeration("fmc_warning") == warnings
    assert sorted(enumeration("fmc_cell_type").values()) == sorted(_structs.CELL_TYPES.values())


def test_every_status_has_an_exception():
    statuses = enumeration("fmc_status")
    assert statuses.pop("FMC_OK") == 0
    assert set(errors.BY_STATUS) == set(statuses.values())
    for name, number in statuses.items():
        assert library.fmc_status_name(number).decode() == name
        words = name.replace("FMC_ERROR_", "").title().replace("_", "")
        # OverflowError is taken.
        assert errors.BY_STATUS[number].__name__ == {"Overflow": "Range"}.get(words, words) + "Error"

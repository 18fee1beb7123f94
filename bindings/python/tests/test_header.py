"""What is generated for the package against include/fmc_contact.h, read by a C compiler, and what is written by hand against both."""

import ctypes
import re
import shutil
import subprocess
from pathlib import Path

import pytest
from fmc_contact import _cells, _constants, _structs, errors
from fmc_contact._library import library

HEADER = Path(__file__).parents[3] / "include" / "fmc_contact.h"
CODE = re.sub(r"//[^\n]*|/\*.*?\*/", "", HEADER.read_text(), flags=re.S)

STRUCTS = {
    name: struct
    for name, struct in vars(_structs).items()
    if isinstance(struct, type) and issubclass(struct, ctypes.Structure) and struct is not ctypes.Structure
}


def test_every_struct_of_the_header_is_there():
    assert STRUCTS.keys() == set(re.findall(r"typedef struct \{[^}]*\} (\w+);", CODE))


@pytest.mark.skipif(shutil.which("cc") is None, reason="no C compiler")
def test_the_compiler_lays_structs_out_as_ctypes_does(tmp_path):
    lines, expected = [], []
    for name, struct in STRUCTS.items():
        lines.append(f'printf("%zu\\n", sizeof({name}));')
        expected.append(ctypes.sizeof(struct))
        for field, _ in struct._fields_:
            lines.append(f'printf("%zu\\n", offsetof({name}, {field}));')
            expected.append(getattr(struct, field).offset)
    source = tmp_path / "layout.c"
    source.write_text(f'#include "{HEADER}"\n#include <stdio.h>\nint main(void) {{ {"".join(lines)} return 0; }}\n')
    subprocess.run(["cc", "-o", tmp_path / "layout", source], check=True)
    printed = subprocess.run([tmp_path / "layout"], check=True, capture_output=True, text=True).stdout
    assert [int(line) for line in printed.split()] == expected


def test_every_cell_and_facet_type_has_a_name():
    assert sorted(_constants.FMC_CELL_TYPE) == sorted(_cells.CELL_TYPES.values())
    assert sorted(_constants.FMC_FACET_TYPE) == sorted(_cells.FACET_TYPES.values())


def test_every_status_has_an_exception():
    assert errors.BY_STATUS.keys() | {0} == _constants.FMC_STATUS.keys()
    for number, error in errors.BY_STATUS.items():
        name = library.fmc_status_name(number).decode()
        words = name.replace("FMC_ERROR_", "").title().replace("_", "")
        # OverflowError, InterruptedError and MemoryError are taken.
        taken = {"Overflow": "Range", "Interrupted": "Ended", "Memory": "OutOfMemory"}
        assert error.__name__ == taken.get(words, words) + "Error"
        assert error.status == number

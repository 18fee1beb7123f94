"""The list of keys of case files: python3 -m unittest discover benchmarks/results"""

import re
import unittest

import case_keys
import tomllib


def tables(text):
    """Keys of the page, by the heading of their table."""
    parts = re.split(r"^### (.*)\n", text, flags=re.M)
    return {title: set(re.findall(r"^\| `([\w-]+)` \|", part, flags=re.M)) for title, part in zip(parts[1::2], parts[2::2])}


class CaseKeys(unittest.TestCase):
    def test_every_key_and_name_of_the_cases_is_listed(self):
        listed = tables(case_keys.keys(None))
        shapes = set(re.findall(r"`shape = \"([\w-]+)\"`", case_keys.keys(None)))
        cases = sorted((case_keys.SOURCES.parents[1] / "cases").glob("*.toml"))
        seen = 0
        for path in cases:
            if path.stem == "report":
                continue
            case = tomllib.loads(path.read_text(encoding="utf-8"))
            self.assertLessEqual(set(case), listed["Top level"], path.name)
            for name, value in case.items():
                title = next((one for one in (f"`[{name}]`", f"`[[{name}]]`") if one in listed), None)
                for entry in value if isinstance(value, list) else [value]:
                    if title and isinstance(entry, dict):
                        self.assertLessEqual(set(entry), listed[title], f"{path.name}: {name}")
                        seen += len(entry)
            for body in case["bodies"]:
                self.assertIn(body["mesh"]["shape"], shapes)
                self.assertLessEqual(set(body["material"]), listed["`material`"])
                self.assertIn(body["material"]["law"], listed["Values of `law` in `material`"])
            self.assertIn(case["contact"]["law"], listed["Values of `law` in `[contact]`"])
            self.assertIn(case["figures"]["kind"], listed["Values of `kind` in `[figures]`"])
        self.assertGreater(seen, 500)

    def test_no_struct_that_is_read_is_left_out(self):
        read = re.compile(r"^#\[derive\([^\n]*Deserialize\)\]\n(?:#\[[^\n]*\]\n)*pub (?:struct|enum) (\w+) \{", re.M)
        found = {path.stem: read.findall(path.read_text(encoding="utf-8")) for path in case_keys.SOURCES.glob("*.rs")}
        self.assertEqual({name for name, items in found.items() if items}, set(case_keys.FILES))
        self.assertEqual({item for items in found.values() for item in items}, set(case_keys.items()))

    def test_defaults(self):
        text = case_keys.keys(None)
        for row in (
            "| `frames` | integer | `50` |",
            "| `estimator` | [name](#values-of-estimator-in-contact) | `fibers` |",
            "| `check_cells` | `true`, `false` | `true` |",
            "| `exponent` | number | `1` |",
            "| `stiffness` | number | required |",
        ):
            self.assertIn(row, text)


if __name__ == "__main__":
    unittest.main()

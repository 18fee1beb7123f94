"""Figures in tables: python3 -m unittest discover benchmarks/results"""

import unittest

import fields
import pages
from recorded import Results

RESULTS = Results(
    {
        "wedge --variant soft": {
            "figures": {"force": 28.7952, "error": -0.00204, "small": 2.45e-13, "none": None, "zero": 0.0},
            "iterations": 1467,
            "contact_iterations": 2873,
            "checks": [{"name": "force", "reference": 30.0}, {"name": "error", "reference": 1.0}, {"name": "error", "reference": 2.0}],
        },
        "bar": {"figures": {}, "iterations": 540, "contact_iterations": 0},
    }
)


class Fields(unittest.TestCase):
    def written(self, quantity, run="wedge --variant soft"):
        return fields.filled(f"| {{{run}: {quantity}}} |", RESULTS)[2:-2]

    def test_numbers_are_written_as_on_the_pages(self):
        for quantity, text in [
            ("force: .2f", "28.80"),
            ("force", "28.8"),
            ("error: +.2%", "−0.20 %"),
            ("small: .0e", "2e-13"),
            ("small * -1e14: .1f", "−24.5"),
            ("force / 1e-3: ,.0f", "28 795"),
            ("force * 1e9: .1e", "2.9e10"),
            ("zero: .0e", "0"),
            ("force vs reference: +.1%", "−4.0 %"),
            ("force vs 28: +.1%", "+2.8 %"),
            ("force reference: .0f", "30"),
            ("iterations", "1 467 (2 873)"),
        ]:
            self.assertEqual(self.written(quantity), text)
        self.assertEqual(self.written("iterations", "bar"), "540")

    def test_what_is_not_recorded_is_an_error_that_names_it(self):
        for quantity, told in [
            ("none", "no figure 'none'"),
            ("speed", "it has force, error"),
            ("error vs reference", "2 references"),
            ("zero reference", "0 references"),
            ("force over 2", "no quantity"),
        ]:
            with self.assertRaisesRegex(ValueError, told):
                self.written(quantity)
        with self.assertRaisesRegex(ValueError, "no run 'cone'"):
            self.written("force", "cone")

    def test_text_without_fields_stays_as_it_is(self):
        self.assertEqual(fields.filled("a {b} c: d", RESULTS), "a {b} c: d")


class Pages(unittest.TestCase):
    def test_a_block_that_is_not_closed_is_found(self):
        page = pages.TABLES.parent / "test-page.md"
        page.write_text("<!-- begin: statics -->\n| 1 |\n", encoding="utf-8")
        self.addCleanup(page.unlink)
        with self.assertRaisesRegex(ValueError, "not closed"):
            pages.filled(page, RESULTS)

    def test_tables_ask_for_runs(self):
        self.assertGreater(len(pages.runs()), 50)
        self.assertEqual(fields.runs("{hertz: force: .1f} {cone --variant hex8: force}"), {"hertz", "cone --variant hex8"})


if __name__ == "__main__":
    unittest.main()

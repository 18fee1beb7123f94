"""Contact problems with known answers, solved by several codes, in one table and on one page.

problems/NAME.toml  ->  problem  ->  model (arrays)  ->  runners/CODE (a process)  ->  displacements
                        references                       figures  ->  results/CELL.json  ->  table, page
"""

"""The cases of fmc-contact in GetFEM, a program with contact of its own, on the same meshes in the same run.

    problem (of benchmarks/agreement)  ->  solid  ->  rigid | pair | tied  ->  solve     a process of its own
                                      measure  ->  table  ->  __main__     starts them in turn, and fmc
"""

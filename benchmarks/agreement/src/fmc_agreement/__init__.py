"""The cases of fmc-contact in several finite element programs: the same mesh, the same loads, and what came out of
it side by side.

    drivers/*       ->  problem, path, leapfrog, figures, outcome          agree  ->  outcome, reference, table
"""

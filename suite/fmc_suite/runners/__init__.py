"""One module for every code, run as ``python -m fmc_suite.runners.CODE MODEL.npz VARIANT OUT``, each in the environment of its code."""

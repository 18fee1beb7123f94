"""Errors of unsupported input."""


class LayoutError(TypeError):
    """Contact cannot read the unknowns of a variable as a displacement."""

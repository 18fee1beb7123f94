"""Errors of unsupported input."""


class LayoutError(TypeError):
    """Contact cannot read the degrees of freedom of a basis as a displacement."""

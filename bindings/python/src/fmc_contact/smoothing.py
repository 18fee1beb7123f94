"""Straight faces that represent round surfaces, for adapters."""

from __future__ import annotations

from .contact import Contact


class SmoothesSurfaces:
    """Part of an adapter, an object with a ``contact``: passes the smoothing of surfaces to it.

    Examples
    --------
    >>> SkfemContact(basis, stiffness=1e9).set_surface_smoothing(30.0)
    """

    contact: Contact

    def set_surface_smoothing(self, feature_angle: float) -> None:
        """Measures straight faces as the round surfaces that they represent. See ``Mesh.set_surface_smoothing``.

        Parameters
        ----------
        feature_angle : float
            In degrees, at least 0 and below 90. At a larger angle faces meet at an edge of the body: 30 is usual. 0 takes faces for flat,
            which is the default.

        Raises
        ------
        NotPositiveError
            If the angle is negative, NaN, or at least 90.
        UnsupportedError
            If the surface has no cells, or the mesh is in parts.

        Examples
        --------
        >>> contact.set_surface_smoothing(30.0)
        """
        self.contact.mesh.set_surface_smoothing(feature_angle)

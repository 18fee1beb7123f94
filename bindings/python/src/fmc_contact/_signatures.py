"""Functions of ``include/fmc_contact.h``: result and arguments of each. The tests compare the table with the header."""

from __future__ import annotations

from ctypes import CFUNCTYPE, POINTER, c_char_p, c_double, c_int32, c_size_t, c_uint32, c_void_p

import numpy as np

from ._structs import (
    ALL_GATHER,
    ALL_TO_ALL,
    fmc_augmentation,
    fmc_boundary_facet,
    fmc_cell_block,
    fmc_cell_block_i64,
    fmc_carried_slip,
    fmc_communicator,
    fmc_gathered_counts,
    fmc_contact_point,
    fmc_contact_step_options,
    fmc_contact_step_result,
    fmc_coords,
    fmc_facet_block,
    fmc_facet_block_i64,
    fmc_forces,
    fmc_friction_step,
    fmc_gap_constraint,
    fmc_multiplier,
    fmc_options,
    fmc_pair,
    fmc_pair_options,
    fmc_part,
    fmc_pose,
    fmc_mesh_part,
    fmc_rank_counts,
    fmc_result,
    fmc_resultant,
)


class _Array(c_void_p):
    """Pointer to the first entry of a numpy array of one dtype without gaps, or ``None`` for NULL."""

    dtype: np.dtype

    @classmethod
    def from_param(cls, array):
        if array is None:
            return None
        if array.dtype != cls.dtype or not array.flags.c_contiguous:
            raise TypeError(f"an array of dtype {cls.dtype} without gaps is wanted, not of {array.dtype}")
        return c_void_p(array.ctypes.data)


class Float64Array(_Array):
    dtype = np.dtype(np.float64)


class Int32Array(_Array):
    dtype = np.dtype(np.int32)


class Int64Array(_Array):
    dtype = np.dtype(np.int64)


class Context(c_void_p):
    """``fmc_context *``. A class of its own, so that ctypes neither unpacks nor mixes it up."""


class CondensationPointer(c_void_p):
    """``fmc_condensation *``."""


STATUS = c_int32
"""``fmc_status``."""

SIGNED_DISTANCE = CFUNCTYPE(c_int32, c_void_p, c_size_t, POINTER(c_double), POINTER(c_double), POINTER(c_double))
"""``fmc_signed_distance``."""

LOG = CFUNCTYPE(None, c_void_p, c_int32, c_char_p)
"""``fmc_log_callback``."""

PLACE = CFUNCTYPE(c_int32, c_void_p, c_size_t, POINTER(c_double), POINTER(c_double))
"""``fmc_place``."""

_COUNT = POINTER(c_size_t)
_NUMBER = POINTER(c_double)
_OPTIONS = POINTER(fmc_options)
_COORDS = POINTER(fmc_coords)
_POSE = POINTER(fmc_pose)
_HANDLE = POINTER(Context)

FUNCTIONS = {
    "fmc_version": (c_char_p, []),
    "fmc_abi_version": (c_int32, []),
    "fmc_has_feature": (c_int32, [c_char_p]),
    "fmc_status_name": (c_char_p, [c_int32]),
    "fmc_last_error": (c_char_p, []),
    "fmc_options_init": (STATUS, [_OPTIONS]),
    "fmc_options_set": (STATUS, [_OPTIONS, c_char_p, c_char_p]),
    "fmc_contact_force": (
        STATUS,
        [c_int32, Float64Array, c_size_t, c_int32, Int32Array, c_size_t, Int32Array, _OPTIONS, Float64Array, _NUMBER],
    ),
    "fmc_contact_force_i64": (
        STATUS,
        [c_int32, Float64Array, c_size_t, c_int32, Int64Array, c_size_t, Int64Array, _OPTIONS, Float64Array, _NUMBER],
    ),
    "fmc_friction_step_init": (STATUS, [POINTER(fmc_friction_step)]),
    "fmc_contact_force_step": (
        STATUS,
        [c_int32, Float64Array, c_size_t, c_int32, Int32Array, c_size_t, Int32Array, _OPTIONS]
        + [POINTER(fmc_friction_step), Float64Array, _NUMBER],
    ),
    "fmc_contact_force_step_i64": (
        STATUS,
        [c_int32, Float64Array, c_size_t, c_int32, Int64Array, c_size_t, Int64Array, _OPTIONS]
        + [POINTER(fmc_friction_step), Float64Array, _NUMBER],
    ),
    "fmc_context_new_from_cells": (
        STATUS,
        [c_int32, _COORDS, POINTER(fmc_cell_block), c_size_t, Int32Array, _OPTIONS, _HANDLE],
    ),
    "fmc_context_new_from_cells_i64": (
        STATUS,
        [c_int32, _COORDS, POINTER(fmc_cell_block_i64), c_size_t, Int64Array, _OPTIONS, _HANDLE],
    ),
    "fmc_context_new_from_facets": (
        STATUS,
        [c_int32, _COORDS, Int32Array, c_size_t, Int32Array, _OPTIONS, _HANDLE],
    ),
    "fmc_context_new_from_facets_i64": (
        STATUS,
        [c_int32, _COORDS, Int64Array, c_size_t, Int64Array, _OPTIONS, _HANDLE],
    ),
    "fmc_context_new_from_facet_blocks": (
        STATUS,
        [c_int32, _COORDS, POINTER(fmc_facet_block), c_size_t, Int32Array, _OPTIONS, _HANDLE],
    ),
    "fmc_context_new_from_facet_blocks_i64": (
        STATUS,
        [c_int32, _COORDS, POINTER(fmc_facet_block_i64), c_size_t, Int64Array, _OPTIONS, _HANDLE],
    ),
    "fmc_context_free": (STATUS, [_HANDLE]),
    "fmc_context_set_options": (STATUS, [Context, _OPTIONS]),
    "fmc_context_set_log": (STATUS, [Context, LOG, c_void_p]),
    "fmc_context_counts": (STATUS, [Context, _COUNT, _COUNT, _COUNT]),
    "fmc_context_boundary_facets": (STATUS, [Context, POINTER(fmc_boundary_facet), c_size_t]),
    "fmc_context_point_weights_size": (STATUS, [Context, _COUNT, _COUNT]),
    "fmc_context_point_weights": (STATUS, [Context, Int64Array, c_size_t, Int64Array, Float64Array, c_size_t]),
    "fmc_context_set_basis": (STATUS, [Context, c_size_t, Int64Array, Int64Array, Float64Array, c_size_t]),
    "fmc_context_evaluate": (STATUS, [Context, _COORDS, POINTER(fmc_forces), c_uint32, POINTER(fmc_result)]),
    "fmc_context_error": (c_char_p, [Context]),
    "fmc_context_set_reference": (STATUS, [Context, _COORDS]),
    "fmc_context_set_symmetry_nodes": (STATUS, [Context, Int64Array, c_size_t]),
    "fmc_context_keep_patches": (STATUS, [Context, _COORDS, _COUNT]),
    "fmc_context_begin_step": (STATUS, [Context, _COORDS]),
    "fmc_context_commit_step": (STATUS, [Context, _COORDS]),
    "fmc_context_freeze_friction": (STATUS, [Context, _COORDS]),
    "fmc_context_slip": (STATUS, [Context, Float64Array, c_size_t]),
    "fmc_context_set_slip": (STATUS, [Context, Float64Array, c_size_t]),
    "fmc_context_tangent": (STATUS, [Context, _COORDS, c_uint32, _COUNT, _COUNT]),
    "fmc_context_tangent_entries": (STATUS, [Context, Int32Array, Int32Array, Float64Array, c_size_t]),
    "fmc_context_tangent_product": (STATUS, [Context, Float64Array, Float64Array, c_size_t]),
    "fmc_context_tangent_rank_one": (STATUS, [Context, c_size_t, _NUMBER, Float64Array, c_size_t]),
    "fmc_context_tangent_csr_size": (STATUS, [Context, c_uint32, _COUNT, _COUNT]),
    "fmc_context_tangent_csr": (STATUS, [Context, c_uint32, Int32Array, Int32Array, Float64Array, c_size_t]),
    "fmc_context_tangent_csr_i64": (STATUS, [Context, c_uint32, Int64Array, Int64Array, Float64Array, c_size_t]),
    "fmc_context_keep_pattern": (STATUS, [Context, c_int32]),
    "fmc_context_set_obstacle_rotations": (STATUS, [Context, c_int32]),
    "fmc_context_evaluate_tangent": (
        STATUS,
        [Context, _COORDS, c_uint32, POINTER(fmc_forces), POINTER(fmc_result), _COUNT, _COUNT],
    ),
    "fmc_context_stable_step": (STATUS, [Context, _COORDS, Float64Array, _NUMBER]),
    "fmc_communicator_init": (STATUS, [POINTER(fmc_communicator)]),
    "fmc_context_set_communicator": (STATUS, [Context, POINTER(fmc_communicator)]),
    "fmc_context_rank_counts": (STATUS, [Context, POINTER(fmc_rank_counts)]),
    "fmc_context_new_from_part": (
        STATUS,
        [c_int32, POINTER(fmc_communicator), POINTER(fmc_mesh_part), POINTER(fmc_options), POINTER(Context)],
    ),
    "fmc_context_bring": (STATUS, [Context, POINTER(fmc_coords), POINTER(c_int32)]),
    "fmc_context_gathered_counts": (STATUS, [Context, POINTER(fmc_gathered_counts)]),
    "fmc_context_gathered_nodes": (STATUS, [Context, Int64Array, Int32Array, Float64Array, c_size_t]),
    "fmc_context_gathered_cells": (STATUS, [Context, Int64Array, c_size_t]),
    "fmc_context_carried_slip": (STATUS, [Context, POINTER(fmc_carried_slip), c_size_t, POINTER(c_size_t)]),
    "fmc_context_set_carried_slip": (STATUS, [Context, POINTER(fmc_carried_slip), c_size_t]),
    "fmc_contact_step_options_init": (STATUS, [POINTER(fmc_contact_step_options)]),
    "fmc_context_contact_step": (
        STATUS,
        [Context, _COORDS, POINTER(fmc_contact_step_options), Int64Array, c_size_t, Int64Array, c_size_t]
        + [Float64Array, Float64Array, PLACE, c_void_p, Float64Array, POINTER(fmc_contact_step_result)],
    ),
    "fmc_condensation_new": (STATUS, [POINTER(CondensationPointer)]),
    "fmc_condensation_free": (STATUS, [POINTER(CondensationPointer)]),
    "fmc_condensation_factorise": (
        STATUS,
        [CondensationPointer, c_size_t, Int64Array, Int64Array, Float64Array, Int64Array, c_size_t],
    ),
    "fmc_condensation_complement": (STATUS, [CondensationPointer, Float64Array, c_size_t]),
    "fmc_condensation_condense": (STATUS, [CondensationPointer, Float64Array, c_size_t, Float64Array, c_size_t]),
    "fmc_condensation_expand": (
        STATUS,
        [CondensationPointer, Float64Array, c_size_t, Float64Array, c_size_t, Float64Array, c_size_t],
    ),
    "fmc_context_body": (STATUS, [Context, c_size_t, POINTER(fmc_resultant)]),
    "fmc_context_obstacle": (STATUS, [Context, c_size_t, POINTER(fmc_resultant)]),
    "fmc_context_pair": (STATUS, [Context, c_size_t, POINTER(fmc_pair)]),
    "fmc_context_warning": (STATUS, [Context, c_size_t, POINTER(c_int32), POINTER(c_char_p)]),
    "fmc_pair_options_init": (STATUS, [POINTER(fmc_pair_options)]),
    "fmc_context_set_pair_options": (
        STATUS,
        [Context, c_int32, c_size_t, c_int32, c_size_t, POINTER(fmc_pair_options)],
    ),
    "fmc_context_pair_options": (
        STATUS,
        [Context, c_int32, c_size_t, c_int32, c_size_t, POINTER(fmc_pair_options)],
    ),
    "fmc_context_nodal_contact": (
        STATUS,
        [Context, _COORDS, *[Float64Array] * 6, Int32Array, c_size_t],
    ),
    "fmc_context_find_contact_points": (STATUS, [Context, _COORDS, _COUNT]),
    "fmc_context_contact_points": (STATUS, [Context, POINTER(fmc_contact_point), c_size_t]),
    "fmc_context_find_gap_constraints": (STATUS, [Context, _COORDS, c_double, _COUNT, _COUNT]),
    "fmc_context_augment": (STATUS, [Context, _COORDS, c_double, c_double, POINTER(fmc_augmentation)]),
    "fmc_context_stiffen": (STATUS, [Context, c_double]),
    "fmc_context_multipliers": (STATUS, [Context, POINTER(fmc_multiplier), c_size_t, _COUNT]),
    "fmc_context_set_multipliers": (STATUS, [Context, POINTER(fmc_multiplier), c_size_t]),
    "fmc_context_gap_constraints": (STATUS, [Context, POINTER(fmc_gap_constraint), c_size_t]),
    "fmc_context_gap_gradient": (STATUS, [Context, Int64Array, Int64Array, Float64Array, c_size_t]),
    "fmc_pose_init": (STATUS, [_POSE]),
    "fmc_pose_along": (STATUS, [c_int32, Float64Array, Float64Array, _POSE]),
    "fmc_context_add_half_space": (STATUS, [Context, _POSE, _COUNT]),
    "fmc_context_add_ball": (STATUS, [Context, c_double, _POSE, _COUNT]),
    "fmc_context_add_cuboid": (STATUS, [Context, Float64Array, _POSE, _COUNT]),
    "fmc_context_add_cylinder": (STATUS, [Context, c_double, c_double, _POSE, _COUNT]),
    "fmc_context_add_cone": (STATUS, [Context, c_double, c_double, _POSE, _COUNT]),
    "fmc_context_add_capsule": (STATUS, [Context, c_double, c_double, _POSE, _COUNT]),
    "fmc_context_add_polytope": (STATUS, [Context, _COORDS, Int32Array, c_size_t, _POSE, _COUNT]),
    "fmc_context_add_polytope_i64": (STATUS, [Context, _COORDS, Int64Array, c_size_t, _POSE, _COUNT]),
    "fmc_context_add_convex_hull": (STATUS, [Context, _COORDS, _POSE, _COUNT]),
    "fmc_context_add_height_field": (
        STATUS,
        [Context, _COUNT, Float64Array, Float64Array, c_double, _POSE, _COUNT],
    ),
    "fmc_part_init": (STATUS, [POINTER(fmc_part)]),
    "fmc_context_add_compound": (STATUS, [Context, POINTER(fmc_part), c_size_t, _POSE, _COUNT]),
    "fmc_context_add_signed_distance": (STATUS, [Context, SIGNED_DISTANCE, c_void_p, _POSE, _COUNT]),
    "fmc_context_obstacle_shape": (STATUS, [Context, c_size_t, POINTER(c_int32), _POSE]),
    "fmc_context_set_pose": (STATUS, [Context, c_size_t, _POSE]),
    "fmc_context_remove_obstacle": (STATUS, [Context, c_size_t]),
    "fmc_suggest_fiber_stiffness": (STATUS, [c_double, c_double, _NUMBER]),
    "fmc_suggest_stiffness_from_modulus": (STATUS, [c_int32, c_double, c_double, c_double, _NUMBER]),
    "fmc_suggest_stiffness_from_pressure": (STATUS, [c_int32, c_double, c_double, c_double, _NUMBER]),
}
"""Result and argument types by name."""

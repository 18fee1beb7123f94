"""Structs and callbacks of ``include/fmc_contact.h``, under the names that they have there.

Generated from the header by ``make header``; do not edit.
"""

from __future__ import annotations

from ctypes import (
    CFUNCTYPE,
    POINTER,
    Structure,
    c_char_p,
    c_double,
    c_int32,
    c_int64,
    c_size_t,
    c_ssize_t,
    c_uint32,
    c_uint64,
    c_void_p,
)


class fmc_context(c_void_p):
    """``fmc_context *``"""


class fmc_equilibrium(c_void_p):
    """``fmc_equilibrium *``"""


class fmc_condensation(c_void_p):
    """``fmc_condensation *``"""


fmc_log_callback = CFUNCTYPE(None, c_void_p, c_int32, c_char_p)

fmc_interrupt_callback = CFUNCTYPE(c_int32, c_void_p)

fmc_signed_distance = CFUNCTYPE(c_int32, c_void_p, c_size_t, POINTER(c_double), POINTER(c_double), POINTER(c_double))

fmc_respond = CFUNCTYPE(c_int32, c_void_p, c_void_p, c_void_p)

fmc_limit_friction = CFUNCTYPE(c_int32, c_void_p, c_void_p, c_void_p)

fmc_place = CFUNCTYPE(c_int32, c_void_p, c_size_t, POINTER(c_double), POINTER(c_double))

fmc_all_gather = CFUNCTYPE(c_int32, c_void_p, c_void_p, POINTER(c_uint64), c_void_p)

fmc_all_to_all = CFUNCTYPE(c_int32, c_void_p, c_void_p, POINTER(c_uint64), c_void_p, POINTER(c_uint64))


class fmc_options(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("stiffness", c_double),
        ("exponent", c_double),
        ("spacing", c_double),
        ("fiber_length", c_double),
        ("fiber_count", c_uint64),
        ("seed", c_uint64),
        ("law", c_int32),
        ("estimator", c_int32),
        ("pattern", c_int32),
        ("weights", c_int32),
        ("momentum_correction", c_int32),
        ("self_contact", c_int32),
        ("check_cells", c_int32),
        ("threads", c_int32),
        ("index_base", c_int32),
        ("axisymmetric", c_int32),
        ("smoothing_length", c_double),
        ("friction_coefficient", c_double),
        ("friction_stiffness", c_double),
        ("cohesion", c_double),
        ("shear_limit", c_double),
        ("memoryless_slip", c_double),
        ("static_coefficient", c_double),
        ("weakening_slip", c_double),
        ("weld", c_double),
        ("reserved", c_uint64 * 7),
    ]


class fmc_coords(Structure):
    _fields_ = [
        ("data", c_void_p),
        ("node_count", c_size_t),
        ("node_stride", c_ssize_t),
        ("axis_stride", c_ssize_t),
    ]


class fmc_forces(Structure):
    _fields_ = [
        ("data", c_void_p),
        ("node_count", c_size_t),
        ("node_stride", c_ssize_t),
        ("axis_stride", c_ssize_t),
    ]


class fmc_cell_block(Structure):
    _fields_ = [
        ("cell_type", c_int32),
        ("index_size", c_int32),
        ("conn", c_void_p),
        ("cell_count", c_size_t),
    ]


class fmc_facet_block(Structure):
    _fields_ = [
        ("facet_type", c_int32),
        ("index_size", c_int32),
        ("conn", c_void_p),
        ("facet_count", c_size_t),
    ]


class fmc_csr(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("row_count", c_size_t),
        ("index_size", c_int32),
        ("index_base", c_int32),
        ("row_offsets", c_void_p),
        ("cols", c_void_p),
        ("values", c_void_p),
        ("reserved", c_uint64 * 4),
    ]


class fmc_pose(Structure):
    _fields_ = [
        ("position", c_double * 3),
        ("rotation", c_double * 9),
        ("scale", c_double),
    ]


class fmc_shape(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("kind", c_int32),
        ("index_size", c_int32),
        ("radius", c_double),
        ("half_height", c_double),
        ("half_extents", c_double * 3),
        ("points", fmc_coords),
        ("facets", c_void_p),
        ("facet_count", c_size_t),
        ("heights", c_void_p),
        ("counts", c_size_t * 2),
        ("lengths", c_double * 2),
        ("thickness", c_double),
        ("parts", c_void_p),
        ("part_count", c_size_t),
        ("signed_distance", fmc_signed_distance),
        ("user", c_void_p),
        ("reserved", c_uint64 * 8),
    ]


class fmc_part(Structure):
    _fields_ = [
        ("shape", POINTER(fmc_shape)),
        ("pose", fmc_pose),
    ]


class fmc_pair_options(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("stiffness", c_double),
        ("exponent", c_double),
        ("smoothing_length", c_double),
        ("gap_offset", c_double),
        ("friction_coefficient", c_double),
        ("law", c_int32),
        ("excluded", c_int32),
        ("static_coefficient", c_double),
        ("weakening_slip", c_double),
        ("interface_kind", c_int32),
        ("softening", c_int32),
        ("reach", c_double),
        ("normal_strength", c_double),
        ("shear_strength", c_double),
        ("normal_energy", c_double),
        ("shear_energy", c_double),
        ("mixed_mode_exponent", c_double),
        ("surface_a", c_int32),
        ("surface_b", c_int32),
        ("viscosity", c_double),
        ("reserved", c_uint64 * 3),
    ]


class fmc_orthotropic_friction(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("transverse_coefficient", c_double),
        ("direction", c_double * 3),
        ("direction_of", c_int32),
        ("unused", c_int32),
        ("reserved", c_uint64 * 4),
    ]


class fmc_ppr(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("normal_shape", c_double),
        ("shear_shape", c_double),
        ("normal_slope", c_double),
        ("shear_slope", c_double),
        ("reserved", c_uint64 * 4),
    ]


class fmc_law_points(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("count", c_size_t),
        ("dim", c_size_t),
        ("history_count", c_size_t),
        ("body", c_size_t),
        ("partner", c_size_t),
        ("time_step", c_double),
        ("jump", c_void_p),
        ("axes", c_void_p),
        ("position", c_void_p),
        ("reference", c_void_p),
        ("area", c_void_p),
        ("history", c_void_p),
        ("field_count", c_size_t),
        ("fields", c_void_p),
        ("reserved", c_uint64 * 4),
    ]


class fmc_law_response(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("traction", c_void_p),
        ("tangent", c_void_p),
        ("history", c_void_p),
        ("stored", c_void_p),
        ("dissipated", c_void_p),
        ("reserved", c_uint64 * 4),
    ]


class fmc_own_law(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("history_count", c_size_t),
        ("respond", fmc_respond),
        ("user", c_void_p),
        ("reserved", c_uint64 * 4),
    ]


class fmc_friction_facets(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("count", c_size_t),
        ("dim", c_size_t),
        ("history_count", c_size_t),
        ("body", c_size_t),
        ("partner", c_size_t),
        ("partner_kind", c_int32),
        ("unused", c_int32),
        ("time_step", c_double),
        ("stiffness", c_double),
        ("facet", c_void_p),
        ("pressure", c_void_p),
        ("slip", c_void_p),
        ("trial", c_void_p),
        ("axes", c_void_p),
        ("position", c_void_p),
        ("area", c_void_p),
        ("history", c_void_p),
        ("field_count", c_size_t),
        ("fields", c_void_p),
        ("reserved", c_uint64 * 4),
    ]


class fmc_friction_response(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("limit", c_void_p),
        ("by_pressure", c_void_p),
        ("by_slip", c_void_p),
        ("history", c_void_p),
        ("reserved", c_uint64 * 4),
    ]


class fmc_friction_law(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("history_count", c_size_t),
        ("limit", fmc_limit_friction),
        ("user", c_void_p),
        ("reserved", c_uint64 * 4),
    ]


class fmc_result(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("volume", c_double),
        ("volume_standard_error", c_double),
        ("energy", c_double),
        ("contact_area", c_double),
        ("penetration", c_double),
        ("fiber_count", c_size_t),
        ("crossing_count", c_size_t),
        ("facet_count", c_size_t),
        ("pair_count", c_size_t),
        ("body_count", c_size_t),
        ("obstacle_count", c_size_t),
        ("warning_count", c_size_t),
        ("friction_energy", c_double),
        ("friction_dissipation", c_double),
        ("stick_area", c_double),
        ("slip_area", c_double),
        ("largest_slip", c_double),
        ("reserved", c_uint64 * 3),
    ]


class fmc_resultant(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("id", c_int64),
        ("force", c_double * 3),
        ("moment", c_double * 3),
        ("node_count", c_size_t),
        ("friction", c_double * 3),
        ("reserved", c_uint64 * 4),
    ]


class fmc_pair_result(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("a_kind", c_int32),
        ("b_kind", c_int32),
        ("a", c_size_t),
        ("b", c_size_t),
        ("volume", c_double),
        ("volume_standard_error", c_double),
        ("energy", c_double),
        ("pressure", c_double),
        ("contact_area", c_double),
        ("penetration", c_double),
        ("spacing", c_double),
        ("friction_energy", c_double),
        ("friction_dissipation", c_double),
        ("stick_area", c_double),
        ("slip_area", c_double),
        ("force", c_double * 3),
        ("reserved", c_uint64 * 4),
    ]


class fmc_step_limit(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("part", c_double),
        ("first_touch", c_double),
        ("reserved", c_uint64 * 4),
    ]


class fmc_adjustment(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("closed", c_double),
        ("removed", c_double),
        ("left", c_double),
        ("count", c_size_t),
        ("reserved", c_uint64 * 4),
    ]


class fmc_augmentation(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("penetration", c_double),
        ("change", c_double),
        ("multiplier_count", c_size_t),
        ("is_converged", c_int32),
        ("reserved_flags", c_int32),
        ("reserved", c_uint64 * 4),
    ]


class fmc_multiplier(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("node", c_int64),
        ("body", c_size_t),
        ("partner_kind", c_int32),
        ("reserved_flags", c_int32),
        ("partner", c_size_t),
        ("shift", c_double),
        ("towards", c_double * 3),
        ("reserved", c_uint64 * 4),
    ]


class fmc_equilibrium_options(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("tolerance", c_double),
        ("max_solves", c_size_t),
        ("penetration", c_double),
        ("reach", c_double),
        ("max_updates", c_size_t),
        ("condensed", c_int32),
        ("lagged", c_int32),
        ("find_patches", c_int32),
        ("check", c_int32),
        ("straight_slip", c_int32),
        ("reserved_flags", c_uint32),
        ("reserved", c_uint64 * 4),
    ]


class fmc_equilibrium_problem(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("unknown_count", c_size_t),
        ("row_count", c_size_t),
        ("unknown_of_coordinate", c_void_p),
        ("base", c_void_p),
        ("free", c_void_p),
        ("x", c_void_p),
        ("prescribed", c_void_p),
        ("reserved", c_uint64 * 4),
    ]


class fmc_equilibrium_answer(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("vector", c_void_p),
        ("refusal", c_void_p),
        ("energy", c_void_p),
        ("definite", c_int32),
        ("reserved_flags", c_uint32),
        ("reserved", c_uint64 * 4),
    ]


class fmc_equilibrium_request(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("kind", c_int32),
        ("matrix", c_int32),
        ("magnitudes", c_int32),
        ("tangent_flags", c_uint32),
        ("x", c_void_p),
        ("vector", c_void_p),
        ("forces", c_void_p),
        ("shift", c_double),
        ("tolerance", c_double),
        ("absolute_tolerance", c_double),
        ("reserved", c_uint64 * 4),
    ]


class fmc_equilibrium_result(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("way", c_int32),
        ("unheld", c_int32),
        ("x", c_void_p),
        ("reactions", c_void_p),
        ("residuals", c_void_p),
        ("residual_count", c_size_t),
        ("solve_count", c_size_t),
        ("rigid_step_count", c_size_t),
        ("part_count", c_size_t),
        ("loose_count", c_size_t),
        ("update_count", c_size_t),
        ("text_count", c_size_t),
        ("penetration", c_double),
        ("unheld_body", c_int64),
        ("unheld_direction", c_double * 3),
        ("first_touch_count", c_size_t),
        ("reserved", c_uint64 * 5),
    ]


class fmc_contact_step_options(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("tolerance", c_double),
        ("absolute_tolerance", c_double),
        ("full_below", c_double),
        ("max_iterations", c_int32),
        ("max_trials", c_int32),
        ("soft_start", c_int32),
        ("reserved_flags", c_int32),
        ("reserved", c_uint64 * 7),
    ]


class fmc_contact_step_result(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("state", c_int32),
        ("iterations", c_int32),
        ("evaluation_count", c_size_t),
        ("outside_count", c_size_t),
        ("residual_at_start", c_double),
        ("residual", c_double),
        ("scale", c_double),
        ("reserved", c_uint64 * 8),
    ]


class fmc_nodal_contact(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("pressure", c_void_p),
        ("gap", c_void_p),
        ("area", c_void_p),
        ("normal", c_void_p),
        ("friction", c_void_p),
        ("sliding", c_void_p),
        ("status", c_void_p),
        ("local_pressure", c_void_p),
        ("reserved", c_uint64 * 8),
    ]


class fmc_contact_side(Structure):
    _fields_ = [
        ("kind", c_int32),
        ("node_count", c_int32),
        ("index", c_size_t),
        ("cell", c_int64),
        ("nodes", c_int64 * 8),
        ("weights", c_double * 8),
        ("position", c_double * 3),
    ]


class fmc_contact_point(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("patch", c_size_t),
        ("position", c_double * 3),
        ("normal", c_double * 3),
        ("gap", c_double),
        ("pressure", c_double),
        ("area", c_double),
        ("friction", c_double * 3),
        ("slip", c_double * 3),
        ("sliding", c_double),
        ("sides", fmc_contact_side * 2),
        ("reserved", c_uint64 * 8),
    ]


class fmc_gap_constraint(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("node", c_int64),
        ("body", c_size_t),
        ("partner_kind", c_int32),
        ("reserved_flags", c_int32),
        ("partner", c_size_t),
        ("gap", c_double),
        ("area", c_double),
        ("reserved", c_uint64 * 4),
    ]


class fmc_tie(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("area", c_double),
        ("largest_gap", c_double),
        ("node_count", c_size_t),
        ("reach", c_double),
        ("reserved", c_uint64 * 3),
    ]


class fmc_tie_node(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("node", c_int64),
        ("body", c_size_t),
        ("partner", c_size_t),
        ("area", c_double),
        ("traction", c_double * 3),
        ("jump", c_double * 3),
        ("reserved", c_uint64 * 4),
    ]


class fmc_conductance(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("pressure_count", c_size_t),
        ("pressures", c_void_p),
        ("by_pressure", c_void_p),
        ("gap_count", c_size_t),
        ("gaps", c_void_p),
        ("by_gap", c_void_p),
        ("reserved", c_uint64 * 8),
    ]


class fmc_cohesive(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("area", c_double),
        ("largest_gap", c_double),
        ("point_count", c_size_t),
        ("stored", c_double),
        ("dissipated", c_double),
        ("damaged_area", c_double),
        ("broken_area", c_double),
        ("rubbed", c_double),
        ("viscous", c_double),
        ("reserved", c_uint64 * 3),
    ]


class fmc_cohesive_point(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("body", c_size_t),
        ("partner", c_size_t),
        ("position", c_double * 3),
        ("area", c_double),
        ("opening", c_double),
        ("sliding", c_double * 3),
        ("traction", c_double * 3),
        ("damage", c_double),
        ("dissipated", c_double),
        ("rubbed", c_double),
        ("viscous", c_double),
        ("reserved", c_uint64 * 3),
    ]


class fmc_law_point(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("body", c_size_t),
        ("partner", c_size_t),
        ("position", c_double * 3),
        ("area", c_double),
        ("axes", c_double * 9),
        ("jump", c_double * 3),
        ("traction", c_double * 3),
        ("stored", c_double),
        ("dissipated", c_double),
        ("reserved", c_uint64 * 4),
    ]


class fmc_boundary_facet(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("body", c_size_t),
        ("cell", c_int64),
        ("input_facet", c_int64),
        ("local_face", c_int32),
        ("node_count", c_int32),
        ("nodes", c_int64 * 4),
        ("reserved", c_uint64 * 4),
    ]


class fmc_gradients(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("coords", c_void_p),
        ("reference", c_void_p),
        ("positions", c_void_p),
        ("rotations", c_void_p),
        ("of_pairs", c_uint64),
        ("slip_adjoint", c_void_p),
        ("slip_adjoint_count", c_size_t),
        ("slip", c_void_p),
        ("slip_capacity", c_size_t),
        ("slip_count", c_void_p),
        ("reserved", c_uint64 * 3),
    ]


class fmc_pair_gradient(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("a_kind", c_int32),
        ("b_kind", c_int32),
        ("a", c_size_t),
        ("b", c_size_t),
        ("stiffness", c_double),
        ("gap_offset", c_double),
        ("friction", c_double),
        ("reserved", c_uint64 * 4),
    ]


class fmc_directions(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("coords", c_void_p),
        ("positions", c_void_p),
        ("rotations", c_void_p),
        ("stiffness", c_double),
        ("gap_offset", c_double),
        ("friction", c_double),
        ("pairs", POINTER(fmc_pair_gradient)),
        ("pair_count", c_size_t),
        ("slip", c_void_p),
        ("slip_count", c_size_t),
        ("reserved", c_uint64 * 4),
    ]


class fmc_communicator(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("rank", c_int32),
        ("size", c_int32),
        ("all_gather", fmc_all_gather),
        ("user", c_void_p),
        ("all_to_all", fmc_all_to_all),
        ("reserved", c_uint64 * 5),
    ]


class fmc_rank_counts(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("item_count", c_uint64),
        ("own_item_count", c_uint64),
        ("call_count", c_uint64),
        ("sent_bytes", c_uint64),
        ("received_bytes", c_uint64),
        ("reserved", c_uint64 * 4),
    ]


class fmc_mesh_part(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("coords", fmc_coords),
        ("index_size", c_int32),
        ("reserved_flags", c_int32),
        ("node_numbers", c_void_p),
        ("blocks", POINTER(fmc_cell_block)),
        ("block_count", c_size_t),
        ("cell_numbers", c_void_p),
        ("body_ids", c_void_p),
        ("reach", c_double),
        ("reserved", c_uint64 * 4),
    ]


class fmc_carried_slip(Structure):
    _fields_ = [
        ("cell", c_int64),
        ("face", c_int32),
        ("part", c_int32),
        ("partner_kind", c_int32),
        ("is_second", c_int32),
        ("partner", c_size_t),
        ("slip", c_double * 3),
        ("slid", c_double),
    ]


class fmc_gathered_counts(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("node_count", c_uint64),
        ("cell_count", c_uint64),
        ("facet_count", c_uint64),
        ("whole_facet_count", c_uint64),
        ("own_cell_count", c_uint64),
        ("gather_count", c_uint64),
        ("reserved", c_uint64 * 4),
    ]


class fmc_friction_step(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("start", c_void_p),
        ("reference", c_void_p),
        ("slip", c_void_p),
        ("slip_count", c_size_t),
        ("next_slip", c_void_p),
        ("next_slip_capacity", c_size_t),
        ("next_slip_count", c_void_p),
        ("reserved", c_uint64 * 8),
    ]

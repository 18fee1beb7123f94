"""Kratos' mortar contact with an augmented Lagrangian (ContactStructuralMechanicsApplication), its parameters left at their defaults."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import KratosMultiphysics as Kratos
import numpy as np
from KratosMultiphysics import ContactStructuralMechanicsApplication, StructuralMechanicsApplication  # noqa: F401
from KratosMultiphysics.StructuralMechanicsApplication.structural_mechanics_analysis import StructuralMechanicsAnalysis

from . import common

CONTACT = "KratosMultiphysics.ContactStructuralMechanicsApplication"
ITERATIONS, WIDE = 60, 20.0


def _block(name: str, lines: list[str], words: str = "") -> list[str]:
    return [f"Begin {name} {words}", *lines, f"End {name}", ""]


def _numbers(numbers: np.ndarray) -> list[str]:
    return [str(int(number) + 1) for number in numbers]


def _part(name: str, nodes: np.ndarray, cells: np.ndarray, conditions: np.ndarray) -> list[str]:
    lines = _block("SubModelPartNodes", _numbers(nodes))
    lines += _block("SubModelPartElements", _numbers(cells)) + _block("SubModelPartConditions", _numbers(conditions))
    return _block("SubModelPart", lines, name)


def _mesh(model: common.Model) -> str:
    """The bodies, a condition for every node that is loaded, and the sides that may touch, as an mdpa file."""
    text = [*_block("ModelPartData", []), *_block("Properties", [], "0")]
    for number in range(len(model.cells)):
        text += _block("Properties", [], str(number + 1))
    coords = np.zeros((len(model.points), 3))
    coords[:, : model.dim] = model.points
    text += _block("Nodes", [f"{i + 1} {x!r} {y!r} {z!r}" for i, (x, y, z) in enumerate(coords.tolist())])
    element, first, parts = {2: "SmallDisplacementElement2D4N", 3: "SmallDisplacementElement3D8N"}[model.dim], 0, []
    none = np.empty(0, int)
    for number, cells in enumerate(model.cells):
        rows = [f"{first + e + 1} {number + 1} {' '.join(_numbers(cell))}" for e, cell in enumerate(cells)]
        text += _block("Elements", rows, element)
        nodes = np.arange(*model.firsts[number : number + 2])
        parts += _part(f"Body_{number}", nodes, np.arange(first, first + len(cells)), none)
        first += len(cells)
    loaded = np.flatnonzero(model.loads.any(axis=(0, 2)))
    text += _block("Conditions", [f"{c + 1} 0 {node + 1}" for c, node in enumerate(loaded)], f"PointLoadCondition{model.dim}D1N")
    parts += _part("Loaded", loaded, none, np.arange(len(loaded)))
    for number, (slave, master) in enumerate(model.pairs):
        parts += _part(f"Slave_{number}", np.unique(slave), none, none) + _part(f"Master_{number}", np.unique(master), none, none)
    return "\n".join([*text, *parts])


def _contact(model: common.Model, variant: str) -> dict[str, Any]:
    numbers = [str(number) for number in range(len(model.pairs))]
    sides = {number: [f"Slave_{number}", f"Master_{number}"] for number in numbers}
    slaves = {number: [f"Slave_{number}"] for number in numbers}
    words: dict[str, Any] = {"model_part_name": "Structure", "assume_master_slave": slaves}
    if variant == "wide search":
        words["search_parameters"] = {"search_factor": WIDE}
    if model.tied:
        words |= {"mesh_tying_model_part": sides}
        return {"python_module": "mesh_tying_process", "kratos_module": CONTACT, "Parameters": words}
    words |= {"contact_model_part": sides, "contact_type": "Frictional" if model.friction else "Frictionless"}
    if model.friction:
        words["friction_coefficients"] = dict.fromkeys(numbers, model.friction)
    return {"python_module": "alm_contact_process", "kratos_module": CONTACT, "Parameters": words}


def _parameters(model: common.Model, variant: str) -> dict[str, Any]:
    kind = "ComponentsMeshTying" if model.tied else "ALMContactFrictional" if model.friction else "ALMContactFrictionless"
    law = {2: "LinearElasticPlaneStrain2DLaw", 3: "LinearElastic3DLaw"}[model.dim]
    materials = [
        {
            "model_part_name": f"Structure.Body_{number}",
            "properties_id": number + 1,
            "Material": {
                "constitutive_law": {"name": law},
                "Variables": {"DENSITY": 1.0, "YOUNG_MODULUS": young, "POISSON_RATIO": poisson, "THICKNESS": 1.0},
            },
        }
        for number, (young, poisson) in enumerate(model.materials.tolist())
    ]
    Path("materials.json").write_text(json.dumps({"properties": materials}))
    solver = {
        "model_part_name": "Structure",
        "domain_size": model.dim,
        "solver_type": "Static",
        "echo_level": 0,
        "analysis_type": "non_linear",
        "model_import_settings": {"input_type": "mdpa", "input_filename": "mesh"},
        "material_import_settings": {"materials_filename": "materials.json"},
        "time_stepping": {"time_step": 1.0},
        "contact_settings": {"mortar_type": kind},
        "clear_storage": True,
        "reform_dofs_at_each_step": True,
        "convergence_criterion": "contact_residual_criterion",
        # Of Kratos' own tests with friction; without it tighter, which costs no iterations.
        "residual_relative_tolerance": 1e-4 if model.friction else 1e-8,
        "residual_absolute_tolerance": 1e-9,
        "buffer_size": 3,
        "max_iteration": ITERATIONS,
        "linear_solver_settings": {"solver_type": "LinearSolversApplication.sparse_lu"},
    }
    data = {"problem_name": "suite", "parallel_type": "OpenMP", "start_time": 0.0, "end_time": model.steps - 0.01, "echo_level": 0}
    processes = {"constraints_process_list": [], "loads_process_list": [], "contact_process_list": [_contact(model, variant)]}
    return {"problem_data": data, "solver_settings": solver, "processes": processes, "output_processes": {}}


def _set(part: Any, model: common.Model, step: int) -> None:
    """Held displacements and loads of a load step."""
    axes = (Kratos.DISPLACEMENT_X, Kratos.DISPLACEMENT_Y, Kratos.DISPLACEMENT_Z)
    for point, axis in np.argwhere(model.fixed):
        node = part.Nodes[int(point) + 1]
        node.Fix(axes[axis])
        node.SetSolutionStepValue(axes[axis], float(model.prescribed[step, point, axis]))
    for point in np.flatnonzero(model.loads.any(axis=(0, 2))):
        load = np.zeros(3)
        load[: model.dim] = model.loads[step, point]
        part.Nodes[int(point) + 1].SetSolutionStepValue(StructuralMechanicsApplication.POINT_LOAD, Kratos.Array3(load.tolist()))


def solve(model: common.Model, variant: str) -> tuple[np.ndarray, int]:
    Kratos.Logger.GetDefaultOutput().SetSeverity(Kratos.Logger.Severity.WARNING)
    if variant == "other slave":
        model.pairs = [(master, slave) for slave, master in model.pairs]
    Path("mesh.mdpa").write_text(_mesh(model))
    kratos = Kratos.Model()
    analysis = StructuralMechanicsAnalysis(kratos, Kratos.Parameters(json.dumps(_parameters(model, variant))))
    analysis.Initialize()
    part, solver = kratos["Structure"], analysis._GetSolver()
    found, iterations = [], 0
    for step in range(model.steps):
        analysis.time = analysis._AdvanceTime()
        _set(part, model, step)
        analysis.InitializeSolutionStep()
        solver.Predict()
        converged = solver.SolveSolutionStep()
        iterations += part.ProcessInfo[Kratos.NL_ITERATION_NUMBER]
        if converged is False:
            raise common.Failed(f"no equilibrium in {ITERATIONS} iterations in step {step + 1}")
        analysis.FinalizeSolutionStep()
        moved = [part.Nodes[i + 1].GetSolutionStepValue(Kratos.DISPLACEMENT) for i in range(len(model.points))]
        found.append(np.array([[one[axis] for axis in range(model.dim)] for one in moved]))
    return np.array(found), iterations


if __name__ == "__main__":
    common.main(solve)

"""A block is pressed into a larger one and lifted by half, in Kratos: meshes that do not match, and nothing to choose."""

import KratosMultiphysics as Kratos
import numpy as np
from fmc_contact import Contact, OnUnknowns, find_equilibrium
from KratosMultiphysics.scipy_conversion_tools import to_csr
from KratosMultiphysics.StructuralMechanicsApplication import LinearElastic3DLaw


# 1. Two blocks of hexahedra. They touch from the start.
def block(low, high, n, first):
    points = np.stack(np.meshgrid(*np.linspace(low, high, n + 1).T, indexing="ij"), -1).reshape(-1, 3)
    k = np.arange(first, first + len(points)).reshape([n + 1] * 3)
    corners = [(i, j, m) for m in (0, 1) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
    return points, np.stack([k[i : n + i, j : n + j, m : n + m].ravel() for i, j, m in corners], 1)


blocks = block((0, 0, 0), (1, 1, 1), 4, 0), block((0.2, 0.2, 1.0), (0.8, 0.8, 1.6), 3, 125)
points, cells = (np.vstack(both) for both in zip(*blocks))

# 2. The bodies without contact: internal forces at displacements u, and their derivative.
model = Kratos.Model()
part = model.CreateModelPart("both")
part.AddNodalSolutionStepVariable(Kratos.DISPLACEMENT), part.AddNodalSolutionStepVariable(Kratos.VOLUME_ACCELERATION)
rubber = part.CreateNewProperties(1)
rubber[Kratos.YOUNG_MODULUS], rubber[Kratos.POISSON_RATIO], rubber[Kratos.CONSTITUTIVE_LAW] = 1e6, 0.3, LinearElastic3DLaw()
nodes = [part.CreateNewNode(n + 1, *point) for n, point in enumerate(points)]
for e, cell in enumerate(cells + 1):
    part.CreateNewElement("SmallDisplacementElement3D8N", e + 1, cell.tolist(), rubber)
for axis in (axes := (Kratos.DISPLACEMENT_X, Kratos.DISPLACEMENT_Y, Kratos.DISPLACEMENT_Z)):
    Kratos.VariableUtils().AddDof(axis, part)
scheme, space = Kratos.ResidualBasedIncrementalUpdateStaticScheme(), Kratos.UblasSparseSpace()
system = Kratos.ResidualBasedBlockBuilderAndSolver(Kratos.SkylineLUFactorizationSolver())
scheme.Initialize(part), scheme.InitializeElements(part)
system.SetUpDofSet(scheme, part), system.SetUpSystem(part)
A, b, dx = space.CreateEmptyMatrixPointer(), space.CreateEmptyVectorPointer(), space.CreateEmptyVectorPointer()
system.ResizeAndInitializeVectors(scheme, A, dx, b, part)
unknowns = np.array([[node.GetDof(axis).EquationId for axis in axes] for node in nodes])


def host(u):
    Kratos.VariableUtils().SetSolutionStepValuesVector(part.Nodes, Kratos.DISPLACEMENT, Kratos.Vector(u[unknowns].ravel()), 0)
    space.SetToZeroMatrix(A), space.SetToZeroVector(b)
    system.Build(scheme, part, A, b)
    return -np.array(b), to_csr(A)


# 3. The contact, on the equations of Kratos.
contact = OnUnknowns(Contact(points, cells, "hexahedron"), points, unknowns)

# 4. Bottom and top are held, and the top is moved: two load steps, the second from the end of the first.
height, u = points[:, 2], np.zeros(contact.size)
free = unknowns[(height > 0) & (height < 1.599)].ravel()
for push in (0.01, 0.005):
    goal = np.zeros(contact.size)
    goal[unknowns[height > 1.599, 2]] = -push
    step = find_equilibrium(host, contact, u, free, goal)
    u = step.x
    force = step.result.bodies[1].force[2]
    print(f"pushed by {push}: force {force:.6f}, {step.iterations} linear solves, {step.warnings or 'no warnings'}")

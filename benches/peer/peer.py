"""NGSolve and ngsdiffgeo do what regge does, on meshes that regge wrote. Called by compare.py, one line of JSON a call.

    peer.py functional MESH r RUNS    ⟨(Rω)_dist(g_h), hat⟩ of the paper's metric, rules of order 2(r+2)
    peer.py accuracy MESH             R of a quadratic metric in the Regge space of degree 2, against Gauss' equation
    peer.py norm MESH r               ‖(Rω)_dist(g_h) − (Rω)(g)‖_{H⁻²} by Hellan-Herrmann-Johnson of degree r+2
"""

import json
import os
import resource
import sys
import time

import ngsdiffgeo as dg
import ngsolve as ngs
from netgen.meshing import Element1D, Element2D, Element3D, FaceDescriptor, MeshPoint, Pnt
from netgen.meshing import Mesh as NetgenMesh
from ngsolve import BBND, BND, VOL, dx

THREADS = int(os.environ.get("PEER_THREADS", "2"))
# One thread's time on the processor does not depend on what else the machine does.
now = time.process_time if THREADS == 1 else time.perf_counter


def load(path):
    """The mesh in a file, and for each of its vertices whether it is inside."""
    data = json.load(open(path))
    data.setdefault("points", data.get("vertices"))
    dim = len(data["points"][0])
    mesh = NetgenMesh(dim=dim)
    points = [mesh.Add(MeshPoint(Pnt(*x, *[0.0] * (3 - dim)))) for x in data["points"]]
    faces = {}
    for cell in data["cells"]:
        for opposite in range(dim + 1):
            face = tuple(sorted(cell[:opposite] + cell[opposite + 1 :]))
            faces[face] = faces.get(face, 0) + 1
    boundary = [face for face, cells in faces.items() if cells == 1]
    if dim == 2:
        mesh.Add(FaceDescriptor(surfnr=1, domin=1, bc=1))
        mesh.SetMaterial(1, "domain")
        for cell in data["cells"]:
            mesh.Add(Element2D(1, [points[v] for v in oriented(data["points"], cell)]))
        for face in boundary:
            mesh.Add(Element1D([points[v] for v in face], index=1))
    else:
        mesh.SetMaterial(1, "domain")
        for cell in data["cells"]:
            mesh.Add(Element3D(1, [points[v] for v in oriented(data["points"], cell)]))
        mesh.Add(FaceDescriptor(surfnr=1, domin=1, bc=1))
        for face in boundary:
            mesh.Add(Element2D(1, [points[v] for v in face]))
    outside = {v for face in boundary for v in face}
    inside = [v for v in range(len(points)) if v not in outside]
    return ngs.Mesh(mesh), inside


def oriented(points, cell):
    """The cell with its last two vertices exchanged if it is turned inside out."""
    origin, *rest = (points[v] for v in cell)
    rows = [[a - b for a, b in zip(x, origin)] for x in rest]
    return list(cell) if determinant(rows) > 0 else [*cell[:-2], cell[-1], cell[-2]]


def determinant(a):
    if len(a) == 2:
        return a[0][0] * a[1][1] - a[0][1] * a[1][0]
    minors = ([row[:j] + row[j + 1 :] for row in a[1:]] for j in range(3))
    return sum((-1) ** j * a[0][j] * determinant(minor) for j, minor in enumerate(minors))


def graph(dim, slope):
    """δ + ∇f ⊗ ∇f from ∂_i f as a function of x_i."""
    gradient = ngs.CF(tuple(slope(x) for x in (ngs.x, ngs.y, ngs.z)[:dim]))
    return ngs.Id(dim) + ngs.OuterProduct(gradient, gradient), gradient


def interpolate(mesh, metric, degree):
    """The canonical interpolant."""
    function = ngs.GridFunction(ngs.HCurlCurl(mesh, order=degree))
    function.Set(metric, dual=True, bonus_intorder=12)
    return function


def rules(dim, order):
    """The measures of the three sums, integrated to an order."""
    shapes = [[], [ngs.SEGM], [ngs.TRIG], [ngs.TET]]
    at = lambda k: {s: ngs.IntegrationRule(s, order) for s in shapes[k]}
    hinges = {"element_vb": BBND} | ({"intrules": at(1)} if dim == 3 else {})
    return (
        dx(intrules=at(dim)),
        dx(element_boundary=True, intrules=at(dim - 1)),
        dx(**hinges),
    )


def curvature(manifold, v, measures):
    """The three sums. The peer's mean curvature is minus the paper's; its Euclidean angles add up to 2π."""
    cells, faces, hinges = measures
    return (
        (manifold.Scalar * v * manifold.VolumeForm(VOL)).Compile() * cells,
        (-2 * manifold.MeanCurvature * v * manifold.VolumeForm(BND)).Compile() * faces,
        (2 * manifold.AngleDefect * v * manifold.VolumeForm(BBND)).Compile() * hinges,
    )


def paper(dim):
    return graph(dim, lambda x: x - x**3 / 3)


def functional(path, degree, runs):
    mesh, inside = load(path)
    metric, _ = paper(mesh.dim)
    hats = ngs.H1(mesh, order=1)
    g_h = interpolate(mesh, metric, degree)
    sums = curvature(
        dg.RiemannianManifold(g_h), hats.TestFunction(), rules(mesh.dim, 2 * (degree + 2))
    )
    forms = [ngs.LinearForm(hats) for _ in sums]
    for form, term in zip(forms, sums):
        form += term
    seconds = [[assemble(form) for form in forms] for _ in range(runs)]
    best = min(map(sum, seconds))
    # R and H vanish for r = 0: a program that knows it need not compute them.
    spared = min(times[2] for times in seconds) if degree == 0 else best
    names = ("element", "face", "hinge") if degree > 0 else ("hinge",)
    values = {n: [form.vec[v] for v in inside] for n, form in zip(names, forms[-len(names) :])}
    return {
        "cells": mesh.ne,
        "seconds": best,
        "microseconds_per_cell": best * 1e6 / mesh.ne,
        "spared_per_cell": spared * 1e6 / mesh.ne,
        **values,
    }


def assemble(form):
    start = now()
    form.Assemble()
    return now() - start


def gauss(gradient, second):
    """R of a graph from ∂_i f and f_ii: Σ_{i≠j} f_ii f_jj (w − f_i² − f_j²)/w²."""
    dim = len(second)
    f = [gradient[i] for i in range(dim)]
    w = 1 + sum(x * x for x in f)
    pairs = [(i, j) for i in range(dim) for j in range(dim) if i != j]
    return sum(second[i] * second[j] * (w - f[i] ** 2 - f[j] ** 2) for i, j in pairs) / w**2


def accuracy(path):
    mesh, _ = load(path)
    metric, gradient = graph(mesh.dim, lambda x: x)
    scalar = dg.RiemannianManifold(interpolate(mesh, metric, 2)).Scalar
    error = scalar - gauss(gradient, [1.0] * mesh.dim)
    centre = ngs.IntegrationRule([(0.25, 0.25, 0.25)], [1.0 / 6])
    points = mesh.MapToAllElements(centre, VOL)
    return {"error": float(abs(error(points)).max())}


def hhj(mesh, degree):
    """The hybrid Hellan-Herrmann-Johnson form: σ discontinuous and condensed, û the normal derivative on facets."""
    moments = ngs.HDivDiv(mesh, order=degree - 1, discontinuous=True)
    displacement = ngs.H1(mesh, order=degree, dirichlet=".*")
    slope = ngs.NormalFacetFESpace(mesh, order=degree - 1, dirichlet=".*")
    space = moments * displacement * slope
    (sigma, u, u_hat), (tau, v, v_hat) = space.TnT()
    n = ngs.specialcf.normal(mesh.dim)
    pairing = lambda s, w: ngs.InnerProduct(s, w.Operator("hesse")) * dx
    jump = lambda s, w, w_hat: (s * n) * n * ((ngs.grad(w) - w_hat) * n) * dx(element_boundary=True)
    form = ngs.BilinearForm(space, symmetric=True, condense=True)
    form += -ngs.InnerProduct(sigma, tau) * dx
    form += pairing(sigma, v) - jump(sigma, v, v_hat)
    form += pairing(tau, u) - jump(tau, u, u_hat)
    return space, form


def norm(path, degree):
    mesh, _ = load(path)
    metric, gradient = paper(mesh.dim)
    xyz = (ngs.x, ngs.y, ngs.z)[: mesh.dim]
    g_h = interpolate(mesh, metric, degree)
    space, form = hhj(mesh, degree + 2)
    v = space.TestFunction()[1]
    load_form = ngs.LinearForm(space)
    for term in curvature(dg.RiemannianManifold(g_h), v, rules(mesh.dim, 2 * (degree + 2))):
        load_form += term
    w = 1 + sum(gradient[i] ** 2 for i in range(mesh.dim))
    exact = gauss(gradient, [1 - x**2 for x in xyz]) * ngs.sqrt(w)
    load_form += -exact * v * dx(bonus_intorder=4)
    times = {}
    start = now()
    load_form.Assemble()
    times["functional"] = now() - start
    start = now()
    solution, steps = solve(mesh, space, form, load_form)
    times["solve"] = now() - start
    sigma, u, _ = solution.components
    square = u * u + ngs.InnerProduct(ngs.grad(u), ngs.grad(u)) + ngs.InnerProduct(sigma, sigma)
    value = ngs.Integrate(square * dx(bonus_intorder=2 * degree + 4), mesh) ** 0.5
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
    return {"cells": mesh.ne, "norm": value, "steps": steps, "bytes": peak, **times}


def solve(mesh, space, form, load_form):
    """Directly in dimension 2; by conjugate gradients with BDDC in dimension 3, as the paper's authors do."""
    solution = ngs.GridFunction(space)
    free = space.FreeDofs(coupling=True)
    if mesh.dim == 3:
        bddc = ngs.Preconditioner(form, "bddc")
    form.Assemble()
    rhs = load_form.vec.CreateVector()
    rhs.data = load_form.vec + form.harmonic_extension_trans * load_form.vec
    steps = 0
    if mesh.dim == 2:
        solution.vec.data = form.mat.Inverse(free, inverse="sparsecholesky") * rhs
    else:
        inverse = ngs.krylovspace.CGSolver(form.mat, bddc.mat, tol=1e-8, maxiter=1000)
        solution.vec.data = inverse * rhs
        steps = inverse.GetSteps() if hasattr(inverse, "GetSteps") else inverse.iterations
    solution.vec.data += form.harmonic_extension * solution.vec
    solution.vec.data += form.inner_solve * load_form.vec
    return solution, steps


def main():
    ngs.SetNumThreads(THREADS)
    command, path, *rest = sys.argv[1:]
    with ngs.TaskManager():
        if command == "functional":
            result = functional(path, int(rest[0]), int(rest[1]))
        elif command == "accuracy":
            result = accuracy(path)
        else:
            result = norm(path, int(rest[0]))
    print(json.dumps(result))


if __name__ == "__main__":
    main()

"""Examples of the docstrings, the pages and the notebooks are run, and the types are those of the stubs."""

from __future__ import annotations

import ast
import doctest
import importlib
import importlib.util
import inspect
import json
import os
import re
import runpy
from pathlib import Path

import pytest
from conftest import ROOT

import regge

NOTEBOOKS = ROOT / "python" / "notebooks"
MODULES = ["regge", "_mesh", "_metrics", "_functions", "_curvature", "_action", "_norms"]


@pytest.mark.parametrize("name", MODULES)
def test_examples_of_docstrings(name):
    module = importlib.import_module(name if name == "regge" else f"regge.{name}")
    if name == "_action":
        pytest.importorskip("scipy")  # the Hessian is one of its matrices
    result = doctest.testmod(module)
    assert result.failed == 0
    assert result.attempted > 0


def _imports(file: Path) -> set[str]:
    """The modules of this package that a file imports anywhere in it, for its types too."""
    found: set[str] = set()
    for node in ast.walk(ast.parse(file.read_text())):
        if isinstance(node, ast.ImportFrom) and node.level:
            found |= {node.module} if node.module else {name.name for name in node.names}
    return found


def test_modules_import_downward():
    """Taken away one after the other: each time there is one that imports none of those that are left."""
    left = {file.stem: _imports(file) for file in Path(regge.__file__).parent.glob("*.py")}
    assert {"_curvature", "_mesh"} <= left["__init__"]
    while left:
        lowest = [name for name, imported in left.items() if not imported & set(left)]
        assert lowest, f"in a circle, or above one: {sorted(left)}"
        left = {name: imported for name, imported in left.items() if name not in lowest}


def test_everything_public_is_documented():
    for name in regge.__all__:
        assert inspect.getdoc(getattr(regge, name)), name
    for kind in (regge.Mesh, regge.ReggeSpace, regge.ReggeFunction, regge.Curvature, regge.Action):
        for name, member in inspect.getmembers(kind):
            if not name.startswith("_") and name not in ("mesh", "degree"):
                assert inspect.getdoc(member), f"{kind.__name__}.{name}"


def test_the_stubs_name_what_is_there():
    stubs = (Path(regge.__file__).parent / "_regge.pyi").read_text()
    native = importlib.import_module("regge._regge")
    public = {name for name in dir(native) if not name.startswith("_")}
    assert public == set(re.findall(r"^(?:class|def) (\w+)", stubs, re.M))
    for name in public:
        kind = getattr(native, name)
        if inspect.isclass(kind):
            body = stubs.split(f"class {name}:")[1].split("\nclass ")[0].split("\ndef ")[0]
            members = {m for m in vars(kind) if not m.startswith("_")}
            assert members == set(re.findall(r"def (\w+)", body)), name


@pytest.mark.parametrize("page", ["README.md", "docs/python.md"])
def test_examples_of_the_pages(page, monkeypatch, tmp_path):
    """Blocks of Python of a page, one after the other; those that need a package that is not here are left out."""
    text = (ROOT / page).read_text()
    blocks = re.findall(r"```python\n(.*?)```", text, re.S)
    assert blocks
    monkeypatch.chdir(ROOT)
    variables: dict[str, object] = {}
    for block in blocks:
        needed = re.findall(r"^(?:import|from) (ngsolve|netgen|pyvista|meshio|jax|torch|matplotlib)", block, re.M)
        if any(importlib.util.find_spec(name) is None for name in needed):
            continue
        exec(compile(block, page, "exec"), variables)


@pytest.mark.parametrize("path", sorted(NOTEBOOKS.glob("*.py")), ids=lambda path: path.stem)
def test_notebooks(path, monkeypatch):
    """They hold what they claim: each asserts its results."""
    pytest.importorskip("scipy")
    monkeypatch.setenv("MPLBACKEND", "Agg")
    monkeypatch.chdir(NOTEBOOKS)
    variables = runpy.run_path(str(path))
    assert variables["checked"] > 0


@pytest.mark.parametrize("path", sorted(NOTEBOOKS.glob("*.py")), ids=lambda path: path.stem)
def test_notebooks_with_outputs_are_of_these_sources(path):
    notebook = json.loads(path.with_suffix(".ipynb").read_text())
    cells = ["".join(cell["source"]).strip() for cell in notebook["cells"]]
    ours = []
    for chunk in re.split(r"^# %%", path.read_text(), flags=re.M)[1:]:
        first, _, body = chunk.partition("\n")
        if "[markdown]" in first:
            body = re.sub(r"^# ?", "", body, flags=re.M)
        ours.append(body.strip())
    assert cells == ours
    assert any(cell.get("outputs") for cell in notebook["cells"])
    assert os.path.getsize(path.with_suffix(".ipynb")) < 400_000

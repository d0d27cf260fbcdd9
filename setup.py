# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The step of the Python module's build that pyproject.toml cannot tell: CMake compiles the core.

CMAKE_ARGS holds further arguments for CMake. EXTREMAL_MESH_3_PYTHON_BUILD_DIR names a build folder that is configured for the module, with
EXTREMAL_MESH_3_BUILD_PYTHON and for this Python, to be used as it is; without it, build/python-package is made.
"""
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

root = pathlib.Path(__file__).parent.resolve()
configured = os.environ.get("EXTREMAL_MESH_3_PYTHON_BUILD_DIR")
folder = pathlib.Path(configured or root / "build" / "python-package")
package = folder / "python" / "package"  # what setuptools leaves
package.mkdir(parents=True, exist_ok=True)


class CMake(build_ext):
    def build_extension(self, ext):
        if not configured:
            ninja = ["-G", "Ninja"] if shutil.which("ninja") and not (folder / "CMakeCache.txt").exists() else []
            subprocess.run(
                ["cmake", "-S", str(root), "-B", str(folder), *ninja, "-DCMAKE_BUILD_TYPE=Release", "-DEXTREMAL_MESH_3_BUILD_PYTHON=ON",
                 "-DEXTREMAL_MESH_3_BUILD_TESTS=OFF", "-DEXTREMAL_MESH_3_BUILD_EXAMPLES=OFF", f"-DEXTREMAL_MESH_3_PYTHON={sys.executable}",
                 *shlex.split(os.environ.get("CMAKE_ARGS", ""))], check=True)
        subprocess.run(["cmake", "--build", str(folder), "--target", "extremal_mesh_core", "--parallel", str(os.cpu_count())], check=True)
        target = pathlib.Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(next((folder / "python" / "extremal_mesh").glob("_core*.so")), target)


setup(
    version=re.search(r"^project\(\w+ VERSION ([\d.]+)", (root / "CMakeLists.txt").read_text(), re.MULTILINE)[1],
    package_dir={"": "python"},
    packages=["extremal_mesh"],
    package_data={"extremal_mesh": ["*.pyi", "py.typed"]},
    ext_modules=[Extension("extremal_mesh._core", sources=[])],
    cmdclass={"build_ext": CMake},
    zip_safe=False,
    options={"egg_info": {"egg_base": str(package)}, "build": {"build_base": str(package)}},  # nothing in the tree
)

"""Builds the compiled part of the Python package by CMake: `pip wheel . --no-build-isolation --no-deps`.

All else is in pyproject.toml. The wheel needs nothing but the C and C++ libraries of the system: fmt
and pugixml become part of it, and threads are those of the C++ library (decision 0056).
"""
import os
import pathlib
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent


class BuildByCMake(build_ext):
    def build_extension(self, ext: Extension) -> None:
        module = pathlib.Path(self.get_ext_fullpath(ext.name)).resolve()
        build = pathlib.Path(self.build_temp).resolve() / "cmake"
        options = {
            "CMAKE_BUILD_TYPE": "Release",
            "SOMS_BUILD_PYTHON": "ON",
            "SOMS_PYTHON": sys.executable,
            "SOMS_PYTHON_FOLDER": str(build / "package"),
            "SOMS_SELF_CONTAINED": "ON",
            "SOMS_USE_TBB": "OFF",
            "SOMS_SHARED": "OFF",
            "SOMS_INSTALL": "OFF",
            "SOMS_BUILD_APPS": "OFF",
            "SOMS_BUILD_VIEW": "OFF",
            "SOMS_BUILD_IMPORT": "OFF",
            "SOMS_BUILD_TESTS": "OFF",
        }
        generator = ["-G", "Ninja"] if shutil.which("ninja") else []
        defines = [f"-D{name}={value}" for name, value in options.items()]
        defines += os.environ.get("SOMS_CMAKE_ARGS", "").split()
        jobs = str(self.parallel or os.cpu_count() or 1)
        subprocess.run(["cmake", "-S", str(ROOT), "-B", str(build), *generator, *defines], check=True)
        subprocess.run(["cmake", "--build", str(build), "--target", "soms_python", "-j", jobs],
                       check=True)
        made = list((build / "package/soms").glob("_soms.*.so"))
        if len(made) != 1:
            sys.exit("soms._soms was not built: CMake says above what is missing")
        module.parent.mkdir(parents=True, exist_ok=True)
        subprocess.run(["strip", "--strip-unneeded", "-o", str(module), str(made[0])], check=True)


setup(ext_modules=[Extension("soms._soms", [])], cmdclass={"build_ext": BuildByCMake})

"""Packs what CMake builds: the modules and the shared library, without machine code for one Python.

The build folder is build/wheel, or $WRCONTACT_BUILD_FOLDER from the top folder of the project, which
may have been configured already (build/release, for example).
"""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:  # before setuptools 70.1
    from wheel.bdist_wheel import bdist_wheel

project = Path(__file__).resolve().parent.parent
folder = project / os.environ.get("WRCONTACT_BUILD_FOLDER", "build/wheel")
version = re.search(r"^project\(wrcontact VERSION ([\d.]+)", (project / "CMakeLists.txt").read_text(),
                    re.M).group(1)


class BuildByCMake(build_py):
    def run(self):
        if not (folder / "CMakeCache.txt").exists():
            options = [f"-DWRCONTACT_BUILD_{part}=OFF" for part in ("DRIVERS", "FORTRAN", "TESTS")]
            subprocess.run(["cmake", "-S", project, "-B", folder, "-DCMAKE_BUILD_TYPE=Release",
                            f"-DWRCONTACT_PYTHON={sys.executable}", *options], check=True)
        subprocess.run(["cmake", "--build", folder, "--target", "wrcontact_python", "--parallel",
                        str(os.cpu_count())], check=True)
        package = Path(self.build_lib) / "wrcontact"
        shutil.rmtree(package, ignore_errors=True)
        shutil.copytree(folder / "python/wrcontact", package,
                        ignore=shutil.ignore_patterns("__pycache__"))
        for library in package.glob("lib*.so.*"):
            subprocess.run(["strip", "--strip-unneeded", library], check=True)


class WheelForAnyPython(bdist_wheel):
    def get_tag(self):
        return "py3", "none", super().get_tag()[2]


class WithLibrary(Distribution):
    def has_ext_modules(self):
        return True


output = project / "build/wheel"
output.mkdir(parents=True, exist_ok=True)
setup(version=version, packages=["wrcontact"], distclass=WithLibrary,
      cmdclass={"build_py": BuildByCMake, "bdist_wheel": WheelForAnyPython},
      options={"egg_info": {"egg_base": str(output)}, "build": {"build_base": str(output / "setup")}})

# Spack recipe; scripts/release.sh fills in what stands between @ signs.
from spack.package import *


class Wrcontact(CMakePackage):
    """Wheel/rail contact: geometry, remesh and non-Hertzian mechanics."""

    url = "@URL@"
    license("MIT")
    version("@VERSION@", sha256="@SHA256@")

    variant("drivers", default=True, description="Command-line programs")
    variant("fortran", default=True, description="Fortran module and F77 layer")
    variant("mpi", default=False, description="Studies on many processes", when="+drivers")

    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("pkgconfig", type="build")
    depends_on("fftw-api@3")
    depends_on("fftw@3 precision=float,double", when="^fftw")
    depends_on("lapack")
    depends_on("tomlplusplus", type="build")
    depends_on("cli11", type="build", when="+drivers")
    depends_on("nlohmann-json", type="build", when="+drivers")
    depends_on("netcdf-c", when="+drivers")
    depends_on("openssl", when="+drivers")
    depends_on("mpi", when="+mpi")
    depends_on("gnuplot", type="run", when="+drivers")

    generator("ninja")

    def cmake_args(self):
        return [
            self.define_from_variant("WRCONTACT_BUILD_DRIVERS", "drivers"),
            self.define_from_variant("WRCONTACT_BUILD_FORTRAN", "fortran"),
            self.define("WRCONTACT_BUILD_TESTS", False),
            self.define("WRCONTACT_BUILD_PYTHON", False),
            self.define("CMAKE_DISABLE_FIND_PACKAGE_MPI", self.spec.satisfies("~mpi")),
        ]

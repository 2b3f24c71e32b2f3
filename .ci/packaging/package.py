# SPDX-License-Identifier: Apache-2.0
"""A recipe for Spack 1: copy it to packages/ideotype/package.py of a
repository, once .github/contact.toml has the address of the sources. No build
with Spack has checked it; tests/debian/prefix.sh builds in the same way. `spack
install ideotype ^embree~ispc` saves a build of LLVM."""

# ruff: noqa: F403, F405

from spack.package import *
from spack_repo.builtin.build_systems.cmake import CMakePackage


class Ideotype(CMakePackage):
    """Exact light in crop canopies, and plants bred for it."""

    homepage = "https://example.org/ideotype"
    git = "https://example.org/ideotype.git"
    license("Apache-2.0")

    version("main", branch="main")

    variant("program", default=True, description="the program, with MPI")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("embree@3:4")
    depends_on("glm")
    depends_on("fmt@9:")
    depends_on("openssl")
    depends_on("boost@1.70:+random")
    with when("+program"):
        depends_on("mpi")
        depends_on("hdf5@1.10: +hl")
        depends_on("tomlplusplus")
        depends_on("eigen@3.4:3")
        depends_on("cli11@2.1:")
        depends_on("nlohmann-json@3:")

    # Spack's tinyobjloader is 1.0.6, which is too old.
    resource(
        name="tinyobjloader",
        git="https://github.com/tinyobjloader/tinyobjloader.git",
        tag="v2.0.0rc10",
        placement="tinyobjloader",
    )

    def cmake_args(self):
        return [
            self.define_from_variant("IDEOTYPE_PROGRAM", "program"),
            self.define("BUILD_TESTING", False),
            self.define(
                "TINYOBJLOADER_INCLUDE_DIR",
                join_path(self.stage.source_path, "tinyobjloader"),
            ),
        ]

# SPDX-License-Identifier: (Apache-2.0 OR MIT)

import os

from spack.package import *
from spack_repo.builtin.build_systems.makefile import MakefilePackage


class FmcContact(MakefilePackage):
    """Contact forces from overlap for any finite element code, explicit or implicit, in 2D or 3D, with a C interface: node
    coordinates and connectivity go in, nodal contact forces, their tangent and the overlap volume come out."""

    homepage = "https://github.com/fmc-contact/fmc-contact"
    git = "https://github.com/fmc-contact/fmc-contact.git"

    license("MIT OR Apache-2.0")

    version("main", branch="main")
    version("0.1.0", tag="v0.1.0")

    variant("python", default=False, description="The Python package")
    variant("tools", default=False, description="The command fmc")

    depends_on("c", type="build")
    depends_on("rust@1.89:", type="build")
    depends_on("gmake", type="build")
    with when("+python"):
        extends("python@3.9:")
        depends_on("py-numpy@1.20:", type=("build", "run"))

    def build(self, spec, prefix):
        make("build")

    def install(self, spec, prefix):
        make("install", f"PREFIX={prefix}", "LIBDIR=lib")
        if spec.satisfies("+tools"):
            make("install-command", f"PREFIX={prefix}")
        if spec.satisfies("+python"):
            folder = os.path.relpath(python_purelib, prefix)
            make("install-python", f"PREFIX={prefix}", "LIBDIR=lib", f"PYTHONDIR={folder}")

    @run_after("install")
    @on_package_attributes(run_tests=True)
    def first_force(self):
        source = join_path(self.stage.source_path, "hosts", "c", "two_squares.c")
        library, include = self.prefix.lib, self.prefix.include
        cc = which(os.environ["CC"])
        cc(source, f"-I{include}", f"-L{library}", f"-Wl,-rpath,{library}", "-lfmc_contact", "-o", "two_squares")
        which("./two_squares")()

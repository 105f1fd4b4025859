"""Makes the messages from protocol/amalgam.proto while the package is built, so that no copy can grow old."""

import pathlib
import shutil
import subprocess

from setuptools import setup
from setuptools.command.build_py import build_py

HERE = pathlib.Path(__file__).resolve().parent
PROTOCOL = HERE.parent.parent / "protocol"


class BuildWithMessages(build_py):
    def run(self):
        super().run()
        editable = getattr(self, "editable_mode", False)
        package = HERE / "src/amalgam" if editable else pathlib.Path(self.build_lib) / "amalgam"
        protoc = shutil.which("protoc")
        if protoc is None:
            raise SystemExit("amalgam: protoc is missing; on Debian: apt install protobuf-compiler")
        if not (PROTOCOL / "amalgam.proto").exists():
            raise SystemExit(f"amalgam: {PROTOCOL}/amalgam.proto is missing; install from a clone of the repository")
        package.mkdir(parents=True, exist_ok=True)
        subprocess.run(
            [protoc, f"-I{PROTOCOL}", f"--python_out={package}", f"--pyi_out={package}", "amalgam.proto"], check=True)


setup(cmdclass={"build_py": BuildWithMessages})

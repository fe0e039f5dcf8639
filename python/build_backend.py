# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""The backend by which pip builds the package (PEP 517): CMake compiles it, and this packs it.

It stands here since Debian 12 has no scikit-build-core, and needs nothing but Python itself."""

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[1]


def project(key):
    return re.search(rf'^{key} = "(.*)"', (ROOT / "pyproject.toml").read_text(), re.M)[1]


def metadata():
    fields = {"Metadata-Version": "2.1", "Name": project("name"), "Version": project("version"),
              "Summary": project("description"), "License": "GPL-3.0-or-later",
              "Requires-Python": project("requires-python"), "Requires-Dist": "numpy",
              "Description-Content-Type": "text/markdown"}
    head = "".join(f"{key}: {value}\n" for key, value in fields.items())
    return head + "\n" + (ROOT / "README.md").read_text()


def tag():
    python = "cp%d%d" % sys.version_info[:2]
    return f"{python}-{python}-{re.sub('[-.]', '_', sysconfig.get_platform())}"


def compiled(folder):
    """Builds the package into the folder, as the manual says that users of CMake do."""
    configure = ["cmake", "-S", ROOT, "-B", folder, "-DVolume_filling_curves_WITH_PYTHON=ON",
                 f"-DPython_EXECUTABLE={sys.executable}", "-DVFC_PYTHON_FOLDER=."]
    jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count()))
    install = ["cmake", "--install", folder, "--component", "python", "--prefix", folder / "installed"]
    for command in (configure, ["cmake", "--build", folder, "--target", "_vfc", "--parallel", jobs],
                    install):
        subprocess.run(command, check=True, stdout=sys.stderr)
    return folder / "installed"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    distribution = f"{project('name').replace('-', '_')}-{project('version')}"
    information = f"{distribution}.dist-info"
    name = f"{distribution}-{tag()}.whl"
    record = []
    with tempfile.TemporaryDirectory() as folder, \
            zipfile.ZipFile(pathlib.Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        def add(path, content):
            wheel.writestr(path, content)
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            record.append(f"{path},sha256={digest},{len(content)}\n")

        package = compiled(pathlib.Path(folder))
        for file in sorted(path for path in package.rglob("*") if path.is_file()):
            add(file.relative_to(package).as_posix(), file.read_bytes())
        add(f"{information}/METADATA", metadata().encode())
        add(f"{information}/WHEEL", f"Wheel-Version: 1.0\nGenerator: build_backend\n"
            f"Root-Is-Purelib: false\nTag: {tag()}\n".encode())
        wheel.writestr(f"{information}/RECORD", "".join(record) + f"{information}/RECORD,,\n")
    return name


def build_sdist(sdist_directory, config_settings=None):
    distribution = f"{project('name').replace('-', '_')}-{project('version')}"
    file = pathlib.Path(sdist_directory) / f"{distribution}.tar.gz"
    subprocess.run(["git", "-C", ROOT, "archive", f"--prefix={distribution}/", "-o", file, "HEAD"], check=True)
    return file.name

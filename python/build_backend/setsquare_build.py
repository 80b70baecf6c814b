# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Builds the package's wheel with CMake (PEP 517), with Python's standard library alone.

pip install . --config-settings=build-dir=DIR builds in DIR, where an earlier build may lie;
the default is build/python-<version of Python>.
"""

import base64
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "python" / "setsquare"


def version():
    """The version that CMakeLists.txt states: the one source of it."""
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(setsquare VERSION ([0-9.]+)", text).group(1)


def metadata():
    return (
        "Metadata-Version: 2.1\n"
        "Name: setsquare\n"
        f"Version: {version()}\n"
        "Summary: 2-D laser scans of a building to a map whose walls are straight and square\n"
        "License: Apache-2.0\n"
        "Requires-Python: >=3.9\n"
        "Requires-Dist: numpy\n"
        'Provides-Extra: plot\n'
        'Requires-Dist: matplotlib; extra == "plot"\n'
        "Description-Content-Type: text/markdown\n\n"
        + (ROOT / "python" / "README.md").read_text(encoding="utf-8")
    )


def build_extension(settings):
    """Compiles setsquare._core and returns its path."""
    python = f"{sys.version_info.major}.{sys.version_info.minor}"
    folder = pathlib.Path(settings.get("build-dir", ROOT / "build" / f"python-{python}"))
    configure = ["cmake", "-S", ROOT, "-B", folder, "-DSETSQUARE_BUILD_PYTHON=ON",
                 f"-DPython3_EXECUTABLE={sys.executable}"]
    if not (folder / "CMakeCache.txt").exists():
        configure += ["-DCMAKE_BUILD_TYPE=Release", "-DSETSQUARE_BUILD_TESTS=OFF",
                      "-DSETSQUARE_BUILD_APPS=OFF", "-DSETSQUARE_INSTALL=OFF",
                      "-DSETSQUARE_WARNINGS=OFF", "-DSETSQUARE_FEW_UNITS=ON"]
        # Make compiles layer after layer, Ninja all at once.
        if "CMAKE_GENERATOR" not in os.environ and shutil.which("ninja"):
            configure += ["-G", "Ninja"]
    subprocess.run(configure, check=True)
    subprocess.run(["cmake", "--build", folder, "--target", "setsquare_python",
                    "--parallel", str(len(os.sched_getaffinity(0)))], check=True)
    suffix = sysconfig.get_config_var("EXT_SUFFIX")
    return folder / "python" / f"_core{suffix}"


def record_line(name, content):
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(content)}\n"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    extension = build_extension(config_settings or {})
    tag = (f"cp{sys.version_info.major}{sys.version_info.minor}",) * 2
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    info = f"setsquare-{version()}.dist-info"
    files = {f"setsquare/{file.name}": file.read_bytes()
             for file in sorted(PACKAGE.iterdir()) if file.suffix in {".py", ".pyi", ".typed"}}
    files[f"setsquare/{extension.name}"] = extension.read_bytes()
    files[f"{info}/METADATA"] = metadata().encode()
    files[f"{info}/WHEEL"] = (f"Wheel-Version: 1.0\nGenerator: setsquare_build\n"
                              f"Root-Is-Purelib: false\nTag: {'-'.join(tag)}-{platform}\n").encode()
    files[f"{info}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    record = "".join(record_line(name, content) for name, content in files.items())
    files[f"{info}/RECORD"] = f"{record}{info}/RECORD,,\n".encode()
    wheel = f"setsquare-{version()}-{'-'.join(tag)}-{platform}.whl"
    with zipfile.ZipFile(pathlib.Path(wheel_directory) / wheel, "w", zipfile.ZIP_DEFLATED) as to:
        for name, content in files.items():
            to.writestr(name, content)
    return wheel


def build_sdist(sdist_directory, config_settings=None):
    """The files that git tracks, and PKG-INFO."""
    name = f"setsquare-{version()}"
    tracked = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True, capture_output=True)
    info = ROOT / "build" / "PKG-INFO"
    info.parent.mkdir(exist_ok=True)
    info.write_text(metadata(), encoding="utf-8")
    with tarfile.open(pathlib.Path(sdist_directory) / f"{name}.tar.gz", "w:gz") as to:
        for file in filter(None, tracked.stdout.decode().split("\0")):
            to.add(ROOT / file, f"{name}/{file}")
        to.add(info, f"{name}/PKG-INFO")
    return f"{name}.tar.gz"

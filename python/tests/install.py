# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""install.py BUILD FOLDER: installs the package with pip, without any index, into a new
environment in FOLDER, as docs/python.md tells users; BUILD is where the module is built."""
import pathlib
import subprocess
import sys

build, folder = sys.argv[1:]
root = pathlib.Path(__file__).resolve().parents[2]
missing = [name for name in ("numpy", "matplotlib", "pytest", "mypy", "venv", "pip")
           if subprocess.run([sys.executable, "-c", f"import {name}"], capture_output=True).returncode]
if missing:
    print("skipped: Python lacks " + ", ".join(missing))
    sys.exit(77)
subprocess.run([sys.executable, "-m", "venv", "--clear", "--system-site-packages", folder], check=True)
subprocess.run([f"{folder}/bin/pip", "install", "--no-index", "--no-deps", "--force-reinstall",
                f"--config-settings=build-dir={build}", str(root)], check=True)
subprocess.run([f"{folder}/bin/python", "-c", "import setsquare; print(setsquare.__version__)"],
               check=True, cwd=folder)

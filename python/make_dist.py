"""Leaves the units and a wheel of the Python package in dist/:

    python3 python/make_dist.py

Needs Rust 1.89 or later, a C linker and pip. WHEELRAIL_PLATFORMS=linux64,win64 asks for units of both (docs/fmi.md, platforms). The
library is compiled twice, once for the units and once within the wheel.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def main() -> None:
    start = time.monotonic()
    dist, target = ROOT / "dist", ROOT / "target" / "dist"
    dist.mkdir(exist_ok=True)
    # The build script packs the units; what is only checked is not compiled for it.
    command = ["cargo", "check", "--release", "--no-default-features", "--features", "package"]
    subprocess.run([*command, "--target-dir", str(target)], cwd=ROOT, check=True)
    for unit in sorted((target / "release").glob("*.fmu")):
        shutil.copy(unit, dist / unit.name)
    for old in dist.glob("wheelrail-*.whl"):
        old.unlink()
    command = [sys.executable, "-m", "pip", "wheel", "--no-deps", "--wheel-dir", str(dist)]
    environment = {**os.environ, "WHEELRAIL_UNITS": str(dist)}
    subprocess.run([*command, str(ROOT / "python")], check=True, env=environment)
    print(f"in {dist}, after {(time.monotonic() - start) / 60.0:.1f} minutes:")
    for made in sorted(dist.iterdir()):
        print(f"  {made.name}")


if __name__ == "__main__":
    main()

"""What the tables of other programs say of the computer, as grazing's own do."""

import os
import platform
import subprocess


def machine():
    """The processor and how many there are."""
    name = f"{platform.system().lower()} {platform.machine()}"
    try:
        for line in open("/proc/cpuinfo"):
            key, _, value = line.partition(":")
            if key.strip() == "model name":
                name = value.strip()
                break
    except OSError:
        pass
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    return f"{name}, {cores} core{'' if cores == 1 else 's'}"


def load():
    """Processes that wanted a processor over the last minute."""
    return f"{os.getloadavg()[0]:.2f}"


def gcc():
    return "gcc " + subprocess.run(["gcc", "-dumpfullversion"], capture_output=True, text=True).stdout.strip()


def arb():
    """Arb's version, by its header; from FLINT 3 on, FLINT's, of which it is a part."""
    for header, name, macro in [("flint/arb.h", "FLINT", "__FLINT_VERSION"), ("arb.h", "Arb", "__ARB_VERSION")]:
        source = f"#include <{header}>\n" + " ".join(macro + part for part in ("", "_MINOR", "_PATCHLEVEL"))
        done = subprocess.run(["gcc", "-E", "-P", "-"], input=source, capture_output=True, text=True)
        if done.returncode == 0:
            return name + " " + ".".join(done.stdout.split()[-3:])
    return "Arb"


def quartiles(times):
    """Median, lower and upper quartile, as grazing has them."""
    times = sorted(times)
    return [round(times[(len(times) - 1) * share // 4]) for share in (2, 1, 3)]

#!/bin/sh
# The machines of benches/machines.rs here and by SciPy's solve_ivp: nanoseconds per mode and quarter period of the
# fastest mode. SciPy's part needs python3 (or $PYTHON) with numpy and scipy and is left out without.
set -eu
cd "$(dirname "$0")/../.."
python=${PYTHON:-python3}
echo "# grazing"
cargo bench --quiet -p grazing-scenes --bench machines
if "$python" -c 'import scipy, numpy' 2>/dev/null; then
    echo "# SciPy $("$python" -c 'import scipy; print(scipy.__version__)')"
    "$python" benches/peers/machines.py
else
    echo "scipy is not installed: no comparison" >&2
fi

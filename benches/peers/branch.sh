#!/bin/sh
# The same branch by AUTO-07p (Debian's packages auto-07p and gfortran; without a compiler it ends with "Killed") and by
# `cargo bench -p grazing-scenes --bench branches`: the orbits of period 4 with one impact of the paper's example from mu = -0.05 through the
# saddle-node to mu = -0.0245. Prints AUTO's saddle-node, its time per point with and without the start of its process, the least
# of five runs each, and how many digits of it agree with the closed formula.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$here/branch.f90" "$work/impact.f90"
cd "$work"
cat > c.impact <<'CONSTANTS'
NDIM=2, IPS=0, IRS=0, ILP=1
ICP=['mu']
parnames={1:'mu'}
NTST=10, NCOL=4, IAD=3, ISP=0, ISW=1, IPLT=0, NBC=0, NINT=0
NMX=100000, NPR=100000, MXBF=0, IID=0, ITMX=9, ITNW=7, NWTN=3, JAC=0
EPSL=1e-12, EPSU=1e-12, EPSS=1e-9
DS=-0.0005, DSMIN=1e-8, DSMAX=0.0005, IADS=0
NPAR=1, THL={}, THU={}
UZSTOP={'mu': -0.0245}
CONSTANTS
cat > run.auto <<'SCRIPT'
import time
def timed(**options):
    begin = time.time()
    branch = run(e='impact', c='impact', **options)
    return time.time() - begin, branch
timed(NMX=2)
starts = [timed(NMX=2)[0] for _ in range(5)]
runs = [timed() for _ in range(5)]
branch = runs[0][1]
spent = min(run[0] for run in runs)
points = len(branch[0]['mu'])
each = [1e6 * seconds / points for seconds in (spent, spent - min(starts))]
print('AUTO-07p: %d points, %.2f us a point, %.2f without the start of the process' % (points, each[0], each[1]))
fold = branch('LP1')['mu']
print('saddle-node at mu = %.16g, off the closed formula by %.1e' % (fold, abs(fold + 0.08433847008958927)))
SCRIPT
auto-07p run.auto | grep -E 'AUTO-07p:|saddle-node'

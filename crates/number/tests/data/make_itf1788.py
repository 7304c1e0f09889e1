"""Cases of the interval operations that this crate has, from the tests of the package inari 2.0.0.

    python3 make_itf1788.py INARI/tests/itf1788_tests >itf1788.csv

There: libieeep1788_elem.rs and libieeep1788_set.rs, which are the unit tests of libieeep1788 in the form that the
ITF1788 project gave them (Apache-2.0). Cases with the empty interval, which this crate does not have, and decorated
ones are left out; their number is written to the error stream.
"""

import re
import sys

NAMES = {"neg": 1, "add": 2, "sub": 2, "mul": 2, "div": 2, "intersection": 2, "sqrt": 1, "exp": 1, "sin": 1, "cos": 1,
         "sqr": 1, "log": 1, "pow": 2, "tan": 1, "atan": 1, "sinh": 1, "cosh": 1, "abs": 1, "min": 2, "max": 2,
         "convex_hull": 2}
INTERVAL = r"(?:n2i\(([^(),]+),([^(),]+),?\)|(I::ENTIRE)|(I::EMPTY))"


def end(text):
    text = text.strip()
    return {"f64::INFINITY": "inf", "f64::NEG_INFINITY": "-inf"}.get(text, text)


def main(folder):
    print("""# Interval operations and the tightest intervals of floats that enclose their results.
# operation, lower and upper ends of the arguments, lower and upper end of the result
#
# From libieeep1788 (original author: Marco Nehmeier), copyright 2013-2015 Marco Nehmeier
# (nehmeier@informatik.uni-wuerzburg.de), copyright 2015-2017 Oliver Heimlich (oheim@posteo.de), Apache License 2.0;
# as in the tests of the package inari 2.0.0, rewritten as a table by crates/number/tests/data/make_itf1788.py. ITF1788, copyright 2014
# Marco Nehmeier, Maximilian Kiesner, Department of Computer Science, University of Wuerzburg, Germany: this product
# includes software developed at the Chair of Software Engineering there.""")
    left_out = 0
    for name in ("libieeep1788_elem.rs", "libieeep1788_set.rs"):
        text = open(f"{folder}/{name}").read()
        for operation, body in re.findall(r"fn minimal_(\w+?)_test\(\) \{(.*?)\n\}", text, re.S):
            if operation not in NAMES:
                continue
            for case in re.findall(r"assert_eq2!\((.*?)\);\n", body, re.S):
                intervals = re.findall(INTERVAL, " ".join(case.split()))
                assert len(intervals) == NAMES[operation] + 1, case
                if any(empty for *_, empty in intervals):
                    left_out += 1
                    continue
                ends = [(end(lo), end(hi)) if lo else ("-inf", "inf") for lo, hi, _, _ in intervals]
                print(",".join([operation] + [x for pair in ends for x in pair]))
    print(f"left out: {left_out} with the empty interval", file=sys.stderr)


main(sys.argv[1])

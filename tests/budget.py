#!/usr/bin/env python3
"""Holds every test to its budget of processor time: 1 second, 5 for those that LONGER names.

    tests/budget.py [CARGO TEST ARGUMENTS]        such as --workspace; without any, the default members

Each test runs in a process of its own, at the sample of 1 and asked for nothing beside cargo; what it starts counts.
Exit code 1 names those that take longer, and the names in LONGER that no longer do, or are not.
"""
import json
import os
import subprocess
import sys

ONE, LONG, SLACK = 1.0, 5.0, 1.3
# What needs a whole run, or is of too few cases below.
LONGER = {
    "checker branch::damaged_certificates_of_branches_are_true_or_rejected",
    "checker branch::forged_claims_are_refused",
    "checker range_damage::what_is_accepted_of_damaged_certificates_is_true",
    "checker details::what_is_printed_of_chaos_is_checked",
    "checker share::the_work_is_bounded",
    "checker single::what_is_accepted_of_damaged_certificates_is_true",
    "enclosures sines_agree_with_flint",
    "grazing search::fuzz::sweep::tests::the_error_bounds_hold_and_are_needed",
    "grazing_number edges::operations_hold_at_every_exponent",
    "grazing_number float_sine::tests::products_over_stay_within_their_error",
    "theory appendix_b::the_polynomials_on_the_circle",
    "theory boundary::polynomials_change_sign_across_the_edge",
    "theory decay::hard_records_are_fitted_too",
    "theory decay::two_deviations_hold_the_truth_as_often_as_they_should",
    "theory enclosures::a_million_interval_signs_are_right",
    "theory enclosures::real_eigenvalues_add_up_exactly",
    "theory farey::the_largest_walk_stays_exact",
    "theory fuzz::words::false_statements_are_refuted",
    "theory measure::the_distribution_approaches_the_landau_law",
    "theory patterns::block_solver_against_dense",
    "theory share::two_searches_bound_one_share",
    "theory tolerance::random_points_contradict_no_verdict_and_lie_within_the_shares",
    "theory words::forms::a_point_is_a_tiny_box",
    "theory words::forms::boxes_across_lines_say_what_their_points_have_in_common",
    "theory words::words_agree_for_large_and_small_numbers",
    "theory words::words_agree_where_quantities_vanish",
    "verify cover::a_killed_run_resumes_to_the_same_certificate",
    "verify cover_certificates::damage_is_detected",
}


def programs(arguments):
    """The test programs that cargo builds: the folder each starts in, and its path."""
    command = ["cargo", "test", "--no-run", "--message-format", "json", *arguments]
    built = subprocess.run(command, stdout=subprocess.PIPE, check=True, text=True).stdout
    for line in built.splitlines():
        message = json.loads(line)
        if message.get("executable") and message["profile"]["test"]:
            yield os.path.dirname(message["manifest_path"]), message["target"]["name"], message["executable"]


def seconds(folder, program, test):
    """Processor seconds of one test, its children's included, and whether it passed."""
    environment = {**os.environ, "CARGO_MANIFEST_DIR": folder, "RAYON_NUM_THREADS": "1"}
    child = subprocess.Popen([program, "--exact", test, "--test-threads", "1"], cwd=folder, env=environment,
                             stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, used = os.wait4(child.pid, 0)
    return used.ru_utime + used.ru_stime, status == 0


def main():
    for name in [name for name in os.environ if name.startswith(("GRAZING_SAMPLES", "GRAZING_REQUIRE_"))]:
        del os.environ[name]
    found, failed = [], []
    for folder, name, program in programs(sys.argv[1:]):
        listed = subprocess.run([program, "--list", "--format", "terse"], cwd=folder, stdout=subprocess.PIPE, text=True)
        for line in listed.stdout.splitlines():
            test, _, kind = line.rpartition(": ")
            if kind == "test":
                spent, passed = seconds(folder, program, test)
                found.append((spent, f"{name} {test}"))
                if not passed:
                    failed.append(f"{name} {test}")
    found.sort(reverse=True)
    for spent, test in found[:25]:
        print(f"{spent:7.2f} s  {test}")
    print(f"{sum(spent for spent, _ in found):7.0f} s  all {len(found)}")
    # A machine of another speed, or a busy one, is no fault of a test.
    budget = lambda test: SLACK * (LONG if test in LONGER else ONE)
    broken = [f"{test}: {spent:.1f} s" for spent, test in found if spent > budget(test)]
    known = {test for spent, test in found if spent > ONE / SLACK}
    idle = sorted(test for test in LONGER - known if any(test.split(" ")[0] == other.split(" ")[0] for _, other in found))
    for what, tests in [("fails", failed), ("over its budget", broken), ("in LONGER without need", idle)]:
        for test in tests:
            print(f"{what}: {test}")
    return 1 if failed or broken else 0


if __name__ == "__main__":
    sys.exit(main())

/* The walk of F_N from 0/1 to 1/1 by FLINT's fmpq_farey_neighbors, timed. Prints: terms mix ns_per_term. */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <flint/fmpq.h>

int main(int argc, char **argv)
{
    ulong order = argc > 1 ? strtoul(argv[1], NULL, 10) : 10000, terms = 0, mix = 0;
    struct timespec start, end;
    fmpq_t left, x, right;
    fmpz_t n;
    fmpq_init(left); fmpq_init(x); fmpq_init(right);
    fmpz_init_set_ui(n, order);
    clock_gettime(CLOCK_MONOTONIC, &start);
    for (;;) {
        terms++;
        mix += fmpz_get_ui(fmpq_numref(x)) ^ fmpz_get_ui(fmpq_denref(x));
        if (fmpz_is_one(fmpq_denref(x)) && fmpz_is_one(fmpq_numref(x)))
            break;
        fmpq_farey_neighbors(left, right, x, n);
        fmpq_swap(x, right);
    }
    clock_gettime(CLOCK_MONOTONIC, &end);
    double ns = (end.tv_sec - start.tv_sec) * 1e9 + (end.tv_nsec - start.tv_nsec);
    printf("%lu %lu %.3f\n", terms, mix, ns / terms);
    return 0;
}

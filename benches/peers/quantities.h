/* b_{n,k} and c_n by Arb as quotients, by the formulas as the paper prints them: (B1), (62) and (60) from (r, s); powers of the
 * eigenvalues, (59) and (60), from (a1, a2). And a clock. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <flint/fmpq.h>
#if __has_include(<flint/arb.h>)
#include <flint/arb.h>
#else
#include <arb.h>
#endif

static arb_t x, y, theta, root, one, two, u, v, w, t;

static void set(arb_t out, const fmpq_t q, slong bits) { arb_set_fmpq(out, q, bits); }

/* u_m from (a1, a2): r^{m-1} sin(m theta)/sin theta, or (l1^m - l2^m)/(l1 - l2). */
static void u_of(arb_t out, ulong m, int complex_pair, slong bits)
{
    arb_t a, b;
    arb_init(a); arb_init(b);
    if (complex_pair) {
        arb_mul_ui(a, theta, m, bits);
        arb_sin(a, a, bits);
        arb_sin(b, theta, bits);
        arb_div(out, a, b, bits);
        arb_pow_ui(a, root, m - 1, bits);
        arb_mul(out, out, a, bits);
    } else {
        arb_pow_ui(a, one, m, bits);
        arb_pow_ui(b, two, m, bits);
        arb_sub(out, a, b, bits);
        arb_sub(a, one, two, bits);
        arb_div(out, out, a, bits);
    }
    arb_clear(a); arb_clear(b);
}

/* Numerator u and denominator w of the quantity at one precision; 0 if it is not certain which formula holds. */
static int quotient(int polar, int c, ulong n, ulong k, const fmpq_t p, const fmpq_t q, slong bits)
{
    fmpq_t at;
    fmpq_init(at);
    set(x, p, bits);
    set(y, q, bits);
    if (polar && fmpq_is_one(p)) {
        fmpq_mul_ui(at, q, k); arb_sin_pi_fmpq(u, at, bits);
        fmpq_mul_ui(at, q, n - k); arb_sin_pi_fmpq(v, at, bits);
        fmpq_mul_ui(at, q, n); arb_cos_pi_fmpq(w, at, bits);
        arb_mul(u, u, v, bits);
        arb_mul_si(u, u, -2, bits);
    } else if (polar) {
        /* (r^{n-k} sin n theta - r^n sin (n-k) theta - sin k theta) over r^{n-k} sin n theta. */
        fmpq_mul_ui(at, q, 2 * n); arb_sin_pi_fmpq(w, at, bits);
        arb_pow_ui(u, x, n - k, bits);
        arb_mul(u, u, w, bits);
        arb_set(w, u);
        fmpq_mul_ui(at, q, 2 * (n - k)); arb_sin_pi_fmpq(v, at, bits);
        arb_pow_ui(t, x, n, bits);
        arb_submul(u, t, v, bits);
        fmpq_mul_ui(at, q, 2 * k); arb_sin_pi_fmpq(v, at, bits);
        arb_sub(u, u, v, bits);
    } else {
        arb_mul(t, x, x, bits);
        arb_submul_ui(t, y, 4, bits);
        int complex_pair = arb_is_negative(t);
        if (!complex_pair && !arb_is_positive(t)) { fmpq_clear(at); return 0; }
        arb_abs(t, t);
        arb_sqrt(t, t, bits);
        if (complex_pair) {
            arb_atan2(theta, t, x, bits);
            arb_sqrt(root, y, bits);
        } else {
            arb_add(one, x, t, bits); arb_mul_2exp_si(one, one, -1);
            arb_sub(two, x, t, bits); arb_mul_2exp_si(two, two, -1);
        }
        u_of(w, n, complex_pair, bits);
        if (c) {
            /* -(1 - v_n + a2^n), v_n = 2 u_{n+1} - a1 u_n. */
            u_of(u, n + 1, complex_pair, bits);
            arb_mul_2exp_si(u, u, 1);
            arb_submul(u, x, w, bits);
            arb_sub_ui(u, u, 1, bits);
            arb_pow_ui(t, y, n, bits);
            arb_sub(u, u, t, bits);
        } else {
            u_of(u, k, complex_pair, bits);
            arb_sub(u, w, u, bits);
            u_of(v, n - k, complex_pair, bits);
            arb_pow_ui(t, y, k, bits);
            arb_submul(u, t, v, bits);
        }
    }
    fmpq_clear(at);
    return 1;
}

static double now(void)
{
    struct timespec at;
    clock_gettime(CLOCK_MONOTONIC, &at);
    return at.tv_sec * 1e9 + at.tv_nsec;
}

static void set_up(void)
{
    arb_ptr all[] = {x, y, theta, root, one, two, u, v, w, t};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) arb_init(all[i]);
}

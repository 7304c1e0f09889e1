/* Signs of b_{n,k} and c_n by Arb, timed, at the points that standard input lists: lines
 *
 *     family,distance,quantity,n,k,coordinates,x,y
 *
 * with quantity b or c, coordinates rs or a1a2 and x, y exact fractions. From 64 bits on the precision doubles until the sign is
 * certain, as a user of Arb would do it, up to 16384 bits. One line per point: family,distance,sign,bits,ns, where the sign is + or -,
 * or ? if it is not certain, bits is the last precision and ns the fastest of three batches of the whole search. Formulas: (B1), (62)
 * and (60) from (r, s); powers of the eigenvalues, (59) and (60), from (a1, a2).
 *
 * With the argument "widths" nothing is timed: one line per point and precision of 53 to 4096 bits, family,distance,bits,lost, where
 * lost is how many of these bits the value's enclosure has not. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
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

/* The sign of sin or of the quantity at one precision: 1, -1, or 0 if it is not certain. */
static int sign_at(int polar, int c, ulong n, ulong k, const fmpq_t p, const fmpq_t q, slong bits)
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
        arb_mul(u, u, w, bits);
        arb_neg(u, u);
    } else if (polar) {
        /* (r^{n-k} sin n theta - r^n sin (n-k) theta - sin k theta) times sin n theta. */
        fmpq_mul_ui(at, q, 2 * n); arb_sin_pi_fmpq(w, at, bits);
        arb_pow_ui(u, x, n - k, bits);
        arb_mul(u, u, w, bits);
        fmpq_mul_ui(at, q, 2 * (n - k)); arb_sin_pi_fmpq(v, at, bits);
        arb_pow_ui(t, x, n, bits);
        arb_submul(u, t, v, bits);
        fmpq_mul_ui(at, q, 2 * k); arb_sin_pi_fmpq(v, at, bits);
        arb_sub(u, u, v, bits);
        arb_mul(u, u, w, bits);
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
        arb_mul(u, u, w, bits);
    }
    fmpq_clear(at);
    return arb_is_positive(u) ? 1 : arb_is_negative(u) ? -1 : 0;
}

static double now(void)
{
    struct timespec at;
    clock_gettime(CLOCK_MONOTONIC, &at);
    return at.tv_sec * 1e9 + at.tv_nsec;
}

static void widths(char *part[8], int polar, int c, ulong n, ulong k, const fmpq_t p, const fmpq_t q)
{
    static const slong bits[] = {53, 128, 256, 1024, 4096};
    for (size_t i = 0; i < sizeof bits / sizeof *bits; i++) {
        /* What stays so where the formula gives up: nothing is known. */
        arb_zero_pm_inf(u);
        sign_at(polar, c, n, k, p, q, bits[i]);
        slong accuracy = arb_rel_accuracy_bits(u);
        accuracy = accuracy < 0 ? 0 : accuracy > bits[i] ? bits[i] : accuracy;
        printf("%s,%s,%ld,%ld\n", part[0], part[1], bits[i], bits[i] - accuracy);
    }
}

int main(int argc, char **argv)
{
    int only_widths = argc > 1 && !strcmp(argv[1], "widths");
    arb_ptr all[] = {x, y, theta, root, one, two, u, v, w, t};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) arb_init(all[i]);
    char *line = NULL;
    size_t room = 0;
    fmpq_t p, q;
    fmpq_init(p); fmpq_init(q);
    while (getline(&line, &room, stdin) > 0) {
        char *part[8], *rest = line;
        for (int i = 0; i < 8; i++) part[i] = strsep(&rest, ",\n");
        if (!part[7] || fmpq_set_str(p, part[6], 10) || fmpq_set_str(q, part[7], 10)) {
            fprintf(stderr, "a line that is no point\n");
            return 2;
        }
        int c = part[2][0] == 'c', polar = part[5][0] == 'r', sign = 0;
        ulong n = strtoul(part[3], NULL, 10), k = strtoul(part[4], NULL, 10);
        if (only_widths) {
            widths(part, polar, c, n, k, p, q);
            continue;
        }
        slong bits = 64;
        double best = 1e300;
        long calls = 1;
        for (int batch = 0; batch < 4; batch++) {
            double start = now();
            for (long i = 0; i < calls; i++)
                for (bits = 64; !(sign = sign_at(polar, c, n, k, p, q, bits)) && bits < 16384; bits *= 2) {}
            double ns = (now() - start) / calls;
            /* The first only finds out how many calls a batch is, and fills Arb's caches. */
            if (batch && ns < best) best = ns;
            if (!batch) calls = ns > 1e6 ? 1 : 1e6 / ns;
        }
        printf("%s,%s,%s,%ld,%.0f\n", part[0], part[1], sign > 0 ? "+" : sign < 0 ? "-" : "?", bits, best);
    }
    return 0;
}

/* b_{n,k} on r = 1 by Arb, timed, for s = P/Q, n = 100: arguments k P/Q as exact fractions, (B1).
 *
 * Lines "single BITS NS MIDPOINT": one b_{100,37}: three sines. Lines "all BITS NS MIDPOINT": per k over all k = 1 ... 99, cos(n pi s)
 * taken out of the loop; the midpoint is that of the sum over k. */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <flint/fmpq.h>
#if __has_include(<flint/arb.h>)
#include <flint/arb.h>
#else
#include <arb.h>
#endif

static const slong P = 12345, Q = 67891, N = 100, K = 37;

static void sine(arb_t out, slong k, slong bits)
{
    fmpq_t x;
    fmpq_init(x);
    fmpq_set_si(x, k * P, Q);
    arb_sin_pi_fmpq(out, x, bits);
    fmpq_clear(x);
}

static void cosine(arb_t out, slong k, slong bits)
{
    fmpq_t x;
    fmpq_init(x);
    fmpq_set_si(x, k * P, Q);
    arb_cos_pi_fmpq(out, x, bits);
    fmpq_clear(x);
}

static void product(arb_t b, arb_t t, const arb_t c, slong k, slong bits)
{
    sine(b, k, bits);
    sine(t, N - k, bits);
    arb_mul(b, b, t, bits);
    arb_mul_si(b, b, -2, bits);
    arb_div(b, b, c, bits);
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec * 1e9 + t.tv_nsec;
}

int main(void)
{
    static const slong BITS[] = {53, 128, 256, 1024, 4096};
    arb_t b, t, c, sum;
    arb_init(b); arb_init(t); arb_init(c); arb_init(sum);
    for (size_t i = 0; i < sizeof BITS / sizeof *BITS; i++) {
        slong bits = BITS[i];
        long rounds = 4000000 / (bits * 20);
        double best = 1e300;
        for (int batch = 0; batch < 5; batch++) {
            double start = now();
            for (long r = 0; r < rounds; r++) {
                cosine(c, N, bits);
                product(b, t, c, K, bits);
            }
            double ns = (now() - start) / rounds;
            if (ns < best) best = ns;
        }
        printf("single %ld %.1f ", bits, best);
        arb_printn(b, 15, ARB_STR_NO_RADIUS);
        printf("\n");
        rounds = rounds / 50 + 1;
        best = 1e300;
        for (int batch = 0; batch < 5; batch++) {
            double start = now();
            for (long r = 0; r < rounds; r++) {
                arb_zero(sum);
                cosine(c, N, bits);
                for (slong k = 1; k < N; k++) {
                    product(b, t, c, k, bits);
                    arb_add(sum, sum, b, bits);
                }
            }
            double ns = (now() - start) / rounds / (N - 1);
            if (ns < best) best = ns;
        }
        printf("all %ld %.1f ", bits, best);
        arb_printn(sum, 15, ARB_STR_NO_RADIUS);
        printf("\n");
    }
    arb_clear(b); arb_clear(t); arb_clear(c); arb_clear(sum);
    flint_cleanup();
    return 0;
}

/* Operations of FLINT's balls (arb) and, from FLINT 3.4 on, of its floats with directed rounding (nfloat), timed on the numbers of
 * operations/src/main.rs: lines LIBRARY OPERATION BITS NS LOWER UPPER, as there. An operation of nfloat is done twice, rounded down and
 * up, as the ends of positive intervals need it. */
#include <stdio.h>
#include <time.h>
#include <flint/fmpq.h>
#if __has_include(<flint/arb.h>)
#include <flint/arb.h>
#else
#include <arb.h>
#endif
#if __has_include(<flint/nfloat.h>)
#include <flint/gr.h>
#include <flint/nfloat.h>
#endif

static double now(void)
{
    struct timespec at;
    clock_gettime(CLOCK_MONOTONIC, &at);
    return at.tv_sec * 1e9 + at.tv_nsec;
}

/* Nanoseconds of CALL: the fastest of nine batches of about 2 ms. */
#define TIME(ns, CALL) do { \
    long calls = 1; \
    ns = 1e300; \
    for (int batch = 0; batch < 11; batch++) { \
        double start = now(); \
        for (long call = 0; call < calls; call++) { CALL; } \
        double one = (now() - start) / calls; \
        if (batch < 2) calls = batch || one > 2e4 ? 2e6 / one + 1 : 100; \
        else if (one < ns) ns = one; \
    } \
} while (0)

static void put(const char *library, const char *operation, slong bits, double ns, const arb_t value)
{
    arb_t scaled;
    fmpz_t low, high, exponent;
    arb_init(scaled);
    fmpz_init(low); fmpz_init(high); fmpz_init(exponent);
    arb_set_str(scaled, "1e25", 8192);
    arb_mul(scaled, scaled, value, 8192);
    arb_get_interval_fmpz_2exp(low, high, exponent, scaled);
    slong e = fmpz_get_si(exponent);
    if (e < 0) { fmpz_fdiv_q_2exp(low, low, -e); fmpz_cdiv_q_2exp(high, high, -e); }
    else { fmpz_mul_2exp(low, low, e); fmpz_mul_2exp(high, high, e); }
    printf("%s %s %ld %.2f ", library, operation, bits, ns);
    fmpz_print(low); printf("e-25 "); fmpz_print(high); printf("e-25\n");
    arb_clear(scaled);
    fmpz_clear(low); fmpz_clear(high); fmpz_clear(exponent);
}

static void balls(slong bits)
{
    arb_t a, b, c;
    fmpq_t x, y;
    double ns;
    arb_init(a); arb_init(b); arb_init(c);
    fmpq_init(x); fmpq_init(y);
    fmpq_set_si(x, 12345, 67891);
    fmpq_set_si(y, 987654321, 123456787);
    arb_set_fmpq(a, x, bits);
    arb_set_fmpq(b, y, bits);
    TIME(ns, arb_add(c, a, b, bits)); put("arb", "sum", bits, ns, c);
    TIME(ns, arb_mul(c, a, b, bits)); put("arb", "product", bits, ns, c);
    TIME(ns, arb_div(c, a, b, bits)); put("arb", "quotient", bits, ns, c);
    TIME(ns, arb_sin_pi_fmpq(c, x, bits)); put("arb", "sinpi", bits, ns, c);
    TIME(ns, arb_exp(c, a, bits)); put("arb", "exp", bits, ns, c);
    TIME(ns, arb_log(c, a, bits)); put("arb", "log", bits, ns, c);
    TIME(ns, arb_sin(c, a, bits)); put("arb", "sin", bits, ns, c);
    TIME(ns, arb_tan(c, a, bits)); put("arb", "tan", bits, ns, c);
    TIME(ns, arb_atan(c, a, bits)); put("arb", "atan", bits, ns, c);
    TIME(ns, arb_sinh(c, a, bits)); put("arb", "sinh", bits, ns, c);
    TIME(ns, arb_pow(c, b, a, bits)); put("arb", "pow", bits, ns, c);
    arb_clear(a); arb_clear(b); arb_clear(c);
    fmpq_clear(x); fmpq_clear(y);
}

#ifdef NFLOAT_RND_FLOOR
typedef int (*binary)(gr_ptr, gr_srcptr, gr_srcptr, gr_ctx_t);

/* p/q, rounded as the context says. */
static void end(gr_ptr out, slong p, ulong q, gr_ctx_t ctx)
{
    gr_ptr t = gr_heap_init(ctx);
    GR_MUST_SUCCEED(gr_set_si(out, p, ctx));
    GR_MUST_SUCCEED(gr_set_ui(t, q, ctx));
    GR_MUST_SUCCEED(nfloat_div(out, out, t, ctx));
    gr_heap_clear(t, ctx);
}

static void directed(slong bits)
{
    gr_ctx_t down, up;
    if (nfloat_ctx_init(down, bits, NFLOAT_RND_FLOOR) != GR_SUCCESS) return;
    if (nfloat_ctx_init(up, bits, NFLOAT_RND_CEIL) != GR_SUCCESS) return;
    gr_ptr a = gr_heap_init(down), b = gr_heap_init(up), c = gr_heap_init(down), d = gr_heap_init(up);
    gr_ptr low = gr_heap_init(down), high = gr_heap_init(up);
    end(a, 12345, 67891, down); end(b, 12345, 67891, up);
    end(c, 987654321, 123456787, down); end(d, 987654321, 123456787, up);
    static const char *const names[] = {"sum", "product", "quotient"};
    static const binary operations[] = {(binary) nfloat_add, (binary) nfloat_mul, (binary) nfloat_div};
    for (int i = 0; i < 3; i++) {
        gr_ptr right[2] = {i == 2 ? d : c, i == 2 ? c : d};
        double ns;
        TIME(ns, operations[i](low, a, right[0], down); operations[i](high, b, right[1], up));
        arf_t l, h;
        arb_t both;
        arf_init(l); arf_init(h); arb_init(both);
        nfloat_get_arf(l, low, down);
        nfloat_get_arf(h, high, up);
        arb_set_interval_arf(both, l, h, 8192);
        put("nfloat", names[i], bits, ns, both);
        arf_clear(l); arf_clear(h); arb_clear(both);
    }
    gr_heap_clear(a, down); gr_heap_clear(b, up); gr_heap_clear(c, down); gr_heap_clear(d, up);
    gr_heap_clear(low, down); gr_heap_clear(high, up);
    gr_ctx_clear(down); gr_ctx_clear(up);
}
#endif

int main(void)
{
    static const slong BITS[] = {53, 128, 256, 1024, 4096};
    for (size_t i = 0; i < sizeof BITS / sizeof *BITS; i++) {
        balls(BITS[i]);
#ifdef NFLOAT_RND_FLOOR
        directed(BITS[i]);
#endif
    }
    flint_cleanup();
    return 0;
}

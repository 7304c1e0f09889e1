/* Signs of b_{n,k} and c_n by Arb, timed, at the points that standard input lists: lines
 *
 *     family,distance,quantity,n,k,coordinates,x,y
 *
 * with quantity b or c, coordinates rs or a1a2 and x, y exact fractions. From 64 bits on the precision doubles until the sign is
 * certain, as a user of Arb would do it, up to 16384 bits. One line per point: family,distance,sign,bits,ns, where the sign is + or -,
 * or ? if it is not certain, bits is the last precision and ns the fastest of three batches of the whole search. Formulas:
 * quantities.h.
 *
 * With the argument "widths" nothing is timed: one line per point and precision of 53 to 4096 bits, family,distance,bits,lost, where
 * lost is how many of these bits the value's enclosure has not. */
#include "quantities.h"

/* The sign of the quantity at one precision: 1, -1, or 0 if it is not certain. */
static int sign_at(int polar, int c, ulong n, ulong k, const fmpq_t p, const fmpq_t q, slong bits)
{
    if (!quotient(polar, c, n, k, p, q, bits)) return 0;
    arb_mul(u, u, w, bits);
    return arb_is_positive(u) ? 1 : arb_is_negative(u) ? -1 : 0;
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
    set_up();
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

/* Values of b_{n,k} by Arb, timed, at the points that standard input lists: lines
 *
 *     family,n,k,coordinates,x,y,value
 *
 * with coordinates rs or a1a2, x, y exact fractions and a decimal value. One line per point and precision of 128 to 4096 bits:
 * family,bits,digits,holds,ns,ns,ns, where digits are the certain decimal ones, holds is 1 if the ball touches the value (within
 * its last digits), and ns are the times of three batches. Formulas: quantities.h. */
#include "quantities.h"

int main(void)
{
    set_up();
    char *line = NULL;
    size_t room = 0;
    fmpq_t p, q;
    arb_t value, ball;
    fmpq_init(p); fmpq_init(q);
    arb_init(value); arb_init(ball);
    while (getline(&line, &room, stdin) > 0) {
        char *part[7], *rest = line;
        for (int i = 0; i < 7; i++) part[i] = strsep(&rest, ",\n");
        if (!part[6] || fmpq_set_str(p, part[4], 10) || fmpq_set_str(q, part[5], 10) || arb_set_str(value, part[6], 16384)) {
            fprintf(stderr, "a line that is no point\n");
            return 2;
        }
        /* It has 1240 digits. */
        mag_t last;
        mag_init(last);
        arb_get_mag(last, value);
        mag_mul_2exp_si(last, last, -4090);
        arb_add_error_mag(value, last);
        mag_clear(last);
        int polar = part[3][0] == 'r';
        ulong n = strtoul(part[1], NULL, 10), k = strtoul(part[2], NULL, 10);
        for (slong bits = 128; bits <= 4096; bits *= 2) {
            double times[4];
            long calls = 1;
            /* The first batch only finds out how many calls a batch is, and fills Arb's caches. */
            for (int batch = 0; batch < 4; batch++) {
                double start = now();
                for (long i = 0; i < calls; i++)
                    if (quotient(polar, 0, n, k, p, q, bits)) arb_div(ball, u, w, bits);
                    else arb_indeterminate(ball);
                times[batch] = (now() - start) / calls;
                if (!batch) calls = times[0] > 2e6 ? 1 : 2e6 / times[0];
            }
            slong certain = arb_rel_accuracy_bits(ball);
            printf("%s,%ld,%.1f,%d,%.0f,%.0f,%.0f\n", part[0], bits, certain > 0 ? certain * 0.30103 : 0.0, arb_overlaps(ball, value),
                   times[1], times[2], times[3]);
        }
    }
    return 0;
}

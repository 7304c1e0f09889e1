/* Theorem 2 decided for n = 3 to N in plain C, two ways, to be timed beside `grazing verify`.

   walk N: every cut of (0, 1/2) that matters, from left to right, as src/existence/decide.rs says: where two b of opposite sign are
   known, to the first zero of either; else all k are tried. Prints the pieces by kind, as `grazing verify` counts them.
   intervals N: the intervals of Theorem 2 alone, without what lies between. No fraction of order below n lies inside one, so all
   signs are those at the mediant of its ends, found for k = 1 to n/2 by increments. Prints the intervals.

   Both stop with exit code 1 where a sign is not the theorem's. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef uint64_t u;
typedef struct { u p, q; } ratio;

static u gcd(u a, u b)
{
    while (b) { u r = a % b; a = b; b = r; }
    return a;
}

/* The x in 1..n with m x = 1 modulo n. */
static u inverse(u m, u n)
{
    int64_t a = n, b = m, x = 0, y = 1;
    while (b) { int64_t k = a / b, r = a - k * b, z = x - k * y; a = b; b = r; x = y; y = z; }
    return x <= 0 ? x + n : x;
}

/* Just right of s: the sign of sin j pi s, of b_{n,k} and of c_n. */
static int sine(u j, ratio s) { return (j * s.p / s.q) % 2 ? -1 : 1; }
static int cosine(u n, ratio s) { return ((2 * n * s.p + s.q) / (2 * s.q)) % 2 ? -1 : 1; }
static int sign_b(u n, u k, ratio s) { return -sine(k, s) * sine(n - k, s) * cosine(n, s); }
/* The same at s itself, where cos n pi s is not 0. */
static int b_at(u n, u k, ratio s) { return k * s.p % s.q && (n - k) * s.p % s.q ? sign_b(n, k, s) : 0; }

/* The first k with this sign of b just right of s, or at s; 0 if there is none. */
static u first(u n, ratio s, int sign, int at)
{
    u low = 0, high = n * s.p % (2 * s.q);
    int outer = -cosine(n, s);
    for (u k = 1; k <= n / 2; k++) {
        low += s.p;
        if (low >= 2 * s.q) low -= 2 * s.q;
        high += high < s.p ? 2 * s.q - s.p : -s.p;
        int b = outer * (low < s.q ? 1 : -1) * (high < s.q ? 1 : -1);
        if (at && (low % s.q == 0 || high % s.q == 0)) continue;
        if (b == sign) return k;
    }
    return 0;
}

/* The next multiple of 1/j after s, if it comes before `next`. */
static ratio sooner(ratio next, ratio s, u j)
{
    ratio other = { j * s.p / s.q + 1, j };
    return other.p * next.q < next.p * other.q ? other : next;
}

/* The term of F_order after s: the k < n whose next multiple comes first. */
static ratio next_term(ratio s, u order)
{
    ratio l = { 0, 1 }, r = { 1, 1 };
    while (l.q + r.q <= order) {
        ratio m = { l.p + r.p, l.q + r.q };
        if (m.p * s.q <= s.p * m.q) {
            u most = (order - l.q) / r.q, d = s.p * l.q - l.p * s.q, e = r.p * s.q - s.p * r.q, run = d / e;
            if (run > most) run = most;
            l.p += run * r.p; l.q += run * r.q;
        } else {
            u most = (order - r.q) / l.q, d = s.p * l.q - l.p * s.q, e = r.p * s.q - s.p * r.q, run = d ? (e - 1) / d : most;
            if (run > most) run = most;
            r.p += run * l.p; r.q += run * l.q;
        }
    }
    return r;
}

static u count[5];
enum { ORBIT, STRETCH, SINGULAR, BOUNDARY, EXCLUDED };

static void walk(u n)
{
    ratio s = { 0, 1 };
    u known[2] = { 0, 0 }, before[2] = { 0, 0 };
    /* The theorem's next interval, by m. */
    u m = 0, half = 0;
    for (;;) {
        before[0] = known[0]; before[1] = known[1];
        u nearest = (2 * n * s.p / s.q + 1) / 2, g = gcd(nearest, n);
        u guesses[2] = { (s.q + s.p) / (s.p ? 2 * s.p : 1), g > 1 ? n / g : inverse(nearest, n) };
        for (int i = 0; i < 2; i++) {
            int sign = 1 - 2 * i;
            if (known[i] && sign_b(n, known[i], s) == sign) continue;
            known[i] = 0;
            for (int j = 0; j < 2 && !known[i]; j++)
                if (guesses[j] && guesses[j] < n && sign_b(n, guesses[j], s) == sign) known[i] = guesses[j];
            if (!known[i]) known[i] = first(n, s, sign, 0);
        }
        if (s.p) {
            if (2 * n * s.p % s.q == 0) count[SINGULAR]++;
            else {
                u found[2] = { 0, 0 };
                for (int i = 0; i < 2 && before[0] && before[1] && known[0] && known[1]; i++) {
                    if (b_at(n, before[i], s)) found[i] = before[i];
                    else if (b_at(n, known[i], s)) found[i] = known[i];
                    else found[i] = first(n, s, 1 - 2 * i, 1);
                }
                count[found[0] && found[1] ? EXCLUDED : BOUNDARY]++;
            }
        }
        ratio next = { 2 * n * s.p / s.q + 1, 2 * n };
        if (known[0] && known[1]) {
            for (int i = 0; i < 2; i++) { next = sooner(next, s, known[i]); next = sooner(next, s, n - known[i]); }
            count[STRETCH]++;
        } else {
            ratio term = next_term(s, n - 1);
            if (term.p * next.q < next.p * term.q) next = term;
            /* Theorem 2: what this interval should be. */
            ratio l = { 0, 1 }, r = { 1, 2 * n };
            int b = -1, c = -1;
            if (m) {
                u plus = inverse(m, n), quotient = (m * plus - 1) / n;
                ratio at = { m, n }, left = { quotient, plus }, right = { m - quotient, n - plus }, start = { 1, 2 * n };
                l = half ? at : m == 1 ? start : left;
                r = half ? right : at;
                b = 1; c = half ? -1 : 1;
            }
            int same = s.p * l.q == l.p * s.q && next.p * r.q == r.p * next.q;
            if (!same || (known[0] != 0) != (b > 0) || -sine(n, s) * cosine(n, s) != c) exit(1);
            count[ORBIT]++;
            if (m && !half && 2 * m < n) half = 1;
            else { half = 0; do m++; while (2 * m <= n && gcd(m, n) > 1); }
        }
        u d = gcd(next.p, next.q);
        s.p = next.p / d; s.q = next.q / d;
        if (2 * s.p == s.q) break;
    }
    if (2 * m <= n) exit(1);
}

/* Whether all b have the sign b at s, which is no cut, and c_n the sign c. */
static void interval(u n, ratio l, ratio r, int b, int c)
{
    uint32_t p = l.p + r.p, q = l.q + r.q, low = 0, high = n * p % (2 * q), twice = 2 * q, half = n / 2;
    ratio s = { p, q };
    int same = cosine(n, s) * b < 0, bad = 0;
    for (uint32_t k = 0; k < half; k++) {
        low += p;
        low -= low >= twice ? twice : 0;
        high += high < p ? twice - p : -p;
        bad |= ((low < q) == (high < q)) != same;
    }
    if (bad || -sine(n, s) * cosine(n, s) != c) exit(1);
    count[ORBIT]++;
}

static void intervals(u n)
{
    ratio zero = { 0, 1 }, start = { 1, 2 * n };
    interval(n, zero, start, -1, -1);
    for (u m = 1; 2 * m <= n; m++) {
        if (gcd(m, n) > 1) continue;
        u plus = inverse(m, n), quotient = (m * plus - 1) / n;
        ratio at = { m, n }, left = { quotient, plus }, right = { m - quotient, n - plus };
        interval(n, m == 1 ? start : left, at, 1, 1);
        if (2 * m < n) interval(n, at, right, 1, -1);
    }
}

int main(int argc, char **argv)
{
    if (argc != 3) return 2;
    void (*decide)(u) = strcmp(argv[1], "walk") ? intervals : walk;
    for (u n = 3, last = strtoull(argv[2], NULL, 10); n <= last; n++) decide(n);
    printf("%llu %llu %llu %llu %llu\n", (unsigned long long) count[0], (unsigned long long) count[1],
           (unsigned long long) count[2], (unsigned long long) count[3], (unsigned long long) count[4]);
    return 0;
}

/* The plain closed-form event loop, timed: q'' = -(2d/w) q' - q/w^2 above the wall (1 + mu) cos t - 1, restitution 1, from (q, u) = (0.01, 0) at t = 1.
 * Between impacts the solution is evaluated from the last impact; per period it starts Newton's method for the minimum of the gap at the wall's
 * summit, and for the impact at the parabola's root. Usage: simulation [PERIODS]. Prints: impacts microseconds_per_period. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static const double d = 0.6, w = 4.9, mu = 0.003, tau = 1;
static double c, s, omega, t0, q0, u0; /* motion since the last impact */

/* Displacement, velocity, acceleration at t. */
static void motion(double t, double *q, double *u, double *a)
{
    double e = exp(-c / 2 * (t - t0)), C = cos(omega * (t - t0)), S = sin(omega * (t - t0)) / omega;
    *q = e * (C * q0 + S * (u0 + c / 2 * q0));
    *u = e * (C * u0 - S * (s * q0 + c / 2 * u0));
    *a = -c * *u - s * *q;
}

/* The gap and its derivatives at t, the wall's phase being t. */
static void gap(double t, double *z, double *v, double *b)
{
    double q, u, a, C = cos(t), S = sin(t);
    motion(t, &q, &u, &a);
    *z = q + 1 - (1 + mu) * C;
    *v = u + (1 + mu) * S;
    *b = a + (1 + mu) * C;
}

int main(int argc, char **argv)
{
    long periods = argc > 1 ? atol(argv[1]) : 1000000, impacts = 0;
    const double period = 2 * M_PI;
    struct timespec start, end;
    c = 2 * d / w, s = 1 / (w * w), omega = sqrt(s - c * c / 4);
    t0 = 1, q0 = 0.01, u0 = 0;
    clock_gettime(CLOCK_MONOTONIC, &start);
    for (long n = 0; n < periods; n++) {
        /* The window of this period is (pi/2, 5 pi/2), its summit at 2 pi; time starts anew in each. */
        double from = n == 0 ? t0 : M_PI / 2, summit = period;
        for (;;) {
            double t = summit, z, v, b;
            for (int i = 0; i < 30; i++) {
                gap(t, &z, &v, &b);
                double step = v / b;
                t -= step;
                if (fabs(step) < 1e-8) break;
            }
            gap(t, &z, &v, &b);
            if (!(t > from + 1e-9) || z >= 0 || b < 0 || t > summit + M_PI / 2) break;
            double low = from, high = t;
            t -= sqrt(-2 * z / b);
            for (int i = 0; i < 100; i++) {
                if (!(t > low && t < high)) t = (low + high) / 2;
                gap(t, &z, &v, &b);
                if (z > 0) low = t; else high = t;
                double step = z / v;
                t -= step;
                if (step * step * fabs(b) < 1e-17 * fabs(v) || high - low < 1e-15) break;
            }
            double q, u, a;
            motion(t, &q, &u, &a);
            q0 = q, u0 = -tau * u - (1 + tau) * (1 + mu) * sin(t), t0 = t, from = t;
            impacts++;
        }
        t0 -= period;
    }
    clock_gettime(CLOCK_MONOTONIC, &end);
    printf("%ld %.4f\n", impacts, ((end.tv_sec - start.tv_sec) * 1e6 + (end.tv_nsec - start.tv_nsec) / 1e3) / periods);
    return 0;
}

/* The motions of motions.py by a plain loop: Runge and Kutta's method of order 4 with fixed steps; where a step ends behind the
 * wall, its length is bisected to the impact. A rebound slower than 1e-9 onto a wall that presses is rest, until it presses no more.
 * What passes behind the wall and back within a step is missed, as such loops miss it.
 *
 * Reads the lines of motions.py; prints a line per motion and number of steps per period: name|steps|impacts|ns ns ...|state, each
 * time the mean of a period over a whole run. Usage: motions PERIODS RUNS. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { MOST = 16 };
static int n;
static double cubic, friction, width, force, offset, wall, restitution, slowest;
static double damping[MOST], stiffness[MOST], amplitude[MOST], row[MOST], start[MOST];

static void field(double t, const double *y, double *f)
{
    double c = cos(t);
    for (int i = 0; i < n; i++) {
        double q = y[i], u = y[n + i];
        f[i] = u;
        f[n + i] = -damping[i] * u - stiffness[i] * q - cubic * q * q * q - (friction ? friction * tanh(u / width) : 0) + force + amplitude[i] * c;
    }
}

static void step(double t, double h, const double *y, double *out)
{
    double a[2 * MOST], b[2 * MOST], c[2 * MOST], d[2 * MOST], z[2 * MOST] = {0};
    field(t, y, a);
    for (int i = 0; i < 2 * n; i++) z[i] = y[i] + h / 2 * a[i];
    field(t + h / 2, z, b);
    for (int i = 0; i < 2 * n; i++) z[i] = y[i] + h / 2 * b[i];
    field(t + h / 2, z, c);
    for (int i = 0; i < 2 * n; i++) z[i] = y[i] + h * c[i];
    field(t + h, z, d);
    for (int i = 0; i < 2 * n; i++) out[i] = y[i] + h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
}

static double gap(double t, const double *y)
{
    double z = -offset - wall * cos(t);
    for (int i = 0; i < n; i++) z += row[i] * y[i];
    return z;
}

static double rate(double t, const double *y)
{
    double z = wall * sin(t);
    for (int i = 0; i < n; i++) z += row[i] * y[n + i];
    return z;
}

/* The gap's acceleration. */
static double push(double t, const double *y)
{
    double f[2 * MOST], z = wall * cos(t);
    field(t, y, f);
    for (int i = 0; i < n; i++) z += row[i] * f[n + i];
    return z;
}

/* On the wall, moving with it: one mode. */
static void on_wall(double t, double *y)
{
    y[0] = offset + wall * cos(t);
    y[1] = -wall * sin(t);
}

static long follow(int periods, int steps, double *y)
{
    long impacts = 0;
    int resting = 0, touching = 0;
    double mobility = 0, h = 2 * M_PI / steps, z[2 * MOST];
    for (int i = 0; i < n; i++) mobility += row[i] * row[i];
    for (int i = 0; i < n; i++) y[i] = start[i], y[n + i] = 0;
    for (int period = 0; period < periods; period++)
        for (int j = 0; j < steps; j++) {
            double t = j * h, end = (j + 1) * h;
            while (t < end) {
                if (resting) {
                    on_wall(end, z);
                    if (push(end, z) <= 0) {
                        memcpy(y, z, sizeof *y * 2 * n);
                        break;
                    }
                    double low = t, high = end;
                    for (int i = 0; i < 60; i++) {
                        double middle = (low + high) / 2;
                        on_wall(middle, z);
                        if (push(middle, z) <= 0) low = middle; else high = middle;
                    }
                    on_wall(high, y);
                    t = high;
                    resting = 0;
                    touching = 1;
                    continue;
                }
                step(t, end - t, y, z);
                /* After an impact the gap is 0 to rounding and opens until this length. */
                double low = 0, high = end - t;
                if (touching) {
                    double a = push(t, y);
                    low = a < 0 ? fmin(-rate(t, y) / a, high) : high;
                }
                touching = 0;
                if (low == high || gap(end, z) >= 0) {
                    memcpy(y, z, sizeof *y * 2 * n);
                    break;
                }
                /* The last length at which the gap is open. */
                for (int i = 0; i < 60; i++) {
                    double middle = (low + high) / 2;
                    step(t, middle, y, z);
                    if (gap(t + middle, z) >= 0) low = middle; else high = middle;
                }
                step(t, high, y, z);
                memcpy(y, z, sizeof *y * 2 * n);
                t += high;
                double v = fmin(rate(t, y), 0);
                touching = 1;
                for (int i = 0; i < n; i++) y[n + i] -= (1 + restitution) * v * row[i] / mobility;
                if (-v > slowest) impacts++;
                if (-restitution * v < 1e-9 && push(t, y) < 0 && n == 1) resting = 1, on_wall(t, y);
            }
        }
    return impacts;
}

int main(int argc, char **argv)
{
    int periods = argc > 1 ? atoi(argv[1]) : 10, runs = argc > 2 ? atoi(argv[2]) : 5;
    char *line = NULL;
    size_t room = 0;
    while (getline(&line, &room, stdin) > 0) {
        char *rest = strchr(line, '|');
        *rest++ = 0;
        n = strtol(rest, &rest, 10);
        double *scalars[] = {&cubic, &friction, &width, &force, &offset, &wall, &restitution, &slowest};
        for (int i = 0; i < 8; i++) *scalars[i] = strtod(rest, &rest);
        double *lists[] = {damping, stiffness, amplitude, row, start};
        for (int k = 0; k < 5; k++)
            for (int i = 0; i < n; i++) lists[k][i] = strtod(rest, &rest);
        for (int steps = 32; steps <= 32768; steps *= 4) {
            double y[2 * MOST];
            long impacts = follow(periods, steps, y);
            printf("%s|%d|%ld|", line, steps, impacts);
            for (int i = 0; i < runs; i++) {
                struct timespec from, to;
                clock_gettime(CLOCK_MONOTONIC, &from);
                follow(periods, steps, y);
                clock_gettime(CLOCK_MONOTONIC, &to);
                printf(" %.0f", ((to.tv_sec - from.tv_sec) * 1e9 + (to.tv_nsec - from.tv_nsec)) / periods);
            }
            printf("|");
            for (int i = 0; i < 2 * n; i++) printf(" %.17g", y[i]);
            printf("\n");
        }
    }
    return 0;
}

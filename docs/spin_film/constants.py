"""The four constants of cases/spin_film_guo2013, from the twelve printed films: python3 docs/spin_film/constants.py

Least squares of the relative deviations; then, at each ellipticity, the other three alone: how well each is known, and what that means
for films at another load. Needs numpy and scipy."""
import numpy as np
from scipy.optimize import least_squares

MODULUS = 2.26e11  # [Pa] bearing steel, E/(1 - nu^2)
MOTIONS = [(500, 5, 200), (500, 10, 300), (500, 15, 400)]  # [N], [m/s], [rad/s]
PRINTED = np.array([[0.4040, 0.4041, 0.3268, 0.3210], [0.6428, 0.6429, 0.5236, 0.4891], [0.8435, 0.8436, 0.6898, 0.6015]])
OTHERS = [(1500, 5, 200), (1500, 10, 300), (1500, 15, 400)]


def films(radius, ellipticity, viscosity, pressure_viscosity, motion):
    """Central and least film [um], of Hamrock and Dowson and with spin, in the order of the printed columns."""
    load, rolling, spin = motion
    k, g, f = ellipticity, pressure_viscosity * MODULUS, load / (MODULUS * radius**2)
    v, s = rolling * viscosity / (MODULUS * radius), spin * viscosity / MODULUS
    central = 0.769 * v**0.67 * f**-0.067 * g**0.53 * k**0.434 * (1 + 1.753 * np.exp(-0.179 * k))
    least = (8.9e-3 * v**0.72 * (1 + 1.043 * np.exp(-664.016 * f)) * g**0.801 * k**1.616 * (1 + 21.46 * np.exp(-0.3 * k))
             * max(0.0, 1 - 1.31e10 * s**1.024))
    central_hd = 2.69 * v**0.67 * g**0.53 * f**-0.067 * (1 - 0.61 * np.exp(-0.73 * k))
    least_hd = 3.63 * v**0.68 * g**0.49 * f**-0.073 * (1 - np.exp(-0.68 * k))
    return 1e6 * radius * np.array([central_hd, central, least_hd, least])


def table(logarithms, ellipticity, motions):
    radius, viscosity, pressure_viscosity = np.exp(logarithms)
    return np.array([films(radius, ellipticity, viscosity, pressure_viscosity, motion) for motion in motions])


def deviations(logarithms, ellipticity):
    return (table(logarithms, ellipticity, MOTIONS) / PRINTED - 1).ravel()


def main():
    start = np.log([5e-3, 0.02, 2e-8])
    best = least_squares(lambda x: deviations(x[:3], x[3]), [*start, 7.0], x_scale=[1, 1, 1, 3], xtol=1e-14, ftol=1e-14)
    radius, viscosity, pressure_viscosity = np.exp(best.x[:3])
    print(f"best: R_x {1e3 * radius:.3f} mm, ellipticity {best.x[3]:.3f}, viscosity {viscosity:.5f} Pa s, "
          f"pressure-viscosity {1e9 * pressure_viscosity:.2f} 1/GPa; worst deviation {100 * abs(best.fun).max():.2f} %")
    print("singular values of the slopes:", np.linalg.svd(best.jac)[1])
    middle = table(best.x[:3], best.x[3], OTHERS)
    print("films at 1500 N [um]:\n", middle.round(4))
    print("ellipticity held | worst deviation [%] | R_x [mm] | viscosity [Pa s] | 1/GPa | largest change at 1500 N [%]")
    for k in (5, 6, 7, 7.5, 8, 8.5, 9, 9.5):
        fit = least_squares(deviations, start, args=(k,))
        r, eta, alpha = np.exp(fit.x)
        change = abs(table(fit.x, k, OTHERS) / middle - 1).max()
        print(f"{k:5.1f} | {100 * abs(fit.fun).max():.2f} | {1e3 * r:.3f} | {eta:.5f} | {1e9 * alpha:.2f} | {100 * change:.2f}")


if __name__ == "__main__":
    main()

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// An elastic column that carries no tension, standing on a slope under its own weight. Of rigid
/// blocks it topples at tan θ = h/L; elastic ones lean, which moves their weight downhill, and
/// where the line of thrust leaves the middle third only part of the section is pressed:
///
///   y″ = κ(N, e),   e = M/N,   M(z) = ∫ q [c (y(z′) − y(z)) + s (z′ − z)] dz′ over z′ > z
///   κ = N e/(E I)                   for e ≤ h/6
///   κ = 2 N / (9 E h (h/2 − e)²)    for e > h/6: a triangle of pressure of width 3 (h/2 − e)
///
/// with c, s = cos θ, sin θ; y(0) = y′(0) = 0. Euler–Bernoulli. Blocks do carry tension inside,
/// only their joints don't, so a stack of blocks stands at least about as steep as the column.
namespace stiction::reference {

struct Column {
  double height = 1.0;            ///< L, m
  double width = 0.1;             ///< h, of the square section, m
  double youngs_modulus = 1e7;    ///< E, Pa
  double weight_density = 9810.;  ///< N/m³
};

/// Deflection of the top, m; infinite if there is no equilibrium.
double top_deflection(const Column& column, double tan_slope);

/// The steepest tan θ at which there is an equilibrium, to 1e-4 of h/L, from below.
double critical_tan(const Column& column);

}  // namespace stiction::reference

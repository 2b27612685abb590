/// Normal contact of a single line of elements, each as long as the contact: strips.
///
/// The problem of normal_contact.hpp with one element along the rail,
///   g = h + K p - approach >= 0,  p >= 0,  p g = 0,  K[i, j] = I(0, (i - j) b)/(pi E*),
/// I from influence_coefficients.hpp (Love 1929) for elements of length x step. Next to a strip
/// that is plane strain, u = -2/(pi E*) integral p ln|y - y'| dy' (Johnson, Contact Mechanics,
/// 1985, eq. 2.24a); the length sets the constant. Solved by conjugate gradients on the contact
/// (Polonsky & Keer, Wear 231 (1999) 206-219, with the approach prescribed), sums by transforms.
/// Units mm, N, MPa. Thread rule: a pure function, which plans transforms as
/// half_space/fft.hpp says, and throws its Error(out_of_memory). Not known here: where the strips
/// lie.
#pragma once

#include <span>
#include <vector>

namespace wrc {

struct StripProblem {
  double step = 0.0;                           ///< b, across, mm
  double length = 0.0;                         ///< along, mm
  double combined_modulus = 0.0;               ///< E*, MPa
  double approach = 0.0;                       ///< mm
  std::span<const double> undeformed_distance; ///< h at the strips' centres, mm
  /// The iteration ends when a step changes no pressure by more, relative to the largest one.
  double tolerance = 1e-4;
};

/// Displacements at the centres of strips under these pressures, mm.
std::vector<double> displacements_of_strips(double step, double length, double combined_modulus,
                                            std::span<const double> pressure);

/// Mean pressures of the strips, MPa, from a first guess of the same length. After a fixed number
/// of steps the last ones are returned.
std::vector<double> solve_strips(const StripProblem& problem, std::vector<double> pressure);

} // namespace wrc

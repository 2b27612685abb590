/// Constants of behaviour of this room: transforms, influence coefficients and materials.
///
/// Each with its origin: published (with author) or derived, bound, measured (with the program that
/// measures it) or reasoned. `scripts/list_constants.sh` prints them all.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace wrc {

// Transforms (fft.hpp, box_convolution.hpp).

/// Alignment of arrays.
/// origin: derived: bytes of a cache line and of the widest vector register.
inline constexpr std::size_t vector_alignment = 64;

/// Lines that are transformed together.
/// origin: derived: four single-precision complex values fill half a vector register of 64 bytes
/// and one of 32, so all instruction sets are served.
inline constexpr std::size_t block_lines = 4;

/// FFTW's tables when it first plans, in both precisions, and what a plan takes.
/// origin: bound: 0.4 MB; 16 kB and 3 complex values per element of a line, rounded up.
inline constexpr std::size_t fft_memory_of_tables = std::size_t{1} << 20;
inline constexpr std::size_t fft_memory_of_plan = std::size_t{1} << 16;
inline constexpr std::size_t fft_memory_per_value = 64;

/// Lines from this length on are fast one by one.
/// origin: measured: single-precision lines of 12 to 32 values take 24 to 72 ns each in blocks,
/// 83 to 230 ns one by one (docs/evidence/performance.md).
inline constexpr std::size_t min_lone_line = 48;

/// The longest line with odd factors above 5.
/// origin: measured: longer ones are slower than the next power of two times 1, 3 or 5.
inline constexpr std::size_t max_odd_line = 400;

/// Rows that are transposed together, as pairs.
/// origin: derived: eight single-precision complex values fill a cache line of 64 bytes.
inline constexpr std::size_t transposed_rows = 8;

// Influence coefficients and materials.

/// From this distance on, in units of the element's longer side, the expansion is used.
/// origin: derived: the expansion of order six is accurate to 3e-13 there
/// (influence_coefficients.hpp).
inline constexpr double far_field_distance = 16.0;

/// Relative change of the ratio of an element's sides by which its coefficients are differentiated.
/// origin: derived: the differences' own error and rounding are both below 1e-6.
inline constexpr double aspect_step = 1e-4;

/// Farthest offset upstream that a difference needs.
/// origin: derived: the last of the weights.
inline constexpr std::size_t difference_reach = 2;

/// Fraction of the accuracy below which the effect of different materials counts as none.
/// origin: reasoned: too little to show in any result.
inline constexpr double negligible_material_effect = 1e-3;

/// Steels (steel.hpp): where the law begins, in yield stresses, its exponent and its stiffness.
/// origin: measured (pmax and area of 40 contacts by finite elements, yield stress 300 to 700 MPa,
/// evidence page half-space.md): 1.3 to 1.6 and 2.5 to 3, each with its best stiffness, fit as
/// well.
inline constexpr double yield_onset = 1.44;
inline constexpr double yield_exponent = 2.53;
inline constexpr double yield_stiffness = 0.373;

/// Excess over which steel pressed again begins to yield once more, in that of the pressing before:
/// with 0 the indentation would jump.
/// origin: measured (12 passes over two lobes and gauge corner at 80 kN, 500 MPa: 0.03 instead of
/// 0.003 changes pmax by 0.8 %, 0.1 by 2 %; with 0.003 the corner does not converge at 350 MPa, and
/// with 0.03 it takes more than twice the iterations of 0.1).
inline constexpr double yield_again_range = 0.05;

/// Range over which the estimate of yielded pressures saturates, in yield stresses.
/// origin: measured (the same contacts): their largest pressures, within 4 to 7 %.
inline constexpr double yield_estimate_range = 1.22;

struct SteelGrade {
  std::string_view name;
  double yield_stress;
  std::string_view source;
};
inline constexpr std::string_view of_wheel_grade = "EN 13262, the least that it requires";
inline constexpr std::string_view of_rail_grade = "estimate: 0.55 of the tensile strength";
inline constexpr std::string_view of_hardened_grade = "estimate: 0.65 of the tensile strength";

/// Yield stresses by name, MPa.
/// origin: published (EN 13262, quoted from memory), and reasoned of rails: fractions of the
/// tensile strengths of EN 13674-1.
inline constexpr std::array steel_grades{SteelGrade{"ER6", 500.0, of_wheel_grade},
                                         SteelGrade{"ER7", 520.0, of_wheel_grade},
                                         SteelGrade{"ER8", 540.0, of_wheel_grade},
                                         SteelGrade{"ER9", 580.0, of_wheel_grade},
                                         SteelGrade{"R200", 370.0, of_rail_grade},
                                         SteelGrade{"R220", 420.0, of_rail_grade},
                                         SteelGrade{"R260", 480.0, of_rail_grade},
                                         SteelGrade{"R320Cr", 600.0, of_rail_grade},
                                         SteelGrade{"R350HT", 760.0, of_hardened_grade},
                                         SteelGrade{"R370CrHT", 830.0, of_hardened_grade},
                                         SteelGrade{"R400HT", 830.0, of_hardened_grade}};

/// Yield stress in shear of rails whose yield stress is not given, MPa.
/// origin: derived: 1/sqrt(3) of 520 MPa, between R260 and R320Cr.
inline constexpr double usual_shear_yield = 300.0;

/// K of bodies whose constants differ by rounding only.
/// origin: derived: four units in the last place of each of the terms of K, which are 0.25 at most.
inline constexpr double rounding_of_material_difference = 1e-15;

} // namespace wrc

/// Where contact begins within an element of a strip.
///
/// Behind the leading edge tractions without slip grow like the square root of the distance. An
/// element of which only the share c behind the edge is in contact stands for less of them than
/// a whole one; taken as whole, it puts the edge elsewhere, an error of first order in the
/// element's length. A compliance added to the influence of the element on itself,
///   (2/pi) beta (c_0 - c)/(c + 1 - c_0) in y, 1 - nu times that in x   (G = 1, element length 1),
/// puts it where it is. Derived for the half-plane, steady rolling without slip, on equal elements
/// with the differences of difference_of: changing one diagonal coefficient changes the solution by
/// a multiple of one field (Sherman & Morrison), so that the edge found from tractions far behind
/// is c_0 - kappa/(kappa + beta) for a compliance kappa; c_0 and beta are read off two solutions
/// (tests/core/rolling/leading_edge_test.cpp). The plane problem is then of second order wherever
/// its edge falls.
///
/// Not known here: edges that run obliquely through elements (in strips more than twice as narrow
/// as their shift from one to the next the edge found is off by a tenth of an element, which is
/// still of first order).
/// Thread rule: pure functions.
#pragma once

#include "half_space/traction_convolution.hpp"

namespace wrc {

/// In y, for a share c that is in contact, 0 to 1.
double edge_compliance(double covered);
double edge_compliance_rate(double covered); ///< by the share

/// From the share of each element in contact to its compliance: of the first elements under a bound
/// of strips, counted from the leading edge; 0 elsewhere. Fields as TractionConvolution has them.
template <typename Real>
void make_edges(const Real* bound, Real* edge, const TractionShape& shape, std::size_t pitch);

} // namespace wrc

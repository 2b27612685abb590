/// Where contact begins within an element of a strip.
///
/// Behind the leading edge tractions without slip grow like the square root of the distance. An
/// element of which only the fraction c behind the edge is in contact stands for less of them than
/// a whole one; taken as whole, it puts the edge elsewhere, an error of first order in the
/// element's length. A compliance added to the influence of the element on itself,
///   (2/pi) beta (1 - c)/c in y, 1 - nu times that in x   (G = 1, element length 1),
/// puts it where it is. Derived for the half-plane, steady rolling without slip, on equal elements
/// with the differences of difference_of, which put the edge at the end of a whole first element:
/// changing one diagonal coefficient changes the solution by a multiple of one field (Sherman &
/// Morrison), so that a compliance kappa moves the edge found from tractions far behind by
/// kappa/(kappa + beta), and the value of the first element falls by that fraction. That value is
/// then
///   f = F c^(-1/2)
/// times the mean of the tractions over the element. Its bound is raised alike, or strips that are
/// just below it would slip from their edge on; tractions are given as means. F and beta are read
/// off solutions (tests/core/rolling/leading_edge_test.cpp). The plane problem is then of second
/// order wherever its edge falls.
///
/// An edge that runs obliquely through the strips is found behind its true position, by a fraction
/// of its slope (`edge_advance`), which is smaller for tractions in x than for those in y; its
/// elements count as covered by more, the same on average over all positions of an edge, nothing
/// where it passes from one element to the next. Along a single
/// oblique edge that holds on average only: what is left is of first order still. Thread rule: pure
/// functions.
#pragma once

#include "half_space/traction_convolution.hpp"

namespace wrc {

/// Compliance in y for a fraction c that is in contact, 0 to 1.
double edge_compliance(double covered);
/// Derivative of the compliance in y that make_edges found, or of that in x over 1 - nu, by the
/// covered fraction; 0 for a whole element.
double edge_compliance_rate(double compliance, double covered);

/// f for such a fraction: the value of a first element over the mean of its tractions.
double edge_traction_ratio(double covered);

/// Replaces the covered fraction of each element that begins a strip by its compliance in x, writes
/// that in y behind all of them, and multiplies its bound by f. An element behind another one
/// begins its strip as far as the one ahead is not covered, so that nothing steps where an edge
/// enters the next element. Fields as TractionConvolution has them; `aspect`: an element's width
/// over its length. In a step of time the differences along x have the fraction `upstream` of the
/// weights, and so have compliances and what f is above 1.
template <typename Real>
void make_edges(Real* bound, Real* edge, const TractionShape& shape, std::size_t pitch,
                double aspect, double poisson, double upstream = 1.0);

} // namespace wrc

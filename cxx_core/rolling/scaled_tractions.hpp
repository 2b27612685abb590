/// A tangential problem without units, on the rectangle that holds the contact.
///
/// Tractions over mu times the largest pressure, slips times G over that, lengths in longitudinal
/// steps. Rows of constant x are counted from the leading edge (large x) downstream.
/// Slip that is given for each element is taken into the rigid slip, and so is what earlier
/// tractions and, between unlike bodies, pressures displace.
/// Thread rule: constant after construction.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "half_space/traction_convolution.hpp"
#include "rolling/rolling_problem.hpp"

namespace wrc {

/// Weights of displacements in slips, without units, and where their derivative is, in
/// elements upstream of the centre.
struct SlipDifferenceWeights {
  DifferenceWeights weights{};
  double place = 0.0;
  /// Fraction of them that differences along x have: 1 in rolling, 0 in a shift; of a step of time
  /// f/(f + h/d).
  double upstream = 1.0;
};

/// On grids of elements `times` as long as the problem's.
SlipDifferenceWeights difference_of(const RollingProblem& problem, double times = 1.0);

/// f + h/d, by which a step of time divides its equation.
double step_rate(const RollingProblem& problem);

/// r of the natural residual for elements of this influence on themselves.
double natural_step_of(const TractionShape& shape, std::array<double, 2> self_influence,
                       double upstream);

/// Lever of a strip's longitudinal tractions about the origin, on a grid with this first position
/// and step. A strip stands for its middle, and sums of middles exceed the moment by h^2/24 of the
/// slope that y Q(y) ends with, Q the strip's force: where contact ends at the grid's lateral
/// edges, Q falling to 0, that is a twelfth of the outermost strips' distances from the middle
/// (midpoint rule with the end correction of Euler and Maclaurin). Forces need no such correction:
/// in adhesion displacements that strips cause as a whole make up for it.
double lever_of(const RollingProblem& problem, std::size_t strip, double lateral_first,
                double lateral_step);

/// Forces, areas and power from tractions and slips of the whole grid; `pressure_power`: of the
/// slip that pressures of unlike bodies cause, N.
void sum_up(const RollingProblem& problem, double pressure_power, RollingSolution& solution);

class ScaledTractions {
public:
  /// The elements in contact, by their indices in the problem's grid.
  struct Box {
    TractionShape shape;
    std::size_t first_longitudinal = 0;
    std::size_t first_lateral = 0;
  };

  ScaledTractions(const RollingProblem& problem, LinePlans& plans);

  /// Nothing can be transmitted: no pressure or no friction.
  [[nodiscard]] bool empty() const { return box_.shape.rows == 0; }
  [[nodiscard]] const Box& box() const { return box_; }
  /// Contact may begin within elements.
  [[nodiscard]] bool has_edges() const {
    return !problem_.covered.empty() && problem_.motion == TangentialMotion::rolling;
  }
  /// That of the problem's own grid.
  [[nodiscard]] const SlipDifferenceWeights& difference() const { return difference_; }
  [[nodiscard]] double aspect() const { return aspect_; }
  [[nodiscard]] double bound() const { return bound_; }
  [[nodiscard]] double slip_scale() const { return slip_scale_; }
  /// By the problem's order, from rows downstream.
  [[nodiscard]] std::size_t element(std::size_t row, std::size_t column) const;
  [[nodiscard]] TractionTable table() const {
    return traction_table(aspect_, box_.shape.table_rows(), box_.shape.table_columns());
  }

  /// Of the columns of the box along a curve; none: a plane.
  [[nodiscard]] std::span<const double> angles() const {
    return problem_.angles.empty()
               ? problem_.angles
               : problem_.angles.subspan(box_.first_lateral, box_.shape.columns);
  }
  /// What tractions on the box displace.
  template <typename Real>
  [[nodiscard]] TractionConvolution<Real>
  convolution(std::size_t pitch, const DifferenceWeights& weights, LinePlans& plans) const {
    return TractionConvolution<Real>(box_.shape, pitch, problem_.poisson, weights, table(), plans,
                                     angles());
  }

  /// Mean traction of an element in contact over the value that stands for it, from its bound
  /// without units after make_edges: 1 but where a strip begins.
  [[nodiscard]] double mean_share(std::size_t element, double bound) const;

  template <typename Real> void fill_bound(Real* bound, std::size_t pitch) const;
  /// The problem's covered fractions; only if there are any.
  template <typename Real> void fill_covered(Real* covered, std::size_t pitch) const;
  /// Rigid slip at the centres of elements 2^level times as large, x components first.
  template <typename Real>
  void fill_rigid_slip(Real* slip, const TractionShape& shape, std::size_t pitch,
                       std::size_t level) const;
  /// The rigid slip for a creepage of 1: longitudinal, lateral or, per step, spin.
  template <typename Real>
  void fill_slip_rate(std::size_t creepage, Real* slip, std::size_t pitch) const;
  /// Derivatives of the forces, the moment and the weighted force from rates of the tractions for
  /// such a slip; bounds as for mean_share.
  template <typename Real>
  [[nodiscard]] std::array<double, 4> force_rates(std::size_t creepage, const Real* rate,
                                                  const Real* bound, std::size_t pitch) const;
  /// Fills in RollingSolution::displacement_x and -y from tractions without units and edges as
  /// make_edges has them.
  void displace(std::span<const double> traction, std::span<const double> bound,
                std::span<const double> edge, LinePlans& plans, RollingSolution& solution) const;
  /// The problem's tractions without units, x components first.
  void read_tractions(std::span<const double> x, std::span<const double> y, double* traction,
                      std::size_t pitch) const;
  /// Mean tractions and slips; bounds as for mean_share.
  template <typename Real>
  void read_back(const Real* traction, const Real* slip, const Real* bound, std::size_t pitch,
                 RollingSolution& solution) const;
  /// Power over the speed of the slip that pressures cause, N.
  [[nodiscard]] double power_by_pressure(const RollingSolution& solution) const;

private:
  void find_box();
  void limit_slip();
  void take_in_previous(LinePlans& plans);
  void take_in_pressure(LinePlans& plans);
  void lessen_first_elements(const std::vector<double>& pressure);
  void take_in_slip();
  [[nodiscard]] std::array<double, 2> given_slip_at(std::size_t row, std::size_t column,
                                                    std::size_t level) const;

  const RollingProblem& problem_;
  Box box_;
  double aspect_ = 1.0;
  double bound_ = 0.0;      ///< mu times the largest pressure, MPa: a traction without units of 1
  double slip_scale_ = 0.0; ///< likewise of slips; of a step of time f + h/d times that
  SlipDifferenceWeights difference_;
  /// Slip given for each element, from previous tractions or from pressures, without units; empty:
  /// none.
  std::vector<double> given_slip_;
};

} // namespace wrc

/// What pressures answer a small change of the gap, with the elements in contact staying the same.
///
/// While the contact set C = {p > 0} does not change, the contact problem h + u = approach on C is
/// linear: at a prescribed position a change dh of the undeformed distance is answered by
///   A_CC dp = -dh_C,   dp = 0 elsewhere,   dN = a b sum dp
/// (A: influence_coefficients.hpp; the derivative of the solution of the complementarity problem,
/// Cottle, Pang & Stone, The Linear Complementarity Problem, 1992, section 7.2). An element that
/// touches without pressure is left out: the derivative is then that of the direction in which it
/// parts. Pressures of the discrete problem are piecewise linear in the position, so the derivative
/// jumps a little where an element joins or leaves.
/// A_CC is symmetric, so sums of pressures need not be solved for each change: with A_CC f = w,
///   sum w dp = -sum f dh
/// for any dh; `w` = 1 on one patch gives its normal force's derivative by every motion.
///
/// Of bodies that yield A is the stiffness H of mechanics/yielding.hpp, symmetric as well, and with
/// its preconditioner.
///
/// Conjugate gradients on the elements of C, the convolution exact and linear in double precision
/// on the box around C, preconditioned by the inverse of the periodic convolution as in
/// projected_cg.hpp. Unknowns are the elements' forces, p a b, which keeps several grids together
/// symmetric. Solutions are kept until the contact changes: the next right-hand side starts from
/// the combination of them that has the least energy of the error. Iteration stops when the
/// energy of the error, estimated by <r, M r>, is at most tolerance^2 of the solution's energy.
/// A force found with it is then right to about `tolerance` times the geometric mean of the two
/// energies, its own and that of the change; if both are the same (the stiffness against a shift
/// along the normal) to about the square of that, down to 1e-8 in rough contacts.
/// Units mm, N, MPa. Thread rule: one object serves one thread at a time; so does its cache.
/// Not known here: where the gap's change comes from (derivatives/gap_rates.hpp), and friction.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "half_space/box_convolution.hpp"
#include "half_space/steel.hpp"
#include "mechanics/cascade.hpp"
#include "mechanics/coupled_influence.hpp"
#include "mechanics/normal_contact.hpp"

namespace wrc {

struct StiffnessOutcome {
  int iterations = 0; ///< one linear and one periodic convolution each; of the patch with most
  StopReason stop_reason = StopReason::tolerance_met;
  double error = 0.0; ///< square root of the estimated fraction of the energy that is left
};

class ContactStiffness {
public:
  /// The cache must outlive the object.
  explicit ContactStiffness(InfluenceCache& cache) : cache_(cache) {}

  /// The contact of the following solutions; what is given is not needed afterwards, except the
  /// influence (none: the patches do not interact).
  /// Throws Error(invalid_argument) for grids, sizes or a modulus outside their range.
  void set_contact(std::span<const SolvedPatch> patches, double combined_modulus,
                   PatchInfluence* influence = nullptr,
                   std::span<const YieldingBody> yielding = {});

  /// Pressures x, MPa, with A_CC x = b and x = 0 outside C: b and x have one field a patch, in mm
  /// and MPa. An empty field of b counts as 0, and so do values outside C.
  /// Throws Error(invalid_argument) for sizes, and for a tolerance that is not positive.
  StiffnessOutcome solve(std::span<const std::span<const double>> displacement,
                         std::vector<std::vector<double>>& pressure, double tolerance = 1e-8,
                         int maximum_iterations = 5000);

  /// What a patch's pressures, those of solvers, displace at it, mm, the indentation of steel that
  /// yields included, and how that changes with the logarithm of the
  /// lateral step. (Displacements are lengths: with both steps they grow by themselves.)
  struct Displacements {
    std::vector<double> displacement;
    std::vector<double> by_lateral_step;
    /// Along a curve, per mm by which its elements move to the field side, and per unit by which
    /// they grow across: their rows turn. Empty in a plane.
    std::vector<double> by_place;
    std::vector<double> by_spread;
  };
  Displacements displacements_of(std::size_t patch, std::span<const double> pressure);

private:
  struct Patch {
    Grid grid;
    Elements elements = Elements::constant;
    bool in_contact = false;
    ElementBox box;
    std::size_t begin = 0;      ///< of the box's elements among those of all boxes
    double unit = 1.0;          ///< displacement = unit * K * force
    double self = 1.0;          ///< of an element at itself, likewise
    std::vector<double> angles; ///< of all rows of the grid, along a curve
    BoxConvolution<double> convolution;
    BoxConvolution<double> preconditioner;

    [[nodiscard]] RowAngles angles_of_box() const {
      const std::span<const double> rows =
          angles.empty() ? std::span<const double>()
                         : std::span(angles).subspan(box.first_row, box.rows());
      return {rows, rows};
    }
    /// Of the curve at a row, rad/mm.
    [[nodiscard]] double curvature(std::size_t row) const;
    [[nodiscard]] std::size_t count() const { return in_contact ? box.count() : 0; }
    [[nodiscard]] LevelSize size() const { return {grid.lateral_count, grid.longitudinal_count}; }
    /// Its part of a field over all boxes.
    [[nodiscard]] std::span<double> within(double* field) const { return {field + begin, count()}; }
    [[nodiscard]] std::span<const double> within(const double* field) const {
      return {field + begin, count()};
    }
  };
  /// Patches that are solved together, and what is known of their answers.
  struct Group {
    std::size_t first = 0;
    std::size_t last = 0; ///< not included
    std::size_t begin = 0;
    std::size_t count = 0;
    /// Forces of unit energy, each without energy in common with the others, and displacements.
    std::vector<std::vector<double>> forces;
    std::vector<std::vector<double>> displacements;
  };

  /// Of steel that yields, over all boxes; inside, excess is a force.
  struct YieldingFields {
    std::vector<double> excess;
    std::vector<double> slope;
  };

  void set_groups();
  void set_yielding(std::span<const SolvedPatch> patches, std::span<const YieldingBody> yielding);
  Displacements elastic_displacements_of(const Patch& patch);
  void displace_elastically(const Group& group, const double* force, double* displacement);
  void displace(const Group& group, const double* force, double* displacement);
  void precondition(const Group& group, const double* residual, double* correction);
  void put_pressure(const Patch& patch, const double* force, std::vector<double>& pressure);
  void add_influence(const double* force, double* displacement);
  static void keep_answer(Group& group, std::vector<double> forces,
                          std::vector<double> displacements);
  StiffnessOutcome solve_group(Group& group, double tolerance, int maximum_iterations);

  InfluenceCache& cache_;
  ConvolutionWorkspace<double> workspace_;
  PatchInfluence* influence_ = nullptr;
  double force_unit_ = 1.0; ///< N per unit of the forces inside
  std::vector<Patch> patches_;
  std::vector<Group> groups_;
  // Fields over the boxes of all patches, one after the other.
  std::vector<double> contact_; ///< 1 on C, 0 elsewhere
  std::vector<double> force_;
  std::vector<double> residual_;
  std::vector<double> correction_;
  std::vector<double> direction_;
  std::vector<double> response_;
  std::vector<double> gained_;           ///< forces that the iteration has added to its start
  std::vector<double> in_box_;           ///< of one patch
  std::vector<YieldingFields> yielding_; ///< by body
  std::vector<double> diagonal_;         ///< of steel that yields: sum_b P_b'' A P_b
  std::vector<double> elastic_;          ///< of the preconditioner, E, ...
  std::vector<double> jacobi_;           ///< ... and (1 - E^2)/diag(H)
  std::vector<double> product_;
  std::vector<double> by_body_;
  std::vector<std::vector<double>> full_pressure_;
  std::vector<std::vector<double>> full_displacement_;
};

/// sum x a b, N.
double force_of(const Grid& grid, std::span<const double> pressure);

} // namespace wrc

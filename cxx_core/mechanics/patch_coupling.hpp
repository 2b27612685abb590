/// What the pressures of one contact patch displace at the others.
///
/// All patches are taken to lie in one plane. Across the distance between patches the influence of
/// a pressure varies slowly: u = F / (pi E* r) (Boussinesq; Johnson, Contact Mechanics, 1985, eq.
/// 3.22). It is taken from node to node, the nodes being Chebyshev points of each box, and
/// interpolated by the polynomial through them (Fong & Darve, The black-box fast multipole method,
/// J. Comput. Phys. 228, 2009): smooth all over a box, so that no pressure sees the nodes.
/// Gathering is the transpose of interpolating, which keeps the operator symmetric. 1/r continued
/// into the complex plane along one direction of a box of half length a is singular no nearer than
/// at a distance B beyond its end and at an imaginary distance S, B and S being how far the other
/// box lies beyond it and beside it. The error falls with the number of nodes n like rho^-n,
/// ln rho = max(arcosh(1 + B/a), arsinh(S/a)) (Trefethen, Approximation Theory and Approximation
/// Practice, 2013, theorem 8.2). n is taken from that, 16 at most: the error stays below 1.5 times
/// the requested one where boxes are farther apart than half their length along the gap, and is
/// 2e-4 to 1e-2 of the displacement where they are nearly in touch. Two nodes that are nearer to
/// each other than half of the mean distance of nodes, as where boxes overlap, count as if they
/// were that far apart; no other pair of nodes changes with it, wherever the ends of the boxes lie.
///
/// Units: pressures in any one unit P, lengths in mm; the displacement of each box comes in P times
/// the box's `unit` (its longitudinal step) over pi E*, as in influence_cache.hpp.
/// Thread rule: one object serves one thread at a time.
#pragma once

#include <cstddef>
#include <vector>

#include "base/grid.hpp"

namespace wrc {

/// By box: pressures as loads at its nodes.
using NodeLoads = std::vector<std::vector<double>>;

/// Loads of all boxes, and what they displace at each other's nodes.
struct NodeField {
  NodeLoads load;
  /// [box * boxes + other]: at the nodes of `box`, by the loads of `other`; empty if not coupled.
  std::vector<std::vector<double>> displacement;
};

class PatchCoupling {
public:
  /// `coupling_weight`: boxes x boxes, row by row, symmetric; 0 leaves a pair out. `error`: that of
  /// the interpolation, relative to the displacement.
  PatchCoupling(std::vector<Grid> boxes, const std::vector<double>& coupling_weight,
                double error = 1e-5);

  /// Without loads.
  [[nodiscard]] NodeField field() const;
  /// Loads from the pressures of a box, into `loads` of field().
  template <typename Real> void gather(std::size_t box, const Real* pressure, NodeLoads& loads);
  /// Node to node, once all boxes are gathered.
  void transfer(NodeField& field) const;
  /// Sum of displacement times load, of the loads on `box` by those on `other`; in P^2 times mm^3
  /// over pi E*.
  [[nodiscard]] double energy(const NodeField& field, std::size_t box, std::size_t other) const;
  /// The same of pressures whose sums over the elements of two boxes are given, with one distance
  /// for all of them: no more than a rough value, but it takes no nodes.
  [[nodiscard]] double rough_energy(std::size_t box, double sum, std::size_t other,
                                    double other_sum) const;
  /// Energies over this are sums of pressure times displacement over the elements of a box.
  [[nodiscard]] double energy_unit(std::size_t box) const {
    return boxes_[box].lateral_step * boxes_[box].longitudinal_step * boxes_[box].longitudinal_step;
  }
  /// Adds displacements of nodes to those of the box's elements, interpolated in either precision.
  template <typename Real>
  void add(std::size_t box, const std::vector<double>& nodes, double* displacement);
  /// What all others displace at the nodes of a box.
  void sum_others(const NodeField& field, std::size_t box, std::vector<double>& nodes) const;
  /// Adds it to the displacements of its elements.
  void add_others(const NodeField& field, std::size_t box, double* displacement);

private:
  /// Nodes along one direction, and their weights at the elements.
  struct Axis {
    std::vector<double> position; ///< of the nodes, from the first element's centre
    std::vector<double> weight;   ///< [node * elements + element]
    std::vector<float> single_weight;
    double half_spacing = 0.0; ///< half of the nodes' mean distance
    [[nodiscard]] std::size_t nodes() const { return position.size(); }
    template <typename Real> [[nodiscard]] const Real* weights() const {
      if constexpr (sizeof(Real) < sizeof(double)) {
        return single_weight.data();
      } else {
        return weight.data();
      }
    }
  };
  static Axis make_axis(std::size_t elements, double step, double convergence, double error);

  struct Nodes {
    Axis rows;
    Axis columns;
    [[nodiscard]] std::size_t count() const { return rows.nodes() * columns.nodes(); }
  };
  /// c / r between the nodes of two boxes: [node of one * nodes of the other + node of it].
  struct Link {
    std::size_t one = 0;
    std::size_t other = 0;
    std::vector<double> values;
  };
  [[nodiscard]] Link make_link(std::size_t one, std::size_t other, double coupling_weight) const;
  [[nodiscard]] std::size_t pair(std::size_t box, std::size_t other) const {
    return box * boxes_.size() + other;
  }

  std::vector<Grid> boxes_;
  std::vector<Nodes> nodes_;
  std::vector<Link> links_;
  std::vector<double> rough_links_; ///< [box * boxes + other]: c / r, 0 if not coupled
  /// Buffer of elements, while a box is gathered or added.
  template <typename Real> std::vector<Real>& lines() {
    if constexpr (sizeof(Real) < sizeof(double)) {
      return single_lines_;
    } else {
      return double_lines_;
    }
  }
  std::vector<float> single_lines_;
  std::vector<double> double_lines_;
};

} // namespace wrc

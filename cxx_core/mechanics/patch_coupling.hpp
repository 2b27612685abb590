/// What the pressures of one contact patch displace at the others.
///
/// All patches are taken to lie in one plane. Across the distance between patches the influence of
/// a pressure varies slowly: u = F / (pi E* r) (Boussinesq; Johnson, Contact Mechanics, 1985, eq.
/// 3.22). It is taken from node to node, the nodes being Chebyshev points of each box, and
/// interpolated by the polynomial through them (Fong & Darve, The black-box fast multipole method,
/// J. Comput. Phys. 228, 2009): smooth all over a box, so that no pressure sees the nodes.
/// Gathering is the transpose of interpolating, which keeps the operator symmetric. 1/r continued
/// into the complex plane is singular at the distance D beside a box of half length a, so the error
/// falls with the number of nodes n like rho^-n, rho = D/a + sqrt(1 + (D/a)^2) (Trefethen,
/// Approximation Theory and Approximation Practice, 2013, theorem 8.2): 1e-5 at most for
/// D > 0.8 a unless less is asked for; closer boxes have 16 nodes each way. Where D is less than
/// half of the mean distance of the nodes, r counts as if it were that.
///
/// Units: pressures in any one unit P, lengths in mm; the displacement of each box comes in P times
/// the box's `unit` (its longitudinal step) over pi E*, as in influence_cache.hpp.
/// Thread rule: one object serves one thread at a time.
#pragma once

#include <cstddef>
#include <vector>

namespace wrc {

/// A box of elements in the mean plane.
struct CoupledBox {
  std::size_t rows = 0;
  std::size_t columns = 0;
  double lateral_step = 0.0;
  double longitudinal_step = 0.0;
  double lateral_first = 0.0; ///< centre of the first element
  double longitudinal_first = 0.0;
};

/// Pressures of all boxes, as loads at their nodes, and what they displace at each other's nodes.
struct NodeField {
  std::vector<std::vector<double>> load; ///< by box
  /// [box * boxes + other]: at the nodes of `box`, by the loads of `other`; empty if not coupled.
  std::vector<std::vector<double>> displacement;
};

class PatchCoupling {
public:
  /// `closeness`: boxes x boxes, row by row, symmetric; 0 leaves a pair out. `error`: that of the
  /// interpolation, relative to the displacement.
  PatchCoupling(std::vector<CoupledBox> boxes, const std::vector<double>& closeness,
                double error = 1e-5);

  /// Without loads.
  [[nodiscard]] NodeField field() const;
  /// Loads from the pressures of a box.
  template <typename Real> void gather(std::size_t box, const Real* pressure, NodeField& field);
  /// Node to node, once all boxes are gathered.
  void transfer(NodeField& field) const;
  /// Sum of displacement times load, of one field's loads on `box` by the other's on `other`; in
  /// P^2 times mm^3 over pi E*.
  [[nodiscard]] double energy(const NodeField& loads, std::size_t box, const NodeField& displacing,
                              std::size_t other) const;
  /// Energies over this are sums of pressure times displacement over the elements of a box.
  [[nodiscard]] double energy_unit(std::size_t box) const {
    return boxes_[box].lateral_step * boxes_[box].longitudinal_step * boxes_[box].longitudinal_step;
  }
  /// Adds displacements of nodes to those of the box's elements, interpolated in either precision.
  template <typename Real>
  void add(std::size_t box, const std::vector<double>& nodes, double* displacement);
  /// Adds what all others displace at a box.
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
  static Axis make_axis(std::size_t elements, double step, double distance, double error);

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
  [[nodiscard]] Link make_link(std::size_t one, std::size_t other, double closeness) const;
  [[nodiscard]] std::size_t pair(std::size_t box, std::size_t other) const {
    return box * boxes_.size() + other;
  }

  std::vector<CoupledBox> boxes_;
  std::vector<Nodes> nodes_;
  std::vector<Link> links_;
  /// Of elements, while a box is gathered or added.
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

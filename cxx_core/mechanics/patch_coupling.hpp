/// What the pressures of one contact patch displace at the others.
///
/// All patches are taken to lie in one plane. Across the distance between patches the influence of
/// a pressure varies slowly, so pressures are gathered on a few nodes of their own box, displaced
/// from node to node by Boussinesq's u = F / (pi E* r) (Johnson, Contact Mechanics, 1985, eq.
/// 3.22), and interpolated bilinearly. Gathering is the transpose of interpolating, which keeps the
/// operator symmetric. With nodes a distance d apart and patches a distance D, the error is of the
/// order (d / D)^2 / 8 of the displacement; D counts between elements under pressure. Nodes closer
/// than d / 2 to each other count as d / 2 apart.
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

class PatchCoupling {
public:
  /// `closeness`: boxes x boxes, row by row; 0 leaves a pair out.
  PatchCoupling(std::vector<CoupledBox> boxes, std::vector<double> closeness);

  /// Gathers the pressures of a box.
  template <typename Real> void gather(std::size_t box, const Real* pressure);
  /// Node to node, once all boxes are gathered.
  void transfer();
  /// Adds to a box what the others displace there.
  template <typename Real> void add(std::size_t box, Real* displacement);

private:
  /// Elements between two nodes, along one direction.
  struct Axis {
    std::vector<std::size_t> node; ///< before the element
    std::vector<double> share;     ///< of the node after it
    std::vector<double> position;  ///< of the nodes, from the first element's centre
    [[nodiscard]] std::size_t nodes() const { return position.size(); }
  };
  static Axis make_axis(std::size_t elements, double step);

  struct Nodes {
    Axis rows;
    Axis columns;
    std::vector<double> load;
    std::vector<double> displacement;
    [[nodiscard]] std::size_t count() const { return rows.nodes() * columns.nodes(); }
  };
  std::vector<CoupledBox> boxes_;
  std::vector<double> closeness_;
  std::vector<Nodes> nodes_;
};

} // namespace wrc

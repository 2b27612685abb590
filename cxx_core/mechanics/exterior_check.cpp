#include "mechanics/exterior_check.hpp"

#include <algorithm>

#include "mechanics/constants.hpp"
#include "mechanics/coupled_influence.hpp"

namespace wrc {
namespace {

void include(ElementBox& box, const ElementBox& other) {
  box.first_row = std::min(box.first_row, other.first_row);
  box.last_row = std::max(box.last_row, other.last_row);
  box.first_column = std::min(box.first_column, other.first_column);
  box.last_column = std::max(box.last_column, other.last_column);
}

/// Displacements on a rectangle from the pressures of the box.
template <typename Real>
std::vector<double> displacement_on(const PatchCascade& cascade, const ElementBox& rectangle,
                                    InfluenceCache& cache, ConvolutionWorkspace<Real>& workspace) {
  const ElementBox& box = cascade.box;
  const BoxConvolution<Real> convolution = BoxConvolution<Real>::linear(
      {box.rows(), box.columns(), rectangle.rows(), rectangle.columns(),
       -static_cast<std::ptrdiff_t>(box.first_row - rectangle.first_row),
       -static_cast<std::ptrdiff_t>(box.first_column - rectangle.first_column)},
      cascade.kernel, cache,
      {angles_of(cascade.finest(), box.first_row, box.rows()),
       angles_of(cascade.finest(), rectangle.first_row, rectangle.rows())});
  const std::vector<Real> in(cascade.box_pressure.begin(), cascade.box_pressure.end());
  std::vector<Real> out(rectangle.rows() * rectangle.columns());
  convolution.apply(in.data(), out.data(), workspace);
  return {out.begin(), out.end()};
}

/// Adds what the other patches displace to the displacements on a rectangle of a patch's finest
/// grid.
void add_displacement_by_others(const ScaledProblem& problem, std::size_t k,
                                const ElementBox& rectangle, std::vector<double>& displacement) {
  const std::size_t count = problem.count;
  const std::vector<PatchCascade>& cascades = problem.cascades;
  std::vector<Grid> coupled;
  std::vector<double> coupling_weight(count * count);
  for (std::size_t l = 0; l < count; ++l) {
    coupled.push_back(grid_in_mean_plane(cascades[l].finest().grid, cascades[l].place,
                                         l == k ? rectangle : cascades[l].box));
    coupling_weight[k * count + l] = coupling_weight[l * count + k] =
        problem.interaction->coupling_weight[k * count + l];
  }
  PatchCoupling coupling(std::move(coupled), coupling_weight);
  NodeField field = coupling.field();
  for (std::size_t l = 0; l < count; ++l) {
    if (l != k) {
      coupling.gather(l, cascades[l].box_pressure.data(), field.load);
    }
  }
  coupling.transfer(field);
  coupling.add_others(field, k, displacement.data());
}

/// The box enlarged by the elements around it that overlap by more than a limit at an approach,
/// with a margin; none if there is none. `displacement` is that on a rectangle around the box.
std::optional<ElementBox> box_with_overlap(double limit, double approach, const Level& level,
                                           const ElementBox& box, const ElementBox& rectangle,
                                           const std::vector<double>& displacement) {
  const LevelSize& size = level.size;
  std::optional<ElementBox> larger;
  for (std::size_t row = rectangle.first_row; row <= rectangle.last_row; ++row) {
    const double* displaced =
        displacement.data() + (row - rectangle.first_row) * rectangle.columns();
    const double* distance = level.distance.data() + row * size.columns;
    const double* shares = level.shares.data() + row * size.columns;
    for (std::size_t column = rectangle.first_column; column <= rectangle.last_column; ++column) {
      const double overlap =
          shares[column] * approach - distance[column] - displaced[column - rectangle.first_column];
      if (overlap > limit && !box.holds(row, column)) {
        larger = larger.value_or(box);
        include(*larger,
                {row - std::min(row, box_margin), std::min(row + box_margin, size.rows - 1),
                 column - std::min(column, box_margin),
                 std::min(column + box_margin, size.columns - 1)});
      }
    }
  }
  return larger;
}

} // namespace

std::optional<ElementBox> ExteriorCheck::larger_box(const ScaledProblem& problem, std::size_t k,
                                                    double approach, double permitted_error) const {
  const PatchCascade& cascade = problem.cascades[k];
  const Level& level = cascade.finest();
  const ElementBox& box = cascade.box;
  const double approach_here = level.share * approach;
  ElementBox rectangle = box;
  find_penetration_box(level, approach, 0, rectangle);
  include(rectangle, box);
  if (rectangle.rows() * rectangle.columns() == box.rows() * box.columns()) {
    return std::nullopt;
  }
  // An element left out lacks about overlap / K[0, 0] of pressure; u is nowhere above the approach.
  const double permitted = permitted_error * cache.table(cascade.kernel, 1, 1)->row(0)[0];
  const bool single = missed_overlap * approach_here <= permitted;
  const double overlap =
      single ? missed_overlap * approach_here : std::max(permitted, double_overlap * approach_here);
  std::vector<double> displacement =
      single ? displacement_on(cascade, rectangle, cache, single_workspace)
             : displacement_on(cascade, rectangle, cache, double_workspace);
  if (problem.interaction != nullptr) {
    add_displacement_by_others(problem, k, rectangle, displacement);
  }
  return box_with_overlap(overlap, approach, level, box, rectangle, displacement);
}

} // namespace wrc

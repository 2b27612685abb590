#include "scene/trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reductions.hpp"

namespace wrc {
namespace {

/// Steps of element aspect ratios in an octave: few enough to meet again, with at most five
/// per cent more elements than aimed at, or as much smaller ones than given.
constexpr double ladder_steps = 8.0;
/// Factor on the estimated discretisation error, for its own uncertainty.
constexpr double estimate_safety = 1.5;
/// The same if the coarser grid has many rows: such grids agree by chance no longer.
constexpr double fine_safety = 1.0;
constexpr double many_rows = 40.0;
/// Weight of the load per length against pmax and approach: it is there for what they miss by
/// chance, and differs by several times as much as they do where nothing is missed.
constexpr double load_share = 0.3;
/// Rows with more than this share of the largest load per length lie well inside the contact.
constexpr double inner_share = 0.5;
/// Below so many elements smooth contact may be missed by more.
constexpr double least_longitudinal_resolution = 8.0;
/// At the top of a semi-elliptic pressure n rows wide the second difference is 4 / n^2 of it.
constexpr double top_difference = 4.0;
/// Peaks of few rows are seldom semi-ellipses, and may lie anywhere between the rows: errors up to
/// four times those of Hertz's law were measured with 5 rows.
constexpr double few_rows = 5.0;
/// A top along the rail with less than this share of the width that the contact has there is a
/// crest that runs across it aslant, as a yawed flange has.
constexpr double crest_share = 0.6;
/// What the error of a lower peak counts against that of the highest.
constexpr double lower_peak_weight = 4.0;
/// Grids count as different in a direction from this ratio of elements on.
constexpr double least_ratio = 1.2;

/// Largest relative error of pmax and approach for Hertzian contact with n elements along an axis
/// and many along the other one, n = 4 to 48, any place of the grid; `slenderness` is the axis over
/// the other one, 1/9 to 90: elements that are long against the tips of an ellipse resolve them
/// badly. Constant elements have pmax 0.13/n^2 too high in the mean; smooth ones are without bias,
/// 0.02/n^2.
double hertz_error(double n, double slenderness, Elements elements) {
  const double tips = std::max(0.0, std::log(slenderness));
  return (elements == Elements::smooth ? 0.055 + 0.6 / n + 0.045 * tips : 0.22 + 0.02 * tips) /
         (n * n);
}

/// Order by which errors of a grid and one of twice the elements are taken to fall: from grid to
/// grid about three with smooth elements, two at last, from the edge of contact.
double order_of(Elements elements) {
  return elements == Elements::smooth ? 3.0 : 2.0;
}

/// Load per length across the rail, summed up from the first row: values at the rows' edges.
std::vector<double> summed_load(const PatchTrial& trial) {
  const Grid& grid = trial.grid;
  std::vector<double> sums{0.0};
  sums.reserve(grid.lateral_count + 1);
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    const double* values = trial.pressure.data() + row * grid.longitudinal_count;
    sums.push_back(sums.back() + sum_of(values, grid.longitudinal_count) * grid.element_area());
  }
  return sums;
}

/// Difference of the load per length, averaged over the coarser rows, relative to the largest load
/// per length: root of the mean square over the rows. Only rows well inside the contact count: at
/// its edges the difference falls more slowly and says nothing about the peak.
double load_difference(const PatchTrial& coarser, const PatchTrial& finer) {
  const std::vector<double> coarse_sums = summed_load(coarser);
  const std::vector<double> fine_sums = summed_load(finer);
  const double shift = dot(finer.frame.origin - coarser.frame.origin, finer.frame.lateral);
  const Grid& grid = finer.grid;
  const double first_edge = grid.lateral_first - 0.5 * grid.lateral_step + shift;
  const auto fine_sum_at = [&](double lateral) {
    const double place = std::clamp((lateral - first_edge) / grid.lateral_step, 0.0,
                                    static_cast<double>(grid.lateral_count));
    const auto row = std::min(static_cast<std::size_t>(place), grid.lateral_count - 1);
    const double share = place - static_cast<double>(row);
    return fine_sums[row] + share * (fine_sums[row + 1] - fine_sums[row]);
  };
  double largest = 0.0;
  for (std::size_t row = 0; row < coarser.grid.lateral_count; ++row) {
    largest = std::max(largest, coarse_sums[row + 1] - coarse_sums[row]);
  }
  double squares = 0.0;
  double rows = 0.0;
  for (std::size_t row = 0; row < coarser.grid.lateral_count; ++row) {
    const double middle = coarser.grid.lateral(row);
    const double half = 0.5 * coarser.grid.lateral_step;
    const double load = coarse_sums[row + 1] - coarse_sums[row];
    if (load > inner_share * largest) {
      const double difference = fine_sum_at(middle + half) - fine_sum_at(middle - half) - load;
      squares += difference * difference;
      rows += 1.0;
    }
  }
  return std::sqrt(squares / rows) / largest;
}

/// The step of the ladder nearest to an aspect ratio. Powers of two are exact, so that the same
/// step gives the same bits on every call.
double on_ladder(double aspect) {
  return std::exp2(std::round(std::log2(aspect) * ladder_steps) / ladder_steps);
}

/// Elements of one size, centred over an area, but for the edges that lie on a boundary.
Grid placed_grid(const PlaneArea& area, const BoundaryEdges& edges, std::size_t lateral_count,
                 std::size_t longitudinal_count, double lateral_step, double longitudinal_step) {
  Grid grid{lateral_count, longitudinal_count, lateral_step, longitudinal_step, 0.0, 0.0};
  const auto first = [](double begin, double end, double step, std::size_t count) {
    return 0.5 * (begin + end) - 0.5 * step * static_cast<double>(count - 1);
  };
  grid.lateral_first = first(area.lateral_first, area.lateral_last, lateral_step, lateral_count);
  if (edges.lateral_first && !edges.lateral_last) {
    grid.lateral_first = area.lateral_first + 0.5 * lateral_step;
  } else if (edges.lateral_last && !edges.lateral_first) {
    grid.lateral_first =
        area.lateral_last - (static_cast<double>(lateral_count) - 0.5) * lateral_step;
  }
  grid.longitudinal_first =
      first(area.longitudinal_first, area.longitudinal_last, longitudinal_step, longitudinal_count);
  return grid;
}

std::size_t count_over(double length, double size) {
  return static_cast<std::size_t>(std::max(1.0, std::ceil(length / size)));
}

/// Rows that fit an area between two boundaries. Columns follow from the ladder: elements no longer
/// than aimed at, or, in numbers given, none that fails to reach both ends.
Grid fitted_grid(const PlaneArea& area, const Mesh& mesh, const BoundaryEdges& edges) {
  const std::size_t rows =
      mesh.counts ? (*mesh.counts)[0] : count_over(area.width(), mesh.lateral_step);
  const double lateral_step = area.width() / static_cast<double>(rows);
  const double half_a_rung = std::exp2(0.5 / ladder_steps);
  if (mesh.counts) {
    const std::size_t columns = (*mesh.counts)[1];
    const double least = area.length() / static_cast<double>(columns);
    const double step = lateral_step / on_ladder(lateral_step / least * (1.0 / half_a_rung));
    return placed_grid(area, edges, rows, columns, lateral_step, step);
  }
  const double step = lateral_step / on_ladder(lateral_step / mesh.longitudinal_step * half_a_rung);
  return placed_grid(area, edges, rows, count_over(area.length(), step), lateral_step, step);
}

} // namespace

Grid mesh_grid(const PlaneArea& area, const Mesh& mesh, const BoundaryEdges& edges) {
  if (edges.lateral_first && edges.lateral_last) {
    return fitted_grid(area, mesh, edges);
  }
  if (mesh.counts) {
    const auto [lateral_count, longitudinal_count] = *mesh.counts;
    const double lateral_step = area.width() / static_cast<double>(lateral_count);
    const double longitudinal_step = area.length() / static_cast<double>(longitudinal_count);
    const double aspect = on_ladder(lateral_step / longitudinal_step);
    const double step = std::max(longitudinal_step, lateral_step / aspect);
    return placed_grid(area, edges, lateral_count, longitudinal_count, step * aspect, step);
  }
  const double aspect = on_ladder(mesh.lateral_step / mesh.longitudinal_step);
  const double step = std::min(mesh.longitudinal_step, mesh.lateral_step / aspect);
  return placed_grid(area, edges, count_over(area.width(), step * aspect),
                     count_over(area.length(), step), step * aspect, step);
}

PlaneArea PatchTrial::grown(double share_of_area, double least_elements) const {
  PlaneArea larger = area;
  const double width = rows() >= least_elements ? share_of_area * area.width() : 0.0;
  const double length = columns() >= least_elements ? share_of_area * area.length() : 0.0;
  larger.lateral_first -= contact.touches_edge.lateral_first ? width : 0.0;
  larger.lateral_last += contact.touches_edge.lateral_last ? width : 0.0;
  larger.longitudinal_first -= contact.touches_edge.longitudinal_first ? length : 0.0;
  larger.longitudinal_last += contact.touches_edge.longitudinal_last ? length : 0.0;
  return larger;
}

PlaneArea PatchTrial::contact_area(double margin) const {
  const double reach = 0.5 + margin;
  return {grid.lateral(contact.box.lateral_first) - reach * grid.lateral_step,
          grid.lateral(contact.box.lateral_last) + reach * grid.lateral_step,
          grid.longitudinal(contact.box.longitudinal_first) - reach * grid.longitudinal_step,
          grid.longitudinal(contact.box.longitudinal_last) + reach * grid.longitudinal_step};
}

double PatchTrial::overlap(double approach) const {
  const double least = least_of(distance.data(), distance.size());
  const auto index = static_cast<std::size_t>(std::find(distance.begin(), distance.end(), least) -
                                              distance.begin());
  const std::size_t columns_of_grid = grid.longitudinal_count;
  const std::size_t row = index / columns_of_grid;
  const std::size_t column = index % columns_of_grid;
  double deepest = least;
  const auto deepen = [&](double before, double after) {
    const double curvature = before - 2.0 * least + after;
    if (curvature > 0.0) {
      deepest -= (after - before) * (after - before) / (8.0 * curvature);
    }
  };
  if (row > 0 && row + 1 < grid.lateral_count) {
    deepen(distance[index - columns_of_grid], distance[index + columns_of_grid]);
  }
  if (column > 0 && column + 1 < columns_of_grid) {
    deepen(distance[index - 1], distance[index + 1]);
  }
  return share * approach - deepest;
}

bool Trial::no_contact() const {
  return std::all_of(patches.begin(), patches.end(),
                     [](const PatchTrial& patch) { return patch.no_contact(); });
}

bool Trial::touches_edge() const {
  return std::any_of(patches.begin(), patches.end(),
                     [](const PatchTrial& patch) { return patch.touches_edge(); });
}

bool Trial::has_close_patches() const {
  return std::any_of(links.begin(), links.end(), [](double link) { return link > 0.0; });
}

bool Trial::has_turned_planes() const {
  return std::any_of(patches.begin(), patches.end(), [](const PatchTrial& patch) {
    return patch.place.angle != patch.place.own_angle;
  });
}

double Trial::peak_pressure() const {
  double peak = 0.0;
  for (const PatchTrial& patch : patches) {
    peak = std::max(peak, patch.contact.peak_pressure);
  }
  return peak;
}

double Trial::normal_force() const {
  double sum = 0.0;
  for (const PatchTrial& patch : patches) {
    sum += patch.normal_force;
  }
  return sum;
}

const PatchTrial* Trial::matching(const ContactPatch& place) const {
  const auto found =
      std::find_if(patches.begin(), patches.end(), [&place](const PatchTrial& patch) {
        return !patch.no_contact() && patch.place.holds(place);
      });
  return found == patches.end() ? nullptr : &*found;
}

double Trial::weight(const PatchTrial& patch) const {
  return patch.contact.peak_pressure / peak_pressure();
}

namespace {

/// Elements under pressure along the rail, through the peak of a patch.
double elements_through_peak(const PatchTrial& patch) {
  const std::vector<double>& pressure = patch.pressure;
  const std::size_t peak = patch.contact.largest_element;
  const std::size_t columns = patch.grid.longitudinal_count;
  const std::size_t row_begin = peak - peak % columns;
  std::size_t first = peak;
  std::size_t last = peak;
  while (first > row_begin && pressure[first - 1] > 0.0) {
    --first;
  }
  while (last + 1 < row_begin + columns && pressure[last + 1] > 0.0) {
    ++last;
  }
  return static_cast<double>(last - first + 1);
}

/// Elements under a semi-ellipse with this top and the ones beside it.
double elements_under_top(double before, double top, double after) {
  return std::sqrt(top_difference * top / (2.0 * top - before - after));
}

/// The same along the rail for the peak of a patch, as far as it lies inside the grid.
double elements_under_peak(const PatchTrial& patch) {
  const std::size_t columns = patch.grid.longitudinal_count;
  const std::size_t peak = patch.contact.largest_element;
  if (peak % columns == 0 || peak % columns + 1 == columns) {
    return static_cast<double>(columns);
  }
  return elements_under_top(patch.pressure[peak - 1], patch.pressure[peak],
                            patch.pressure[peak + 1]);
}

/// Error of a peak of few elements.
double top_error(double elements_of_top, Elements elements) {
  const double roughness = 1.0 + (few_rows / elements_of_top) * (few_rows / elements_of_top);
  return roughness * hertz_error(elements_of_top, 1.0, elements);
}

} // namespace

double longitudinal_error(const Trial& trial) {
  double error = 0.0;
  for (const PatchTrial& patch : trial.patches) {
    if (!patch.no_contact()) {
      const double count = elements_through_peak(patch);
      double own = hertz_error(count, patch.slenderness(), trial.elements);
      const double under_peak = elements_under_peak(patch);
      if (under_peak < crest_share * count) {
        own = std::max(own, top_error(under_peak, trial.elements));
      }
      error = std::max(error, trial.weight(patch) * own);
    }
  }
  return error;
}

double narrow_error(const Trial& trial) {
  double highest = 0.0;
  for (const PatchTrial& patch : trial.patches) {
    highest = std::max(highest, patch.contact.largest_element_pressure);
  }
  double missing = 0.0;
  std::vector<double> tops; // largest pressure of each row, between rows without any
  for (const PatchTrial& patch : trial.patches) {
    const std::size_t columns = patch.grid.longitudinal_count;
    tops.assign(patch.grid.lateral_count + 2, 0.0);
    for (std::size_t row = 0; row < patch.grid.lateral_count; ++row) {
      const double* values = patch.pressure.data() + row * columns;
      tops[row + 1] = *std::max_element(values, values + columns);
    }
    for (std::size_t i = 1; i + 1 < tops.size(); ++i) {
      if (tops[i] > 0.0 && tops[i] >= tops[i - 1] && tops[i] >= tops[i + 1]) {
        const double rows = elements_under_top(tops[i - 1], tops[i], tops[i + 1]);
        const double error = top_error(rows, trial.elements) * tops[i];
        missing = std::max(
            missing, tops[i] < highest ? tops[i] + lower_peak_weight * error - highest : error);
      }
    }
  }
  return missing / highest;
}

double longitudinal_resolution(double error, double slenderness, Elements elements) {
  double count = least_longitudinal_resolution;
  while (hertz_error(count, slenderness, elements) > error) {
    count += 1.0;
  }
  return count;
}

namespace {

/// The ratio of elements by which a patch was refined: across the rail, or along it if it was not
/// refined across. Where both changed, what the elements along the rail leave has its own law.
double refinement_of(const PatchTrial& coarser, const PatchTrial& finer) {
  const double across = finer.rows() / coarser.rows();
  return across > least_ratio ? across : std::max(finer.columns() / coarser.columns(), least_ratio);
}

} // namespace

double estimate_error(const Trial& coarser, const Trial& finer, bool position_is_prescribed) {
  const double other =
      position_is_prescribed
          ? std::abs(finer.normal_force() - coarser.normal_force()) / finer.normal_force()
          : std::abs(finer.next_depth - coarser.next_depth) / finer.next_depth;
  double error = 0.0;
  for (const PatchTrial& patch : finer.patches) {
    if (patch.no_contact()) {
      continue;
    }
    const double weight = finer.weight(patch);
    const PatchTrial* before = coarser.matching(patch.place);
    if (before == nullptr) {
      error = std::max(error, weight); // not known before: all of it may be wrong
      continue;
    }
    const double ratio = refinement_of(*before, patch);
    const double peak = std::abs(patch.contact.peak_pressure - before->contact.peak_pressure) /
                        patch.contact.peak_pressure;
    const double difference = std::max(peak, load_share * load_difference(*before, patch));
    const double safety = before->rows() < many_rows ? estimate_safety : fine_safety;
    const double gain = std::pow(ratio, order_of(finer.elements)) - 1.0;
    error = std::max(error, safety * std::max(weight * difference, other) / gain);
  }
  return error + finer.pressure_error;
}

} // namespace wrc

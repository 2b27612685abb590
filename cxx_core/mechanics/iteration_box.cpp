#include "mechanics/iteration_box.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/reductions.hpp"
#include "mechanics/constants.hpp"
#include "mechanics/projected_cg_loops.hpp"

namespace wrc {
namespace {

/// K for all offsets of columns, so that around any element it is read in one direction.
template <typename Real>
void mirror_influence(const IterationBox& box, BoxFields<Real>& fields, InfluenceCache& cache) {
  const auto influence = cache.table(box.kernel, box.rows, box.columns);
  const std::size_t pitch = 2 * box.columns - 1;
  provide(fields.mirrored, box.rows * pitch);
  for (std::size_t i = 0; i < box.rows; ++i) {
    const double* row = influence->row(i);
    Real* centre = fields.mirrored.data() + i * pitch + (box.columns - 1);
    for (std::size_t j = 0; j < box.columns; ++j) {
      centre[j] = static_cast<Real>(row[j]);
    }
    std::reverse_copy(centre + 1, centre + box.columns, centre - (box.columns - 1));
  }
  fields.has_mirrored = true;
}

template <typename Real>
void clip_one_by_one(const IterationBox& box, BoxFields<Real>& fields, InfluenceCache& cache) {
  double* pressure = box.pressure.data();
  struct Cut {
    std::size_t row;
    std::size_t column;
  };
  std::array<Cut, max_single_cuts> cuts{};
  std::array<Real, max_single_cuts> pressures{};
  std::array<const Real*, max_single_cuts> kernels{};
  std::size_t cut_count = 0;
  for (std::size_t i = 0; i < box.rows; ++i) {
    double* row = pressure + i * box.columns;
    if (!(least_of(row, box.columns) < 0.0)) {
      continue;
    }
    for (std::size_t j = 0; j < box.columns; ++j) {
      if (row[j] < 0.0) {
        cuts[cut_count] = {i, j};
        pressures[cut_count++] = static_cast<Real>(row[j]);
        row[j] = 0.0;
      }
    }
  }
  if (!fields.has_mirrored) {
    mirror_influence(box, fields, cache);
  }
  std::array<Real, max_single_cuts> along_normal; // of a row on a curve
  for (std::size_t i = 0; i < box.rows; ++i) {
    for (std::size_t c = 0; c < cut_count; ++c) {
      const Cut& cut = cuts[c];
      const std::size_t offset = i > cut.row ? i - cut.row : cut.row - i;
      kernels[c] =
          fields.mirrored.data() + offset * (2 * box.columns - 1) + (box.columns - 1 - cut.column);
    }
    const Real* acting = pressures.data();
    if (!box.angles.empty()) {
      for (std::size_t c = 0; c < cut_count; ++c) {
        const double cosine = std::cos(box.angles[i] - box.angles[cuts[c].row]);
        along_normal[c] = static_cast<Real>(cosine) * pressures[c];
      }
      acting = along_normal.data();
    }
    take_out(fields.displacement.data() + i * box.columns, fields.response.data(), kernels.data(),
             acting, cut_count, box.columns);
  }
}

template <typename Real>
void clip_all_at_once(const IterationBox& box, BoxFields<Real>& fields,
                      ConvolutionWorkspace<Real>& workspace) {
  double* pressure = box.pressure.data();
  std::transform(pressure, pressure + box.count(), fields.response.data(),
                 [](double p) { return static_cast<Real>(std::max(0.0, -p)); });
  std::transform(pressure, pressure + box.count(), pressure,
                 [](double p) { return std::max(0.0, p); });
  fields.convolution.apply(fields.response.data(), fields.response.data(), workspace);
  for (std::size_t index = 0; index < box.count(); ++index) {
    fields.displacement.data()[index] += static_cast<double>(fields.response.data()[index]);
  }
}

} // namespace

template <typename Real> ReachedSides reached_sides(const IterationBox& box, const Real* contact) {
  const auto row_touched = [&](std::size_t row) {
    return std::any_of(contact + row * box.columns, contact + (row + 1) * box.columns,
                       [](Real value) { return value > Real{0}; });
  };
  const auto column_touched = [&](std::size_t column) {
    for (std::size_t index = column; index < box.count(); index += box.columns) {
      if (contact[index] > Real{0}) {
        return true;
      }
    }
    return false;
  };
  ReachedSides reached;
  reached.first_row = box.open_first_row && row_touched(0);
  reached.last_row = box.open_last_row && row_touched(box.rows - 1);
  reached.first_column = box.open_first_column && column_touched(0);
  reached.last_column = box.open_last_column && column_touched(box.columns - 1);
  return reached;
}

template <typename Real>
void clip_negative(const IterationBox& box, BoxFields<Real>& fields, InfluenceCache& cache,
                   ConvolutionWorkspace<Real>& workspace) {
  const double most = static_cast<double>(box.count()) / elements_per_cut;
  if (fields.cut <= std::min(most, static_cast<double>(max_single_cuts))) {
    clip_one_by_one(box, fields, cache);
  } else {
    clip_all_at_once(box, fields, workspace);
  }
}

template void clip_negative(const IterationBox&, BoxFields<float>&, InfluenceCache&,
                            ConvolutionWorkspace<float>&);
template void clip_negative(const IterationBox&, BoxFields<double>&, InfluenceCache&,
                            ConvolutionWorkspace<double>&);

template ReachedSides reached_sides(const IterationBox&, const float*);
template ReachedSides reached_sides(const IterationBox&, const double*);

} // namespace wrc

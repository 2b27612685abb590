// What pressures displace, and what steel that yields adds to it (contact_stiffness.hpp).
#include <algorithm>
#include <cmath>

#include "derivatives/constants.hpp"
#include "derivatives/contact_stiffness.hpp"
#include "half_space/constants.hpp"
#include "mechanics/yielding.hpp"
#include "remesh/row_scales.hpp"

namespace wrc {

void ContactStiffness::set_yielding(std::span<const SolvedPatch> patches,
                                    std::span<const YieldingBody> yielding) {
  const std::size_t count = contact_.size();
  product_.assign(count, 0.0);
  by_body_.assign(count, 0.0);
  diagonal_.assign(count, 0.0);
  elastic_.assign(count, 1.0);
  jacobi_.assign(count, 0.0);
  std::vector<YieldTerms> terms;
  for (std::size_t k = 0; k < patches_.size(); ++k) {
    const Patch& patch = patches_[k];
    Grid box = patch.grid;
    std::vector<double> pressure(patch.count());
    std::span<const double> scales = patches[k].row_scales;
    if (patch.in_contact) {
      box.lateral_count = patch.box.rows();
      box.longitudinal_count = patch.box.columns();
      scales = scales.empty() ? scales : scales.subspan(patch.box.first_row, patch.box.rows());
      copy_box(patch.size(), patch.box, patches[k].pressure, pressure);
      pressure = over_scales(box, scales, pressure);
    }
    terms.emplace_back(box, pressure, scales, yielding);
  }
  for (std::size_t b = 0; b < yielding.size(); ++b) {
    YieldingFields& body = yielding_.emplace_back();
    for (std::size_t k = 0; k < patches_.size(); ++k) {
      const double force = patches_[k].grid.element_area() / force_unit_;
      for (const double excess : terms[k].excess[b]) {
        body.excess.push_back(force * excess);
      }
      body.slope.insert(body.slope.end(), terms[k].slope[b].begin(), terms[k].slope[b].end());
    }
    for (const Group& group : groups_) {
      displace_elastically(group, body.excess.data(), by_body_.data());
    }
    for (std::size_t k = 0; k < patches_.size(); ++k) {
      const double pressure = force_unit_ / patches_[k].grid.element_area();
      const std::size_t begin = patches_[k].begin;
      for (std::size_t i = 0; i < patches_[k].count(); ++i) {
        diagonal_[begin + i] += pressure * terms[k].curvature[b][i] * by_body_[begin + i];
      }
    }
  }
  for (const Patch& patch : patches_) {
    for (std::size_t i = patch.begin; i < patch.begin + patch.count(); ++i) {
      double squares = 1.0;
      for (const YieldingFields& body : yielding_) {
        squares += body.slope[i] * body.slope[i];
      }
      const double whole = patch.self * squares + diagonal_[i];
      elastic_[i] = std::sqrt(patch.self / whole);
      jacobi_[i] = (1.0 - patch.self / whole) / whole;
    }
  }
}

ContactStiffness::Displacements
ContactStiffness::displacements_of(std::size_t patch_index, std::span<const double> pressure) {
  const Patch& patch = patches_[patch_index];
  Displacements result;
  result.displacement.resize(pressure.size());
  result.by_lateral_step.resize(pressure.size());
  if (!patch.in_contact) {
    return result;
  }
  copy_box(patch.size(), patch.box, pressure, in_box_);
  result = elastic_displacements_of(patch);
  for (const YieldingFields& body : yielding_) {
    const std::span<const double> excess = patch.within(body.excess.data());
    in_box_.assign(excess.begin(), excess.end());
    for (double& value : in_box_) {
      value *= force_unit_ / patch.grid.element_area();
    }
    const Displacements of_excess = elastic_displacements_of(patch);
    std::vector<double> slope(pressure.size(), 0.0);
    put_box(patch.size(), patch.box, patch.within(body.slope.data()), slope);
    const auto add = [&slope](const std::vector<double>& from, std::vector<double>& to) {
      for (std::size_t i = 0; i < to.size(); ++i) {
        to[i] += slope[i] * from[i];
      }
    };
    add(of_excess.displacement, result.displacement);
    add(of_excess.by_lateral_step, result.by_lateral_step);
    add(of_excess.by_place, result.by_place);
    add(of_excess.by_spread, result.by_spread);
  }
  return result;
}

/// By the pressures in in_box_.
ContactStiffness::Displacements ContactStiffness::elastic_displacements_of(const Patch& patch) {
  const std::size_t count = patch.grid.element_count();
  Displacements result;
  result.displacement.resize(count);
  result.by_lateral_step.resize(count);
  const std::size_t rows = patch.box.rows();
  const std::size_t columns = patch.box.columns();
  const double unit = patch.unit * patch.grid.element_area() / force_unit_;
  const double aspect = patch.grid.lateral_step / patch.grid.longitudinal_step;
  const auto displaced = [&](double factor, const RowAngles& angles) {
    const auto convolution = BoxConvolution<double>::linear(
        {rows, columns, rows, columns, 0, 0}, {shared_aspect(factor * aspect), patch.elements},
        cache_, angles);
    std::vector<double> values(patch.count());
    convolution.apply(in_box_.data(), values.data(), workspace_);
    return values;
  };
  // A central difference over aspect_step to both sides.
  const auto put_rate = [&](std::vector<double> above, const std::vector<double>& below,
                            std::vector<double>& rate) {
    std::ranges::transform(above, below, above.begin(), [unit](double one, double other) {
      return unit * (one - other) / (2.0 * aspect_step);
    });
    put_box(patch.size(), patch.box, above, rate);
  };
  const RowAngles angles = patch.angles_of_box();
  std::vector<double> here = displaced(1.0, angles);
  put_rate(displaced(1.0 + aspect_step, angles), displaced(1.0 - aspect_step, angles),
           result.by_lateral_step);
  for (double& value : here) {
    value *= unit;
  }
  put_box(patch.size(), patch.box, here, result.displacement);
  if (patch.angles.empty()) {
    return result;
  }
  const auto turned = [&](double by_place, double by_spread) {
    std::vector<double> rows_turned(angles.in.begin(), angles.in.end());
    for (std::size_t i = 0; i < rows; ++i) {
      const std::size_t row = patch.box.first_row + i;
      rows_turned[i] += (by_place + by_spread * patch.grid.lateral(row)) * patch.curvature(row);
    }
    return displaced(1.0, {rows_turned, rows_turned});
  };
  result.by_place.resize(count);
  result.by_spread.resize(count);
  put_rate(turned(aspect_step, 0.0), turned(-aspect_step, 0.0), result.by_place);
  put_rate(turned(0.0, aspect_step), turned(0.0, -aspect_step), result.by_spread);
  return result;
}

} // namespace wrc

#include "derivatives/contact_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "base/error.hpp"
#include "base/reductions.hpp"
#include "base/vector_clones.hpp"
#include "derivatives/constants.hpp"
#include "mechanics/constants.hpp"

namespace wrc {

namespace {

WRC_VECTOR_CLONES void multiply(const double* factors, double* values, std::size_t count) {
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    values[i] *= factors[i];
  }
}

/// v = z + beta v.
WRC_VECTOR_CLONES void form_direction(const double* correction, double beta, double* direction,
                                      std::size_t count) {
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    direction[i] = correction[i] + beta * direction[i];
  }
}

void check_size(const std::string& argument, std::size_t size, std::size_t expected) {
  if (size != expected) {
    throw_invalid_argument(argument, static_cast<double>(size),
                           "must have " + std::to_string(expected) + " entries");
  }
}

} // namespace

void ContactStiffness::set_contact(std::span<const SolvedPatch> patches, double combined_modulus,
                                   PatchInfluence* influence,
                                   std::span<const YieldingBody> yielding) {
  if (patches.empty()) {
    throw_invalid_argument("patches", 0.0, "must have at least one entry");
  }
  if (!(combined_modulus > 0.0) || !std::isfinite(combined_modulus)) {
    throw_invalid_argument("combined_modulus", combined_modulus, "must be positive and finite");
  }
  for (const SolvedPatch& patch : patches) {
    check_grid(patch.grid);
    check_size("pressure", patch.pressure.size(), patch.grid.element_count());
    if (!patch.angles.empty()) {
      check_size("angles", patch.angles.size(), patch.grid.lateral_count);
    }
  }
  // Without dimensions: displacements in mm, forces in E* pi s mm, s the first patch's step. From
  // u = s_k / (pi E*) K p and p = force / (a b) follows each patch's unit.
  const double step = patches.front().grid.longitudinal_step;
  force_unit_ = std::numbers::pi * combined_modulus * step;
  influence_ = patches.size() > 1 ? influence : nullptr;
  patches_.clear();
  std::size_t count = 0;
  for (const SolvedPatch& solved : patches) {
    Patch patch;
    patch.grid = solved.grid;
    patch.elements = solved.elements;
    patch.begin = count;
    patch.in_contact = find_pressure_box(patch.size(), solved.pressure, 0, patch.box);
    patch.unit = step / solved.grid.lateral_step;
    if (patch.in_contact) {
      const InfluenceKernel kernel{
          shared_aspect(solved.grid.lateral_step / solved.grid.longitudinal_step), solved.elements};
      const std::size_t rows = patch.box.rows();
      const std::size_t columns = patch.box.columns();
      patch.angles.assign(solved.angles.begin(), solved.angles.end());
      patch.convolution = BoxConvolution<double>::linear({rows, columns, rows, columns, 0, 0},
                                                         kernel, cache_, patch.angles_of_box());
      patch.preconditioner =
          BoxConvolution<double>::inverse_periodic(rows, columns, kernel, cache_);
      patch.self = patch.unit * cache_.table(kernel, 1, 1)->values[0];
    }
    count += patch.count();
    patches_.push_back(std::move(patch));
  }
  for (std::vector<double>* field :
       {&contact_, &force_, &residual_, &correction_, &direction_, &response_, &gained_}) {
    field->assign(count, 0.0);
  }
  for (std::size_t k = 0; k < patches_.size(); ++k) {
    const Patch& patch = patches_[k];
    if (!patch.in_contact) {
      continue;
    }
    const std::span<double> contact = patch.within(contact_.data());
    copy_box(patch.size(), patch.box, patches[k].pressure, contact);
    for (double& value : contact) {
      value = value > 0.0 ? 1.0 : 0.0;
    }
  }
  set_groups();
  yielding_.clear();
  if (!yielding.empty()) {
    set_yielding(patches, yielding);
  }
}

/// Patches that interact are solved together.
void ContactStiffness::set_groups() {
  groups_.clear();
  const std::size_t together = influence_ != nullptr ? patches_.size() : 1;
  for (std::size_t first = 0; first < patches_.size(); first += together) {
    Group group;
    group.first = first;
    group.last = first + together;
    group.begin = patches_[first].begin;
    const Patch& last = patches_[group.last - 1];
    group.count = last.begin + last.count() - group.begin;
    groups_.push_back(std::move(group));
  }
  full_pressure_.clear();
  full_displacement_.clear();
  if (influence_ != nullptr) {
    for (const Patch& patch : patches_) {
      full_pressure_.emplace_back(patch.grid.element_count(), 0.0);
      full_displacement_.emplace_back(patch.grid.element_count(), 0.0);
    }
  }
}

/// On all boxes of a group; fields are those of all boxes. `force` is 0 outside C, and so is the
/// displacement given back.
void ContactStiffness::displace(const Group& group, const double* force, double* displacement) {
  displace_elastically(group, force, displacement);
  if (yielding_.empty()) {
    return;
  }
  const std::size_t end = group.begin + group.count;
  for (const YieldingFields& body : yielding_) {
    for (std::size_t i = group.begin; i < end; ++i) {
      product_[i] = body.slope[i] * force[i];
    }
    displace_elastically(group, product_.data(), by_body_.data());
    for (std::size_t i = group.begin; i < end; ++i) {
      displacement[i] += body.slope[i] * by_body_[i];
    }
  }
  for (std::size_t i = group.begin; i < end; ++i) {
    displacement[i] += diagonal_[i] * force[i];
  }
}

void ContactStiffness::displace_elastically(const Group& group, const double* force,
                                            double* displacement) {
  for (std::size_t k = group.first; k < group.last; ++k) {
    const Patch& patch = patches_[k];
    if (patch.in_contact) {
      const std::span<double> values = patch.within(displacement);
      patch.convolution.apply(patch.within(force).data(), values.data(), workspace_);
      for (double& value : values) {
        value *= patch.unit;
      }
    }
  }
  if (influence_ != nullptr) {
    add_influence(force, displacement);
  }
  multiply(contact_.data() + group.begin, displacement + group.begin, group.count);
}

double ContactStiffness::Patch::curvature(std::size_t row) const {
  const std::size_t before = row - std::min<std::size_t>(row, 1);
  const std::size_t after = std::min(row + 1, angles.size() - 1);
  return after > before ? (angles[after] - angles[before]) /
                              (grid.lateral_step * static_cast<double>(after - before))
                        : 0.0;
}

/// Forces within the box as pressures on the grid, MPa.
void ContactStiffness::put_pressure(const Patch& patch, const double* force,
                                    std::vector<double>& pressure) {
  const std::span<const double> forces = patch.within(force);
  in_box_.assign(forces.begin(), forces.end());
  const double scale = force_unit_ / patch.grid.element_area();
  for (double& value : in_box_) {
    value *= scale;
  }
  put_box(patch.size(), patch.box, in_box_, pressure);
}

void ContactStiffness::add_influence(const double* force, double* displacement) {
  for (std::size_t k = 0; k < patches_.size(); ++k) {
    const Patch& patch = patches_[k];
    std::fill(full_displacement_[k].begin(), full_displacement_[k].end(), 0.0);
    if (!patch.in_contact) {
      continue;
    }
    put_pressure(patch, force, full_pressure_[k]);
  }
  influence_->add(full_pressure_, full_displacement_);
  for (std::size_t k = 0; k < patches_.size(); ++k) {
    const Patch& patch = patches_[k];
    if (!patch.in_contact) {
      continue;
    }
    copy_box(patch.size(), patch.box, full_displacement_[k], in_box_);
    add_scaled(patch.within(displacement).data(), 1.0, in_box_.data(), patch.count());
  }
}

void ContactStiffness::precondition(const Group& group, const double* residual,
                                    double* correction) {
  for (std::size_t k = group.first; k < group.last; ++k) {
    const Patch& patch = patches_[k];
    if (patch.in_contact) {
      const std::span<double> values = patch.within(correction);
      const double* from = patch.within(residual).data();
      if (!yielding_.empty()) {
        in_box_.assign(from, from + patch.count());
        multiply(elastic_.data() + patch.begin, in_box_.data(), patch.count());
        from = in_box_.data();
      }
      patch.preconditioner.apply(from, values.data(), workspace_);
      const double inverse = 1.0 / patch.unit;
      for (double& value : values) {
        value *= inverse;
      }
    }
  }
  if (!yielding_.empty()) {
    for (std::size_t i = group.begin; i < group.begin + group.count; ++i) {
      correction[i] = elastic_[i] * correction[i] + jacobi_[i] * residual[i];
    }
  }
  multiply(contact_.data() + group.begin, correction + group.begin, group.count);
}

/// Keeps forces and what they displace, scaled to an energy of 1.
void ContactStiffness::keep_answer(Group& group, std::vector<double> forces,
                                   std::vector<double> displacements) {
  const double scale = 1.0 / std::sqrt(dot(forces.data(), displacements.data(), forces.size()));
  if (std::isfinite(scale)) {
    for (std::size_t i = 0; i < forces.size(); ++i) {
      forces[i] *= scale;
      displacements[i] *= scale;
    }
    group.forces.push_back(std::move(forces));
    group.displacements.push_back(std::move(displacements));
  }
}

/// The right-hand side comes in residual_, the answer goes to force_.
StiffnessOutcome ContactStiffness::solve_group(Group& group, double tolerance,
                                               int maximum_iterations) {
  const std::size_t count = group.count;
  double* force = force_.data() + group.begin;
  double* residual = residual_.data() + group.begin;
  double* correction = correction_.data() + group.begin;
  double* direction = direction_.data() + group.begin;
  double* response = response_.data() + group.begin;
  double* gained = gained_.data() + group.begin;
  std::fill_n(force, count, 0.0);
  std::fill_n(gained, count, 0.0);
  std::fill_n(direction, count, 0.0);

  double energy = 0.0; // of the answer so far, <x, A x>
  for (std::size_t i = 0; i < group.forces.size(); ++i) {
    const double share = dot(group.forces[i].data(), residual, count);
    add_scaled(force, share, group.forces[i].data(), count);
    add_scaled(residual, -share, group.displacements[i].data(), count);
    energy += share * share;
  }
  // What the iteration has to add, for the answers kept.
  std::vector<double> left(residual, residual + count);

  StiffnessOutcome outcome;
  const double square =
      std::max(tolerance * tolerance, min_stiffness_tolerance * min_stiffness_tolerance);
  double gained_energy = 0.0;
  double last_z_r = 0.0;
  double least_z_r = std::numeric_limits<double>::infinity();
  int best_iteration = 0;
  for (;; ++outcome.iterations) {
    precondition(group, residual_.data(), correction_.data());
    const double z_r = dot(correction, residual, count);
    const double whole = energy + gained_energy;
    outcome.error = z_r > 0.0 ? (whole > 0.0 ? std::sqrt(z_r / whole) : 1.0) : 0.0;
    if (z_r < least_z_r) {
      least_z_r = z_r;
      best_iteration = outcome.iterations;
    }
    if (z_r <= square * whole) {
      if (z_r > 0.0 && tolerance < min_stiffness_tolerance) {
        outcome.stop_reason = StopReason::stagnation;
      }
      break;
    }
    if (outcome.iterations - best_iteration >= stagnation_window) {
      outcome.stop_reason = StopReason::stagnation;
      break;
    }
    if (outcome.iterations >= maximum_iterations) {
      outcome.stop_reason = StopReason::iteration_limit;
      break;
    }
    form_direction(correction, last_z_r > 0.0 ? z_r / last_z_r : 0.0, direction, count);
    last_z_r = z_r;
    displace(group, direction_.data(), response_.data());
    const double v_q = dot(direction, response, count);
    if (!(v_q > 0.0)) {
      outcome.stop_reason = StopReason::stagnation;
      break;
    }
    const double step = z_r / v_q;
    add_scaled(gained, step, direction, count);
    add_scaled(residual, -step, response, count);
    gained_energy += step * z_r;
  }
  add_scaled(force, 1.0, gained, count);
  if (gained_energy > min_new_energy * (energy + gained_energy)) {
    add_scaled(left.data(), -1.0, residual, count); // what the forces gained displace
    keep_answer(group, {gained, gained + count}, std::move(left));
  }
  return outcome;
}

StiffnessOutcome ContactStiffness::solve(std::span<const std::span<const double>> displacement,
                                         std::vector<std::vector<double>>& pressure,
                                         double tolerance, int maximum_iterations) {
  check_size("displacement", displacement.size(), patches_.size());
  if (!(tolerance > 0.0)) {
    throw_invalid_argument("tolerance", tolerance, "must be positive");
  }
  for (std::size_t k = 0; k < patches_.size(); ++k) {
    const Patch& patch = patches_[k];
    if (!displacement[k].empty()) {
      check_size("displacement", displacement[k].size(), patch.grid.element_count());
    }
    const std::span<double> values = patch.within(residual_.data());
    std::fill(values.begin(), values.end(), 0.0);
    if (!patch.in_contact || displacement[k].empty()) {
      continue;
    }
    copy_box(patch.size(), patch.box, displacement[k], values);
    const std::span<const double> contact = patch.within(contact_.data());
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = contact[i] > 0.0 ? values[i] : 0.0;
    }
  }
  StiffnessOutcome outcome;
  for (Group& group : groups_) {
    const StiffnessOutcome of_group = solve_group(group, tolerance, maximum_iterations);
    outcome.iterations = std::max(outcome.iterations, of_group.iterations);
    outcome.error = std::max(outcome.error, of_group.error);
    if (of_group.stop_reason != StopReason::tolerance_met) {
      outcome.stop_reason = of_group.stop_reason;
    }
  }
  pressure.resize(patches_.size());
  for (std::size_t k = 0; k < patches_.size(); ++k) {
    const Patch& patch = patches_[k];
    pressure[k].assign(patch.grid.element_count(), 0.0);
    if (patch.in_contact) {
      put_pressure(patch, force_.data(), pressure[k]);
    }
  }
  return outcome;
}

double force_of(const Grid& grid, std::span<const double> pressure) {
  double sum = 0.0;
  for (const double value : pressure) {
    sum += value;
  }
  return sum * grid.element_area();
}

} // namespace wrc

#include "mechanics/projected_cg.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/reductions.hpp"
#include "mechanics/constants.hpp"

namespace wrc {

namespace {

void scale_pressures(std::span<const IterationBox> boxes, double factor) {
  for (const IterationBox& box : boxes) {
    for (double& pressure : box.pressure) {
      pressure *= factor;
    }
  }
}

} // namespace

template <typename Real> void ProjectedCg<Real>::prepare(const IterationBox& box, Fields& fields) {
  fields.convolution =
      BoxConvolution<Real>::linear({box.rows, box.columns, box.rows, box.columns, 0, 0}, box.kernel,
                                   cache_, {box.angles, box.angles});
  fields.preconditioner =
      BoxConvolution<Real>::inverse_periodic(box.rows, box.columns, box.kernel, cache_);
  fields.has_mirrored = false;
  provide(fields.displacement, box.count());
  for (AlignedArray<Real>* array : {&fields.residual, &fields.last_residual, &fields.correction,
                                    &fields.direction, &fields.response, &fields.contact}) {
    provide(*array, box.count());
  }
  std::fill_n(fields.direction.data(), box.count(), Real{0});
  std::fill_n(fields.last_residual.data(), box.count(), Real{0});
  fields.last_z_r = 0.0;
  fields.factor = 1.0;
  if (request_->coupling != nullptr) {
    provide(fields.distance, box.count());
  }
}

/// u = K p. In the precision of the directions, or in double if they are single and it matters.
template <typename Real> void ProjectedCg<Real>::refresh_displacement(bool in_double) {
  ++convolutions_;
  const auto boxes = request_->boxes;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const IterationBox& box = boxes[k];
    Fields& fields = *fields_[k];
    if (in_double) {
      BoxConvolution<double>::linear({box.rows, box.columns, box.rows, box.columns, 0, 0},
                                     box.kernel, cache_, {box.angles, box.angles})
          .apply(box.pressure.data(), fields.displacement.data(), double_workspace_);
    } else {
      std::transform(box.pressure.begin(), box.pressure.end(), fields.response.data(),
                     [](double p) { return static_cast<Real>(p); });
      fields.convolution.apply(fields.response.data(), fields.response.data(), workspace_);
      std::copy_n(fields.response.data(), box.count(), fields.displacement.data());
    }
    if (request_->coupling != nullptr) {
      request_->coupling->gather(k, box.pressure.data(), pressure_nodes_.load);
    }
  }
  if (request_->coupling != nullptr) {
    request_->coupling->transfer(pressure_nodes_);
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      std::copy_n(boxes[k].distance.data(), boxes[k].count(), fields_[k]->distance.data());
      request_->coupling->sum_others(pressure_nodes_, k, others_[k]);
      request_->coupling->add<double>(k, others_[k], fields_[k]->distance.data());
    }
  }
}

/// K v within each box.
template <typename Real> void ProjectedCg<Real>::respond() {
  ++convolutions_;
  for (std::size_t k = 0; k < request_->boxes.size(); ++k) {
    Fields& fields = *fields_[k];
    fields.convolution.apply(fields.direction.data(), fields.response.data(), workspace_);
  }
}

/// How far to go in each box, and by how much its pressures then grow.
template <typename Real> void ProjectedCg<Real>::choose_steps() {
  const auto boxes = request_->boxes;
  const std::size_t count = boxes.size();
  for (std::size_t k = 0; k < count; ++k) {
    fields_[k]->factor = 1.0;
  }
  bool found = false;
  if (count > 1) {
    joint_step_.begin(count);
    step_sums_.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
      const IterationBox& box = boxes[k];
      const Fields& fields = *fields_[k];
      const JointStepSums& sums = step_sums_[k] = sum_joint_step(
          box.pressure.data(), fields.displacement.data(), fields.residual.data(),
          fields.direction.data(), fields.response.data(), box.shares.data(), box.count());
      joint_step_.set_energy(k, k, box.weight * sums.v_q);
      joint_step_.set_energy(k, count + k, box.weight * sums.p_q);
      joint_step_.set_energy(count + k, count + k, box.weight * sums.p_u);
      joint_step_.set_work(k, box.weight * sums.r_v);
      joint_step_.set_work(count + k, box.weight * sums.r_p);
      joint_step_.set_load(k, box.weight * sums.s_v);
      joint_step_.set_load(count + k, box.weight * sums.s_p);
    }
    if (request_->coupling != nullptr) {
      add_coupled_energies();
    }
    found = joint_step_.solve(request_->load.has_value());
  }
  double part = found ? 1.0 : 0.0;
  for (std::size_t k = 0; k < count && found; ++k) {
    const double growth = joint_step_.growth(k);
    part = std::min(part, (growth < 0.0 ? max_joint_step_shrinking : max_joint_step_growth) /
                              std::abs(growth));
  }
  if (part >= min_joint_step_part) {
    for (std::size_t k = 0; k < count; ++k) {
      Fields& fields = *fields_[k];
      fields.factor = 1.0 + part * joint_step_.growth(k);
      fields.step = part * joint_step_.step(k) / fields.factor; // pressures grow after it
    }
    return;
  }
  double r_v = 0.0;
  double v_q = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    const Fields& fields = *fields_[k];
    const StepSums step = sum_step(fields.residual.data(), fields.direction.data(),
                                   fields.response.data(), boxes[k].count());
    r_v += boxes[k].weight * step.r_v;
    v_q += boxes[k].weight * step.v_q;
  }
  for (std::size_t k = 0; k < count; ++k) {
    fields_[k]->step = v_q > 0.0 && r_v > 0.0 ? r_v / v_q : 0.0;
  }
}

/// Energies of the displacements of one box by another. Those of directions only decide the length
/// of a step: rough values lead to the same number of iterations.
template <typename Real> void ProjectedCg<Real>::add_coupled_energies() {
  const PatchCoupling& coupling = *request_->coupling;
  const std::size_t count = request_->boxes.size();
  for (std::size_t k = 0; k < count; ++k) {
    // The same for all boxes: weights go like element area times unit of length.
    const double unit = request_->boxes[k].weight / coupling.energy_unit(k);
    const double moved = step_sums_[k].v;
    for (std::size_t l = 0; l < count; ++l) {
      if (l < k) {
        joint_step_.set_energy(l, k, unit * coupling.rough_energy(k, moved, l, step_sums_[l].v));
        joint_step_.set_energy(count + l, count + k, unit * coupling.energy(pressure_nodes_, k, l));
      }
      if (l != k) {
        joint_step_.set_energy(k, count + l,
                               unit * coupling.rough_energy(k, moved, l, step_sums_[l].p));
      }
    }
  }
}

/// What the pressures of a box, which have moved and will be cut, add to the loads of its nodes.
template <typename Real> void ProjectedCg<Real>::gather_change(std::size_t k) {
  const IterationBox& box = request_->boxes[k];
  Fields& fields = *fields_[k];
  form_change(box.pressure.data(), fields.direction.data(), fields.step, fields.correction.data(),
              box.count());
  request_->coupling->gather(k, fields.correction.data(), load_change_);
}

/// Updates the displacements of boxes by each other after pressures have moved, been cut and been
/// scaled.
template <typename Real> void ProjectedCg<Real>::advance_coupling() {
  PatchCoupling& coupling = *request_->coupling;
  const std::size_t count = request_->boxes.size();
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<double>& load = pressure_nodes_.load[k];
    std::transform(load.begin(), load.end(), load_change_[k].begin(), load.begin(),
                   [factor = fields_[k]->factor](double now, double change) {
                     return factor * (now + change);
                   });
  }
  coupling.transfer(pressure_nodes_);
  for (std::size_t k = 0; k < count; ++k) {
    node_change_ = others_[k];
    coupling.sum_others(pressure_nodes_, k, others_[k]);
    std::transform(others_[k].begin(), others_[k].end(), node_change_.begin(), node_change_.begin(),
                   std::minus<>());
    coupling.add<Real>(k, node_change_, fields_[k]->distance.data());
  }
}

/// p = max(0, p + z): z estimates the error, so this removes most of the remaining one.
template <typename Real> void ProjectedCg<Real>::final_correction(double z_mean) {
  const auto boxes = request_->boxes;
  double load = 0.0;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const IterationBox& box = boxes[k];
    const Fields& fields = *fields_[k];
    double sum = 0.0;
    for (std::size_t i = 0; i < box.count(); ++i) {
      const double shift = z_mean * box.shares[i] * fields.contact.data()[i];
      box.pressure[i] = std::max(0.0, box.pressure[i] + (fields.correction.data()[i] - shift));
      sum += box.shares[i] * box.pressure[i];
    }
    load += box.weight * sum;
  }
  if (request_->load) {
    scale_pressures(boxes, *request_->load / load);
  }
}

template <typename Real> bool ProjectedCg<Real>::Progress::stuck() const {
  return outcome.iterations - best_iteration >= stagnation_window;
}

template <typename Real> typename ProjectedCg<Real>::Progress ProjectedCg<Real>::begin() {
  Progress progress;
  IterationOutcome& outcome = progress.outcome;
  const auto boxes = request_->boxes;
  outcome.reached.resize(boxes.size());
  std::size_t longest = 1;
  double load = 0.0;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const IterationBox& box = boxes[k];
    prepare(box, *fields_[k]);
    longest = std::max({longest, box.rows, box.columns});
    double sum = 0.0;
    for (std::size_t i = 0; i < box.count(); ++i) {
      sum += box.shares[i] * box.pressure[i];
      outcome.largest_pressure = std::max(outcome.largest_pressure, box.pressure[i]);
    }
    load += box.weight * sum;
  }
  if (request_->load) {
    const double factor = *request_->load / load;
    outcome.largest_pressure *= factor;
    scale_pressures(boxes, factor);
  }
  if (request_->coupling != nullptr) {
    pressure_nodes_ = request_->coupling->field();
    load_change_ = others_ = pressure_nodes_.load;
  }
  const double amplification = std::pow(static_cast<double>(longest), drift_exponent);
  progress.least_drift = double_drift * amplification;
  progress.drift_rate = is_single ? single_drift * amplification : progress.least_drift;
  progress.permitted_drift = request_->rounding_share * request_->tolerance;
  const bool in_double = is_single && progress.drift_rate > progress.permitted_drift;
  refresh_displacement(in_double);
  progress.rounding =
      (in_double ? progress.least_drift : progress.drift_rate) * outcome.largest_pressure;
  outcome.approach =
      request_->load ? (fields_[0]->displacement.data()[0] + distance_of(0)[0]) / boxes[0].shares[0]
                     : request_->approach;
  return progress;
}

/// Scales p and u by the remainder of the last step, and sets the approach by least squares of the
/// gaps under pressure.
template <typename Real> void ProjectedCg<Real>::update_approach(Progress& progress) {
  IterationOutcome& outcome = progress.outcome;
  double gap_sum = 0.0;
  double squares = 0.0;
  for (std::size_t k = 0; k < request_->boxes.size(); ++k) {
    const IterationBox& box = request_->boxes[k];
    Fields& fields = *fields_[k];
    const ContactMean mean =
        scale_and_average(box.pressure.data(), fields.displacement.data(), distance_of(k),
                          box.shares.data(), fields.factor, outcome.approach, box.count());
    fields.factor = 1.0;
    gap_sum += box.weight * mean.sum;
    squares += box.weight * mean.squares;
  }
  progress.drift = progress.rounding / std::max(outcome.largest_pressure, 1e-300);
  if (request_->load) {
    outcome.approach += gap_sum / squares;
  }
}

template <typename Real> void ProjectedCg<Real>::form_residuals(IterationOutcome& outcome) {
  for (std::size_t k = 0; k < request_->boxes.size(); ++k) {
    const IterationBox& box = request_->boxes[k];
    Fields& fields = *fields_[k];
    std::swap(fields.residual, fields.last_residual);
    form_residual(box.pressure.data(), fields.displacement.data(), distance_of(k),
                  box.shares.data(), outcome.approach, fields.residual.data(),
                  fields.contact.data(), box.count());
    outcome.reached[k] = reached_sides(box, fields.contact.data());
    outcome.reached_any = outcome.reached_any || outcome.reached[k].any();
  }
  outcome.convolutions = convolutions_;
}

template <typename Real>
typename ProjectedCg<Real>::Correction ProjectedCg<Real>::precondition(Progress& progress) {
  IterationOutcome& outcome = progress.outcome;
  const auto boxes = request_->boxes;
  sums_.resize(boxes.size());
  Correction correction;
  double z_sum = 0.0;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const IterationBox& box = boxes[k];
    Fields& fields = *fields_[k];
    fields.preconditioner.apply(fields.residual.data(), fields.correction.data(), workspace_);
    sums_[k] = sum_correction(fields.correction.data(), fields.residual.data(),
                              fields.last_residual.data(), fields.direction.data(),
                              fields.contact.data(), box.shares.data(), box.count());
    z_sum += box.weight * sums_[k].s_z;
    correction.contacts += box.weight * sums_[k].s_s;
  }
  correction.z_mean = mean_over(correction.contacts, z_sum);
  double largest_z = 0.0;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const double shift = correction.z_mean * boxes[k].share;
    if (sums_[k].s_s > 0.0) {
      largest_z = std::max({largest_z, sums_[k].largest_z - shift, shift - sums_[k].least_z});
    }
  }
  outcome.error = outcome.largest_pressure > 0.0 ? largest_z / outcome.largest_pressure
                                                 : (largest_z > 0.0 ? 1.0 : 0.0);
  if (outcome.error < progress.best_error) {
    progress.best_error = outcome.error;
    progress.best_iteration = outcome.iterations;
  }
  return correction;
}

template <typename Real> bool ProjectedCg<Real>::refreshed(Progress& progress) {
  if (!(progress.drift > progress.permitted_drift && progress.drift > 2.0 * progress.least_drift)) {
    return false;
  }
  refresh_displacement(is_single);
  progress.rounding = progress.least_drift * progress.outcome.largest_pressure;
  progress.best_error = std::numeric_limits<double>::infinity();
  progress.best_iteration = progress.outcome.iterations;
  for (std::size_t k = 0; k < request_->boxes.size(); ++k) {
    fields_[k]->last_z_r = 0.0;
    std::fill_n(fields_[k]->direction.data(), request_->boxes[k].count(), Real{0});
  }
  return true;
}

/// v = z + beta v, or r + beta v (`steepest`), both without load.
template <typename Real>
void ProjectedCg<Real>::choose_directions(const Correction& correction, bool steepest) {
  const auto boxes = request_->boxes;
  double mean = correction.z_mean;
  if (steepest) {
    double r_sum = 0.0;
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      r_sum += boxes[k].weight * sums_[k].s_r;
    }
    mean = mean_over(correction.contacts, r_sum);
  }
  double v_sum = 0.0;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    Fields& fields = *fields_[k];
    const double z_r = sums_[k].z_r - correction.z_mean * sums_[k].s_r;
    const double z_old_r = sums_[k].z_old_r - correction.z_mean * sums_[k].s_old_r;
    fields.beta = fields.last_z_r > 0.0 ? std::max(0.0, (z_r - z_old_r) / fields.last_z_r) : 0.0;
    fields.last_z_r = steepest ? 0.0 : z_r;
    v_sum += boxes[k].weight * fields.beta * sums_[k].s_v;
  }
  const double v_mean = mean_over(correction.contacts, v_sum);
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    Fields& fields = *fields_[k];
    form_direction(steepest ? fields.residual.data() : fields.correction.data(),
                   fields.direction.data(), fields.contact.data(), boxes[k].shares.data(),
                   fields.beta, mean + v_mean, boxes[k].count());
  }
}

/// p + alpha v, clipped; how it has to be scaled to keep the load is left to update_approach.
template <typename Real> void ProjectedCg<Real>::move_pressures(Progress& progress) {
  IterationOutcome& outcome = progress.outcome;
  const auto boxes = request_->boxes;
  PatchCoupling* coupling = request_->coupling;
  bool moves = false;
  double largest_change = 0.0;
  outcome.largest_pressure = 0.0;
  double load = 0.0;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const IterationBox& box = boxes[k];
    Fields& fields = *fields_[k];
    const MoveSums moved =
        move(box.pressure.data(), fields.displacement.data(), fields.direction.data(),
             fields.response.data(), box.shares.data(), fields.step, box.count());
    fields.cut = moved.negative_count;
    largest_change = std::max(largest_change, fields.factor * moved.largest_change);
    outcome.largest_pressure = std::max(outcome.largest_pressure, fields.factor * moved.largest);
    load += box.weight * fields.factor * moved.load;
    if (fields.step == 0.0) {
      fields.last_z_r = 0.0; // no descent along this direction: steepest descent next
    } else {
      moves = true;
    }
  }
  progress.idle = moves ? 0 : progress.idle + 1;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    if (coupling != nullptr) {
      gather_change(k);
    }
    if (fields_[k]->cut > 0.0) {
      clip_negative(boxes[k], *fields_[k], cache_, workspace_);
    }
  }
  const double kept_load = request_->load ? *request_->load / load : 1.0;
  double largest_factor = 0.0;
  double largest_growth = 0.0;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    double& factor = fields_[k]->factor;
    factor *= kept_load;
    largest_factor = std::max(largest_factor, factor);
    largest_growth = std::max(largest_growth, std::abs(factor - 1.0));
  }
  outcome.largest_pressure *= kept_load;
  progress.rounding =
      largest_factor * progress.rounding + progress.drift_rate * kept_load * largest_change;
  if (coupling != nullptr) {
    // Rounding of the displacements by other boxes.
    progress.rounding += progress.drift_rate * largest_growth * outcome.largest_pressure;
    advance_coupling();
  }
}

template <typename Real>
IterationOutcome ProjectedCg<Real>::solve(const IterationRequest& request) {
  request_ = &request;
  convolutions_ = 0;
  while (fields_.size() < request.boxes.size()) {
    fields_.push_back(std::make_unique<Fields>());
  }
  Progress progress = begin();
  IterationOutcome& outcome = progress.outcome;
  for (;; ++outcome.iterations) {
    update_approach(progress);
    form_residuals(outcome);
    if (outcome.reached_any) {
      break;
    }
    const Correction correction = precondition(progress);
    const bool met = progress.met(request.tolerance);
    const bool stuck = progress.stuck();
    if ((met || stuck) && refreshed(progress)) {
      continue;
    }
    if (met || stuck || outcome.iterations >= request.maximum_iterations) {
      outcome.stop_reason = met ? StopReason::tolerance_met
                                : (stuck ? StopReason::stagnation : StopReason::iteration_limit);
      final_correction(correction.z_mean);
      break;
    }
    // z, taken off its mean, need not lead to less energy far from the answer; r does.
    choose_directions(correction, progress.idle >= 2);
    respond();
    choose_steps();
    move_pressures(progress);
  }
  request_ = nullptr;
  return outcome;
}

template class ProjectedCg<float>;
template class ProjectedCg<double>;

} // namespace wrc

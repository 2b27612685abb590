#include "damage/wear.hpp"

#include <algorithm>
#include <cmath>

#include "damage/constants.hpp"

namespace wrc {
namespace {

std::vector<double> energy_of(const SlidingContact& contact) {
  std::vector<double> energy(contact.pressure.size());
  double sum = 0.0;
  double tractions = 0.0;
  for (std::size_t i = 0; i < energy.size(); ++i) {
    const double dissipated =
        -(contact.traction_x[i] * contact.slip_x[i] + contact.traction_y[i] * contact.slip_y[i]);
    energy[i] = std::max(dissipated, 0.0);
    sum += energy[i];
    tractions += std::hypot(contact.traction_x[i], contact.traction_y[i]);
  }
  const double power = std::max(contact.power_per_speed, 0.0) / contact.grid.element_area();
  const bool slips = sum > least_dissipated_share * power;
  for (std::size_t i = 0; i < energy.size(); ++i) {
    if (slips) {
      energy[i] *= power / sum;
    } else {
      const double traction = std::hypot(contact.traction_x[i], contact.traction_y[i]);
      energy[i] = tractions > 0.0 ? power * traction / tractions : 0.0;
    }
  }
  return energy;
}

} // namespace

double archard_coefficient(double sliding_speed, double pressure, double hardness) {
  if (pressure > seizure_pressure * hardness) {
    return archard_seizure;
  }
  return sliding_speed < severe_speed_first || sliding_speed > severe_speed_last ? archard_mild
                                                                                 : archard_severe;
}

double usfd_wear_rate(double energy) {
  if (energy < usfd_severe_energy) {
    return usfd_mild_slope * energy;
  }
  return usfd_severe_rate +
         usfd_catastrophic_slope * std::max(energy - usfd_catastrophic_energy, 0.0);
}

Wear wear_of(const SlidingContact& contact, const WearRequest& request) {
  Wear wear;
  wear.energy = energy_of(contact);
  wear.rate.resize(wear.energy.size());
  for (std::size_t i = 0; i < wear.rate.size(); ++i) {
    const double e = wear.energy[i];
    double rate = 0.0;
    if (request.law == WearLaw::usfd) {
      // ug/(m mm^2) to mm^3/(mm^2 mm)
      rate = usfd_wear_rate(e) * 1e-9 / steel_density;
    } else if (request.law == WearLaw::energy) {
      rate = request.energy_coefficient * e;
    } else if (contact.friction > 0.0 && e > 0.0) {
      const double speed = contact.slip_speed * std::hypot(contact.slip_x[i], contact.slip_y[i]);
      rate = archard_coefficient(speed, contact.pressure[i], request.hardness) * e /
             (contact.friction * request.hardness);
    }
    wear.rate[i] = request.scale * rate;
  }
  const std::size_t columns = contact.grid.longitudinal_count;
  for (std::size_t row = 0; row < contact.grid.lateral_count; ++row) {
    double depth = 0.0;
    for (std::size_t column = 0; column < columns; ++column) {
      depth += wear.rate[row * columns + column] * contact.grid.longitudinal_step;
    }
    wear.depth.push_back(depth);
    wear.volume += depth * contact.grid.lateral_step;
  }
  return wear;
}

} // namespace wrc

/// Wear from the energy that friction dissipates, element by element.
///
/// Energy: e = -q.s per area and distance rolled (MPa: N mm per mm^2 and mm). Its sum is scaled to
/// the power -F.w over the speed, which is exact in steady rolling: what the discretisation of slip
/// loses is shared in proportion; where nothing slips on the grid, in proportion to the traction.
/// Laws, as volume per area of contact and distance rolled (no unit, mm^3/(mm^2 mm)):
///   energy:   c e, one coefficient c in mm^3/(N mm)
///   archard:  k e/(mu H): k p |s|/H where |q| = mu p (Archard, J. Appl. Phys. 24, 1953), with k
///   from
///             a map by sliding speed and p/H (Jendel, Wear 253, 2002)
///   usfd:     K(e)/density, K in ug/(m mm^2), mild, severe and catastrophic (Lewis & Dwyer-Joyce,
///             Proc. IMechE J 218, 2004; Braghin et al., Wear 261, 2006), for R8T wheel on 900A
///             rail
/// Across the profile each row of elements takes off a depth: of the rail per wheel that passes, of
/// the wheel per turn. Its integral across is the volume per distance rolled, in mm^2.
///
/// Units mm, N, MPa, s. Thread rule: pure functions. Not known here: lubrication, temperature, how
/// the loss is shared between wheel and rail (each law is that of one body).
#pragma once

#include <span>
#include <vector>

#include "base/grid.hpp"

namespace wrc {

enum class WearLaw { usfd, archard, energy };

struct WearRequest {
  WearLaw law = WearLaw::usfd;
  double energy_coefficient = 0.0; ///< c, mm^3/(N mm)
  double hardness = 0.0;           ///< H, MPa
  double scale = 1.0;              ///< of every law: lubrication, other steels
};

/// The tangential contact as it was solved; fields per element.
struct SlidingContact {
  Grid grid;
  std::span<const double> pressure;
  std::span<const double> traction_x;
  std::span<const double> traction_y;
  std::span<const double> slip_x; ///< over the speed
  std::span<const double> slip_y;
  double friction = 0.0;
  double slip_speed = 0.0;      ///< what slip is multiplied with to give velocities, mm/s
  double power_per_speed = 0.0; ///< that of friction, N
};

struct Wear {
  std::vector<double> energy; ///< e per element, MPa
  std::vector<double> rate;   ///< volume per area and distance rolled, per element
  std::vector<double> depth;  ///< per row of elements, mm
  double volume = 0.0;        ///< per distance rolled, mm^2
};

/// k of Archard's law, no unit.
double archard_coefficient(double sliding_speed, double pressure, double hardness);
/// K of the USFD law in ug/(m mm^2); e in MPa is T-gamma over the area in N/mm^2.
double usfd_wear_rate(double energy);

Wear wear_of(const SlidingContact& contact, const WearRequest& request);

} // namespace wrc

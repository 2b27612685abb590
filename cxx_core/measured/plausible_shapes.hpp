/// What wheels and rails of railways and trams measure, and what is said of points that do not.
///
/// Each dimension has its source. Units mm, frame of profile.hpp. Thread rule: constants.
#pragma once

#include <string_view>

#include "base/warning.hpp"
#include "profile/curve.hpp"

namespace wrc::plausible {

/// A dimension that is checked.
struct Shape {
  Position range; ///< least and greatest
  WarningClass kind;
  /// %: a value, #: one without decimals; < and >: the ends of the range.
  std::string_view warning;

  [[nodiscard]] bool holds(double value) const { return value >= range[0] && value <= range[1]; }
};

/// Between least and greatest lateral.
/// origin: published: wheels are 105 to 150 mm wide, heads of rails 50 to 80 (EN 13715, EN 13674-1,
/// EN 14811), measurements may end earlier.
inline constexpr Shape width{{50.0, 200.0},
                             WarningClass::profile_dimensions,
                             "width % mm, expected < to >; state the scale"};
/// Of the flange above the taping line.
/// origin: published: flanges are 20 (trams) to 38 mm (worn) high.
inline constexpr Shape flange_height{{20.0, 45.0},
                                     WarningClass::profile_dimensions,
                                     "flange height % mm, expected < to >; state origin, "
                                     "mirror_height or the scale"};
/// Of the flange tip from the flange back.
/// origin: published: 10 to 21 mm (EN 13715).
inline constexpr Shape tip_distance{{8.0, 28.0},
                                    WarningClass::profile_origin,
                                    "with the taping line at 0, the flange tip's distance from the "
                                    "flange back is % mm, expected < to >; state origin"};
/// Of the flange back from where the taping line says.
/// origin: reasoned: backs wear by 2 mm at most.
inline constexpr Shape back_distance{
    {-4.0, 4.0},
    WarningClass::profile_origin,
    "the flange back is at lateral % mm, expected % by the distance of the taping line; state "
    "origin or tape_offset"};
/// Lateral that a wheel has beside its taping line: its flange root and the outer tread.
/// origin: published: the flank begins 32 to 40 mm beside the taping line (EN 13715).
inline constexpr Shape reach{{-20.0, 20.0},
                             WarningClass::profile_origin,
                             "lateral from % to % mm: the taping line, at 0, is not inside by > "
                             "mm; state origin, mirror_height or the scale"};
/// Of a wheel at its taping line; more is another origin and no rounding of a drawing.
/// origin: reasoned: coefficients of standards leave 0.03 mm; the radius would be wrong by as much.
inline constexpr Shape tape_height{{-1.0, 1.0},
                                   WarningClass::profile_origin,
                                   "height % mm at the taping line, expected 0; state "
                                   "origin, mirror_height or the scale"};
/// Height of a rail's crown.
/// origin: measured: worn rails of the collection have their crown at up to 1.7 mm below 0.
inline constexpr Shape crown_height{{-5.0, 5.0},
                                    WarningClass::profile_origin,
                                    "the crown is at height % mm, expected near 0; a scene puts it "
                                    "to the height of the track"};

/// Width of the flange of a wheel that is given as a rail, ...
/// origin: measured: flanges of the collection are 28 to 38 mm wide.
inline constexpr Shape flange_width{{20.0, 45.0},
                                    WarningClass::profile_dimensions,
                                    "the shape is that of a wheel, with a flange # mm high beside "
                                    "a tread # mm wide; expected is a rail"};
/// ... least width of its tread, and greatest width of a part beyond the tip that is as high.
/// origin: measured: treads of the collection are 95 to 111 mm wide. Of rails a crossing has parts
/// 29 mm wide and 38 mm off the rest, which is 54 mm wide; one with wings a groove 38 mm wide and
/// 49 mm deep, one with a guard rail a groove of 52 and 47 mm.
inline constexpr double least_tread_width = 75.0;
inline constexpr double most_beyond_tip = 10.0;

/// What stands off the tread by more than this belongs to a flange or a face, or, of half a rail,
/// to its head or foot.
/// origin: published: flanges are measured 10 mm above the taping line (EN 13715), where treads and
/// chamfers (5 mm) do not reach; half heads of rails are 25 mm thicker than half webs, half feet 50
/// (EN 13674-1).
inline constexpr double off_tread = 8.0;
/// Narrower than this it is no flange.
/// origin: measured: flanges of five measured wheels are 28 to 35 mm wide, from the tip alone 18;
/// faces and worn gauge corners up to 9.
inline constexpr double least_flange_width = 12.0;
/// How much wider than its counterpart the wider part of a shape has to be to be plain.
/// origin: reasoned: heads and flanges are five times as wide as faces; scatter is a few per cent.
inline constexpr double plainly_wider = 1.5;
/// Depth in which a rail is wide at its top, and as a fraction of shallow measurements.
/// origin: derived: a circular arc is 3.1 times as wide in the upper third of its height as in the
/// lower one.
inline constexpr double top_depth = 5.0;
inline constexpr double top_share = 1.0 / 3.0;
/// Points that are higher are those of a whole rail with its foot.
/// origin: published: heads are up to 51 mm high, rails 140 to 190 (EN 13674-1).
inline constexpr double greatest_head_height = 100.0;
/// Points of a disc are so close to a circle or a cylinder, whose middle is beside theirs by such a
/// small fraction of the width.
/// origin: reasoned: discs are ground to 0.01 mm; crowns of rails have arcs of two radii, which
/// differ by 0.3 mm, cones of treads rise to one side.
inline constexpr double disc_tolerance = 0.05;
inline constexpr double disc_eccentricity = 0.05;

/// Widths that tell units: of a wheel, of a rail's head.
/// origin: published: EN 13715, EN 13674-1.
inline constexpr double usual_wheel_width = 135.0;
inline constexpr double usual_head_width = 72.0;
/// A unit of another power of ten is taken by these widths, an inch or a cm only near a whole
/// profile's width, by this factor.
/// origin: reasoned: 1000 cannot be mistaken; 10 and 25.4 differ by 2.5, so 1.3 keeps them apart.
inline constexpr Position thinkable_width{20.0, 300.0};
inline constexpr double near_width = 1.3;
/// All slices of a list that are narrower are in metres.
/// origin: reasoned: the narrowest slice, a blade of a switch, is a few mm wide; the widest, a
/// crossing with its wing rails, 0.5 m.
inline constexpr double narrowest_slice = 2.0;
/// The outline of a whole rail is longer than what can be its running surface.
/// origin: published: outlines of EN 13674-1 are up to 690 mm long.
inline constexpr double longest_outline = 1000.0;
/// Columns are swapped if the first extends over less than this share of the second.
/// origin: published: wheels and heads of rails are at least 1.9 times as wide as high (EN 13715,
/// EN 13674-1).
inline constexpr double swapped_ratio = 0.6;

/// Taping line of a wheel from its flange back, where nothing states it.
/// origin: published: EN 13715.
inline constexpr double usual_tape_offset = 70.0;
/// Where a wheel that counts from its flange back begins, and its tip.
/// origin: measured: files of six instruments begin at -0.2 to 3.9, tips are at 15 to 21.
inline constexpr Position begin_from_back{-5.0, 12.0};
inline constexpr Position tip_from_back{5.0, 40.0};
/// A flange back was measured if the points begin so far below the tip.
/// origin: reasoned: rounded tips are 5 to 8 mm high.
inline constexpr double back_depth = 10.0;

/// Depth below the top that a wheel touches, and depth of a chamfer.
/// origin: published: gauge faces are measured 14 mm below the top, chamfers are 5 mm high (EN
/// 13715).
inline constexpr double contact_depth = 14.0;
inline constexpr double chamfer_depth = 6.0;
/// How far below the highest point a running surface can reach.
/// origin: published: rail heads of EN 13674-1 are up to 38 mm high at their side faces; below a
/// flange tip lie its height, 28, and rims measured down to 40 below the tread.
inline constexpr double depth_of_rail = 40.0;
inline constexpr double depth_of_wheel = 75.0;
/// From the taping line to either end of a wheel. origin: published: EN 13715.
inline constexpr double half_width = 65.0;
/// Less of a wheel may lie anywhere on a nominal one.
/// origin: published: wheels are 105 mm wide or more (EN 13715, EN 14811).
inline constexpr double least_wheel_width = 100.0;
/// Waves that wheels and rails have: a smoothing that halves them needs a statement.
/// origin: published: gauge corners and flange roots have radii of 8 to 15 mm (EN 13674-1, EN
/// 13715), whose arcs are longer.
inline constexpr double shape_wave = 5.0;

} // namespace wrc::plausible

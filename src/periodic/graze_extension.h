// The smooth extension of a map beyond a graze: the motion with one contact kept in its mode while
// the guard dips that ends it, with the least value of the guard there. The mode is the open one
// before a touch, one in contact before a release or the end of a force, slip before sides just
// come to stick, stick before they just slip.
//
// A motion x(t; x_0, p) has the least value g = G(x(t_g), t_g; p) of a guard at t_g, dG/dt = 0, so
// that its derivative is that at fixed t_g,
//
//   dg/dx_0 = G_x x_x(t_g),   dg/dp = G_x x_p(t_g) + G_p
//
// What the contact does behind the graze, to first order in the depth -g:
//   force continuous, or a dashpot c that may pull: nothing; its impulse c int u' dt vanishes
//   dashpot that lets go at zero force: the impulse c (-g) of the way in, and the compression -g of
//     an internal state: derivatives jump by (d/dg of these, carried to the end) dg
//   rigid: sqrt(-g); derivatives are unbounded
//   slip rate g that just falls to zero: the sides stick until t_g, v = 0 instead of g: derivatives
//     jump by that change of the velocities, carried to the end. Where the static coefficient is
//     larger than the kinetic one they stick on: motions on the two sides are far from each other
// Where a mode in contact ends the force is continuous, or that of a dashpot whose impulse over the
// dip vanishes: nothing. A bumper that lets go for a time t of the order sqrt(-g) lies -g t away
// when it is met again, which changes the velocity by as little as (-g)^(3/2). Sides that just slip
// out of stick do so at speeds of the order of g.
// (Nordmark 1991; di Bernardo, Budd & Champneys 2001; di Bernardo, Kowalczyk & Nordmark 2002)
//
// Where a slip ends and sides turn round, the least value is that of h, minus the guard of stick
// by which they slip on: h < 0 where they stick in between. The map itself is its own extension.
// With the instant t_e of the turn, at which the slip rate v is zero,
//
//   dh = h_x x_x(t_e) + h' dt_e,   dt_e = -v_x x_x(t_e) / v'     ' total time derivatives
#pragma once

#include "continuation/problem.h"
#include "periodic/guard_minima.h"
#include "periodic/open_contact.h"
#include "periodic/stroboscopic_map.h"

#include <vector>

namespace vibroimpact::periodic {

/// What a graze is, as continuation::Extension::kind.
enum class GrazeKind : int {
  contact,           ///< sides just touch, or just let go, or a force just ends
  crossing_sliding,  ///< slip turns round: behind it the sides stick for a moment in between
  grazing_sliding,   ///< the slip rate just falls to zero: behind it the sides stick for a moment
  switching_sliding, ///< sides come to stick: behind it they slip the other way for a moment first
  adding_sliding     ///< stick nearly ends: behind it they slip for a moment
};

/// Part of a motion in which one guard may graze once; phases in periods, of a free period since
/// the start of the motion.
struct GrazeWindow {
  std::size_t contact = 0;
  int mode = 0;
  std::size_t guard = 0;
  bool in_contact = false; ///< the mode that the guard ends; false: the guard closes the contact
  double begin = 0, position = 0, end = 0;
  double nearness = 0; ///< least value, or depth of the touch, over the size of the motion; rough
  bool passed = false; ///< the guard falls below zero there
  /// Where a slip ends: the guard of stick that grazes; nothing is overlooked.
  std::optional<Overlooked> stick{};

  Overlooked overlooked() const {
    return in_contact ? Overlooked{contact, mode, guard} : Overlooked{.contact = contact};
  }
};

/// The maps of a motion that may graze, with the same keys.
struct GrazingMaps {
  const StroboscopicMap &map;
  const StroboscopicMap &open;            ///< that overlooks the guard of the window
  const StroboscopicMap *stick = nullptr; ///< where a slip ends, that overlooks the guard of stick
};

/// Of a motion whose guards may graze close by: those that close contacts, the nearest first, those
/// that end modes in contact, the nearest first, and where slip ends.
std::vector<GrazeWindow> graze_windows(const StroboscopicMap &map, const Section &section,
                                       const Vector &state);

struct GrazingFlow {
  continuation::Extension extension{};
  double touch = 0;       ///< phase of the least value [periods], in the section
  EventPattern pattern{}; ///< with the touch as a change that leaves the mode as it is
};

/// Of x -> P(x; p) - x.
/// NumericalError when the section lies in the window, or the guard has no minimum there.
GrazingFlow extend(const GrazingMaps &maps, const Section &section, const Vector &state,
                   const GrazeWindow &window);

/// From the start of a section to a later phase in it, past a window that lies in it.
Flow flow_past(const GrazingMaps &maps, double from, double to, const Vector &state,
               const GrazeWindow &window);

} // namespace vibroimpact::periodic

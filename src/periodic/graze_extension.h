// The smooth extension of a map beyond a graze: the motion with one contact kept in its mode while
// the guard dips that ends it, with the least value of the guard there. The mode is the open one
// before a touch, one in contact before a release or the end of a force.
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
// Where a mode in contact ends the force is continuous, or that of a dashpot whose impulse over the
// dip vanishes: nothing. A bumper that lets go for a time t of the order sqrt(-g) lies -g t away
// when it is met again, which changes the velocity by as little as (-g)^(3/2).
// (Nordmark 1991; di Bernardo, Budd & Champneys 2001)
#pragma once

#include "continuation/problem.h"
#include "periodic/guard_minima.h"
#include "periodic/open_contact.h"
#include "periodic/stroboscopic_map.h"

#include <vector>

namespace vibroimpact::periodic {

/// Part of a motion in which one guard may graze once; phases in periods.
struct GrazeWindow {
  std::size_t contact = 0;
  int mode = 0;
  std::size_t guard = 0;
  bool in_contact = false; ///< the mode that the guard ends; false: the guard closes the contact
  double begin = 0, position = 0, end = 0;
  double nearness = 0; ///< least value, or depth of the touch, over the size of the motion; rough

  Overlooked overlooked() const {
    return in_contact ? Overlooked{contact, mode, guard} : Overlooked{.contact = contact};
  }
};

/// Of a motion whose guards may graze close by: those that close contacts, the nearest first, and
/// those that end modes in contact, the nearest first.
std::vector<GrazeWindow> graze_windows(const StroboscopicMap &map, const Section &section,
                                       const Vector &state);

struct GrazingFlow {
  continuation::Extension extension{};
  double touch = 0;       ///< phase of the least value [periods], in the section
  EventPattern pattern{}; ///< with the touch as a change that leaves the mode as it is
};

/// Of x -> P(x; p) - x. `open`: the map that overlooks the guard of the window; both with the same
/// keys.
/// NumericalError when the section lies in the window, or the guard has no minimum there.
GrazingFlow extend(const StroboscopicMap &map, const StroboscopicMap &open, const Section &section,
                   const Vector &state, const GrazeWindow &window);

/// From the start of a section to a later phase in it, past a window that lies in it.
Flow flow_past(const StroboscopicMap &map, const StroboscopicMap &open, double from, double to,
               const Vector &state, const GrazeWindow &window);

} // namespace vibroimpact::periodic

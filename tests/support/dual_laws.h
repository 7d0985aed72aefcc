// The contact laws, written down from their formulas in dual numbers.
#pragma once

#include "support/dual_motion.h"

#include <string>

namespace vibroimpact::testing {

/// k u^n or k u, and what else a law has.
struct DualLaw {
  Dual stiffness, loss;
};

inline DualGuard when(DualFunction indicator, int target, DualFunction reset = {}) {
  return {.indicator = std::move(indicator), .target = target, .reset = std::move(reset)};
}
inline DualGuard gap_closes(int target, DualFunction reset = {}) {
  return when([](const DualLocal &x) { return x.gap; }, target, std::move(reset));
}
inline DualGuard gap_opens(int target) {
  return when([](const DualLocal &x) { return -x.gap; }, target);
}
inline DualGuard root_ends(int target) {
  return when([](const DualLocal &x) { return x.root; }, target);
}
inline DualFunction opposite(const DualFunction &function) {
  return [function](const DualLocal &x) { return -function(x); };
}

/// Contact ends with the overlap.
inline std::vector<DualMode> while_overlapping(DualFunction force, bool rooted) {
  return {{.guards = {gap_closes(1)}},
          {.force = std::move(force),
           .guards = {rooted ? root_ends(0) : gap_opens(0)},
           .rooted = rooted}};
}
/// The force acts while `push` is positive. `reset` of the internal state where contact begins.
inline std::vector<DualMode> while_pushing(DualFunction force, const DualFunction &push,
                                           const DualFunction &push_outside, bool rooted,
                                           DualFunction reset = {}) {
  return {{.guards = {gap_closes(1, std::move(reset))}},
          {.force = std::move(force),
           .guards = {rooted ? root_ends(0) : gap_opens(0), when(push, 2)},
           .rooted = rooted},
          {.guards = {gap_opens(0), when(opposite(push_outside), 1)}}};
}

inline Dual third_half(const Dual &root) { return root * root * root * root * root * root; }

inline std::vector<DualMode> kelvin_voigt_bumper(const DualLaw &law) {
  const Dual k = law.stiffness, c = law.loss;
  const DualFunction force = [=](const DualLocal &x) { return -(k * x.gap + c * x.gap_rate); };
  const DualFunction recovery = [=](const DualLocal &x) { return -(k / c * x.internal); };
  const DualFunction pushed_in = [](const DualLocal &x) { return -x.gap; };
  const DualFunction distance = [](const DualLocal &x) { return x.gap + x.internal; };
  const DualFunction parting = [=](const DualLocal &x) { return c * x.gap_rate - k * x.internal; };
  return {{.internal_rate = recovery, .guards = {when(distance, 1, pushed_in)}},
          {.force = force,
           .internal_rate = [](const DualLocal &x) { return -x.gap_rate; },
           .guards = {when(force, 2, pushed_in)}},
          {.internal_rate = recovery, .guards = {when(parting, 0)}}};
}

inline std::vector<DualMode> hunt_crossley(const DualLaw &law) {
  const Dual k = law.stiffness, d = law.loss;
  const DualFunction push = [=](const DualLocal &x) { return Dual(1) - d * x.gap_rate; };
  return while_pushing([=](const DualLocal &x) { return k * third_half(x.root) * push(x); }, push,
                       push, true);
}
// With the dissipation d_c / (approach speed).
inline std::vector<DualMode> hunt_crossley_of_speed(const DualLaw &law) {
  const Dual k = law.stiffness, d = law.loss;
  const DualFunction push = [=](const DualLocal &x) { return x.internal - d * x.gap_rate; };
  return while_pushing(
      [=](const DualLocal &x) { return k * third_half(x.root) * push(x) / x.internal; }, push, push,
      true, [](const DualLocal &x) { return -x.gap_rate; });
}
inline std::vector<DualMode> kuwabara_kono(const DualLaw &law) {
  const Dual k = law.stiffness, a = 1.5 * law.loss;
  const DualFunction push = [=](const DualLocal &x) {
    return x.root * x.root * x.root * x.root - a * x.gap_rate;
  };
  return while_pushing([=](const DualLocal &x) { return k * x.root * x.root * push(x); }, push,
                       [=](const DualLocal &x) { return -x.gap - a * x.gap_rate; }, true);
}
inline std::vector<DualMode> kelvin_voigt(const DualLaw &law) {
  const Dual k = law.stiffness, c = law.loss;
  const DualFunction force = [=](const DualLocal &x) { return -(k * x.gap + c * x.gap_rate); };
  return while_pushing(force, force, force, false);
}
/// Rests after an impact without restitution.
inline std::vector<DualMode> rigid(bool rests) {
  DualGuard impact = gap_closes(rests ? 1 : 0);
  impact.impact = true;
  return {{.guards = {impact}},
          {.guards = {when([](const DualLocal &x) { return x.force_of_rest; }, 0)}, .rests = true}};
}

inline std::vector<DualMode> dual_modes(const std::string &name, const DualLaw &law) {
  const Dual k = law.stiffness, c = law.loss;
  if (name == "linear penalty")
    return while_overlapping([=](const DualLocal &x) { return -(k * x.gap); }, false);
  if (name == "kelvin-voigt")
    return kelvin_voigt(law);
  if (name == "bilinear stop")
    return while_overlapping([=](const DualLocal &x) { return -(k * x.gap + c * x.gap_rate); },
                             false);
  if (name == "kelvin-voigt bumper")
    return kelvin_voigt_bumper(law);
  if (name == "hertz")
    return while_overlapping([=](const DualLocal &x) { return k * third_half(x.root); }, true);
  if (name == "hunt-crossley")
    return hunt_crossley(law);
  if (name == "hunt-crossley of the approach speed")
    return hunt_crossley_of_speed(law);
  if (name == "tsuji")
    return while_overlapping(
        [=](const DualLocal &x) { return k * third_half(x.root) - c * x.root * x.gap_rate; }, true);
  if (name == "kuwabara-kono")
    return kuwabara_kono(law);
  return rigid(law.loss.value == 0);
}

} // namespace vibroimpact::testing

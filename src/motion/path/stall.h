// Bounds the work of a motion that hardly advances: how often in a row a contact may leave a mode
// at once.
//
// In a linear phase whose largest exponent is |e| a guard is a straight line but for (t |e|)^2: one
// that has risen from zero falls back to it within t << 1 / |e| only if it left zero with hardly
// any slope. A contact may do so where it grazes, and then stays in its next mode: a force that
// ends has been there for some part of 1 / |e|. One that goes to and fro, each time in less than a
// thousandth of 1 / |e|, has guards that are zero but for rounding, and time advances by what
// rounding happens to leave. Where no |e| is known a stay counts that is shorter than a hundred
// times the uncertainty of an instant, and so before an impact: infinitely many of these in a
// finite time are completed at once (Collisions). Contacts that change in turn do not count: of
// many each stays long.
//
// Steps and contact changes of any kind are counted too, until the motion is beyond a horizon that
// no motion needs thousands of them for: a billionth of the shortest time scale, or what the
// uncertainty of an instant leaves, where that is more, up to a thousandth of that scale.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

namespace vibroimpact::motion {

class StallBound {
public:
  /// highest_frequency: of the model [rad/s]; 0: nothing vibrates.
  void begin(std::size_t n_contacts, double highest_frequency) {
    contacts_.assign(n_contacts, {});
    const bool vibrates = highest_frequency > 0;
    shortest_ = vibrates ? 1e-3 / highest_frequency : std::numeric_limits<double>::infinity();
    least_ = vibrates ? 1e-9 / highest_frequency : 0;
    quick_ = count_ = 0;
    mark_ = -std::numeric_limits<double>::infinity();
  }
  /// Something was done; the motion is at `time` [s] now, an instant with the `uncertainty` [s].
  void pass(double time, double uncertainty) {
    const bool beyond = time > mark_ + std::min(std::max(100 * uncertainty, least_), shortest_);
    count_ = beyond ? 0 : count_ + 1;
    mark_ = beyond ? time : mark_;
  }
  /// A contact changes its mode at `time` [s], in a phase with the largest exponent |e| [1/s], 0:
  /// not known; `uncertainty`: of the instant [s].
  void note(std::size_t contact, double time, double fastest, double uncertainty) {
    Stays &stays = contacts_[contact];
    const bool quick = time - stays.end < (fastest > 0 ? 1e-3 / fastest : 100 * uncertainty);
    quick_ = stays.quick = quick ? stays.quick + 1 : 0;
    stays.end = time;
  }

  /// The way in which the motion proceeds does not lead on.
  bool slow() const { return std::max(quick_, count_) > 1000; }
  /// Nor does any other.
  bool stalled() const { return std::max(quick_, count_) > 10000; }

private:
  struct Stays {
    double end = -std::numeric_limits<double>::infinity(); ///< of the last [s]
    long quick = 0;                                        ///< in a row
  };
  std::vector<Stays> contacts_;
  long quick_ = 0;      ///< of the contact that changed last
  double shortest_ = 0; ///< a thousandth of the shortest time scale [s]
  double least_ = 0;    ///< a billionth of it, 0 where there is none [s]
  double mark_ = 0;
  long count_ = 0; ///< since the mark
};

} // namespace vibroimpact::motion

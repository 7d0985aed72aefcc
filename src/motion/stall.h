// Bounds the work of a motion that hardly advances.
//
// Steps, flights and contact changes are counted until the motion is beyond a horizon: a hundred
// times the uncertainty of an event's instant, or a thousandth of the shortest time scale where
// that is less. No motion needs thousands of them there.
#pragma once

namespace vibroimpact::motion {

class StallBound {
public:
  void begin(double time) {
    mark_ = time;
    count_ = 0;
  }
  /// Something was done; the motion is at `time` now. Both in s.
  void note(double time, double horizon) {
    if (time > mark_ + horizon)
      begin(time);
    else
      ++count_;
  }

  /// The way in which the motion proceeds does not lead on.
  bool slow() const { return count_ > 1000; }
  /// Nor does any other.
  bool stalled() const { return count_ > 10000; }

private:
  double mark_ = 0;
  long count_ = 0;
};

} // namespace vibroimpact::motion

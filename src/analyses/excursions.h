// Extreme values of a motion over a window, from the dense output.
#pragma once

#include "analyses/channels.h"
#include "analyses/system.h"
#include "common/result_sink.h"
#include "integration/observer.h"

#include <limits>
#include <vector>

namespace vibroimpact {

/// Smallest and largest value seen.
struct Extent {
  double minimum = std::numeric_limits<double>::infinity();
  double maximum = -std::numeric_limits<double>::infinity();

  void include(const Bernstein &polynomial);
  void include(double value);
  /// maximum - minimum; 0 when nothing was seen.
  double peak_to_peak() const;
  /// Largest absolute value.
  double peak() const;
};

class Excursions : public Observer {
public:
  explicit Excursions(const System &system);

  void step(const StepView &view) override;

  /// Adds peak-to-peak and peak excursions of every channel (displacements also in space where the
  /// base moves), the largest force and the extreme gaps
  /// of every contact as scalar fields and summary lines.
  void add_fields(PointResult &result) const;

private:
  struct ChannelExtents {
    Extent displacement, absolute, velocity, acceleration;
  };
  struct ContactExtents {
    Extent gap, force;
  };

  const ContactSet &contacts_;
  std::vector<Channel> channels_;
  std::vector<ChannelExtents> channel_extents_;
  std::vector<ContactExtents> contact_extents_;
};

} // namespace vibroimpact

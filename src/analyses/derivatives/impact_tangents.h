// The derivatives of what is recorded of impacts.
//
// The instant of an event moves by its delay t'. Of an impact from t_0 to t_1
//
//   duration         t_1' - t_0'
//   approach speed   -(dg'/dp + g'' t_0'), before the event
//   impulse          integral of (DF + F s) dt over its smooth intervals,
//                    plus the derivative of the impulses at events
//
// where DF = dF/dp + F' t' is the derivative at a time that moves along with both ends of an
// interval, t' linear between them and s = (t_1' - t_0') / (t_1 - t_0). At a fixed time dF/dp would
// be infinite where contact begins, for laws whose slope is infinite there.
#pragma once

#include "analyses/derivatives/form_tangents.h"
#include "analyses/derivatives/smooth_intervals.h"

namespace vibroimpact::analyses {

struct ImpactTangent {
  double approach_speed = 0, impulse = 0, duration = 0;
};

/// An instant inside an interval, and how much it counts in integrals over that [s].
struct IntegrationNode {
  double time = 0, weight = 0, place = 0; ///< place in the interval, 0 to 1
  std::size_t interval = 0;
};

/// Follows the motion apart from extreme values: stops close to where the slope of a force is
/// infinite cost digits of what follows.
class ImpactTangents : public TangentVisitor {
public:
  /// Keeps references.
  ImpactTangents(const contact::ContactSet &contacts, const std::vector<SmoothInterval> &intervals,
                 FormTangents &forms);

  /// Nodes of all intervals in which some contact may have a force.
  std::vector<double> stops() const override;
  void stop(std::size_t place, const TangentPoint &at) override;
  void event(const TangentEvent &event) override;

  /// Per contact, of the impacts that have ended; approach speeds of all onsets.
  std::vector<std::vector<ImpactTangent>> impacts;
  std::vector<std::vector<double>> approach_speeds;

private:
  struct Track {
    ImpactTangent present;
    double begun = 0; ///< delay of the beginning
    bool complete = false;
    /// Integrals over the present interval of dF/dp, of F' times the distances from its start and
    /// its end, and of F.
    double change = 0, to_start = 0, to_end = 0, force = 0;
    double jump = 0; ///< derivative of an impulse at the present instant
  };
  void close_interval(double time, double delay);
  void take_jumps(const TangentEvent &event);
  void begin(Track &track, const TangentEvent &event) const;
  bool in_contact(std::size_t contact, int mode) const;

  const contact::ContactSet &contacts_;
  const std::vector<SmoothInterval> &intervals_;
  FormTangents &forms_;
  std::vector<IntegrationNode> nodes_;
  std::vector<Track> tracks_;
  double start_ = 0, start_delay_ = 0; ///< of the present interval
  std::size_t interval_ = 0;           ///< of the last node
};

} // namespace vibroimpact::analyses

// The derivatives of extreme values.
//
// An extreme value max_t m(x(t), t; p) at the instant t* changes by (envelope theorem)
//
//   d max/dp = dm/dp at the fixed time t*         where m is flat, m' = 0
//            = dm/dp + m' dt*/dp, on its side      where t* is an event, which moves by dt*/dp
//
// Inside a smooth interval the instant t* itself is known only up to the dense output of a step, m'
// is not quite zero there, and dm/dp at a fixed time changes fast where the whole motion shifts in
// time. To first order in both
//
//   d max/dp = dm/dp + m' dt*/dp,   dt*/dp = -(d/dt dm/dp) / m''
//
// with the two slopes from an instant close by.
#pragma once

#include "analyses/derivatives/form_tangents.h"
#include "analyses/recorders/recorder.h"
#include "common/scalar.h"

namespace vibroimpact::analyses {

class ExtremeTangents : public TangentVisitor {
public:
  /// Keeps references to the extrema and the forms. `events`: instants, ascending [s].
  ExtremeTangents(const std::vector<ObservedExtremum> &extrema, const std::vector<double> &events,
                  FormTangents &forms);

  std::vector<double> stops() const override;
  void stop(std::size_t place, const TangentPoint &at) override;
  void event(const TangentEvent &event) override;
  std::size_t events() const { return events_; } ///< seen

  /// Of the value, per unit of the key; 0 where nothing was seen, NaN where it has none. One of the
  /// extrema.
  double of(const motion::Extremum &extremum) const { return find(extremum).derivative; }
  /// The motion has the value that was seen, to a thousandth of `range`.
  bool is_of_motion(const motion::Extremum &extremum, double range) const;

private:
  struct Place {
    const motion::Extremum *extremum = nullptr;
    TangentOf of{};
    bool inside = false;
    double derivative = nan;
    Tangent at{}, beside{};

    void take_inside();
  };
  struct Stop {
    double time = 0;
    Place *place = nullptr;
    bool beside = false;
  };
  const Place &find(const motion::Extremum &extremum) const;

  std::vector<Place> places_;
  std::vector<Stop> stops_; ///< of those inside a smooth interval, in the order of time
  std::size_t events_ = 0;
};

} // namespace vibroimpact::analyses

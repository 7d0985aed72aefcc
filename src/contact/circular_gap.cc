#include "contact/circular_gap.h"

#include <cmath>

namespace vibroimpact::contact {

namespace {

double dot(const AcrossAxis &a, const AcrossAxis &b) { return a[0] * b[0] + a[1] * b[1]; }

// form += along . u + along_rate . u'
void add(const AcrossAxis &along, double position, double rate, AffineForm &form) {
  form.gap += position * along[0];
  form.tangential[0].position += position * along[1];
  form.gap_rate += rate * along[0];
  form.tangential[0].rate += rate * along[1];
}

// s / r; at the centre, where nothing touches and any direction serves, directions do not turn.
double bend_of(double sense, const CircularFrame &frame) {
  return frame.distance > 0 ? sense / frame.distance : 0;
}

} // namespace

AffineForm normal_force_gradient(const LawResponse &response) {
  return {.gap = response.force_by_gap,
          .gap_rate = response.force_by_gap_rate,
          .internal = response.force_by_internal};
}

AffineForm internal_rate_gradient(const LawResponse &response, int state, int n_internal) {
  const auto i = static_cast<std::size_t>(state);
  const double *by_internal =
      response.internal_rate_by_internal.data() + static_cast<std::ptrdiff_t>(state) * n_internal;
  AffineForm form{.gap = response.internal_rate_by_gap[i],
                  .gap_rate = response.internal_rate_by_gap_rate[i],
                  .internal = {by_internal, by_internal + n_internal}};
  for (std::size_t k = 0; k < most_tangential; ++k)
    if (const std::vector<double> &by = response.tangential[k].internal_rate_by_slip_rate;
        !by.empty())
      form.tangential[k].rate = by[i];
  return form;
}

// At r = 0, where the gap has no slope, any direction serves.
CircularFrame CircularGap::frame(const RelativeMotion &motion) const {
  CircularFrame frame{.distance = std::hypot(motion.position[0], motion.position[1])};
  frame.normal = {-sense_, 0};
  if (frame.distance > 0)
    frame.normal = {-sense_ * motion.position[0] / frame.distance,
                    -sense_ * motion.position[1] / frame.distance};
  frame.tangent = {-frame.normal[1], frame.normal[0]};
  frame.gap_rate = dot(frame.normal, motion.rate);
  frame.turning = dot(frame.tangent, motion.rate);
  return frame;
}

void CircularGap::see(const CircularFrame &frame, LocalState &state) const {
  state.gap = sense_ * (clearance_ - frame.distance);
  state.gap_rate = frame.gap_rate;
  state.tangential[0].slip_rate = frame.turning + surface_speed_;
}

// g'' = n . u'' - s (t . u')^2 / r,  v' = t . u'' + s (n . u') (t . u') / r
double CircularGap::acceleration(const CircularFrame &frame, const AcrossAxis &acceleration,
                                 int direction) const {
  const double turning = bend_of(sense_, frame) * frame.turning;
  return direction == 0 ? dot(frame.normal, acceleration) - turning * frame.turning
                        : dot(frame.tangent, acceleration) + turning * frame.gap_rate;
}

AcrossAxis CircularGap::force(const CircularFrame &frame, const LawResponse &response) const {
  AcrossAxis force{};
  for (std::size_t k = 0; k < force.size(); ++k)
    force[k] = response.force * frame.normal[k] + response.tangential[0].force * frame.tangent[k];
  return force;
}

// dg = n . du, dg' = n . du' - s (t . u') (t . du) / r, dv = t . du' + s (n . u') (t . du) / r
AffineForm CircularGap::gradient(const CircularFrame &frame, const AffineForm &form) const {
  const double bend = bend_of(sense_, frame);
  const double slip_rate = form.tangential[0].rate;
  AffineForm made{.internal = form.internal};
  add(frame.normal, form.gap, form.gap_rate, made);
  add(frame.tangent,
      form.tangential[0].position +
          bend * (slip_rate * frame.gap_rate - form.gap_rate * frame.turning),
      slip_rate, made);
  return made;
}

// df = dN n + dF t + (F n - N t) s (t . du) / r
std::array<AffineForm, 2> CircularGap::force_gradient(const CircularFrame &frame,
                                                      const LawResponse &response) const {
  const AffineForm normal = gradient(frame, normal_force_gradient(response));
  const AffineForm tangential = gradient(frame, response.tangential[0].by);
  std::array<AffineForm, 2> made;
  for (std::size_t k = 0; k < made.size(); ++k) {
    made[k] = frame.normal[k] * normal + frame.tangent[k] * tangential;
    add(frame.tangent,
        bend_of(sense_, frame) *
            (response.tangential[0].force * frame.normal[k] - response.force * frame.tangent[k]),
        0, made[k]);
  }
  return made;
}

// With the turning w = t . u': d(n . u'') = -s (t . u'') (t . du) / r,
// d(s w^2 / r) = 2 s w dw / r - s w^2 dr / r^2,  dw = t . du' + s g' (t . du) / r,  dr = -s n . du.
// Likewise d(t . u'') = s (n . u'') (t . du) / r,
// d(s g' w / r) = s (w dg' + g' dw) / r - s g' w dr / r^2,  dg' = n . du' - s w (t . du) / r
AffineForm CircularGap::acceleration_gradient(const CircularFrame &frame,
                                              const AcrossAxis &acceleration, int direction) const {
  const double bend = bend_of(sense_, frame);
  const double turning = bend * frame.turning; // s w / r
  AffineForm made;
  if (direction > 0) {
    const double sliding = bend * frame.gap_rate;
    add(frame.tangent,
        bend * dot(frame.normal, acceleration) - turning * turning + sliding * sliding, sliding,
        made);
    add(frame.normal, sliding * turning, turning, made);
    return made;
  }
  add(frame.tangent, -bend * (dot(frame.tangent, acceleration) + 2 * turning * frame.gap_rate),
      -2 * turning, made);
  add(frame.normal, -turning * turning, 0, made);
  return made;
}

} // namespace vibroimpact::contact

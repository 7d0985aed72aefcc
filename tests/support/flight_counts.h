// Runs random flights through Trajectory, observed and not, and judges the first contact of
// each by the closed form.
#pragma once

#include "motion/path/trajectory.h"
#include "support/lumped_models.h"
#include "support/random_flights.h"
#include "support/true_contact.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <optional>

namespace vibroimpact::testing {

/// Remembers the first touch for ever and exerts no force; with a clock its internal state counts
/// the time since then.
class TouchLaw : public contact::ContactLaw {
public:
  explicit TouchLaw(bool clock)
      : contact::ContactLaw({{.name = "open",
                              .guards = {{.indicator = {.gap = 1}, .target = 1}},
                              .affine = law(clock, 0)},
                             {.name = "touched", .affine = law(clock, 1)}},
                            std::vector<double>(clock ? 1 : 0, 0.0)) {}
  std::string name() const override { return "touch"; }
  int initial_mode(const contact::LocalState & /*state*/) const override { return 0; }
  void evaluate(int mode, const contact::LocalState &state,
                contact::LawResponse &response) const override {
    response = {};
    const std::size_t n = state.internal.size();
    response.force_by_internal.assign(n, 0);
    response.internal_rate.assign(n, mode);
    response.internal_rate_by_gap.assign(n, 0);
    response.internal_rate_by_gap_rate.assign(n, 0);
    response.internal_rate_by_internal.assign(n * n, 0);
  }

private:
  static contact::AffineLaw law(bool clock, double rate) {
    contact::AffineLaw law;
    if (clock)
      law.internal_rate = {{.constant = rate}};
    return law;
  }
};

/// The system of a RandomSystem as the program knows it.
struct BuiltSystem {
  BuiltSystem(const RandomSystem &system, bool clock)
      : model({body(system)}), contacts(stops(system, model, clock)),
        trajectory(model, contacts, motion::Settings{}) {}
  BuiltSystem(const BuiltSystem &) = delete;
  BuiltSystem &operator=(const BuiltSystem &) = delete;

  model::Model model;
  contact::ContactSet contacts;
  motion::Trajectory trajectory;

private:
  static std::shared_ptr<const reduction::ReducedBody> body(const RandomSystem &system) {
    const auto n = static_cast<Index>(system.modes.size());
    auto body = std::make_shared<reduction::ReducedBody>();
    body->name = "body";
    body->type = "lumped";
    body->mass = Vector::Ones(n);
    body->stiffness = Vector::Zero(n);
    body->damping = Matrix::Zero(n, n);
    body->base_participation = Matrix::Zero(n, 3);
    Matrix rows = Matrix::Zero(6, n); // contacts along x, the force along y
    for (Index j = 0; j < n; ++j) {
      const TrueMode &mode = system.modes[static_cast<std::size_t>(j)];
      body->stiffness[j] = mode.stiffness;
      body->damping(j, j) = mode.damping;
      rows(0, j) = mode.weight;
      rows(1, j) = mode.load;
    }
    body->points.push_back({.name = "head", .position = Vector3::Zero(), .rows = rows});
    return body;
  }

  static contact::ContactSet stops(const RandomSystem &system, model::Model &model, bool clock) {
    if (system.force.amplitude != 0)
      model.add_force("force",
                      std::make_shared<model::Harmonic>(model::Given::displacement,
                                                        system.force.amplitude,
                                                        system.force.frequency, system.force.phase),
                      {.body = 0, .point = 0}, Vector3::UnitY());
    const auto law = std::make_shared<TouchLaw>(clock);
    contact::ContactPair right = contact_along_x(model, "body.head", "", system.right, law);
    contact::ContactPair left = contact_along_x(model, "body.head", "", system.left, law);
    left.gap.row *= -1;
    return contact::ContactSet({right, left});
  }
};

/// What the program found.
struct FoundContact {
  std::optional<double> time;
  long undecided = 0;
};

struct FlightCounts {
  long flights = 0;
  long contacts = 0;
  long near = 0;    ///< judged by multiprecision: within 1e-9 of touching somewhere
  long in_band = 0; ///< touches that rounding may take for a contact, before any contact
  struct Path {
    long missed = 0, invented = 0;
    long decided_in_band = 0;  ///< touches within the band taken for contacts
    long reported = 0;         ///< flights with undecided touches, as the program reports them
    long reported_outside = 0; ///< of them those without a touch within the band
    double worst_instant = 0;  ///< [s], of contacts outside it
  };
  std::array<Path, 2> path; ///< observed, not observed

  long wrong() const {
    long sum = 0;
    for (const Path &p : path)
      sum += p.missed + p.invented + p.reported_outside;
    return sum;
  }
};

class FlightCounter {
public:
  explicit FlightCounter(const RandomSystem &system)
      : system_(system), observed_(system, false), unwatched_(system, true) {}

  void count(const RandomFlight &flight, FlightCounts &counts) {
    const TrueFlight truth(system_.modes, system_.force, flight.displacement, flight.velocity);
    const double size = truth.size(std::max(system_.right, system_.left), flight.end);
    band_ = 64 * std::numeric_limits<double>::epsilon() * size;
    const TrueContact contact = first_contact(truth, flight.end);
    ++counts.flights;
    counts.near += truth.used_multiprecision();
    counts.contacts += contact.time.has_value();
    counts.in_band += !contact.touches.empty();
    judge(truth, contact, flight.end, fly_watched(flight), counts.path[0]);
    judge(truth, contact, flight.end, fly_unwatched(flight), counts.path[1]);
  }

private:
  class FirstEvent : public motion::Observer {
  public:
    void event(const motion::ContactEvent &event) override {
      if (!time)
        time = event.time;
    }
    std::optional<double> time;
  };

  static motion::MotionState start(const RandomFlight &flight, Index internal) {
    const auto n = static_cast<Index>(flight.displacement.size());
    motion::MotionState state{.time = 0, .physical = Vector::Zero(2 * n + internal)};
    state.physical.head(n) = ConstVectorView(flight.displacement.data(), n);
    state.physical.segment(n, n) = ConstVectorView(flight.velocity.data(), n);
    return state;
  }

  FoundContact fly_watched(const RandomFlight &flight) {
    FirstEvent first;
    observed_.trajectory.start(start(flight, 0));
    observed_.trajectory.advance(flight.end, first);
    return {first.time, observed_.trajectory.accuracy().undecided_events};
  }

  FoundContact fly_unwatched(const RandomFlight &flight) {
    unwatched_.trajectory.start(start(flight, 2));
    unwatched_.trajectory.advance(flight.end);
    const Vector clocks = unwatched_.trajectory.motion_state().physical.tail(2);
    const motion::Accuracy accuracy = unwatched_.trajectory.accuracy();
    if (accuracy.events == 0)
      return {std::nullopt, accuracy.undecided_events};
    return {flight.end - clocks.maxCoeff(), accuracy.undecided_events};
  }

  TrueContact first_contact(const TrueFlight &truth, double end) {
    TrueContact right = truth.contact(system_.right, 1, end, band_);
    TrueContact left = truth.contact(system_.left, -1, end, band_);
    if (left.time && (!right.time || *left.time < *right.time))
      right.time = left.time;
    right.touches.insert(right.touches.end(), left.touches.begin(), left.touches.end());
    in_band_ = right.in_band || left.in_band;
    if (right.time)
      std::erase_if(right.touches, [&](double touch) { return touch > *right.time; });
    return right;
  }

  bool within_band(const TrueFlight &truth, double time) const {
    const long double gap =
        std::min(truth.gap(system_.right, 1, time), truth.gap(system_.left, -1, time));
    return std::abs(gap) <= band_;
  }

  void judge(const TrueFlight &truth, const TrueContact &contact, double end,
             const FoundContact &found, FlightCounts::Path &path) const {
    const double tolerance = 1e-12 + 32 * std::numeric_limits<double>::epsilon() * end;
    path.reported += found.undecided > 0;
    path.reported_outside += found.undecided > 0 && !in_band_;
    if (!found.time) {
      path.missed += contact.time && *contact.time < end - tolerance;
      return;
    }
    const double late = contact.time ? static_cast<double>(*found.time - *contact.time) : -INFINITY;
    if (std::abs(late) <= tolerance) {
      path.worst_instant = std::max(path.worst_instant, std::abs(late));
      return;
    }
    if (within_band(truth, *found.time)) {
      path.decided_in_band += !contact.touches.empty() && late < 0;
      path.invented += contact.touches.empty() && !contact.time;
      return;
    }
    if (!contact.time)
      ++path.invented;
    else
      ++(late > 0 ? path.missed : path.invented);
  }

  RandomSystem system_;
  BuiltSystem observed_, unwatched_;
  double band_ = 0;
  bool in_band_ = false; // anywhere in the flight
};

/// The flights of system number `index`: all kinds of touches in turn.
inline void count_system(std::uint64_t seed, std::uint64_t index, int flights, bool safe_path,
                         FlightCounts &counts) {
  FlightGenerator generator(seed + 0x9e3779b97f4a7c15u * index);
  const RandomSystem system = generator.system(safe_path);
  FlightCounter counter(system);
  constexpr std::array kinds = {Touch::anywhere,   Touch::near_start, Touch::anywhere,
                                Touch::inflection, Touch::anywhere,   Touch::departure};
  for (int i = 0; i < flights; ++i)
    counter.count(generator.flight(system, kinds[static_cast<std::size_t>(i) % kinds.size()]),
                  counts);
}

} // namespace vibroimpact::testing

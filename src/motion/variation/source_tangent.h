// How the sources of a model change with a key.
//
// The derivative at a fixed time is taken from the sources of neighbouring models, with weights
// that make it exact for polynomials of the key. Where the key changes the frequency, as long as
// the phase theta = omega t is not small differences at a fixed time would be useless; so the
// neighbours are compared at the same phase, and
//
//   ds/dp at t  =  ds/dp at omega t  +  s'(t) t (d omega/dp) / omega
//
// Between two breaks each source is continued by its closed form, so that it does not matter on
// which side of an instant a break of a neighbour lies.
#pragma once

#include "model/model.h"
#include "motion/phase/excitation.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace vibroimpact::motion {

/// What the sources of a model do in time.
using Histories = std::vector<std::shared_ptr<const model::TimeFunction>>;

class SourceTangent {
public:
  /// Keeps references. `weights`: of the difference of each neighbour to the model.
  SourceTangent(const model::Model &model, std::vector<Histories> neighbours, Vector weights);

  /// From now on times lie between `from` and the next break `to` (+infinity: none). NumericalError
  /// when a neighbour has its break elsewhere.
  void enter(double from, double to);

  /// d(s, s', s'')/dp of a source at a time.
  std::array<double, 3> at(std::size_t source, double time) const;
  /// s, s', s'' themselves.
  std::array<double, 3> value(std::size_t source, double time) const;
  /// d(to)/dp, of the break that ends the interval [s].
  double break_rate() const { return break_rate_; }

  /// How the generator of the inputs of a linear phase changes, m x m [1/s]. The sources must have
  /// closed forms. NumericalError when a neighbour has inputs of other kinds.
  const Matrix &input_generator() const;
  /// Changes with input_generator().
  long generation() const { return generation_; }
  /// How the coordinates of the inputs change: m.
  Vector input_coordinates(double time) const;

private:
  struct Interval {
    std::optional<model::ExponentialForm> form;
    std::vector<std::optional<model::ExponentialForm>> neighbours;
    bool changes = true;              ///< with the key
    double stretch = 0;               ///< (d omega/dp) / omega
    std::vector<double> time_factors; ///< of each neighbour: the time at which it has the phase
    Excitation inputs{};              ///< of this source alone, where it has a closed form
    std::vector<Excitation> near_inputs{}; ///< none where it does not change
  };
  void take_inputs(Interval &interval) const;
  void find_input_generator();
  double inside() const;
  double last_instant() const;
  void find_break_rate();

  const model::Model &model_;
  std::vector<Histories> neighbours_;
  Vector weights_;
  std::vector<Interval> intervals_; ///< per source
  double from_ = 0, to_ = 0;
  double break_rate_ = 0;
  Matrix input_generator_;
  bool same_inputs_ = true; ///< as all neighbours
  long generation_ = 0;
};

} // namespace vibroimpact::motion

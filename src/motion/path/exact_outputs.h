// Extreme values of linear forms of the motion in a phase. Forms that are parallel (a displacement
// and a gap, a gap and the force of a spring there) have their extreme values together and are one
// output, searched once.
#pragma once

#include "motion/interval/output.h"
#include "motion/phase/exact_phase.h"

#include <vector>

namespace vibroimpact::motion {

class ExactOutputs {
public:
  /// Keeps references to both.
  ExactOutputs(const LinearOutputs &forms, const ExactPhase &phase);

  /// The inputs of the phase are others.
  void renew();

  std::size_t size() const { return leaders_.size(); }
  std::size_t bytes() const { return bytes_of(storage_, dense_magnitudes_); }
  /// That the searches so far have examined, of parts of the motion and blocks of eight outputs.
  long pieces() const { return view_.pieces; }

  /// The ranges grow by a part of the motion, from its amplitudes at both ends, `length` apart [s].
  void include(const double *from, const double *to, double length);

private:
  /// A range that grows by factor * output + shift.
  struct Share {
    ValueRange *range = nullptr;
    std::size_t output = 0;
    double factor = 1, inverse = 1, shift = 0;
  };

  void share_output(std::size_t form);
  void begin();
  void end();
  void arrange();
  void set_group(const PhaseGroup &group);
  void set_pair(std::size_t output, const PhaseGroup &group);
  void set_dense(std::size_t output, const PhaseGroup &group);
  double seen(std::size_t output, Index coordinate) const;
  void store(std::size_t output, std::size_t j, Index order, double real, double imaginary);

  const LinearOutputs &forms_;
  const ExactPhase &phase_;
  std::vector<std::size_t> leaders_; ///< of each output, a form
  std::vector<Share> shares_;        ///< of all forms
  long arrangement_ = -1, generation_ = -1;
  AlignedArray storage_, dense_magnitudes_;
  // In the storage, for the view:
  double *constants_ = nullptr, *minimum_ = nullptr, *maximum_ = nullptr, *rows_ = nullptr,
         *sixth_ = nullptr, *sizes_ = nullptr, *single_ = nullptr;
  OutputsView view_;
};

} // namespace vibroimpact::motion

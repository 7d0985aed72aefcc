// Extreme values over a step of many contacts, by the polynomials that the step itself goes by.
//
// What belongs to a contact grows by each stretch of its course as soon as that is over; what
// belongs to none grows once for each step.
#pragma once

#include "motion/interval/observer.h"
#include "motion/moments/moment_step.h"

#include <vector>

namespace vibroimpact::motion {

class MomentRanges {
public:
  /// Keeps references.
  MomentRanges(const Equations &equations, const MomentStep &step);

  /// What the observers ask for in the present modes of the equations. False: some of it is known
  /// from steps alone, or one of them must see these.
  bool ask(const std::vector<Observer *> &observers);
  /// By a stretch of the contact's course, in whose mode they were asked.
  void include(std::size_t contact, const CourseStretch &stretch);
  /// The step is over, and they were asked in the modes there: by the last stretch of each contact,
  /// and by the whole step what belongs to none.
  void include_ends();

private:
  std::optional<std::size_t> contact_of(const OutputForm &form) const;
  bool known(const OutputForm &form) const;
  void include(const Output &output, std::size_t contact, const CourseStretch &stretch);
  void include_open(std::size_t contact) const;
  Bernstein curve(const OutputForm &form, std::size_t contact, const CourseStretch &stretch) const;
  void include_force(const Output &output, std::size_t contact, const CourseStretch &stretch);

  const Equations &equations_;
  const MomentStep &step_;
  std::vector<std::size_t> contact_of_internal_;
  Audience audience_;
  std::vector<std::vector<Output>> of_contacts_;
  std::vector<std::size_t> asked_; ///< contacts with outputs, each once
  std::vector<Output> others_;
  contact::LawResponse response_;
};

} // namespace vibroimpact::motion

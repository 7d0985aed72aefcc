// Where along a motion a contact is about to change its mode, or has hardly changed it.
#pragma once

#include "contact/contact_set.h"
#include "motion/interval/observer.h"

#include <map>
#include <optional>
#include <tuple>
#include <vector>

namespace vibroimpact::periodic {

/// A guard that closes an open contact, or that ends a mode in contact, comes near to zero, or
/// falls below it for a short time.
struct GuardMinimum {
  std::size_t contact = 0;
  int mode = 0;              ///< that the guard ends
  std::size_t guard = 0;     ///< in that mode
  bool in_contact = false;   ///< the mode is one in contact
  double time = 0;           ///< of the minimum, or the middle of the time below zero [s]
  double begin = 0, end = 0; ///< of that time [s]; both `time` where there is none
  double value = 0;          ///< least value; where it falls below zero its rate there
  bool passed = false;       ///< it falls below zero
};

/// A slip that ends: whether the sides stick then is decided by a guard of stick, by which they
/// slip on the other way.
struct SlipEnd {
  std::size_t contact = 0;
  int mode = 0;             ///< of the slip
  std::size_t guard = 0;    ///< that ends it
  int stick = 0;            ///< the mode of stick
  std::size_t slips_on = 0; ///< the guard of stick
  double time = 0;          ///< [s]
  double next = 0;          ///< of the next change of the contact [s]; `time` where there is none
};

/// Lists the minima of a motion that it observes.
class MinimumObserver : public motion::Observer {
public:
  /// `contacts` with the laws whose guards count; the motion may have some that overlook guards.
  explicit MinimumObserver(const contact::ContactSet &contacts) : contacts_(contacts) {}

  void step(const motion::StepView &view) override;
  void event(const motion::ContactEvent &event) override;
  const std::vector<GuardMinimum> &minima() const { return minima_; }
  /// Of contacts with friction along one direction that stick.
  const std::vector<SlipEnd> &slip_ends() const { return slip_ends_; }
  /// The guard is below zero at the end: a contact that has not parted again, or a mode in contact
  /// that has not come back.
  bool lasts(const GuardMinimum &minimum) const;
  /// When a contact parts for the first time that is closed from the start [s].
  std::optional<double> first_parting(std::size_t contact) const;
  /// Largest absolute value of the guard of a mode in contact.
  double largest(const GuardMinimum &minimum) const;

private:
  using Place = std::tuple<std::size_t, int, std::size_t>; ///< contact, mode, guard
  void note_minima(const motion::StepView &view, const Place &place, bool in_contact);
  void touch(const motion::ContactEvent &event, std::size_t guard);
  void part(const motion::ContactEvent &event);
  void leave(const motion::ContactEvent &event, std::size_t guard);
  void end_slip(const motion::ContactEvent &event, std::size_t guard);
  void come_back(const motion::ContactEvent &event);
  void end_of(std::vector<std::size_t> &open, std::vector<std::size_t>::iterator at, double time);
  bool in_contact(std::size_t contact, int mode) const {
    return contacts_.pairs()[contact].law->modes()[static_cast<std::size_t>(mode)].in_contact;
  }

  struct Seen {
    double largest = 0; ///< absolute value
    double rate = 0;    ///< at the end of the last step
  };
  const contact::ContactSet &contacts_;
  std::vector<GuardMinimum> minima_;
  std::vector<SlipEnd> slip_ends_;
  std::vector<std::size_t> closed_;      ///< places in minima_ of the contacts that are closed
  std::vector<std::size_t> left_;        ///< places in minima_ of modes in contact that are left
  std::map<Place, Seen> seen_;           ///< of modes in contact
  std::map<std::size_t, double> parted_; ///< of contacts that are closed from the start [s]
};

} // namespace vibroimpact::periodic

// The derivative by one key of all that a motion is made of, at a fixed time and state.
//
// A key of the parameter file (a clearance, a stiffness, a mass, an amplitude, a frequency, a
// variable) changes the assembled model. The model is smooth in it and has nothing to do with
// motion, so that its derivative follows from models assembled at a few neighbouring values,
//
//   df/dp = sum over i of w_i (f(p + d_i) - f(p)),   sum of w_i d_i^m = 1 for m = 1, 0 for m = 2
//   ... 4
//
// exact but for d^4 f^(5): with d = 1e-3 |p| to about 1e-12. Motions are never differenced. Forces
// of contacts, which are not smooth where a contact begins, are differenced at fixed gap, gap rate
// and internal states; what the key does to the gap enters by the chain rule.
#pragma once

#include "motion/interval/observer.h"
#include "motion/system/linear_system.h"
#include "motion/variation/model_tangent.h"
#include "motion/variation/source_tangent.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vibroimpact::motion {

struct SourceFrequency {
  std::size_t source = 0;
  double angular = 0; ///< [rad/s]
};

/// What a motion is made of at the value p + offset of a key. Model and contacts that the key does
/// not change may be the very ones of the present value; no difference of them is taken then.
struct KeyNeighbour {
  double offset = 0; ///< not zero [unit of the key]
  std::shared_ptr<const model::Model> model;
  std::shared_ptr<const contact::ContactSet> contacts;
  std::optional<SourceFrequency> frequency{}; ///< of a source, in place of that of the model

  static KeyNeighbour of(double offset, model::Model model, contact::ContactSet contacts);
  /// The model with that frequency.
  model::Model own_model() const;
  Histories histories() const;
};

class KeyTangent {
public:
  /// Keeps references to the model and the contacts. Four neighbours, on one side of the present
  /// value or on both. NumericalError when they have other coordinates, contacts or sources, or
  /// when they do not change smoothly.
  KeyTangent(std::string key, const model::Model &model, const contact::ContactSet &contacts,
             std::vector<KeyNeighbour> neighbours);

  const std::string &key() const { return key_; }
  const SourceTangent &sources() const { return *sources_; }
  /// The motion comes into an interval between two breaks of the sources [s].
  void enter(double from, double to) { sources_->enter(from, to); }

  /// d(dx/dt)/dp of the physical state in the present modes of `equations`.
  Vector rates(const Equations &equations, double time, const Vector &state) const;
  /// d(gap, gap rate)/dp of a contact, or of the slip along a tangential direction; of a circular
  /// gap as its law sees them, the slip being zero.
  double gap(std::size_t contact, double time, const Vector &state, int direction = 0) const;
  double gap_rate(std::size_t contact, double time, const Vector &state, int direction = 0) const;

  /// Picks an affine form of a law.
  using Pick = std::function<const contact::AffineForm &(const contact::ContactLaw &)>;
  /// Of the value that such a form has at a state; the force that holds a gap counts as fixed.
  double form(const Equations &equations, std::size_t contact, const Pick &pick, double time,
              const Vector &state) const;
  /// Of the jump of the velocities in a collision: n entries.
  Vector jump(const Equations &equations, const Collision &collision, double time,
              const Vector &before) const;

  /// Of a linear phase, y' = A y + b + loads.
  struct LinearTangent {
    Matrix matrix;
    Vector constant;
    std::vector<LinearSystem::Load> loads;
  };
  /// For these modes of the contacts, in which the equations are `own`; kept from the first call
  /// on.
  const LinearTangent &linear(const std::vector<int> &modes, const LinearSystem &own) const;
  /// The neighbours are linear without contacts, as a cubic spring that begins with the key is not.
  bool keeps_linear() const { return keeps_linear_; }
  /// How far the neighbours lie from the key [its unit].
  double reach() const { return reach_; }
  /// No two keys have the same.
  long identity() const { return identity_; }

private:
  struct Near {
    KeyNeighbour data;
    mutable std::unique_ptr<Equations> equations; ///< once they are asked for
    double weight = 0;
  };
  struct Forces {
    Vector present; ///< F of all contacts
    Vector change;  ///< of all that pushes them apart or along: n entries
  };
  /// Of a local state and what its law makes of it, at fixed coordinates and velocities.
  struct ContactTangent {
    double gap = 0, gap_rate = 0, slip_rate = 0;
    double force = 0, tangential_force = 0;
    Vector internal_rates;
  };
  LinearTangent make_linear(const std::vector<int> &modes, const LinearSystem &own) const;
  Vector linear_rates(const Equations &equations, double time, const Vector &state) const;
  bool is_unchanged(const KeyNeighbour &neighbour) const {
    return neighbour.model.get() == &model_ && neighbour.contacts.get() == &contacts_;
  }
  void check_structure() const;
  void check_smoothness() const;
  Forces forces(const Equations &equations, double time, const Vector &state, const Vector &rates,
                Vector &change) const;
  ContactTangent contact(const Equations &equations, std::size_t contact, double time,
                         const Vector &state, contact::LawResponse &own) const;
  Vector circular_force(const Equations &equations, std::size_t contact, double time,
                        const Vector &state, const ContactTangent &tangent,
                        const contact::LawResponse &own) const;
  contact::RelativeMotion moved(std::size_t contact, double time, const Vector &state) const;
  contact::LocalState moved_local_state(std::size_t contact, double time,
                                        const Vector &state) const;
  double normal_force(const Equations &equations, std::size_t contact, double time,
                      const Vector &state) const;
  void refuse_friction(const Equations &equations) const;
  Vector acceleration(const model::Model &model, const contact::ContactSet &contacts, double time,
                      const Vector &state, const std::vector<SourceValues> &sources,
                      const Vector &forces) const;
  void add_rates_with_rotors(const Equations &equations, double time, const Vector &state,
                             const std::vector<SourceValues> &sources, const Vector &contact_forces,
                             const Vector &rates, Vector &change) const;
  double position(std::size_t contact, double time, const Vector &state, int direction) const;
  double rate(std::size_t contact, double time, const Vector &state, int direction) const;
  contact::RelativeMotion relative_motion(std::size_t contact, double time,
                                          const Vector &state) const;
  double gap_by_sources(std::size_t contact, double time, std::size_t order, int direction) const;
  double held_forces(const Equations &equations, std::size_t contact,
                     const contact::AffineForm &forces, double time, const Vector &state) const;
  Vector force_of_sources(const Equations &equations, double time, const Vector &state,
                          const std::vector<SourceValues> &sources) const;
  void hold(const Equations &equations, double time, const Vector &state, const Vector &rates,
            Vector &change) const;

  std::string key_;
  const model::Model &model_;
  const contact::ContactSet &contacts_;
  std::vector<Near> near_; ///< none where the sources alone change, as with a frequency
  std::unique_ptr<SourceTangent> sources_;
  std::unique_ptr<ModelTangent> data_;
  mutable std::map<std::vector<int>, LinearTangent> linear_; ///< by the modes of the contacts
  double reach_ = 0;
  bool keeps_linear_ = false;
  long identity_;
};

} // namespace vibroimpact::motion

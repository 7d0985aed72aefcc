// What a linear phase is asked for, as linear forms of its rows [y, then s, s', s'' of each
// source]: the guards of its contacts and what happens there, and the powers that make up its
// energies. All of it belongs to the modes of the contacts; none depends on the excitation.
#pragma once

#include "motion/interval/guard_forms.h"

#include <vector>

namespace vibroimpact::motion {

/// What happens at a guard.
struct PhaseGuard {
  std::size_t contact = 0;
  std::size_t guard = 0;
  int target = 0; ///< mode of the contact's law
};

class PhaseForms {
public:
  /// A new internal state when a guard is passed.
  struct Reset {
    Index entry = 0; ///< in y
    LinearRow form;
  };

  /// For the present modes of the equations, which must be linear in them.
  explicit PhaseForms(const Equations &equations);

  const std::vector<int> &contact_modes() const { return contact_modes_; }
  const std::vector<PhaseGuard> &guards() const { return guards_; }
  const GuardForms &guard_forms() const { return guard_forms_; }
  const std::vector<Reset> &resets(std::size_t guard) const { return resets_[guard]; }

private:
  void add_guards(const Equations &equations, std::size_t contact);

  std::vector<int> contact_modes_;
  std::vector<PhaseGuard> guards_;
  GuardForms guard_forms_;
  std::vector<std::vector<Reset>> resets_;
};

/// The powers of a linear phase as products of linear forms: each the rate of an entry of the
/// work integrals.
class PowerForms {
public:
  /// For the present modes of the equations, which must be linear in them. std::logic_error when a
  /// law dissipates in another way than by a quadratic form of its local state.
  explicit PowerForms(const Equations &equations);

  std::size_t size() const { return entries_.size(); }
  /// Entry of the state whose rate the k-th product is a part of.
  Index entry(std::size_t k) const { return entries_[k]; }
  /// Rows 2 k and 2 k + 1 are the two factors of the k-th product.
  const Matrix &rows() const { return rows_; }
  const Vector &constants() const { return constants_; }

private:
  void add(Index entry, const LinearRow &a, const LinearRow &b);
  void add_loads(const Equations &equations);
  void add_damping(const Equations &equations);
  void add_circulatory(const Equations &equations);
  void add_contact(const Equations &equations, std::size_t contact);
  void add_friction(const Equations &equations, std::size_t contact);
  void add_dissipation(const Equations &equations, std::size_t contact, Index entry,
                       double contact::LawResponse::*power);

  std::vector<Index> entries_;
  Matrix rows_;
  Vector constants_;
};

} // namespace vibroimpact::motion

// A linear phase of a motion under its excitation, ready for the kernel.
//
// Real coordinates x: those of the modes of the system (ModalForm), then those of the inputs. With
// r the rows [y, then s, s', s'' of each source], r = columns x. The modes go on without the
// inputs: the response to these is in the columns of their own coordinates, A Y + B = Y S. Where an
// input is in resonance with a block of modes, so that Y would not exist or lose its digits, the
// two stay one dense block, x' = [D C; 0 S] x.
#pragma once

#include "motion/interval/guard_forms.h"
#include "motion/kernel/aligned.h"
#include "motion/kernel/kernel.h"
#include "motion/phase/exact_groups.h"

#include <array>
#include <memory>
#include <vector>

namespace vibroimpact::motion {

/// Amplitudes of the groups of a phase: real parts, then imaginary parts, both padded.
using Amplitudes = AlignedArray;

struct TabulatedExponential;

/// What the motion so far has taught about lengths of pieces; it outlives the phase.
struct TaughtLengths {
  TaughtLengths() { hints.fill(-1); }

  std::array<signed char, n_hints> hints{}; ///< lengths of the first pieces
  /// Of the excitation that they are for, and whether an input is coupled with modes.
  long generation = -1, structure = -1;
  bool coupled = false;
};

class ExactPhase {
public:
  /// y' = matrix y + constant + sum over sources (value s + rate s' + acceleration s''). h0: length
  /// of the longest pieces [s], the same for all phases that exchange amplitudes.
  ExactPhase(const Matrix &matrix, const Vector &constant,
             const std::vector<LinearSystem::Load> &loads, const GuardForms &guards, double h0,
             std::shared_ptr<TaughtLengths> taught = std::make_shared<TaughtLengths>());
  ExactPhase(const ExactPhase &) = delete;
  ExactPhase &operator=(const ExactPhase &) = delete;

  /// Renews what belongs to the inputs when they are others than the last time.
  void take(const Excitation &excitation);
  /// Counts the arrangements of the groups; amplitudes of another one mean nothing.
  long arrangement() const { return arrangement_; }
  Index n_modes() const { return modal_.basis().cols(); }
  Index n_coordinates() const { return columns_.cols(); }
  /// r = columns x: (size of y + 3 sources) x coordinates.
  const Matrix &columns() const { return columns_; }
  const ModalForm &modal() const { return modal_; }
  /// Where a coordinate stands in the amplitudes.
  const std::vector<int> &places() const { return places_; }
  std::size_t n_amplitudes() const { return 2 * static_cast<std::size_t>(view_.n_padded); }
  const PhaseView &view() const { return view_; }

  const std::vector<PhaseGroup> &groups() const { return groups_; }
  /// Of the excitation whose inputs it has; groups of the same generation are those that were
  /// renewed for it.
  long generation() const { return generation_; }
  bool has_dense() const { return view_.n_dense > 0; }
  std::size_t bytes() const;

  /// y to amplitudes, whose inputs have the coordinates given; each is rounded once.
  void amplitudes(const Vector &y, const double *inputs, Amplitudes &amplitudes) const;
  /// y of amplitudes: n_modes() entries.
  void state(const double *amplitudes, double *y) const;

private:
  struct Level {
    double length = 0;    ///< [s]
    long generation = -1; ///< that it was last renewed for
    AlignedArray turn, growth, table, bounds;
    std::vector<double> dense, dense_growth;

    std::size_t bytes() const;
  };

  void set_squares(const GuardForms &guards);
  void set_loads(const Vector &constant, const std::vector<LinearSystem::Load> &loads);
  void arrange(const Excitation &excitation);
  void renew(const Excitation &excitation);
  void forget_levels();

  const LinearSystem::Load &loads_of(const Input &input) const;
  bool is_driven(const ModalBlock &block, const Input &input) const;
  bool respond(const Excitation &excitation, bool may_couple);
  bool respond(std::size_t block, const Input &input, Index first, bool may_couple);
  void respond_to_exponential(const ModalBlock &block, const Input &input, Index first);
  void respond_to_polynomial(const ModalBlock &block, const Input &input, Index first);
  void add_response(const ModalBlock &block, const Complex *response, Index first, bool pair);
  void couple(const ModalBlock &block, const Input &input, Index first);
  void add_source_rows(const Input &input, Index first);

  void place_groups();
  void allocate();
  void place_dense();
  void show();
  void set_group(PhaseGroup &group);
  void set_pair(const PhaseGroup &group);
  void set_pair_rows(std::size_t guard, const PhaseGroup &group);
  Complex seen_by_guard(std::size_t guard, const PhaseGroup &group, double &size) const;
  void set_dense(const PhaseGroup &group);
  void set_norms();
  void set_weights();
  void make_level(int index);
  Level &allocate_level(int index);
  void show_level(int index);
  void set_level_pair(Level &level, const PhaseGroup &group);
  void set_level_rows(Level &level, std::size_t guard, const PhaseGroup &group,
                      const TabulatedExponential &table);
  void set_level_dense(Level &level, const PhaseGroup &group);
  void set_dense_rows(Level &level, std::size_t guard, const PhaseGroup &group,
                      const std::array<Matrix, 8> &data);

  ModalForm modal_;
  double h0_, radius_ = 0;
  std::shared_ptr<TaughtLengths> taught_;
  /// W^-1 times the loads of the sources, and behind these times the constant
  std::vector<LinearSystem::Load> modal_loads_;
  std::vector<std::array<double, 3>> load_sizes_; ///< their largest entries
  std::vector<std::vector<Complex>> eigenvalues_; ///< of the blocks
  Matrix guard_rows_;
  Vector guard_constants_;
  std::vector<SquaresView> squares_; ///< of each guard; empty: none is a sum of squares
  Index n_rows_ = 0;

  std::vector<Input> inputs_;
  long generation_ = -1, arrangement_ = 0;
  std::vector<Coupling> couplings_;
  Matrix couples_; ///< modes x input coordinates, of the couplings
  Matrix columns_;
  std::vector<PhaseGroup> groups_;
  std::vector<int> places_;

  PhaseView view_;
  AlignedArray rate_, frequency_, rows_, sizes_, slopes_, second_, third_, eighth_, magnitudes_,
      weights_;
  std::vector<double> constants_, constant_sizes_, norms_;
  double fastest_dense_ = 0;
  std::vector<DenseBlockView> dense_;
  std::vector<std::vector<double>> generators_;
  std::vector<std::unique_ptr<Level>> levels_;
  std::size_t level_bytes_ = 0; ///< of all
  std::vector<LevelView> level_views_;
};

} // namespace vibroimpact::motion

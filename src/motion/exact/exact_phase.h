// A linear phase of a motion under its excitation, ready for the kernel.
//
// Real coordinates x: those of the modes of the system (ModalForm), then those of the inputs. With
// r the rows [y, then s, s', s'' of each source], r = columns x. The modes go on without the
// inputs: the response to these is in the columns of their own coordinates, A Y + B = Y S. Where an
// input is in resonance with a block of modes, so that Y would not exist or lose its digits, the
// two stay one dense block, x' = [D C; 0 S] x.
#pragma once

#include "motion/exact/aligned.h"
#include "motion/exact/excitation.h"
#include "motion/exact/kernel.h"
#include "motion/segment/guard_forms.h"

#include "motion/exact/interpolation.h"

#include <array>
#include <memory>
#include <vector>

namespace vibroimpact::motion {

/// Amplitudes of the groups of a phase: real parts, then imaginary parts, both padded.
using Amplitudes = AlignedArray;

class ExactPhase {
public:
  /// y' = matrix y + constant + sum over sources (value s + rate s' + acceleration s''). h0: length
  /// of the longest pieces [s], the same for all phases that exchange amplitudes.
  ExactPhase(const Matrix &matrix, const Vector &constant,
             const std::vector<LinearSystem::Load> &loads, const GuardForms &guards, double h0);
  ExactPhase(const ExactPhase &) = delete;
  ExactPhase &operator=(const ExactPhase &) = delete;

  /// Renews what belongs to the inputs when they are others than the last time.
  void take(const Excitation &excitation);
  /// Forgets what earlier motions taught about lengths of pieces.
  void forget();

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

  /// One group of equal exponent, or the columns of a dense block.
  struct Group {
    BlockKind kind = BlockKind::real;
    Complex exponent{};
    std::vector<Index> coordinates; ///< real and imaginary part of a pair
    Matrix generator;               ///< of a dense block
    int first = 0;                  ///< place among the groups
    bool is_input = false;          ///< an input alone
  };
  const std::vector<Group> &groups() const { return groups_; }
  bool has_dense() const { return view_.n_dense > 0; }

  /// y to amplitudes, whose inputs have the coordinates given; each is rounded once.
  void amplitudes(const Vector &y, const double *inputs, Amplitudes &amplitudes) const;
  /// The rows of amplitudes.
  void rows(const double *amplitudes, Vector &rows) const;

private:
  struct Level {
    AlignedArray turn, growth, table, bounds;
    std::vector<double> dense, dense_growth;
  };

  void arrange(const Excitation &excitation);
  void renew(const Excitation &excitation);
  bool respond(const Excitation &excitation, bool couple);
  bool respond(const ModalBlock &block, const Input &input, Index first, bool couple);
  void add_source_rows(const Input &input, Index first);
  void place_groups();
  void allocate();
  void set_group(const Group &group);
  void set_pair(const Group &group);
  void set_dense(const Group &group);
  void set_weights();
  void make_level(int level);
  void set_level(Level &level, double h, const Group &group);
  void set_level_pair(Level &level, double h, const Group &group);
  void set_level_dense(Level &level, double h, const Group &group);

  ModalForm modal_;
  double h0_, radius_ = 0;
  std::vector<LinearSystem::Load> modal_loads_; ///< W^-1 times the loads
  Vector modal_constant_;
  Matrix guard_rows_;
  Vector guard_constants_;
  Index n_rows_ = 0;

  std::vector<Input> inputs_;
  long generation_ = -1, structure_ = -1, arrangement_ = 0;
  bool coupled_ = false;
  std::vector<std::array<Index, 2>> couplings_; ///< block of modes, input
  Matrix couples_;                              ///< modes x input coordinates, of the couplings
  Matrix columns_;
  std::vector<Group> groups_;
  std::vector<int> places_;

  PhaseView view_;
  AlignedArray rate_, frequency_, rows_, sizes_, second_, third_, eighth_, magnitudes_, weights_;
  std::vector<double> constants_, constant_sizes_;
  std::vector<DenseBlockView> dense_;
  std::vector<std::vector<double>> generators_;
  std::vector<std::unique_ptr<Level>> levels_;
  std::vector<LevelView> level_views_;
  std::array<signed char, n_hints> hints_{};
};

} // namespace vibroimpact::motion

#include "motion/energy/work_quadrature.h"
#include "motion/exact/exponential_sums.h"
#include "motion/exact/linear_phase.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

using model::ExponentialForm;

namespace {

class ModalMotion : public LinearMotion {
public:
  ModalMotion(const LinearSystem &system, Index n_coordinates, const DenseTolerance &tolerance);

  bool begin(const Vector &y, std::span<const ExponentialForm> sources) override;
  double natural_step() override;
  void derivatives(double tau, Matrix &rows) override;
  void initial_derivatives(Matrix &rows) override;
  void values(std::span<const double> instants, Matrix &rows) override;
  double quadrature_length(double start, double rest) const override;
  void move(double tau) override;
  void watch(const GuardForms &forms) override;
  const GuardCurves &guards(double end) override;

private:
  // Re(amplitude exp(exponent t)) times one column of the basis for the real part of the rest and
  // one for its imaginary part, or a single column where everything is real.
  struct Group {
    Complex exponent;
    Index column = 0;
    bool is_pair = false;
    Complex amplitude{};
    double size10 = 0, size8 = 0; // |exponent|^10, |exponent|^8
  };
  // A part of the excitation: an exponential or the constant of a source, or that of the system.
  struct Input {
    std::size_t source = 0;
    Complex exponent{}; // imaginary part >= 0
    bool own = false;   // of the system
    bool operator==(const Input &other) const = default;
  };

  bool read_inputs(std::span<const ExponentialForm> sources);
  bool respond();
  void add_group(Complex exponent, bool is_pair, Index column);
  bool respond(const Input &input, Index place);
  void multiply(Matrix &rows) const;
  void measure_groups();
  void measure_speeds();
  void monitor_groups();
  void start_guards();
  void note_sizes();
  Complex factor(const Group &group, double tau) const;
  static void store(const Group &group, Complex value, Matrix &amplitudes, Index column);

  const LinearSystem &system_;
  Index n_;
  const DenseTolerance &tolerance_;
  std::vector<Group> groups_; // of the modes, then of the inputs
  std::vector<Input> inputs_, responded_;
  std::vector<Complex> input_amplitudes_;
  bool measured_ = false;
  Matrix columns_;    // rows x columns of all groups
  Matrix magnitudes_; // n + internal states + sources by groups
  Vector speeds_;     // of a unit amplitude of each group: square root of twice the kinetic energy
  Vector sizes14_;    // |exponent|^14
  double speed_of_phase_ = 0; // that all groups together can have
  Vector inverse_tolerance_, weights10_, weights8_, bound_;
  Vector initial_, modal_, rest_;
  Matrix amplitudes_;
  GuardForms observed_;
  ExponentialSums guards_;
  std::vector<Complex> group_amplitudes_;
  std::vector<Complex> factors_;
  double factors_at_ = -1; // the tau that factors_ are for
};

ModalMotion::ModalMotion(const LinearSystem &system, Index n_coordinates,
                         const DenseTolerance &tolerance)
    : system_(system), n_(n_coordinates), tolerance_(tolerance) {
  const auto n_sources = static_cast<Index>(system.loads().size());
  columns_ = Matrix::Zero(system.size() + 3 * n_sources, system.basis().cols());
  columns_.topRows(system.size()) = system.basis();
  for (const LinearSystem::Mode &mode : system.modes())
    add_group(mode.eigenvalue, mode.is_pair, mode.column);
}

bool ModalMotion::read_inputs(std::span<const ExponentialForm> sources) {
  inputs_.clear();
  input_amplitudes_.clear();
  const auto add = [&](const Input &input, Complex amplitude) {
    inputs_.push_back(input);
    input_amplitudes_.push_back(amplitude);
  };
  if (!system_.constant().isZero(0))
    add({.own = true}, 1);
  for (std::size_t k = 0; k < sources.size(); ++k) {
    if (sources[k].polynomial.size() > 1)
      return false;
    if (!sources[k].polynomial.empty() && sources[k].polynomial[0] != 0)
      add({.source = k}, sources[k].polynomial[0]);
    for (const ExponentialForm::Term &term : sources[k].terms) {
      const bool upper = term.exponent.imag() >= 0;
      add({.source = k, .exponent = upper ? term.exponent : std::conj(term.exponent)},
          upper ? term.amplitude : std::conj(term.amplitude));
    }
  }
  return true;
}

void ModalMotion::add_group(Complex exponent, bool is_pair, Index column) {
  const double size = std::norm(exponent);
  const double size8 = size * size * size * size;
  groups_.push_back({.exponent = exponent,
                     .column = column,
                     .is_pair = is_pair,
                     .size10 = size8 * size,
                     .size8 = size8});
}

// Into the columns from `place` on.
bool ModalMotion::respond(const Input &input, Index place) {
  const Index size = system_.size();
  const Complex e = input.exponent;
  ComplexVector load = system_.constant().cast<Complex>();
  if (!input.own) {
    const LinearSystem::Load &source = system_.loads()[input.source];
    load = source.value.cast<Complex>() + e * source.rate.cast<Complex>() +
           e * e * source.acceleration.cast<Complex>();
  }
  ComplexVector solution;
  if (!system_.response(e, load, solution))
    return false;
  ComplexVector column = ComplexVector::Zero(columns_.rows());
  column.head(size) = solution;
  if (!input.own) {
    const Index row = size + 3 * static_cast<Index>(input.source);
    column[row] = 1;
    column[row + 1] = e;
    column[row + 2] = e * e;
  }
  add_group(e, e.imag() != 0, place);
  columns_.col(place) = column.real();
  if (groups_.back().is_pair)
    columns_.col(place + 1) = -column.imag();
  return true;
}

// The columns depend on the exponents only: they stay while the excitation keeps its frequencies.
bool ModalMotion::respond() {
  const Index modes = system_.basis().cols();
  Index count = modes;
  for (const Input &input : inputs_)
    count += input.exponent.imag() != 0 ? 2 : 1;
  columns_.conservativeResize(Eigen::NoChange, count);
  groups_.resize(system_.modes().size());
  responded_.clear();
  measured_ = false;
  Index place = modes;
  for (const Input &input : inputs_) {
    if (!respond(input, place))
      return false;
    responded_.push_back(input);
    place += groups_.back().is_pair ? 2 : 1;
  }
  return true;
}

// What steps need besides the columns.
void ModalMotion::measure_groups() {
  measured_ = true;
  const Index size = system_.size();
  const Index n_internal = size - 2 * n_;
  const auto n_sources = static_cast<Index>(system_.loads().size());
  magnitudes_.resize(n_ + n_internal + n_sources, static_cast<Index>(groups_.size()));
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    Vector size_of_row = columns_.col(groups_[g].column).cwiseAbs2();
    if (groups_[g].is_pair)
      size_of_row += columns_.col(groups_[g].column + 1).cwiseAbs2();
    size_of_row = size_of_row.cwiseSqrt();
    auto column = magnitudes_.col(static_cast<Index>(g));
    column.head(n_) = size_of_row.head(n_);
    for (Index k = 0; k < n_sources; ++k)
      column[n_ + k] = size_of_row[size + 3 * k];
    column.tail(n_internal) = size_of_row.segment(2 * n_, n_internal);
  }
  weights10_.resize(magnitudes_.cols());
  weights8_.resize(magnitudes_.cols());
  measure_speeds();
}

void ModalMotion::measure_speeds() {
  const auto velocities = columns_.middleRows(n_, n_);
  speeds_.resize(magnitudes_.cols());
  sizes14_.resize(magnitudes_.cols());
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const Group &group = groups_[g];
    double energy = velocities.col(group.column).cwiseAbs2().dot(system_.mass());
    if (group.is_pair)
      energy += velocities.col(group.column + 1).cwiseAbs2().dot(system_.mass());
    speeds_[static_cast<Index>(g)] = std::sqrt(energy);
    sizes14_[static_cast<Index>(g)] = std::pow(std::abs(group.exponent), 14);
  }
}

bool ModalMotion::begin(const Vector &y, std::span<const ExponentialForm> sources) {
  if (!read_inputs(sources))
    return false;
  if (inputs_ != responded_ && !respond())
    return false;
  if (!measured_) {
    measure_groups();
    monitor_groups();
  }
  factors_at_ = -1;
  const std::size_t n_modes = system_.modes().size();
  initial_ = y;
  rest_ = y;
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    Group &group = groups_[n_modes + i];
    group.amplitude = input_amplitudes_[i];
    rest_ -= group.amplitude.real() * columns_.col(group.column).head(y.size());
    if (group.is_pair)
      rest_ -= group.amplitude.imag() * columns_.col(group.column + 1).head(y.size());
  }
  modal_.noalias() = system_.inverse() * rest_;
  for (std::size_t g = 0; g < n_modes; ++g) {
    const Index column = groups_[g].column;
    groups_[g].amplitude = {modal_[column], groups_[g].is_pair ? modal_[column + 1] : 0.0};
  }
  note_sizes();
  return true;
}

// The size of each row in this phase, and with it the error allowed.
void ModalMotion::note_sizes() {
  for (std::size_t g = 0; g < groups_.size(); ++g)
    weights10_[static_cast<Index>(g)] = std::abs(groups_[g].amplitude);
  speed_of_phase_ = speeds_.dot(weights10_);
  inverse_tolerance_.noalias() = magnitudes_ * weights10_;
  inverse_tolerance_ *= tolerance_.relative;
  const Index n_internal = system_.size() - 2 * n_;
  inverse_tolerance_.head(n_) += tolerance_.absolute.head(n_);
  inverse_tolerance_.tail(n_internal) += tolerance_.absolute.segment(2 * n_, n_internal);
  inverse_tolerance_ =
      (inverse_tolerance_.array() > 0).select(inverse_tolerance_.cwiseInverse(), 0);
}

double ModalMotion::natural_step() {
  double growth = 0;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const Group &group = groups_[g];
    const double amplitude = std::abs(group.amplitude);
    weights10_[static_cast<Index>(g)] = amplitude * group.size10;
    weights8_[static_cast<Index>(g)] = amplitude * group.size8;
    growth = std::max(growth, group.exponent.real());
  }
  const Index n_internal = system_.size() - 2 * n_;
  const Index n_smooth = magnitudes_.rows() - n_internal;
  bound_.noalias() = magnitudes_.topRows(n_smooth) * weights10_;
  const double tenth = bound_.cwiseProduct(inverse_tolerance_.head(n_smooth)).maxCoeff();
  double eighth = 0;
  if (n_internal > 0) {
    bound_.noalias() = magnitudes_.bottomRows(n_internal) * weights8_;
    eighth = bound_.cwiseProduct(inverse_tolerance_.tail(n_internal)).maxCoeff();
  }
  const double step = dense_step(tenth, eighth);
  return growth > 0 ? std::min(step, 1 / growth) : step;
}

Complex ModalMotion::factor(const Group &group, double tau) const {
  if (group.is_pair)
    return std::polar(std::exp(group.exponent.real() * tau), group.exponent.imag() * tau);
  return group.exponent == 0.0 ? 1.0 : std::exp(group.exponent.real() * tau);
}

void ModalMotion::store(const Group &group, Complex value, Matrix &amplitudes, Index column) {
  amplitudes(group.column, column) = value.real();
  if (group.is_pair)
    amplitudes(group.column + 1, column) = value.imag();
}

// The general product packs its arguments first, which costs more than a small product itself.
void ModalMotion::multiply(Matrix &rows) const {
  constexpr Index small = 16;
  if (columns_.cols() >= small) {
    rows.noalias() = columns_ * amplitudes_;
    return;
  }
  const Index count = columns_.rows();
  rows.resize(count, amplitudes_.cols());
  for (Index j = 0; j < rows.cols(); ++j) {
    double *sum = &rows(0, j);
    std::fill(sum, sum + count, 0.0);
    for (Index k = 0; k < columns_.cols(); ++k) {
      const double amplitude = amplitudes_(k, j);
      const double *column = &columns_(0, k);
      for (Index i = 0; i < count; ++i)
        sum[i] += amplitude * column[i];
    }
  }
}

void ModalMotion::derivatives(double tau, Matrix &rows) {
  amplitudes_.resize(columns_.cols(), dense_derivatives + 1);
  factors_.resize(groups_.size());
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const Group &group = groups_[g];
    factors_[g] = factor(group, tau);
    Complex value = group.amplitude * factors_[g];
    for (Index m = 0; m <= dense_derivatives; ++m) {
      store(group, value, amplitudes_, m);
      value *= group.exponent;
    }
  }
  factors_at_ = tau;
  multiply(rows);
}

void ModalMotion::initial_derivatives(Matrix &rows) {
  derivatives(0, rows);
  rows.col(0).head(initial_.size()) = initial_;
  system_.differentiate(rows);
}

void ModalMotion::values(std::span<const double> instants, Matrix &rows) {
  amplitudes_.resize(columns_.cols(), static_cast<Index>(instants.size()));
  for (const Group &group : groups_)
    for (std::size_t i = 0; i < instants.size(); ++i)
      store(group, group.amplitude * factor(group, instants[i]), amplitudes_,
            static_cast<Index>(i));
  multiply(rows);
}

// Of the speeds, and of each internal state, that part counts which is fast: its size relative to
// that of the whole in this phase, times the error of the rule for twice its exponent.
double ModalMotion::quadrature_length(double start, double rest) const {
  constexpr double error = 1e-13;
  const Index n_internal = system_.size() - 2 * n_;
  double fast = 0;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const Group &group = groups_[g];
    const auto k = static_cast<Index>(g);
    double strength = std::abs(group.amplitude);
    if (start > 0)
      strength *= std::exp(group.exponent.real() * start);
    double share = speed_of_phase_ > 0 ? strength * speeds_[k] / speed_of_phase_ : 0;
    for (Index i = magnitudes_.rows() - n_internal; i < magnitudes_.rows(); ++i)
      share = std::max(share,
                       strength * magnitudes_(i, k) * tolerance_.relative * inverse_tolerance_[i]);
    fast = std::max(fast, share * sizes14_[k]);
  }
  fast *= WorkQuadrature::error_factor / error;
  const double span2 = 4 * rest * rest;
  const double span14 = span2 * span2 * span2 * span2 * span2 * span2 * span2;
  return fast * span14 <= 1 ? rest : std::min(rest, 0.5 * std::pow(fast, -1.0 / 14));
}

void ModalMotion::watch(const GuardForms &forms) {
  observed_ = forms;
  measured_ = false;
}

// A row sees c Re(a) + d Im(a) = Re((c - i d) a) of a group.
void ModalMotion::monitor_groups() {
  if (observed_.rows.cols() != columns_.rows())
    return;
  const Matrix seen = observed_.rows * columns_;
  Eigen::MatrixXcd coefficients(seen.rows(), static_cast<Index>(groups_.size()));
  const Matrix summed = observed_.rows.cwiseAbs() * columns_.cwiseAbs();
  Matrix sizes(seen.rows(), coefficients.cols());
  std::vector<Complex> exponents;
  for (const Group &group : groups_) {
    const auto place = static_cast<Index>(exponents.size());
    sizes.col(place) = summed.col(group.column);
    if (group.is_pair)
      sizes.col(place) = sizes.col(place).cwiseMax(summed.col(group.column + 1)) * std::sqrt(2.0);
    auto column = coefficients.col(place);
    column.real() = seen.col(group.column);
    column.imag().setZero();
    if (group.is_pair)
      column.imag() = -seen.col(group.column + 1);
    exponents.push_back(group.exponent);
  }
  guards_.set(coefficients, sizes, observed_.constants, std::move(exponents));
}

void ModalMotion::start_guards() {
  group_amplitudes_.clear();
  for (const Group &group : groups_)
    group_amplitudes_.push_back(group.amplitude);
  guards_.start(group_amplitudes_);
}

const GuardCurves &ModalMotion::guards(double end) {
  start_guards();
  if (end != factors_at_) {
    factors_.clear();
    for (const Group &group : groups_)
      factors_.push_back(factor(group, end));
    factors_at_ = end;
  }
  guards_.end_at(end, factors_);
  return guards_;
}

void ModalMotion::move(double tau) {
  for (std::size_t g = 0; g < groups_.size(); ++g)
    groups_[g].amplitude *= tau == factors_at_ ? factors_[g] : factor(groups_[g], tau);
  factors_at_ = -1;
}

} // namespace

std::unique_ptr<LinearMotion> make_modal_motion(const LinearSystem &system, Index n_coordinates,
                                                const DenseTolerance &tolerance) {
  return std::make_unique<ModalMotion>(system, n_coordinates, tolerance);
}

} // namespace vibroimpact::motion

#include "motion/path/exact_stepper.h"

#include "common/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace vibroimpact::motion {

// The guards of the phase during a step. The k-th derivative of a group is bounded by the size of
// its amplitude and the growth since then; of a dense block by |c B^k| exp(|B| (b - a)) |x(a)|
// between a and b: from the start of the step on, the bound of a fast block would soon grow beyond
// any use. The sixth derivative of a square is the sum of C(6, k) f^(k) f^(6 - k).
class ExactStepper::Guards : public GuardCurves {
public:
  void start(const LinearPhase &known, ExactPhase &phase, const Amplitudes &amplitudes) {
    forms_ = &known.forms().guard_forms();
    products_ = forms_->products.value();
    phase_ = &phase;
    amplitudes_ = &amplitudes;
    turned_.resize(amplitudes.size());
    seen_.assign(static_cast<std::size_t>(forms_->rows.rows()), {});
  }

  Index size() const override { return forms_->constants.size(); }

  Jet at(Index guard, double time) const override {
    const double *const amplitudes = amplitudes_at(time);
    const GuardProduct *const product = product_of(guard);
    if (!product)
      return jet(guard, amplitudes);
    Jet sum;
    for (const auto &[factor, sign] : squares(*product)) {
      const Jet f = jet(factor, amplitudes);
      sum.value += sign * f.value * f.value;
      sum.rate += 2 * sign * f.value * f.rate;
      sum.acceleration += 2 * sign * (f.rate * f.rate + f.value * f.acceleration);
    }
    return sum;
  }

  double sixth_derivative(Index guard, double from, double to) const override {
    const GuardProduct *const product = product_of(guard);
    if (!product)
      return derivatives(guard, from, to)[6];
    constexpr double binomials[] = {1, 6, 15, 20, 15, 6, 1};
    double bound = 0;
    for (const auto &[factor, sign] : squares(*product)) {
      const Derivatives f = derivatives(factor, from, to);
      for (std::size_t k = 0; k < f.size(); ++k)
        bound += std::abs(sign) * binomials[k] * f[k] * f[f.size() - 1 - k];
    }
    return bound;
  }

  double rounding(Index guard) const override {
    const GuardProduct *const product = product_of(guard);
    if (!product)
      return rounding_of_form(guard);
    // Of f^2 by that of f; where the sum is not below zero, the first form is the largest of them.
    const double largest = rounding_of_form(product->factors) / guard_rounding;
    double sum = 0;
    for (const auto &[factor, sign] : squares(*product)) {
      const double error = rounding_of_form(factor);
      sum += std::abs(sign) * error * (2 * largest + error);
    }
    return sum;
  }

private:
  const GuardProduct *product_of(Index guard) const {
    const auto found =
        std::find_if(products_.begin(), products_.end(),
                     [guard](const GuardProduct &product) { return product.guard == guard; });
    return found == products_.end() ? nullptr : &*found;
  }

  // The forms whose squares make the product, and the factor of each.
  static std::array<std::pair<Index, double>, 3> squares(const GuardProduct &product) {
    return {{{product.factors, product.scale},
             {product.factors + 1, -product.scale},
             {product.factors + 2, -product.scale}}};
  }

  Jet jet(Index form, const double *amplitudes) const {
    double f[4];
    kernel().derivatives(phase_->view(), static_cast<int>(form), amplitudes, f);
    return {.value = f[0], .rate = f[1], .acceleration = f[2]};
  }

  /// Bounds of the orders 0 to 6.
  using Derivatives = std::array<double, 7>;

  // Between two instants.
  Derivatives derivatives(Index form, double from, double to) const {
    Derivatives bounds{};
    bounds[0] = phase_->view().constant_sizes[form];
    const std::vector<RowVector> &rows = seen(form);
    for (std::size_t g = 0; g < rows.size(); ++g) {
      const PhaseGroup &group = phase_->groups()[g];
      if (group.kind == BlockKind::dense)
        add_dense(rows[g], group, from, to, bounds);
      else
        add_group(rows[g].norm(), group, from, to, bounds);
    }
    return bounds;
  }

  double rounding_of_form(Index guard) const {
    const PhaseView &view = phase_->view();
    const auto n = static_cast<std::size_t>(view.n_padded);
    const auto g = static_cast<std::size_t>(guard);
    double sum = view.constant_sizes[g];
    for (std::size_t j = 0; j < n; ++j)
      sum += view.sizes[g * n + j] * std::hypot((*amplitudes_)[j], (*amplitudes_)[n + j]);
    return guard_rounding * sum;
  }

  // The amplitudes some time after the start of the step.
  const double *amplitudes_at(double time) const {
    if (time == 0)
      return amplitudes_->data();
    kernel().turn(phase_->view(), amplitudes_->data(), time, turned_.data());
    return turned_.data();
  }

  // What a form sees of each group.
  const std::vector<RowVector> &seen(Index form) const {
    std::vector<RowVector> &rows = seen_[static_cast<std::size_t>(form)];
    for (std::size_t g = rows.size(); g < phase_->groups().size(); ++g) {
      const std::vector<Index> &coordinates = phase_->groups()[g].coordinates;
      rows.emplace_back(static_cast<Index>(coordinates.size()));
      for (std::size_t c = 0; c < coordinates.size(); ++c)
        rows[g][static_cast<Index>(c)] =
            forms_->rows.row(form).dot(phase_->columns().col(coordinates[c]));
    }
    return rows;
  }

  void add_group(double seen, const PhaseGroup &group, double from, double to,
                 Derivatives &bounds) const {
    const auto j = static_cast<std::size_t>(group.first);
    const double size = std::hypot((*amplitudes_)[j], (*amplitudes_)[j + amplitudes_->size() / 2]);
    const double rate = group.exponent.real(), speed = std::abs(group.exponent);
    double bound = seen * size * std::exp(rate * (rate > 0 ? to : from));
    for (double &sum : bounds) {
      sum += bound;
      bound *= speed;
    }
  }

  void add_dense(RowVector row, const PhaseGroup &group, double from, double to,
                 Derivatives &bounds) const {
    const double *amplitudes = amplitudes_at(from);
    double largest = 0;
    for (Index c = 0; c < row.size(); ++c)
      largest = std::max(largest, std::abs(amplitudes[static_cast<std::size_t>(group.first + c)]));
    const double growth = group.generator.cwiseAbs().rowwise().sum().maxCoeff();
    constexpr double beyond_any_use = 200;
    largest *= std::exp(std::min(growth * (to - from), beyond_any_use));
    for (double &sum : bounds) {
      sum += row.cwiseAbs().sum() * largest;
      row = (row * group.generator).eval();
    }
  }

  std::vector<GuardProduct> products_;
  const GuardForms *forms_ = nullptr;
  const ExactPhase *phase_ = nullptr;
  const Amplitudes *amplitudes_ = nullptr;
  mutable Amplitudes turned_;
  mutable std::vector<std::vector<RowVector>> seen_; ///< by forms and groups, where asked for
};

ExactStepper::ExactStepper(const Equations &equations, const Settings &settings)
    : equations_(equations), phases_(equations, settings), guards_(std::make_unique<Guards>()) {}

ExactStepper::~ExactStepper() = default;

bool ExactStepper::handles(double time) {
  const LinearPhase *const phase = phases_.find();
  return phase && phase->forms().guard_forms().products && phases_.take_sources(time);
}

void ExactStepper::restart(double time, const Vector &x) {
  place(time, x);
  start_.time = time;
  start_.state = x;
  phase_.reset();
}

// What is zero at the start comes out as zero from the state and the equations, not from a sum of
// amplitudes.
void ExactStepper::begin() {
  phase_ = phases_.present()->shared_from_this();
  phases_.enter(*phase_);
  const Index size = equations_.layout().physical_size();
  const Vector y = end_.state.head(size);
  Vector inputs(phases_.excitation().size());
  phases_.excitation().coordinates(end_.time, inputs.data());
  phase_->phase().amplitudes(y, inputs.data(), from_);
  to_.resize(from_.size());
  phase_->segment(equations_).fill(end_.time, from_.data(), end_);
  Matrix rows(size + 3 * static_cast<Index>(end_.sources.size()), 4);
  rows.col(0).head(size) = y;
  for (std::size_t k = 0; k < end_.sources.size(); ++k)
    for (Index order = 0; order < 3; ++order)
      for (Index of = 0; of < 3; ++of)
        rows(size + 3 * static_cast<Index>(k) + of, order) =
            end_.sources[k][static_cast<std::size_t>(order + of)];
  phase_->system().differentiate(rows);
  phase_->segment(equations_).begin(from_.data(), true);
  end_.state.head(size) = y;
  end_.rates.head(size) = rows.col(1).head(size);
  end_.higher = rows.block(0, 2, size, 2);
}

void ExactStepper::take(double end) {
  kernel().turn(phase_->phase().view(), from_.data(), end - start_.time, to_.data());
  end_.state = start_.state;
  phase_->segment(equations_).fill(end, to_.data(), end_);
  if (!end_.state.allFinite())
    throw NumericalError("the state is no longer finite at t = " + std::to_string(end) + " s");
  pending_ = true;
}

void ExactStepper::step(double limit) {
  if (!phase_)
    begin();
  std::swap(start_, end_);
  const double wanted = phase_->segment(equations_).step(from_.data());
  const double rest = limit - start_.time;
  if (!(start_.time + wanted > start_.time))
    throw NumericalError(
        "the motion is too large for any step, at t = " + std::to_string(start_.time) + " s");
  // Two halves rather than a step and a sliver.
  if (rest <= wanted * (1 + 1e-9))
    take(limit);
  else
    take(start_.time + (rest < 2 * wanted ? 0.5 * rest : wanted));
}

const GuardCurves *ExactStepper::guard_curves() {
  guards_->start(*phase_, phase_->phase(), from_);
  return guards_.get();
}

void ExactStepper::undo() {
  end_ = start_;
  pending_ = false;
}

void ExactStepper::accept(bool keep_work) {
  if (!pending_)
    return;
  pending_ = false;
  if (keep_work)
    phase_->work(equations_).add(from_.data(), to_.data(), end_.time - start_.time, end_.state);
  from_.swap(to_);
}

void ExactStepper::place(double time, const Vector &x) {
  end_.time = time;
  end_.state = x;
  pending_ = false;
}

} // namespace vibroimpact::motion

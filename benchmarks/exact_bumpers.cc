#include "exact_bumpers.h"

#include <complex>
#include <limits>

namespace vibroimpact::benchmarks {

namespace {

using Complex = std::complex<double>;

// Value and three derivatives.
struct Jet {
  double value = 0, rate = 0, second = 0;
  double bound = 0; // of the third derivative from here on
};

Jet operator*(double factor, const Jet &jet) {
  return {factor * jet.value, factor * jet.rate, factor * jet.second, std::abs(factor) * jet.bound};
}

Jet operator+(const Jet &a, const Jet &b) {
  return {a.value + b.value, a.rate + b.rate, a.second + b.second, a.bound + b.bound};
}

// How far, up to `limit`, value + rate h + second h^2 / 2 - bound h^3 / 6 is positive: from h on it
// lies above the parabola with the least curvature it has up to the limit, and the zero of that is
// the next h. From a zero that rises the step is one that takes half of the slope at most.
double safe_step(const Jet &jet, double limit) {
  if (jet.value <= 0) {
    if (jet.rate <= 0)
      return 0;
    const double bend = std::max(0.0, -jet.second) + limit * jet.bound / 3;
    return bend * limit <= jet.rate ? limit : jet.rate / bend;
  }
  const double bend = std::max(0.0, limit * jet.bound - jet.second);
  double h = 0;
  for (int i = 0; i < 5; ++i) {
    const double value = jet.value + h * (jet.rate + h * (0.5 * jet.second - h * jet.bound / 6));
    const double slope = jet.rate + h * (jet.second - 0.5 * h * jet.bound);
    const double root = std::sqrt(slope * slope + 2 * bend * value);
    if (!(value > 0))
      break;
    if (slope >= 0 && bend == 0)
      return limit;
    const double more = slope > 0 ? (root + slope) / bend : 2 * value / (root - slope);
    h += more;
    if (h >= limit)
      return limit;
    if (more <= 1e-3 * h)
      break;
  }
  return h;
}

class ExactBumpers {
public:
  ExactBumpers(const Bumpers &system, const Bumpers::State &start, double end, bool records)
      : begin_(system), system_(system), start_(start), end_(end), records_(records),
        creep_(system.lambda / system.dashpot()) {
    for (int touching = -1; touching <= 1; ++touching)
      phases_[static_cast<std::size_t>(touching + 1)] = make_phase(touching);
  }

  Outcome operator()() {
    begin();
    while (time_ < end_)
      advance();
    return {.excursion = records_ ? highest_ - lowest_ : 0,
            .contacts = {system_.begun.begin(), system_.begun.end()},
            .steps = steps_};
  }

private:
  // No contact, or that with one bumper.
  struct Phase {
    Complex p, forced;
    double constant = 0;
    double p3 = 0; // |p|^3
  };

  Phase make_phase(int touching) const {
    const double damping = 2 * system_.xi + (touching != 0 ? system_.dashpot() : 0);
    const double stiffness = 1 + (touching != 0 ? system_.lambda : 0);
    Phase phase;
    phase.p = {-0.5 * damping, std::sqrt(stiffness - 0.25 * damping * damping)};
    const double beta = system_.beta;
    // -base sin(beta t) = Re(i base exp(i beta t))
    phase.forced = Complex(0, system_.base()) / Complex(stiffness - beta * beta, damping * beta);
    phase.constant = touching * system_.lambda * system_.delta / stiffness;
    phase.p3 = std::pow(std::abs(phase.p), 3);
    return phase;
  }

  void begin() {
    system_ = begin_;
    time_ = 0;
    steps_ = 0;
    lowest_ = std::numeric_limits<double>::infinity();
    highest_ = -lowest_;
    creeping_ = {start_[2], start_[3]};
    enter(start_[0], start_[1]);
    rising_ = start_[1] > 0;
  }

  // A new phase from q, v.
  void enter(double q, double v) {
    const int touching = (system_.modes[0] == Bumpers::touching ? 1 : 0) -
                         (system_.modes[1] == Bumpers::touching ? 1 : 0);
    phase_ = &phases_[static_cast<std::size_t>(touching + 1)];
    forced_ = phase_->forced * std::polar(1.0, system_.beta * time_);
    const double rest = q - phase_->constant - forced_.real();
    const double rest_rate = v - (Complex(0, system_.beta) * forced_).real();
    // Re(a) = rest, Re(p a) = rest_rate
    free_ = {rest, (phase_->p.real() * rest - rest_rate) / phase_->p.imag()};
    look();
  }

  // The motion and its derivatives here.
  void look() {
    const Complex p = phase_->p;
    const Complex i_beta(0, system_.beta);
    const Complex free1 = p * free_, forced1 = i_beta * forced_;
    const Complex free2 = p * free1, forced2 = i_beta * forced1;
    motion_ = {phase_->constant + free_.real() + forced_.real(), free1.real() + forced1.real(),
               free2.real() + forced2.real(), 0};
    const double free_size = std::abs(free_) * phase_->p3;
    const double forced_size = std::abs(forced_) * system_.beta * system_.beta * system_.beta;
    motion_.bound = free_size + forced_size;
    third_ = (p * free2).real() + (i_beta * forced2).real();
    velocity_ = {motion_.rate, motion_.second, third_,
                 free_size * std::abs(p) + forced_size * system_.beta};
  }

  Jet creeping(std::size_t i) const {
    const double z = creeping_[i];
    return {z, -creep_ * z, creep_ * creep_ * z, std::abs(z) * creep_ * creep_ * creep_};
  }

  Jet guard(std::size_t i) const {
    const double s = Bumpers::sign(i);
    if (system_.modes[i] == Bumpers::touching) {
      Jet force = (system_.lambda * s) * motion_ + (system_.dashpot() * s) * velocity_;
      force.value -= system_.lambda * system_.delta;
      return force;
    }
    if (system_.modes[i] == Bumpers::leaving)
      return (-system_.dashpot() * s) * velocity_ + (-system_.lambda) * creeping(i);
    Jet distance = creeping(i) + (-s) * motion_;
    distance.value += system_.delta;
    return distance;
  }

  void move(double h) {
    time_ += h;
    const double decay = std::exp(phase_->p.real() * h);
    free_ *= std::polar(decay, phase_->p.imag() * h);
    forced_ *= std::polar(1.0, system_.beta * h);
    const double creep = std::exp(-creep_ * h);
    for (std::size_t i = 0; i < 2; ++i)
      creeping_[i] *= creep;
    look();
    ++steps_;
  }

  // To the next zero, or as far as none can be.
  void advance() {
    constexpr double shortest = 1e-14;
    constexpr double longest = 0.6; // where the bounds begin to be poor
    double h = std::min(longest, end_ - time_);
    std::size_t first = none;
    for (std::size_t i = 0; i < 2; ++i) {
      const double step = safe_step(guard(i), h);
      if (step < h) {
        h = step;
        first = i;
      }
    }
    bool turns = false;
    if (records_) {
      const double step = safe_step(rising_ ? velocity_ : -1.0 * velocity_, h);
      turns = step < h;
      h = std::min(h, step);
    }
    if (h > shortest) {
      const bool last = h >= end_ - time_;
      move(h);
      if (last)
        time_ = end_;
    } else if (turns) {
      include(motion_.value);
      rising_ = !rising_;
    } else if (first != none) {
      change(first);
    } else {
      time_ = end_;
    }
  }

  void include(double value) {
    lowest_ = std::min(lowest_, value);
    highest_ = std::max(highest_, value);
  }

  void change(std::size_t i) {
    Bumpers::State x = {motion_.value, motion_.rate, creeping_[0], creeping_[1]};
    system_.pass(i, x);
    creeping_ = {x[2], x[3]};
    enter(x[0], x[1]);
  }

  static constexpr std::size_t none = 2;
  Bumpers begin_, system_;
  Bumpers::State start_;
  double end_;
  bool records_;
  double creep_;
  std::array<Phase, 3> phases_;
  const Phase *phase_ = nullptr;
  double time_ = 0;
  Complex free_, forced_;
  std::array<double, 2> creeping_{};
  Jet motion_, velocity_;
  double third_ = 0;
  bool rising_ = false;
  double lowest_ = 0, highest_ = 0;
  long steps_ = 0;
};

} // namespace

Side exact_bumpers_side(const Bumpers &system, const Bumpers::State &start, double end) {
  return {
      .name = "exact by hand",
      .prepare = [=](const Tolerance & /*tolerance*/,
                     bool records) { return Motion(ExactBumpers(system, start, end, records)); },
      .exact = true};
}

} // namespace vibroimpact::benchmarks

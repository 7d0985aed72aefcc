#include "contact/frictional_impulses.h"

#include "common/error.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::contact {

namespace {

constexpr double rounding_of_products = 1e-14;

// The contacts that act on each other, directly or by others.
std::vector<std::vector<std::size_t>> components(const Matrix &matrix, std::size_t count) {
  const auto act = [&](std::size_t a, std::size_t b) {
    const Index i = 2 * static_cast<Index>(a), j = 2 * static_cast<Index>(b);
    const double size =
        std::sqrt(matrix.block<2, 2>(i, i).trace() * matrix.block<2, 2>(j, j).trace());
    return matrix.block<2, 2>(i, j).cwiseAbs().maxCoeff() > rounding_of_products * size;
  };
  std::vector<std::vector<std::size_t>> parts;
  std::vector<char> listed(count, 0);
  for (std::size_t first = 0; first < count; ++first) {
    if (listed[first])
      continue;
    std::vector<std::size_t> part = {first};
    listed[first] = 1;
    for (std::size_t k = 0; k < part.size(); ++k)
      for (std::size_t c = 0; c < count; ++c)
        if (!listed[c] && act(part[k], c)) {
          part.push_back(c);
          listed[c] = 1;
        }
    std::sort(part.begin(), part.end());
    parts.push_back(std::move(part));
  }
  return parts;
}

// One component.
class Simultaneous {
public:
  Simultaneous(const FrictionalImpact &impact, const std::vector<std::size_t> &part)
      : count_(static_cast<Index>(part.size())), matrix_(2 * count_, 2 * count_),
        rates_(2 * count_), restitution_(count_) {
    for (Index i = 0; i < count_; ++i) {
      const auto a = part[static_cast<std::size_t>(i)];
      rates_.segment<2>(2 * i) = impact.rates.segment<2>(2 * static_cast<Index>(a));
      restitution_[i] = impact.restitution[static_cast<Index>(a)];
      const double mu = impact.contacts[a].coefficient;
      contacts_.push_back({.coefficient = mu, .at_rest = mu});
      for (Index j = 0; j < count_; ++j)
        matrix_.block<2, 2>(2 * i, 2 * j) = impact.matrix.block<2, 2>(
            2 * static_cast<Index>(a), 2 * static_cast<Index>(part[static_cast<std::size_t>(j)]));
    }
  }

  void solve() {
    if (dissipates(1))
      return;
    reduced_ = true;
    double least = 0, most = 1;
    constexpr int halvings = 30;
    for (int i = 0; i < halvings; ++i) {
      const double middle = (least + most) / 2;
      (dissipates(middle) ? least : most) = middle;
    }
    solve_with(least);
  }

  bool reduced() const { return reduced_; }
  const Vector &impulses() const { return found_.impulses; }
  const Vector &rates() const { return rates_; }
  const Vector &after() const { return after_; }
  const Matrix &by_rates() const { return by_rates_; }

private:
  // Are there impulses with this share of the restitution, by which the energy does not grow? Sides
  // that wedge have nothing to come back by.
  bool dissipates(double share) {
    try {
      solve_with(share);
    } catch (const NumericalError &) {
      return false;
    }
    return energy() <= 0;
  }

  void solve_with(double share) {
    Vector start = rates_;
    Vector factors = Vector::Ones(rates_.size());
    Vector wanted = Vector::Zero(count_);
    for (Index i = 0; i < count_; ++i)
      if (rates_[2 * i] < 0) {
        wanted[i] = -share * restitution_[i] * rates_[2 * i];
        start[2 * i] -= wanted[i];
        factors[2 * i] += share * restitution_[i];
      }
    found_ = solve_frictional(matrix_, start, contacts_,
                              share > 0 ? FrictionalEffort::limited : FrictionalEffort::full);
    by_rates_ = found_.by_start * factors.asDiagonal();
    after_ = rates_ + matrix_ * found_.impulses;
    for (Index i = 0; i < count_; ++i) { // without the rounding of the solution
      const FrictionalState state = found_.states[static_cast<std::size_t>(i)];
      if (state != FrictionalState::open)
        after_[2 * i] = wanted[i];
      if (state == FrictionalState::stick)
        after_[2 * i + 1] = 0;
    }
  }

  // What the bodies gain, above rounding.
  double energy() const {
    const Vector sum = rates_ + after_;
    return 0.5 * found_.impulses.dot(sum) -
           rounding_of_products *
               found_.impulses.cwiseAbs().dot(rates_.cwiseAbs() + after_.cwiseAbs());
  }

  Index count_;
  Matrix matrix_;
  Vector rates_, restitution_;
  std::vector<ContactFriction> contacts_;
  FrictionalSolution found_;
  Vector after_;
  Matrix by_rates_;
  bool reduced_ = false;
};

// Of |v| while it goes from one value to another.
double mean_size(double from, double to) {
  if (from * to >= 0)
    return std::abs(from + to) / 2;
  return (from * from + to * to) / (2 * std::abs(from - to));
}

void add_alone(const FrictionalImpact &impact, std::size_t contact, FrictionalImpulses &made) {
  const auto c = static_cast<Index>(contact);
  const auto block = impact.matrix.block<2, 2>(2 * c, 2 * c);
  const double mu = impact.contacts[contact].coefficient;
  const PointImpulse at = impulse_at_point({.normal = block(0, 0),
                                            .coupling = block(0, 1),
                                            .tangential = block(1, 1),
                                            .gap_rate = impact.rates[2 * c],
                                            .slip_rate = impact.rates[2 * c + 1],
                                            .friction = mu,
                                            .restitution = impact.restitution[c],
                                            .hypothesis = impact.hypotheses[contact]});
  made.impulses.segment<2>(2 * c) = at.impulse;
  made.after.segment<2>(2 * c) = at.after;
  made.rubbing[c] = at.rubbing;
  made.friction_work[c] = mu * at.rubbing;
  made.by_rates.block<2, 2>(2 * c, 2 * c) = at.by_rates;
}

void add_together(const FrictionalImpact &impact, const std::vector<std::size_t> &part,
                  FrictionalImpulses &made) {
  Simultaneous of(impact, part);
  of.solve();
  made.reduced += of.reduced() ? 1 : 0;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const auto from = 2 * static_cast<Index>(i), to = 2 * static_cast<Index>(part[i]);
    made.impulses.segment<2>(to) = of.impulses().segment<2>(from);
    made.after.segment<2>(to) = of.after().segment<2>(from);
    const double slip = of.rates()[from + 1], slip_after = of.after()[from + 1];
    made.friction_work[to / 2] = -0.5 * of.impulses()[from + 1] * (slip + slip_after);
    made.rubbing[to / 2] = impact.contacts[part[i]].coefficient > 0
                               ? of.impulses()[from] * mean_size(slip, slip_after)
                               : 0;
    for (std::size_t j = 0; j < part.size(); ++j)
      made.by_rates.block<2, 2>(to, 2 * static_cast<Index>(part[j])) =
          of.by_rates().block<2, 2>(from, 2 * static_cast<Index>(j));
  }
}

} // namespace

FrictionalImpulses frictional_impulses(const FrictionalImpact &impact) {
  const std::size_t count = impact.contacts.size();
  FrictionalImpulses made{.impulses = Vector::Zero(impact.rates.size()),
                          .after = impact.rates,
                          .friction_work = Vector::Zero(static_cast<Index>(count)),
                          .rubbing = Vector::Zero(static_cast<Index>(count)),
                          .by_rates = Matrix::Zero(impact.rates.size(), impact.rates.size())};
  for (const std::vector<std::size_t> &part : components(impact.matrix, count))
    if (part.size() == 1 && impact.contacts[part.front()].coefficient > 0)
      add_alone(impact, part.front(), made);
    else
      add_together(impact, part, made);
  return made;
}

} // namespace vibroimpact::contact

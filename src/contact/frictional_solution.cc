// The complementarity problem of several contacts with friction.
#include "common/decompositions.h"
#include "common/error.h"
#include "contact/frictional_impulses.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace vibroimpact::contact {

namespace {

using States = std::vector<FrictionalState>;

constexpr double rounding_of_block = 1e-12;
constexpr double rounding_of_states = 1e-11;

double sign_of(FrictionalState state) { return state == FrictionalState::forward ? 1 : -1; }

class FrictionalProblem {
public:
  FrictionalProblem(const Matrix &matrix, const Vector &start,
                    const std::vector<ContactFriction> &contacts)
      : matrix_(matrix), start_(start), contacts_(contacts),
        states_(contacts.size(), FrictionalState::open), x_(Vector::Zero(start.size())) {}

  FrictionalSolution solve(FrictionalEffort effort) { return with_all_that_stick(find(effort)); }

private:
  FrictionalSolution find(FrictionalEffort effort) {
    constexpr int most_sweeps = 100;
    constexpr int repetitions = 3;
    int repeated = 0;
    States refused;
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
      const States before = states_;
      for (std::size_t c = 0; c < contacts_.size(); ++c)
        step(sweep % 2 == 0 ? c : contacts_.size() - 1 - c);
      repeated = states_ == before ? repeated + 1 : 0;
      if (repeated < repetitions || states_ == refused)
        continue;
      if (auto found = try_states(states_, Vector::Zero(start_.size())))
        return std::move(*found);
      if (auto found = try_states(states_, x_))
        return std::move(*found);
      refused = states_;
    }
    constexpr int starts = 8;
    constexpr int most_starts = 2000;
    if (auto found = pivot(effort == FrictionalEffort::limited ? starts : most_starts))
      return std::move(*found);
    constexpr std::size_t few = 3;
    if (effort == FrictionalEffort::full || contacts_.size() <= few)
      if (auto found = try_all())
        return std::move(*found);
    throw NumericalError("no states of " + std::to_string(contacts_.size()) +
                         " rigid contacts with friction fit together");
  }

  const ContactFriction &friction(std::size_t c) const { return contacts_[c]; }
  static Index normal(std::size_t c) { return 2 * static_cast<Index>(c); }

  // The states that a contact can have.
  std::vector<FrictionalState> choices(std::size_t c) const {
    if (friction(c).slides > 0 || friction(c).coefficient == 0)
      return {FrictionalState::open, FrictionalState::forward};
    if (friction(c).slides < 0)
      return {FrictionalState::open, FrictionalState::backward};
    return {FrictionalState::open, FrictionalState::stick, FrictionalState::forward,
            FrictionalState::backward};
  }

  // One contact, the impulses of all others as they are.
  void step(std::size_t c) {
    const Index n = normal(c);
    const Eigen::Vector2d own = x_.segment<2>(n);
    const Eigen::Matrix2d block = matrix_.block<2, 2>(n, n);
    const Eigen::Vector2d rest = start_.segment<2>(n) + matrix_.middleRows<2>(n) * x_ - block * own;
    const double slow =
        rounding_of_block * (std::abs(start_[n]) + matrix_.row(n).cwiseAbs().dot(x_.cwiseAbs()));
    for (const FrictionalState state : choices(c))
      if (const auto found = alone(c, state, block, rest, slow)) {
        states_[c] = state;
        x_.segment<2>(n) = *found;
        return;
      }
  }

  std::optional<Eigen::Vector2d> alone(std::size_t c, FrictionalState state,
                                       const Eigen::Matrix2d &block, const Eigen::Vector2d &rest,
                                       double slow) const {
    const ContactFriction &of = friction(c);
    if (state == FrictionalState::open)
      return rest[0] >= -slow ? std::optional(Eigen::Vector2d(0, 0)) : std::nullopt;
    if (state == FrictionalState::stick) {
      const double determinant = block(0, 0) * block(1, 1) - block(0, 1) * block(1, 0);
      if (determinant <=
          rounding_of_block * block(0, 0) * block(1, 1)) // one velocity is all there is
        return held_on_rail(of, block, rest);
      const Eigen::Vector2d x(-(block(1, 1) * rest[0] - block(0, 1) * rest[1]) / determinant,
                              -(block(0, 0) * rest[1] - block(1, 0) * rest[0]) / determinant);
      return std::abs(x[1]) <= of.at_rest * x[0] ? std::optional(x) : std::nullopt;
    }
    const double share = -sign_of(state) * of.coefficient;
    const double slope = block(0, 0) + share * block(0, 1);
    if (!(slope > 0))
      return std::nullopt;
    const double p = -rest[0] / slope;
    const double slip = rest[1] + (block(1, 0) + share * block(1, 1)) * p;
    const double creep =
        rounding_of_block * (std::abs(rest[1]) + block.row(1).cwiseAbs().sum() * p);
    if (of.slides == 0 && of.coefficient > 0 && sign_of(state) * slip < -creep)
      return std::nullopt;
    return Eigen::Vector2d(p, share * p);
  }

  static std::optional<Eigen::Vector2d> held_on_rail(const ContactFriction &of,
                                                     const Eigen::Matrix2d &block,
                                                     const Eigen::Vector2d &rest) {
    const double p = -rest[0] * block(0, 0) / (block(0, 0) * block.trace());
    const Eigen::Vector2d x(p, p * block(0, 1) / block(0, 0));
    return p >= 0 && std::abs(x[1]) <= of.at_rest * p ? std::optional(x) : std::nullopt;
  }

  // The unknowns of some states: p = columns * unknowns, rates of `rows` zero.
  struct System {
    std::vector<Index> rows;
    Matrix columns;
  };
  System system(const States &states) const {
    System made;
    made.columns = Matrix::Zero(start_.size(), start_.size());
    for (std::size_t c = 0; c < states.size(); ++c) {
      if (states[c] == FrictionalState::open)
        continue;
      const Index n = normal(c);
      const auto k = static_cast<Index>(made.rows.size());
      made.columns(n, k) = 1;
      made.rows.push_back(n);
      if (states[c] == FrictionalState::stick) {
        made.columns(n + 1, k + 1) = 1;
        made.rows.push_back(n + 1);
      } else {
        made.columns(n + 1, k) = -sign_of(states[c]) * friction(c).coefficient;
      }
    }
    made.columns.conservativeResize(Eigen::NoChange, static_cast<Index>(made.rows.size()));
    return made;
  }

  // The inequality that is violated most, in roundings, and the state beyond it.
  struct Violation {
    double size = 1;
    std::size_t contact = 0;
    FrictionalState beyond = FrictionalState::open;
    void take(double larger, std::size_t of, FrictionalState state) {
      if (larger > size)
        *this = {.size = larger, .contact = of, .beyond = state};
    }
    bool none() const { return size <= 1; }
  };

  // Where the impulses are not unique, those next to `near`.
  FrictionalSolution solve_states(const States &states, const Vector &near) const {
    const System of = system(states);
    const auto size = static_cast<Index>(of.rows.size());
    FrictionalSolution found{.impulses = Vector::Zero(start_.size()),
                             .states = states,
                             .by_start = Matrix::Zero(start_.size(), start_.size())};
    if (size == 0)
      return found;
    Matrix picked = Matrix::Zero(size, start_.size());
    for (Index k = 0; k < size; ++k)
      picked(k, of.rows[static_cast<std::size_t>(k)]) = 1;
    const Matrix by_rates =
        of.columns * least_norm_solution(Matrix(picked * matrix_ * of.columns), picked);
    found.by_start = -by_rates;
    const Vector kept = of.columns * (picked * near);
    found.impulses = kept - by_rates * (start_ + matrix_ * kept);
    return found;
  }

  Violation judge(const FrictionalSolution &found) const {
    const Vector v = start_ + matrix_ * found.impulses;
    const double slow =
        rounding_of_states *
        (start_.cwiseAbs() + matrix_.cwiseAbs() * found.impulses.cwiseAbs()).maxCoeff();
    const double light = rounding_of_states * found.impulses.cwiseAbs().maxCoeff();
    Violation worst;
    for (std::size_t c = 0; c < contacts_.size(); ++c) {
      const Index n = normal(c);
      const FrictionalState state = found.states[c];
      const double p = found.impulses[n], t = found.impulses[n + 1];
      const std::vector<FrictionalState> all = choices(c);
      if (state == FrictionalState::open) {
        worst.take(-v[n] / slow, c, all[1]);
        continue;
      }
      worst.take(std::max(-p / light, std::abs(v[n]) / slow), c, FrictionalState::open);
      if (all.size() == 2)
        continue;
      if (state == FrictionalState::stick) {
        worst.take((std::abs(t) - friction(c).at_rest * p) / light, c,
                   t < 0 ? FrictionalState::forward : FrictionalState::backward);
        worst.take(std::abs(v[n + 1]) / slow, c, FrictionalState::open);
      } else {
        worst.take(-sign_of(state) * v[n + 1] / slow, c, FrictionalState::stick);
      }
    }
    return worst;
  }

  std::optional<FrictionalSolution> try_states(const States &states, const Vector &near) const {
    FrictionalSolution found = solve_states(states, near);
    return judge(found).none() ? std::optional(std::move(found)) : std::nullopt;
  }

  // Contacts that slide at no speed beside others that stick do so too where the forces of all that
  // are smallest allow it, as those that hold them will be (ActiveConstraints).
  FrictionalSolution with_all_that_stick(FrictionalSolution found) const {
    const Vector sizes = start_.cwiseAbs() + matrix_.cwiseAbs() * found.impulses.cwiseAbs();
    const Vector v = start_ + matrix_ * found.impulses;
    States states = found.states;
    for (std::size_t c = 0; c < states.size(); ++c)
      if (states[c] != FrictionalState::open && choices(c).size() > 2 &&
          std::abs(v[normal(c) + 1]) <= rounding_of_states * sizes.maxCoeff())
        states[c] = FrictionalState::stick;
    if (states == found.states)
      return found;
    auto all = try_states(states, Vector::Zero(start_.size()));
    return all ? std::move(*all) : found;
  }

  // From the last guess and from others: across the inequality that is violated most, again and
  // again.
  std::optional<FrictionalSolution> pivot(int most_starts) const {
    const std::size_t most_pivots = 6 * contacts_.size();
    std::uint64_t random = 1;
    States from = states_;
    for (int start = 0; start < most_starts; ++start) {
      States states = from;
      for (std::size_t i = 0; i < most_pivots; ++i) {
        FrictionalSolution found =
            solve_states(states, start % 2 == 0 ? Vector(Vector::Zero(start_.size())) : x_);
        const Violation worst = judge(found);
        if (worst.none())
          return found;
        states[worst.contact] = worst.beyond;
      }
      for (std::size_t c = 0; c < from.size(); ++c) { // Knuth's linear congruential numbers
        random = 6364136223846793005U * random + 1442695040888963407U;
        const std::vector<FrictionalState> all = choices(c);
        from[c] = all[(random >> 33) % all.size()];
      }
    }
    return std::nullopt;
  }

  std::optional<FrictionalSolution> try_all() const {
    constexpr std::size_t most_contacts = 7;
    std::vector<States> of;
    for (std::size_t c = 0; c < contacts_.size(); ++c)
      of.push_back(choices(c));
    std::vector<std::size_t> digits(contacts_.size(), 0);
    bool left = contacts_.size() <= most_contacts;
    while (left) {
      States states;
      for (std::size_t c = 0; c < digits.size(); ++c)
        states.push_back(of[c][digits[c]]);
      if (auto found = try_states(states, Vector::Zero(start_.size())))
        return found;
      left = false;
      for (std::size_t c = 0; c < digits.size() && !left; ++c) {
        left = ++digits[c] < of[c].size();
        if (!left)
          digits[c] = 0;
      }
    }
    return std::nullopt;
  }

  const Matrix &matrix_;
  const Vector &start_;
  const std::vector<ContactFriction> &contacts_;
  States states_;
  Vector x_;
};

} // namespace

FrictionalSolution solve_frictional(const Matrix &matrix, const Vector &start,
                                    const std::vector<ContactFriction> &contacts,
                                    FrictionalEffort effort) {
  if (contacts.empty())
    return {.impulses = Vector(0), .states = {}, .by_start = Matrix(0, 0)};
  return FrictionalProblem(matrix, start, contacts).solve(effort);
}

} // namespace vibroimpact::contact

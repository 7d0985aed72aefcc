// The formula is computed with other things than numbers: linear forms, powers, sets of powers.
#include "contact/laws/formula_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace vibroimpact::contact {

namespace {

using parameters::Step;
using Kind = Step::Kind;

template <class Type> using Maybe = std::optional<Type>;

/// The last value of the steps; `Arithmetic` has constants, arguments, combined() and called().
template <class Arithmetic>
typename Arithmetic::Entry computed(const std::vector<Step> &steps, const Arithmetic &arithmetic) {
  std::vector<typename Arithmetic::Entry> stack;
  for (const Step &step : steps) {
    if (step.kind == Kind::constant)
      stack.push_back(arithmetic.constant(step.constant.value));
    else if (step.kind == Kind::argument)
      stack.push_back(arithmetic.argument(step.index));
    else if (step.kind == Kind::negate)
      stack.back() = arithmetic.combined(Kind::multiply, arithmetic.constant(-1), stack.back());
    else
      parameters::perform(step, stack, arithmetic);
  }
  return stack.back();
}

double called_with(std::size_t function, const std::vector<double> &values) {
  if (!parameters::takes_several_values(function))
    return parameters::function_value(function, values.front());
  return parameters::function_names()[function] == "min"
             ? *std::min_element(values.begin(), values.end())
             : *std::max_element(values.begin(), values.end());
}

struct LinearForms {
  struct Entry {
    Maybe<LinearForm> form{};   ///< the whole
    Maybe<LinearForm> factor{}; ///< see FormulaShape; of linear ones the whole
    bool sees_rate = false;
  };

  static bool is_constant(const Entry &entry) {
    return entry.form && entry.form->by_penetration == 0 && entry.form->by_rate == 0;
  }
  static Entry linear(const LinearForm &form) {
    return {.form = form, .factor = form, .sees_rate = form.by_rate != 0};
  }
  static Entry constant(double value) { return linear({.constant = value}); }
  static Entry argument(std::size_t index) {
    return linear(index == 0 ? LinearForm{.by_penetration = 1} : LinearForm{.by_rate = 1});
  }
  static Entry sum(const LinearForm &a, double sign, const LinearForm &b) {
    return linear({.constant = a.constant + sign * b.constant,
                   .by_penetration = a.by_penetration + sign * b.by_penetration,
                   .by_rate = a.by_rate + sign * b.by_rate});
  }
  static Entry scaled(const LinearForm &form, double factor) {
    return linear({.constant = form.constant * factor,
                   .by_penetration = form.by_penetration * factor,
                   .by_rate = form.by_rate * factor});
  }
  static Entry product(const Entry &a, const Entry &b) {
    if (!a.sees_rate && !b.sees_rate)
      return {};
    if (a.sees_rate && b.sees_rate)
      return {.sees_rate = true};
    return {.factor = a.sees_rate ? a.factor : b.factor, .sees_rate = true};
  }

  static Entry combined(Kind kind, const Entry &a, const Entry &b) {
    if (is_constant(a) && is_constant(b))
      return constant(parameters::combined(kind, a.form->constant, b.form->constant));
    if ((kind == Kind::add || kind == Kind::subtract) && a.form && b.form)
      return sum(*a.form, kind == Kind::add ? 1 : -1, *b.form);
    if (kind == Kind::multiply && is_constant(a) && b.form)
      return scaled(*b.form, a.form->constant);
    if (kind == Kind::multiply && a.form && is_constant(b))
      return scaled(*a.form, b.form->constant);
    if (kind == Kind::divide && a.form && is_constant(b))
      return scaled(*a.form, 1 / b.form->constant);
    if (kind == Kind::power && is_constant(b) && b.form->constant == 1)
      return a;
    if (kind == Kind::multiply || (kind == Kind::divide && !b.sees_rate))
      return product(a, b);
    return {.sees_rate = a.sees_rate || b.sees_rate};
  }
  static Entry called(std::size_t function, const Entry *first, std::size_t count) {
    std::vector<double> values;
    bool sees_rate = false;
    for (const Entry *entry = first; entry != first + count; ++entry) {
      sees_rate = sees_rate || entry->sees_rate;
      if (is_constant(*entry))
        values.push_back(entry->form->constant);
    }
    return values.size() == count ? constant(called_with(function, values))
                                  : Entry{.sees_rate = sees_rate};
  }
};

/// k u^n at v = 0.
struct Powers {
  using Entry = Maybe<ElasticForce>;

  static Entry constant(double value) { return ElasticForce{.stiffness = value, .exponent = 0}; }
  static Entry argument(std::size_t index) {
    return index == 0 ? ElasticForce{.stiffness = 1, .exponent = 1} : *constant(0);
  }
  static Entry sum(const ElasticForce &a, double sign, const ElasticForce &b) {
    if (b.stiffness == 0)
      return a;
    if (a.stiffness != 0 && a.exponent != b.exponent)
      return std::nullopt;
    return ElasticForce{.stiffness = a.stiffness + sign * b.stiffness, .exponent = b.exponent};
  }
  static Entry combined(Kind kind, const Entry &a, const Entry &b) {
    if (!a || !b)
      return std::nullopt;
    if (kind == Kind::add || kind == Kind::subtract)
      return sum(*a, kind == Kind::add ? 1 : -1, *b);
    if (kind == Kind::power && b->exponent == 0)
      return ElasticForce{.stiffness = std::pow(a->stiffness, b->stiffness),
                          .exponent = a->exponent * b->stiffness};
    if (kind == Kind::power)
      return std::nullopt;
    const double sign = kind == Kind::multiply ? 1 : -1;
    return ElasticForce{.stiffness = parameters::combined(kind, a->stiffness, b->stiffness),
                        .exponent = a->exponent + sign * b->exponent};
  }
  static Entry called(std::size_t function, const Entry *first, std::size_t count) {
    if (parameters::function_names()[function] == "sqrt")
      return combined(Kind::power, *first, constant(0.5));
    std::vector<double> values;
    for (const Entry *entry = first; entry != first + count; ++entry)
      if (*entry && (*entry)->exponent == 0)
        values.push_back((*entry)->stiffness);
    return values.size() == count ? constant(called_with(function, values)) : std::nullopt;
  }
};

/// A sum of u^p times series in u and v: one p for each fractional part, the lowest.
struct Growths {
  struct Growth {
    std::vector<double> powers;
    Maybe<double> constant{};
    bool sees_rate = false;
  };
  using Entry = Maybe<Growth>;

  static Entry constant(double value) {
    return Growth{.powers = value == 0 ? std::vector<double>{} : std::vector<double>{0},
                  .constant = value};
  }
  static Entry argument(std::size_t index) {
    return Growth{.powers = {index == 0 ? 1.0 : 0.0}, .sees_rate = index != 0};
  }
  static void add(double power, std::vector<double> &powers) {
    for (double &known : powers)
      if (std::abs(std::remainder(known - power, 1.0)) < 1e-9) {
        known = std::min(known, power);
        return;
      }
    powers.push_back(power);
  }
  static Growth product(const Growth &a, const Growth &b) {
    Growth made{.powers = {}, .sees_rate = a.sees_rate || b.sees_rate};
    for (const double p : a.powers)
      for (const double q : b.powers)
        add(p + q, made.powers);
    return made;
  }
  static Entry power(const Growth &base, double exponent) {
    constexpr double most = 8;
    if (exponent >= 0 && exponent <= most && exponent == std::floor(exponent)) {
      Growth made = *constant(1);
      for (int k = 0; k < static_cast<int>(exponent); ++k)
        made = product(made, base);
      return made;
    }
    if (base.sees_rate || base.powers.size() != 1)
      return std::nullopt;
    return Growth{.powers = {base.powers[0] * exponent}};
  }
  static Entry combined(Kind kind, const Entry &a, const Entry &b) {
    if (!a || !b)
      return std::nullopt;
    if (a->constant && b->constant)
      return constant(parameters::combined(kind, *a->constant, *b->constant));
    if (kind == Kind::power)
      return b->constant ? power(*a, *b->constant) : std::nullopt;
    if (kind == Kind::multiply)
      return product(*a, *b);
    if (kind == Kind::divide)
      return divided(*a, *b);
    Growth made = *a;
    made.constant.reset();
    made.sees_rate = a->sees_rate || b->sees_rate;
    for (const double p : b->powers)
      add(p, made.powers);
    return made;
  }
  static Entry divided(const Growth &a, const Growth &b) {
    if (b.powers.size() != 1)
      return std::nullopt;
    return product(a, {.powers = {-b.powers[0]}, .sees_rate = b.sees_rate});
  }
  // Those that are a series about every number, and begin with a constant or with their argument.
  static Entry called(std::size_t function, const Entry *first, std::size_t count) {
    static constexpr std::array with_constant = {"exp", "cos", "cosh"};
    static constexpr std::array odd = {"sin", "sinh", "tanh", "atan"};
    const auto among = [&](const auto &names) {
      return std::find(names.begin(), names.end(), parameters::function_names()[function]) !=
             names.end();
    };
    if (count == 1 && *first && parameters::function_names()[function] == "sqrt")
      return power(**first, 0.5);
    if (count != 1 || !*first || (!among(with_constant) && !among(odd)))
      return std::nullopt;
    Growth made = **first;
    made.constant.reset();
    for (const double p : made.powers)
      if (p < 0 || p != std::floor(p))
        return std::nullopt;
    if (among(with_constant))
      made.powers = {0};
    return made;
  }
};

/// Least whole number by which a power becomes one; none up to 6.
Maybe<int> denominator(double power) {
  for (int r = 1; r <= 6; ++r)
    if (std::abs(std::remainder(power * r, 1.0)) < 1e-9)
      return r;
  return std::nullopt;
}

// A force that begins below u adds its own power, plus one, to those of the motion.
Maybe<ForceEdge> edge_of(const Growths::Entry &growth) {
  if (!growth || growth->powers.empty())
    return std::nullopt;
  const double least = *std::min_element(growth->powers.begin(), growth->powers.end());
  if (!(least > 0))
    return std::nullopt;
  std::vector<double> apart;
  for (const double power : growth->powers)
    apart.push_back(power - least);
  if (least < 1)
    apart.push_back(least);
  int root = 1;
  for (const double power : apart) {
    const Maybe<int> r = denominator(power);
    if (!r)
      return std::nullopt;
    root = std::lcm(root, *r);
  }
  return ForceEdge{.power = least, .root = root};
}

} // namespace

FormulaShape shape_of(const parameters::Formula &formula) {
  const LinearForms::Entry form = computed(formula.steps(), LinearForms{});
  FormulaShape shape{.sees_rate = form.sees_rate, .linear = form.form, .factor = form.factor};
  if (!form.sees_rate)
    shape.factor.reset();
  if (const Powers::Entry power = computed(formula.steps(), Powers{});
      power && power->stiffness > 0 && power->exponent > 0)
    shape.elastic = power;
  shape.edge = edge_of(computed(formula.steps(), Growths{}));
  return shape;
}

} // namespace vibroimpact::contact

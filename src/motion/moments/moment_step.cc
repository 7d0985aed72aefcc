#include "motion/moments/moment_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace vibroimpact::motion {

namespace {

constexpr int most_sweeps = 24;
/// What the sweeps may leave, of the tolerance.
constexpr double share_of_sweeps = 0.05;
/// Slower than that they leave too much; so many sweeps show it.
constexpr double slowest_rate = 0.6;
constexpr int sweeps_to_judge = 3;
/// How far gaps may move from where the first sweep saw them, of the way seen so far.
constexpr double room_for_way = 1.5;

int free_mode(const contact::ContactLaw &law) {
  for (std::size_t m = 0; m < law.modes().size(); ++m)
    if (forceless(law.modes()[m]) && !law.modes()[m].in_contact)
      return static_cast<int>(m);
  return -1;
}

} // namespace

bool MomentStep::holds(const Equations &equations) {
  const auto &pairs = equations.contacts().pairs();
  return equations.model().linear() && !pairs.empty() &&
         std::all_of(pairs.begin(), pairs.end(), [](const contact::ContactPair &pair) {
           return pair.tangential.empty() && pair.law->n_internal() == 0 && !pair.law->rigid() &&
                  free_mode(*pair.law) >= 0;
         });
}

MomentStep::MomentStep(Equations &equations, double tolerance)
    : equations_(equations), tolerance_(tolerance), fastest_(equations.model().highest_frequency()),
      contacts_(equations), courses_(equations.contacts().size()),
      all_(equations.contacts().size()) {
  moments_.setZero(contacts_.size(), n_moments);
  std::iota(all_.begin(), all_.end(), 0);
}

void MomentStep::begin() {
  largest_ = deepest_ = 0;
  slack_ = std::numeric_limits<double>::infinity();
}

void MomentStep::make_phase() {
  const std::vector<int> present = equations_.modes();
  const auto &pairs = equations_.contacts().pairs();
  for (std::size_t c = 0; c < pairs.size(); ++c)
    equations_.set_mode(c, free_mode(*pairs[c].law));
  const LinearSystem system(equations_);
  for (std::size_t c = 0; c < pairs.size(); ++c)
    equations_.set_mode(c, present[c]);
  const GuardForms none{
      .rows =
          Matrix(0, system.size() + 3 * static_cast<Index>(equations_.model().sources().size())),
      .constants = Vector(0)};
  phase_ =
      std::make_unique<ExactPhase>(system.matrix(), system.constant(), system.loads(), none, 1);
}

bool MomentStep::take(const Excitation &excitation) {
  if (!phase_)
    make_phase();
  const long generation = phase_->generation();
  phase_->take(excitation);
  if (flow_ && generation == phase_->generation())
    return false;
  flow_ = std::make_unique<MomentFlow>(*phase_, equations_.model().mass());
  return true;
}

void MomentStep::start(const Vector &state, const Excitation &excitation, double time,
                       const std::vector<int> &modes, double uncertainty) {
  modes_ = modes;
  std::vector<double> inputs(static_cast<std::size_t>(excitation.size()));
  excitation.coordinates(time, inputs.data());
  Amplitudes amplitudes;
  const Vector y = state.head(phase_->n_modes());
  phase_->amplitudes(y, inputs.data(), amplitudes);
  start_.resize(phase_->n_coordinates());
  for (Index k = 0; k < start_.size(); ++k)
    start_[k] = amplitudes[static_cast<std::size_t>(phase_->places()[static_cast<std::size_t>(k)])];
  const Vector rows = phase_->columns() * start_;
  largest_ = std::max(largest_, norm(rows));
  find_start(rows);
  gap_rounding_ += 2 * uncertainty * start_rates_.cwiseAbs().maxCoeff();
}

void MomentStep::find_start(const Vector &rows) {
  const Index n = equations_.layout().n;
  start_gaps_ = contacts_.clearances + contacts_.rows * rows.head(n);
  start_rates_ = contacts_.rows * rows.segment(n, n);
  constexpr double unit = 64 * std::numeric_limits<double>::epsilon();
  gap_rounding_ =
      contacts_.clearances.cwiseAbs().maxCoeff() + contacts_.largest.dot(rows.head(n).cwiseAbs());
  rate_rounding_ = contacts_.largest.dot(rows.segment(n, n).cwiseAbs());
  for (Index s = 0; s < contacts_.base.cols(); ++s) {
    const double value = rows[2 * n + 3 * s], rate = rows[2 * n + 3 * s + 1];
    start_gaps_ += value * contacts_.base.col(s);
    start_rates_ += rate * contacts_.base.col(s);
    gap_rounding_ += std::abs(value) * contacts_.base.col(s).cwiseAbs().maxCoeff();
    rate_rounding_ += std::abs(rate) * contacts_.base.col(s).cwiseAbs().maxCoeff();
  }
  gap_rounding_ *= unit;
  rate_rounding_ *= unit;
}

// Inputs go on by themselves; their rounding does not add up.
void MomentStep::go_on(const Excitation &excitation, double time) {
  for (const std::size_t c : list_)
    modes_[c] = courses_[c].last_mode();
  deepest_ = deepest();
  start_ = ends_.back();
  excitation.coordinates(time, start_.data() + phase_->n_modes());
  const Vector rows = phase_->columns() * start_;
  largest_ = std::max(largest_, norm(rows));
  find_start(rows);
}

MomentTables MomentStep::tables(double h) const {
  MomentTables tables;
  for (std::size_t i = 0; i < n_moments; ++i)
    tables[i] = flow_->table(h, moment_nodes()[i]);
  tables[n_moments] = flow_->table(h, 1);
  tables[n_moments + 1] = flow_->table(h, 0.5);
  return tables;
}

double MomentStep::norm(const Vector &rows) const {
  const Index n = equations_.layout().n;
  const Vector q = rows.head(n);
  Vector elastic;
  equations_.model().stiffness().apply(ConstVectorView(q.data(), n), elastic);
  return std::sqrt(std::max(0.0, q.dot(elastic)) +
                   rows.segment(n, n).cwiseAbs2().dot(equations_.model().mass()));
}

// From the moments of the listed contacts to the coordinates, and to what the contacts see.
void MomentStep::sweep(const MomentTables &tables) {
  const Index n = equations_.layout().n;
  const auto count = static_cast<Index>(list_.size());
  Matrix forces = Matrix::Zero(n, n_moments);
  if (count == contacts_.size()) {
    forces.noalias() = contacts_.rows.transpose() * moments_;
  } else {
    for (const std::size_t c : list_)
      if (moments_.row(static_cast<Index>(c)).any())
        forces.noalias() += contacts_.rows.row(static_cast<Index>(c)).transpose() *
                            moments_.row(static_cast<Index>(c));
  }
  loads_ = flow_->loads(forces);
  Matrix coordinates(start_.size(), n_moments + 1);
  for (std::size_t i = 0; i <= n_moments; ++i) {
    flow_->move(tables[i], start_, loads_, ends_[i]);
    coordinates.col(static_cast<Index>(i)) = ends_[i];
  }
  positions_.resize(n, n_moments + 2);
  positions_.leftCols(n_moments + 1).noalias() = phase_->columns().topRows(n) * coordinates;
  positions_.col(n_moments + 1).noalias() = phase_->columns().middleRows(n, n) * ends_.back();
  sources_.noalias() = phase_->columns().bottomRows(3 * contacts_.base.cols()) * coordinates;
}

// Of the listed contacts, at the nodes and the end, and the rates there.
void MomentStep::find_gaps() {
  const auto count = static_cast<Index>(list_.size());
  if (count == contacts_.size()) {
    gaps_.noalias() = contacts_.rows * positions_;
  } else {
    gaps_.resize(count, positions_.cols());
    for (Index k = 0; k < count; ++k)
      gaps_.row(k).noalias() =
          contacts_.rows.row(static_cast<Index>(list_[static_cast<std::size_t>(k)])) * positions_;
  }
  for (Index k = 0; k < count; ++k) {
    const auto c = static_cast<Index>(list_[static_cast<std::size_t>(k)]);
    gaps_.row(k).head(n_moments + 1).array() += contacts_.clearances[c];
    for (Index s = 0; s < contacts_.base.cols(); ++s)
      if (const double factor = contacts_.base(c, s); factor != 0) {
        gaps_.row(k).head(n_moments + 1) += factor * sources_.row(3 * s);
        gaps_(k, n_moments + 1) += factor * sources_(3 * s + 1, n_moments);
      }
  }
}

// False: a mode changes too often.
bool MomentStep::find_forces() {
  for (std::size_t k = 0; k < list_.size(); ++k) {
    const std::size_t c = list_[k];
    const auto row = static_cast<Index>(c);
    const contact::ContactLaw &law = *equations_.contacts().pairs()[c].law;
    GapValues values{.start = start_gaps_[row],
                     .start_rate = start_rates_[row],
                     .rounding = gap_rounding_,
                     .rate_rounding = rate_rounding_};
    const double *gaps = gaps_.row(static_cast<Index>(k)).data();
    std::copy_n(gaps, n_moments, values.nodes.begin());
    values.end = gaps[n_moments];
    values.end_rate = gaps[n_moments + 1];
    if (!courses_[c].follow(law, GapCurve(values, h_), modes_[c]))
      return false;
    const ContactCourse::Moments moments = courses_[c].moments(law, response_);
    std::copy(moments.begin(), moments.end(), moments_.row(row).data());
  }
  return true;
}

// Contacts without force whose gap the way seen so far cannot close are left out.
void MomentStep::choose_list() {
  list_.clear();
  for (const std::size_t c : all_) {
    const contact::ContactLaw &law = *equations_.contacts().pairs()[c].law;
    const ContactCourse &course = courses_[c];
    const bool open = !course.changes() && modes_[c] == free_mode(law);
    const auto &gap = course.curve().coefficients();
    if (!open || *std::min_element(gap.begin(), gap.end()) <= slack_)
      list_.push_back(c);
  }
}

// The most that any gap has moved since the first sweep, at the nodes and the end.
double MomentStep::way() const {
  const Matrix moved = (positions_ - first_positions_).leftCols(n_moments + 1).cwiseAbs();
  return (contacts_.largest.transpose() * moved).maxCoeff();
}

std::vector<std::size_t> MomentStep::acting() const {
  std::vector<std::size_t> some;
  for (const std::size_t c : list_)
    if (courses_[c].changes() || moments_.row(static_cast<Index>(c)).any())
      some.push_back(c);
  return some;
}

std::optional<double> MomentStep::attempt(double h, const MomentTables &tables) {
  h_ = h;
  list_ = all_;
  moments_.setZero();
  for (const std::size_t c : all_) {
    const contact::ContactLaw &law = *equations_.contacts().pairs()[c].law;
    const auto row = static_cast<Index>(c);
    if (forceless(law.modes()[static_cast<std::size_t>(modes_[c])]))
      continue;
    law.evaluate(modes_[c], {.gap = start_gaps_[row], .gap_rate = start_rates_[row]}, response_);
    moments_(row, 0) = response_.force;
  }
  double before = std::numeric_limits<double>::infinity();
  Vector last;
  for (int i = 0; i < most_sweeps; ++i) {
    sweep(tables);
    if (i == 0)
      first_positions_ = positions_;
    else if (list_.size() < all_.size() && way() > slack_) {
      list_ = all_;
      slack_ = room_for_way * way();
    }
    find_gaps();
    if (!find_forces())
      return {};
    if (i == 0 && std::isfinite(slack_))
      choose_list();
    const Vector rows = phase_->columns() * ends_.back();
    if (!rows.allFinite())
      return {};
    const bool none = !moments_.any();
    const double change = i == 0 ? before : norm(rows - last);
    const double rate = std::isfinite(before) ? change / before : 0;
    last = rows;
    const double scale = tolerance_ * std::max(largest_, norm(rows));
    if (none && i == 0)
      return 0;
    if (i > 0 && (change == 0 || rate / (1 - rate) * change < share_of_sweeps * scale) &&
        rate < 1 && i > 1) {
      slack_ = room_for_way * way();
      return std::max(error(tables[n_moments], rate) / scale, gap_error(tables.back()));
    }
    if (i >= sweeps_to_judge && rate > slowest_rate)
      return {};
    before = change;
  }
  return {};
}

double MomentStep::error(const MomentTable &end, double rate) const {
  const Index n = equations_.layout().n;
  Vector lacking = Vector::Zero(n), changing = Vector::Zero(n);
  for (const std::size_t c : list_) {
    const auto row = static_cast<Index>(c);
    const double last = moments_(row, n_moments - 1);
    lacking += last * contacts_.rows.row(row).transpose();
    if (courses_[c].changes())
      changing += last * contacts_.rows.row(row).transpose();
  }
  Matrix force = Matrix::Zero(n, n_moments);
  force.col(0) = lacking;
  const Vector response = flow_->response(end, flow_->loads(force).col(0));
  const double unseen =
      h_ * std::sqrt(changing.cwiseAbs2().cwiseQuotient(equations_.model().mass()).sum());
  return std::max(norm(phase_->columns() * response), unseen * rate / (2 * n_moments));
}

// Penetration, of the step and before; at a first touch what the speed leads to within the shortest
// time scale [m].
double MomentStep::deepest() const {
  double depth = deepest_;
  for (const std::size_t c : acting()) {
    const auto &gap = courses_[c].curve().coefficients();
    depth = std::max(depth, -std::min(gap.front(), gap.back()));
    if (courses_[c].changes() && fastest_ > 0)
      depth = std::max(depth, std::abs(start_rates_[static_cast<Index>(c)]) / fastest_);
  }
  return depth;
}

// Over what is allowed.
double MomentStep::gap_error(const MomentTable &middle) {
  constexpr double x = 0.5, share = 10;
  const double allowed = share * tolerance_ * deepest();
  if (allowed == 0)
    return 0;
  Vector coordinates;
  flow_->move(middle, start_, loads_, coordinates);
  const Vector rows = phase_->columns() * coordinates;
  const GapCurve::Coefficients polynomials = bernstein_polynomials(x);
  constexpr double m = n_moments;
  constexpr double twice = (2 / ((2 * m + 1) * (2 * m + 3)) + 2 / ((2 * m + 1) * (2 * m - 1))) / 4;
  double largest = 0;
  for (const std::size_t c : acting()) {
    const auto row = static_cast<Index>(c);
    const double lacking =
        h_ * h_ * twice * std::abs(moments_(row, n_moments - 1)) * contacts_.flexibilities[row];
    const double missed =
        std::abs(contacts_.local(row, rows).gap - courses_[c].curve().at(polynomials).gap);
    largest = std::max(largest, lacking + missed);
  }
  return largest / allowed;
}

// Within the step the motion under the true forces deviates from that under their polynomials: to
// first order by what the difference of the two makes of free masses.
Vector MomentStep::rows_at(double x) const {
  Vector coordinates;
  flow_->move(flow_->table(h_, x), start_, loads_, coordinates);
  Vector rows = phase_->columns() * coordinates;
  const Index n = equations_.layout().n;
  for (const std::size_t c : list_) {
    if (!courses_[c].changes())
      continue;
    const auto row = static_cast<Index>(c);
    const auto lacking = courses_[c].lacking(*equations_.contacts().pairs()[c].law,
                                             moments_.row(row).data(), x, response_);
    const Vector response =
        contacts_.rows.row(row).transpose().cwiseQuotient(equations_.model().mass());
    rows.head(n) += h_ * h_ * lacking[1] * response;
    rows.segment(n, n) += h_ * lacking[0] * response;
  }
  return rows;
}

} // namespace vibroimpact::motion

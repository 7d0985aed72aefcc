#include "motion/moments/moment_step.h"

#include "contact/free_mode.h"

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

} // namespace

bool MomentStep::holds(const Equations &equations) {
  const auto &pairs = equations.contacts().pairs();
  return equations.model().linear() && !pairs.empty() &&
         std::all_of(pairs.begin(), pairs.end(), [](const contact::ContactPair &pair) {
           return !pair.circle && pair.law->n_tangential() < 2 && ContactCourse::holds(*pair.law);
         });
}

MomentStep::MomentStep(const Equations &equations, double tolerance)
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
  const contact::ContactSet no_contacts;
  const LinearSystem system(Equations(equations_.model(), no_contacts));
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
  const StateLayout &layout = equations_.layout();
  internal_ = state.segment(layout.internal(), layout.n_internal);
  std::vector<double> inputs(static_cast<std::size_t>(excitation.size()));
  excitation.coordinates(time, inputs.data());
  Amplitudes amplitudes;
  const Vector y = state.head(phase_->n_modes());
  phase_->amplitudes(y, inputs.data(), amplitudes);
  start_.resize(phase_->n_coordinates());
  for (Index k = 0; k < start_.size(); ++k)
    start_[k] = amplitudes[static_cast<std::size_t>(phase_->places()[static_cast<std::size_t>(k)])];
  find_start();
  gap_rounding_ += 2 * uncertainty * start_rates_.cwiseAbs().maxCoeff();
}

void MomentStep::find_start() {
  start_rows_ = phase_->columns() * start_;
  const Vector &rows = start_rows_;
  largest_ = std::max(largest_, norm(rows));
  const Index n = equations_.layout().n;
  start_positions_ = contacts_.offsets + contacts_.rows * rows.head(n);
  start_rates_ = contacts_.rows * rows.segment(n, n);
  constexpr double unit = 64 * std::numeric_limits<double>::epsilon();
  gap_rounding_ =
      contacts_.offsets.cwiseAbs().maxCoeff() + contacts_.largest.dot(rows.head(n).cwiseAbs());
  rate_rounding_ =
      contacts_.speeds.cwiseAbs().maxCoeff() + contacts_.largest.dot(rows.segment(n, n).cwiseAbs());
  for (Index s = 0; s < contacts_.base.cols(); ++s) {
    const double value = rows[2 * n + 3 * s], rate = rows[2 * n + 3 * s + 1];
    start_positions_ += value * contacts_.base.col(s);
    start_rates_ += rate * contacts_.base.col(s);
    gap_rounding_ += std::abs(value) * contacts_.base.col(s).cwiseAbs().maxCoeff();
    rate_rounding_ += std::abs(rate) * contacts_.base.col(s).cwiseAbs().maxCoeff();
  }
  gap_rounding_ *= unit;
  rate_rounding_ *= unit;
}

// Inputs go on by themselves; their rounding does not add up.
void MomentStep::go_on(const Excitation &excitation, double time) {
  for (const std::size_t c : list_) {
    modes_[c] = courses_[c].last_mode();
    set_internal(c, courses_[c].stretches().back(), 1, internal_.data());
  }
  deepest_ = deepest();
  start_ = ends_.back();
  excitation.coordinates(time, start_.data() + phase_->n_modes());
  find_start();
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

void MomentStep::set_internal(std::size_t contact, const CourseStretch &stretch, double x,
                              double *all) const {
  double *own = all + equations_.contacts().pairs()[contact].internal_offset;
  for (const Bernstein &curve : stretch.internal)
    *own++ = curve(x);
}

// From the moments of the listed contacts to the coordinates, and to what the contacts see.
void MomentStep::sweep(const MomentTables &tables) {
  const Index n = equations_.layout().n;
  const auto count = static_cast<Index>(listed_rows_.size());
  ContactRows::RowMatrix moments(count, n_moments);
  for (Index k = 0; k < count; ++k)
    moments.row(k) = moments_.row(listed_rows_[static_cast<std::size_t>(k)]);
  const Matrix forces = packed_.topRows(count).transpose() * moments;
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

// Of the listed rows, at the nodes and the end, and the rates there.
void MomentStep::find_paths() {
  const auto count = static_cast<Index>(listed_rows_.size());
  paths_.noalias() = packed_.topRows(count) * positions_;
  for (Index k = 0; k < count; ++k) {
    const Index row = listed_rows_[static_cast<std::size_t>(k)];
    paths_.row(k).head(n_moments + 1).array() += contacts_.offsets[row];
    for (Index s = 0; s < contacts_.base.cols(); ++s)
      if (const double factor = contacts_.base(row, s); factor != 0) {
        paths_.row(k).head(n_moments + 1) += factor * sources_.row(3 * s);
        paths_(k, n_moments + 1) += factor * sources_(3 * s + 1, n_moments);
      }
  }
}

DirectionCurve MomentStep::curve(Index listed) const {
  const Index row = listed_rows_[static_cast<std::size_t>(listed)];
  PathValues values{.start = start_positions_[row], .start_rate = start_rates_[row]};
  const double *path = paths_.row(listed).data();
  std::copy_n(path, n_moments, values.nodes.begin());
  values.end = path[n_moments];
  values.end_rate = path[n_moments + 1];
  return {values, h_, contacts_.speeds[row]};
}

// False: a mode changes too often.
bool MomentStep::find_forces() {
  Index listed = 0;
  for (const std::size_t c : list_) {
    const contact::ContactPair &pair = equations_.contacts().pairs()[c];
    const auto directions = static_cast<std::size_t>(contacts_.directions(c));
    for (std::size_t d = 0; d < directions; ++d)
      courses_[c].take(d, curve(listed++));
    if (!courses_[c].follow(*pair.law, modes_[c], internal_of(c), {gap_rounding_, rate_rounding_}))
      return false;
    for (std::size_t d = 0; d < directions; ++d) {
      const ContactCourse::Moments moments = courses_[c].moments(*pair.law, d, response_);
      std::copy(moments.begin(), moments.end(),
                moments_.row(contacts_.first(c) + static_cast<Index>(d)).data());
    }
  }
  return true;
}

// At the start.
std::span<const double> MomentStep::internal_of(std::size_t contact) const {
  const contact::ContactPair &pair = equations_.contacts().pairs()[contact];
  return {internal_.data() + pair.internal_offset, static_cast<std::size_t>(pair.n_internal())};
}

void MomentStep::take_list(std::vector<std::size_t> list) {
  list_ = std::move(list);
  listed_rows_.clear();
  for (const std::size_t c : list_)
    for (Index d = 0; d < contacts_.directions(c); ++d)
      listed_rows_.push_back(contacts_.first(c) + d);
  const auto count = static_cast<Index>(listed_rows_.size());
  packed_.resize(std::max(packed_.rows(), count), contacts_.rows.cols());
  for (Index k = 0; k < count; ++k)
    packed_.row(k) = contacts_.rows.row(listed_rows_[static_cast<std::size_t>(k)]);
}

bool MomentStep::open_at_start(std::size_t contact) const {
  return contact::forceless(equations_.contacts()
                                .pairs()[contact]
                                .law->modes()[static_cast<std::size_t>(modes_[contact])]);
}

// Those that may touch: at each node and at the end
//
//   g(x) >= g(0) + h x g'(0) - sum over j of max over c |W_cj| |q_j(x) - q_j(0) - h x v_j(0)|
//
// and the same of moving bases. What remains is the way by which later sweeps differ.
std::vector<std::size_t> MomentStep::within_reach() const {
  const Index n = equations_.layout().n;
  std::array<double, n_moments + 1> curved{};
  for (Index i = 0; i <= n_moments; ++i) {
    const double time = h_ * (i < n_moments ? moment_nodes()[static_cast<std::size_t>(i)] : 1);
    double &sum = curved[static_cast<std::size_t>(i)];
    sum = contacts_.largest.dot(
        (positions_.col(i) - start_rows_.head(n) - time * start_rows_.segment(n, n)).cwiseAbs());
    for (Index s = 0; s < contacts_.base.cols(); ++s)
      sum += contacts_.base.col(s).cwiseAbs().maxCoeff() *
             std::abs(sources_(3 * s, i) - start_rows_[2 * n + 3 * s] -
                      time * start_rows_[2 * n + 3 * s + 1]);
  }
  std::vector<std::size_t> some;
  for (const std::size_t c : all_) {
    const Index row = contacts_.first(c);
    double least = start_positions_[row];
    for (std::size_t i = 0; i <= n_moments; ++i)
      least = std::min(least, start_positions_[row] +
                                  h_ * (i < n_moments ? moment_nodes()[i] : 1) * start_rates_[row] -
                                  curved[i]);
    if (least <= slack_ || !open_at_start(c))
      some.push_back(c);
  }
  return some;
}

// Contacts without force whose gap the way seen so far cannot close are left out.
void MomentStep::choose_list() {
  std::vector<std::size_t> some;
  for (const std::size_t c : list_) {
    const ContactCourse &course = courses_[c];
    if (course.changes() || !open_at_start(c) || course.gap().lower_bound() <= slack_)
      some.push_back(c);
  }
  take_list(std::move(some));
}

// The most that any gap has moved since the first sweep, at the nodes and the end.
double MomentStep::way() const {
  const Matrix moved = (positions_ - first_positions_).leftCols(n_moments + 1).cwiseAbs();
  return (contacts_.largest.transpose() * moved).maxCoeff();
}

std::vector<std::size_t> MomentStep::acting() const {
  std::vector<std::size_t> some;
  for (const std::size_t c : list_)
    if (courses_[c].changes() ||
        moments_.middleRows(contacts_.first(c), contacts_.directions(c)).any())
      some.push_back(c);
  return some;
}

std::optional<double> MomentStep::attempt(double h, const MomentTables &tables) {
  h_ = h;
  moments_.setZero();
  std::vector<std::size_t> closed;
  for (const std::size_t c : all_) {
    if (open_at_start(c))
      continue;
    contact::LocalState local = contacts_.local(c, start_rows_);
    local.internal = internal_of(c);
    equations_.contacts().pairs()[c].law->evaluate(modes_[c], local, response_);
    for (Index d = 0; d < contacts_.directions(c); ++d)
      moments_(contacts_.first(c) + d, 0) = component_force(response_, static_cast<std::size_t>(d));
    closed.push_back(c);
  }
  take_list(std::move(closed));
  double before = std::numeric_limits<double>::infinity();
  Vector last;
  for (int i = 0; i < most_sweeps; ++i) {
    sweep(tables);
    if (i == 0) {
      first_positions_ = positions_;
      take_list(within_reach());
    } else if (list_.size() < all_.size() && way() > slack_) {
      take_list(all_);
      slack_ = room_for_way * way();
    }
    find_paths();
    if (!find_forces())
      return {};
    if (i == 0 && std::isfinite(slack_))
      choose_list();
    const Vector rows = phase_->columns() * ends_.back();
    if (!rows.allFinite())
      return {};
    const bool none = !moments_.any();
    const double change = i == 0 ? before : norm(rows - last);
    const double rate = std::isfinite(before) && before > 0 ? change / before : 0;
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
  const auto count = static_cast<Index>(listed_rows_.size());
  ContactRows::RowMatrix last(count, 2); // of all, of those that change
  Index k = 0;
  for (const std::size_t c : list_)
    for (Index d = 0; d < contacts_.directions(c); ++d, ++k) {
      last(k, 0) = moments_(contacts_.first(c) + d, n_moments - 1);
      last(k, 1) = courses_[c].changes() ? last(k, 0) : 0;
    }
  const Matrix lacking = packed_.topRows(count).transpose() * last;
  Matrix force = Matrix::Zero(n, n_moments);
  force.col(0) = lacking.col(0);
  const Vector response = flow_->response(end, flow_->loads(force).col(0));
  const double unseen =
      h_ * std::sqrt(lacking.col(1).cwiseAbs2().cwiseQuotient(equations_.model().mass()).sum());
  return std::max(norm(phase_->columns() * response), unseen * rate / (2 * n_moments));
}

// Penetration, of the step and before; at a first touch what the speed leads to within the shortest
// time scale [m].
double MomentStep::deepest() const {
  double depth = deepest_;
  for (const std::size_t c : acting()) {
    const Bernstein &gap = courses_[c].gap();
    depth = std::max(depth, -std::min(gap.start(), gap.end()));
    if (courses_[c].changes() && fastest_ > 0)
      depth = std::max(depth, std::abs(start_rates_[contacts_.first(c)]) / fastest_);
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
  constexpr double m = n_moments;
  constexpr double twice = (2 / ((2 * m + 1) * (2 * m + 3)) + 2 / ((2 * m + 1) * (2 * m - 1))) / 4;
  double largest = 0;
  for (const std::size_t c : acting()) {
    const Index row = contacts_.first(c);
    const double lacking =
        h_ * h_ * twice * std::abs(moments_(row, n_moments - 1)) * contacts_.flexibilities[row];
    const double missed = std::abs(contacts_.local(c, rows).gap - courses_[c].gap()(x));
    largest = std::max(largest, lacking + missed);
  }
  return largest / allowed;
}

} // namespace vibroimpact::motion

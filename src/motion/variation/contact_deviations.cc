#include "motion/variation/contact_deviations.h"

#include "motion/episode/phase_episode.h"
#include "motion/variation/contact_map.h"

#include <cmath>

namespace vibroimpact::motion {

namespace {

// Of the length of a part: by so much a contact may differ from it, of which the rest is free.
constexpr double same_length = 1e-6;

std::optional<std::size_t> onset_guard(const LinearPhase &phase, std::size_t contact, int target) {
  const std::vector<PhaseGuard> &guards = phase.forms().guards();
  for (std::size_t g = 0; g < guards.size(); ++g)
    if (guards[g].contact == contact && guards[g].target == target)
      return g;
  return std::nullopt;
}

// The mode from which a touch leads into the present one.
std::optional<int> mode_before(const Equations &equations, std::size_t contact) {
  const std::vector<contact::Mode> &modes = equations.contacts().pairs()[contact].law->modes();
  for (std::size_t m = 0; m < modes.size(); ++m)
    if (!modes[m].in_contact && modes[m].affine && !modes[m].guards.empty() &&
        modes[m].guards[0].target == equations.modes()[contact])
      return static_cast<int>(m);
  return std::nullopt;
}

// Solved from the state at the start of the part; nullptr: not as a whole.
std::unique_ptr<PhaseEpisode> solve(const SmoothPart &part, std::size_t contact, int target,
                                    const Equations &open, ExactPhases &phases, double tolerance) {
  LinearPhase *const linear = phases.take_sources(part.start) ? phases.present() : nullptr;
  const std::optional<std::size_t> guard =
      linear ? onset_guard(*linear, contact, target) : std::nullopt;
  if (!guard)
    return nullptr;
  std::unique_ptr<PhaseEpisode> solved =
      PhaseEpisode::create(open, *linear, *guard, target, tolerance);
  if (!solved)
    return nullptr;
  const ExactPhase &phase = linear->phase();
  std::vector<double> inputs(static_cast<std::size_t>(phases.excitation().size()));
  phases.excitation().coordinates(part.start, inputs.data());
  Amplitudes amplitudes;
  phase.amplitudes(part.start_state.head(phase.n_modes()), inputs.data(), amplitudes);
  const bool whole = !solved->pass(amplitudes.data(), 2 * part.length()) &&
                     std::abs(solved->duration() - part.length()) <= same_length * part.length();
  return whole ? std::move(solved) : nullptr;
}

// What the force adds, in physical states.
Matrix forced_columns(const PhaseEpisode &contact, const ContactMap &map, const Matrix &columns) {
  const ExactPhase &phase = contact.linear().phase();
  const Matrix modal = phase.modal().inverse() * columns;
  Matrix amplitudes = Matrix::Zero(static_cast<Index>(phase.n_amplitudes()), columns.cols());
  for (Index k = 0; k < modal.rows(); ++k)
    amplitudes.row(phase.places()[static_cast<std::size_t>(k)]) = modal.row(k);
  const Matrix forced = map.forced(amplitudes);
  Matrix added(modal.rows(), modal.cols());
  for (Index k = 0; k < modal.rows(); ++k)
    added.row(k) = forced.row(phase.places()[static_cast<std::size_t>(k)]);
  return phase.modal().basis() * added;
}

} // namespace

std::optional<std::size_t> contact_episode(const Equations &equations) {
  std::optional<std::size_t> only;
  for (std::size_t c = 0; c < equations.contacts().size(); ++c) {
    const contact::Mode &mode = equations.mode(c);
    if (mode.affine && !mode.holds_gap)
      continue;
    const contact::ContactPair &pair = equations.contacts().pairs()[c];
    if (only || mode.holds_gap || pair.n_directions() > 1 ||
        !pair.law->force_pulse(equations.modes()[c]) || pair.n_internal() > 0)
      return std::nullopt;
    only = c;
  }
  return only;
}

std::optional<double> pass_contact_episode(const SmoothPart &part, std::size_t contact,
                                           Equations &equations, ExactPhases &phases,
                                           double tolerance, Matrix &columns) {
  const int target = equations.modes()[contact];
  const std::optional<int> before = mode_before(equations, contact);
  if (!part.from_event || !part.to_event || !before)
    return std::nullopt;
  equations.set_mode(contact, *before);
  const std::unique_ptr<PhaseEpisode> solved =
      solve(part, contact, target, equations, phases, tolerance);
  equations.set_mode(contact, target);
  if (!solved)
    return std::nullopt;
  const ContactMap map(solved->solution(), solved->output(), solved->before().data());
  const Matrix forced = forced_columns(*solved, map, columns);
  LinearFlow flow(solved->linear());
  flow.propagate(solved->duration(), columns);
  columns += forced;
  flow.propagate(part.length() - solved->duration(), columns);
  return flow.divergence() * part.length() + map.divergence();
}

} // namespace vibroimpact::motion

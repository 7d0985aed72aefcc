// What a file would cost, without running it.
#include "analyses/run/constants.h"
#include "common/log.h"
#include "common/memory.h"
#include "common/work_limit.h"
#include "simulation.h"

#include <algorithm>

namespace vibroimpact {

using analyses::Cost;
using analyses::duration_text;

namespace {

// Of processor time [s].
constexpr double longest_reduction_in_check = 7;
constexpr double longest_trial = 2.5;  // of all analyses together
constexpr double shortest_trial = 0.2; // of those that are left, whatever their set-up took
constexpr double longest_run_without_warning = 3600;

void warn_of_cost(const Cost &total, double memory) {
  if (total.seconds > longest_run_without_warning)
    log::warning(
        std::string("a run takes ") + (total.at_least ? "more than " : "about ") +
        duration_text(total.seconds) +
        " on one core; the ranks of mpirun share the points of sweeps, grids and searches");
  if (const std::string lack = lack_of_memory(memory); !lack.empty())
    log::warning(lack);
}

} // namespace

// Rank 0 tries for so many seconds at most; the others have nothing to do.
Cost Simulation::log_cost(const Job &job, double seconds) const {
  const Cost cost = analyses::estimate_cost(
      job.keys,
      [&](const std::vector<parameters::Override> &overrides) {
        return build_case(job, overrides);
      },
      seconds);
  log::info("analysis " + job.name + ": " + cost.sentence());
  return cost;
}

// The results of one analysis at a time are put together.
void Simulation::log_costs(const std::vector<Job> &jobs) const {
  const double so_far = processor_seconds();
  Cost total{.seconds = so_far};
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const Cost cost =
        log_cost(jobs[i], std::max(shortest_trial, so_far + longest_trial - processor_seconds()) /
                              static_cast<double>(jobs.size() - i));
    total.seconds += cost.seconds;
    total.at_least = total.at_least || cost.at_least;
    total.memory = std::max(total.memory, cost.memory);
    total.memory_known = total.memory_known && cost.memory_known;
  }
  const double memory = peak_memory() + total.memory;
  log::info(std::string("in all ") + (total.at_least ? "more than " : "about ") +
            duration_text(total.seconds) + " on one core, " + duration_text(so_far) +
            " of them for the bodies and before; " +
            (total.memory_known ? "about " : "more than ") + memory_text(memory) + " of memory");
  warn_of_cost(total, memory);
}

void Simulation::check() {
  const std::vector<Job> all = jobs();
  derived_quantities(all);
  int rank = 0;
  MPI_Comm_rank(communicator_, &rank);
  {
    const EndAtLimit limit(longest_reduction_in_check,
                           "The keys of the file are good. Its bodies take longer to reduce than a "
                           "check may, so that contacts, analyses and cost are not checked; the "
                           "run itself checks them before it computes anything.",
                           rank == 0);
    reduce_all(all);
  }
  for (const auto &body : bodies(parameters_->root()))
    log::info("body " + body->name + ": " +
              analyses::body_sentence(*body, parameters_->dimensionless()));
  for (const Job &job : all)
    check_cases(job);
  try_evaluated(all);
  warn_of_unused_laws(all);
  contacts_of(all);
  if (rank == 0)
    log_costs(all);
}

} // namespace vibroimpact

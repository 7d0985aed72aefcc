// Messages for the person at the terminal: rank 0 only, also kept for the run's log file.
#pragma once

#include <string>

namespace vibroimpact::log {

/// Only rank 0 prints. Called once after MPI has started.
void set_rank(int rank);
/// Everything printed is also appended to this file; an empty name closes it.
void open_file(const std::string &file);

void info(const std::string &message);
/// A doubt about the input or the results that does not stop the run; begins with "warning: ".
void warning(const std::string &message);

} // namespace vibroimpact::log

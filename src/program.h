// The program from its command line to its exit code.
#pragma once

namespace vibroimpact {

/// Starts the libraries, performs what the command line says and closes the libraries again: at
/// most once in a process, and before anything else uses MPI or PETSc. What goes wrong becomes one
/// message on rank 0. Returns the exit code of the process, as described by usage().
int run_program(int argc, char **argv);

} // namespace vibroimpact

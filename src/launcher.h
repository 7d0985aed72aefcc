// Whether a launcher such as mpirun started this process, and what MPI need not do where none did.
#pragma once

namespace vibroimpact {

/// True when mpirun, srun or another launcher started this process as one of a group. False for a
/// process started by itself, in a batch job too.
bool started_by_launcher();

/// Lets Open MPI start a process without launcher in some hundredths of a second instead of half a
/// second: without the daemon that only spawned processes need, and without a search for networks.
/// Environment variables that are set already are left alone. To be called before MPI starts.
void prepare_single_process();

} // namespace vibroimpact

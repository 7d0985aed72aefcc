#!/usr/bin/env bash
# A job for a cluster with Slurm and Open MPI, started from the top folder of the project:
#
#   sbatch scripts/slurm-job.sh params/impacting-beams.prm [options of vibroimpact]
#
# One rank for each core; the sweeps and grids of the file are shared out over the ranks. A job that
# ran into its time limit is gone on with by
#
#   sbatch scripts/slurm-job.sh --resume output/impacting-beams
#SBATCH --job-name=vibroimpact
#SBATCH --nodes=2
#SBATCH --ntasks-per-node=32
#SBATCH --cpus-per-task=1
#SBATCH --mem-per-cpu=1G
#SBATCH --time=04:00:00
#SBATCH --output=vibroimpact-%j.log
# Five minutes before the end every rank gets a signal: it finishes the case at hand and keeps it.
#SBATCH --signal=TERM@300
set -euo pipefail
cd "$SLURM_SUBMIT_DIR"

export OPENBLAS_NUM_THREADS=1
# Where Slurm was built without PMIx: mpirun build/vibroimpact "$@"
srun --mpi=pmix build/vibroimpact "$@"

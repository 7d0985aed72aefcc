# shellcheck shell=bash
# To be sourced before mpirun: lets Open MPI run as root and with more ranks than cores, both of
# which it otherwise refuses, and holds BLAS to one thread for each rank.
if [[ $(id -u) == 0 ]]; then
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
fi
export OMPI_MCA_rmaps_base_oversubscribe=1
export OPENBLAS_NUM_THREADS=1
# Containers often forbid the copy between processes that Open MPI would use on one machine.
export OMPI_MCA_btl_vader_single_copy_mechanism=none

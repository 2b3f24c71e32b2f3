# SPDX-License-Identifier: Apache-2.0
# shellcheck disable=SC2034,SC2154  # shared with the script that sources it
# Settings of a site. Copy this file to slurm/sites/NAME.sh, change it, and use
# it with `slurm/submit --site NAME`. slurm/submit reads it where you are, and
# every job where it runs.

# Software that ideotype was built with.
# module purge
# module load gcc/12 openmpi/4.1 hdf5/1.10 embree/3.13

# For sbatch. Take a whole node, or as many cores as are to work and one task
# more for rank 0, which sleeps.
sbatch_options=(--ntasks=3 --time=01:00:00)
# sbatch_options=(--account=ABC --partition=standard --time=12:00:00
#     --nodes=2 --ntasks-per-node=64 --mem-per-cpu=1G)

# The launcher starts the ranks: Open MPI's own, or SLURM if it has PMIx (`srun
# --mpi=list`).
launcher=(mpirun)
# launcher=(srun --mpi=pmix)
# launcher=(srun --mpi=pmi2)  # MPICH

# Where the histories go: a folder that all nodes see, with room and without a
# cleaner that removes old files.
out=results
# out=$SCRATCH/ideotype

# At most so many tasks of an array at once; empty for no limit.
throttle=

# SLURM's signal comes so many seconds before the time limit. Give it several
# evaluations and a minute.
lead=120

# Ranks are single threads and need not be tied to cores. Tie them
# (`core`) only where jobs do not share nodes.
export OMPI_MCA_hwloc_base_binding_policy=none
export PRTE_MCA_hwloc_default_binding_policy=none  # Open MPI 5

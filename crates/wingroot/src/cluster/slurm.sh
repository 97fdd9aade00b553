#!/usr/bin/env bash
# A sweep as three jobs of Slurm that wait for each other: prepare, an array of @PARTS@ parts, merge. Start it with `bash THIS_FILE`
# in the folder from which the paths below hold, on a file system that all machines see.
#
#   wingroot @LINE@
#
@ESTIMATE@
set -eu

# The program, if it is not on the PATH of the machines: WINGROOT=/path/to/wingroot bash THIS_FILE
wingroot=${WINGROOT:-wingroot}
# Options of your site, such as --partition or --account: SBATCH_MORE="--account=me" bash THIS_FILE
submit() { sbatch --parsable --export=ALL,WINGROOT_PARTS=@PARTS@ --mem=@MEMORY_MB@M ${SBATCH_MORE:-} "$@"; }

# What all parts share, and every fault of the input, before many machines begin.
prepare=$(submit --job-name=wingroot-prepare --cpus-per-task=1 --time=@PREPARE_MINUTES@ --wrap "$wingroot prepare @LINE@")

# Which part an element is it reads from its environment. A part that is killed with its machine is queued again (--requeue) and goes on
# with what it has not finished.
array() {
  submit --job-name=wingroot-part --array=0-@LAST@ --cpus-per-task=@CPUS@ --time=@PART_MINUTES@ --requeue "$@" \
    --wrap "$wingroot @LINE@ --threads @CPUS@"
}
parts=$(array --dependency="afterok:$prepare" --kill-on-invalid-dep=yes)

# If an element failed, the array once more: elements that are done find nothing to do.
again=$(array --dependency="afterok:$prepare,afternotok:$parts" --kill-on-invalid-dep=yes)

# Results, when the first or the second array is complete; names what is missing if something is.
merge=$(submit --job-name=wingroot-merge --cpus-per-task=1 --time=@PREPARE_MINUTES@ --kill-on-invalid-dep=yes \
  --dependency="afterok:$parts?afterok:$again" --wrap "$wingroot merge @LINE@")

echo "prepare $prepare, parts $parts (again $again), merge $merge; how far it is: $wingroot status @LINE@"

#!/usr/bin/env bash
# The shipped sweep on a Slurm of one node: `sweep_on_slurm.sh WINGROOT FOLDER`, from the top of the repository. The script of `wingroot
# cluster slurm` submits prepare, eight parts and merge; one part is killed and queued again while it runs. Results are compared with those
# of one process, byte for byte.
set -euo pipefail
export WINGROOT=$1
folder=$(realpath -m "$2")
here=$(cd "$(dirname "$0")" && pwd)
sweep=(fullaircraft --cases data/tuflex/cases.ron --aircraft data/tuflex/aircraft.ron --out "$folder/parts")

mkdir -p "$folder"
trap '"$here/slurm_of_one_node.sh" stop "$folder/slurm"' EXIT
eval "$("$here/slurm_of_one_node.sh" start "$folder/slurm")"

"$WINGROOT" fullaircraft --cases data/tuflex/cases.ron --aircraft data/tuflex/aircraft.ron --out "$folder/whole" --quiet
"$WINGROOT" cluster slurm --parts 8 --cpus 1 "${sweep[@]}" > "$folder/sweep.sh"
said=$(SBATCH_MORE="--output=$folder/%A_%a.log" bash "$folder/sweep.sh")
echo "$said"
parts=$(sed -n 's/.*parts \([0-9]*\).*/\1/p' <<< "$said")
merge=$(sed -n 's/.*merge \([0-9]*\);.*/\1/p' <<< "$said")

requeued=no
for _ in $(seq 600); do
  running=$(squeue --noheader --states=RUNNING --jobs="$parts" --format=%i | head -n 1 || true)
  if [ "$requeued" = no ] && [ -n "$running" ]; then
    scontrol requeue "$running"
    requeued=$running
  fi
  left=$(squeue --noheader --jobs="$merge" --format=%T 2>/dev/null || true)
  [ -z "$left" ] || [ "$left" = COMPLETED ] && break
  sleep 1
done
echo "killed and queued again: $requeued"
[ "$requeued" != no ] || { echo "no part could be killed" >&2; exit 1; }
diff -r "$folder/whole" "$folder/parts"
echo "the results of eight parts are those of one process, byte for byte"

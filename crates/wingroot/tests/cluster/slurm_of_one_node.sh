#!/usr/bin/env bash
# A Slurm of one node that listens on this machine alone: `slurm_of_one_node.sh start FOLDER` prints what a shell needs to use it, `stop
# FOLDER` ends it. Needs Debian's slurm-wlm and munge, and whoever may start them (root in a container). Paths in the configuration are
# absolute, as the controller leaves its folder.
set -euo pipefail
what=$1
folder=$(realpath -m "$2")
node=$(hostname -s)

end() {
  for daemon in slurmd slurmctld munged; do
    if [ -f "$folder/run/$daemon.pid" ]; then
      kill "$(cat "$folder/run/$daemon.pid")" 2>/dev/null || true
    fi
  done
}

configure() {
  mkdir -p "$folder"/{run,state,spool,log}
  # the key must belong to whoever starts munged, and to nobody else
  (umask 077 && head -c 1024 /dev/urandom > "$folder/munge.key")
  cat > "$folder/slurm.conf" <<CONF
ClusterName=one
SlurmctldHost=$node(127.0.0.1)
SlurmctldPort=16817
SlurmdPort=16818
SlurmUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$folder/run/munge.socket
CryptoType=crypto/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/run/slurmctld.pid
SlurmdPidFile=$folder/run/slurmd.pid
SlurmctldLogFile=$folder/log/slurmctld.log
SlurmdLogFile=$folder/log/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=batch_sched_delay=1,sched_interval=2
ReturnToService=2
MailProg=/bin/true
NodeName=$node NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=6000 State=UNKNOWN
PartitionName=all Nodes=$node Default=YES MaxTime=INFINITE State=UP
CONF
}

case $what in
  stop) end ;;
  start)
    configure
    /usr/sbin/munged --force --key-file="$folder/munge.key" --socket="$folder/run/munge.socket" \
      --pid-file="$folder/run/munged.pid" --log-file="$folder/log/munged.log" --seed-file="$folder/run/munged.seed" >&2
    /usr/sbin/slurmctld -f "$folder/slurm.conf" >&2
    sleep 2
    /usr/sbin/slurmd -f "$folder/slurm.conf" >&2
    sleep 2
    echo "export SLURM_CONF=$folder/slurm.conf"
    ;;
  *) echo "expected start or stop" >&2; exit 2 ;;
esac

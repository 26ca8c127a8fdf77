# slurm.bash - a Slurm of our own on this machine, for tests; all its state is under a folder.

slurm_there() {
	PATH=$PATH:/usr/sbin
	for p in munged slurmctld slurmd sbatch; do
		command -v $p >/dev/null || return 1
	done
}

# slurm_up FOLDER NODES: starts the daemons, NODES nodes of one processor each, and waits for them.
slurm_up() {
	local dir=$1 nodes=$2 host user port
	host=$(hostname -s) user=$(id -un) port=$((20000 + $$ % 10000))
	mkdir -p "$dir"/{run,log,state,spool}
	chmod 755 "$dir" "$dir"/*
	(umask 077; head -c 128 /dev/urandom >"$dir/munge.key")
	cat >"$dir/slurm.conf" <<-C
		ClusterName=lhgrid
		SlurmctldHost=$host(127.0.0.1)
		SlurmctldPort=$port
		SlurmUser=$user
		SlurmdUser=$user
		AuthType=auth/munge
		AuthInfo=socket=$dir/run/munge.sock
		CredType=cred/munge
		CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
		MpiDefault=none
		ProctrackType=proctrack/linuxproc
		TaskPlugin=task/none
		JobAcctGatherType=jobacct_gather/none
		AccountingStorageType=accounting_storage/none
		SelectType=select/cons_tres
		SelectTypeParameters=CR_CPU
		SchedulerType=sched/backfill
		SchedulerParameters=batch_sched_delay=0,sched_interval=1,bf_interval=1,sched_min_interval=0
		ReturnToService=2
		SlurmctldPidFile=$dir/run/slurmctld.pid
		SlurmdPidFile=$dir/run/slurmd.%n.pid
		StateSaveLocation=$dir/state
		SlurmdSpoolDir=$dir/spool/%n
		SlurmctldLogFile=$dir/log/slurmctld.log
		SlurmdLogFile=$dir/log/slurmd.%n.log
		SlurmdTimeout=10
		KillWait=2
		MaxArraySize=10001
		NodeName=n[1-$nodes] NodeHostname=$host NodeAddr=127.0.0.1 Port=[$((port + 1))-$((port + nodes))] CPUs=1 RealMemory=500 State=UNKNOWN
		PartitionName=main Nodes=n[1-$nodes] Default=YES MaxTime=INFINITE State=UP
	C
	munged --key-file="$dir/munge.key" --socket="$dir/run/munge.sock" --pid-file="$dir/run/munged.pid" \
	    --log-file="$dir/log/munged.log" --seed-file="$dir/run/munge.seed" 3>&-
	export SLURM_CONF=$dir/slurm.conf
	slurmctld -c 3>&-
	for i in $(seq "$nodes"); do
		slurmd -N "n$i" 3>&-
	done
	for i in $(seq 100); do
		[ "$(sinfo -h -N -o %t 2>/dev/null | sort -u)" != idle ] || return 0
		sleep 0.2
	done
	echo "the nodes are not idle"
	return 1
}

# slurm_kill_node FOLDER NODE: the node is gone at once, with all that runs on it; the daemons of
# Slurm first, so that none of them tells what happened.
slurm_kill_node() {
	local p steps='' jobs=''
	for p in /proc/[0-9]*; do
		tr '\0' '\n' 2>/dev/null <"$p/environ" | grep -qx "SLURMD_NODENAME=$2" || continue
		tr '\0' '\n' 2>/dev/null <"$p/environ" | grep -qx "SLURM_CONF=$1/slurm.conf" || continue
		jobs+=" ${p#/proc/}"
		p=$(sed 's/.*) . \([0-9]*\) .*/\1/' "$p/stat")
		! grep -q slurmstepd "/proc/$p/comm" || steps+=" $p"
	done 2>/dev/null
	kill -9 "$(cat "$1/run/slurmd.$2.pid")" $steps
	kill -9 $jobs 2>/dev/null || :
}

# slurm_down FOLDER: stops the daemons that slurm_up FOLDER started, and waits until they have ended.
slurm_down() {
	local f i pid
	for f in "$1"/run/slurmd.*.pid "$1/run/slurmctld.pid" "$1/run/munged.pid"; do
		pid=$(cat "$f" 2>/dev/null) && kill "$pid" 2>/dev/null || continue
		for i in $(seq 100); do
			kill -0 "$pid" 2>/dev/null || break
			sleep 0.1
		done
	done
}

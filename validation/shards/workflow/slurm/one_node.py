#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A Slurm of one node on this machine, for as long as a command runs: one_node.py COMMAND …

Its daemons, ports, key and files are its own, and all are gone afterwards. It needs root, Debian's slurmctld, slurmd, slurm-client
and munge, and nothing of systemd or cgroups.
"""
import contextlib
import ctypes
import os
import pathlib
import secrets
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scancel", "scontrol")
NODE = socket.gethostname().partition(".")[0]
CONFIGURATION = """ClusterName=one
SlurmctldHost={node}(127.0.0.1)
SlurmctldPort={controller}
SlurmdPort={daemon}
SlurmUser=root
AuthInfo=socket={folder}/munge/socket
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU_Memory
SchedulerParameters=sched_interval=1
MailProg=/bin/true
PlugStackConfig=/dev/null
KillWait=2
MinJobAge={forgets}
ReturnToService=2
NodeName={node} NodeAddr=127.0.0.1 CPUs={cpus} RealMemory={memory}
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""
_libc = ctypes.CDLL(None)


def missing(*more):
    """Programs that are not installed."""
    path = os.environ["PATH"] + ":/usr/sbin:/sbin"
    return [name for name in (*PROGRAMS, *more) if shutil.which(name, path=path) is None]


def _prctl(option, value):
    _libc.prctl(option, value, 0, 0, 0)


def _free_ports(count):
    with contextlib.ExitStack() as sockets:
        taken = [sockets.enter_context(socket.socket()) for _ in range(count)]
        for one in taken:
            one.bind(("127.0.0.1", 0))
        return [one.getsockname()[1] for one in taken]


def _children(pid):
    found = []
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        with contextlib.suppress(OSError):
            if int(stat.read_text().rpartition(")")[2].split()[1]) == pid:
                found.append(int(stat.parent.name))
    return found


def end_children(grace=3.0):
    """All of them, those that orphans left too, as they are ours (a subreaper's)."""
    for number in (signal.SIGTERM, signal.SIGKILL):
        until = time.monotonic() + grace
        while children := _children(os.getpid()):
            for pid in children:
                with contextlib.suppress(OSError):
                    os.kill(pid, number)
            with contextlib.suppress(ChildProcessError):
                while os.waitpid(-1, os.WNOHANG)[0]:
                    pass
            if time.monotonic() > until:
                break
            time.sleep(0.05)


class OneNode:
    """With it, `environment` is that of commands which speak to it. A forgotten job: `forgets` s after its end."""

    def __init__(self, forgets=300):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="stiction-slurm-"))
        self.environment = {name: value for name, value in os.environ.items() if not name.startswith(("SLURM_", "SBATCH_"))}
        self.environment.update(SLURM_CONF=str(self.folder / "slurm.conf"), PATH=os.environ["PATH"] + ":/usr/sbin:/sbin")
        self.forgets = forgets

    def __enter__(self):
        try:
            self._start()
        except BaseException:
            self.__exit__()
            raise
        return self

    def _start(self):
        _prctl(36, 1)  # PR_SET_CHILD_SUBREAPER
        self.folder.chmod(0o755)
        for name in ("munge", "state", "spool"):
            (self.folder / name).mkdir(mode=0o755)
        key = self.folder / "munge/key"
        key.touch(mode=0o600)
        key.write_bytes(secrets.token_bytes(128))
        controller, daemon = _free_ports(2)
        memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") // 2**20
        (self.folder / "slurm.conf").write_text(CONFIGURATION.format(
            node=NODE, folder=self.folder, controller=controller, daemon=daemon, cpus=os.cpu_count(), memory=memory * 9 // 10, forgets=self.forgets))
        munge = [f"--{name}={self.folder / 'munge' / file}" for name, file in
                 (("socket", "socket"), ("key-file", "key"), ("pid-file", "pid"), ("log-file", "log"), ("seed-file", "seed"))]
        self._daemon("munged", "--foreground", "--force", *munge)
        self._wait(lambda: (self.folder / "munge/socket").exists(), "munged does not start")
        self._daemon("slurmctld", "-D")
        self._daemon("slurmd", "-D")
        self._wait(lambda: "State=IDLE" in self.told("scontrol", "show", "node", "--oneliner"), "the node does not come up")

    def _daemon(self, name, *words):
        with (self.folder / f"{name}.out").open("w") as out:
            # When this process is killed, they end too.
            subprocess.Popen([name, *words], env=self.environment, stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.STDOUT,
                             cwd=self.folder, start_new_session=True, preexec_fn=lambda: _prctl(1, signal.SIGKILL))

    def _wait(self, true, words):
        until = time.monotonic() + 30
        while not true():
            if time.monotonic() > until:
                logs = "\n".join(file.read_text()[-1000:] for file in sorted(self.folder.glob("*.out")) + sorted(self.folder.glob("*.log")))
                raise RuntimeError(f"{words}:\n{logs}")
            time.sleep(0.1)

    def told(self, *words):
        return subprocess.run(words, env=self.environment, capture_output=True, text=True, timeout=60).stdout

    def __exit__(self, *_):
        for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
            signal.signal(number, signal.SIG_IGN)  # what ends now ends whole
        with contextlib.suppress(subprocess.SubprocessError, OSError):
            subprocess.run(["scancel", "--signal=KILL", "--full", "--user=root"], env=self.environment, capture_output=True, timeout=10)
        end_children()
        shutil.rmtree(self.folder, ignore_errors=True)


def end_on_signals():
    """So that what stands in `with` is cleaned up."""
    for number in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, lambda number, _: sys.exit(128 + number))


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    if lacking := missing():
        sys.exit(f"one_node: not installed: {', '.join(lacking)}")
    end_on_signals()
    with OneNode() as slurm:
        return subprocess.call(sys.argv[1:], env=slurm.environment)


if __name__ == "__main__":
    sys.exit(main())

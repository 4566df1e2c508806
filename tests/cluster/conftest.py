"""Slurm on this machine alone: controller, daemon and key service on the loopback, gone after the tests."""

import os
import shutil
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PACKAGES = ("slurm-wlm", "munge")
# Nowhere else: the plugin removes SLURM_CONF from the environment of its jobs.
CONFIGURATION = Path("/etc/slurm/slurm.conf")

SETTINGS = """\
ClusterName=loopback
SlurmctldHost=localhost(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge/socket
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
SchedulerParameters=batch_sched_delay=0,sched_interval=1
EnforcePartLimits=ALL
ReturnToService=2
KillWait=5
NodeName=localhost NodeAddr=127.0.0.1 CPUs={processors} RealMemory={memory}
PartitionName=main Nodes=localhost Default=YES MaxTime=INFINITE State=UP
"""


class Loopback:
    """A cluster of one node."""

    def __init__(self, folder: Path):
        self.folder = folder
        self.daemons = []
        for name in ("munge", "state", "spool"):
            (folder / name).mkdir(parents=True)
        folder.chmod(0o711)
        (folder / "munge" / "key").write_bytes(os.urandom(1024))
        (folder / "munge" / "key").chmod(0o400)

    def start(self) -> None:
        memory = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") // 2**20
        values = {"folder": self.folder, "ports": free_ports(2), "memory": int(0.9 * memory)}
        CONFIGURATION.parent.mkdir(exist_ok=True)
        CONFIGURATION.write_text(SETTINGS.format(**values, processors=os.cpu_count()))
        munge = self.folder / "munge"
        files = {name: f"--{name}-file={munge / name}" for name in ("key", "log", "pid", "seed")}
        self.daemon("munged", "--foreground", "--force", f"--socket={munge / 'socket'}", *files.values())
        self.wait_for("no key service", lambda: (munge / "socket").exists())
        self.daemon("slurmctld", "-D")
        self.daemon("slurmd", "-D", "-N", "localhost")
        self.wait_for("the node does not become idle", lambda: "idle" in self.ask("sinfo", "-h", "-o", "%T"))

    def daemon(self, *command: str) -> None:
        with open(self.folder / f"{command[0]}.log", "w") as log:
            # Ended with the tests, even if these are killed.
            pinned = ["setpriv", "--pdeathsig", "TERM", *command]
            self.daemons.append(subprocess.Popen(pinned, stdout=log, stderr=log, stdin=subprocess.DEVNULL))

    def ask(self, *command: str) -> str:
        return subprocess.run(command, capture_output=True, text=True, check=False).stdout

    def jobs(self) -> list[str]:
        """The jobs in the queue, running or waiting, as `squeue` lists them."""
        return self.ask("squeue", "-h", "-o", "%i %t %j").splitlines()

    def wait_for(self, what: str, happened, seconds: float = 60) -> None:
        end = time.monotonic() + seconds
        while not happened():
            if time.monotonic() > end:
                logs = "".join(path.read_text()[-2000:] for path in sorted(self.folder.glob("*.log")))
                raise TimeoutError(f"slurm: {what} within {seconds} s\n{logs}")
            time.sleep(0.2)

    def stop(self) -> None:
        try:
            self.ask("scancel", "--user=root")
            self.wait_for("jobs do not end", lambda: not self.jobs(), 30)
        finally:
            for daemon in reversed(self.daemons):
                daemon.send_signal(signal.SIGTERM)
                try:
                    daemon.wait(20)
                except subprocess.TimeoutExpired:
                    daemon.kill()
                    daemon.wait()
            CONFIGURATION.unlink(missing_ok=True)


def free_ports(count: int) -> list[int]:
    held = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [one.getsockname()[1] for one in held]
    for one in held:
        one.close()
    return ports


def hindrance() -> str:
    """Why there can be no Slurm here; empty if there can."""
    if os.getuid() != 0:
        return "starts the daemons of Slurm, which needs root"
    if CONFIGURATION.exists():
        return f"this machine has a Slurm of its own: {CONFIGURATION}"
    if shutil.which("slurmctld") and shutil.which("munged"):
        return ""
    if not shutil.which("apt-get"):
        return "no Slurm here, and no apt-get to install it"
    quiet = {"env": os.environ | {"DEBIAN_FRONTEND": "noninteractive"}, "capture_output": True, "text": True}
    for command in (["update"], ["install", "-y", "--no-install-recommends", *PACKAGES]):
        done = subprocess.run(["apt-get", "-q", *command], check=False, **quiet)
        if done.returncode != 0:
            return f"apt-get {' '.join(command)} failed: {done.stderr.strip()[-300:]}"
    return ""


@pytest.fixture(scope="session")
def slurm(request, tmp_path_factory):
    """A running cluster of one node."""
    if not request.config.getoption("--cluster"):
        pytest.skip("installs and starts Slurm, asked for by ./run tests --cluster")
    if reason := hindrance():
        pytest.skip(reason)
    cluster = Loopback(tmp_path_factory.mktemp("slurm"))
    try:
        cluster.start()
        yield cluster
    finally:
        cluster.stop()


@pytest.fixture(scope="session")
def submitter(slurm, tmp_path_factory):
    """The Python of an environment with the plugin: that of the tests, and profiles/slurm/requirements.lock on top."""
    folder = tmp_path_factory.mktemp("submitter")
    subprocess.run([sys.executable, "-m", "venv", folder], check=True)
    (layer,) = folder.glob("lib/python*/site-packages")
    below = [path for path in sys.path if path.endswith("site-packages")]
    (layer / "below.pth").write_text("\n".join([*below, str(ROOT / "src")]) + "\n")
    lock = ROOT / "profiles" / "slurm" / "requirements.lock"
    pip = [folder / "bin" / "python", "-m", "pip", "install", "-q", "--disable-pip-version-check"]
    done = subprocess.run([*pip, "--require-hashes", "-r", lock], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        pytest.skip(f"the plugin cannot be installed: {done.stderr.strip()[-300:]}")
    return folder / "bin" / "python"

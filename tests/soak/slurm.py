#!/usr/bin/env python3
"""slurm.py PROGRAM: draws films with Slurm on this machine, as root, with a configuration of its own.

Checks the frames against a single run, and parts that fail: those that succeed later, and one that never does. Then
measures two workers against one, with Slurm and with GNU parallel. The services end with the script.
"""

import os
import shutil
import socket
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

LEAST_EFFICIENCY = 0.9
# A short history, and a film whose drawing takes far longer than the start of a part.
FADING = ("phosphor", "--set", "decay=0.8", "--size", "320x240", "--fps", "30", "--frames", "300")
HEAVY = ("composite-video", "--size", "640x480", "--frames", "320")
PER_JOB = 40
ROUNDS = 3


def configuration(folder):
    cpus = os.cpu_count()
    return f"""ClusterName=test
SlurmctldHost={socket.gethostname()}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=5
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
SlurmctldPort=16817
SlurmdPort=16818
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=batch_sched_delay=0,sched_min_interval=0,bf_interval=1
ReturnToService=2
NodeName={socket.gethostname()} CPUs={cpus} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


class Slurm:
    """Munge, slurmctld and slurmd on this machine, until the end of the block."""

    def __init__(self, folder):
        self.folder = folder
        self.processes = []
        for name in ("state", "spool"):
            (folder / name).mkdir()
        (folder / "munge.key").write_bytes(os.urandom(128))
        (folder / "munge.key").chmod(0o400)
        (folder / "slurm.conf").write_text(configuration(folder))
        self.environment = dict(os.environ, SLURM_CONF=str(folder / "slurm.conf"))

    def __enter__(self):
        folder = self.folder
        self.begin("munged", "--foreground", "--force", f"--socket={folder}/munge.socket",
                   f"--key-file={folder}/munge.key", f"--pid-file={folder}/munge.pid",
                   f"--log-file={folder}/munge.log", f"--seed-file={folder}/munge.seed")
        self.wait_until(lambda: (folder / "munge.socket").exists(), "munge")
        self.begin("slurmctld", "-D")
        self.begin("slurmd", "-D")
        self.wait_until(lambda: "idle" in self.told("sinfo", "--noheader", "--format=%T"), "Slurm")
        return self

    def __exit__(self, *_):
        for process in reversed(self.processes):
            process.terminate()
            process.wait()

    def begin(self, *command):
        log = (self.folder / f"{command[0]}.txt").open("w")
        self.processes.append(subprocess.Popen(command, env=self.environment, stdout=log, stderr=log))

    def wait_until(self, is_ready, name):
        for _ in range(150):
            if is_ready():
                return
            time.sleep(0.2)
        logs = "".join(file.read_text() for file in self.folder.glob("*.log"))
        sys.exit(f"{name} did not start:\n{logs}")

    def told(self, *command):
        return subprocess.run(command, env=self.environment, capture_output=True, text=True, check=False).stdout


class Farm:
    """A film in parts; a stand-in for the program can make parts fail."""

    def __init__(self, program, folder, slurm, engine="slurm"):
        self.program, self.folder, self.slurm, self.engine = program, folder, slurm, engine
        (folder / "bin").mkdir(parents=True)
        self.stand_in("")

    def stand_in(self, text):
        file = self.folder / "bin/afterglow"
        file.write_text(f"#!/bin/sh\n{text}\nexec {self.program} \"$@\"\n")
        file.chmod(0o755)

    def split(self, film, per_job, *more):
        subprocess.run([self.program, "jobs", *film, "--frames-per-job", str(per_job), "--for", self.engine,
                        "-o", self.folder / "farm", *more], check=True, stdout=subprocess.DEVNULL)

    def draw(self, *options, limit=1500):
        """Seconds until all jobs have ended."""
        environment = dict(self.slurm.environment, LP_NUM_THREADS="1", LIBGL_ALWAYS_SOFTWARE="1",
                           PATH=f"{self.folder / 'bin'}:{os.environ['PATH']}")
        begin = time.monotonic()
        subprocess.run([self.folder / "farm/run", *options], env=environment, check=True, stdout=subprocess.DEVNULL)
        while self.engine == "slurm":
            states = self.slurm.told("squeue", "--noheader", "--array", "--format=%T %r").splitlines()
            if all("DependencyNeverSatisfied" in state for state in states):
                break
            if time.monotonic() - begin > limit:
                sys.exit("the jobs did not end: " + "; ".join(states))
            time.sleep(0.1)
        return time.monotonic() - begin


def largest_difference(one, other):
    """Of any channel of two PNGs, in 8-bit steps."""
    pixels = [subprocess.run(["ffmpeg", "-v", "error", "-i", file, "-f", "rawvideo", "-pix_fmt", "rgb24", "-"],
                             check=True, capture_output=True).stdout for file in (one, other)]
    assert len(pixels[0]) == len(pixels[1]) > 0
    return 0 if pixels[0] == pixels[1] else max(abs(a - b) for a, b in zip(*pixels))


def check_frames(program, folder, slurm):
    """The frames of a film in parts, and its join."""
    farm = Farm(program, folder / "frames", slurm)
    film = farm.folder / "film.mkv"
    farm.split(FADING, 100, "--join", film)
    farm.draw()
    assert film.exists(), "the join did not run"
    whole = folder / "whole"
    subprocess.run([program, "render", *FADING, "-o", whole / "%04d.png"], check=True)
    frames = sorted(whole.iterdir())
    assert len(frames) == 300
    largest = max(largest_difference(file, farm.folder / "farm/frames" / file.name) for file in frames)
    print(f"largest difference to a single run: {largest}/255 (at most 1)", flush=True)
    assert largest <= 1


def words(times):
    return ", ".join(f"{time:.1f}" for time in times)


def efficiency(program, folder, slurm, engine):
    """The time of one worker, in parts of twice the time of two workers: the medians of rounds that alternate both."""
    seconds = {1: [], 2: []}
    one, two = {"slurm": (("--cpus-per-task=2",), ()), "parallel": (("1",), ("2",))}[engine]
    for number in range(ROUNDS):
        for workers, options in ((1, one), (2, two)):
            farm = Farm(program, folder / f"{engine}-{workers}-{number}", slurm, engine)
            farm.split(HEAVY, PER_JOB)
            seconds[workers].append(farm.draw(*options))
            shutil.rmtree(farm.folder)
    share = statistics.median(seconds[1]) / (2.0 * statistics.median(seconds[2]))
    print(f"{engine}: one worker {words(seconds[1])} s, two {words(seconds[2])} s: efficiency {share:.2f} "
          f"(at least {LEAST_EFFICIENCY})", flush=True)
    return share


def check_failures(program, folder, slurm):
    """A part that succeeds at its third try, and one that never does."""
    film = ("crt", "--source", "pattern:smpte", "--size", "64x48", "--frames", "4")
    count = f"""case "$*" in *--frames\\ 4*)
    tries=$(cat {folder}/tries 2>/dev/null || echo 0)
    echo $((tries + 1)) > {folder}/tries
    [ "$tries" -ge LEAST ] || exit 1 ;;
esac"""
    for name, least, tries, is_joined in (("later", 2, 3, True), ("never", 100, 4, False)):
        farm = Farm(program, folder / name, slurm)
        (folder / "tries").unlink(missing_ok=True)
        farm.split(film, 2, "--join", farm.folder / "film.mkv")
        farm.stand_in(count.replace("LEAST", str(least)))
        farm.draw()
        told = int((folder / "tries").read_text())
        print(f"part that succeeds {name}: {told} tries", flush=True)
        # The join itself also has --frames 4, and is the last try.
        assert told == tries + is_joined, told
        assert (farm.folder / "film.mkv").exists() == is_joined
        slurm.told("scancel", "--state=PENDING", "--user=root")


def main():
    program = Path(sys.argv[1]).resolve()
    if os.geteuid() != 0:
        sys.exit("Run this part as root: it starts the services of Slurm.")
    for name in ("munged", "slurmctld", "slurmd", "parallel"):
        if not shutil.which(name):
            sys.exit(f"{name} is missing. Install the packages munge, parallel and slurm-wlm.")
    with tempfile.TemporaryDirectory(prefix="afterglow-slurm-") as text, Slurm(Path(text)) as slurm:
        folder = Path(text)
        check_failures(program, folder, slurm)
        check_frames(program, folder, slurm)
        shares = [efficiency(program, folder, slurm, engine) for engine in ("slurm", "parallel")]
    return 0 if min(shares) >= LEAST_EFFICIENCY else 1


if __name__ == "__main__":
    sys.exit(main())

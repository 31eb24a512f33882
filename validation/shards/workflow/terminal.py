# SPDX-License-Identifier: GPL-3.0-or-later
"""What a person sees of Snakemake, which the profiles tell to be quiet: how far it is, and whatever went wrong."""
import json
import sys
import time

EVERY = 5.0  # s, how far it is
TOLD = ("Trying to restart", "Error submitting", "Resuming incomplete", "Will exit", "Cluster status")
REPEATED = ("Error executing rule", "Exiting because a job", "Complete log")
out = None  # the folder that all is in, which the Snakefile names
_told, _last = 0, 0.0


def say(words):
    print("stiction:", words, file=sys.stderr, flush=True)


def _plan():
    return json.loads((out / "plan.json").read_text())


def tell_progress():
    global _told, _last
    if time.monotonic() - _last < EVERY or not (out / "plan.json").exists():
        return
    plan = _plan()
    done = sum(1 for _ in (out / plan["plan"] / "done").glob("*.json"))
    if 0 < done != _told:
        _told, _last = done, time.monotonic()
        say(f"{done} of {plan['parts']} parts done")


def tell_results():
    """Of the whole, at the end."""
    plan = _plan()
    whole = json.loads((out / plan["plan"] / "merged.json").read_text())
    print(whole["screen"], end="")
    if whole["broke_off"] > 0:
        say(f"{whole['broke_off']} of {plan['jobs']} broke off; a sweep tries them again with retry=true behind --config")


def log_handler(message):
    """Of a message of Snakemake's logger, which hands each as a dictionary."""
    level, words = message["level"], str(message.get("msg") or "")
    if words.startswith("Select jobs"):  # whenever some have ended
        tell_progress()
    elif level == "job_error":
        slurm = message.get("aux", {}).get("cluster_jobid")
        logs = [f"{log} and {log}.slurm say why" if slurm else f"{log} says why" for log in message["log"]]
        say("; ".join([message["name"] + " failed" + (f", Slurm's job {slurm}" if slurm else ""), *logs]))
    elif level in ("error", "warning") and not words.startswith(REPEATED) or level == "info" and words.startswith(TOLD):
        if words.startswith("WorkflowError"):  # of what a person gave; where the Snakefile says so is of no use to them
            words = " ".join(line for line in words.splitlines()[1:] if not line.startswith("  File"))
        say(words)

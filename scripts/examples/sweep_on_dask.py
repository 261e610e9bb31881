"""Runs a study of `kerf sweep` on the workers of Dask.

    sweep_on_dask.py SCHEDULER STUDY.json DIR      as in: tcp://127.0.0.1:8786 study.json out
"""
import sys

from distributed import Client, as_completed

import kerf

scheduler, file, out = sys.argv[1:]
study = kerf.Study(file)
client = Client(scheduler)
runs = {client.submit(study.run, number, out, pure=False): number for number in range(len(study))}
for run in as_completed(runs):
    code, problem = run.result()
    print(runs[run], "done" if code == 0 else f"failed: {problem}", flush=True)
failed, missing = study.gather(out)
print(f"{len(study)} runs, {len(failed)} failed, {len(missing)} missing")
sys.exit(bool(failed or missing))

# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Gives the program damaged copies of files: each must end with a result whose checks hold, or with a clear error.

usage: mutate.py PROGRAM FOLDER NUMBER [SEED] [--first N] [--seconds LIMIT]

FOLDER is searched for images and meshes (not larger than 2 MB). Prints what went wrong, and a summary; the exit code is 1 if
something did. Damaged copies that something is wrong with stay in ./mutated. The limit is one of processor time, so that it means
the same on a busy machine. Each copy depends on the seed and its number alone.
"""
import argparse
import collections
import gzip
import json
import pathlib
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile

parser = argparse.ArgumentParser()
parser.add_argument("program", type=pathlib.Path)
parser.add_argument("folder", type=pathlib.Path)
parser.add_argument("number", type=int)
parser.add_argument("seed", type=int, nargs="?", default=1)
parser.add_argument("--first", type=int, default=0)
parser.add_argument("--seconds", type=int, default=120)
options = parser.parse_args()
program = options.program.resolve()

MESHES = (".off", ".obj", ".ply", ".stl", ".om")
IMAGES = (".nrrd", ".mha", ".nii", ".nii.gz", ".vtk", ".vti")
files = sorted(f for f in options.folder.rglob("*") if f.name.lower().endswith(MESHES + IMAGES) and f.stat().st_size < 2 << 20)
pick = random.Random()


def damaged(content, text):
    """a copy with one to a few kinds of damage."""
    data = bytearray(content)
    for _ in range(pick.choice((1, 1, 2, 5))):
        kind = pick.randrange(9)
        n = len(data)
        at = pick.randrange(n) if pick.random() < 0.5 else pick.randrange(min(n, 400))
        if kind == 0:  # truncated
            del data[at:]
        elif kind == 1:
            data[at] ^= 1 << pick.randrange(8)
        elif kind == 2:
            for _ in range(20):
                data[pick.randrange(n)] = pick.randrange(256)
        elif kind == 3:  # something is missing
            del data[at : at + pick.choice((1, 4, 100))]
        elif kind == 4:  # something is twice
            data[at:at] = data[at : at + pick.choice((1, 4, 1000))]
        elif kind == 5:
            data[at : at + 4] = pick.choice((b"\xff\xff\xff\xff", b"\0\0\0\0", b"\0\0\xc0\x7f", b"\0\0\x80\x7f", b"\x7f\xff\xff\xff"))
        elif text:  # a word is another one
            words = bytes(data).split(b" ")
            words[pick.randrange(len(words))] = pick.choice(
                (b"nan", b"inf", b"-1", b"0", b"1e300", b"1e-300", b"4294967296", b"99999999999999999999", b"", b"\n", b"x", b"1e39"))
            data = bytearray(b" ".join(words))
        else:
            data[at : at + 2] = bytes(pick.randrange(256) for _ in range(2))
        if not data:
            data = bytearray(b"\0")
    return bytes(data)


ISO = {"skull": "2.9", "engine": "180", "cranium": "300", "ch2": "35", "C57BL6_J_": "35", "headsq_uint8": "31", "headsq": "500"}
outcomes = collections.Counter()
longest = 0


def run(*command):
    """runs the program within the limit, and with one thread, so that its processor time is the time that it takes."""
    return subprocess.run(command, capture_output=True, timeout=20 * options.seconds,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (options.seconds, options.seconds + 5)))


def processor_time():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


bad = pathlib.Path("mutated")
done = 0


def stop(*_):
    raise KeyboardInterrupt


def damage_and_run(folder):
    """copy after copy, each on its own."""
    global longest, done
    for i in range(options.first, options.number):
        pick.seed(f"{options.seed} {i}")
        file = files[i % len(files)]
        content = file.read_bytes()
        is_mesh = file.name.lower().endswith(MESHES)
        if file.name.endswith(".gz") and pick.random() < 0.6:  # what is compressed is damaged, or the compressed
            content = gzip.compress(damaged(gzip.decompress(content), False), 1)
        else:
            content = damaged(content, is_mesh and b"\0" not in content[:1000])
        copy = folder / f"{i}_{file.name}"
        copy.write_bytes(content)
        report, graph = folder / "report.json", folder / "graph.graphml"
        arguments = [] if is_mesh else ["--iso", next((v for k, v in ISO.items() if file.name.startswith(k)), "300"), "--max-level", "3"]
        command = [program, "extract", copy, *arguments, "--report", report, "-o", graph, "--quiet", "--memory-limit", "3G", "--threads", "1"]
        problem = None
        before = processor_time()
        try:
            result = run(*command)
            longest = max(longest, processor_time() - before)
            errors = result.stderr.decode(errors="replace")
            if result.returncode == 0:
                failed = [name for name, holds in json.loads(report.read_text())["checks"].items() if holds is False]
                again = run(program, "check", graph)
                if failed or again.returncode != 0:
                    problem = f"checks fail: {failed} {again.stdout.decode()[-300:]}"
                outcomes["results"] += 1
            elif result.returncode in (1, 2):
                if not errors.startswith("extremal_mesh: ") or errors.count("\n") != 1 or "out of memory" in errors:
                    problem = f"unclear error: {errors[-300:]}"
                elif graph.exists() or report.exists():
                    problem = "an output beside an error"
                outcomes["errors"] += 1
            elif result.returncode == -signal.SIGXCPU:
                problem = f"not done after {options.seconds} s of processor time"
            else:
                problem = f"exit code {result.returncode}: {errors[-500:]}"
        except subprocess.TimeoutExpired:
            problem = "hangs"
        for output in (report, graph):
            output.unlink(missing_ok=True)
        if problem:
            outcomes["problems"] += 1
            bad.mkdir(exist_ok=True)
            shutil.copy(copy, bad)
            print(f"{copy.name}: {problem}", flush=True)
        copy.unlink()
        done += 1


signal.signal(signal.SIGTERM, stop)
with tempfile.TemporaryDirectory() as folder:
    try:
        damage_and_run(pathlib.Path(folder))
    except KeyboardInterrupt:
        print("stopped")
print(", ".join(f"{n} {what}" for what, n in outcomes.items()), f"of {done} copies, the longest {longest:.0f} s")
sys.exit(1 if outcomes["problems"] else 0)

# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whatever goes wrong, outputs are complete or absent, existing ones survive, nothing else is left, and the exit code tells.

usage: faults_test.py PROGRAM LIBRARY DATA FOLDER [RUNS]

LIBRARY injects the faults (inject.cpp). RUNS: of each kind of fault that can hit at any time (default 8).
"""
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import time

program, library, data, folder = (pathlib.Path(a).resolve() for a in sys.argv[1:5])
runs = int(sys.argv[5]) if len(sys.argv) > 5 else 8
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
failures = 0
FORMULA = ["--formula", "x^2/9+y^2/4+z^2-1", "--box", "-4", "-3", "-2", "4", "3", "2", "--resolution", "10", "--threads", "1"]
OUTPUTS = ["e.graphml", "e.png", "e.ply", "e.html", "e.off", "report.json"]


def claim(holds, what):
    global failures
    if not holds:
        failures += 1
        print("FAILED:", what)


def run(*arguments, limits=(), **environment):
    """runs the program; a limit is (resource, value)."""
    env = dict(os.environ, **{k: str(v) for k, v in environment.items()})
    if environment:
        env["LD_PRELOAD"] = str(library)

    def prepare():
        for what, value in limits:
            resource.setrlimit(what, (value, value))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    return subprocess.run([program, *map(str, arguments)], env=env, preexec_fn=prepare, capture_output=True, timeout=120)


def extract(place, **how):
    outputs = [a for name in OUTPUTS if name != "report.json" for a in ("-o", place / name)]
    return run("extract", *FORMULA, *outputs, "--report", place / "report.json", **how)


def content(place):
    return {f.name: f.read_bytes() for f in place.iterdir()}


def fresh(name, old=None):
    place = folder / name
    shutil.rmtree(place, ignore_errors=True)
    place.mkdir()
    for file, text in (old or {}).items():
        (place / file).write_bytes(text)
    return place


def count_of(*arguments):
    """how often the program calls new, write and read."""
    run(*arguments, FAULT_COUNT=folder / "count")
    return tuple(map(int, (folder / "count").read_text().split()))


good_place = fresh("good")
claim(extract(good_place, FAULT_COUNT=folder / "count").returncode == 0, "it works without faults")
good = content(good_place)
claim(sorted(good) == sorted(OUTPUTS), f"all outputs are there: {sorted(good)}")
news, writes, reads = map(int, (folder / "count").read_text().split())


def same(name, text):
    """but for what names the place, or tells of the time."""
    return len(text) == len(good[name]) if name == "report.json" else text == good[name]


def examine(place, result, what, codes, hidden=False, old=b"old"):
    """each output is whole, or as it was; nothing else is there."""
    claim(result.returncode in codes, f"{what}: exit code {result.returncode}: {result.stderr[-200:]}")
    if result.returncode == 1:
        claim(result.stderr.startswith(b"extremal_mesh: ") and result.stderr.count(b"\n") == 1, f"{what}: one line: {result.stderr}")
    for name, text in content(place).items():
        if name.startswith(".extremal_mesh-") and hidden:
            continue
        claim(name in OUTPUTS, f"{what}: {name} is left")
        claim(name not in OUTPUTS or text == old or same(name, text), f"{what}: {name} is neither whole nor as it was")
    if result.returncode != 0 and old is not None:
        claim(set(OUTPUTS) <= set(content(place)), f"{what}: an existing output is gone")


OLD = {name: b"old" for name in OUTPUTS}


def spread(n, count):
    """up to `count` numbers from 1 to n."""
    return sorted({1 + (n - 1) * i // max(1, count - 1) for i in range(count)})


for unnamed in (0, 1):
    for k in range(1, writes + 1) if writes < 2 * runs else spread(writes, runs):
        examine(fresh("write", OLD), extract(folder / "write", FAULT_WRITE=k, FAULT_UNNAMED=unnamed), f"write {k} fails", {1})
        # With a name of its own, the unfinished file is what SIGKILL may leave.
        examine(fresh("kill", OLD), extract(folder / "kill", FAULT_KILL=k, FAULT_UNNAMED=unnamed), f"killed at write {k}", {-9},
                hidden=unnamed)
    examine(fresh("rename", OLD), extract(folder / "rename", FAULT_RENAME=1, FAULT_UNNAMED=unnamed), "rename fails", {1})

in_libraries = count_of("--version")[0]  # before main() hardly anything can be done, but to end
for k in [k for k in spread(news, runs) if k > in_libraries] + [in_libraries + i for i in (50, 100, 150, 200)]:
    # Some libraries get along with less memory.
    examine(fresh("new", OLD), extract(folder / "new", FAULT_NEW=k), f"new {k} fails", {0, 1})

# A mesh: other code is on the way.
mesh = data / "ellipe0.003.off"
place = fresh("mesh")
claim(run("extract", mesh, "-o", place / "m.graphml", "--threads", "1", FAULT_COUNT=folder / "count").returncode == 0, "a mesh works")
# The last ones are nlohmann-json's, whose destructor takes memory, and ends the program if there is none: all is written then.
for k in spread(int((folder / "count").read_text().split()[0]) - 50, runs):
    if k <= in_libraries:
        continue
    result = run("extract", mesh, "-o", place / "m.graphml", "--threads", "1", FAULT_NEW=k)
    claim(result.returncode in (0, 1), f"mesh, new {k} fails: exit code {result.returncode}: {result.stderr[-200:]}")
claim(sorted(content(place)) == ["m.graphml"], "mesh: nothing else is left")

# Limits of the system.
for size in (1, 1000, 50_000, 200_000):
    examine(fresh("fsize", OLD), extract(folder / "fsize", limits=[(resource.RLIMIT_FSIZE, size)]), f"files of at most {size}", {1})
for megabytes in (12, 20, 40, 80, 120, 160, 200, 400):
    for kind, size, name in ((resource.RLIMIT_AS, megabytes << 20, f"{megabytes} MB of address space"),
                             (resource.RLIMIT_DATA, megabytes << 18, f"{megabytes / 4} MB of data")):
        # Before main() the shared libraries cannot be loaded (127) or, those of DICOM, get memory for what they know (-6).
        limit = lambda: resource.setrlimit(kind, (size, size))
        starts = subprocess.run([program, "--version"], capture_output=True, preexec_fn=limit).returncode == 0
        result = extract(fresh("memory", OLD), limits=[(kind, size)])
        examine(folder / "memory", result, name, {0, 1} if starts else {1, 127, -6})
with open("/dev/full", "wb") as full:
    result = subprocess.run([program, "info", good_place / "e.graphml"], stdout=full, stderr=subprocess.PIPE)
    claim(result.returncode == 1 and b"disk" in result.stderr, f"a full standard output is told: {result}")

# Places that cannot be written to.
for target, code in (("/proc/e.graphml", 1), (folder / "none" / "e.graphml", 1), (folder, 2), ("/dev/null", 1), ("", 1)):
    result = run("extract", *FORMULA, "-o", target)
    claim(result.returncode in (code, 2) and result.stderr, f"written to '{target}': {result}")
if os.geteuid() != 0:
    place = fresh("locked")
    place.chmod(0o500)
    claim(extract(place).returncode == 1 and not content(place), "a folder without permission to write")
    place.chmod(0o700)

# An input that gets shorter while it is read: the result is that of the whole or there is an error.
image = folder / "image.nii"
subprocess.run(["sh", "-c", f"gzip -dc '{data}/headsq.nii.gz' > '{image}'"], check=True)
whole = image.read_bytes()
for k in (1, 2, 3, 4, 6, 8):
    image.write_bytes(whole)
    place = fresh("shrink")
    result = run("extract", image, "--iso", "500000", "-o", place / "i.graphml", FAULT_SHRINK=f"{k}:{image}")
    shrunk = image.stat().st_size < len(whole)
    claim(result.returncode == 1 and (not shrunk or b"iso" not in result.stderr), f"image shrinks at read {k}: {result.stderr}")
    claim(not content(place), f"image shrinks at read {k}: nothing is written")
for name, text in (("m.off", mesh.read_bytes()), ("e.graphml", good["e.graphml"])):
    for k in (1, 2):
        (folder / name).write_bytes(text)
        arguments = ["extract", folder / name] if name == "m.off" else ["info", folder / name]
        result = run(*arguments, FAULT_SHRINK=f"{k}:{folder / name}")
        claim(result.returncode in (0, 1), f"{name} shrinks at read {k}: {result}")

# Signals.
LONG = ["extract", "--formula", "x^2/9+y^2/4+z^2-1+0.05*sin(9*x)*sin(8*y)*sin(7*z)", "--box", "-4", "-3", "-2", "4", "3", "2",
        "--resolution", "150"]
for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL):
    place = fresh("signal", {"e.graphml": b"old"})
    process = subprocess.Popen([program, *LONG, "-o", place / "e.graphml", "-o", place / "e.png"], stderr=subprocess.PIPE)
    time.sleep(0.4)
    process.send_signal(number)
    errors = process.communicate(timeout=60)[1]
    expected = -9 if number == signal.SIGKILL else 128 + number
    claim(process.returncode == expected, f"{number!r}: exit code {process.returncode}: {errors}")
    claim(content(place) == {"e.graphml": b"old"}, f"{number!r}: left {sorted(content(place))}")
process = subprocess.Popen([program, "extract", *FORMULA, "-o", fresh("ignored") / "e.graphml"], stdout=subprocess.PIPE,
                           preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
process.send_signal(signal.SIGHUP)
process.communicate(timeout=60)
claim(process.returncode == 0, f"a signal that is ignored stays ignored: {process.returncode}")
reader, writer = os.pipe()
os.close(reader)
place = fresh("pipe")
process = subprocess.Popen([program, "extract", *FORMULA, "-o", place / "e.graphml"], stdout=writer, stderr=subprocess.PIPE)
os.close(writer)
process.communicate(timeout=60)
claim(process.returncode in (1, -signal.SIGPIPE), f"a closed pipe: exit code {process.returncode}")
claim(content(place) == {"e.graphml": good["e.graphml"]}, "a closed pipe: the output is there")

print(f"{failures} failures")
sys.exit(failures != 0)

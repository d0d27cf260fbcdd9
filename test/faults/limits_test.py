# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that ask for more than they hold end in an error, soon and without memory.

usage: limits_test.py PROGRAM FOLDER
"""
import gzip
import math
import pathlib
import resource
import shutil
import struct
import subprocess
import sys
import zlib

program, folder = (pathlib.Path(a).resolve() for a in sys.argv[1:3])
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
failures = 0
MEMORY = 600 << 20  # address space: most of it is shared libraries
SECONDS = 2  # of the processor, whatever else the machine does


def claim(holds, what):
    global failures
    if not holds:
        failures += 1
        print("FAILED:", what)


def processor_time():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def refused(name, content, *arguments, code=1, expect="", command="extract"):
    if content is not None:
        (folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())
    limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    start = processor_time()
    file = [folder / name] if content is not None else []
    result = subprocess.run([program, command, *file, *arguments], capture_output=True, preexec_fn=limit, timeout=120)
    seconds = processor_time() - start
    error = result.stderr.decode(errors="replace")
    claim(result.returncode == code, f"{name}: exit code {result.returncode}: {error[-300:]}")
    claim(code == 0 or (error.count("\n") == 1 and len(error) < 1000 and expect in error), f"{name}: {error[-300:]}")
    claim(seconds < SECONDS, f"{name}: {seconds:.1f} s")


def nrrd(size, data, encoding="gzip"):
    return f"NRRD0004\ntype: uchar\ndimension: 3\nsizes: {size} {size} {size}\nencoding: {encoding}\n\n".encode() + data


def zeros(megabytes):
    """so many MB of zeros, compressed a thousand times."""
    return gzip.compress(bytes(1 << 20), 9, mtime=0) * megabytes


# Meshes.
refused("vertices.off", "OFF\n2147483648 1 0\n0 0 0\n", expect="rest of the file")
refused("vertices64.off", "OFF\n18446744073709551615 1 0\n0 0 0\n", expect="rest of the file")
refused("corners.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4294967295 0 1 2\n", expect="rest of the file")
refused("vertices.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uint uint vertex_indices\nend_header\n")
refused("nothing.ply", "ply\nformat ascii 1.0\nelement vertex 99999999999\nelement face 99999999999\nend_header\n")
refused("triangles.stl", bytes(80) + struct.pack("<I", 0xFFFFFFFF) + bytes(50))
refused("edges.om", b"OMT" + struct.pack("<BIII", 2 << 5, 0xFFFFFFFF, 0xFFFFFFFF, 0xFFFFFFFF) + bytes(64))
n = 1_000_000
refused("polygon.off", f"OFF\n{n} 1 0\n" + "".join(f"{i % 1000} {i // 1000} {i % 7}\n" for i in range(n)) + f"{n} " + " ".join(map(str, range(n))), expect="at most 65536 vertices, found 1000000 at face 1")
few = 1 << 16  # as many as a face may have
turns = [2 * math.pi * i / few for i in range(few)]
refused("round_polygon.off", f"OFF\n{few} 1 0\n" + "".join(f"{math.cos(t):.9f} {math.sin(t):.9f} 0\n" for t in turns) + f"{few} " +
        " ".join(map(str, range(few))), expect="no jet")
refused("polygon_twice.off", f"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n{few} " + "0 1 2 " * (few // 3) + "0")
# Images.
refused("size.nrrd", nrrd(2_000_000, bytes(100), "raw"), "--iso", "1")
refused("lie.nrrd", nrrd(1500, zeros(1)), "--iso", "1", expect="truncated")
refused("bomb.nrrd", nrrd(8, zeros(2000)), "--iso", "1", expect="go on long after")
refused("large.nrrd", nrrd(1280, zeros(2000)), "--iso", "1", "--memory-limit", "1G", expect="a temporary file of 8000 MB")
refused("text.nrrd", nrrd(1500, b"1 2 3", "ascii"), "--iso", "1")
header = bytearray(352)
struct.pack_into("<i", header, 0, 348)
struct.pack_into("<8h", header, 40, 3, 32767, 32767, 32767, 1, 1, 1, 1)
struct.pack_into("<hh", header, 70, 2, 8)
struct.pack_into("<8f", header, 76, 1, 1, 1, 1, 0, 0, 0, 0)
struct.pack_into("<f", header, 108, 352)
header[344:348] = b"n+1\0"
refused("size.nii", bytes(header) + bytes(64), "--iso", "1")
refused("size.nii.gz", gzip.compress(bytes(header)) + zeros(10), "--iso", "1")
refused("size.mha", b"ObjectType = Image\nNDims = 3\nBinaryData = True\nCompressedData = True\nCompressedDataSize = 1000\nDimSize = 65536 65536 65536\n"
        b"ElementType = MET_UCHAR\nElementDataFile = LOCAL\n" + zlib.compress(bytes(100000)), "--iso", "1")
refused("size.vtk", "# vtk DataFile Version 3.0\nt\nBINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS 65536 65536 65536\nORIGIN 0 0 0\nSPACING 1 1 1\n"
        "POINT_DATA 281474976710656\nSCALARS s short 1\nLOOKUP_TABLE default\n", "--iso", "1")
# Texts.
deep = 100_000
box = ["--box", "-1", "-1", "-1", "1", "1", "1"]
for name, formula in (("parentheses", "(" * 60_000 + "x" + ")" * 60_000), ("signs", "-" * deep + "x"), ("powers", "x^" * 60_000 + "x"),
                      ("calls", "sin(" * 25_000 + "x" + ")" * 25_000)):
    refused(f"formula of {name}", None, "--formula", formula, *box, code=2, expect="levels of nesting")
refused("formula of terms", None, "--formula", "+".join(["x"] * 60_000) + "-1", *box, "--resolution", "2", code=1)
refused("deep.graphml", "<graphml>" * deep, command="info")
refused("entities.graphml", '<!DOCTYPE a [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;">]><graphml>&b;</graphml>', command="info")
graph = '<graphml><key id="f" for="graph" attr.name="format"/><key id="c" for="graph" attr.name="cells"/><graph><data key="c">'
refused("deep_cells.graphml", graph + "[" * deep + "</data></graph></graphml>", command="info")
refused("cells.json.graphml", graph + '{"a":' * deep + "</data></graph></graphml>", command="info")
empty = folder / "graph.graphml"
subprocess.run([program, "extract", "--formula", "x^2/9+y^2/4+z^2-1", "--box", "-4", "-3", "-2", "4", "3", "2", "--resolution", "10", "-o", empty,
                "--quiet"], check=True)
(folder / "deep.json").write_text('{"markups":' + "[" * deep)
(folder / "motion.json").write_text('{"matrix":' + '{"a":[' * deep)
refused("graph of deep landmarks", None, empty, folder / "deep.json", command="match")
refused("graph of a deep motion", None, empty, empty, "--transform", folder / "motion.json", command="compare")
# --memory-limit.
ellipsoid = ["--formula", "x^2+y^2/0.9+z^2/0.8-1", "--box", "-1.1", "-1.1", "-1.1", "1.1", "1.1", "1.1"]
refused("formula, 1 MB", None, *ellipsoid, "--resolution", "5000", "--memory-limit", "1M", expect="more than the 1 MB")
refused("formula, 100 MB", None, *ellipsoid, "--resolution", "400", "--memory-limit", "100M", expect="out of memory")
refused("formula, enough", None, *ellipsoid, "--resolution", "20", "--memory-limit", "300M", code=0)
for size in ("2X", "-1", "", "1e99", "nan", "G"):
    refused(f"limit '{size}'", None, *ellipsoid, f"--memory-limit={size}", code=2)

print(f"{failures} failures")
sys.exit(failures != 0)

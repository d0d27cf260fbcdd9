# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""json_test.py PROGRAM DATA_FOLDER WORK_FOLDER

Every command of the program has an example in its help and prints, with --json, one JSON object and nothing else.
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys

program, data, work = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
shutil.rmtree(work, ignore_errors=True)
work.mkdir(parents=True)


def run(*arguments):
    outcome = subprocess.run([program, *map(str, arguments)], cwd=work, text=True, capture_output=True, check=False)
    assert outcome.returncode == 0 and outcome.stderr == "", outcome
    return outcome.stdout


def printed(*arguments):
    return json.loads(run(*arguments, "--json"))


told = {}
box = ["--formula", "x^2/9 + y^2/4 + z^2 = 1", "--box", -4, -3, -2, 4, 3, 2, "--resolution", 24]
told["extract"] = printed("extract", *box, "-o", "e.graphml", "--cells", "e.ply", "--report", "report.json")
assert told["extract"] == json.loads((work / "report.json").read_text())
assert told["extract"]["cells"] == 8 and told["extract"]["report"]["uncertain_cells"] == 0
told["info"] = printed("info", "e.graphml")
told["check"] = printed("check", "e.graphml")
assert told["info"] == told["check"] and told["info"]["ok"] and told["info"]["vertices"]["extremal_point"] == 6

told["simplify"] = printed("simplify", "e.graphml", "--level", 0, "-o", "s.graphml")
level = told["simplify"].pop("level")
assert level["number"] == 0 and level["last_step"] is None and level["levels"] >= 1
assert told["simplify"]["edges_by_type"] == told["info"]["edges_by_type"]
told["query"] = printed("query", "e.graphml", "--quads")
assert told["query"]["quadrilaterals"] == 8
told["view"] = printed("view", "e.graphml", "-o", "e.html", "-o", "e.png")
assert told["view"] == {"files": ["e.html", "e.png"]}
told["convert"] = printed("convert", "e.graphml", "e.vtp")
assert told["convert"] == {"files": ["e.vtp"]}

told["segment"] = printed("segment", "e.graphml", "--surface", "e.ply", "-o", "s.ply")
assert told["segment"]["cells_with_faces"] == 8 and told["segment"]["away_faces"] == 0
told["reduce"] = printed("reduce", "e.graphml", "--surface", "e.ply", "--faces", 300, "-o", "r.ply")
assert told["reduce"]["faces"] <= 300 and told["reduce"]["euler_characteristic"] == 2
told["flatten"] = printed("flatten", "e.graphml", "--surface", "e.ply", "-o", "f.obj")
assert told["flatten"]["by_corners"] == {"4": 8} and told["flatten"]["flipped"] == 0

told["landmarks"] = printed("landmarks", "e.graphml", "--umbilics", "-o", "l.csv")
assert [landmark["kind"] for landmark in told["landmarks"]["landmarks"]] == 6 * ["extremal_point"] + 4 * ["umbilic"]
assert printed("landmarks", "e.graphml", "--umbilics") == told["landmarks"]  # no file needs to be written
told["match"] = printed("match", "e.graphml", "l.csv")
assert told["match"]["landmarks"] == 10 and told["match"]["extremal_point"]["greatest"] > 0

wavy = ["--formula", "x^2/9 + y^2/4 + z^2 + 0.02*sin(3*x)*cos(2*y + 1) + 0.03*x*y*z = 1", "--box", -4, -3, -2, 4, 3, 2, "--resolution", 32]
run("extract", *wavy, "-o", "w.graphml", "--quiet")
told["register"] = printed("register", "w.graphml", "w.graphml")
assert told["register"]["found"] and abs(told["register"]["matrix"][0][0] - 1) < 1e-6
told["compare"] = printed("compare", "w.graphml", "w.graphml")
assert told["compare"]["edges_percent"] == 100
told["scale-space"] = printed("scale-space", data / "skull_2.9.nrrd", "--iso", 2.9, "--sigma", 12, 15)
sigmas = [entry["sigma"] for entry in told["scale-space"]["levels"]]
vertices = [entry["vertices"] for entry in told["scale-space"]["levels"]]
assert sigmas == [12, 15] and vertices[0] > vertices[1] > 0

commands = re.search(r"^Subcommands:\n((?:  .*\n)+)", run("--help"), re.MULTILINE)[1]
for command in re.findall(r"^  ([a-z-]+) ", commands, re.MULTILINE):
    text = run(command, "--help")
    assert re.search(rf"^ *extremal_mesh {command} ", text, re.MULTILINE), f"the help of {command} has no example"
    assert "--json" in text, f"{command} has no --json"
    if command not in told:
        print(f"{command} is not called here with --json: add it")
        sys.exit(1)
print(f"{len(told)} commands print JSON")

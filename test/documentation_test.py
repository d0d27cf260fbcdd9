# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""documentation_test.py SOURCE_FOLDER BUILD_FOLDER FOLDER_OF_THE_PROGRAM WORK_FOLDER

What README, CHANGELOG and manual show is true: for each page, in a folder of its own that holds data/ and scripts/,
- sh blocks are run, all of a page in order, and a text block right after one is what it prints, a line … standing for any lines;
- python blocks are run, but for those of a program that uses the module extremal_mesh: these are part of python/examples, which the
  tests of the module run;
- cpp blocks are part of an example, cmake blocks of the outside project that the tests build;
- links lead somewhere: to a file, and to a heading in it.
Other blocks are an error, but for `text` blocks that follow no command.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

source, build, program_folder, work = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
presets = json.loads((source / "CMakePresets.json").read_text())
failures = []


def fail(page, line, message):
    failures.append(f"{page.relative_to(source)}:{line}: {message}")


def blocks(page):
    """the fenced blocks of a page: (language, first line, text, whether it follows the block before)"""
    language, start, lines, adjacent = None, 0, [], False
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        fence = re.match(r"```(\S*)$", line)
        if language is None:
            if fence:
                language, start, lines = fence[1], number, []
            elif line.strip():
                adjacent = False
        elif fence:
            yield language, start, "\n".join(lines) + "\n", adjacent
            language, adjacent = None, True
        else:
            lines.append(line)


def runnable(command):
    """the commands of a block as they can be run here"""
    result = []
    for line in command.splitlines():
        script = re.match(r"scripts/(test|benchmark)\.sh\b", line)
        if script:  # the one runs this test, the other takes long
            assert os.access(source / script[0], os.X_OK)
            continue
        preset = re.match(r"(cmake|ctest|cmake --build) --preset (\S+)$", line)
        if preset:  # would build everything once more: what it names must be there
            kind = {"cmake": "configure", "ctest": "test"}.get(preset[1], "build") + "Presets"
            assert preset[2] in [p["name"] for p in presets[kind]], f"no preset: {line}"
            continue
        benchmark = re.match(r"build/benchmark/(benchmark/\S+)$", line)
        if benchmark:  # takes long, and its output is for people
            assert os.access(build / benchmark[1], os.X_OK), f"no program: {line}"
            continue
        result.append(re.sub(r"\bbuild/[a-z-]+(?=[/ ]|$)", str(build), line))
    return "set -euo pipefail\n" + "\n".join(result)


def run(page, line, command, folder, environment):
    outcome = subprocess.run(command, cwd=folder, env=environment, text=True, capture_output=True, check=False)
    if outcome.returncode != 0:
        fail(page, line, f"exit code {outcome.returncode}:\n{outcome.stdout[-2000:]}{outcome.stderr[-2000:]}")
    return outcome.stdout


def parts(*patterns):
    return [p.read_text(encoding="utf-8") for pattern in patterns for p in source.glob(pattern)]


def headings(page):
    """what the headings of a page are linked by"""
    lines = re.sub(r"^```.*?^```$", "", page.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL).splitlines()
    titles = [line.lstrip("#").strip().lower() for line in lines if line.startswith("#")]
    return {re.sub(r"[^\w\- ]", "", title).replace(" ", "-") for title in titles}


def check_page(page):
    folder = work / page.stem
    folder.mkdir()
    for name in ("data", "scripts"):
        (folder / name).symlink_to(source / name)
    environment = dict(os.environ, PATH=f"{program_folder}:{os.environ['PATH']}", EXTREMAL_MESH_3_BUILD_DIR=str(build))
    output = None
    for language, line, text, adjacent in blocks(page):
        if language == "sh":
            output = run(page, line, ["bash", "-c", runnable(text)], folder, environment)
        elif language == "python" and any(text in part for part in parts("python/examples/*.py")):
            pass
        elif language == "python":
            run(page, line, [sys.executable, "-c", text], folder, environment)
        elif language == "cpp":
            if not any(text in part for part in parts("examples/*.cpp", "test/consumer/*.cpp")):
                fail(page, line, "this code is in no example")
        elif language == "cmake":
            if not any(text in part for part in parts("test/consumer/CMakeLists.txt")):
                fail(page, line, "this code is not in test/consumer/CMakeLists.txt")
        elif language != "text":
            fail(page, line, f"nothing is known of blocks of {language or 'no language'}")
        elif adjacent and not re.fullmatch(re.escape(text).replace("…\\\n", ".*"), output, re.DOTALL):
            fail(page, line, f"the output is now\n{output}")
    prose = re.sub(r"^```.*?^```$", "", page.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)
    for link in re.findall(r"\]\(([^)\s]+)\)", prose):
        target, _, heading = link.partition("#")
        if "://" in target:
            continue
        linked = page.parent / target if target else page
        if not linked.exists() or (heading and heading not in headings(linked)):
            failures.append(f"{page.relative_to(source)}: {link} is not there")


shutil.rmtree(work, ignore_errors=True)
work.mkdir(parents=True)
pages = [source / "README.md", source / "CHANGELOG.md", *sorted((source / "doc").glob("*.md"))]
for each in pages:
    check_page(each)
print("\n".join(failures) if failures else f"{len(pages)} pages are true")
sys.exit(bool(failures))

# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""reference_test.py SOURCE_FOLDER DOXYFILE WORK_FOLDER

The manual and the reference as Doxygen makes them: no warning, so no public name, parameter or result is undocumented; every class, function and
type of the public headers is there, and every page of doc/; no link and no picture leads nowhere. Exit code 77: there is no doxygen.
"""
import html.parser
import pathlib
import re
import shutil
import subprocess
import sys
import urllib.parse

source, doxyfile, work = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
if not shutil.which("doxygen"):
    print("skipped: there is no doxygen; the package of this name brings it")
    sys.exit(77)

shutil.rmtree(work, ignore_errors=True)
work.mkdir(parents=True)
settings = doxyfile.read_text()
settings = settings.replace(str(doxyfile.parent), str(work))
subprocess.run(["doxygen", "-"], input=settings, text=True, check=True, cwd=work)
failures = (work / "warnings.txt").read_text().splitlines()
failures += [f"{page.name} is not in doc_pages of cmake/Extremal_mesh_3_doc.cmake" for page in (source / "doc").glob("*.md")
             if str(page) not in settings]


class Links(html.parser.HTMLParser):
    """what a page leads to, and what can be led to in it"""

    def __init__(self, file):
        super().__init__()
        self.targets, self.names, self.text = [], set(), []
        self.feed(file.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.names.update(values[key] for key in ("id", "name") if values.get(key))
        self.targets += [values[key] for key in ("href", "src") if values.get(key)]

    def handle_data(self, data):
        self.text.append(data)


folder = work / "html"
pages = {file.name: Links(file) for file in folder.glob("*.html")}
for name, page in pages.items():
    for target in page.targets:
        url = urllib.parse.urlsplit(target)
        if url.scheme:
            continue
        file = urllib.parse.unquote(url.path) or name
        if not (folder / file).exists():
            failures.append(f"{name}: {target} is not there")
        elif url.fragment and file in pages and url.fragment not in pages[file].names:
            failures.append(f"{name}: there is no {target}")

# what the public headers declare, by a look at their text that knows nothing of Doxygen
words = set(re.findall(r"\w+", " ".join(" ".join(page.text) for page in pages.values())))
names = 0
for header in sorted((source / "include/CGAL/Extremal_mesh_3").glob("*.h")):
    text = re.sub(r"namespace internal[^{]*\{.*?^\} // namespace internal\S*", "", header.read_text(), flags=re.DOTALL | re.MULTILINE)
    declared = re.findall(r"^(?:template <[^;{]*?> )?(?:struct|class|enum class|using|concept) (\w+)", text, re.MULTILINE)
    declared += re.findall(r"^(?! )(?:template <[^;{]*?>\s)?[\w:<>,& ]+[ &](\w+)\([^;{]*\)(?:;| \{)", text, re.MULTILINE)
    names += len(declared)
    failures += [f"{header.name}: {name} is not in the reference" for name in declared if name not in words]
assert names > 150, f"only {names} names were found in the headers"

print("\n".join(failures) if failures else f"{len(pages)} pages, {names} names: all is documented, no link leads nowhere")
sys.exit(bool(failures))

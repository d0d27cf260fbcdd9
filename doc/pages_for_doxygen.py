# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""pages_for_doxygen.py PAGE.md: the page as Doxygen 1.9 understands it, on standard output.

The pages are written for whoever reads them in the repository: headings are linked by what they say, files by where they are. Doxygen
wants names for both: heading "What is X" of page.md becomes page_what-is-x, the page itself page_page. What lies outside
of the manual is not linked.
"""
import pathlib
import re
import sys


def anchor(heading):
    """what a heading is linked by in the repository"""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def name_of(page, heading=None):
    stem = pathlib.PurePath(page).stem.lower()
    return f"page_{stem}" if heading is None else f"{stem}_{anchor(heading)}"


def link(page, text, target):
    file, _, fragment = target.partition("#")
    if "://" in file:
        return f"[{text}]({target})"
    linked = page.parent / file if file else page
    if linked.suffix != ".md" or linked.resolve().parent != page.resolve().parent:
        return text
    return f"[{text}](@ref {name_of(linked, fragment or None)})"


def converted(page, lines):
    fenced = False
    first = True
    for line in lines:
        if line.startswith("```"):
            fenced = not fenced
        elif not fenced:
            heading = re.match(r"(#+) (.*)$", line)
            if heading:
                label = name_of(page) if first else name_of(page, heading[2])
                # a number of the page's own contents would be taken for markup
                line = f"{heading[1]} {heading[2]} {{#{label}}}"
                first = False
            else:
                line = re.sub(r"!\[([^\]]*)\]\((?:doc/)?figures/([^)]*)\)", r"![\1](\2)", line)
                line = re.sub(r"(?<!!)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s]+)\)", lambda m: link(page, m[1], m[2]), line)
        yield line


if __name__ == "__main__":
    source = pathlib.Path(sys.argv[1])
    print("\n".join(converted(source, source.read_text(encoding="utf-8").splitlines())))

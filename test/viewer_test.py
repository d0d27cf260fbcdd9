# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""viewer_test.py PROGRAM WORK_FOLDER

Opens what 'extremal_mesh view' writes in a browser without a network, and uses it as people do. Exit code 77: no browser.
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import time

import browser

program, work = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
if not browser.find_browser():
    print("skipped: there is no Chromium; 'apt-get install chromium' brings it")
    sys.exit(77)
shutil.rmtree(work, ignore_errors=True)
work.mkdir(parents=True)
viewer = "extremalMeshViewer"


def run(*arguments):
    return subprocess.run([program, *arguments], cwd=work, check=True, text=True, capture_output=True).stdout


def near(pixel, colour, tolerance=30):
    return all(abs(a - b) <= tolerance for a, b in zip(pixel, colour))


def count(page, colour, columns=slice(0, 1010)):
    """how many pixels of a screenshot are of about this colour, left of the legend"""
    _, _, rows = browser.decode_png(page.screenshot())
    return sum(near(pixel, colour) for row in rows for pixel in row[columns])


def press(page, selector):
    x, y = page.evaluate(f"(() => {{ const b = document.querySelector('{selector}').getBoundingClientRect();"
                         " return [b.x + b.width / 2, b.y + b.height / 2]; })()")
    page.click(x, y)
    page.settle()


orange, dark_blue = (255, 140, 0), (12, 60, 170)
run("extract", "--formula", "x^2/9 + y^2/4 + z^2 = 1", "--box", "-4", "-3", "-2", "4", "3", "2", "--resolution", "24",
    "-o", "e.graphml", "--cells", "e.ply", "-o", "at_once.html", "--quiet")
run("view", "e.graphml", "--surface", "e.ply", "-o", "e.html")
assert (work / "e.html").read_bytes() == (work / "at_once.html").read_bytes()  # same mesh, same bytes
text = (work / "e.html").read_text()
assert not re.search(r"""(src|href)=["'](?!data:)""", text), "the page refers to another file"
info = json.loads(run("info", "e.graphml", "--json"))

with browser.Page(work / "e.html") as page:
    # it shows the mesh
    assert page.evaluate(f"{viewer}.render()") == 3  # surface, lines, vertices: a call each, however many there are
    assert count(page, orange) > 300 and count(page, dark_blue) > 50
    legend = page.evaluate("[...document.querySelectorAll('button.row')].map(b => [b.dataset.key, b.querySelector('.count').textContent])")
    expected = {**{t: n for t, n in info["edges_by_type"].items() if n}, "extremal_point": info["vertices"]["extremal_point"],
                "lemon": info["umbilics"]["lemon"], "surface": info["cells"]}
    assert {key: int(n) for key, n in legend} == expected, (legend, expected)

    # switches
    segments = page.evaluate(f"{viewer}.data.line_types.map(t => t.segments)")
    assert page.evaluate(f"{viewer}.seen()") == {"segments": sum(segments), "vertices": 10}
    press(page, "button[data-key=max_largest]")
    assert count(page, orange) == 0
    assert page.evaluate(f"{viewer}.seen().segments") == sum(segments[1:])
    press(page, "button[data-key=max_largest]")
    assert count(page, orange) > 300
    press(page, "button[data-key=lemon]")
    assert page.evaluate(f"{viewer}.seen().vertices") == 6
    press(page, "button[data-key=lemon]")

    # sliders: from the middle on, half of the edges are left
    strength = sorted(page.evaluate(f"{viewer}.data.edges.strength"))
    page.evaluate("(() => { const s = document.querySelector('input[data-key=strength]'); s.value = 500;"
                  " s.dispatchEvent(new Event('input')); })()")
    each = page.evaluate(f"{viewer}.data.edges.points.map((n, e) => [n - 1, Math.fround({viewer}.data.edges.strength[e])])")
    left = sum(n for n, s in each if s >= strength[8])
    assert 0 < left < sum(segments) and page.evaluate(f"{viewer}.seen().segments") == left
    page.evaluate(f"{viewer}.setLeastStrength(0)")
    assert page.evaluate(f"{viewer}.seen().segments") == sum(segments)

    # picking: the lowest extremal point, an edge that leaves it, a cell beside it
    points = page.evaluate(f"{viewer}.data.vertices.point")
    top = next(v for v, p in enumerate(points) if abs(p[2]) > 0.99 and p[2] > 0)
    x, y = page.evaluate(f"{viewer}.placeOf({points[top]})")
    page.click(x, y)
    assert page.evaluate(f"{viewer}.selected()") == {"kind": "vertex", "id": top}
    shown = page.evaluate("document.getElementById('details').innerText").lower()
    assert f"vertex {top}" in shown and "extremal point" in shown and "-0.111111" in shown and "-0.250000" in shown, shown
    page.evaluate(f"{viewer}.select(null)")
    gold = (255, 212, 64)

    def lit():  # by hue, as the light changes brightness
        _, _, rows = browser.decode_png(page.screenshot())
        return sum(p[0] > 90 and p[2] < 0.62 * p[0] and p[1] > 0.7 * p[0] for row in rows for p in row[:1010])

    dark = lit()
    cell = page.evaluate(f"(() => {{ for (let d = 12; d < 80; ++d) {{ const e = {viewer}.pick({x} + d, {y} + d / 3);"
                         f" if (e?.kind === 'cell') return [e.id, {x} + d, {y} + d / 3]; }} }})()")
    page.click(cell[1], cell[2])
    assert page.evaluate(f"{viewer}.selected()") == {"kind": "cell", "id": cell[0]}
    assert lit() > dark + 3000, (lit(), dark)
    page.evaluate(f"{viewer}.select(null)")
    assert lit() == dark
    edge = page.evaluate(f"(() => {{ for (let d = 10; d < 200; ++d) for (const s of [-1, 1]) {{ const e = {viewer}.pick({x} + s * d, {y});"
                         f" if (e?.kind === 'edge') return [e.id, {x} + s * d]; }} }})()")
    page.click(edge[1], y)
    assert page.evaluate(f"{viewer}.selected()") == {"kind": "edge", "id": edge[0]}
    assert f"edge {edge[0]}" in page.evaluate("document.getElementById('details').innerText").lower()
    page.click(5, 400)  # beside the surface
    assert page.evaluate(f"{viewer}.selected()") is None
    assert page.evaluate("document.getElementById('details').hidden")

    # stereo: two pictures, each of the mesh, not the same
    press(page, "button[data-value=parallel]")
    _, _, rows = browser.decode_png(page.screenshot())
    half_width = page.evaluate("document.getElementById('canvas').clientWidth") // 2
    halves = [[(i, j) for j, row in enumerate(rows) for i, p in enumerate(row[a:a + half_width]) if near(p, orange)]
              for a in (0, half_width)]
    assert all(len(half) > 100 for half in halves) and halves[0] != halves[1]
    assert page.evaluate(f"{viewer}.render()") == 6
    press(page, "button[data-value=off]")

    # tints, turning, and back
    before = page.screenshot()
    press(page, "button[data-value=curvature]")
    assert page.screenshot() != before
    press(page, "button[data-value=cells]")
    page.drag(500, 420, 120, 40)
    page.settle()
    assert page.evaluate(f"Math.hypot({viewer}.placeOf({points[top]})[0] - {x}, {viewer}.placeOf({points[top]})[1] - {y})") > 5
    assert page.errors == [], page.errors

# the slider of the simplification: each of its levels is what 'simplify' makes
run("extract", "--formula", "x^2/9 + y^2/4 + z^2 + 0.001*sin(9*x)*cos(8*y + 1) = 1", "--box", "-4", "-3", "-2", "4", "3", "2", "--resolution", "32",
    "-o", "wavy.graphml", "--cells", "wavy.ply", "-o", "wavy.html", "--quiet")
with browser.Page(work / "wavy.html") as page:
    levels = page.evaluate(f"[...{viewer}.data.levels.level]")
    assert levels == sorted(set(levels)) and levels[0] == 0 and 15 < len(levels) <= 25, levels
    whole = page.screenshot()
    page.evaluate(f"{viewer}.setVisible('anchor', true)")
    for i in (0, len(levels) // 2, len(levels) - 1):
        run("simplify", "wavy.graphml", "--level", str(levels[i]), "-o", "level.json", "--quiet")
        level = json.loads((work / "level.json").read_text())
        page.evaluate(f"(() => {{ const s = document.querySelector('input[data-key=level]'); s.value = {i};"
                      " s.dispatchEvent(new Event('input')); })()")
        segments = {tuple(sorted((tuple(a), tuple(b)))) for e in level["edges"] for a, b in zip(e["polyline"], e["polyline"][1:])}
        assert page.evaluate(f"{viewer}.seen()") == {"segments": len(segments), "vertices": len(level["vertices"])}, levels[i]
        assert page.evaluate(f"{viewer}.data.levels.cells[{i}]") == len(level["cells"])
    shown = page.evaluate("document.querySelector('input[data-key=level]').parentElement.innerText").replace("\n", " ")
    assert f"{len(level['cells'])} cells" in shown, shown
    assert page.screenshot() != whole
    page.evaluate(f"{viewer}.setLevel(0), {viewer}.setVisible('anchor', false)")
    page.settle()
    assert page.errors == [], page.errors

# on a slow machine less is drawn while the picture moves: the strongest lines and their vertices, on a coarser surface; at rest all
run("extract", "--formula", "x^2/9 + y^2/4 + z^2 + 0.001*sin(9*x)*cos(8*y + 1) = 1", "--box", "-4", "-3", "-2", "4", "3", "2", "--resolution", "120",
    "-o", "fine.graphml", "--cells", "fine.ply", "-o", "fine.html", "--quiet")
with browser.Page(work / "fine.html") as page:
    def wait_for_rest():
        deadline = time.monotonic() + 120  # of a machine without a graphics processor that does other things, too
        while not page.evaluate(f"{viewer}.atRest()"):
            assert time.monotonic() < deadline, "the picture does not come to rest"
            time.sleep(0.05)

    def drawn(share=""):  # of a picture that is made now
        return page.evaluate(f"({viewer}.render({share}), {viewer}.drawn())")

    wait_for_rest()
    whole = page.evaluate(f"{viewer}.drawn()")
    assert whole["triangles"] > 50000, whole
    less = drawn(0.25)
    assert less["segments"] == -(-whole["segments"] // 4) and less["vertices"] == -(-whole["vertices"] // 4), (less, whole)
    assert 10000 < less["triangles"] < 50000, less
    assert drawn() == whole
    full = page.screenshot()
    element = page.evaluate(f"{viewer}.pick(500, 430)")
    assert element
    # among all that there is, whatever was drawn last
    assert page.evaluate(f"({viewer}.render(0.01), {viewer}.pick(500, 430))") == element
    assert drawn() == whole
    assert page.screenshot() == full
    page.drag(500, 420, 200, 60)
    wait_for_rest()
    assert page.evaluate(f"{viewer}.drawn()") == whole
    assert page.screenshot() != full
    assert page.errors == [], page.errors

# without a surface the lines are shown alone, those on the far side faded
run("view", "e.graphml", "-o", "lines.html")
with browser.Page(work / "lines.html") as page:
    assert page.evaluate(f"{viewer}.render()") == 2
    assert count(page, orange) > 300
    assert page.errors == [], page.errors
print("the viewer works")

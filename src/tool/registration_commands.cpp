// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "registration_commands.h"

#include "add_command.h"

namespace CGAL::Extremal_mesh_3::tool {

namespace {

void add_register(CLI::App& app, std::function<int()>& run) {
  const auto [c, o] =
      command(app, "register", "finds the motion that takes one extremal mesh to another", register_meshes, run);
  option(c, "A", o->a, "", graph_argument)->required();
  option(c, "B", o->b, "", graph_argument)->required();
  option(c, "-o,--output", o->output, "FILE", "write the motion, its errors and the matched vertices (.json)");
  option(c, "--tolerance", o->tolerance, "MM", "how far apart the same points may be (the side of a voxel, or σ)");
  c->add_flag("--scale", o->scale, "look for a uniform scale, too");
  c->add_flag("--mirror", o->mirror, "where there is no motion, try the mirror image");
  option(c, "--seed", o->seed, "N", "chooses which of many pairs are tried (1)");
  option(c, "--threads", o->threads, "N", "0: as many as there are cores (0)");
  c->add_flag("--json", o->json, "print one JSON object");
  c->add_flag("--quiet", o->quiet, "print errors only");
  c->footer("Exit code 1 if the two have nothing in common.\n"
            "Example:\n  extremal_mesh register before.graphml after.graphml -o motion.json");
}

void add_compare(CLI::App& app, std::function<int()>& run) {
  const auto [c, o] =
      command(app, "compare", "tells which part of one extremal mesh is found in another", compare, run);
  option(c, "A", o->a, "", graph_argument)->required();
  option(c, "B", o->b, "", graph_argument)->required();
  option(c, "--transform", o->transform, "FILE", "the motion from A to B, as 'register -o' wrote it (.json)");
  option(c, "--tolerance", o->tolerance, "MM", "how far apart the same points may be (the side of a voxel, or σ)");
  option(c, "-o,--output", o->outputs, "FILE", "write the table (.csv .json .txt); repeatable")
      ->allow_extra_args(false);
  option(c, "--threads", o->threads, "N", "0: as many as there are cores (0)");
  c->add_flag("--json", o->json, "print one JSON object");
  c->footer("Example:\n  extremal_mesh compare before.graphml after.graphml --transform motion.json -o table.csv");
}

void add_landmarks(CLI::App& app, std::function<int()>& run) {
  const auto [c, o] =
      command(app, "landmarks", "lists extremal points as landmarks, the strongest first", landmarks, run);
  option(c, "GRAPH", o->file, "", graph_argument)->required();
  option(c, "-o,--output", o->outputs, "FILE", "write them (.mrk.json for 3D Slicer, .csv); repeatable")
      ->allow_extra_args(false);
  option(c, "--most", o->most, "N", "so many, of each kind (all)");
  c->add_flag("--umbilics", o->umbilics, "umbilics, too");
  c->add_flag("--json", o->json, "print them as one JSON object");
  c->footer("Example:\n  extremal_mesh landmarks skull.graphml --most 50 -o skull.mrk.json -o skull.csv");
}

void add_match(CLI::App& app, std::function<int()>& run) {
  const auto [c, o] =
      command(app, "match", "tells how near given landmarks are to extremal points and lines", match, run);
  option(c, "GRAPH", o->file, "", graph_argument)->required();
  option(c, "LANDMARKS", o->landmarks, "", "files of landmarks (.mrk.json .csv)")->required();
  option(c, "--most", o->most, "N", "only the N strongest extremal points, and umbilics, count (all)");
  option(c, "-o,--output", o->output, "FILE", "write what is nearest to each (.csv)");
  c->add_flag("--json", o->json, "print one JSON object");
  c->footer("Example:\n  extremal_mesh match mouse.graphml landmarks.mrk.json --most 500");
}

void add_scale_space(CLI::App& app, std::function<int()>& run) {
  const auto [c, o] =
      command(app, "scale-space", "follows the extremal mesh of an image from scale to scale", scale_space, run);
  option(c, "IMAGE", o->file, "", "an image: .nrrd .nhdr .mha .mhd .nii .nii.gz .vtk")->required();
  option(c, "--iso", o->iso, "VALUE", "the value on the surface")->required();
  option(c, "--sigma", o->sigmas, "MM …", "the widths of the Gaussian")->required();
  option(c, "--tolerance", o->tolerance, "MM", "how far a vertex may move, plus half of the step of sigma (a voxel)");
  option(c, "-o,--output", o->output, "FILE", "write how many there are of what at each scale (.csv)");
  option(c, "--events", o->events, "FILE", "write what vertices become (.csv)");
  option(c, "--plot", o->plot, "FILE", "draw the numbers against sigma (.svg .png)");
  option(c, "--graphs", o->folder, "FOLDER", "write the graphs there, as sigma_….graphml");
  option(c, "--threads", o->threads, "N", "0: as many as there are cores (0)");
  c->add_flag("--json", o->json, "print the numbers as one JSON object");
  c->add_flag("--quiet", o->quiet, "print errors only");
  c->footer(
      "Example:\n  extremal_mesh scale-space skull.nii.gz --iso 300 --sigma 2 3 4 6 8 -o scales.csv --plot scales.svg");
}

} // namespace

void add_registration_commands(CLI::App& app, std::function<int()>& run) {
  add_register(app, run);
  add_compare(app, run);
  add_landmarks(app, run);
  add_match(app, run);
  add_scale_space(app, run);
}

} // namespace CGAL::Extremal_mesh_3::tool

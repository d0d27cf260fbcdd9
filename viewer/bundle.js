// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
//   node bundle.js [FILE]       the default is dist/viewer.js
//
// Makes one script of src/ and what it uses of three.js, with the licences of both. The same versions, which
// package-lock.json fixes, give the same bytes.
import { build } from "esbuild";
import { readFileSync } from "node:fs";

const licence = readFileSync(new URL("node_modules/three/LICENSE", import.meta.url), "utf8").trim();
await build({
  entryPoints: [new URL("src/main.js", import.meta.url).pathname],
  outfile: process.argv[2] ?? new URL("dist/viewer.js", import.meta.url).pathname,
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2020",
  charset: "ascii",
  legalComments: "none",
  logLevel: "warning",
  banner: {
    js: `/* The viewer of Extremal_mesh_3: Copyright (c) 2026 The Extremal_mesh_3 authors, GPL-3.0-or-later.\n` +
      `It contains three.js, of which this is the licence:\n\n${licence} */`,
  },
});

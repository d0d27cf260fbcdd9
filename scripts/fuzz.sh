#!/usr/bin/env bash
# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
#   scripts/fuzz.sh SECONDS [TARGET…]       the default is all targets, one after the other, SECONDS together
#
# Feeds the readers and the extraction with hostile bytes (libFuzzer of clang 14, address and undefined-behaviour sanitizers).
# What it learns stays in build/fuzz/corpus, what it finds in build/fuzz/findings: replayed by
# FUZZ_TARGET=NAME build/fuzz/test/fuzz/fuzzer FILE. The exit code is 1 if there was a finding.
#
# Variables: FUZZ_NO_BUILD=1 takes the fuzzer that is there, FUZZ_TIMEOUT is how many seconds an input may take (30; more on a busy
# machine), FUZZ_VALUE_PROFILE=0 learns less from comparisons and runs more inputs.
set -euo pipefail
cd "$(dirname "$0")/.."
if [[ ! ${1:-} =~ ^[0-9]+$ ]]; then
  echo "usage: $0 SECONDS [TARGET…]" >&2
  exit 2
fi
seconds=$1
shift
if [[ -z ${FUZZ_NO_BUILD:-} ]]; then
  source scripts/dependencies.sh
  install_dependencies "${fuzz_packages[@]}"
  cmake --preset fuzz >/dev/null
  cmake --build --preset fuzz --target fuzzer --parallel "$(nproc)" >/dev/null
fi
fuzzer=build/fuzz/test/fuzz/fuzzer
[[ -x $fuzzer ]] || { echo "$fuzzer is not there" >&2; exit 1; }
targets=("$@")
[[ $# -gt 0 ]] || mapfile -t targets < <(ls test/fuzz/corpus)
share=$((seconds / ${#targets[@]}))
[[ $share -gt 0 ]] || share=1

mkdir -p build/fuzz/findings
status=0 total=0
for target in "${targets[@]}"; do
  learned=build/fuzz/corpus/$target
  mkdir -p "$learned"
  log=build/fuzz/$target.log
  end=$((SECONDS + share)) executions=0
  while ((SECONDS < end)); do # after a finding it goes on
    code=0
    FUZZ_TARGET=$target ASAN_OPTIONS=allocator_may_return_null=0 LSAN_OPTIONS=suppressions=test/leak_suppressions.txt:print_suppressions=0 \
      "$fuzzer" -max_total_time=$((end - SECONDS)) -timeout="${FUZZ_TIMEOUT:-30}" -rss_limit_mb=3000 -malloc_limit_mb=1000 -max_len=65536 \
      -use_value_profile="${FUZZ_VALUE_PROFILE:-1}" -print_final_stats=1 -artifact_prefix="build/fuzz/findings/$target-" "$learned" "test/fuzz/corpus/$target" >"$log" 2>&1 || code=$?
    n=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
    executions=$((executions + ${n:-0}))
    [[ $code -eq 0 ]] && break
    status=1
    grep -m 3 -E 'ERROR|runtime error|what\(\)|Test unit written' "$log" || tail -3 "$log"
  done
  total=$((total + executions))
  echo "$target: $executions executions"
  rm -f /dev/shm/extremal_mesh_fuzz_*
done
echo "$total executions"
exit "$status"

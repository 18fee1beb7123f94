#!/bin/sh
# Builds the fuzz targets and runs them all, in 60 seconds together or in as many as are given: fuzz/run.sh [seconds]
# [target ...]. Ends with "fuzz: passed" and 0, or names the input that shows a defect and ends with 1.
#
# No nightly compiler is needed: the coverage counters are a pass of LLVM's that every compiler has. They go into what is
# built for the target only, which is why it is named; build scripts are left alone.
set -eu
cd "$(dirname "$0")"

seconds=${1:-60}
[ $# -gt 0 ] && shift
targets=${*:-c_calls gmsh vtu case}
host=$(rustc -vV | sed -n 's/^host: //p')
out=${CARGO_TARGET_DIR:-target}

# What the targets asked for need.
features() {
  case " $targets " in *" gmsh "* | *" vtu "*) printf 'meshes ' ;; esac
  case " $targets " in *" case "*) printf 'cases ' ;; esac
}

CARGO_TARGET_DIR=$out RUSTFLAGS="-Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4 \
  -Cllvm-args=-sanitizer-coverage-inline-8bit-counters -Cllvm-args=-sanitizer-coverage-pc-table \
  -Cllvm-args=-sanitizer-coverage-trace-compares -Ccodegen-units=1 -Clinker=${CC:-cc}" \
  ${CARGO:-cargo} build --release --target "$host" $(for t in $targets; do printf -- '--bin %s ' "$t"; done) \
  --no-default-features --features "$(features)"

count=$(set -- $targets; echo $#)
failed=
for target in $targets; do
  found=$out/fuzz/$target
  mkdir -p "$found/corpus" "$found/defects"
  log=$found/log
  # What is found is kept beside the build; the seeds are read, never written. A quarter of a gigabyte and 20 s are far
  # beyond what an input of this size needs.
  if "$out/$host/release/$target" -max_total_time=$((seconds / count)) -timeout=20 -rss_limit_mb=1024 -max_len=16384 \
    -seed="${FUZZ_SEED:-1}" -print_final_stats=1 -artifact_prefix="$found/defects/" \
    "$found/corpus" "corpus/$target" >"$log" 2>&1
  then
    runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
    covered=$(sed -n 's/.* cov: \([0-9]*\) .*/\1/p' "$log" | tail -1)
    echo "fuzz: $target: $runs runs, $covered places reached, nothing found"
  else
    tail -n 40 "$log"
    echo "fuzz: $target: a defect; the input is the file named above, in $(pwd)/$found/defects"
    failed=yes
  fi
done
if [ -n "$failed" ]; then
  echo "fuzz: failed"
  exit 1
fi
echo "fuzz: passed"

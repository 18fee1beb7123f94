#!/usr/bin/env bash
# Builds the fuzz targets and runs them: fuzz/run.sh [seconds | runs=N] [target …]
#
# All of them in 60 seconds together, or in as many as are given; or N executions in all. Ends with "fuzz: passed" and 0, or names the
# input that shows a defect and ends with 1: a crash, a panic, memory that is lost, or more than a second of processor time.
#
# No nightly compiler is needed: the coverage counters are a pass of LLVM's that every compiler has. They go into what is
# built for the target only, which is why it is named; build scripts are left alone.
set -euo pipefail
cd "$(dirname "$0")"

extent=${1:-60}
[ $# -gt 0 ] && shift
targets=${*:-c_calls gmsh inp vtu case}
host=$(rustc -vV | sed -n 's/^host: //p')
out=${CARGO_TARGET_DIR:-target}

# What the targets asked for need.
features() {
  case " $targets " in *" gmsh "* | *" inp "* | *" vtu "*) printf 'meshes ' ;; esac
  case " $targets " in *" case "*) printf 'cases ' ;; esac
}

CARGO_TARGET_DIR=$out RUSTFLAGS="-Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4 \
  -Cllvm-args=-sanitizer-coverage-inline-8bit-counters -Cllvm-args=-sanitizer-coverage-pc-table \
  -Cllvm-args=-sanitizer-coverage-trace-compares -Ccodegen-units=1 -Clinker=${CC:-cc}" \
  ${CARGO:-cargo} build --release --target "$host" $(for t in $targets; do printf -- '--bin %s ' "$t"; done) \
  --no-default-features --features "$(features)"

# By how many of them a processor makes in a second, so that all take about as long.
speed() {
  case $1 in c_calls) echo 3 ;; vtu) echo 5 ;; case) echo 8 ;; *) echo 10 ;; esac
}
count=0 speeds=0
for target in $targets; do
  count=$((count + 1)) speeds=$((speeds + $(speed "$target")))
done
share() {
  case $extent in
    runs=*) echo "-runs=$((${extent#runs=} / speeds * $(speed "$1") + speeds))" ;;
    *) echo "-max_total_time=$((extent / count))" ;;
  esac
}

# Input that takes longer than a second is written down; on a busy machine that says nothing, so its processor time is asked for: of
# a program of several calls that of the longest.
TIMEFORMAT='%U'
is_slow() { # TARGET INPUT
  local seconds said
  said=$(mktemp)
  seconds=$({ time FMC_FUZZ_TIMED=yes "$out/$host/release/$1" "$2" >"$said" 2>&1; } 2>&1 | tail -1)
  seconds=$(sed -n 's/^longest call: \([0-9.]*\) s$/\1/p' "$said" | sort -g | tail -1 | grep . || echo "$seconds")
  rm "$said"
  awk -v seconds="$seconds" 'BEGIN { exit !(seconds > 1) }'
}

failed= total=0
for target in $targets; do
  found=$out/fuzz/$target
  mkdir -p "$found/corpus" "$found/defects"
  rm -f "$found/defects"/slow-unit-*
  log=$found/log
  # What is found is kept beside the build; the seeds are read, never written. A gigabyte and 60 s are far beyond what an input of
  # this size needs.
  if "$out/$host/release/$target" "$(share "$target")" -timeout=60 -report_slow_units=1 -rss_limit_mb=1024 -max_len=8192 \
    -seed="${FUZZ_SEED:-1}" -print_final_stats=1 -artifact_prefix="$found/defects/" \
    "$found/corpus" "corpus/$target" >"$log" 2>&1
  then
    runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
    covered=$(sed -n 's/.* cov: \([0-9]*\) .*/\1/p' "$log" | tail -1)
    total=$((total + runs))
    verdict="nothing found"
    for input in "$found/defects"/slow-unit-*; do
      if [ -e "$input" ] && is_slow "$target" "$input"; then
        verdict="TOO SLOW: $(pwd)/$input"
        failed=yes
      fi
    done
    echo "fuzz: $target: $runs runs, $covered places reached, $verdict"
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
[ -z "${SAID:-}" ] || echo "$total runs" >"$SAID"
echo "fuzz: passed, $total runs"

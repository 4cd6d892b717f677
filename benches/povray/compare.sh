#!/usr/bin/env bash
# Vitrine's classic renderer against POV-Ray 3.7 on one scene: CPU time (user + system) of the whole process, from the
# scene file to the PNG file, for 1 and 2 threads. Both take one sample a pixel, the same depth and every shadow point.
# The runs alternate, so that whatever else the machine does meets both alike. Prints a table in Markdown for
# benches/runs/DATE-povray.md; the pictures stay for a look at whether they are the same.
#
#   benches/povray/compare.sh [SCENE [RUNS]]
set -euo pipefail
export LC_ALL=C
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

scene=${1:-scenes/coursework/benchmark.vitrine.toml}
runs=${2:-9}
folder=$(mktemp -d "${TMPDIR:-/tmp}/vitrine-povray.XXXXXX")
command -v povray >/dev/null || { echo "POV-Ray is missing: apt install povray" >&2; exit 1; }

echo "building …" >&2
cargo build --release --quiet --package vitrine-cli --bin vitrine
cargo build --release --quiet --package vitrine-benches --example to_povray
target=$(cargo metadata --no-deps --format-version 1 | sed 's/.*"target_directory":"\([^"]*\)".*/\1/')
vitrine="$target/release/vitrine"
read -r width height < <("$target/release/examples/to_povray" "$scene" "$folder/scene.pov")

run_vitrine() { # THREADS
    "$vitrine" render "$scene" -o "$folder/vitrine-$1.png" --renderer classic --samples 1 --threads "$1" \
        --set settings.shadow_error=0
}

run_povray() { # THREADS
    povray "+I$folder/scene.pov" "+O$folder/povray-$1.png" +FN "+W$width" "+H$height" -A -D -GA "+WT$1"
}

# CPU seconds of a program for so many threads, as a line of its record.
measure() { # PROGRAM THREADS
    local TIMEFORMAT='%3U %3S' times
    times=$({ time "run_$1" "$2" >"$folder/$1.log" 2>&1; } 2>&1) || { cat "$folder/$1.log" >&2; exit 1; }
    awk '{ print $1 + $2 }' <<<"$times" >>"$folder/$1-$2.times"
}

# Median, least and greatest of a record.
summary() { # PROGRAM THREADS
    sort -n "$folder/$1-$2.times" | awk '
        { v[NR] = $1 }
        END { m = NR % 2 ? v[(NR + 1) / 2] : (v[NR / 2] + v[NR / 2 + 1]) / 2; print m, v[1], v[NR] }'
}

for ((run = 0; run <= runs; run++)); do
    # The first run warms the caches and does not count.
    for threads in 1 2; do measure vitrine "$threads"; measure povray "$threads"; done
    if ((run == 0)); then rm "$folder"/*.times; fi
    echo "run $run of $runs" >&2
done

cat <<TABLE
- Date: $(date -u +%F). Machine: $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores.
- Programs: $("$vitrine" --version), commit $(git rev-parse --short HEAD); POV-Ray $(povray --version 2>&1 | sed -n 's/^POV-Ray //p').
- Scene: \`$scene\`, ${width}×${height}, one sample a pixel. CPU seconds (user + system) of the whole process, scene
  file to PNG; median of $runs runs (least to greatest), the programs in turn.

| threads | Vitrine | POV-Ray | POV-Ray ÷ Vitrine |
|---|---|---|---|
TABLE
for threads in 1 2; do
    read -r a a_min a_max < <(summary vitrine "$threads")
    read -r b b_min b_max < <(summary povray "$threads")
    awk -v t="$threads" -v a="$a" -v al="$a_min" -v ah="$a_max" -v b="$b" -v bl="$b_min" -v bh="$b_max" 'BEGIN {
        printf "| %d | %.3f (%.3f–%.3f) | %.3f (%.3f–%.3f) | %.1f |\n", t, a, al, ah, b, bl, bh, b / a }'
done
echo "Pictures, to be looked at: $folder/*.png" >&2

#!/usr/bin/env bash
# Kills the program (SIGKILL) 20 times at random moments while things are added and the scene is saved by real mouse and keys.
# Afterwards every file must be sound, and no more than the last 10 seconds of work may be lost.
# Usage: cargo build --release && crates/editor/window/kill.sh [times]. Needs python3 besides what window.sh needs.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/window.sh"
times=${1:-20}
RANDOM=${SEED:-1}
now() { date +%s%N | cut -c1-13; } # milliseconds

start_display
SETTLE=2
for run in $(seq "$times"); do
    export VITRINE_HOME=$work/home-$run
    mkdir -p "$VITRINE_HOME"
    scene=$VITRINE_HOME/scene.vitrine.toml
    "$vitrine" templates empty -o "$scene" >/dev/null
    start_program edit "$scene"
    end=$(($(now) + 1500 + RANDOM % 24000))
    edits=()
    saves=0
    while [ "$(now)" -lt "$end" ]; do
        xdotool mousemove 225 52 click 1 # Sphere
        edits+=("$(now)")
        if [ $((RANDOM % 4)) = 0 ]; then xdotool key --clearmodifiers ctrl+s; saves=$((saves + 1)); fi
        sleep "0.$((RANDOM % 6 + 1))"
    done
    kill -9 "$program"
    killed=$(now)
    wait "$program" 2>/dev/null || true
    shot "killed-$run"

    # What is older than 10 seconds must be there; an edit takes a moment to arrive.
    expected=0
    for at in "${edits[@]}"; do [ "$at" -lt $((killed - 10500)) ] && expected=$((expected + 1)); done
    for file in "$scene" "$scene.bak"; do
        [ ! -e "$file" ] || "$vitrine" check "$file" >/dev/null || { echo "run $run: $file is broken" >&2; exit 1; }
    done
    best=$(grep -c '^shape = "sphere"' "$scene" || true)
    for kept in "$VITRINE_HOME"/state/autosave/*.toml; do
        [ -e "$kept" ] || continue
        python3 - "$kept" "$VITRINE_HOME/recovered.vitrine.toml" <<'PY'
import sys, tomllib
with open(sys.argv[1], "rb") as kept:
    text = tomllib.load(kept)["text"]
with open(sys.argv[2], "w") as recovered:
    recovered.write(text)
PY
        "$vitrine" check "$VITRINE_HOME/recovered.vitrine.toml" >/dev/null || { echo "run $run: $kept is broken" >&2; exit 1; }
        count=$(grep -c '^shape = "sphere"' "$VITRINE_HOME/recovered.vitrine.toml" || true)
        [ "$count" -le "$best" ] || best=$count
    done
    left=$(find "$VITRINE_HOME" -name '*.part' | wc -l)
    echo "run $run: ${#edits[@]} edits, $saves saves; $best kept, $expected were older than 10 s; $left unfinished files left over"
    [ "$best" -ge "$expected" ] || { echo "run $run: work was lost" >&2; exit 1; }
done
echo "passed: killed $times times"

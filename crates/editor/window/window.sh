# What the scripts beside this one share: a display of their own, the program in it, mouse and keys, counted.
# Needs Debian's xvfb, xauth, xdotool, openbox and imagemagick. Source it; it cleans up after itself.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
vitrine=${VITRINE:-$root/target/release/vitrine}
work=$(mktemp -d)
shots=${SHOTS:-$work}
inputs=0
pids=()

for tool in Xvfb xdotool import compare openbox; do
    command -v "$tool" >/dev/null || { echo "$tool is missing: apt-get install xvfb xauth xdotool openbox imagemagick" >&2; exit 2; }
done
[ -x "$vitrine" ] || { echo "build the program first: cargo build --release" >&2; exit 2; }
mkdir -p "$shots"

finish() {
    for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null || true; done
    wait 2>/dev/null || true
    rm -rf "$work"
}
trap finish EXIT

# A display with a window manager: without one nothing is ever in the foreground.
start_display() {
    Xvfb -displayfd 3 -screen 0 1280x800x24 -nolisten tcp 3>"$work/display" >/dev/null 2>&1 &
    pids+=($!)
    for _ in $(seq 100); do
        [ -s "$work/display" ] && break
        sleep 0.1
    done
    [ -s "$work/display" ] || { echo "there is no display" >&2; exit 2; }
    DISPLAY=":$(cat "$work/display")"
    export DISPLAY
    # No frame around the window: its corner is the screen's.
    mkdir -p "$work/openbox"
    cat >"$work/openbox/rc.xml" <<'RC'
<?xml version="1.0"?>
<openbox_config xmlns="http://openbox.org/3.4/rc">
  <applications><application class="*"><decor>no</decor><position force="yes"><x>0</x><y>0</y></position></application></applications>
</openbox_config>
RC
    openbox --config-file "$work/openbox/rc.xml" >/dev/null 2>&1 &
    pids+=($!)
    sleep 0.5
}

# Starts the program with a home of its own and waits for its window.
start_program() {
    export VITRINE_HOME=${VITRINE_HOME:-$work/home}
    export LIBGL_ALWAYS_SOFTWARE=1
    unset WAYLAND_DISPLAY WAYLAND_SOCKET
    "$vitrine" "$@" >"$work/out" 2>&1 &
    program=$!
    pids+=("$program")
    for _ in $(seq 150); do
        window=$(xdotool search --onlyvisible --pid "$program" 2>/dev/null | tail -1 || true)
        [ -n "$window" ] && break
        kill -0 "$program" 2>/dev/null || { echo "the program ended: $(cat "$work/out")" >&2; exit 1; }
        sleep 0.1
    done
    [ -n "$window" ] || { echo "there is no window" >&2; exit 1; }
    xdotool windowfocus "$window" 2>/dev/null || true
    sleep "${SETTLE:-1.5}"
}

# One input each.
click() { xdotool mousemove "$1" "$2" sleep 0.15 click 1; inputs=$((inputs + 1)); sleep "${3:-0.4}"; }
press() { xdotool key --clearmodifiers "$1"; inputs=$((inputs + 1)); sleep "${2:-0.4}"; }

shot() { import -window root "$shots/$1.png"; }

#!/usr/bin/env python3
"""Vitrine's photoreal renderer against Mitsuba 3's path tracer, on the scenes in benches/scenes.

Two questions. Do both show the same picture? The means of both pictures are compared, and the difference is searched for
structure. How much noise does a second of work leave? The cost of a renderer is relMSE x CPU seconds on one thread; it does
not depend on the number of samples for a renderer without bias, so the ratio of two costs is the ratio of the times to the same
noise.

relMSE is the mean over all pixels and channels of Var / (m^2 + e^2): Var is the variance among independent runs (no reference
is needed for what has no bias), m the pixel's mean over its channels, e a hundredth of the picture's mean. No outlier is left out.
CPU seconds are user + system: for Vitrine of the whole process, from the scene file to the EXR file; for Mitsuba of the call that
renders, without loading and compiling, by the faster of its variants scalar_rgb and llvm_ad_rgb. For the noise Mitsuba has its box
filter, which is its fastest; for the picture the same Gaussian as Vitrine.

    pip install mitsuba==3.9.1 numpy        (llvm_ad_rgb needs LLVM 19: apt install libllvm19)
    benches/mitsuba/compare.py [SCENE ...] [--runs N] [--seconds S] [--noise-only] [--out FOLDER]

Prints a table in Markdown for benches/runs/DATE-photoreal.md; the pictures stay for a look. Ends with 1 if a mean is off by more
than both 0.5 % and three standard errors, or if the difference has structure.
"""

import argparse
import datetime
import json
import os
import pickle
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import drjit
import mitsuba as mi
import numpy as np

ROOT = Path(__file__).resolve().parents[2]
SCENES = ["pane", "tank", "case", "ball", "cornell", "diffuse"]
# Samples a pixel of each run, of both programs.
SAMPLES = 64
# Pixels along the edge of the blocks in which the difference is searched for structure.
BLOCK = 8
MOST_OFF = 0.005


def build():
    # Without the window, which takes long to build.
    for arguments in (["-p", "vitrine-cli", "--no-default-features"], ["-p", "vitrine-benches", "--bin", "to_mitsuba"]):
        subprocess.run(["cargo", "build", "--release", "--quiet", *arguments], cwd=ROOT, check=True)
    data = subprocess.run(
        ["cargo", "metadata", "--no-deps", "--format-version", "1"], cwd=ROOT, check=True, capture_output=True
    )
    return Path(json.loads(data.stdout)["target_directory"]) / "release"


def read(path):
    return np.array(mi.Bitmap(str(path)).convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.Float32, False), dtype=np.float64)


class Vitrine:
    def __init__(self, binaries, scene, folder):
        self.program, self.scene, self.folder = binaries / "vitrine", scene, folder

    def render(self, seed):
        out = self.folder / "vitrine.exr"
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(
            [self.program, "render", self.scene, "-o", out, "--samples", str(SAMPLES), "--threads", "1"]
            + ["--set", f"settings.seed={seed}"],
            check=True,
            capture_output=True,
        )
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return read(out), after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


class Mitsuba:
    def __init__(self, variant, xml, is_box):
        drjit.set_thread_count(1)
        mi.set_variant(variant)
        mi.set_log_level(mi.LogLevel.Error)
        text = Path(xml).read_text()
        if is_box:
            text = text.replace('<rfilter type="gaussian"/>', '<rfilter type="box"/>')
        self.scene = mi.load_string(text)

    def render(self, seed):
        start = time.process_time()
        picture = np.array(mi.render(self.scene, spp=SAMPLES, seed=seed), dtype=np.float64)
        return picture[..., :3], time.process_time() - start


class Runs:
    """Sums of independent pictures."""

    def __init__(self):
        self.count, self.seconds = 0, 0.0
        self.sum = self.squares = self.blocks = self.block_squares = 0.0
        self.means = []

    def add(self, picture, seconds):
        block = blocks(picture)
        self.count += 1
        self.seconds += seconds
        self.sum = self.sum + picture
        self.squares = self.squares + picture**2
        self.blocks = self.blocks + block
        self.block_squares = self.block_squares + block**2
        self.means.append(picture.mean())

    def mean(self):
        return self.sum / self.count

    def variance(self):
        """Of one picture, pixel by pixel."""
        return (self.squares - self.sum**2 / self.count) / (self.count - 1)

    def block_mean(self):
        return self.blocks / self.count

    def block_error(self):
        """The variance of the blocks' means over all runs."""
        return (self.block_squares - self.blocks**2 / self.count) / (self.count - 1) / self.count

    def whole(self):
        """The picture's mean and its standard error."""
        return np.mean(self.means), np.std(self.means, ddof=1) / np.sqrt(self.count)

    def cost(self, mean):
        level = mean.mean(axis=2, keepdims=True)
        rel = (self.variance() / (level**2 + (0.01 * mean.mean()) ** 2)).mean()
        return rel * self.seconds / self.count


def blocks(picture):
    height, width = (n // BLOCK * BLOCK for n in picture.shape[:2])
    cut = picture[:height, :width].mean(axis=2)
    return cut.reshape(height // BLOCK, BLOCK, width // BLOCK, BLOCK).mean(axis=(1, 3))


def structure(ours, theirs):
    """The greatest difference of two blocks in standard errors, and the mean square of all."""
    error = np.sqrt(ours.block_error() + theirs.block_error())
    z = (ours.block_mean() - theirs.block_mean()) / np.maximum(error, 1e-12)
    return np.abs(z).max(), (z**2).mean(), z


def repeat(renderer, seconds, least, first_seed):
    """As many runs as fit into so many CPU seconds, and no fewer than `least`."""
    runs = Runs()
    renderer.render(first_seed - 1)
    while runs.count < least or runs.seconds < seconds:
        runs.add(*renderer.render(first_seed + runs.count))
    return runs


def repeat_mitsuba(variant, xml, is_box, seconds, least, first_seed):
    """The same in a process of its own: one process bears one variant."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "runs"
        task = [variant, xml, is_box, seconds, least, first_seed, out]
        subprocess.run([sys.executable, __file__, "--task", pickle.dumps(task).hex()], check=True)
        return pickle.loads(out.read_bytes())


def do_task(task):
    variant, xml, is_box, seconds, least, first_seed, out = pickle.loads(bytes.fromhex(task))
    runs = repeat(Mitsuba(variant, xml, is_box), seconds, least, first_seed)
    out.write_bytes(pickle.dumps(runs))


def write(path, picture):
    mi.Bitmap(picture.astype(np.float32)).write(str(path))


def compare(name, binaries, options):
    scene = ROOT / "benches" / "scenes" / f"{name}.vitrine.toml"
    folder = options.out / name
    folder.mkdir(parents=True, exist_ok=True)
    xml = folder / "scene.xml"
    subprocess.run([binaries / "to_mitsuba", scene, xml], check=True)

    ours = repeat(Vitrine(binaries, scene, folder), options.seconds / 4, options.runs, 1)
    write(folder / "vitrine-mean.exr", ours.mean())
    row = {"scene": name, "ours": ours.cost(ours.mean()), "ours_rate": rate(ours)}
    for variant in ("scalar_rgb", "llvm_ad_rgb"):
        box = repeat_mitsuba(variant, xml, True, options.seconds / 2, options.runs, 1)
        found = {"variant": variant, "theirs": box.cost(ours.mean()), "rate": rate(box)}
        # Of two, the one that draws more samples a second: their noise is the same.
        if "rate" not in row or found["rate"] > row["rate"]:
            row.update(found)
    if not options.noise_only:
        theirs = repeat_mitsuba(row["variant"], xml, False, options.seconds, options.runs, 1000)
        write(folder / "mitsuba-mean.exr", theirs.mean())
        write(folder / "difference.exr", ours.mean() - theirs.mean())
        (a, da), (b, db) = ours.whole(), theirs.whole()
        row["off"], row["error"] = a / b - 1.0, np.hypot(da / a, db / b)
        row["greatest"], row["square"], z = structure(ours, theirs)
        write(folder / "difference-z.exr", np.repeat(z[..., None], 3, axis=2))
    return row


def rate(runs):
    """Millions of samples a CPU second."""
    return runs.count * SAMPLES * runs.mean().shape[0] * runs.mean().shape[1] / runs.seconds / 1e6


def is_wrong(row):
    if "off" not in row:
        return False
    return abs(row["off"]) > max(MOST_OFF, 3.0 * row["error"])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", default=SCENES)
    parser.add_argument("--runs", type=int, default=12, help="the least number of runs of each")
    parser.add_argument("--seconds", type=float, default=60.0, help="CPU seconds for Mitsuba's picture")
    parser.add_argument("--noise-only", action="store_true", help="measure costs alone")
    parser.add_argument("--out", type=Path, default=Path(tempfile.gettempdir()) / "vitrine-mitsuba")
    parser.add_argument("--task", help=argparse.SUPPRESS)
    options = parser.parse_args()
    mi.set_variant("scalar_rgb")
    if options.task:
        do_task(options.task)
        return 0
    binaries = build()
    rows = []
    for name in options.scenes:
        rows.append(compare(name, binaries, options))
        print(rows[-1], file=sys.stderr)
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=ROOT, capture_output=True, text=True).stdout.strip()
    model = next((l.split(":")[1].strip() for l in open("/proc/cpuinfo") if l.startswith("model name")), "unknown")
    print(f"- Date: {datetime.date.today()}. Machine: {model}, {os.cpu_count()} cores, one thread for each program.")
    print(f"- Programs: Vitrine, commit {commit}; Mitsuba {mi.__version__}, `path`, depth and roulette by default.")
    print()
    print("| scene | cost, Vitrine | cost, Mitsuba | ratio | samples a second, Vitrine | Mitsuba | mean off | standard error | blocks: greatest z, mean z² |")
    print("|---|---|---|---|---|---|---|---|---|")
    for r in rows:
        means = f"{100 * r['off']:+.2f} % | {100 * r['error']:.2f} % | {r['greatest']:.1f}, {r['square']:.2f}" if "off" in r else "| |"
        print(
            f"| {r['scene']} | {r['ours']:.3g} | {r['theirs']:.3g} | {r['theirs'] / r['ours']:.3g} "
            f"| {r['ours_rate']:.2f} M | {r['rate']:.2f} M ({r['variant']}) | {means} |"
        )
    print(f"Pictures, to be looked at: {options.out}", file=sys.stderr)
    return 1 if any(is_wrong(r) for r in rows) else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Plots where the time of each frame goes.

    latency_plot.py PICTURE --output latency.png [--server HOST:PORT] [--frames N]

Sends the picture again and again, moved a little each time, so that nothing is reused. Writes a plot, and beside it the
numbers as CSV; only those where matplotlib is missing.
"""

import argparse
import csv
import pathlib
import sys

import cv2
import numpy as np

import amalgam


def arguments():
    parser = argparse.ArgumentParser(description="Plots where the time of each frame goes.")
    parser.add_argument("picture", type=pathlib.Path, help="with the scene's marker in it")
    parser.add_argument("--server", default="127.0.0.1:7447", metavar="HOST:PORT")
    parser.add_argument("--frames", type=int, default=60)
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("latency.png"))
    return parser.parse_args()


def moved(picture, count):
    """The picture as a camera in an unsteady hand would see it."""
    height, width = picture.shape[:2]
    for number in range(count):
        shift = width / 40 * np.array([np.sin(number / 5), np.cos(number / 7)])
        yield cv2.warpAffine(picture, np.float32([[1, 0, shift[0]], [0, 1, shift[1]]]), (width, height),
                             borderMode=cv2.BORDER_REPLICATE)


def write_csv(path, names, composites):
    with open(path, "w", newline="") as file:
        table = csv.writer(file)
        table.writerow(["frame", "latency_ms", "server_ms", *[f"{name}_ms" for name in names]])
        for number, c in enumerate(composites):
            table.writerow([number, round(c.latency_ms, 3), round(c.server_ms, 3),
                            *[round(c.stages.get(name, 0.0), 3) for name in names]])


def plot(path, names, composites):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot

    frames = range(len(composites))
    # The longest stages have a color of their own.
    times = {name: np.array([c.stages.get(name, 0.0) for c in composites]) for name in names}
    longest = sorted(names, key=lambda name: -times[name].sum())[:7]
    rest = sum((times[name] for name in names if name not in longest), np.zeros(len(frames)))
    figure, axes = pyplot.subplots(figsize=(9, 4.5))
    axes.stackplot(frames, *[times[name] for name in longest], rest, labels=[*longest, "other stages"],
                   colors=pyplot.get_cmap("tab10").colors[:len(longest)] + ((0.8, 0.8, 0.8),), linewidth=0)
    axes.plot(frames, [c.server_ms for c in composites], color="black", linewidth=1, linestyle="--",
              label="server, waiting included")
    axes.plot(frames, [c.latency_ms for c in composites], color="black", linewidth=1.5, label="capture to composite")
    axes.set(xlabel="frame", ylabel="milliseconds", ylim=(0, None), xlim=(0, max(len(frames) - 1, 1)))
    axes.set_title("Where the time of a frame goes")
    axes.legend(loc="center left", bbox_to_anchor=(1, 0.5), frameon=False)
    figure.savefig(path, dpi=110, bbox_inches="tight")


def main():
    options = arguments()
    picture = cv2.imread(str(options.picture), cv2.IMREAD_COLOR | cv2.IMREAD_IGNORE_ORIENTATION)
    if picture is None:
        sys.exit(f"latency_plot: {options.picture} cannot be read")
    camera = amalgam.Camera.from_fov(picture.shape[1], picture.shape[0])
    try:
        with amalgam.connect(options.server, camera=camera) as session:
            session.send(picture, timeout=60)  # a server's first frame makes what later ones reuse
            composites = [session.send(frame) for frame in moved(picture, options.frames)]
    except amalgam.AmalgamError as error:
        sys.exit(f"latency_plot: {error}")
    names = list(dict.fromkeys(name for c in composites for name in c.stages if name != "total"))
    write_csv(options.output.with_suffix(".csv"), names, composites)
    try:
        plot(options.output, names, composites)
    except ImportError:
        print("matplotlib is missing (apt install python3-matplotlib): only the numbers were written", file=sys.stderr)
    latencies = [c.latency_ms for c in composites]
    print(f"{len(composites)} frames, median {np.median(latencies):.1f} ms, worst {max(latencies):.1f} ms")


if __name__ == "__main__":
    main()

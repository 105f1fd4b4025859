#!/usr/bin/env python3
"""Composites all pictures of a folder.

    composite_folder.py PICTURES OUTPUT [--server HOST:PORT] [--calibration FILE] [--token-file FILE] [--ca PEM]

Pictures of another size than the first one are scaled to it. Exit codes: 0 all were composited, 1 some were skipped,
2 none could be, or there is no server.
"""

import argparse
import pathlib
import sys
import time

import cv2

import amalgam

POSE_HOLD = 0.3  # seconds; PROTOCOL.md, CameraFrame, "Holding"
SUFFIXES = {".jpg", ".jpeg", ".png", ".webp", ".bmp", ".tif", ".tiff"}


def arguments():
    parser = argparse.ArgumentParser(description="Composites all pictures of a folder.")
    parser.add_argument("pictures", type=pathlib.Path, help="folder")
    parser.add_argument("output", type=pathlib.Path, help="folder; a composite has its picture's name, as .jpg")
    parser.add_argument("--server", default="127.0.0.1:7447", metavar="HOST:PORT")
    parser.add_argument("--calibration", type=pathlib.Path, help="OpenCV's file; without it 60 degrees are assumed")
    parser.add_argument("--token-file", type=pathlib.Path, help="the server's secret")
    parser.add_argument("--ca", type=pathlib.Path, help="encrypt, and trust these certificates (PEM)")
    return parser.parse_args()


def note(text):
    """Above the progress line."""
    sys.stderr.write(f"\r\033[K{text}\n" if sys.stderr.isatty() else f"{text}\n")


def progress(done, count, name):
    if sys.stderr.isatty():
        sys.stderr.write(f"\r\033[K{done}/{count} {name}" if done < count else "\r\033[K")


def composite_all(session, files, size, output):
    """How many were composited."""
    composited = 0
    sent = -POSE_HOLD
    for number, file in enumerate(files):
        progress(number, len(files), file.name)
        picture = cv2.imread(str(file), cv2.IMREAD_COLOR | cv2.IMREAD_IGNORE_ORIENTATION)
        if picture is None:
            note(f"{file.name}: skipped, it cannot be read")
            continue
        same = (picture.shape[1], picture.shape[0]) == size
        # The server draws objects on for a moment when their marker is lost. These pictures are no film.
        time.sleep(max(0.0, sent + POSE_HOLD - time.monotonic()))
        sent = time.monotonic()
        try:
            composite = session.send(file if same else cv2.resize(picture, size, interpolation=cv2.INTER_AREA))
        except (amalgam.FrameRejected, amalgam.FrameTimeout) as error:
            note(f"{file.name}: skipped, {error}")
            continue
        (output / file.with_suffix(".jpg").name).write_bytes(composite.jpeg)
        if not composite.poses:
            note(f"{file.name}: no marker was found, it is as it was")
        composited += 1
    progress(len(files), len(files), "")
    return composited


def check_names(files):
    """Pictures that differ in their suffix only would overwrite each other's composites."""
    by_stem = {}
    for file in files:
        other = by_stem.setdefault(file.stem, file)
        if other != file:
            raise ValueError(f"{other.name} and {file.name} would both become {file.stem}.jpg")


def first_size(files):
    for file in files:
        picture = cv2.imread(str(file), cv2.IMREAD_COLOR | cv2.IMREAD_IGNORE_ORIENTATION)
        if picture is not None:
            return picture.shape[1], picture.shape[0]
    raise ValueError("no picture can be read")


def main():
    options = arguments()
    try:
        files = sorted(f for f in options.pictures.iterdir() if f.suffix.lower() in SUFFIXES)
        check_names(files)
        size = first_size(files)
        calibration = options.calibration
        camera = amalgam.Camera.from_file(calibration, size) if calibration else amalgam.Camera.from_fov(*size)
        token = options.token_file.read_text().strip() if options.token_file else ""
        options.output.mkdir(parents=True, exist_ok=True)
        with amalgam.connect(options.server, camera=camera, token=token, tls=options.ca is not None,
                             ca=options.ca) as session:
            composited = composite_all(session, files, size, options.output)
            unchanged = f"{session.counts.unchanged} of them without any object"
    except (amalgam.AmalgamError, OSError, ValueError) as error:
        note(f"composite_folder: {error}")
        return 2
    print(f"{composited} of {len(files)} pictures composited, {unchanged}")
    return 0 if composited == len(files) else 1 if composited else 2


if __name__ == "__main__":
    sys.exit(main())

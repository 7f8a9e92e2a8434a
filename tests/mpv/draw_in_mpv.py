#!/usr/bin/env python3
"""Draws a picture with user shaders in mpv, on a display of its own, and saves what the window shows.

    draw_in_mpv.py --size 640x360 --shader look.glsl --frame 1 source.png result.png

The window has the given size, and the last shader fills it. With --frame N the same picture is
drawn N times, as frames 1 to N at 60 per second. Several shaders are applied one after the other.
Messages of mpv about shaders go to standard error, and end the program with 1.

Needs the Debian packages mpv, xvfb and libgl1-mesa-dri.
"""

import argparse
import contextlib
import json
import os
import pathlib
import socket
import subprocess
import sys
import tempfile
import time

# Without these, mpv would convert colours, add noise or hide the picture behind texts.
OPTIONS = """
    --no-config --vo=gpu --gpu-api=opengl --gpu-context=x11egl --opengl-es=no --gpu-sw=yes
    --gpu-dumb-mode=no --fbo-format=rgba16f --gpu-shader-cache-dir=
    --dither-depth=no --deband=no --scale=bilinear --correct-downscaling=no --linear-downscaling=no
    --linear-upscaling=no --sigmoid-upscaling=no --scaler-resizes-only=yes --interpolation=no
    --keepaspect=no --video-unscaled=no --icc-profile-auto=no --target-trc=auto --target-prim=auto
    --tone-mapping=clip --hdr-compute-peak=no --gamut-mapping-mode=clip --alpha=no
    --screenshot-format=png --screenshot-png-compression=1 --screenshot-tag-colorspace=no
    --no-audio --no-osc --osd-level=0 --no-terminal --load-scripts=no --ytdl=no
    --input-default-bindings=no --no-input-cursor --cursor-autohide=no --autofit=
    --force-window-position=yes --no-border --pause --keep-open=always --image-display-duration=inf
    --mf-fps=60 --hr-seek=yes --video-sync=audio --framedrop=no --untimed=yes --hwdec=no
    --vd-lavc-threads=1 --sub-auto=no --audio-file-auto=no --cache=no
""".split()


@contextlib.contextmanager
def running(command, **settings):
    """Runs a program until the end of the block, then ends it by its id."""
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, **settings)
    try:
        yield process
    finally:
        process.terminate()
        try:
            process.wait(5)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()


@contextlib.contextmanager
def display(width, height):
    """A virtual screen of this size. Gives its name, such as ':99'."""
    reader, writer = os.pipe()
    command = ["Xvfb", "-displayfd", str(writer), "-screen", "0", f"{width}x{height}x24", "-nolisten", "tcp"]
    with running(command, pass_fds=[writer], stderr=subprocess.DEVNULL):
        os.close(writer)
        with os.fdopen(reader) as answer:
            yield ":" + answer.readline().strip()


class Player:
    """Commands for a running mpv, over its JSON socket."""

    def __init__(self, path, process, limit):
        self.end = time.monotonic() + limit
        self.socket = self.connect(path, process)
        self.lines = self.socket.makefile("r", encoding="utf-8")

    def connect(self, path, process):
        connection = socket.socket(socket.AF_UNIX)
        while True:
            try:
                connection.connect(path)
                connection.settimeout(max(0.1, self.end - time.monotonic()))
                return connection
            except OSError:
                if process.poll() is not None or time.monotonic() > self.end:
                    raise SystemExit("mpv did not start. Install mpv.") from None
                time.sleep(0.01)

    def ask(self, *command):
        """Sends a command. Gives its answer with `error` and `data`."""
        self.socket.sendall((json.dumps({"command": command}) + "\n").encode())
        for line in self.lines:
            answer = json.loads(line)
            if "error" in answer:
                return answer
        raise SystemExit("mpv ended too early.")

    def wait_for(self, name, wanted):
        """Waits until a property has the wanted value."""
        while self.ask("get_property", name).get("data") != wanted:
            if time.monotonic() > self.end:
                raise SystemExit(f"mpv did not reach {name} = {wanted}.")
            time.sleep(0.01)

    def show_frame(self, number):
        """Draws frames one after the other until this one, from 1."""
        self.wait_for("vo-configured", True)
        self.wait_for("estimated-frame-number", 0)
        for index in range(1, number):
            self.ask("frame-step")
            self.wait_for("estimated-frame-number", index)
            self.wait_for("pause", True)


def environment(screen):
    """Software drawing in one thread, so that each run gives the same numbers."""
    return os.environ | {"DISPLAY": screen, "LIBGL_ALWAYS_SOFTWARE": "1", "LP_NUM_THREADS": "0"}


def command_of(arguments, folder):
    frames = ",".join([str(arguments.source.absolute())] * (arguments.frame + 1))
    shaders = [f"--glsl-shaders-append={path.absolute()}" for path in arguments.shader]
    return ["mpv", *OPTIONS, f"--geometry={arguments.size}+0+0", *shaders, *arguments.option,
            f"--log-file={folder}/log", "--msg-level=all=warn,vo/gpu=v", f"--input-ipc-server={folder}/socket",
            "mf://" + frames]


def problems(log):
    """Lines of the log with warnings and errors of the output."""
    lines = log.read_text(encoding="utf-8", errors="replace").splitlines()
    return [line for line in lines if ("][e][" in line or "][w][vo/gpu" in line) and "software renderer" not in line]


def draw(arguments):
    width, height = map(int, arguments.size.split("x"))
    with tempfile.TemporaryDirectory() as folder, display(width, height) as screen:
        with running(command_of(arguments, folder), env=environment(screen), stderr=subprocess.DEVNULL) as mpv:
            player = Player(f"{folder}/socket", mpv, arguments.limit)
            player.show_frame(arguments.frame)
            answer = player.ask("screenshot-to-file", str(arguments.result.absolute()), "window")
            player.ask("quit")
            mpv.wait(5)
        log = pathlib.Path(folder, "log")
        if arguments.log:
            arguments.log.write_bytes(log.read_bytes())
        found = problems(log)
    if answer["error"] != "success":
        found.append("The picture could not be saved: " + answer["error"])
    print(*found, sep="\n", end="\n" if found else "", file=sys.stderr)
    return 1 if found else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("source", type=pathlib.Path)
    parser.add_argument("result", type=pathlib.Path)
    parser.add_argument("--size", required=True, help="of the window in pixels, such as 640x360")
    parser.add_argument("--shader", type=pathlib.Path, action="append", default=[])
    parser.add_argument("--frame", type=int, default=1)
    parser.add_argument("--limit", type=float, default=60, help="seconds until the program gives up")
    parser.add_argument("--option", action="append", default=[], help="another option for mpv")
    parser.add_argument("--log", type=pathlib.Path, help="keep the log of mpv")
    sys.exit(draw(parser.parse_args()))


if __name__ == "__main__":
    main()

"""Portable looks, drawn by a player that shares no code with the program: docs/portable.md.

The second argument is the path of the player.
"""

import json
import os
import subprocess
import sys
import zlib
from pathlib import Path
from struct import pack

PLAYER = Path(sys.argv.pop(2) if len(sys.argv) > 2 else "build/release/tests/portable_player").resolve()

from program import ProgramTest, main, read_png, run  # takes the first argument

SIZE = "128x96"
FRAMES = (1, 16, 60)
MOST = 3        # of 255, in any pixel
USUAL = 1       # of 255, in all pixels but this share
SHARE = 0.001

LOOKS = ("phosphor", "crt", "shadow-mask", "vector-beam", "caffeine")
PRESETS = (("phosphor", "radar-p7"), ("vector-beam", "arcade-monitor"), ("shadow-mask", "test-card"),
           ("vector-beam+shadow-mask", "web-runner"))
SIGNALS = ("waveform:ch2=noise,trigger_source=2,slope=falling,o1=1,layout=overlaid,sdiv=0.003", "fm:mode=xy",
           "text:HELLO,spin=90,fit=crop",
           "drawing:strokes=[L-0.5 0 0.5 0;S0 -0.7 0 0.7 0.2 0.3z][L-0.5 0 0.5 0.5],hold=0.05")

# A look with all kinds of blending, feedback, sampler, target and size.
PASSES = [
    {"name": "trail", "format": "rgba16f", "size": ["$WIDTH / 2 + $count % 4", "round(max($HEIGHT * 0.4, 7))"],
     "inputs": {"later": "sum@1", "own": {"from": "trail@2", "wrap": "repeat"}, "old": "source@3"}},
    {"name": "whole", "format": "rgba16ui", "scale": [0.5, 0.25],
     "inputs": {"image": {"from": "source", "wrap": "mirror"}}},
    {"name": "signed", "format": "r32i", "scale_of": "source", "scale": 1, "inputs": {"image": "whole"}},
    {"name": "product", "format": "rgba8", "blend": "multiply", "repeat": "count",
     "inputs": {"image": {"from": "source", "mipmap": True}}},
    {"name": "sum", "format": "rgba32f", "blend": "add", "accumulate": True, "repeat": 3, "converge": 20,
     "inputs": {"image": {"from": "lut", "wrap": "border", "mipmap": True}}},
    {"name": "mean", "format": "rgba32f", "blend": "alpha", "accumulate": True, "converge": "enough",
     "inputs": {"image": "data"}},
    {"name": "spiral", "format": "rgba16f", "repeat": 5, "frame_modulo": 7,
     "inputs": {"before": {"from": "spiral@1", "wrap": "border"}, "image": "product"}},
    {"name": "grey", "format": "rgba8", "blend": "maximum", "one_channel": "$count > 2",
     "inputs": {"image": {"from": "spiral", "mipmap": True}}, "set": {"level": 2.5, "tint": [0.5, 1, 2]}},
    {"name": "show", "format": "rgba16f",
     "inputs": {"trail": "trail", "whole": "whole", "signed_numbers": "signed", "product": "product", "sum": "sum",
                "mean": "mean", "spiral": {"from": "spiral@3"},
                "grey": {"from": "grey", "mipmap": True, "wrap": "mirror"}}},
]
SHADERS = {
    "trail": """uniform sampler2D later, own, old; uniform float u_time; uniform int count = 3;
void main() { color = 0.02 * texture(later, uv) + 0.5 * texture(own, uv * 1.5 - 0.2) + 0.3 * texture(old, uv)
                      + 0.05 * sin(u_time * 7.0); }""",
    "whole": """uniform sampler2D image; void main() { color = uvec4(texture(image, uv * 3.0 - 1.0) * 65535.0); }""",
    "signed": """uniform usampler2D image; uniform vec2 u_source_resolution; uniform vec3 u_source_lines;
void main() { color = ivec4(int(texture(image, uv).x) - 30000
                            + int(u_source_resolution.x + 1e3 * u_source_lines.y)); }""",
    "product": """uniform sampler2D image; uniform int u_samples; uniform float lod = 1.3;  // @range 0 5
void main() { color = 0.6 + 0.4 * textureLod(image, uv + 0.01 * float(u_samples), lod); }""",
    "sum": """uniform sampler2D image; uniform int u_samples;
void main() { color = vec4(fract(float(u_samples) * 0.618) * textureLod(image, uv * 1.4 - 0.2, 2.0).rgb, 1.0); }""",
    "mean": """uniform sampler2D image; uniform int u_samples; uniform int enough = 9; uniform mat4 u_view, u_camera;
void main() { vec4 p = u_camera * u_view * vec4(uv, 0.3, 1.0);
              color = vec4(texture(image, p.xy + 0.01 * float(u_samples)).rgb, 1.0 / float(u_samples + 1)); }""",
    "spiral": """uniform sampler2D before, image; uniform int u_frame; uniform bvec2 flags = bvec2(true, false);
uniform mat3x2 place = mat3x2(1.0, 0.0, 0.0, 1.0, 0.01, 0.0);
void main() { color = 0.8 * texture(before, place * vec3(uv, 1.0) * 0.98) + 0.2 * texture(image, uv)
                      + 0.01 * float(u_frame);
              if (flags.x) color.b *= 0.9; }""",
    "grey": """uniform sampler2D image; uniform float level; uniform vec3 tint;
void main() { color = vec4(tint, 1.0) * textureLod(image, uv, level); }""",
    "show": """uniform sampler2D trail, product, sum, mean, spiral, grey; uniform usampler2D whole;
uniform isampler2D signed_numbers; uniform vec3 paint = vec3(0.3, 0.6, 0.9);  // @color
void main() {
    vec2 g = fract(uv * 3.0);
    vec4 all[9] = vec4[](texture(trail, g), vec4(texture(whole, g)) / 65535.0,
                         0.5 + vec4(texture(signed_numbers, g)) / 65535.0, texture(product, g), texture(sum, g) / 60.0,
                         texture(mean, g), texture(spiral, g), textureLod(grey, g * 2.0 - 0.5, 1.5), vec4(paint, 1.0));
    color = all[int(uv.x * 3.0) + 3 * int(uv.y * 3.0)];
    color.rgb *= color.rgb;
}""",
}


def png_of(width, height, pixel):
    """An RGBA PNG."""
    def chunk(kind, body):
        return pack(">I", len(body)) + kind + body + pack(">I", zlib.crc32(kind + body))
    rows = b"".join(b"\0" + bytes(c for x in range(width) for c in pixel(x, y)) for y in range(height))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


class PortablePlayerTest(ProgramTest):
    def start_player(self, *arguments):
        return subprocess.Popen([PLAYER, *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                text=True, env={**os.environ, "MESA_DEBUG": "1"})

    def play(self, *arguments):
        """The exit code and the messages."""
        player = self.start_player(*arguments)
        messages = player.communicate(timeout=60)[1]
        return player.returncode, messages

    def source_of(self, folder):
        """The source of a description as options for the program."""
        content = json.loads((folder / "portable.json").read_text()).get("source", {}).get("content")
        if content is None:
            return ()
        defaults = [one for one in ("fit=stretch", "prescaled=1") if one.split("=")[0] + "=" not in content]
        return "--source", ",".join([f"{folder}/{content}", *defaults])

    def differences(self, frame):
        """Of a frame from 1: the largest of all pixels, and the share of pixels beyond the usual one."""
        ours, theirs = (read_png(self.folder / f"{name}_{frame - 1:04d}.png") for name in ("program", "player"))
        self.assertEqual(ours[:2], theirs[:2])
        largest, beyond = 0, 0
        for a, b in zip(ours[2], theirs[2]):
            if a == b:
                continue
            values = [abs(x - y) for x, y in zip(a, b)]
            largest = max(largest, *values)
            beyond += sum(max(values[i:i + 3]) > USUAL for i in range(0, len(values), 3))
        return largest, beyond / (ours[0] * ours[1])

    def compare(self, look, *options, frames=FRAMES, source=()):
        with self.subTest(" ".join(map(str, (look, *options, *source)))):
            folder = self.folder / "exported"
            self.assert_done(run("export", look, *options, *source, "--to", "portable", "-o", folder))
            drawn = ("--frames", max(frames), "--size", SIZE, "-o")
            player = self.start_player(folder, *drawn, self.folder / "player_%04d.png")
            rendered = run("render", look, *options, *self.source_of(folder), *drawn, self.folder / "program_%04d.png")
            messages = player.communicate(timeout=60)[1]
            self.assert_done(rendered)
            self.assertEqual((player.returncode, messages), (0, ""))
            for frame in frames:
                largest, beyond = self.differences(frame)
                self.assertLessEqual(largest, MOST, f"frame {frame}")
                self.assertLessEqual(beyond, SHARE, f"frame {frame}")

    def test_looks(self):
        for look in LOOKS:
            self.compare(look)
        self.compare("phosphor+crt", frames=FRAMES[:2])

    def test_presets(self):
        for look, preset in PRESETS:
            self.compare(look, "--preset", preset, frames=(10,))

    def test_signals_as_points_and_segments(self):
        for signal in SIGNALS:
            self.compare("phosphor", "--signal", signal, frames=(5,))
        self.compare("phosphor", "--signal", SIGNALS[0], "--set", "beam_kind=Segments", frames=(5,))

    def test_every_kind_of_pass(self):
        picture = png_of(64, 40, lambda x, y: (4 * x, 6 * y, (x // 8 + y // 8) % 2 * 200, 255 - (x * y) % 99))
        for name, text in SHADERS.items():
            kind = {"whole": "uvec4", "signed": "ivec4"}.get(name, "vec4")
            self.write(f"all/{name}.frag", f"#version 410 core\nin vec2 uv;\nout {kind} color;\n{text}\n")
        self.write("all/picture.png", picture)
        look = self.write("all/look.json", json.dumps({
            "format": "afterglow-look", "version": 1, "driven_by": "picture", "output": "linear", "orbit": True,
            "default_source": "picture.png,fit=crop", "source_encoding": "display",
            "images": {"lut": "picture.png",
                       "data": {"file": "picture.png", "linear": True, "wrap": "mirror", "filter": "nearest"}},
            "passes": [{**one, "fragment": one["name"] + ".frag"} for one in PASSES]})).parent
        self.compare(look, "--set", "orbit_turn=20,30,40", "--set", "orbit_azimuth=25", "--set", "orbit_elevation=40",
                     frames=(1, 2, 12))
        self.compare(look, "--set", "enough=0", frames=(2,),
                     source=("--source", f"{look}/picture.png,fit=integer,shape=4:3"))

    def test_problems_name_their_file(self):
        self.assertEqual(self.play(self.folder)[0], 2)
        arguments = ("--frames", 1, "--size", SIZE, "-o", self.folder / "x.png")
        code, messages = self.play(self.folder / "missing", *arguments)
        self.assertEqual(code, 1)
        self.assertIn("missing/portable.json", messages)
        folder = self.folder / "exported"
        self.assert_done(run("export", "caffeine", "--to", "portable", "-o", folder))
        shader = next((folder / "shaders").glob("0-*.frag"))
        shader.write_text("#version 410 core\nvoid main() { nothing(); }\n")
        code, messages = self.play(folder, *arguments)
        self.assertEqual(code, 1)
        self.assertIn(shader.name, messages)
        self.assertFalse((self.folder / "x.png").exists())


if __name__ == "__main__":
    main()

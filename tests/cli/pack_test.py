"""Packs: written on one machine, installed on another. docs/packs.md."""

import json
import os
import stat
import struct
import wave
import zipfile

from program import ProgramTest, main, read_png, run

SHADER = """// SPDX-License-Identifier: MIT
// Written by A. Person
#version 410 core
#include "tint.glsl"
in vec2 uv;
out vec4 color;
uniform float gain = 1.0;  // @range 0 2
void main() { color = vec4(tint(uv) * gain, 0.0, 1.0); }
"""
TINT = "vec2 tint(vec2 at) { return at.yx; }\n"
MANIFEST = {"format": "afterglow-look", "version": 1, "name": "Glow", "author": "Ann", "license": "MIT",
            "driven_by": "nothing", "passes": [{"name": "show", "fragment": "show.frag"}]}
SIZE = ("--size", "64x36", "--frames", "2")


class PackTest(ProgramTest):
    """`one` writes packs and `two` installs them. Each is a home folder."""

    def at(self, home, *arguments, cwd=None):
        folder = self.folder / home
        return run(*arguments, cwd=cwd, HOME=str(folder), XDG_DATA_HOME=str(folder / "data"),
                   XDG_STATE_HOME=str(folder / "state"), XDG_CACHE_HOME=str(folder / "cache"))

    def data(self, home):
        return self.folder / home / "data/afterglow"

    def files(self, home="two"):
        """The files in the user's folder, with their contents."""
        return {str(file.relative_to(self.data(home))): file.read_bytes()
                for file in self.data(home).rglob("*") if file.is_file()}

    def look(self, name="glow", home="one", shader=SHADER, **keys):
        folder = self.data(home) / "shaders" / name
        self.write(folder / "look.json", json.dumps({**MANIFEST, **keys}))
        self.write(folder / "show.frag", shader)
        return folder

    def preset(self, look, name, home="one", **keys):
        document = {"format": "afterglow-preset", "version": 1, "look": look, "name": name.title(), **keys}
        return self.write(self.data(home) / "presets" / look / f"{name}.json", json.dumps(document))

    def pack(self, *arguments):
        file = self.folder / "mine.afterglow"
        self.assert_done(self.at("one", "pack", *arguments, "-o", file))
        return file

    def install(self, file, home="two"):
        done = self.at(home, "pack", "--install", file, "--json")
        self.assert_done(done)
        return json.loads(done.stdout)

    def picture(self, home, *arguments):
        file = self.folder / f"{home}.png"
        self.assert_done(self.at(home, "render", *arguments, *SIZE, "-o", file))
        return read_png(file)  # without the preset in the file

    def sound(self, file):
        file.parent.mkdir(parents=True, exist_ok=True)
        with wave.open(str(file), "wb") as wav:
            wav.setparams((2, 2, 48000, 0, "NONE", ""))
            wav.writeframes(bytes(range(256)) * 200)
        return file

    def status(self, installed):
        return {item["id"]: item["status"] for item in installed["looks"] + installed["presets"]}


class WrittenPacks(PackTest):
    def test_a_look_with_a_preset_is_the_same_on_another_machine(self):
        folder = self.look()
        self.write(self.data("one") / "shaders/include/tint.glsl", TINT)
        self.write(folder / "LICENSE", "MIT")
        for name in (".secret", "show.frag~", ".git/config"):
            self.write(folder / name, "private")
        (folder / "link").symlink_to("/etc/passwd")
        self.preset("glow", "warm", values={"gain": 0.25})
        file = self.pack("glow")
        with zipfile.ZipFile(file) as archive:
            self.assertEqual(sorted(archive.namelist()), [
                "pack.json", "presets/glow/warm.json", "shaders/glow/LICENSE", "shaders/glow/look.json",
                "shaders/glow/show.frag", "shaders/glow/tint.glsl", "thumbnails/glow--warm.png", "thumbnails/glow.png"])
            contents = json.loads(archive.read("pack.json"))
            self.assertEqual(contents["looks"][0]["license"], "MIT")
            sources = {source["file"]: source for source in contents["sources"]}
            self.assertEqual(sources["shaders/glow/show.frag"]["license"], "MIT")
            self.assertIn("A. Person", sources["shaders/glow/show.frag"]["notice"])
            self.assertEqual(sources["shaders/glow/tint.glsl"]["license"], "not stated")
            for name in ("thumbnails/glow.png", "thumbnails/glow--warm.png"):
                self.assertEqual(struct.unpack(">II", archive.read(name)[16:24]), (240, 135))
        before = file.read_bytes()
        self.assertEqual(self.pack("glow").read_bytes(), before)  # same command, same bytes
        self.assertEqual(self.status(self.install(file)), {"glow": "added", "glow/warm": "added"})
        self.assertEqual(self.picture("two", "glow", "--preset", "warm"), self.picture("one", "glow", "--preset", "warm"))
        self.assertIn("shaders/glow/look.png", self.files())

    def test_file_managers_get_a_thumbnail_without_drawing_the_pack(self):
        self.look(shader=SHADER.replace('#include "tint.glsl"', TINT))
        preset = self.preset("glow", "warm")
        file = self.pack("glow")
        with zipfile.ZipFile(file) as archive:
            stored = archive.read("thumbnails/glow.png")
        small = self.folder / "small.png"
        for given, width in ((file, 240), (preset, 240), (self.data("one") / "shaders/glow/look.json", 240)):
            self.assert_done(self.at("one", "thumbnail", given, "-o", small))
            self.assertEqual(struct.unpack(">I", small.read_bytes()[16:20]), (width,))
        self.assert_done(self.at("two", "thumbnail", file, "-o", small))
        self.assertEqual(small.read_bytes(), stored)
        self.assert_refused(self.at("one", "thumbnail", self.write("x.afterglow", "x"), "-o", small), "x.afterglow")

    def test_a_preset_brings_only_itself(self):
        self.look(shader=SHADER.replace('#include "tint.glsl"', TINT))
        self.preset("glow", "warm")
        cold = self.preset("glow", "cold")
        with zipfile.ZipFile(self.pack(cold)) as archive:
            self.assertEqual([name for name in archive.namelist() if name.startswith("presets")],
                             ["presets/glow/cold.json"])

    def test_the_sound_and_the_picture_of_presets_come_along(self):
        shader = SHADER.replace('#include "tint.glsl"', TINT).replace(
            "uniform float gain = 1.0;", "uniform sampler2D card;  // @label \"Card\"\nuniform float gain = 1.0;").replace(
            "tint(uv)", "texture(card, uv).rg")
        self.look(shader=shader)
        sound = self.sound(self.folder / "one/music/loop.wav")
        (self.folder / "one/shots").mkdir()
        self.assert_done(self.at("one", "render", "crt", *SIZE, "-o", self.folder / "one/shots/card.png"))
        self.preset("vector-beam", "tune", signal={"kind": "audio", "file": "../../../../music/loop.wav"})
        self.preset("glow", "card", values={"card": str(self.folder / "one/shots/card.png")})
        file = self.pack(self.data("one") / "presets/vector-beam/tune.json", "glow")
        self.assertEqual(self.status(self.install(file)), {
            "vector-beam": "present", "glow": "added", "vector-beam/tune": "added", "glow/card": "added"})
        sound.unlink()
        (self.folder / "one/shots/card.png").rename(self.folder / "card.png")
        tune = json.loads(self.files()["presets/vector-beam/tune.json"])["signal"]["file"]
        self.assertRegex(tune, r"^mine-[0-9a-f]{8}/loop\.wav$")
        for look, preset in (("vector-beam", "tune"), ("glow", "card")):
            self.picture("two", look, "--preset", preset)  # fails without the file
        self.assertEqual(self.status(self.install(file)), {
            "vector-beam": "present", "glow": "present", "vector-beam/tune": "present", "glow/card": "present"})

    def test_shaders_of_other_programs_keep_the_places_of_their_files(self):
        tree = self.folder / "one/slang"
        self.write(tree / "common/tone.inc", "vec3 tone(vec3 light) { return light.bgr; }\n")
        self.write(tree / "shaders/swap.slang", """#version 450
// License: public domain
layout(push_constant) uniform Push { float amount; } params;
#pragma parameter amount "Amount" 0.5 0.0 1.0 0.1
layout(std140, set = 0, binding = 0) uniform UBO { mat4 MVP; } global;
#include "../common/tone.inc"
#pragma stage vertex
layout(location = 0) in vec4 Position;
layout(location = 1) in vec2 TexCoord;
layout(location = 0) out vec2 at;
void main() { gl_Position = global.MVP * Position; at = TexCoord; }
#pragma stage fragment
layout(location = 0) in vec2 at;
layout(location = 0) out vec4 FragColor;
layout(set = 0, binding = 2) uniform sampler2D Source;
void main() { FragColor = vec4(mix(texture(Source, at).rgb, tone(texture(Source, at).rgb), params.amount), 1.0); }
""")
        self.write(tree / "presets/swap.slangp", "shaders = 1\nshader0 = ../shaders/swap.slang\n")
        self.write(tree / "presets/COPYING", "public domain")
        self.preset("swap.slangp", "full", values={"amount": 1})
        file = self.pack(tree / "presets/swap.slangp")
        with zipfile.ZipFile(file) as archive:
            self.assertLess({"shaders/swap.slangp/common/tone.inc", "shaders/swap.slangp/presets/COPYING",
                             "shaders/swap.slangp/shaders/swap.slang"}, set(archive.namelist()))
        self.assertEqual(self.status(self.install(file)), {"swap.slangp": "added", "swap.slangp/full": "added"})
        self.assertIn("swap.slangp", self.at("two", "list", "looks").stdout)
        expected = self.picture("one", tree / "presets/swap.slangp", "--preset", "full")
        self.assertEqual(self.picture("two", "swap.slangp", "--preset", "full"), expected)
        # another one of the same name
        changed = self.data("two") / "shaders/swap.slangp/common/tone.inc"
        changed.write_text("vec3 tone(vec3 light) { return light.grb; }\n")
        self.assertEqual(self.status(self.install(file)),
                         {"swap-2.slangp": "renamed", "swap-2.slangp/full": "added"})
        self.assertEqual(self.picture("two", "swap-2.slangp", "--preset", "full"), expected)

    def test_what_cannot_be_packed_is_named(self):
        broken = self.look("broken", shader=SHADER.replace("gain = 1.0;", "gain = 1.0"))
        outside = self.look("outside", shader=SHADER.replace("tint.glsl", "../far.glsl"))
        self.write(self.data("one") / "shaders/far.glsl", TINT)
        lost = self.preset("phosphor", "lost", signal={"kind": "audio", "file": "gone.wav"})
        target = self.write("old.afterglow", "old")
        for argument, words in ((broken, ("show.frag:",)), (outside, ("show.frag:4", "far.glsl", "outside")),
                                (lost, ("lost.json", "gone.wav", "not found")), ("none", ("none",))):
            self.assert_refused(self.at("one", "pack", argument, "-o", target), *words)
            self.assertEqual(target.read_text(), "old")
        with open(self.data("one") / "shaders/outside/large.raw", "wb") as large:
            large.truncate(2_100_000_000)  # a sparse file
        self.look("outside", shader=SHADER.replace('#include "tint.glsl"', TINT))
        self.assert_refused(self.at("one", "pack", "outside", "-o", target), "2100 MB", "2000 MB")
        self.assertEqual(target.read_text(), "old")
        self.assert_refused(self.at("one", "pack", "crt", "-o", "x.zip"), ".afterglow", code=2)
        self.assert_refused(self.at("one", "pack", "-o", "x.afterglow"), "LOOK", code=2)
        self.assert_refused(self.at("one", "pack", "crt"), "--output", code=2)
        self.assert_refused(self.at("one", "pack", "crt", "--install", target), "--install", code=2)


class InstalledPacks(PackTest):
    def archive(self, entries, manifest=None, name="made.afterglow"):
        """A pack with one good look, these further entries, and changes of its pack.json."""
        contents = {"format": "afterglow-pack", "version": 1, "name": "Made", "looks": [
            {"id": "good", "name": "Good", "author": "", "license": "", "folder": "shaders/good"}], "presets": [],
            "sources": [], **(manifest or {})}
        file = self.folder / name
        with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("pack.json", json.dumps(contents))
            archive.writestr("shaders/good/look.json", json.dumps(MANIFEST))
            archive.writestr("shaders/good/show.frag", "not GLSL: nothing is compiled")
            for entry, content in entries:
                archive.writestr(entry, content)
        return file

    def assert_nothing_added(self, file, *words):
        outside = sorted(self.folder.rglob("*"))
        self.assert_refused(self.at("two", "pack", "--install", file), file.name, *words)
        self.assertEqual(self.files(), {})
        self.assertEqual([path for path in sorted(self.folder.rglob("*")) if path not in outside
                          and "/two" not in str(path)], [])

    def test_shaders_are_not_compiled_and_what_is_not_listed_is_left_out(self):
        self.install(self.archive([("extra/file", "x"), ("presets/good/unlisted.json", "x")]))
        # The list of looks would draw a look without a picture.
        self.assertEqual(set(self.files()), {"shaders/good/look.json", "shaders/good/look.png", "shaders/good/show.frag"})

    def test_names_that_lead_outside_are_refused(self):
        for name in ("../up", "shaders/../../../up", "/tmp/afterglow-absolute", "shaders\\..\\up", "C:/up", "a\nb"):
            self.assert_nothing_added(self.archive([(name, "x")]))

    def test_links_and_special_files_are_refused(self):
        for kind in (stat.S_IFLNK, stat.S_IFIFO, stat.S_IFCHR):
            entry = zipfile.ZipInfo("shaders/good/link")
            entry.create_system = 3
            entry.external_attr = (kind | 0o777) << 16
            self.assert_nothing_added(self.archive([(entry, "/etc/passwd")]), "link or special file")

    def test_names_that_differ_in_case_only_are_refused(self):
        self.assert_nothing_added(self.archive([("shaders/good/SHOW.frag", "x")]), "case")
        self.assert_nothing_added(self.archive([("shaders/Good/other", "x")]), "case")
        self.assert_nothing_added(self.archive([("shaders/good/look.json/x", "x")]), "twice")

    def test_too_much_is_refused(self):
        many = [(f"shaders/good/{number}", "") for number in range(10_000)]
        self.assert_nothing_added(self.archive(many), "10003", "10000")
        self.assert_nothing_added(self.archive([("shaders/good/zeros", bytes(10_000_000))]), "100 times")
        file = self.archive([("shaders/good/large", b"x" * 100)])
        data = bytearray(file.read_bytes())
        for mark, offset in ((b"PK\x01\x02", 24), (b"PK\x03\x04", 22)):  # the unpacked size, in both headers
            at = -1
            while (at := data.find(mark, at + 1)) >= 0:
                if b"large" in data[at:at + 80]:
                    data[at + offset:at + offset + 4] = struct.pack("<I", 2_100_000_000)
        file.write_bytes(data)
        self.assert_nothing_added(file, "2000 MB")

    def test_a_size_that_is_stated_too_small_is_refused(self):
        file = self.archive([("shaders/good/large", os.urandom(5000))])
        data = bytearray(file.read_bytes())
        for mark, offset in ((b"PK\x01\x02", 24), (b"PK\x03\x04", 22)):
            at = -1
            while (at := data.find(mark, at + 1)) >= 0:
                if b"large" in data[at:at + 80]:
                    data[at + offset:at + offset + 4] = struct.pack("<I", 10)
        file.write_bytes(data)
        self.assert_nothing_added(file)

    def test_damaged_files_are_refused(self):
        good = self.archive([("shaders/good/noise", os.urandom(20000))]).read_bytes()
        for name, content in (("empty", b""), ("text", b"hello"), ("cut", good[:len(good) // 2]),
                              ("flipped", good[:3000] + bytes([good[3000] ^ 255]) + good[3001:])):
            self.assert_nothing_added(self.write(f"{name}.afterglow", content))
        with zipfile.ZipFile(self.folder / "plain.afterglow", "w") as archive:
            archive.writestr("readme", "x")
        self.assert_nothing_added(self.folder / "plain.afterglow", "pack.json")
        self.assert_refused(self.at("two", "pack", "--install", "none.afterglow"), "none.afterglow")

    def test_errors_of_the_contents_name_the_pack_and_the_line(self):
        preset = json.dumps({"format": "afterglow-preset", "version": 1, "look": "good", "name": "P"})
        listed = {"look": "good", "name": "P", "author": "", "file": "presets/good/p.json"}
        look = {"id": "good", "name": "", "author": "", "license": "", "folder": "shaders/good"}
        for manifest, entries, words in (
                ({"version": 2}, [], ("pack.json:", "version")),
                ({"odd": 1}, [], ("pack.json:", "odd")),
                ({"looks": [{**look, "id": "../up"}]}, [], ("pack.json:", "'id'")),
                ({"looks": [{**look, "folder": "shaders/../.."}]}, [], ("pack.json:", "shaders/")),
                ({"looks": [{**look, "folder": "presets/good"}]}, [], ("pack.json:", "shaders/")),
                ({"looks": [{**look, "file": "../a.slangp"}]}, [], ("pack.json:", "'file'")),
                ({"looks": [look, look]}, [], ("good",)),
                ({"looks": [{**look, "folder": "shaders/none"}]}, [], ("missing",)),
                ({"presets": [listed]}, [], ("p.json",)),
                ({"presets": [{**listed, "look": "crt"}]}, [("presets/good/p.json", preset)], ("p.json", "crt")),
                ({"presets": [listed]}, [("presets/good/p.json", preset.replace('"version": 1', '"version": 9'))],
                 ("p.json", "version"))):
            with self.subTest(manifest):
                self.assert_nothing_added(self.archive(entries, manifest), *words)

    def test_nothing_is_overwritten(self):
        self.look(shader="mine", home="two")
        self.preset("glow", "warm", home="two", values={"gain": 2})
        before = self.files()
        self.look(shader=SHADER.replace('#include "tint.glsl"', TINT))
        self.preset("glow", "warm", values={"gain": 0.5})
        self.preset("glow+crt", "both", values={"glow/gain": 0.5, "crt/exposure": 2})
        file = self.pack("glow+crt", "glow")
        self.assertEqual(self.status(self.install(file)), {
            "glow-2": "renamed", "crt": "present", "glow-2/warm": "added", "glow-2+crt/both": "added"})
        after = self.files()
        self.assertEqual({name: after[name] for name in before}, before)
        both = json.loads(after["presets/glow-2+crt/both.json"])
        self.assertEqual((both["look"], both["values"]), ("glow-2+crt", {"glow-2/gain": 0.5, "crt/exposure": 2}))
        self.picture("two", "glow-2+crt", "--preset", "both")
        self.assertNotIn("added", self.status(self.install(file)).values())
        self.assertEqual(self.files(), after)


main()

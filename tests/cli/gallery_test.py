"""Galleries: a web page of presets with live pages. docs/gallery.md."""

import json
import re
from urllib.parse import unquote

from program import ProgramTest, main, read_png, run

SHADER = """#version 410 core
uniform float gray = 0.25;  // @range 0 1  @unit "cd"  @group "Lamp"
uniform vec3 tint = vec3(1.0);  // @color @label "Tint"  @group "Lamp"
out vec4 color;
void main() { color = vec4(gray * tint, 1.0); }
"""
MANIFEST = {"format": "afterglow-look", "version": 1, "name": "Glow", "about": "One lamp", "author": "Ann",
            "license": "MIT", "driven_by": "nothing", "settle_frames": 1,
            "passes": [{"name": "show", "fragment": "show.frag"}]}
ISF = """/*{ "ISFVSN": "2", "INPUTS": [{ "NAME": "level", "TYPE": "float", "DEFAULT": 0.5 }] }*/
void main() { gl_FragColor = vec4(vec3(level), 1.0); }
"""
HOSTILE = "</script><img src=x onerror='alert(1)'>\"&\n{}"


class GalleryTest(ProgramTest):
    def at(self, *arguments):
        return run(*arguments, cwd=self.folder, HOME=str(self.folder), XDG_DATA_HOME=str(self.folder / "data"),
                   XDG_STATE_HOME=str(self.folder / "state"), XDG_CACHE_HOME=str(self.folder / "cache"))

    def look(self, id="glow", shader=SHADER, **keys):
        folder = self.folder / "data/afterglow/shaders" / id
        self.write(folder / "look.json", json.dumps({**MANIFEST, **keys}))
        self.write(folder / "show.frag", shader)
        return folder

    def preset(self, name, look="glow", **keys):
        document = {"format": "afterglow-preset", "version": 1, "look": look, "name": name.title(), **keys}
        return self.write(f"data/afterglow/presets/{look}/{name}.json", json.dumps(document))

    def gallery(self, *arguments, output="out"):
        """The document of --json and the text of the page."""
        done = self.at("gallery", *arguments, "-o", output, "--json")
        self.assert_done(done)
        return json.loads(done.stdout), (self.folder / output / "index.html").read_text(encoding="utf-8")

    def files(self, output="out"):
        folder = self.folder / output
        return sorted(str(file.relative_to(folder)) for file in folder.rglob("*") if file.is_file())

    def cards(self, page):
        return re.findall(r"<article>(.*?)</article>", page, re.DOTALL)

    def middle(self, picture):
        width, height, rows = read_png(picture)
        return bytes(rows[height // 2][width // 2 * 3:][:3])

    def rendered(self, *look):
        self.assert_done(self.at("render", *look, "--size", "4x4", "--frames", "1", "-o", "small.png"))
        return self.middle(self.folder / "small.png")


class Writing(GalleryTest):
    def test_a_page_shows_all_presets_of_a_look_with_working_share_lines(self):
        self.look()
        self.preset("warm", about="Late light", author="Bea", values={"gray": 0.5, "tint": "#ff8000"})
        self.preset("dark", values={"gray": 0.1})
        document, page = self.gallery("glow")
        self.assertEqual([preset["name"] for preset in document["presets"]], ["Default", "Dark", "Warm"])
        self.assertEqual(self.files(), sorted(["index.html"] + [
            f"{folder}/glow{name}{ending}" for folder, ending in (("pages", ".html"), ("thumbnails", ".png"))
            for name in ("", "--dark", "--warm")]))
        self.assertEqual(document["files"], 7)
        links = [unquote(link) for link in re.findall(r'(?:src|href)="([^"#]*)"', page)]
        self.assertEqual(sorted([*links, "index.html"]), self.files())
        self.assertNotRegex(page, "https?:")
        self.assertEqual(read_png(self.folder / "out/thumbnails/glow--warm.png")[:2], (480, 270))
        self.assertIn("<h2>Glow <code>glow</code></h2>", page)
        for text in ("One lamp", "by Ann · Licence: MIT"):
            self.assertIn(f">{text}</p>", page)
        warm = self.cards(page)[2]
        for text in (">Warm</h3>", ">by Bea</p>", ">Late light</p>", '<dt class="heading">Lamp</dt>',
                     "<dt>Gray</dt><dd>0.5 cd</dd>", 'style="background:#ff8000"></i>#ff8000</dd>'):
            self.assertIn(text, warm)
        self.assertIn("1 value</b> <span>Gray 0.1 cd</span>", self.cards(page)[1])
        self.assertNotIn("<details>", self.cards(page)[0])
        for card, preset in zip(self.cards(page), document["presets"]):
            line = re.search(r'readonly value="(afterglow:1:[^"]+)"', card)[1]
            self.assertEqual(line, preset["share_line"])
            self.assertEqual(self.rendered(line), self.middle(self.folder / "out" / preset["thumbnail"]))
        self.gallery("glow", output="again")
        for name in self.files():
            self.assertEqual((self.folder / "out" / name).read_bytes(), (self.folder / "again" / name).read_bytes(), name)

    def test_presets_stacks_and_shaders_of_other_programs(self):
        self.look()
        self.preset("warm", values={"gray": 0.5})
        dark = self.preset("dark", values={"gray": 0.1})
        line = self.at("preset", "glow", "--set", "gray=0.75", "--line").stdout.strip()
        self.write("level.fs", ISF)
        self.preset("full", "level.fs", values={"level": 1})
        self.preset("tube", "glow+crt", values={"glow/gray": 0.5})
        document, page = self.gallery(dark, line, "glow+crt", "level.fs", "--no-pages")
        self.assertEqual([(preset["look"], preset["name"]) for preset in document["presets"]], [
            ("glow", "Dark"), ("glow", "Unnamed"), ("glow+crt", "Default"), ("glow+crt", "Tube"),
            ("level.fs", "Default"), ("level.fs", "Full")])
        self.assertEqual({preset["page"] for preset in document["presets"]}, {""})
        self.assertNotIn("pages", {file.name for file in (self.folder / "out").iterdir()})
        self.assertEqual(re.findall(r'<a href="#([^"]*)">', page), ["glow", "glow%2Bcrt", "level.fs"])
        self.assertEqual(self.middle(self.folder / "out/thumbnails/level.fs--full.png"), b"\xff\xff\xff")
        self.assertEqual(self.rendered(document["presets"][5]["share_line"]), b"\xff\xff\xff")
        self.assertEqual(self.middle(self.folder / "out" / document["presets"][1]["thumbnail"]), b"\xbf\xbf\xbf")

    def test_folders_of_files_are_not_shown(self):
        self.look("scope", driven_by="signal", default_signal={"kind": "lissajous", "x": 5, "y": 2})
        self.look("screen", driven_by="picture", default_source="pattern:smpte")
        self.write("private/scene.json", json.dumps({"format": "afterglow-scene", "version": 1, "items": [
            {"shape": "polyline", "points": [[0, 0], [1, 1]]}]}))
        self.write("private/card.ppm", b"P6 1 1 255\n\xff\xff\xff")
        document = {"format": "afterglow-preset", "version": 1}
        self.write("scene.json", json.dumps({**document, "look": "scope", "signal": {
            "kind": "scene", "file": "private/scene.json"}}))
        self.write("card.json", json.dumps({**document, "look": "screen", "source": "private/card.ppm,fit=crop"}))
        _, page = self.gallery("scope", "scene.json", "card.json", "--no-pages")
        facts = [fact.replace("<wbr>", "") for fact in re.findall(r"<dt>(?:Signal|Source)</dt><dd>(.*?)</dd>", page)]
        self.assertEqual(facts, ["lissajous:x=5", "scene:file=scene.json", "card.ppm,fit=crop"])
        self.assertNotIn("private", page)
        self.assertNotIn(str(self.folder), page)

    def test_a_look_that_a_browser_can_not_draw_has_no_live_page(self):
        self.look("doubles", SHADER.replace("gray * tint", "dvec3(gray)"))
        done = self.at("gallery", "doubles", "-o", "out", "--json")
        self.assert_done(done)
        preset = json.loads(done.stdout)["presets"][0]
        self.assertEqual(preset["page"], "")
        self.assertIn("pass 'show'", preset["why_no_page"])
        self.assertIn("look.json: warning: has no live page: ", done.stderr)
        page = (self.folder / "out/index.html").read_text()
        self.assertIn("No live page: " + preset["why_no_page"].replace("'", "&#39;"), page)
        self.assertEqual(self.files(), ["index.html", "thumbnails/doubles.png"])


class BadInput(GalleryTest):
    def test_hostile_texts_are_escaped(self):
        self.look(name=HOSTILE, about=HOSTILE, author=HOSTILE, license=HOSTILE,
                  shader=SHADER.replace('@unit "cd"', f'@unit "{HOSTILE[:30]}"'))
        self.preset("hostile", about=HOSTILE, author=HOSTILE, values={"gray": 0.5})
        file = self.preset("named", values={"gray": 0.5})
        file.write_text(file.read_text().replace('"Named"', json.dumps(HOSTILE)))
        document, page = self.gallery("glow", "--no-pages")
        self.assertEqual(document["presets"][1]["name"], HOSTILE)
        body = re.sub(r"<script>.*?</script>\n</html>", "", page, flags=re.DOTALL)
        self.assertNotIn("</script>", body)
        self.assertNotIn("<img src=x", body)
        escaped = "&lt;/script&gt;&lt;img src=x onerror=&#39;alert(1)&#39;&gt;&quot;&amp;"
        self.assertGreaterEqual(body.count(escaped), 9)
        self.assertIn(f'<p class="about">{escaped}<br>{{}}</p>', body)

    def test_what_has_errors_is_left_out_and_named(self):
        self.look()
        self.gallery("glow", "--no-pages")
        before = {name: (self.folder / "out" / name).read_bytes() for name in self.files()}
        self.preset("bad", values={"gray": "much"})
        self.preset("worse").write_text("{")
        done = self.at("gallery", "glow", "none", "-o", "out", "--no-pages")
        self.assert_refused(done, "bad.json", "worse.json:1", "'none'")
        self.assertEqual(before, {name: (self.folder / "out" / name).read_bytes() for name in self.files()})
        self.assert_refused(self.at("gallery", "none", "-o", "out"), "'none'")
        self.assertEqual(before, {name: (self.folder / "out" / name).read_bytes() for name in self.files()})
        self.assertEqual([file.name for file in self.folder.iterdir() if file.name.startswith(".afterglow")], [])

    def test_only_an_earlier_gallery_is_replaced(self):
        self.look()
        self.preset("warm", values={"gray": 0.5})
        self.gallery("glow")
        (self.folder / "data/afterglow/presets/glow/warm.json").unlink()
        self.gallery("glow", "--no-pages")
        self.assertEqual(self.files(), ["index.html", "thumbnails/glow.png"])
        for name in ("notes.txt", "thumbnails/mine.png"):
            mine = self.write(f"out/{name}", "mine")
            self.assert_refused(self.at("gallery", "glow", "-o", "out"), name, "is not part of the gallery")
            self.assertEqual(mine.read_text(), "mine")
            mine.unlink()
        self.write("site/index.html", "<!doctype html>mine")
        self.write("file", "mine")
        for output in ("site", "file"):
            self.assert_refused(self.at("gallery", "glow", "-o", output), output, "is not a gallery")
        self.assertEqual((self.folder / "site/index.html").read_text(), "<!doctype html>mine")
        (self.folder / "empty").mkdir()
        self.gallery("glow", "--no-pages", output="empty")
        self.assert_refused(self.at("gallery", "glow"), "--output is required", code=2)


if __name__ == "__main__":
    main()

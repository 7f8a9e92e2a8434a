#!/usr/bin/env python3
"""Web pages of looks: what a page contains, how it is verified, and bad input.

web_export_test.py PROGRAM
"""
import json
import os
import re
import shutil
import stat
import unittest

from program import ProgramTest, run


class WebExportTest(ProgramTest):
    def export(self, look, *options, name="page.html"):
        page = self.folder / name
        self.assert_done(run("export", look, "--to", "web", "-o", page, *options))
        html = page.read_text(encoding="utf-8")
        data = re.search(r'id="data">\s*(.*?)\s*</script>', html, re.DOTALL).group(1)
        return html, json.loads(data)

    def look(self, name, label="Gain", about="A look."):
        folder = self.folder / name
        folder.mkdir()
        (folder / "show.frag").write_text(
            "#version 410 core\nin vec2 uv;\nout vec4 color;\n"
            f'uniform float gain = 1.0;  // @label "{label}" @range 0 2\n'
            "void main() { color = vec4(uv * gain, 0.0, 1.0); }\n", encoding="utf-8")
        (folder / "look.json").write_text(json.dumps({
            "format": "afterglow-look", "version": 1, "name": name, "about": about, "author": "", "license": "MIT",
            "passes": [{"name": "show", "fragment": "show.frag"}]}), encoding="utf-8")
        return folder

    def test_one_file_has_everything_and_loads_nothing(self):
        html, data = self.export("phosphor", "--set", "decay=0.5", "--signal", "lissajous:x=4,y=3")
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["page.html"])
        self.assertLess(len(html.encode()), 200_000)
        self.assertNotRegex(html, r'(?:src|href)\s*=\s*"(?:https?:)?//')
        self.assertEqual({p["name"]: p for p in data["parameters"]}["decay"]["value"], 0.5)
        self.assertEqual(data["signal"]["settings"]["x"], 4)
        self.assertEqual(len(data["shaders"]), len(set(data["shaders"])))
        for shader in data["shaders"]:
            self.assertTrue(shader.startswith("#version 300 es\n"), shader[:80])

    def test_hostile_text_stays_text(self):
        hostile = "</script><script>alert('1')</script> '&<!--"
        html, data = self.export(self.look("hostile", label=hostile, about=hostile + '"\n{{DATA}}'))
        self.assertEqual(data["parameters"][0]["label"], hostile)
        self.assertEqual(html.count("<script"), 3)
        self.assertEqual(html.count("</script>"), 3)
        self.assertNotIn("alert('1')</script>", html)
        self.assertIn("&lt;/script&gt;", html)

    def test_media_are_embedded_or_next_to_the_page(self):
        picture = self.folder / "picture.png"
        self.assert_done(run("render", "crt", "--size", "32x24", "-o", picture))
        _, data = self.export("crt", "--source", picture)
        self.assertTrue(data["media"]["media/picture.png"].startswith("data:image/png;base64,"))
        large = self.folder / "large.wav"
        samples = bytes(12_000_000)
        large.write_bytes(b"RIFF" + (36 + len(samples)).to_bytes(4, "little") + b"WAVEfmt " +
                          bytes.fromhex("10000000010002004050000000410100040010006461746 1".replace(" ", "")) +
                          len(samples).to_bytes(4, "little") + samples)
        html, data = self.export("vector-beam", "--signal", f"audio:{large}", name="song.html")
        self.assertEqual(data["media"], {})
        script = self.folder / "song_media" / "large.wav.js"
        self.assertIn('<script src="song_media/large.wav.js"></script>', html)
        self.assertIn('["media/large.wav"] = "data:audio/wav;base64,UklGR', script.read_text()[:200])

    def test_nothing_is_half_written(self):
        page = self.folder / "page.html"
        broken = self.look("broken")
        (broken / "show.frag").write_text("#version 410 core\nvoid main() { oops }\n")
        self.assert_refused(run("export", broken, "--to", "web", "-o", page), "show.frag:2")
        self.assertFalse(page.exists())
        self.assert_refused(run("export", "crt", "--to", "web", "-o", self.folder), "is a folder")
        self.assert_refused(run("export", "crt", "--to", "web", "-o", self.folder / "a.txt"), ".html")
        self.assert_refused(run("export", "crt", "--to", "web", "-o", "/proc/page.html"), "/proc/page.html")
        if os.geteuid() != 0:  # root may write everywhere
            self.folder.chmod(stat.S_IRUSR | stat.S_IXUSR)
            self.assert_refused(run("export", "crt", "--to", "web", "-o", page), "page.html")
            self.folder.chmod(stat.S_IRWXU)
        missing = run("export", "crt", "--source", self.folder / "none.png", "--to", "web", "-o", page)
        self.assert_refused(missing, "none.png")
        self.assertFalse(page.exists())

    def test_dry_run_names_what_a_browser_lacks(self):
        look = self.look("levels")
        (look / "show.frag").write_text(
            "#version 410 core\nin vec2 uv;\nout vec4 color;\nuniform sampler2D picture;\n"
            "void main() { color = vec4(dvec2(uv), 0.0, 1.0); }\n")
        answer = run("export", look, "--to", "web", "--dry-run")
        self.assert_refused(answer, "pass 'show'")
        answer = run("export", "crt", "--to", "web", "--dry-run")
        self.assert_done(answer)
        self.assertIn("nothing is lost", answer.stdout)

    def test_dry_run_names_lost_subframes(self):
        for target in ("web", "portable", "isf", "reshade"):
            with self.subTest(target):
                answer = run("export", "rolling-scan", "--to", target, "--dry-run")
                self.assert_done(answer)
                self.assertIn("Sub-frames. Each frame shows the mean light of a source frame.", answer.stdout)
        answer = run("export", "rolling-scan", "--to", "slang", "--dry-run")
        self.assert_done(answer)
        self.assertIn("nothing is lost", answer.stdout)

    def fake_browser(self, script):
        folder = self.folder / "bin"
        folder.mkdir(exist_ok=True)
        browser = folder / "chromium"
        browser.write_text("#!/bin/sh\n" + script)
        browser.chmod(0o755)
        return f"{folder}:/usr/bin:/bin"

    def verify(self, path, *options):
        return run("export", self.look("plain"), "--to", "web", "-o", self.folder / "page.html", "--size", "32x16",
                   "--verify", *options, PATH=path)

    def test_a_browser_that_fails_is_reported_and_the_page_stays(self):
        for script, expected in (
                ("echo '<title>error: This browser has no WebGL 2.</title>'", "failed: This browser has no WebGL 2."),
                ("sleep 30", "not verified: chromium took more than 1 s"),
                ("echo broken >&2; exit 3", "not verified: chromium failed: broken"),
                ("echo '<title>page</title>'", "failed: the page did not draw its frames in time")):
            with self.subTest(script):
                shutil.rmtree(self.folder / "plain", ignore_errors=True)
                answer = self.verify(self.fake_browser(script), "--timeout", "1")
                self.assertEqual(answer.returncode, 1)
                self.assertIn(expected, answer.stdout)
                self.assertTrue((self.folder / "page.html").exists())

    def test_without_a_browser_the_page_is_not_verified(self):
        answer = self.verify(str(self.folder))
        self.assertEqual((answer.returncode, answer.stdout.splitlines()[-1]),
                         (1, "not verified: chromium is not installed"))

    @unittest.skipUnless(shutil.which("chromium"), "chromium is not installed")
    def test_a_page_is_redrawn_by_a_browser(self):
        answer = self.verify(os.environ["PATH"])
        self.assert_done(answer)
        self.assertRegex(answer.stdout, r"verified: max [01]/255, [0-9.e-]+ % of pixels differ")


if __name__ == "__main__":
    unittest.main()

"""Using looks of other programs."""

import json
import time

from person import Person

FOLLOWS_THE_MOUSE = """void mainImage(out vec4 c, in vec2 p) {
    vec3 color = vec3(0.1, 0.1, 0.3);
    if (distance(p, abs(iMouse.zw)) < 10.0) color = vec3(1.0, 0.0, 0.0);
    if (distance(p, iMouse.xy) < 10.0) color = iMouse.z > 0.0 ? vec3(1.0) : vec3(0.0, 1.0, 0.0);
    c = vec4(color, 1.0);
}
"""
FOLLOWS_KEYS = """void mainImage(out vec4 c, in vec2 p) {
    float held_d = texelFetch(iChannel0, ivec2(68, 0), 0).x;
    float toggled_p = texelFetch(iChannel0, ivec2(80, 2), 0).x;
    c = p.x < 0.5 * iResolution.x ? vec4(held_d, 0.2, 0.2, 1.0) : vec4(0.2, toggled_p, 0.2, 1.0);
}
"""
TURNED_CONSTANTS = """#version 330
#define BARS 6  // @range 1 16 @label "Bars"
const float LEVEL = 0.2;  // @range 0 1 @label "Level"
uniform vec2 u_resolution;
out vec4 color;
void main() {
    float bar = step(0.5, fract(gl_FragCoord.x * float(BARS) / u_resolution.x));
    color = vec4(vec3(LEVEL, LEVEL, bar), 1.0);
}
"""
CHAIN_HEAD = """#version 450
layout(std140, set = 0, binding = 0) uniform UBO { mat4 MVP; } u;
#pragma stage vertex
layout(location = 0) in vec4 Position;
layout(location = 1) in vec2 TexCoord;
layout(location = 0) out vec2 at;
void main() { gl_Position = u.MVP * Position; at = TexCoord; }
#pragma stage fragment
layout(location = 0) in vec2 at;
"""
BELOW_ZERO = CHAIN_HEAD + """#pragma format R16G16B16A16_SINT
#pragma name Below
layout(location = 0) out ivec4 numbers;
void main() { numbers = ivec4(int(at.x * 8.0) - 5, -128, 127, -32768); }
"""
READS_IT = CHAIN_HEAD + """layout(location = 0) out vec4 color;
layout(set = 0, binding = 2) uniform isampler2D Below;
void main() { color = vec4(vec3(texture(Below, at).rrr + 5) / 8.0, 1.0); }
"""
TAKES_SECONDS = """/*{"INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "steps", "TYPE": "long", "MIN": 1, "MAX": 1000000000, "DEFAULT": 4000}]}*/
void main() {
    vec4 sum = IMG_THIS_PIXEL(inputImage);
    for (int i = 0; i < steps; ++i)
        sum += 1e-3 * sin(sum.brga + float(i));
    gl_FragColor = vec4(sum.rgb, 1.0);
}
"""
HAS_A_GATE = """/*{"INPUTS": [
    {"NAME": "level", "TYPE": "float", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.25},
    {"NAME": "hidden", "TYPE": "float", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5},
    {"NAME": "opens", "TYPE": "bool", "DEFAULT": false}]}*/
void main() { gl_FragColor = vec4(vec3(level + (opens ? 0.25 * hidden : 0.0)), 1.0); }
"""
RED, GREEN, WHITE = (255, 0, 0), (0, 255, 0), (255, 255, 255)


class Foreign(Person):
    def open_text(self, name, text):
        """Opens a look from a file of this name, and returns the centre of its picture."""
        file = self.looks.parent / name
        file.write_text(text)
        self.open_by_name(file)
        self.program.wait("'%s' is open" % name, lambda s: s["dialog"] == 0 and s["look"] == name)
        return self.program.middle("picture")

    def color_at(self, x, y):
        """Red, green and blue of the screen, 0..255, at the left of a pointer at x, y."""
        blue, green, red, _ = self.screen.rows(x - 13, y, x - 12, y + 1)[0]
        return red, green, blue

    def wait_for_color(self, what, place, color):
        self.program.wait_for(what, lambda: self.color_at(*place) == color)

    def test_numbers_below_zero_of_a_pass_are_told_marked_and_measured(self):
        program = self.program
        self.looks.parent.joinpath("below.slang").write_text(BELOW_ZERO)
        self.looks.parent.joinpath("reads.slang").write_text(READS_IT)
        x, y = self.open_text("signed.slangp", "shaders = 2\nshader0 = below.slang\nshader1 = reads.slang\n")
        program.click("pass:Below")
        state = program.wait("the range is measured", lambda s: s["inspected"] == "Below" and s["measured"])
        self.assertEqual((state["measured"]["minimum"], state["measured"]["maximum"]), (-128, 127))
        program.key("p")
        program.place("back_to_picture")
        self.hover("picture")
        program.wait("the values are reported", lambda s: s["probe"] and s["probe"]["pass"] == "Below" and
                     s["probe"]["rgba"] == ["-1", "-128", "127", "-32768"])
        program.click("channels:R")
        program.click("fit_levels")
        program.wait("black and white are the range of red", lambda s: s["levels"] == [-5, 2])
        self.snapshot("below_zero")
        program.click("mark_flaws")
        self.wait_for_color("a negative value is blue", (x - 100, y), (0, 0, 255))
        self.snapshot("below_zero_marked")
        program.click("mark_flaws")
        program.click("reset_levels")
        program.click("channels:RGB")
        program.key("Escape")

    def test_a_parameter_without_effect_is_found_while_the_picture_is_paused(self):
        program = self.program
        self.open_text("gate.fs", HAS_A_GATE)
        program.key("space")
        program.wait("the picture is paused", lambda s: not s["is_playing"])
        state = program.wait("one parameter is dimmed", lambda s: "dimmed:hidden" in s["widgets"])
        self.assertNotIn("dimmed:level", state["widgets"])
        self.assertNotIn("dimmed:opens", state["widgets"])
        self.hover("label:hidden")
        program.wait("the help is shown", lambda s: "help:hidden" in s["widgets"])
        self.snapshot("no_effect")
        program.click("parameter:opens")
        program.wait("it has an effect", lambda s: "dimmed:hidden" not in s["widgets"])

    def test_the_left_button_is_the_looks_and_the_middle_one_moves_the_view(self):
        x, y = self.open_text("mouse.glsl", FOLLOWS_THE_MOUSE)
        start, end = (x - 80, y + 40), (x + 60, y - 50)
        self.screen.do("mousemove", *start, "mousedown", 1)
        self.wait_for_color("the button is down", start, WHITE)
        self.screen.do("mousemove", *end)
        self.wait_for_color("the pointer is dragged", end, WHITE)
        self.wait_for_color("the start of the drag is known", start, RED)
        self.snapshot("mouse")
        self.screen.do("mouseup", 1)
        self.wait_for_color("the button is up", end, GREEN)
        self.screen.do("mousemove", x, y)
        self.program.place("picture")
        self.assertEqual((self.color_at(*start), self.color_at(*end)), (RED, GREEN))

        self.screen.do("mousemove", *end)
        self.program.wait("the pointer is on green",
                          lambda s: s["probe"] and s["probe"]["rgba"] == ["0", "1", "0", "1"])
        self.screen.do("click", "--repeat", 4, "--delay", 60, 4)
        self.wait_for_color("the wheel zooms around the pointer", (end[0] + 55, end[1] + 30), GREEN)
        by = (-70, 60)
        self.program.drag(end, (end[0] + by[0], end[1] + by[1]), button=2)
        self.wait_for_color("the view is moved", (end[0] + by[0], end[1] + by[1]), GREEN)
        self.program.key("f")

    def test_keys_over_the_picture_are_the_looks_but_with_ctrl_the_programs(self):
        program = self.program
        x, y = self.open_text("keys.json", json.dumps({"renderpass": [{
            "type": "image", "outputs": [{"id": "4dfGRr"}], "code": FOLLOWS_KEYS,
            "inputs": [{"channel": 0, "type": "keyboard", "id": "4dXGRr"}]}]}))
        left, right = (x - 60, y), (x + 60, y)
        resting = (51, 0, 51)  # 0.2 of 255
        self.screen.do("mousemove", x, y)
        program.wait("the pointer is over the picture", lambda s: s["probe"])
        self.screen.do("keydown", "d")
        self.wait_for_color("the key is down", left, (255, 51, 51))
        self.screen.do("keyup", "d")
        self.wait_for_color("the key is up", left, (0, 51, 51))
        program.key("p")
        self.wait_for_color("the toggle is on", right, (51, 255, 51))
        self.snapshot("keys")
        program.key("p")
        self.wait_for_color("the toggle is off again", right, resting)
        self.assertEqual(program.state()["pins"], [])

        program.key("ctrl+p")
        program.place("palette_query")
        program.key("Escape")
        program.wait("the key with Ctrl opened the palette", lambda s: s["dialog"] == 0)
        self.assertEqual(self.color_at(*right), resting)
        self.hover("search")
        program.wait("the pointer is outside the picture", lambda s: not s["probe"])
        self.assertEqual(self.color_at(*right), resting)

    def test_a_constant_of_a_text_is_turned_undone_and_kept_in_a_preset(self):
        program = self.program

        def is_level(value):
            shown = round(255 * value)
            return lambda: self.color_at(*place)[:2] == (shown, shown)

        place = self.open_text("constants.frag", TURNED_CONSTANTS)
        program.wait_for("the picture shows the value of the text", is_level(0.2))
        program.reveal("LEVEL")
        low, high, y = program.slider("LEVEL")
        program.drag(((low + high) // 2, y), (high + 40, y))
        program.wait("the slider is at its end in one step", lambda s:
                     s["values"]["LEVEL"] == [1] and s["undo"] == "Level")
        program.wait_for("the picture shows the new value", is_level(1.0))
        program.key("ctrl+z")
        program.wait("the value is undone", lambda s: s["values"]["LEVEL"] == [0.2])
        program.wait_for("the picture shows the undone value", is_level(0.2))

        program.set("LEVEL", "0.6")
        program.set("BARS", "12")
        program.key("ctrl+s")
        program.answer("Lighter")
        program.wait("the preset is saved", lambda s: s["preset"] == "Lighter" and not s["is_modified"])
        kept = json.loads(next(self.own.rglob("Lighter.json")).read_text())
        self.assertEqual(kept["values"], {"BARS": 12, "LEVEL": 0.6})
        program.click("preset:")
        program.wait_for("the look's default is drawn", is_level(0.2))
        program.click("preset:Lighter")
        program.wait_for("the preset's value is drawn", is_level(0.6))
        self.snapshot("constants")

    def test_a_pass_that_takes_seconds_is_told_with_what_may_be_done_about_it(self):
        program = self.program
        self.open_text("seconds.fs", TAKES_SECONDS)
        def is_heavy(state):
            return state["notice"].startswith('Pass "picture" takes')

        steps, seconds = 1300, 0.0
        while not is_heavy(program.state()):
            steps = round(steps * min(max(1.5 / max(seconds, 0.1), 1.2), 8))  # a second is the limit
            program.set("steps", str(steps))
            first = program.state()["frame"]
            program.wait("the new value is drawn", lambda s: s["frame"] > first + 1)
            start = time.monotonic()
            program.wait("frames are drawn", lambda s: s["frame"] > first + 2)
            seconds = time.monotonic() - start
            if seconds > 1.0:
                program.wait("four frames are heavy", lambda s: s["frame"] > first + 6 or is_heavy(s))
        program.place("offer:Bypass picture")
        program.place("offer:Halve render size")
        self.snapshot("heavy_pass")
        program.key("ctrl+p")
        program.place("palette_query")
        program.type("heavy halve")
        program.wait("the palette lists it too", lambda s: "palette:Heavy pass: Halve render size" in s["widgets"])
        program.key("Escape")
        program.wait("the palette is closed", lambda s: s["dialog"] == 0)
        program.click("offer:Bypass picture")
        program.wait("the pass is bypassed and the notice is gone", lambda s:
                     s["switches"]["bypassed"] == ["picture"] and "offer_leave" not in s["widgets"] and
                     "Bypassed" in s["notice"])

    def test_a_look_that_the_driver_is_stuck_with_is_left_and_the_program_ends(self):
        program = self.program
        lines = "".join("    x = sin(x * %d.5 + y); y = cos(y + x * 0.%d1);\n" % (i % 7 + 1, i % 9)
                        for i in range(6000))  # Mesa needs minutes to compile it
        file = self.looks.parent / "stuck.frag"
        file.write_text("#version 330\nuniform float u_time;\nout vec4 color;\nvoid main() {\n"
                        "    float x = gl_FragCoord.x + u_time, y = gl_FragCoord.y;\n" + lines +
                        "    color = vec4(x, y, 0.0, 1.0);\n}\n")
        self.open_by_name(file)
        before = program.wait("the look is being opened", lambda s: s["opening"] != "")
        program.wait("the open look continues", lambda s:
                     s["opening"] != "" and s["frame"] > before["frame"] + 5 and s["look"] == "phosphor")
        self.snapshot("stuck")
        program.key("Escape")
        state = program.wait("opening is cancelled", lambda s:
                             s["opening"] == "" and s["notice"] == 'Cancelled opening "stuck.frag"')
        program.wait("the open look continues", lambda s: s["frame"] > state["frame"] + 5)
        program.quit()
        program.start()

#include "lab/document/opened_preset.h"
#include "lab/document/stack_edits.h"
#include "lab/offline/offline.h"
#include "lab/session.h"
#include "lab/small_lab.h"
#include "problems_of.h"

#include <cmath>

namespace fs = std::filesystem;

namespace {
constexpr const char* stacked_picture = R"({
  "format": "afterglow-look", "version": 1, "name": "Gain", "driven_by": "picture",
  "default_source": "pattern:white", "source_encoding": "READS", "output": "linear",
  "passes": [ { "name": "show", "fragment": "show.frag", "format": "rgba32f", "scale": SCALE,
                "inputs": { "image": "SOURCE" } } ]
})";
constexpr const char* gain_text = R"(#version 410 core
uniform sampler2D image;
uniform vec2 u_source_resolution;
uniform float gain = 0.5;  // @range 0 8
uniform float offset = 0.0;
uniform float size_shown = 0.0;
in vec2 uv;
out vec4 color;
void main() { color = texture(image, uv) * gain + offset + size_shown * u_source_resolution.x; }
)";
// Writes its value as display values.
constexpr const char* constant_manifest = R"({
  "format": "afterglow-look", "version": 1, "name": "Constant", "driven_by": "nothing",
  "passes": [ { "name": "show", "fragment": "show.frag", "format": "rgba32f" } ]
})";
constexpr const char* constant = R"(#version 410 core
uniform int u_frame;
uniform float level = 0.5;
uniform float a_frame = 0.0;
in vec2 uv;
out vec4 color;
void main() { color = vec4(vec3(level + a_frame * float(u_frame)), 1.0); }
)";

void write_gain(const TemporaryFolder& folder, const std::string& id, const std::string& reads,
                const std::string& source = "source", const std::string& scale = "1.0") {
    std::string manifest = replaced(stacked_picture, "READS", reads);
    manifest = replaced(replaced(manifest, "SOURCE", source), "SCALE", scale);
    folder.write("shaders/" + id + "/look.json", manifest);
    folder.write("shaders/" + id + "/show.frag", gain_text);
}

void write_constant(const TemporaryFolder& folder) {
    folder.write("shaders/constant/look.json", constant_manifest);
    folder.write("shaders/constant/show.frag", constant);
}

Result<float> drawn(const TemporaryFolder& folder, const RenderRequest& request, int frames = 1) {
    const Library library({folder.path(), folder / "user", folder / "state"});
    auto prepared = prepare(request, library);
    if (!prepared)
        return fail(prepared.error());
    auto offline = Offline::create(std::move(*prepared), {8, 8}, 60.0);
    if (!offline)
        return fail(offline.error());
    for (int frame = 0; frame < frames; ++frame)
        offline->advance();
    const Picture picture = offline->picture();
    return picture.pixels[picture.index(3, 3)];
}

float value_of(const Result<float>& result) {
    REQUIRE_MESSAGE(result.has_value(), problems_of(result));
    return *result;
}
}  // namespace

TEST_CASE("two copies of a look draw in sequence, each with its own values") {
    const TemporaryFolder folder;
    write_gain(folder, "gain", "linear");
    CHECK(value_of(drawn(folder, {.look = "gain+gain"})) == doctest::Approx(0.25));
    CHECK(value_of(drawn(folder, {.look = "gain+gain",
                                  .values = {{"gain/gain", "3"}, {"gain#2/offset", "1"}}})) ==
          doctest::Approx(2.5));
    const auto ambiguous = drawn(folder, {.look = "gain+gain", .values = {{"gain", "3"}}});
    REQUIRE_FALSE(ambiguous.has_value());
    CHECK(ambiguous.error().front().message ==
          "several looks have a parameter 'gain'; use one of: gain/gain, gain#2/gain");
}

TEST_CASE("between looks display values are converted to light, and light to display values") {
    // IEC 61966-2-1: display value 0.5 is light 0.21404, and light 0.5 is display value 0.73536.
    const TemporaryFolder folder;
    write_constant(folder);
    write_gain(folder, "light", "linear");
    write_gain(folder, "shown", "display");
    const std::vector<std::pair<std::string, std::string>> plain{{"gain", "1"}};
    CHECK(std::abs(value_of(drawn(folder, {.look = "constant+light", .values = plain})) - 0.21404) <
          1e-5);
    CHECK(std::abs(value_of(drawn(folder, {.look = "constant+shown", .values = plain})) - 0.5) <
          1e-6);
    CHECK(
        std::abs(value_of(drawn(folder, {.look = "light+shown",
                                         .values = {{"light/gain", "0.5"}, {"shown/gain", "1"}}})) -
                 0.73536) < 1e-5);
    // Values above white or below black follow the same curve.
    for (const double light : {3.5, -2.0}) {
        const double shown =
            std::copysign(1.055 * std::pow(std::abs(light), 1 / 2.4) - 0.055, light);
        const auto drawn_light = drawn(folder, {.look = "light+shown",
                                                .values = {{"light/gain", "0"},
                                                           {"light/offset", std::to_string(light)},
                                                           {"shown/gain", "1"}}});
        CHECK(std::abs(value_of(drawn_light) - shown) < 1e-5);
    }
}

TEST_CASE("a later look reads earlier frames of the previous look and its size") {
    const TemporaryFolder folder;
    write_constant(folder);
    write_gain(folder, "late", "display", "source@2");
    write_gain(folder, "half", "display", "source", "0.5");
    write_gain(folder, "wide", "display");
    const std::vector<std::pair<std::string, std::string>> counting{
        {"level", "0"}, {"a_frame", "1"}, {"gain", "1"}};
    CHECK(value_of(drawn(folder, {.look = "constant+late", .values = counting}, 5)) == 3.0f);
    CHECK(value_of(drawn(folder, {.look = "constant+late", .values = counting}, 2)) == 0.0f);
    CHECK(value_of(drawn(folder, {.look = "half+wide",
                                  .values = {{"wide/gain", "0"}, {"wide/size_shown", "1"}}})) ==
          4.0f);
}

TEST_CASE("a preset of a stack contains its looks, the bypassed ones and each value") {
    const TemporaryFolder folder;
    write_gain(folder, "gain", "linear");
    folder.write("presets/gain+gain/mine.json",
                 R"({"format": "afterglow-preset", "version": 1, "look": "gain+gain",
                     "bypass": ["gain#2"], "values": {"gain/gain": 3, "gain#2/offset": 1}})");
    CHECK(value_of(drawn(folder, {.look = "gain+gain", .preset = "mine"})) == doctest::Approx(3.0));
    CHECK(value_of(drawn(folder, {.look = (folder / "presets/gain+gain/mine.json").string()})) ==
          doctest::Approx(3.0));
    const auto wrong = drawn(
        folder, {.look = "gain", .preset = (folder / "presets/gain+gain/mine.json").string()});
    REQUIRE_FALSE(wrong.has_value());
    CHECK(wrong.error().front().message == "this preset is for 'gain+gain', not for 'gain'");
    const auto unknown = drawn(folder, {.look = "gain+gains+"});
    REQUIRE_FALSE(unknown.has_value());
    CHECK(to_string(unknown.error()) ==
          "error: there is no look called 'gains' (did you mean 'gain'?)\n"
          "error: write a stack as LOOK+LOOK, without spaces\n");
}

namespace {
// A lab with two looks: "small", which counts frames, and "gain".
struct StackLab : SmallLab {
    StackLab() {
        write("look.json", replaced(small_look::manifest, "\"sum@1\"", "\"show@1\"").c_str());
        wait_for_frames();
    }
    fs::path write_other(const std::string& text = gain_text) {
        fs::path other = look_folder().parent_path() / "gain";
        fs::create_directories(other);
        const std::string manifest =
            replaced(replaced(replaced(stacked_picture, "READS", "display"), "SOURCE", "source"),
                     "SCALE", "1");
        REQUIRE(write_atomically(other / "look.json", manifest).has_value());
        REQUIRE(write_atomically(other / "show.frag", text).has_value());
        return other;
    }
    bool shows(const std::string& id) {
        return update_until([&] {
            return document().look().id == id && !document().has_pending_stack() &&
                   !lab().loader().is_loading();
        });
    }
    double value(const char* name) {
        return document().value(*find_parameter(document().look(), name)).number();
    }
};
}  // namespace

TEST_CASE("looks are added, bypassed and removed in one undo step each and keep their values") {
    StackLab small;
    const StackPart other{"gain", small.write_other(), "gain"};
    small.lab().edit([](Document& document) { document.set_value("step_size", 2.0); });
    small.lab().edit([&](Document& document) {
        Stack stack = document.state().stack;
        stack.push_back(other);
        set_stack(document, std::move(stack), "Add Gain");
    });
    CHECK(small.value("step_size") == 2.0);  // the displayed picture keeps its values
    REQUIRE(small.shows("small+gain"));
    CHECK(small.value("small/step_size") == 2.0);
    small.lab().edit([](Document& document) { document.set_value("gain/offset", 1.0); });

    small.lab().edit([](Document& document) {
        set_stack(document, with_bypass(document.state().stack, {"gain"}), "Bypass");
    });
    REQUIRE(small.update_until([&] { return small.document().look().passes.size() == 2; }));
    CHECK(small.value("gain/offset") == 1.0);
    CHECK(preset_of(small.document()).bypass == std::vector<std::string>{"gain"});

    small.lab().edit([](Document& document) {
        Stack stack = document.state().stack;
        stack.erase(stack.begin());
        set_stack(document, with_bypass(stack, {}), "Remove Small");
    });
    REQUIRE(small.shows("gain"));
    CHECK(small.value("offset") == 1.0);
    CHECK(small.document().look().driven_by == Driver::picture);
    CHECK(small.document().state().source == "pattern:white");

    for (const char* id : {"small+gain", "small+gain", "small+gain", "small"}) {
        small.lab().edit([](Document& document) { document.undo(); });
        REQUIRE(small.shows(id));
    }
    CHECK(small.value("step_size") == 2.0);
    CHECK(small.document().history().redo_name() == "Add Gain");
}

TEST_CASE("a stack that begins with the open look opens in one undo step, and so does the look") {
    StackLab small;
    small.write_other();
    const fs::path preset = small.folder() / "presets/small+gain/mine.json";
    fs::create_directories(preset.parent_path());
    REQUIRE(write_atomically(preset, R"({"format": "afterglow-preset", "version": 1,
        "look": "small+gain", "name": "Mine", "values": {"gain/offset": 3, "small/step_size": 4}})")
                .has_value());
    small.lab().edit([](Document& document) { document.set_value("step_size", 2.0); });
    small.lab().edit([](Document& document) {
        set_override(document, "show", {Format::rgba16f, {}, {}});
    });
    const auto has_opened = [&small](const char* id, const char* step) {
        return small.update_until([&] { return small.document().history().undo_name() == step; }) &&
               small.shows(id);
    };
    small.lab().looks().open(preset.string());
    REQUIRE(has_opened("small+gain", "Open Mine"));
    CHECK(small.value("small/step_size") == 4.0);
    CHECK(small.value("gain/offset") == 3.0);
    CHECK(small.document().state().overrides.contains("small/show"));
    CHECK_FALSE(is_modified(small.document()));

    small.lab().looks().open("small");
    REQUIRE(has_opened("small", "Open Small"));
    CHECK(small.value("step_size") == 1.0);
    for (const double step_size : {4.0, 2.0}) {
        small.lab().edit([](Document& document) { document.undo(); });
        REQUIRE(small.shows(step_size == 4.0 ? "small+gain" : "small"));
        CHECK(small.value(step_size == 4.0 ? "small/step_size" : "step_size") == step_size);
    }
}

TEST_CASE("each look of a stack is reloaded on changes, and an error keeps the picture") {
    StackLab small;
    const fs::path other = small.write_other();
    small.lab().looks().open("small+gain");
    REQUIRE(small.shows("small+gain"));
    REQUIRE(write_atomically(other / "show.frag", replaced(gain_text, "gain = 0.5", "gain = 0.25"))
                .has_value());
    REQUIRE(small.update_until([&] { return small.value("gain/gain") == 0.25; }));
    REQUIRE(
        write_atomically(other / "show.frag", replaced(gain_text, "uv) *", "uvv) *")).has_value());
    REQUIRE(small.update_until([&] { return !small.lab().messages().problems().empty(); }));
    CHECK(small.lab().messages().problems().front().diagnostic.file == other / "show.frag");
    CHECK(small.document().look().id == "small+gain");
    small.write("gain.glsl", "uniform float gain = 2.0;  // @range 0 8\n");
    REQUIRE(write_atomically(other / "show.frag", gain_text).has_value());
    REQUIRE(small.update_until([&] { return small.value("small/gain") == 2.0; }));
    CHECK(small.update_until([&] { return small.lab().messages().problems().empty(); }));
}

TEST_CASE("a stack with its order, bypass and undo is restored at the next start") {
    StackLab small;
    const StackPart other{"gain", small.write_other(), "gain"};
    small.lab().edit([&](Document& document) {
        Stack stack = document.state().stack;
        stack.push_back(other);
        stack.push_back({"gain", other.path, "gain#2", true});
        set_stack(document, std::move(stack), "Add");
    });
    REQUIRE(small.shows("small+gain+gain"));
    small.lab().edit([](Document& document) { document.set_value("gain/offset", 1.0); });
    const Session session = session_of(small.lab(), {});
    CHECK(parse_session(session_to_json(session), "session.json") == session);

    small.start();
    restore(small.lab(), session);
    small.wait_for_frames();
    REQUIRE(small.shows("small+gain+gain"));
    CHECK(small.value("gain/offset") == 1.0);
    CHECK(small.document().state().stack[2].is_bypassed);
    small.lab().edit([](Document& document) { document.undo(); });
    small.lab().edit([](Document& document) { document.undo(); });
    REQUIRE(small.shows("small"));
}

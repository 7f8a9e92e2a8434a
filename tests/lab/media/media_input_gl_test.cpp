#include "about.h"
#include "io/pictures/picture_file.h"
#include "lab/document/content_edits.h"
#include "lab/document/opened_preset.h"
#include "lab/small_lab.h"
#include "signals/patterns/patterns.h"

namespace fs = std::filesystem;

namespace {
// The small look with another driver and another input of its first pass.
std::string manifest_of(const std::string& driver, const std::string& previous) {
    return R"({
  "format": "afterglow-look", "version": 1, "name": "Small", )" +
           driver + R"(,
  "passes": [
    { "name": "sum", "fragment": "sum.frag", "format": "rgba32f", "inputs": { "previous": ")" +
           previous + R"(" } },
    { "name": "show", "fragment": "show.frag", "format": "rgba32f", "inputs": { "image": "sum" } }
  ]
})";
}

const std::string on_a_picture = manifest_of(
    R"("driven_by": "picture", "default_source": "pattern:white", "source_encoding": "linear", "settle_frames": 1)",
    "source");
// Shows the source of ten frames ago.
const std::string on_the_past = manifest_of(
    R"("driven_by": "picture", "default_source": "pattern:harbour,size=64x48", "source_encoding": "linear", "settle_frames": 20)",
    "source@10");
const std::string on_a_signal = manifest_of(
    R"("driven_by": "signal", "default_signal": { "kind": "lissajous", "x": 3, "y": 2 }, "settle_frames": 1)",
    "sum@1");
const std::string with_an_image = manifest_of(
    R"("driven_by": "nothing", "settle_frames": 1, "images": { "grain": { "file": "grain.exr" } })",
    "grain");

// 16-bit stereo WAV of constants: left 1/4, right -1/4 of full scale.
std::string wav(std::uint32_t frames, std::uint32_t rate = 8000) {
    const auto number = [](std::uint32_t value, int bytes) {
        std::string text;
        for (int i = 0; i < bytes; ++i)
            text += static_cast<char>(value >> (8 * i) & 0xff);
        return text;
    };
    std::string data;
    for (std::uint32_t i = 0; i < frames; ++i)
        data += number(0x2000, 2) + number(0xe000, 2);
    return "RIFF" + number(36 + 4 * frames, 4) + "WAVEfmt " + number(16, 4) + number(1, 2) +
           number(2, 2) + number(rate, 4) + number(4 * rate, 4) + number(4, 2) + number(16, 2) +
           "data" + number(4 * frames, 4) + data;
}

Picture grey(float level) {
    return {{4, 4}, 3, Encoding::linear, std::vector<float>(48, level)};
}

bool has_sound(SmallLab& small) {
    return small.update_until([&] { return small.player().signal().sound().sound != nullptr; });
}
}  // namespace

TEST_CASE("an opened sound draws and plays from its start, and undo restores the figure") {
    SmallLab small(on_a_signal);
    const fs::path song = small.folder() / "song.wav";
    REQUIRE(write_atomically(song, wav(8000)).has_value());
    small.lab().looks().open_file(song);
    CHECK(small.player().signal().get() != nullptr);  // the figure stays until then
    REQUIRE(has_sound(small));
    CHECK(small.player().transport().time() < 0.1);
    CHECK(small.player().signal().sound_seconds() == doctest::Approx(1.0));
    const Beam beam = small.player().signal().trace({0.25, 0.26});
    REQUIRE_FALSE(beam.empty());
    CHECK(beam[beam.size() / 2].x == about(0.25, 0.01));
    CHECK(beam[beam.size() / 2].y == about(-0.25, 0.01));

    small.lab().edit([](Document& document) { document.undo(); });
    small.update(1);
    CHECK(small.player().signal().sound().sound == nullptr);
    small.lab().edit([](Document& document) { document.redo(); });
    CHECK(has_sound(small));
}

TEST_CASE("a preset finds its sound again, and a missing sound is reported") {
    SmallLab small(on_a_signal);
    const fs::path song = small.folder() / "music" / "song.wav";
    REQUIRE(write_atomically(song, wav(8000)).has_value());
    small.lab().looks().open_file(song);
    REQUIRE(has_sound(small));
    small.lab().presets().save_as("with song");
    CHECK_FALSE(is_modified(small.document()));
    const fs::path file = preset_file(small.document());
    CHECK(content_of(file).find("\"song.wav\"") != std::string::npos);
    CHECK(content_of(file).find(small.folder().string()) == std::string::npos);

    small.start();
    small.lab().looks().open(file.string());
    REQUIRE(has_sound(small));
    CHECK_FALSE(is_modified(small.document()));

    fs::remove(song);
    small.start();
    small.lab().looks().open("small");
    small.wait_for_frames();
    small.lab().edit([](Document& document) { set_signal(document, Spec{"waveform", {}}); });
    small.update(1);
    const Signal* of_another = small.player().signal().get();
    small.lab().looks().open(file.string());
    REQUIRE(small.update_until([&] { return !small.lab().messages().problems().empty(); }));
    CHECK(small.player().signal().get() != of_another);
    CHECK(small.lab().messages().notice()->text.find("song.wav") != std::string::npos);
    CHECK(small.player().signal().get() != nullptr);  // the look's default
    CHECK(small.document().state().signal.kind == "audio");
    small.lab().presets().save();
    CHECK(content_of(file).find("\"song.wav\"") != std::string::npos);  // the reference is kept
}

TEST_CASE("a missing file stays listed as a problem while it is referenced") {
    for (const std::string& manifest : {on_a_signal, on_a_picture}) {
        SmallLab small(manifest);
        const bool is_sound = manifest == on_a_signal;
        const fs::path file = small.folder() / (is_sound ? "gone.wav" : "gone.exr");
        small.lab().edit([&](Document& document) {  // like a preset that references it
            if (is_sound)
                set_signal(document, {"audio", {{"file", file.string()}}});
            else
                set_source(document, file.string());
        });
        REQUIRE(small.update_until([&] { return !small.lab().messages().problems().empty(); }));
        small.lab().update(60.0);  // the notice has expired
        small.lab().edit([](Document& document) { document.set_value("gain", Value(2.0)); });
        small.update(3);
        CHECK_FALSE(small.lab().messages().notice().has_value());
        REQUIRE(small.lab().messages().problems().size() == 1);
        CHECK(small.lab().messages().problems().front().diagnostic.file == file);
        CHECK(small.lab().messages().problems().front().diagnostic.severity == Severity::warning);
        small.write("gain.glsl", "uniform float gain = 3.0;\n");  // a reload clears nothing
        REQUIRE(small.update_until(
            [&] { return small.document().look().parameters.back().initial == Value(3.0); }));
        CHECK(small.lab().messages().problems().size() == 1);
        small.lab().edit([](Document& document) { document.undo(); });
        small.lab().edit([](Document& document) { document.undo(); });
        INFO(is_sound);
        CHECK(small.update_until([&] { return small.lab().messages().problems().empty(); }));
        for (const Problem& problem : small.lab().messages().problems())
            FAIL_CHECK(to_string(problem.diagnostic));
    }
}

TEST_CASE("a truncated sound plays as far as it goes and is listed as a problem") {
    SmallLab small(on_a_signal);
    const fs::path song = small.folder() / "cut.wav";
    const std::string whole = wav(8000);
    REQUIRE(write_atomically(song, whole.substr(0, 44 + 4 * 2000)).has_value());
    small.lab().looks().open_file(song);
    REQUIRE(has_sound(small));
    CHECK(small.player().signal().sound_seconds() == doctest::Approx(0.25));
    REQUIRE(small.lab().messages().problems().size() == 1);
    CHECK(small.lab().messages().problems().front().diagnostic.message ==
          "the file ends early: only 0.25 of 1.00 s were read");
}

TEST_CASE("loading a sound can be cancelled, and the previous signal returns") {
    SmallLab small(on_a_signal);
    const fs::path song = small.folder() / "long.wav";
    REQUIRE(write_atomically(song, wav(4000000)).has_value());
    small.lab().looks().open_file(song);
    small.update(1);
    CHECK(small.lab().work().media.loading() == song.string());
    CHECK(small.lab().is_moving());
    small.lab().content().cancel_loading();
    CHECK(small.lab().work().media.loading().empty());
    CHECK(small.document().state().signal.kind == "lissajous");
    small.update(50);
    CHECK(small.player().signal().sound().sound == nullptr);
}

TEST_CASE("a picture or sound follows its file, and a broken file keeps the last version") {
    SmallLab painted(on_a_picture);
    const fs::path file = painted.folder() / "grey.exr";
    REQUIRE(save_picture(grey(0.25f), file).has_value());
    painted.lab().looks().open_file(file);
    REQUIRE(painted.update_until([&] { return painted.shown() == 1.25f; }));
    REQUIRE(save_picture(grey(0.5f), file).has_value());
    CHECK(painted.update_until([&] { return painted.shown() == 1.5f; }));
    REQUIRE(write_atomically(file, "no picture").has_value());
    CHECK(painted.update_until([&] { return !painted.lab().messages().problems().empty(); }));
    CHECK(painted.shown() == 1.5f);
    REQUIRE(save_picture(grey(0.75f), file).has_value());
    CHECK(painted.update_until([&] { return painted.shown() == 1.75f; }));
    CHECK(painted.lab().messages().problems().empty());

    SmallLab played(on_a_signal);
    const fs::path song = played.folder() / "song.wav";
    REQUIRE(write_atomically(song, wav(8000)).has_value());
    played.lab().looks().open_file(song);
    REQUIRE(has_sound(played));
    const auto seconds = [&] { return played.player().signal().sound_seconds(); };
    REQUIRE(write_atomically(song, wav(4000)).has_value());
    CHECK(played.update_until([&] { return seconds() == doctest::Approx(0.5); }));
    REQUIRE(write_atomically(song, "RIFF and nothing more").has_value());
    CHECK(played.update_until([&] { return !played.lab().messages().problems().empty(); }));
    CHECK(seconds() == doctest::Approx(0.5));
}

TEST_CASE("a chosen file that cannot be read changes nothing and is named in the message") {
    struct Case {
        std::string manifest;
        const char* file;
        const char* content;  // null: the file does not exist
    };
    for (const Case& bad :
         {Case{on_a_signal, "broken.wav", "RIFF and nothing more"},
          Case{on_a_signal, "notes.wav", "a letter, and no sound"},
          Case{on_a_signal, "gone.flac", nullptr}, Case{on_a_signal, "cut.svg", "<svg xmlns"},
          Case{on_a_picture, "broken.png", "no picture"},
          Case{on_a_picture, "noise.mp4", "no video at all"},
          Case{on_a_picture, "gone.exr", nullptr}}) {
        CAPTURE(bad.file);
        SmallLab small(bad.manifest);
        const fs::path file = small.folder() / bad.file;
        if (bad.content)
            REQUIRE(write_atomically(file, bad.content).has_value());
        const DocumentState before = small.document().state();
        const Signal* signal = small.player().signal().get();
        small.lab().looks().open_file(file);
        REQUIRE(small.update_until([&] { return small.lab().messages().notice().has_value(); }));
        small.update(3);
        CHECK(small.lab().messages().notice()->is_problem);
        CHECK(small.lab().messages().notice()->text.find(bad.file) != std::string::npos);
        CHECK(small.document().state() == before);
        CHECK_FALSE(small.document().history().can_undo());
        CHECK(small.lab().messages().problems().empty());
        CHECK(small.player().signal().get() == signal);
        CHECK(small.lab().work().opened_files.take().empty());
    }
}

TEST_CASE("an opened file of any kind is reported once") {
    SmallLab small(on_a_picture);
    const fs::path picture = small.folder() / "grey.exr";
    REQUIRE(save_picture(grey(0.25f), picture).has_value());
    small.lab().looks().open_file(picture);
    REQUIRE(small.update_until([&] { return small.shown() == 1.25f; }));
    CHECK(small.lab().work().opened_files.take() == std::vector{picture});
    small.lab().presets().save_as("grey");
    const fs::path preset = preset_file(small.document());
    small.lab().looks().open_file(preset);
    REQUIRE(small.update_until([&] { return !small.lab().loader().is_loading(); }));
    CHECK(small.lab().work().opened_files.take() == std::vector{preset});
    CHECK(small.lab().work().opened_files.take().empty());
}

TEST_CASE("an unreadable video, drawing or model is reported, and the lab continues") {
    struct Case {
        std::string manifest;
        const char* file;
        const char* content;
        const char* words;
    };
    for (const Case& bad :
         {Case{on_a_picture, "noise.mp4", "no video at all", "can't read the video"},
          Case{on_a_signal, "blank.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"></svg>",
               "the SVG has nothing to draw"},
          Case{on_a_signal, "model.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\n", "unknown vertex 3"}}) {
        CAPTURE(bad.file);
        SmallLab small(bad.manifest);
        const fs::path file = small.folder() / bad.file;
        REQUIRE(write_atomically(file, bad.content).has_value());
        if (bad.manifest == on_a_picture) {
            small.lab().edit([&](Document& document) { set_source(document, file.string()); });
        } else {
            const fs::path scene = small.folder() / "scene.json";
            const std::string shape = file.extension() == ".svg" ? "svg" : "wireframe";
            REQUIRE(write_atomically(scene, R"({"format": "afterglow-scene", "version": 1,
                "items": [{"shape": ")" + shape +
                                                R"(", "file": ")" + bad.file + "\"}]}")
                        .has_value());
            small.lab().edit([&](Document& document) {
                set_signal(document, {"scene", {{"file", scene.string()}}});
            });
        }
        REQUIRE(small.update_until([&] { return !small.lab().messages().problems().empty(); }));
        const Diagnostic& problem = small.lab().messages().problems().front().diagnostic;
        CHECK(problem.file.filename() == bad.file);
        CHECK(problem.message.find(bad.words) != std::string::npos);
        const float frames = small.frames();
        small.update(3);
        CHECK(small.frames() == frames + 3);
        if (bad.manifest == on_a_signal)
            CHECK(small.player().signal().get() != nullptr);
        else
            CHECK(gpu::read_pixel(small.lab().renderer()->executor().target(1), 3, 3)[0] > 0.5f);
    }
}

TEST_CASE("a look driven by a picture shows its pattern, then the user's file") {
    SmallLab small(on_a_picture);
    REQUIRE(small.update_until([&] { return small.shown() == 2.0f; }));  // 1 + step_size
    const fs::path file = small.folder() / "grey.exr";
    REQUIRE(save_picture(grey(0.25f), file).has_value());
    small.lab().looks().open_file(file);
    REQUIRE(small.update_until([&] { return small.shown() == 1.25f; }));
    CHECK(small.lab().work().media.source().extent() == Extent{4, 4});

    small.lab().looks().open_file(small.folder() / "none.exr");
    REQUIRE(small.update_until([&] { return small.lab().messages().notice().has_value(); }));
    small.update(3);
    CHECK(small.shown() == 1.25f);
}

TEST_CASE("a picture chosen for a sampler is loaded, and a missing one is black") {
    SmallLab small;
    small.write(
        "show.frag",
        replaced(replaced(small_look::show, "uv) * gain", "uv) * gain + texture(extra, uv)"),
                 "uniform sampler2D image;", "uniform sampler2D image;\nuniform sampler2D extra;"));
    REQUIRE(small.update_until([&] { return find_parameter(small.document().look(), "extra"); }));
    const fs::path file = small.folder() / "extra.exr";
    REQUIRE(save_picture(grey(0.25f), file).has_value());
    const auto choose = [&](const fs::path& path) {
        small.lab().edit([path](Document& document) {
            document.set_value("extra", Value::of_path(path.string()));
        });
        small.update(2);
    };
    choose(file);
    CHECK(small.update_until([&] { return small.shown() - small.frames() == 0.25f; }));
    small.lab().edit([](Document& document) { document.undo(); });
    small.update(2);
    CHECK(small.shown() - small.frames() == 0.0f);
    choose(small.folder() / "gone.exr");
    CHECK(small.shown() - small.frames() == 0.0f);
    REQUIRE(small.lab().messages().problems().size() == 1);
    CHECK(small.lab().messages().problems().front().diagnostic.file.filename() == "gone.exr");
}

TEST_CASE("each change of the placement of a source is an undo step") {
    SmallLab small(on_a_picture);  // draws 8 x 8 px
    const std::string file = (small.folder() / "grey.exr").string();
    REQUIRE(save_picture(grey(0.25f), file).has_value());
    small.lab().looks().open_file(file);
    REQUIRE(small.update_until([&] { return small.shown() == 1.25f; }));
    const auto lies_in = [&](Extent extent) {
        return small.update_until(
            [&] { return small.lab().work().media.source().extent() == extent; });
    };
    small.lab().edit([&](Document& document) {
        set_source(document, file + ",fit=whole,aspect=2");
        set_source(document, file + ",fit=integer");
    });
    CHECK(lies_in({8, 8}));
    small.lab().edit([](Document& document) { document.undo(); });
    CHECK(lies_in({4, 8}));
    small.lab().edit([](Document& document) { document.undo(); });
    CHECK(lies_in({4, 4}));
    small.lab().edit([&](Document& document) { set_source(document, file + ",fit=tall"); });
    CHECK(small.update_until([&] { return small.lab().messages().notice().has_value(); }));
}

TEST_CASE("numbered pictures play in order, and a gap is reported") {
    SmallLab small(on_a_picture);
    for (const int number : {1, 2, 4})
        REQUIRE(save_picture(grey(static_cast<float>(number)),
                             small.folder() / ("f_" + std::to_string(number) + ".exr"))
                    .has_value());
    small.lab().looks().open_file(small.folder() / "f_%d.exr");
    for (const float number : {1.0f, 2.0f, 4.0f, 1.0f})
        CHECK(small.update_until([&] { return small.shown() == 1.0f + number; }));
    REQUIRE(small.lab().messages().notice().has_value());
    CHECK(small.lab().messages().notice()->text.find("picture 3 is missing") != std::string::npos);
}

TEST_CASE("a replay shows a moving pattern as it was in each frame") {
    SmallLab small(on_the_past);
    small.lab().work().size.choose({false, {64, 48}, 1.0});
    REQUIRE(small.update_until([&] {
        return !small.lab().work().media.source().extent().is_empty() && small.frames() > 40.0f;
    }));
    // The harbour moves by one step in ten frames.
    const double end = small.player().transport().time();
    REQUIRE(make_pattern("harbour,size=64x48", end)->pixels !=
            make_pattern("harbour,size=64x48", end - 10.0 / 60.0)->pixels);
    small.lab().player().pause();
    small.update(2);
    const auto shown = [&] {
        return gpu::read_picture(small.lab().renderer()->executor().target(1)).pixels;
    };
    const auto before = shown();
    for (const double step_size : {2.0, 1.0}) {
        small.lab().edit([=](Document& document) {
            document.set_value("step_size", Value(step_size));
            document.finish();
        });
        small.update(1);
        REQUIRE(small.update_until([&] { return !small.lab().is_moving(); }));
        CHECK((shown() == before) == (step_size == 1.0));
    }
}

TEST_CASE("a changed image of the look is shown, and a broken one is reported") {
    TemporaryFolder folder;
    const fs::path grain = folder / "grain.exr";
    REQUIRE(save_picture(grey(0.5f), grain).has_value());
    SmallLab small;
    small.write("grain.exr", content_of(grain));
    small.write_by_rename("look.json", with_an_image);
    REQUIRE(small.update_until([&] { return small.shown() == 1.5f; }));
    REQUIRE(save_picture(grey(4.0f), grain).has_value());
    small.write("grain.exr", content_of(grain));
    REQUIRE(small.update_until([&] { return small.shown() == 5.0f; }));
    small.write("grain.exr", "no picture");
    REQUIRE(small.update_until([&] { return !small.lab().messages().problems().empty(); }));
    CHECK(small.lab().messages().problems().front().diagnostic.file.filename() == "grain.exr");
    small.update(3);
    CHECK(small.shown() == 5.0f);
    small.write("grain.exr", content_of(grain));
    CHECK(small.update_until([&] { return small.lab().messages().problems().empty(); }));
}

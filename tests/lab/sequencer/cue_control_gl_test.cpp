#include "base/file.h"
#include "formats/preset/preset_format.h"
#include "lab/offline/offline.h"
#include "lab/sequencer/cue_control.h"
#include "lab/small_lab.h"

namespace {
constexpr const char* small_show =
    "# The small show\n"
    "0:00.05 parameter gain 3 over 0.1   # a ramp\n"
    "0:00.25 parameter step_size 2\n"
    "0:00.3 preset \"Bright one\" morph 0.2\n"
    "0:00.6 restart\n"
    "0:00.7 blackout on\n"
    "0:00.8 blackout off\n";

/// A paused small lab at its start, with a preset and an open cue file.
struct CuedLab {
    explicit CuedLab(const std::string& text = small_show) {
        Preset preset;
        preset.look = "small";
        preset.name = "Bright one";
        preset.values = {{"gain", Value(6.0)}, {"step_size", Value(0.5)}};
        const auto saved = small.lab().work().library.save_preset(preset, "bright");
        REQUIRE(saved.has_value());
        file = small.folder() / "show.txt";
        REQUIRE(write_atomically(file, text).has_value());
        small.player().pause();
        small.lab().sequencer().cues().open(file);
        small.lab().frames().restart();
        REQUIRE(small.update_until([&] { return small.frames() == 1.0f; }));
    }

    CueControl& cues() { return small.lab().sequencer().cues(); }
    void step() {
        const float before = small.frames();
        small.player().step();
        REQUIRE(small.update_until([&] { return small.frames() == before + 1.0f; }));
    }
    std::string text() const { return small.document().state().cues.text; }

    SmallLab small;
    std::filesystem::path file;
};
}  // namespace

TEST_CASE("cues in the window and in a render give the same frames") {
    CuedLab cued;
    std::vector<float> shown;
    int black = 0;
    for (int frame = 1; frame <= 60; ++frame) {
        if (frame > 1)
            cued.step();
        const bool is_black = cued.small.lab().renderer()->executors().inputs().is_black;
        black += is_black ? 1 : 0;
        shown.push_back(is_black ? 0.0f : cued.small.shown());
    }
    CHECK(black == 6);  // frames 42 to 47
    CHECK(cued.small.lab().sequencer().drawn_document().values().at("gain") == Value(6.0));

    auto prepared =
        prepare({.look = "small", .cues = cued.file.string()}, Library(cued.small.roots()));
    REQUIRE(prepared.has_value());
    auto offline = Offline::create(std::move(*prepared), {8, 8}, 60.0);  // another GL context
    REQUIRE(offline.has_value());
    for (const float value : shown) {
        offline->advance();
        CHECK(offline->picture().pixels[0] == doctest::Approx(value).epsilon(1e-5));
    }
    // A picture that is saved now opens with the values of the preset's cue.
    CHECK(offline->document().values().empty());
    CHECK(offline->drawn_document().values().at("gain") == Value(6.0));
}

TEST_CASE("frames follow the cues") {
    CuedLab cued("0:00.1 parameter gain 3\n0:00.2 restart\n");
    for (int frame = 2; frame <= 20; ++frame) {
        cued.step();
        // A cue changes the frame that ends at its time: frame 6, and the restart frame 12.
        const float sum = frame < 12 ? static_cast<float>(frame) : static_cast<float>(frame - 11);
        CHECK(cued.small.shown() == doctest::Approx(sum * (frame < 6 ? 1.0f : 3.0f)));
    }
    CHECK(cued.small.document().values().empty());  // the user's values stay
}

TEST_CASE("without cues the picture has the user's values again") {
    CuedLab cued("0:00 parameter gain 3\n");
    cued.step();
    CHECK(cued.small.shown() == doctest::Approx(6.0));
    cued.cues().set_playing(false);
    cued.small.update(30);
    cued.step();
    CHECK(cued.small.shown() == doctest::Approx(3.0));
}

TEST_CASE("cues are edited with undo, and saved with the lines that were not edited") {
    CuedLab cued;
    cued.cues().move(2, 0.5);
    CHECK(cued.text().find("0:00.5 parameter gain 3 over 0.1   # a ramp\n") != std::string::npos);
    CHECK(cued.text().find("# The small show\n") == 0);
    cued.cues().add({.seconds = 0.65, .command = Cue::Command::restart});
    cued.cues().retype(3, "0:00.25 parameter step_size 4");
    cued.cues().remove(6);
    CHECK(cued.cues().has_changes());
    for (int i = 0; i < 4; ++i)
        cued.small.lab().edit([](Document& document) { document.undo(); });
    CHECK(cued.text() == small_show);
    for (int i = 0; i < 4; ++i)
        cued.small.lab().edit([](Document& document) { document.redo(); });
    cued.cues().save();
    CHECK_FALSE(cued.cues().has_changes());
    CHECK(read_text(cued.file) == cued.text());
}

TEST_CASE("an invalid text changes nothing, and errors name file and line") {
    CuedLab cued;
    cued.cues().retype(2, "0:00.5 parametr gain 3");
    CHECK(cued.text() == small_show);
    cued.cues().retype(2, "0:00.5 parameter gian 3");
    cued.small.update(1);
    REQUIRE(cued.cues().problems().size() == 1);
    CHECK(cued.cues().problems().front().line == 2);
    CHECK(cued.cues().problems().front().file == cued.file);
    CHECK(cued.cues().problems().front().message.find("gian") != std::string::npos);
    CHECK(cued.small.lab().work().cues == nullptr);
}

TEST_CASE("a file that changed on disk is read again, but unsaved edits stay") {
    CuedLab cued;
    REQUIRE(write_atomically(cued.file, std::string("0:01 restart\n")).has_value());
    cued.cues().file_changed(cued.file);
    CHECK(cued.text() == "0:01 restart\n");
    cued.cues().move(1, 2.0);
    REQUIRE(write_atomically(cued.file, std::string("0:05 restart\n")).has_value());
    cued.cues().file_changed(cued.file);
    CHECK(cued.text() == "0:02 restart\n");
}

TEST_CASE("a saved copy is the file of all undo steps") {
    CuedLab cued;
    const std::filesystem::path copy = cued.small.folder() / "copy.txt";
    cued.cues().move(2, 0.5);
    cued.cues().save_as(copy);
    cued.small.lab().edit([](Document& document) { document.undo(); });
    cued.small.update(1);
    CHECK(cued.cues().has_changes());
    cued.cues().save();
    CHECK(read_text(copy) == std::string(small_show));
    CHECK_FALSE(cued.cues().has_changes());
}

TEST_CASE("cues of a session are compared with their file") {
    CuedLab cued;
    const CueText kept{cued.file.string(), "0:02 restart\n"};
    CueControl restarted(cued.small.lab().work(), cued.small.lab().frames());
    cued.small.lab().work().document->amend([&](DocumentState& state) { state.cues = kept; });
    restarted.update();
    CHECK(restarted.has_changes());
    CHECK(cued.small.lab().messages().notice()->text.find("show.txt") != std::string::npos);
    cued.small.lab().work().document->amend([&](DocumentState& state) {
        state.cues = {kept.file, small_show};
    });
    CueControl unchanged(cued.small.lab().work(), cued.small.lab().frames());
    unchanged.update();
    CHECK_FALSE(unchanged.has_changes());
}

TEST_CASE("opening the same file again plays it") {
    CuedLab cued;
    cued.cues().set_playing(false);
    cued.small.update(1);
    CHECK(cued.small.lab().work().cues == nullptr);
    cued.cues().open(cued.file);
    CHECK(cued.small.lab().work().cues != nullptr);
}

TEST_CASE("a preset that was saved again changes its cue") {
    CuedLab cued("0:00 preset bright\n");
    cued.step();
    CHECK(cued.small.shown() == doctest::Approx(2 * 0.5 * 6.0));
    const std::vector<std::filesystem::path> files = cued.cues().files();
    REQUIRE(files.size() == 2);
    Preset preset = *load_preset(files.front());
    preset.values["gain"] = Value(4.0);
    REQUIRE(write_atomically(files.front(), preset_to_json(preset)).has_value());
    cued.cues().file_changed(files.front());
    cued.small.update(1);
    cued.step();
    CHECK(cued.small.lab().sequencer().drawn_document().values().at("gain") == Value(4.0));
}

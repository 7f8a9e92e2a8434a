// The user's signal or source across presets, looks, reloads and sessions.
#include "io/pictures/picture_file.h"
#include "io/sound/sound_save.h"
#include "lab/document/content_edits.h"
#include "lab/document/opened_preset.h"
#include "lab/lab_parts.h"
#include "lab/session.h"
#include "lab/small_lab.h"

#include <algorithm>

namespace fs = std::filesystem;

namespace {
std::string look_driven_by(const std::string& driver) {
    return R"({
  "format": "afterglow-look", "version": 1, "name": "Small", "settle_frames": 1, )" +
           driver + R"(,
  "passes": [
    { "name": "sum", "fragment": "sum.frag", "format": "rgba32f", "inputs": { "previous": "sum@1" } },
    { "name": "show", "fragment": "show.frag", "format": "rgba32f", "inputs": { "image": "sum" } }
  ]
})";
}

// A lab with two looks driven by a signal and one driven by a picture.
class ContentLab : public SmallLab {
public:
    ContentLab() : SmallLab(beam) {
        add_look("other", beam);
        add_look("tube", R"("driven_by": "picture", "default_source": "pattern:white")");
        REQUIRE(save_sound({8000, 1, std::vector<float>(8000, 0.0f)}, folder() / "song.wav")
                    .has_value());
        REQUIRE(save_picture({{4, 4}, 3, Encoding::linear, std::vector<float>(48, 0.25f)},
                             folder() / "game.exr")
                    .has_value());
        preset("small", "wave", R"("signal": {"kind": "waveform"})");
        preset("tube", "bars", R"("source": "pattern:smpte")");
    }
    void open_song() {
        lab().looks().open_file(folder() / "song.wav");
        REQUIRE(update_until([&] { return plays_song(); }));
        lab().work().opened_files.take();
    }
    bool plays_song() {
        return lab().document()->state().signal.kind == "audio" && player().signal().sound().sound;
    }
    void open_and_wait(const std::string& argument) {
        lab().looks().open(argument);
        REQUIRE(update_until([&] { return !lab().loader().is_loading(); }));
        update(3);
    }
    fs::path preset_file(const char* look, const char* name) {
        return folder() / "presets" / look / (std::string(name) + ".json");
    }

private:
    static inline const std::string beam =
        look_driven_by(R"("driven_by": "signal", "default_signal": { "kind": "lissajous" })");

    void add_look(const char* id, const std::string& driver) {
        const fs::path copy = folder() / "shaders" / id;
        fs::copy(look_folder(), copy);
        REQUIRE(
            write_atomically(copy / "look.json", driver == beam ? driver : look_driven_by(driver))
                .has_value());
    }
    void preset(const char* look, const char* name, const std::string& content) {
        fs::create_directories(folder() / "presets" / look);
        REQUIRE(write_atomically(preset_file(look, name),
                                 std::string(R"({"format": "afterglow-preset", "version": 1,
            "look": ")") + look + R"(", "name": ")" +
                                     name + "\", " + content + R"(, "values": {"gain": 2}})")
                    .has_value());
    }
};

std::vector<std::string> offers(Lab& lab) {
    std::vector<std::string> names;
    if (lab.messages().notice())
        for (const MenuEntry& button : lab.messages().notice()->buttons)
            names.push_back(button.name);
    return names;
}
}  // namespace

TEST_CASE("each opened preset reports the kept content once") {
    ContentLab small;
    small.open_song();
    for (int i = 0; i < 2; ++i) {
        small.open_and_wait(small.preset_file("small", "wave").string());
        REQUIRE(small.lab().messages().notice().has_value());
        CHECK(small.lab().messages().notice()->text == "Kept song.wav");
        CHECK(offers(small.lab()) == std::vector<std::string>{"Use the preset's signal"});
    }
}

TEST_CASE("a preset keeps the user's sound, reports it and offers its own signal") {
    ContentLab small;
    small.open_song();
    small.open_and_wait(small.preset_file("small", "wave").string());
    CHECK(small.plays_song());
    CHECK(preset_name(small.document()) == "wave");
    CHECK_FALSE(is_modified(small.document()));
    REQUIRE(small.lab().messages().notice().has_value());
    CHECK(small.lab().messages().notice()->text == "Kept song.wav");
    REQUIRE(offers(small.lab()) == std::vector<std::string>{"Use the preset's signal"});

    const Edit command = small.lab().messages().notice()->buttons.front().commands.front();
    command(mutable_parts(small.lab(), nullptr));
    small.update(2);
    CHECK(small.document().state().signal.kind == "waveform");
    CHECK(small.player().signal().sound().sound == nullptr);
    small.lab().edit([](Document& document) { document.undo(); });
    CHECK(small.update_until([&] { return small.plays_song(); }));
    CHECK(is_content_locked(small.document()));
    CHECK(preset_name(small.document()) == "wave");
}

TEST_CASE("the offer of a preset's signal disappears like any notice") {
    ContentLab small;
    small.open_song();
    small.open_and_wait(small.preset_file("small", "wave").string());
    small.lab().update(60.0);
    CHECK_FALSE(small.lab().messages().notice().has_value());
}

TEST_CASE("a preset opened with its own signal replaces the user's sound") {
    ContentLab small;
    small.open_song();
    small.lab().looks().open_with_content(small.preset_file("small", "wave").string());
    REQUIRE(small.update_until([&] { return !small.lab().loader().is_loading(); }));
    small.update(3);
    CHECK(small.document().state().signal.kind == "waveform");
    CHECK_FALSE(is_content_locked(small.document()));
}

TEST_CASE("the user's sound keeps playing through a morph and its end") {
    ContentLab small;
    small.open_song();
    small.lab().presets().navigation().morph_to(small.preset_file("small", "wave"), 0.1);
    CHECK(small.update_until([&] { return !small.lab().presets().navigation().morphing(); }));
    small.update(3);
    CHECK(preset_name(small.document()) == "wave");
    CHECK(small.plays_song());
    CHECK(small.lab().messages().notice()->text == "Morphed to \"wave\" · Kept song.wav");
}

TEST_CASE("user content plays in looks of its kind and is stored during other looks") {
    ContentLab small;
    small.open_song();
    small.open_and_wait("other");
    CHECK(small.document().look().id == "other");
    CHECK(small.update_until([&] { return small.plays_song(); }));
    CHECK_FALSE(is_modified(small.document()));
    small.open_and_wait("tube");
    CHECK(small.document().state().source == "pattern:white");
    small.lab().looks().open_file(small.folder() / "game.exr");
    REQUIRE(small.update_until([&] { return is_content_locked(small.document()); }));
    const std::string game = small.document().state().source;
    small.open_and_wait("small");
    CHECK(small.update_until([&] { return small.plays_song(); }));
    small.open_and_wait(small.preset_file("tube", "bars").string());
    CHECK(small.document().state().source == game);
    CHECK(small.lab().messages().notice()->text.find("Kept game.exr") != std::string::npos);
    CHECK(offers(small.lab()) == std::vector<std::string>{"Use the preset's source"});
}

TEST_CASE("without the lock another look brings its own signal") {
    ContentLab small;
    small.open_song();
    small.lab().edit([](Document& document) { lock_content(document, false); });
    small.open_and_wait("other");
    CHECK(small.document().state().signal.kind == "lissajous");
}

TEST_CASE("a locked generator stays when a preset is opened") {
    ContentLab small;
    small.lab().edit([](Document& document) {
        set_signal(document, Spec{"harmonics", {}});
        lock_content(document, true);
    });
    small.open_and_wait(small.preset_file("small", "wave").string());
    CHECK(small.document().state().signal.kind == "harmonics");
}

TEST_CASE("a reload keeps the user's sound") {
    ContentLab small;
    small.open_song();
    small.write("gain.glsl", "uniform float gain = 3.0;\n");
    REQUIRE(small.update_until(
        [&] { return small.document().look().parameters.back().initial == Value(3.0); }));
    small.update(3);
    CHECK(small.plays_song());
}

TEST_CASE("a preset that changes on disk keeps the user's sound") {
    ContentLab small;
    small.open_song();
    const fs::path file = small.preset_file("small", "wave");
    small.open_and_wait(file.string());
    REQUIRE(write_atomically(file, R"({"format": "afterglow-preset", "version": 1,
        "look": "small", "name": "wave", "signal": {"kind": "harmonics"}, "values": {"gain": 4}})")
                .has_value());
    REQUIRE(small.update_until([&] {
        return small.document().values() == Values{{"gain", Value(4.0)}};
    }));
    CHECK(small.plays_song());
    CHECK_FALSE(is_modified(small.document()));
    CHECK(opened_preset(small.document()).saved.signal.kind == "harmonics");
}

TEST_CASE("a session restores the user's sound, its lock and the undo history") {
    ContentLab small;
    small.open_song();
    small.open_and_wait(small.preset_file("small", "wave").string());
    const auto text = session_to_json(session_of(small.lab(), {}));
    const auto session = parse_session(text, "session.json");
    REQUIRE(session.has_value());
    small.start();
    restore(small.lab(), *session);
    small.wait_for_frames();
    CHECK(small.update_until([&] { return small.plays_song(); }));
    CHECK(is_content_locked(small.document()));
    CHECK_FALSE(is_modified(small.document()));
    small.lab().edit([](Document& document) { document.undo(); });
    CHECK(small.document().state().signal.kind == "audio");  // only the preset was undone
    small.lab().edit([](Document& document) { document.undo(); });
    CHECK(small.document().state().signal.kind == "lissajous");
}

TEST_CASE("a start with another look plays the sound locked in the last session") {
    ContentLab small;
    small.open_song();
    const Session session = session_of(small.lab(), {});
    small.start();
    small.lab().content().set_initial(content_of(session));
    small.lab().looks().open("other");
    small.wait_for_frames();
    CHECK(small.update_until([&] { return small.plays_song(); }));
}

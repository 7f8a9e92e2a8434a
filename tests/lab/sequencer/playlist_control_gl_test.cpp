#include "base/file.h"
#include "formats/settings/playlist_format.h"
#include "lab/lab_parts.h"
#include "lab/sequencer/playlist_control.h"
#include "lab/small_lab.h"

#include <fstream>

namespace {
/// A small look with three presets, whose gain is 2, 3 and 4.
struct ListedLab {
    ListedLab() {
        for (const double gain : {2.0, 3.0, 4.0}) {
            Preset preset;
            preset.look = "small";
            preset.name = fmt::format("Gain {}", gain);
            preset.values = {{"gain", Value(gain)}};
            REQUIRE(small.lab().work().library.save_preset(preset, preset.name).has_value());
        }
        small.update(1);
        control().set_list({.presets = {"Gain 2", "Gain 3", "Gain 4"},
                            .every = 1.0,
                            .unit = Playlist::Unit::seconds,
                            .morph_seconds = 0.0});
    }
    PlaylistControl& control() { return small.lab().sequencer().playlist(); }
    double gain() {
        const Document& document = small.document();
        return document.value(*find_parameter(document.look(), "gain")).number();
    }

    SmallLab small;
};
}  // namespace

TEST_CASE("a playlist advances after its seconds of playback, and repeats") {
    ListedLab listed;
    listed.control().set_playing(true);
    std::vector<double> gains;
    for (int second = 0; second < 4; ++second) {
        listed.small.update(30);
        gains.push_back(listed.gain());
        listed.small.update(30);
    }
    CHECK(gains == std::vector{2.0, 3.0, 4.0, 2.0});
}

TEST_CASE("a playlist file with errors is reported and not overwritten") {
    SmallLab small;
    const std::filesystem::path file = small.folder() / "user/playlists/small.json";
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << "{";
    PlaylistControl control(small.lab().work(), small.lab().presets().navigation());
    control.update(Tempo{}, 0.0);  // reads the file
    Playlist list = control.list();
    list.presets = {"a"};
    control.set_list(list);
    CHECK(small.lab().messages().notice()->text.find("small.json") != std::string::npos);
    CHECK(read_text(file).value() == "{");
}

TEST_CASE("a playlist in bars advances with the bars of the tempo") {
    ListedLab listed;
    Playlist list = listed.control().list();
    list.unit = Playlist::Unit::bars;
    list.every = 1.0;
    listed.control().set_list(list);
    listed.small.lab().sequencer().tempo().set_bpm(240.0);  // a bar is 1 s
    listed.small.player().seek(0.0);
    listed.small.lab().sequencer().tempo().set_downbeat();
    listed.small.update(1);
    listed.control().set_playing(true);
    listed.small.update(30);
    CHECK(listed.gain() == 2.0);
    listed.small.update(60);
    CHECK(listed.gain() == 3.0);
    listed.small.lab().sequencer().tempo().set_bpm(60.0);
    listed.small.lab().sequencer().tempo().set_bpm(240.0);
    listed.small.player().seek(20.2);  // many bars later, which is not an advance
    listed.small.update(10);
    CHECK(listed.gain() == 3.0);
}

TEST_CASE("a cleared playlist returns with the notice's Undo") {
    ListedLab listed;
    const Playlist list = listed.control().list();
    listed.control().clear();
    CHECK(listed.control().list().presets.empty());
    REQUIRE(listed.small.lab().messages().notice()->buttons.size() == 1);
    for (const Edit& undo : listed.small.lab().messages().notice()->buttons.front().commands)
        undo(mutable_parts(listed.small.lab(), nullptr));
    CHECK(listed.control().list() == list);
}

TEST_CASE("next and previous work while stopped, and a missing preset is skipped") {
    ListedLab listed;
    listed.control().step(1);
    listed.small.update(5);
    CHECK(listed.gain() == 3.0);
    Playlist list = listed.control().list();
    list.presets[2] = "gone";
    listed.control().set_list(list);
    listed.control().step(1);
    listed.small.update(5);
    CHECK(listed.gain() == 2.0);
    listed.control().step(-1);
    listed.small.update(5);
    CHECK(listed.gain() == 3.0);
}

TEST_CASE("the list of a look is saved") {
    ListedLab listed;
    const Playlist list = listed.control().list();
    listed.small.start();
    listed.small.lab().looks().open("small");
    listed.small.wait_for_frames();
    CHECK(listed.control().list() == list);
}

TEST_CASE("a morph of the list takes its time") {
    ListedLab listed;
    Playlist list = listed.control().list();
    list.morph_seconds = 1.0;
    list.every = 10.0;
    listed.control().set_list(list);
    listed.control().set_playing(true);
    listed.small.update(30);
    CHECK(listed.gain() > 1.2);
    CHECK(listed.gain() < 1.8);
    listed.small.update(45);
    CHECK(listed.gain() == 2.0);
}

TEST_CASE("a playlist that changes on disk is read again, also after an error in it") {
    ListedLab listed;
    const std::filesystem::path file = listed.control().file();
    Playlist changed = listed.control().list();
    changed.presets = {"Gain 4"};
    listed.control().set_playing(true);
    listed.small.update(30);  // the file is watched, and the first preset is open
    REQUIRE(write_atomically(file, "{").has_value());
    const auto is_reported = [&] {
        const auto& notice = listed.small.lab().messages().notice();
        return notice && notice->text.find("small.json") != std::string::npos;
    };
    REQUIRE(listed.small.update_until(is_reported));
    CHECK(listed.control().list().presets.size() == 3);
    REQUIRE(write_atomically(file, playlist_to_json(changed)).has_value());
    REQUIRE(listed.small.update_until([&] { return listed.control().list() == changed; }));
    CHECK(listed.control().is_playing());
    changed.presets.emplace_back("Gain 2");
    listed.control().set_list(changed);
    CHECK(parse_playlist(read_text(file).value(), file).value() == changed);
}

#include "lab/storage/media.h"

#include "base/file.h"
#include "io/files/file_digest.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <fstream>

namespace fs = std::filesystem;

namespace {
Preset preset_with(const fs::path& file) {
    Preset preset;
    preset.look = "phosphor";
    preset.signal = Spec{"audio", {{"file", file.string()}, {"mode", std::string("xy")}}};
    return preset;
}

std::string file_in(const Preset& preset) {
    return std::get<std::string>(preset.signal->settings.at("file"));
}

/// A user's folder with music and presets.
struct Home {
    TemporaryFolder folder;
    fs::path music = folder.path() / "music";
    fs::path presets = folder.path() / "presets";
    fs::path song = music / "song.wav";
    RecentMedia recent{Roots{folder.path(), folder.path() / "own", folder.path() / "state"}};

    Home() {
        fs::create_directories(music);
        fs::create_directories(presets);
        write(song, "123456789");
    }
    static void write(const fs::path& file, const std::string& bytes) {
        std::ofstream(file, std::ios::binary) << bytes;
    }
};
}  // namespace

TEST_CASE("a digest is the CRC-32 of the bytes") {
    const Home home;
    CHECK(file_digest(home.song).value() == "cbf43926");  // the check value of CRC-32/ISO-HDLC
    CHECK_FALSE(file_digest(home.music / "none.wav").has_value());
    JobProgress stopped;
    stopped.is_cancelled = true;
    CHECK_FALSE(file_digest(home.song, &stopped).has_value());
}

TEST_CASE("a saved preset contains a file's name and digest, not its location") {
    const Home home;
    const Preset saved = with_portable_media(preset_with(home.song), home.presets, home.recent);
    CHECK(file_in(saved) == "song.wav");
    CHECK(saved.media_digest == "cbf43926");
    const Preset beside =
        with_portable_media(preset_with(home.song), home.folder.path(), home.recent);
    CHECK(file_in(beside) == "music/song.wav");
}

TEST_CASE("a source is saved by its file name with its settings, and a sequence has no digest") {
    const Home home;
    Preset preset;
    preset.source = home.song.string() + ",fit=whole,rate=25";
    const Preset saved = with_portable_media(preset, home.presets, home.recent);
    CHECK(saved.source == "song.wav,fit=whole,rate=25");
    CHECK(saved.media_digest == "cbf43926");
    CHECK(with_found_media(saved, home.music, home.recent).source == preset.source);

    Home::write(home.music / "f_07.exr", "x");
    preset.source = (home.music / "f_%02d.exr").string() + ",loop=off";
    const Preset numbered = with_portable_media(preset, home.presets, home.recent);
    CHECK(numbered.source == "f_%02d.exr,loop=off");
    CHECK(numbered.media_digest.empty());
    CHECK(with_found_media(numbered, home.music, home.recent).source == preset.source);
    preset.source = "pattern:smpte,fit=crop";
    CHECK(with_portable_media(preset, home.presets, home.recent).source == preset.source);
}

TEST_CASE("the digest of a file that changed after it was opened is computed again") {
    const Home home;
    home.recent.remember(home.song, "00000001");
    CHECK(home.recent.digest_of(home.song) == "00000001");
    Home::write(home.song, "1234567890");
    CHECK(home.recent.digest_of(home.song).empty());
    Home::write(home.song, "123456789");
    const Preset saved = with_portable_media(preset_with(home.song), home.presets, home.recent);
    CHECK(saved.media_digest == "cbf43926");
}

TEST_CASE("a file is found in the folder of the preset") {
    const Home home;
    Preset preset = preset_with("song.wav");
    CHECK(file_in(with_found_media(preset, home.music, home.recent)) == home.song.string());
    CHECK(file_in(with_found_media(preset, home.presets, home.recent)) == "song.wav");
}

TEST_CASE("a file elsewhere is found among recent files, first by digest") {
    const Home home;
    const fs::path other = home.folder.path() / "song.wav";
    Home::write(other, "another song");
    home.recent.remember(home.song, "cbf43926");
    home.recent.remember(other, "00000001");
    Preset preset = preset_with("song.wav");
    CHECK(file_in(with_found_media(preset, home.presets, home.recent)) == other.string());
    preset.media_digest = "cbf43926";
    CHECK(file_in(with_found_media(preset, home.presets, home.recent)) == home.song.string());
    fs::remove(home.song);
    fs::remove(other);
    CHECK(file_in(with_found_media(preset, home.presets, home.recent)) == "song.wav");
}

TEST_CASE("a file that differs from the file of the preset is reported") {
    const Home home;
    Preset preset = preset_with(home.song);
    CHECK(compare_with_media(preset).empty());
    preset.media_digest = "cbf43926";
    CHECK(compare_with_media(preset).empty());
    preset.media_digest = "00000001";
    REQUIRE(compare_with_media(preset).size() == 1);
    CHECK(compare_with_media(preset).front().severity == Severity::warning);
}

TEST_CASE("a damaged list of recent files finds nothing and is rebuilt") {
    const Home home;
    fs::create_directories(home.folder.path() / "state");
    Home::write(home.folder.path() / "state/media.json", "{ \"format\": ");
    CHECK_FALSE(home.recent.find("song.wav", "").has_value());
    home.recent.remember(home.song, "cbf43926");
    CHECK(home.recent.find("song.wav", "") == home.song);
}

TEST_CASE("patterns and generated signals reference no file") {
    const Home home;
    Preset preset;
    preset.source = "pattern:smpte";
    preset.media_digest = "cbf43926";
    CHECK(with_portable_media(preset, home.presets, home.recent).source == "pattern:smpte");
    CHECK(with_portable_media(preset, home.presets, home.recent).media_digest.empty());
    preset.source.clear();
    preset.signal = Spec{"lissajous", {{"x", 3.0}}};
    CHECK(with_found_media(preset, home.presets, home.recent) == preset);
}

TEST_CASE("a file in a value is saved by its path relative to the preset's folder") {
    const Home home;
    Preset preset;
    preset.values = {{"near", Value::of_path(home.song.string())},
                     {"label", Value::of_path("fast")}};
    const Preset saved = with_portable_media(preset, home.folder.path(), home.recent);
    CHECK(saved.values.at("near").path == "music/song.wav");
    CHECK(saved.values.at("label").path == "fast");
    CHECK(with_portable_media(preset, home.presets, home.recent).values == preset.values);

    Look look;
    for (const char* name : {"near", "label"}) {
        look.parameters.emplace_back();
        look.parameters.back().name = name;
    }
    look.parameters.front().control = Control::image;
    CHECK(with_found_files(saved, look, home.folder.path()).values == preset.values);
}

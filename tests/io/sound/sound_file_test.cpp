#include "io/sound/sound_file.h"

#include "io/captured_errors.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <sndfile.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>

namespace fs = std::filesystem;

namespace {
Sound sines(int rate, int channels, int frames) {
    Sound sound{rate, channels, {}};
    for (int i = 0; i < frames; ++i)
        for (int channel = 0; channel < channels; ++channel)
            sound.samples.push_back(static_cast<float>(
                0.5 * std::sin(2.0 * std::numbers::pi * 440.0 * (channel + 1) * i / rate)));
    return sound;
}

bool save(const Sound& sound, const fs::path& file, int format) {
    SF_INFO info{};
    info.samplerate = sound.rate;
    info.channels = sound.channels;
    info.format = format;
    SNDFILE* const target = sf_open(file.c_str(), SFM_WRITE, &info);
    if (!target)
        return false;
    const auto frames = static_cast<sf_count_t>(sound.frame_count());
    const bool wrote = sf_writef_float(target, sound.samples.data(), frames) == frames;
    return sf_close(target) == 0 && wrote;
}

std::string sound_refusal(const fs::path& file) {
    const auto sound = load_sound(file);
    REQUIRE_FALSE(sound.has_value());
    REQUIRE(sound.error().size() == 1);
    CHECK(sound.error().front().file == file);
    return sound.error().front().message;
}

std::string little_endian(std::uint64_t number, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i)
        text += static_cast<char>(number >> (8 * i) & 0xff);
    return text;
}

struct WavHeader {
    std::uint64_t rate = 8000;
    std::uint64_t channels = 1;
    std::uint64_t data_bytes = 8;
};

// A 16-bit WAV with an arbitrary header, followed by four samples.
std::string wav(const WavHeader& header) {
    const std::uint64_t frame_bytes = header.channels * 2;
    return "RIFF" + little_endian(36 + header.data_bytes, 4) + "WAVEfmt " + little_endian(16, 4) +
           little_endian(1, 2) + little_endian(header.channels, 2) + little_endian(header.rate, 4) +
           little_endian(header.rate * frame_bytes, 4) + little_endian(frame_bytes, 2) +
           little_endian(16, 2) + "data" + little_endian(header.data_bytes, 4) +
           std::string("\0\x40\0\x40\0\x40\0\x40", 8);
}
}  // namespace

TEST_CASE("a float WAV is loaded exactly, with any channels and rate") {
    const TemporaryFolder folder;
    for (const int channels : {1, 2, 6}) {
        const Sound sound = sines(96000, channels, 20000);
        REQUIRE(save(sound, folder / "a.wav", SF_FORMAT_WAV | SF_FORMAT_FLOAT));
        const auto loaded = load_sound(folder / "a.wav");
        REQUIRE(loaded.has_value());
        CHECK(loaded->rate == 96000);
        CHECK(loaded->channels == channels);
        CHECK(loaded->samples == sound.samples);
    }
}

TEST_CASE("FLAC is loaded to 16-bit precision, and OGG and MP3 within their compression loss") {
    struct Kind {
        const char* name;
        int format;
        double error;  // RMS
    };
    const TemporaryFolder folder;
    const Sound sound = sines(44100, 2, 44100);
    for (const Kind& kind : {Kind{"a.flac", SF_FORMAT_FLAC | SF_FORMAT_PCM_16, 1.0 / 32768},
                             Kind{"a.ogg", SF_FORMAT_OGG | SF_FORMAT_VORBIS, 0.01},
                             Kind{"a.mp3", SF_FORMAT_MPEG | SF_FORMAT_MPEG_LAYER_III, 0.02}}) {
        INFO(std::string(kind.name));
        SF_INFO info{0, 44100, 2, kind.format, 0, 0};
        if (!sf_format_check(&info))
            continue;  // a libsndfile build without this encoder
        REQUIRE(save(sound, folder / kind.name, kind.format));
        const auto loaded = load_sound(folder / kind.name);
        REQUIRE(loaded.has_value());
        CHECK(loaded->rate == 44100);
        REQUIRE(loaded->channels == 2);
        REQUIRE(loaded->frame_count() >= sound.frame_count());
        double squares = 0.0;
        for (std::size_t i = 8820; i < 79380; ++i)
            squares += std::pow(loaded->samples[i] - sound.samples[i], 2);
        CHECK(std::sqrt(squares / 70560) < kind.error);
    }
}

TEST_CASE("a truncated sound is loaded up to its end, with a warning about its length") {
    const TemporaryFolder folder;
    for (const int format : {SF_FORMAT_WAV | SF_FORMAT_PCM_16, SF_FORMAT_AIFF | SF_FORMAT_PCM_16,
                             SF_FORMAT_FLAC | SF_FORMAT_PCM_16}) {
        REQUIRE(save(sines(44100, 2, 44100), folder / "a.sound", format));
        Diagnostics notes;
        REQUIRE(load_sound(folder / "a.sound", nullptr, &notes));
        CHECK(notes.empty());
        fs::resize_file(folder / "a.sound", fs::file_size(folder / "a.sound") / 2);
        const auto loaded = load_sound(folder / "a.sound", nullptr, &notes);
        REQUIRE(loaded.has_value());
        REQUIRE(notes.size() == 1);
        CHECK(notes.front().severity == Severity::warning);
        CHECK(notes.front().message.starts_with(
            fmt::format("the file ends early: only {:.2f} of 1.00 s", loaded->seconds())));
        CHECK(loaded->frame_count() > 10000);
        CHECK(loaded->frame_count() < 30000);
    }
    Diagnostics notes;  // an OGG stores its length in its last page
    REQUIRE(save(sines(8000, 2, 80000), folder / "a.ogg", SF_FORMAT_OGG | SF_FORMAT_VORBIS));
    REQUIRE(load_sound(folder / "a.ogg", nullptr, &notes));
    CHECK(notes.empty());
    fs::resize_file(folder / "a.ogg", fs::file_size(folder / "a.ogg") / 2);
    REQUIRE(load_sound(folder / "a.ogg", nullptr, &notes));
    REQUIRE(notes.size() == 1);
    CHECK(notes.front().message.starts_with("the file ends early: only "));
    CHECK(notes.front().message.find(" of ") == std::string::npos);

    REQUIRE(save(sines(44100, 2, 44100), folder / "a.wav", SF_FORMAT_WAV | SF_FORMAT_PCM_16));
    fs::resize_file(folder / "a.wav", 44);
    CHECK(sound_refusal(folder / "a.wav") == "the file has a header but no sound data");
}

TEST_CASE("an invalid sound file is rejected with a reason") {
    const TemporaryFolder folder;
    CHECK(sound_refusal(folder / "missing.wav") == "file not found");
    CHECK(sound_refusal(folder.path()) == "this is a folder, not a file");
    folder.write("empty.wav", "");
    CHECK(sound_refusal(folder / "empty.wav") == "the file is empty");
    folder.write("text.wav", "this is not a sound\n");
    CHECK(sound_refusal(folder / "text.wav").starts_with("can't read the sound: "));
    std::string noise;
    for (int i = 0; i < 100000; ++i)
        noise += static_cast<char>(i * 7919 >> 3);
    for (const char* name : {"noise.wav", "noise.mp3", "noise.ogg", "noise.flac"}) {
        folder.write(name, noise);
        INFO(std::string(name));
        CapturedErrors errors;
        CHECK_FALSE(load_sound(folder / name).has_value());
        CHECK(errors.text() == "");
    }
}

TEST_CASE("absurd header values are rejected or ignored") {
    const TemporaryFolder folder;
    folder.write("good.wav", wav({}));
    REQUIRE(load_sound(folder / "good.wav").has_value());
    CHECK(load_sound(folder / "good.wav")->samples == std::vector<float>(4, 0.5f));

    folder.write("rate.wav", wav({.rate = 0}));
    CHECK_FALSE(sound_refusal(folder / "rate.wav").empty());
    folder.write("fast.wav", wav({.rate = 2000000000}));
    CHECK(sound_refusal(folder / "fast.wav") ==
          "the sample rate must be between 1 and 768000 Hz, got 2000000000 Hz");
    folder.write("channels.wav", wav({.channels = 1000, .data_bytes = 0xfffffff0}));
    CHECK(sound_refusal(folder / "channels.wav") ==
          "the number of channels must be between 1 and 32, got 1000");

    folder.write("long.wav", wav({.data_bytes = 0xfffffff0}));
    const auto claims_gigabytes = load_sound(folder / "long.wav");
    REQUIRE(claims_gigabytes.has_value());
    CHECK(claims_gigabytes->frame_count() == 4);
}

TEST_CASE("2^60 frames claimed by a 64-bit header are not allocated") {
    const TemporaryFolder folder;
    const std::uint64_t claimed = std::uint64_t{1} << 61;
    folder.write("a.wav", "RF64" + little_endian(0xffffffff, 4) + "WAVEds64" +
                              little_endian(28, 4) + little_endian(claimed + 72, 8) +
                              little_endian(claimed, 8) + little_endian(claimed / 2, 8) +
                              little_endian(0, 4) + "fmt " + little_endian(16, 4) +
                              little_endian(1, 2) + little_endian(1, 2) + little_endian(8000, 4) +
                              little_endian(16000, 4) + little_endian(2, 2) + little_endian(16, 2) +
                              "data" + little_endian(0xffffffff, 4) +
                              std::string("\0\x40\0\x40", 4));
    const auto sound = load_sound(folder / "a.wav");
    if (sound)
        CHECK(sound->frame_count() <= 2);
    else
        CHECK_FALSE(sound_refusal(folder / "a.wav").empty());
}

TEST_CASE("non-finite samples become silence or are clamped, and huge ones are clamped") {
    const TemporaryFolder folder;
    const float infinite = std::numeric_limits<float>::infinity();
    const Sound sound{8000, 1, {std::numeric_limits<float>::quiet_NaN(), infinite, 1e30f, 0.5f}};
    REQUIRE(save(sound, folder / "a.wav", SF_FORMAT_WAV | SF_FORMAT_FLOAT));
    const auto loaded = load_sound(folder / "a.wav");
    REQUIRE(loaded.has_value());
    CHECK(loaded->samples == std::vector<float>{0.0f, 1000.0f, 1000.0f, 0.5f});
}

TEST_CASE("a sound longer than one hour is rejected with the limit") {
    const TemporaryFolder folder;
    REQUIRE(save(Sound{10, 1, std::vector<float>(36001)}, folder / "a.wav",
                 SF_FORMAT_WAV | SF_FORMAT_PCM_U8));
    CHECK(sound_refusal(folder / "a.wav") == "the sound is too long; the limit is 1 hour");
}

TEST_CASE("a WAV without a length in its header is read to its end, with a warning") {
    const TemporaryFolder folder;
    Diagnostics notes;
    const auto input = load_sound(fs::path(AFTERGLOW_SOURCE_DIR) / "tests/inputs/wav/zerosize.wav",
                                  nullptr, &notes);
    REQUIRE(input.has_value());
    // 9644 bytes minus a header of 44 bytes, two channels of 16 bits.
    CHECK(input->frame_count() == 2400);
    REQUIRE(notes.size() == 1);
    CHECK(notes[0].severity == Severity::warning);
    CHECK(notes[0].message.starts_with("the recording is unfinished: its header has no length. "));

    std::string text = wav({});
    const auto zero = text.find("data") + 4;
    text.replace(zero, 4, std::string(4, '\0'));
    const auto sound = load_sound(folder.write("a.wav", text));
    REQUIRE(sound.has_value());
    CHECK(sound->samples == std::vector<float>{0.5f, 0.5f, 0.5f, 0.5f});

    // Data of length 0 followed by a LIST chunk: the file has no sound.
    text.resize(zero + 4);
    const std::string list = "LIST" + little_endian(4, 4) + "INFO";
    CHECK(sound_refusal(folder.write("b.wav", text + list))
              .starts_with("the file has a header but no sound"));
    CHECK(sound_refusal(folder.write("c.wav", text))
              .starts_with("the file has a header but no sound"));
}

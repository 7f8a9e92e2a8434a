#include "io/video/film_codec.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace {
std::string error_of(const char* file, const FilmChoice& choice) {
    const auto encoding = film_encoding(file, choice);
    return encoding ? "" : encoding.error().front().message;
}
}  // namespace

TEST_CASE("every default of a file type is a codec that it can hold") {
    for (const FilmContainer& container : film_containers()) {
        CAPTURE(container.ending);
        const std::string file = "film" + container.ending;
        const auto encoding = film_encoding(file, {});
        REQUIRE(encoding.has_value());
        CHECK(encoding->codec->name == container.codec);
        CHECK((encoding->sound != nullptr) == !container.sound.empty());
        if (container.alpha_codec.empty()) {
            CHECK(!film_encoding(file, {.keeps_alpha = true}));
        } else {
            const auto clear = film_encoding(file, {.keeps_alpha = true});
            REQUIRE(clear.has_value());
            CHECK(clear->codec->name == container.alpha_codec);
            CHECK(clear->channels() == 4);
        }
    }
}

TEST_CASE("every codec is in some file type, and its quality is within its range") {
    for (const FilmCodec& codec : film_codecs()) {
        CAPTURE(codec.name);
        CHECK(std::ranges::any_of(film_containers(), [&](const FilmContainer& container) {
            return std::ranges::find(codec.endings, container.ending) != codec.endings.end();
        }));
        CHECK(codec.quality.best <= codec.quality.usual);
        CHECK(codec.quality.usual <= codec.quality.worst);
    }
}

TEST_CASE("what does not fit is refused with what fits") {
    CHECK(error_of("a.mp4", {.codec = "ffv1"}) == "'.mp4' can't hold FFV1 (lossless). Use .mkv.");
    CHECK(error_of("a.mp4", {.sound = "pcm"}) ==
          "'.mp4' can't hold PCM (lossless). Use .mov or .mkv.");
    CHECK(error_of("a.webm", {.codec = "prores"}) ==
          "'.webm' can't hold ProRes 4444. Use .mov or .mkv.");
    CHECK(error_of("a.gif", {.sound = "aac"}) == "'.gif' can't hold sound");
    CHECK(error_of("a.mp4", {.codec = "h265", .keeps_alpha = true}) ==
          "H.265 (10 bit) in '.mp4' has no transparency. Use .mov (ProRes 4444), .mkv (FFV1 "
          "(lossless)) or .webm (VP9).");
    CHECK(error_of("a.mp4", {.codec = "h266"}).find("unknown codec 'h266'") == 0);
    CHECK(error_of("a.mp4", {.quality = 60.0}) ==
          "the quality of H.264 is 1 to 51 (CRF, lower is better), got 60");
    CHECK(error_of("a.mkv", {.codec = "ffv1", .quality = 3.0}) ==
          "FFV1 (lossless) has no quality setting: it keeps every pixel");
    CHECK(error_of("a.avi", {}) ==
          "video files must end in .mp4, .mov, .mkv, .webm or .gif, got 'a.avi'");
    CHECK(error_of("a.MKV", {.sound = no_sound}) == "");
}

TEST_CASE("a picture that is too small for a codec is refused") {
    const auto encoding = film_encoding("a.mp4", {.codec = "av1"});
    REQUIRE(encoding.has_value());
    CHECK(check_film_extent(*encoding, {64, 64}).has_value());
    const auto small = check_film_extent(*encoding, {64, 48});
    REQUIRE(!small.has_value());
    CHECK(small.error().front().message == "AV1 (10 bit) needs at least 64 x 64 px, got 64 x 48");
}

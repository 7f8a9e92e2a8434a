#include "formats/preset/share_line.h"

#include "formats/preset/base64url.h"
#include "formats/preset/deflate.h"
#include "formats/preset/preset_format.h"
#include "formats/preset/sample_preset.h"

#include <doctest/doctest.h>

#include <random>

namespace {
std::string line_error(std::string_view text) {
    const auto preset = parse_share_line(text);
    REQUIRE_FALSE(preset.has_value());
    CHECK(preset.error().front().file.empty());
    return preset.error().front().message;
}

std::string line_with(std::string_view json) {
    return "afterglow:1:" + base64url_encode(deflate_bytes(json));
}
}  // namespace

TEST_CASE("a share line consists of letters, digits, - and _") {
    const Preset preset = with_all_values(sample_preset(), sample_look());
    const std::string line = share_line(preset);
    CHECK(line.starts_with("afterglow:1:"));
    CHECK(line.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_",
                                 12) == std::string::npos);
    CHECK(is_share_line(line));
    CHECK(parse_share_line(line) == preset);
}

TEST_CASE("a share line of another program is parsed") {
    // python3: base64.urlsafe_b64encode(zlib.compress(b'{"format":"afterglow-preset","version":1,
    // "look":"crt","values":{"mask":0.5}}'))
    const auto preset = parse_share_line(
        "afterglow:1:eJyrVkrLL8pNLFGyUkpMK0ktSs_JL9ctKEotTi1R0lEqSy0qzszPU7Iy1FHKyc_"
        "PBqpKLgJLJOaUphYrWVUr5SYWA4UN9ExrawH3WBmL");
    REQUIRE(preset.has_value());
    CHECK(preset->look == "crt");
    CHECK(preset->values == Values{{"mask", 0.5}});
}

TEST_CASE("whitespace that a chat inserts into a share line is ignored") {
    std::string line = share_line(sample_preset());
    line.insert(40, "\r\n  ");
    CHECK(parse_share_line("  \n" + line + " \n") == sample_preset());
}

TEST_CASE("invalid, truncated, newer and oversized share lines give a specific error") {
    CHECK_FALSE(is_share_line("phosphor"));
    CHECK(line_error("") ==
          "the clipboard doesn't contain an Afterglow preset. Copy a line that starts with "
          "'afterglow:1:'.");
    CHECK(line_error("afterglow:2:AAAA") == "the shared preset needs a newer version of Afterglow");
    CHECK(line_error("afterglow:") ==
          "the shared preset is damaged: it must start with 'afterglow:1:'");
    const std::string damaged = "the shared preset is damaged or incomplete. Copy the whole line.";
    CHECK(line_error("afterglow:1:") == damaged);
    CHECK(line_error("afterglow:1:!!!") == damaged);
    const std::string line = share_line(sample_preset());
    for (std::size_t size = 12; size < line.size(); ++size)
        CHECK(line_error(line.substr(0, size)) == damaged);
    CHECK(line_error(line_with(std::string(std::size_t{5} << 20, ' '))) == damaged);
    CHECK(line_error(line_with("[]")) ==
          "the shared preset is invalid: expected an object {...}, got []");
    CHECK(line_error("afterglow:1:" + std::string(std::size_t{9} << 20, 'A')) ==
          "the shared preset is too large: 9437196 bytes; the limit is 8388608");
}

TEST_CASE("a randomly changed share line is read or rejected") {
    const std::string line = share_line(sample_preset());
    std::mt19937 random(8);
    for (int trial = 0; trial < 5000; ++trial) {
        std::string changed = line;
        changed[random() % changed.size()] = static_cast<char>(random());
        const auto preset = parse_share_line(changed);
        CHECK((preset.has_value() ? *preset == sample_preset() : !preset.error().empty()));
    }
}

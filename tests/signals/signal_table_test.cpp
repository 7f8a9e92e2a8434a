#include "signals/signal_table.h"

#include "signals/signal/settings.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <set>

namespace {
std::string spec_refusal(std::string_view text) {
    const auto spec = parse_spec(text);
    REQUIRE(spec.has_value());
    const auto complete = completed(*spec);
    REQUIRE_FALSE(complete.has_value());
    return to_string(complete.error());
}
}  // namespace

TEST_CASE("a spec with only a kind is completed with every default") {
    const auto spec = completed(parse_spec("lissajous").value());
    REQUIRE(spec.has_value());
    CHECK(Settings(*spec).number("x") == 3.0);
    CHECK(Settings(*spec).number("y") == 2.0);
    CHECK(Settings(*spec).number("phase") == 0.25);
    CHECK(Settings(*spec).number("amplitude") == 0.8);
    CHECK(Settings(*spec).number("speed") == 0.0);
    CHECK(Settings(*spec).is("weighting", "constant"));
}

TEST_CASE("completing a spec is idempotent, and its text parses to the same spec") {
    for (const SignalKind& kind : signal_kinds()) {
        Spec spec{kind.kind, {}};
        if (!kind.file_setting.empty())
            spec.settings[""] = std::string("song.wav");
        const auto once = completed(spec);
        REQUIRE(once.has_value());
        CHECK(once->settings.size() == kind.settings.size());
        CHECK(completed(*once) == once);
        CHECK(completed(parse_spec(to_string(*once)).value()) == once);
    }
}

TEST_CASE("a bare word is the file, even if it looks like a number") {
    const auto spec = completed(parse_spec("audio:song.wav,mode=xy").value());
    REQUIRE(spec.has_value());
    CHECK(Settings(*spec).word("file") == "song.wav");
    CHECK(spec->settings.count("") == 0);
    CHECK(file_of(parse_spec("audio:song.wav").value()) == "song.wav");
    CHECK(file_of(parse_spec("audio:file=12").value()) == "12");
    CHECK(file_of(parse_spec("lissajous").value()).empty());
}

TEST_CASE("a misspelt kind, key or word is an error with a suggestion") {
    CHECK(spec_refusal("lisajous") ==
          "error: unknown signal 'lisajous' (did you mean 'lissajous'?)\n");
    CHECK(spec_refusal("lissajous:phse=0") ==
          "error: lissajous: unknown setting 'phse' (did you mean 'phase'?)\n");
    CHECK(spec_refusal("waveform:ch1=sin") ==
          "error: waveform: 'ch1' must be one of 'sine', 'triangle', 'square', 'saw', 'noise', "
          "'off', got 'sin' (did you mean 'sine'?)\n");
    CHECK(spec_refusal("theremin").find("use one of: lissajous, waveform") != std::string::npos);
}

TEST_CASE("invalid numbers are errors, all reported at once") {
    CHECK(spec_refusal("lissajous:points=4096.5").find("whole number") != std::string::npos);
    CHECK(spec_refusal("lissajous:points=1e12").find("between 16 and 262144") != std::string::npos);
    CHECK(spec_refusal("audio:a.wav,upsample=0").find("between 1 and 16") != std::string::npos);
    CHECK(spec_refusal("lissajous:x=nan") == "error: lissajous: 'x' must be a number, got 'nan'\n");
    CHECK(spec_refusal("lissajous:3") == "error: lissajous: expected key=value, got '3'\n");
    CHECK(spec_refusal("audio") == "error: audio: 'file' is required\n");
    CHECK(spec_refusal("audio:a.wav,file=b.wav") == "error: audio: 'file' is given twice\n");
    const std::string both = spec_refusal("am:depth=2,mode=zz");
    CHECK(std::count(both.begin(), both.end(), '\n') == 2);

    Spec infinite{"lissajous", {{"x", std::numeric_limits<double>::infinity()}}};
    CHECK_FALSE(completed(infinite).has_value());
}

TEST_CASE("the signal table has labels, help and valid ranges for every setting") {
    std::set<std::string> kinds;
    for (const SignalKind& kind : signal_kinds()) {
        INFO(kind.kind);
        CHECK(kinds.insert(kind.kind).second);
        CHECK_FALSE(kind.label.empty());
        CHECK_FALSE(kind.help.empty());
        std::set<std::string> keys;
        for (const SettingInfo& setting : kind.settings) {
            INFO(setting.key);
            CHECK(keys.insert(setting.key).second);
            CHECK_FALSE(setting.label.empty());
            CHECK_FALSE(setting.help.empty());
            CHECK(setting.low < setting.high);
            CHECK(setting.limit.low <= setting.low);
            CHECK(setting.limit.high >= setting.high);
            CHECK((setting.type != SettingType::word || !setting.words.empty()));
        }
    }
}

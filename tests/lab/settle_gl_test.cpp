// Specialised programs draw the same picture as generic programs.
#include "io/temporary_folder.h"
#include "lab/offline/offline.h"
#include "lab/small_lab.h"
#include "model/picture/difference.h"
#include "problems_of.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace {
Offline opened(const RenderRequest& request) {
    auto roots = find_roots(AFTERGLOW_SOURCE_DIR);
    REQUIRE(roots.has_value());
    auto prepared = prepare(request, Library(std::move(*roots)));
    REQUIRE_MESSAGE(prepared.has_value(), problems_of(prepared));
    auto offline = Offline::create(std::move(*prepared), request.size, 60.0);
    REQUIRE_MESSAGE(offline.has_value(), problems_of(offline));
    return std::move(*offline);
}

struct Drawn {
    Picture picture;
    int draw_calls = 0;
};

Drawn drawn(const RenderRequest& request, bool is_specialized) {
    Offline offline = opened(request);
    if (is_specialized)
        REQUIRE(offline.specialize().has_value());
    for (int i = 0; i < 4; ++i)
        offline.advance();
    return {offline.picture(), offline.executor().drawer().draw_calls()};
}
}  // namespace

TEST_CASE("specialised programs draw the same picture with fewer draw calls") {
    struct Story {
        const char* look;
        const char* preset;
        int draw_calls;  // when specialised; 0: not checked
    };
    const Story stories[] = {
        {"phosphor", "article", 16},   // beam, persistence, reduced, the pyramid's 12, composite
        {"phosphor", "radar-p7", 17},  // and excitation
        {"crt", "article", 0},
        {"vector-beam", "amber", 0},
        {"shadow-mask", "living-room", 0},
    };
    for (const Story& story : stories) {
        CAPTURE(story.look);
        CAPTURE(story.preset);
        const RenderRequest request{.look = story.look, .preset = story.preset, .size = {96, 72}};
        const Drawn before = drawn(request, false);
        const Drawn specialized = drawn(request, true);
        const auto apart = difference_between(before.picture, specialized.picture, 0.0);
        REQUIRE(apart.has_value());
        CHECK(apart->largest < 2e-3);
        CHECK(specialized.draw_calls <= before.draw_calls);
        if (story.draw_calls > 0)
            CHECK(specialized.draw_calls == story.draw_calls);
    }
}

TEST_CASE("a displayed pass is drawn even if the picture does not need it") {
    const RenderRequest request{.look = "phosphor", .preset = "article", .size = {64, 64}};
    Offline offline = opened(request);
    REQUIRE(offline.specialize({"bloom_x"}).has_value());
    offline.advance();
    CHECK(offline.executor().drawer().draw_calls() == 17);
}

TEST_CASE("automated parameters stay uniforms, and the next start is generic again") {
    const SmallLab small;
    const TemporaryFolder folder;
    folder.write("moves.txt", "0 gain 3\n0.03 gain 5\n");
    auto prepared = prepare({.look = "small", .automation = (folder.path() / "moves.txt").string()},
                            Library(small.roots()));
    REQUIRE(prepared.has_value());
    auto offline = Offline::create(std::move(*prepared), {8, 8}, 60.0);
    REQUIRE(offline.has_value());
    REQUIRE(offline->specialize().has_value());
    std::vector<float> shown;
    for (int i = 0; i < 3; ++i) {
        offline->advance();
        shown.push_back(offline->picture().pixels[0]);
    }
    CHECK(shown == std::vector<float>{3.0f, 10.0f, 15.0f});  // gain times the frame number

    auto still = prepare({.look = "small", .values = {{"gain", "2"}}}, Library(small.roots()));
    REQUIRE(still.has_value());
    auto turned = Offline::create(std::move(*still), {8, 8}, 60.0);
    REQUIRE(turned.has_value());
    REQUIRE(turned->specialize().has_value());
    turned->advance();
    CHECK(turned->picture().pixels[0] == 2.0f);
    Document document = turned->document();
    document.set_value("gain", Value(7.0));
    REQUIRE(turned->start_again(std::move(document)).has_value());
    turned->advance();
    CHECK(turned->picture().pixels[0] == 7.0f);
}

TEST_CASE("specialised programs stay while only moving parameters change") {
    const RenderRequest request{.look = "shadow-mask", .size = {96, 72}};
    Offline offline = opened(request);
    Offline generic = opened(request);
    const auto apart_with = [&](const std::string& name, double value) {
        std::vector<Picture> pictures;
        for (Offline* one : {&offline, &generic}) {
            one->make_current();
            Document document = one->document();
            document.set_value(name, Value(value));
            REQUIRE(one->start_again(std::move(document)).has_value());
            pictures.push_back(one->picture_after(1));
        }
        const auto apart = difference_between(pictures[0], pictures[1], 0.0);
        REQUIRE(apart.has_value());
        offline.make_current();
        return apart->largest;
    };
    const auto is_specialized = [&] { return offline.executor().programs().is_specialized(); };
    offline.make_current();
    REQUIRE(offline.specialize({}, {"mask_strength"}).has_value());
    CHECK(is_specialized());
    CHECK(apart_with("mask_strength", 0.3) < 2e-3);
    CHECK(is_specialized());
    CHECK(apart_with("bloom_intensity", 1.0) < 2e-3);
    CHECK(!is_specialized());
    REQUIRE(offline.specialize({}, {"mask_strength"}).has_value());
    CHECK(apart_with("mask_strength", 0.9) < 2e-3);
    CHECK(is_specialized());
}

TEST_CASE("every Phosphor preset draws the same picture without displayed passes") {
    constexpr Extent size{160, 120};
    int sharing = 0;
    for (const auto& file : std::filesystem::directory_iterator(
             std::filesystem::path(AFTERGLOW_SOURCE_DIR) / "presets" / "phosphor")) {
        const std::string preset = file.path().stem().string();
        CAPTURE(preset);
        const RenderRequest request{.look = "phosphor",
                                    .preset = preset,
                                    .values = {{"dither", "0"}, {"bloom_intensity", "0"}},
                                    .size = size};
        Offline apart = opened(request);
        Offline together = opened(request);
        REQUIRE(together.specialize().has_value());
        const auto& targets = together.executor().plan().targets;
        sharing += static_cast<int>(std::ranges::count_if(
            targets, [](const PlannedTarget& target) { return target.onto.has_value(); }));
        for (int i = 0; i < 6; ++i) {
            apart.advance();
            together.advance();
        }
        const auto difference = difference_between(apart.picture(), together.picture(), 0.0);
        REQUIRE(difference.has_value());
        CHECK(difference->psnr_db >= 60.0);
    }
    CHECK(sharing >= 5);
}

TEST_CASE("a target is not shared if automation may change its condition") {
    const TemporaryFolder folder;
    folder.write("moves.txt", "0.02 beam_kind Segments\n");
    auto roots = find_roots(AFTERGLOW_SOURCE_DIR);
    REQUIRE(roots.has_value());
    auto prepared =
        prepare({.look = "phosphor", .automation = (folder.path() / "moves.txt").string()},
                Library(std::move(*roots)));
    REQUIRE_MESSAGE(prepared.has_value(), problems_of(prepared));
    auto offline = Offline::create(std::move(*prepared), {32, 32}, 60.0);
    REQUIRE(offline.has_value());
    REQUIRE(offline->specialize().has_value());
    CHECK_FALSE(offline->executor().plan().targets[0].onto.has_value());
}

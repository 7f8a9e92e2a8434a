// A look that a signal or a source picture can drive, in a lab and offline.
#include "lab/document/content_edits.h"
#include "lab/offline/offline.h"
#include "lab/session.h"
#include "lab/small_lab.h"
#include "problems_of.h"

namespace {
constexpr const char* either_manifest = R"({
  "format": "afterglow-look", "version": 1, "name": "Small", "driven_by": "signal-or-picture",
  "default_signal": { "kind": "lissajous" }, "default_source": "pattern:white",
  "passes": [
    { "name": "light", "fragment": "light.frag", "format": "rgba32f",
      "inputs": { "image": { "from": "source", "driven_by": "picture" } } },
    { "name": "show", "fragment": "show.frag", "format": "rgba32f", "inputs": { "image": "light" } }
  ]
})";
constexpr const char* light_text = R"(#version 410 core
#ifdef DRIVEN_BY_PICTURE
uniform sampler2D image;
uniform float strength = 1.0;  // @range 0 8
#else
uniform float level = 0.25;  // @range 0 1
#endif
in vec2 uv;
out vec4 color;
void main() {
#ifdef DRIVEN_BY_PICTURE
    color = strength * texture(image, uv);
#else
    color = vec4(level);
#endif
}
)";

/// Shows the level with a signal, and 1 with the white picture.
struct EitherLab : SmallLab {
    EitherLab() {
        write("light.frag", light_text);
        write("look.json", either_manifest);
        lab().looks().open("small");
        CHECK(shows(0.25f));
    }
    bool shows(float expected) {
        return update_until([&] {
            return lab().renderer() && !lab().loader().is_loading() &&
                   player().transport().frame_number() > 2 && shown() == expected;
        });
    }
    Document& changed() { return *lab().work().document; }
};
}  // namespace

TEST_CASE("choosing a picture and undoing it reads the look for the picture and for the signal") {
    EitherLab lab;
    lab.changed().set_value("level", Value(0.5));
    CHECK(lab.shows(0.5f));
    set_source(lab.changed(), "pattern:white");
    CHECK(lab.shows(1.0f));
    CHECK(lab.document().look().driven_by == Driver::picture);
    lab.changed().set_value("strength", Value(3.0));
    CHECK(lab.shows(3.0f));
    lab.changed().travel(-2);
    CHECK(lab.shows(0.5f));
    CHECK(lab.document().look().driven_by == Driver::signal);
    lab.changed().travel(2);
    CHECK(lab.shows(3.0f));
}

TEST_CASE("an edited look keeps its driver") {
    EitherLab lab;
    set_source(lab.changed(), "pattern:white");
    CHECK(lab.shows(1.0f));
    lab.write("light.frag", replaced(light_text, "strength *", "4.0 * strength *"));
    CHECK(lab.shows(4.0f));
    CHECK(lab.document().look().driven_by == Driver::picture);
}

TEST_CASE("a session restores the driver and its history") {
    EitherLab lab;
    set_source(lab.changed(), "pattern:white");
    CHECK(lab.shows(1.0f));
    lab.changed().set_value("strength", Value(2.0));
    CHECK(lab.shows(2.0f));
    const Session session = session_of(lab.lab(), {});
    lab.start();
    restore(lab.lab(), session, {});
    CHECK(lab.shows(2.0f));
    lab.changed().travel(-2);
    CHECK(lab.shows(0.25f));
}

TEST_CASE("an offline picture starts again with a preset of the other driver") {
    EitherLab lab;
    const Library library(lab.roots());
    const auto prepared = [&](const std::string& source) {
        auto made = prepare({.look = "small", .source = source}, library);
        REQUIRE_MESSAGE(made.has_value(), problems_of(made));
        return std::move(*made);
    };
    auto offline = Offline::create(prepared(""), {8, 8}, 60.0);
    REQUIRE(offline.has_value());
    for (const auto& [source, expected] :
         {std::pair{"", 0.25f}, {"pattern:white", 1.0f}, {"", 0.25f}}) {
        const auto begun = offline->start_again(prepared(source).document);
        REQUIRE_MESSAGE(begun.has_value(), problems_of(begun));
        offline->advance();
        CHECK(offline->picture().pixels[0] == expected);
    }
}

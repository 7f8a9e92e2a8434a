// Parameters of a foreign look without an effect, found in idle time.
#include "lab/previews/previews.h"
#include "lab/small_lab.h"

namespace {
// `dead` is multiplied by 0, `hidden` matters only while `opens` is on, `level` always.
constexpr const char* shader = R"(/*{
  "INPUTS": [
    {"NAME": "level", "TYPE": "float", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.25},
    {"NAME": "hidden", "TYPE": "float", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5},
    {"NAME": "opens", "TYPE": "bool", "DEFAULT": false},
    {"NAME": "dead", "TYPE": "color", "DEFAULT": [0.5, 0.5, 0.5, 1.0]}
  ]
}*/
void main() {
    float shown = level + (opens ? hidden * 0.25 : 0.0) + 0.0 * dead.r;
    gl_FragColor = vec4(vec3(shown), 1.0);
}
)";

class Foreign : public SmallLab {
public:
    explicit Foreign(const char* text = shader) {
        const auto file = folder() / "foreign.fs";
        REQUIRE(write_atomically(file, text).has_value());
        lab().looks().open(file.string());
        REQUIRE(update_until([&] {
            return document().look().manifest.filename() == "foreign.fs" && lab().renderer();
        }));
        player().pause();
    }
    std::optional<bool> effect(const char* parameter) {
        return lab().frames().previews().effects().has_effect(parameter);
    }
    void wait_for_answers() {
        update(2);
        REQUIRE(update_until([&] { return !lab().frames().previews().effects().is_busy(); }));
    }
    void set(const char* parameter, double value) {
        lab().edit([&](Document& document) { document.set_value(parameter, Value(value)); });
        update(1);
    }
};
}  // namespace

TEST_CASE("parameters that can't change the picture of a foreign look are found") {
    Foreign foreign;
    foreign.wait_for_answers();
    CHECK(foreign.effect("level") == true);
    CHECK(foreign.effect("opens") == true);
    CHECK(foreign.effect("hidden") == false);
    CHECK(foreign.effect("dead") == false);
    CHECK(foreign.player().transport().is_playing() == false);
}

TEST_CASE("an effect is unknown at other values, and known again at earlier ones") {
    Foreign foreign;
    foreign.wait_for_answers();
    foreign.set("opens", 1.0);
    CHECK(foreign.effect("hidden") == std::nullopt);
    CHECK(foreign.effect("opens") == true);  // depends on the other values only
    foreign.wait_for_answers();
    CHECK(foreign.effect("hidden") == true);
    CHECK(foreign.effect("dead") == false);
    foreign.set("opens", 0.0);
    CHECK(foreign.effect("hidden") == false);
}

TEST_CASE("a black picture says nothing about effects") {
    Foreign foreign;
    foreign.wait_for_answers();
    foreign.set("level", 0.0);
    foreign.wait_for_answers();
    CHECK(foreign.effect("level") == true);
    CHECK(foreign.effect("hidden") == std::nullopt);
}

TEST_CASE("an edited shader is measured again") {
    Foreign foreign;
    foreign.wait_for_answers();
    CHECK(foreign.effect("dead") == false);
    const std::string edited = replaced(shader, "0.0 * dead", "0.1 * dead");
    REQUIRE(write_atomically(foreign.folder() / "foreign.fs", edited).has_value());
    REQUIRE(foreign.update_until([&] { return foreign.effect("dead") != false; }));
    foreign.wait_for_answers();
    CHECK(foreign.effect("dead") == true);
}

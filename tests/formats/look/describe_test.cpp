#include "formats/look/describe.h"

#include "formats/preset/sample_preset.h"
#include "model/look/orbit.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

namespace {
using Json = nlohmann::ordered_json;

Look described_look() {
    Look look = sample_look();
    look.license = "MIT";
    Pass first;
    first.name = "beam";
    first.draw = Draw::points;
    first.vertex.text = "vertex text";
    first.fragment.text = "fragment \"text\"\n";
    first.format = Format::r32f;
    first.size.fill({Side::By::viewport, 0.5, {}});
    first.blend = Blend::add;
    first.set = {{"direction", Value({1.0, 0.0})}};
    Pass second;
    second.name = "composite";
    second.format = Format::rgba8;
    second.inputs = {{"image", Input::From::pass, "beam", 1, {Filter::nearest, Wrap::mirror, true}},
                     {"noise", Input::From::image, "noise", 0, {}}};
    look.passes = {first, second};
    look.images = {{"noise", "look/noise.png", {Filter::linear, Wrap::repeat, false}, true}};
    look.parameters[0].range = {0.5, 0.999, 0.001};
    look.parameters[0].scale = Scale::logarithmic;
    look.parameters[0].unit = "per 1/60 s";
    look.parameters[0].bindings = {{0, "decay"}, {1, "decay"}};
    return look;
}

Json described(const Look& look, const Values& values) {
    const auto plan = plan_targets(look, {640, 480}, {}, values);
    REQUIRE(plan.has_value());
    return Json::parse(describe_json(look, *plan, values));
}
}  // namespace

TEST_CASE("a description lists the passes as they are drawn") {
    const Json json = described(described_look(), {});
    CHECK(json["name"] == "Phosphor");
    CHECK(json["license"] == "MIT");
    CHECK(json["passes"][0] ==
          Json::parse(R"({"name": "beam", "draw": "points", "vertex": "vertex text",
              "fragment": "fragment \"text\"\n", "format": "r32f", "width": 320, "height": 240,
              "blend": "add", "inputs": [], "set": {"direction": [1, 0]}})"));
    CHECK(json["passes"][1]["inputs"] ==
          Json::parse(R"([{"name": "image", "from": "beam@1", "filter": "nearest", "wrap": "mirror",
                           "mipmap": true},
                          {"name": "noise", "from": "noise", "filter": "linear", "wrap": "edge",
                           "mipmap": false}])"));
    CHECK(json["images"] == Json::parse(R"([{"name": "noise", "file": "look/noise.png",
              "filter": "linear", "wrap": "repeat", "mipmap": false, "linear": true}])"));
}

TEST_CASE("a description lists the parameters with current values") {
    const Json json = described(described_look(), {{"decay", 0.94}, {"as_written", 1.0}});
    REQUIRE(json["parameters"].size() == 7);
    CHECK(json["parameters"][0] ==
          Json::parse(
              R"({"name": "decay", "type": "float", "default": 0.92, "value": 0.94, "min": 0.5,
              "max": 0.999, "step": 0.001, "scale": "log", "label": "decay", "unit": "per 1/60 s",
              "group": "", "help": "", "items": [], "passes": ["beam", "composite"]})"));
    CHECK(json["parameters"][3]["value"] == true);
    CHECK(json["parameters"][3]["default"] == false);
    CHECK(json["parameters"][4]["type"] == "list");
    CHECK(json["parameters"][4]["items"][2] == Json::parse(R"({"value": 2, "label": "ACES"})"));
    CHECK(json["parameters"][5]["value"] == Json::parse("[0.2, 1, 0.3]"));
    CHECK(json["parameters"][6]["value"] == "noise.png");
}

TEST_CASE("optional keys of a pass are listed only if it has them") {
    Look look = described_look();
    look.passes[0].rename = {{"radius", "beam_radius"}};
    look.passes[0].repeat = std::string("points");
    look.passes[1].accumulate = true;
    look.passes[1].converge = Count("points");
    look.passes[1].frame_modulo = 60;
    const Json json = described(look, {{"points", 8.0}});
    CHECK(json["passes"][0]["rename"] == Json::parse(R"({"radius": "beam_radius"})"));
    CHECK(json["passes"][0]["repeat"] == 8.0);
    CHECK_FALSE(json["passes"][0].contains("accumulate"));
    CHECK(json["passes"][1]["accumulate"] == true);
    CHECK(json["passes"][1]["converge"] == 8.0);
    CHECK(json["passes"][1]["frame_modulo"] == 60);
}

TEST_CASE("an orbit is described as the matrix that a pass gets") {
    Look look = described_look();
    for (Parameter& part : orbit_parameters({1}, {}))
        look.parameters.push_back(std::move(part));
    const Json json = described(look, {{"orbit_turn", std::vector<double>{0, 90, 0}}});
    CHECK_FALSE(json["passes"][0]["set"].contains("u_view"));
    const Json& view = json["passes"][1]["set"]["u_view"];
    REQUIRE(view.size() == 16);
    CHECK(view[2] == doctest::Approx(-1.0));  // x becomes -z
    CHECK(view[8] == doctest::Approx(1.0));   // z becomes x
}

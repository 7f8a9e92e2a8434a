#include "formats/scene/scene_file.h"

#include "formats/scene/obj_file.h"

#include <doctest/doctest.h>

#include <cmath>

namespace {
std::string scene_text(const std::string& items) {
    return "{ \"format\": \"afterglow-scene\", \"version\": 1, \"items\": [\n" + items + "\n] }\n";
}

std::string scene_refusal(const std::string& text) {
    const auto scene = parse_scene(text, "scenes/s.json");
    REQUIRE_FALSE(scene.has_value());
    return to_string(scene.error());
}

std::string obj_refusal(const std::string& text) {
    const auto paths = parse_obj(text, "m.obj");
    REQUIRE_FALSE(paths.has_value());
    return to_string(paths.error());
}
}  // namespace

TEST_CASE("every shape of a scene is read with its position, rotation and beam settings") {
    const auto scene = parse_scene(
        "{ \"format\": \"afterglow-scene\", \"version\": 1, \"beam_speed\": 300, \"refresh\": 30,\n"
        "\"moves\": \"visible\", \"move_intensity\": 0.2, \"items\": [\n"
        "{ \"shape\": \"line\", \"from\": [0, 0], \"to\": [1, 0.5], \"at\": [0.1, 0.2] },\n"
        "{ \"shape\": \"polyline\", \"points\": [[0, 0], [1, 0], [1, 1]], \"closed\": true },\n"
        "{ \"shape\": \"polygon\", \"sides\": 3, \"turn\": 30, \"spin\": [0, 90, 0] },\n"
        "{ \"shape\": \"circle\", \"radius\": 0.25, \"intensity\": 2, \"speed\": 0.5 },\n"
        "{ \"shape\": \"arc\", \"from\": 0, \"to\": 180, \"dwell\": 50 },\n"
        "{ \"shape\": \"text\", \"text\": \"HI\", \"align\": \"left\", \"perspective\": 2 },\n"
        "{ \"shape\": \"dot\" }, { \"shape\": \"grid\", \"columns\": 2, \"rows\": 2 } ] }",
        "s.json");
    REQUIRE(scene.has_value());
    REQUIRE(scene->items.size() == 8);
    CHECK(scene->beam_speed == 300.0);
    CHECK(scene->refresh == 30.0);
    CHECK(scene->move_current == 0.2);
    CHECK(scene->items[0].at == std::array<double, 2>{0.1, 0.2});
    CHECK(scene->items[1].paths[0].points.size() == 4);
    CHECK(scene->items[2].turn == std::array<double, 3>{0, 0, 30});
    CHECK(scene->items[2].spin == std::array<double, 3>{0, 90, 0});
    CHECK(scene->items[3].current == 2.0);
    CHECK(scene->items[3].speed == 0.5);
    CHECK(std::abs(scene->items[4].dwell_seconds - 50e-6) < 1e-12);
    CHECK(scene->items[6].dwell_seconds > 0.0);
    CHECK(scene->items[7].paths.size() == 6);
}

TEST_CASE("errors in a scene are reported with their lines, all at once") {
    const std::string message =
        scene_refusal(scene_text("{ \"shape\": \"circle\", \"radus\": 1 },\n"
                                 "{ \"shape\": \"cirlce\" },\n"
                                 "{ \"shape\": \"line\", \"from\": [0], \"to\": [1, 1] },\n"
                                 "{ \"shape\": \"arc\", \"radius\": -1 }"));
    CHECK(message.find("s.json:2: error: ") != std::string::npos);
    CHECK(message.find("radus") != std::string::npos);
    CHECK(message.find("s.json:3: error: ") != std::string::npos);
    CHECK(message.find("circle") != std::string::npos);
    CHECK(message.find("s.json:4: error: 'from' must be a list of 2 or 3 numbers") !=
          std::string::npos);
    CHECK(message.find("s.json:5: error: 'radius' must be between") != std::string::npos);
    CHECK(scene_refusal("{ \"format\": \"afterglow-look\" }").find("afterglow-scene") !=
          std::string::npos);
    CHECK(scene_refusal(scene_text("")).find("nothing to draw") != std::string::npos);
    CHECK(scene_refusal("{ \"format\": \"afterglow-scene\", \"version\": 1,\n\"beam_speed\": 0,"
                        " \"items\": [{ \"shape\": \"dot\" }] }")
              .find("s.json:2: error: 'beam_speed' must be above 0, got 0") != std::string::npos);
    CHECK(scene_refusal("{ \"x\": NaN }").find("s.json:1") != std::string::npos);
    CHECK(scene_refusal(scene_text("{ \"shape\": \"svg\", \"file\": \"../a.svg\" }"))
              .find("'file' must be in the scene's folder") != std::string::npos);
    CHECK(scene_refusal(scene_text("{ \"shape\": \"svg\", \"file\": \"no-such.svg\" }"))
              .find("scenes/s.json:2: error: can't read 'no-such.svg': file not found") !=
          std::string::npos);
    CHECK(scene_refusal(scene_text("{ \"shape\": \"dot\", \"spin\": \"fast\" }"))
              .find("'spin' must be an angle in degrees or a list of 3 angles") !=
          std::string::npos);
}

TEST_CASE(
    "each edge of an OBJ is drawn once, from faces and lines with positive or negative indices") {
    const auto paths = parse_obj(
        "# two triangles with a side in common\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\n"
        "f 1/1/1 2//1 3\nf -4 -2 -1\nl 2 4\nusemtl none\n",
        "m.obj");
    REQUIRE(paths.has_value());
    std::size_t edges = 0;
    for (const ScenePath& path : *paths)
        edges += path.points.size() - 1;
    CHECK(edges == 6);
}

TEST_CASE("invalid vertices of an OBJ are reported with their lines") {
    const std::string message = obj_refusal("v 0 0 0\nv 1 0 0\nv 1 nan 0\nf 1 2 9\nf 1 0 2\n");
    CHECK(message.find("m.obj:3: error: expected 'v' and three numbers") != std::string::npos);
    CHECK(message.find("m.obj:4: error: unknown vertex 9") != std::string::npos);
    CHECK(message.find("m.obj:5: error: unknown vertex 0") != std::string::npos);
    CHECK(obj_refusal("v 0 0 0\n").find("no edges") != std::string::npos);
    std::string huge = "v 0 0 0\n";
    for (int i = 2; i < 100010; ++i)
        huge += "v " + std::to_string(i) + " 0 0\nl -1 -2\n";
    CHECK(obj_refusal(huge).find("too many edges; the limit is 100000") != std::string::npos);
}

namespace {
std::size_t edges_of(const std::vector<ScenePath>& paths) {
    std::size_t edges = 0;
    for (const ScenePath& path : paths)
        edges += path.points.size() - 1;
    return edges;
}

// The number of edges of a scene in tests/inputs/obj.
std::size_t edges_in(const std::string& name) {
    const auto scene =
        load_scene(std::filesystem::path(AFTERGLOW_SOURCE_DIR) / "tests/inputs/obj" / name);
    REQUIRE_MESSAGE(scene.has_value(), to_string(scene.error()));
    REQUIRE(scene->items.size() == 1);
    return edges_of(scene->items[0].paths);
}
}  // namespace

TEST_CASE("OBJ lines may be continued by a backslash, and end with CR, LF or CRLF") {
    CHECK(edges_in("scene_cont.json") == 4);
    CHECK(edges_in("scene_cr_only.json") == 3);
    const auto dos = parse_obj("v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nf 1 \\\r\n 2 3\r\n", "m.obj");
    REQUIRE(dos.has_value());
    CHECK(edges_of(*dos) == 3);
    CHECK(
        obj_refusal("v 0 0 0\nv 1 0 0\nl 1 \\\n\\\n7\n").find("m.obj:5: error: unknown vertex 7") !=
        std::string::npos);
}

TEST_CASE("degenerate faces of an OBJ are ignored") {
    CHECK(edges_in("scene_degenerate.json") == 3);
}

TEST_CASE("an OBJ file is a scene with its wireframe, three quarters of the screen in size") {
    CHECK(edges_in("cont.obj") == 4);
    const auto scene =
        load_scene(std::filesystem::path(AFTERGLOW_SOURCE_DIR) / "tests/inputs/obj/cont.obj");
    for (const ScenePoint& point : scene->items[0].paths[0].points)
        CHECK(std::abs(std::abs(point.x) - 0.75) < 1e-9);
}

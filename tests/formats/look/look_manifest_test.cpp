#include "formats/look/look_manifest.h"

#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <random>

namespace fs = std::filesystem;

namespace {
// The example manifest.
const std::string phosphor = R"({
  "format": "afterglow-look", "version": 1,
  "name": "Phosphor", "about": "An oscilloscope tube: beam, persistence, bloom, glass.", "author": "", "license": "MIT",
  "driven_by": "signal", "default_signal": { "kind": "lissajous", "x": 3, "y": 2 },
  "output": "display", "settle_frames": 120,
  "passes": [
    { "name": "beam", "draw": "points", "vertex": "beam.vert", "fragment": "beam.frag", "format": "rgba16f", "blend": "add" },
    { "name": "persistence", "fragment": "persistence.frag", "format": "rgba16f", "inputs": { "current": "beam", "previous": "persistence@1" } },
    { "name": "bloom_x", "fragment": "blur.frag", "scale": 0.5, "format": "rgba16f", "inputs": { "image": "persistence" }, "set": { "direction": [1, 0] } },
    { "name": "bloom_y", "fragment": "blur.frag", "scale": 0.5, "format": "rgba16f", "inputs": { "image": "bloom_x" }, "set": { "direction": [0, 1] } },
    { "name": "composite", "fragment": "composite.frag", "inputs": { "phosphor": "persistence", "bloom": "bloom_y" } }
  ]
}
)";

class LookOnDisk {
public:
    LookOnDisk() {
        for (const char* name : {"beam.vert", "beam.frag", "persistence.frag", "blur.frag",
                                 "composite.frag", "lut.png"})
            folder.write(fs::path("phosphor") / name, "text");
    }

    Result<Look> load(std::string_view text) {
        files.clear();
        return load_manifest(folder.write("phosphor/look.json", text), files);
    }

    // All diagnostics, with the manifest's path shortened to "look.json".
    std::string errors_of(std::string_view text) {
        const auto look = load(text);
        REQUIRE_FALSE(look.has_value());
        std::string all;
        for (Diagnostic reason : look.error()) {
            CHECK(reason.file == folder / "phosphor/look.json");
            reason.file = "look.json";
            all += to_string(reason) + '\n';
        }
        return all;
    }

    TemporaryFolder folder;
    std::vector<fs::path> files;
};

// A look with its head on line 1 and `passes` from line 2.
std::string look_with(std::string_view head, std::string_view passes) {
    return "{ \"format\": \"afterglow-look\", \"version\": 1, " + std::string(head) +
           "\"passes\": [\n" + std::string(passes) + "\n] }";
}

const std::string picture_head =
    "\"driven_by\": \"picture\", \"default_source\": \"pattern:smpte\", ";
}  // namespace

TEST_CASE("the example manifest is read correctly") {
    LookOnDisk disk;
    const auto loaded = disk.load(phosphor);
    REQUIRE(loaded.has_value());
    const Look& look = *loaded;
    CHECK(look.id == "phosphor");
    CHECK(look.name == "Phosphor");
    CHECK(look.license == "MIT");
    CHECK(look.driven_by == Driver::signal);
    CHECK(look.default_signal == Spec{"lissajous", {{"x", 3.0}, {"y", 2.0}}});
    CHECK(look.output == Encoding::display);
    CHECK(look.settle_frames == 120);
    CHECK(look.manifest == disk.folder / "phosphor/look.json");
    REQUIRE(look.passes.size() == 5);
    CHECK(look.passes[0].draw == Draw::points);
    CHECK(look.passes[0].blend == Blend::add);
    CHECK(look.passes[0].vertex.file == disk.folder / "phosphor/beam.vert");
    CHECK(look.passes[0].declared == Location{look.manifest, 7});
    const Pass& persistence = look.passes[1];
    CHECK(persistence.vertex.file.empty());
    REQUIRE(persistence.inputs.size() == 2);
    CHECK(persistence.inputs[0].uniform == "current");
    CHECK(persistence.inputs[0].reference() == "beam");
    CHECK(persistence.inputs[1].reference() == "persistence@1");
    CHECK(persistence.inputs[1].sampler == Sampler{});
    CHECK(look.passes[2].size[1] == Side{Side::By::viewport, 0.5, {}});
    CHECK(look.passes[3].set == Values{{"direction", Value({0.0, 1.0})}});
    CHECK(look.passes[4].format == Format::rgba8);
    CHECK(look.passes[4].size[0] == Side{});
    CHECK(disk.files.size() == 6);
}

TEST_CASE("defaults are as documented") {
    LookOnDisk disk;
    const auto look = disk.load(
        look_with("\"output\": \"linear\", ", R"({"name": "a", "fragment": "blur.frag"})"));
    REQUIRE(look.has_value());
    CHECK(look->name == "phosphor");
    CHECK(look->driven_by == Driver::nothing);
    CHECK(look->source_encoding == Encoding::linear);
    CHECK(look->settle_frames == 1);
    CHECK_FALSE(look->has_orbit);
    const Pass& pass = look->passes.front();
    CHECK(pass.draw == Draw::fullscreen);
    CHECK(pass.format == Format::rgba16f);
    CHECK(pass.blend == Blend::replace);
    CHECK(pass.size[0] == Side{});
    CHECK(std::get<int>(pass.repeat) == 1);
}

TEST_CASE("every key of a pass, an input and an image is read") {
    LookOnDisk disk;
    const auto look = disk.load(look_with(
        picture_head +
            R"("source_encoding": "display", "orbit": true, "images": {"lut": "lut.png", "noise": {"file": "lut.png", "filter": "nearest", "wrap": "repeat", "mipmap": true, "linear": true}}, )",
        R"json({"name": "a", "fragment": "blur.frag", "scale": [2, 0.5], "scale_of": "source",
            "inputs": {"s": "source@2", "l": {"from": "noise", "wrap": "mirror"}, "o": {"from": "a@64", "filter": "nearest", "wrap": "border", "mipmap": true}},
            "rename": {"radius": "a_radius"}, "accumulate": true, "converge": 500, "repeat": 8, "frame_modulo": 60, "set": {"x": true, "m": [1, 0, 0, 1]}},
           {"name": "b", "fragment": "blur.frag", "size": [320, "$HEIGHT / floor($pixels)"], "one_channel": "$mono", "half_floats": "1 - $slow", "repeat": "count", "accumulate": true, "converge": "enough"})json"));
    REQUIRE(look.has_value());
    CHECK(look->default_source == "pattern:smpte");
    CHECK(look->source_encoding == Encoding::display);
    CHECK(look->has_orbit);
    REQUIRE(look->images.size() == 2);
    CHECK(look->images[0].file == disk.folder / "phosphor/lut.png");
    CHECK(look->images[1].sampler == Sampler{Filter::nearest, Wrap::repeat, true});
    CHECK(look->images[1].is_linear);
    const Pass& a = look->passes[0];
    CHECK(a.size[0] == Side{Side::By::source, 2.0, {}});
    CHECK(a.size[1] == Side{Side::By::source, 0.5, {}});
    CHECK(a.inputs[0].from == Input::From::source);
    CHECK(a.inputs[0].frames_ago == 2);
    CHECK(a.inputs[1].from == Input::From::image);
    CHECK(a.inputs[1].sampler == Sampler{Filter::nearest, Wrap::mirror, true});
    CHECK(a.inputs[2].frames_ago == 64);
    CHECK(a.inputs[2].sampler == Sampler{Filter::nearest, Wrap::border, true});
    CHECK(a.rename.at("radius") == "a_radius");
    CHECK(a.accumulate);
    CHECK(std::get<int>(a.repeat) == 8);
    CHECK(a.converge == Count(500));
    CHECK(a.frame_modulo == 60);
    CHECK(a.set == Values{{"x", 1.0}, {"m", Value({1.0, 0.0, 0.0, 1.0})}});
    const Pass& b = look->passes[1];
    CHECK(b.size[0] == Side{Side::By::pixels, 320.0, {}});
    CHECK(b.size[1] == Side{Side::By::expression, 1.0, "$HEIGHT / floor($pixels)"});
    CHECK(b.one_channel == "$mono");
    CHECK(b.half_floats == "1 - $slow");
    CHECK(std::get<std::string>(b.repeat) == "count");
    CHECK(b.converge == Count("enough"));
}

TEST_CASE("a pass of segments may set its spot size") {
    LookOnDisk disk;
    const std::string signal = "\"driven_by\": \"signal\", \"output\": \"linear\", ";
    const std::string segments =
        R"({"name": "a", "draw": "segments", "vertex": "beam.vert", "fragment": "blur.frag", )";
    const auto look = disk.load(look_with(signal, segments + R"("spot": [0.5, "4 / $HEIGHT"]})"));
    REQUIRE(look.has_value());
    CHECK(look->passes[0].spot[0] == "0.500000000000");
    CHECK(look->passes[0].spot[1] == "4 / $HEIGHT");
    CHECK(disk.errors_of(look_with(signal, segments + "\n\"spot\": [-1,\n\" \"]}")) ==
          "look.json:3: error: each length of 'spot' must be 0 or more, or an expression such as "
          "'2 * $spot_px / $HEIGHT'\n"
          "look.json:4: error: each length of 'spot' must be 0 or more, or an expression such as "
          "'2 * $spot_px / $HEIGHT'\n");
    CHECK(disk.errors_of(look_with(signal, segments + "\"spot\": 1}")) ==
          "look.json:2: error: 'spot' must be a list [across, up]\n");
    CHECK(disk.errors_of(
              look_with(signal, R"({"name": "a", "fragment": "blur.frag", "spot": [1, 1]})")) ==
          "look.json:2: error: 'spot' needs 'draw': 'segments'\n");
}

TEST_CASE("unknown keys are errors at their line, with a suggestion") {
    LookOnDisk disk;
    CHECK(disk.errors_of(
              look_with("\"licence\": \"MIT\", ",
                        "{\"name\": \"a\",\n\"fragment\": \"blur.frag\",\n\"formt\": "
                        "\"rgba8\",\n\"inputs\": {\"i\": {\"from\": \"a@1\",\n\"filtre\": 1}}}")) ==
          "look.json:1: error: unknown key 'licence' (did you mean 'license'?)\n"
          "look.json:4: error: unknown key 'formt' (did you mean 'format'?)\n"
          "look.json:6: error: unknown key 'filtre' (did you mean 'filter'?)\n");
}

TEST_CASE("inputs with an invalid reference are errors") {
    LookOnDisk disk;
    CHECK(disk.errors_of(look_with("", R"({"name": "beam", "fragment": "blur.frag", "inputs": {
"a": "beam",
"b": "last",
"c": "baem_",
"d": "source",
"e": "last@65",
"f": "last@x",
"g": "last@0",
"h": "beam@1", "i": 3, "j": {}}},
{"name": "last", "fragment": "blur.frag", "inputs": {"a": "beam"}})")) ==
          "look.json:3: error: a pass can't read its own target while it draws; use 'beam@1' for "
          "the previous frame\n"
          "look.json:4: error: pass 'last' is drawn after this one; use 'last@1' for its previous "
          "frame\n"
          "look.json:5: error: unknown pass or image 'baem_'\n"
          "look.json:6: error: 'source' needs a look with 'driven_by': 'picture'\n"
          "look.json:7: error: 'last@65': expected a number of frames from 0 to 64 after '@'\n"
          "look.json:8: error: 'last@x': expected a number of frames from 0 to 64 after '@'\n"
          "look.json:9: error: pass 'last' is drawn after this one; use 'last@1' for its previous "
          "frame\n"
          "look.json:10: error: 'i' must be an object {...}, got 3\n"
          "look.json:10: error: 'from' is missing\n");
    CHECK(disk.errors_of(
                  look_with("",
                            "{\"name\": \"beam\", \"fragment\": \"blur.frag\"},\n{\"name\": "
                            "\"b\", \"fragment\": \"blur.frag\", \"inputs\": {\"i\": \"baem\"}}"))
              .starts_with("look.json:3: error: unknown pass or image 'baem'"));
}

TEST_CASE("names of passes are validated") {
    LookOnDisk disk;
    const std::string rule =
        "Use 1 to 64 letters, digits, _ and -, start with a letter or _, and don't use "
        "'source'.\n";
    CHECK(disk.errors_of(look_with("\"images\": {\"lut\": \"lut.png\"}, ",
                                   R"({"name": "a", "fragment": "blur.frag"},
{"name": "a", "fragment": "blur.frag"},
{"name": "source", "fragment": "blur.frag"},
{"name": "../up", "fragment": "blur.frag"},
{"fragment": "blur.frag"},
{"name": "", "fragment": "blur.frag"},
{"name": "lut", "fragment": "blur.frag"}, 7)")) ==
          "look.json:3: error: the name 'a' is already used by the pass on line 2\n"
          "look.json:4: error: 'source' can't be the name of a pass. " +
              rule + "look.json:5: error: '../up' can't be the name of a pass. " + rule +
              "look.json:6: error: 'name' is missing\n"
              "look.json:7: error: '' can't be the name of a pass. " +
              rule +
              "look.json:8: error: expected an object {...}, got 7\n"
              "look.json:8: error: the name 'lut' is already used by an image\n");
}

TEST_CASE("points and segments need a vertex shader and a signal") {
    LookOnDisk disk;
    CHECK(disk.errors_of(
              look_with("", R"({"name": "a", "draw": "points", "fragment": "blur.frag"})")) ==
          "look.json:2: error: 'draw': 'points' needs a 'vertex' shader\n"
          "look.json:2: error: 'draw': 'points' needs a look with 'driven_by': 'signal'\n");
}

TEST_CASE("files must be in the look's folder") {
    LookOnDisk disk;
    disk.folder.write("outside.frag", "");
    fs::create_directory(disk.folder / "phosphor/folder");
    CHECK(disk.errors_of(look_with("", R"({"name": "a", "fragment": "../outside.frag"},
{"name": "b", "fragment": "/etc/passwd"},
{"name": "d", "fragment": "blur.fraq"},
{"name": "e", "fragment": "folder"},
{"name": "f", "fragment": ""},
{"name": "g", "fragment": "x\u0000"},
{"name": "h", "fragment": "folder/../blur.frag"},
{"name": "i", "vertex": 3})")) ==
          "look.json:2: error: '../outside.frag' is outside the look's folder. Copy the file into "
          "the look's folder.\n"
          "look.json:3: error: '/etc/passwd' is outside the look's folder. Copy the file into the "
          "look's folder.\n"
          "look.json:4: error: can't find 'blur.fraq' in the look's folder (did you mean "
          "'blur.frag'?)\n"
          "look.json:5: error: 'folder' isn't a file\n"
          "look.json:6: error: '' isn't a valid file name\n"
          "look.json:7: error: 'x\\x00' isn't a valid file name\n"
          "look.json:8: error: 'folder/../blur.frag' is outside the look's folder. Copy the file "
          "into the look's folder.\n"
          "look.json:9: error: 'vertex' must be a text in quotes, got 3\n"
          "look.json:9: error: 'fragment' is missing\n");
    CHECK(std::find(disk.files.begin(), disk.files.end(), disk.folder / "phosphor/blur.fraq") !=
          disk.files.end());
}

TEST_CASE("a symbolic link in the look's folder is accepted") {
    LookOnDisk disk;
    disk.folder.write("outside.frag", "");
    fs::create_symlink("../outside.frag", disk.folder / "phosphor/link.frag");
    const auto look = disk.load(look_with("", R"({"name": "a", "fragment": "link.frag"})"));
    REQUIRE(look.has_value());
    CHECK(look->passes[0].fragment.file == disk.folder / "phosphor/link.frag");
}

TEST_CASE("sizes, formats and counts are validated") {
    LookOnDisk disk;
    CHECK(
        disk.errors_of(look_with("", R"({"name": "a", "fragment": "blur.frag", "scale": 0},
{"name": "b", "fragment": "blur.frag", "scale": [1, 65]},
{"name": "c", "fragment": "blur.frag", "scale_of": "source"},
{"name": "d", "fragment": "blur.frag", "size": [0.5, ""]},
{"name": "e", "fragment": "blur.frag", "size": 5},
{"name": "f", "fragment": "blur.frag", "size": [5, 5], "scale": 1},
{"name": "g", "fragment": "blur.frag", "repeat": 0, "converge": 5},
{"name": "h", "fragment": "blur.frag", "frame_modulo": -1},
{"name": "i", "fragment": "blur.frag", "set": {"a": "text"}, "rename": {"a": "9"}},
{"name": "j", "fragment": "blur.frag", "format": "r32ui", "blend": "add"},
{"name": "k", "fragment": "blur.frag", "format": "r11f_g11f_b10f", "one_channel": " ", "inputs": {"a": {"from": "j", "filter": "linear", "mipmap": true}}},
{"name": "l", "fragment": "blur.frag", "format": "rgba61f"})")) ==
        "look.json:2: error: 'scale' must be a number above 0 and at most 64, or a list [x, y]\n"
        "look.json:3: error: 'scale' must be a number above 0 and at most 64, or a list [x, y]\n"
        "look.json:4: error: 'scale_of': 'source' needs a look with 'driven_by': 'picture'\n"
        "look.json:5: error: each side of 'size' must be 1 to 16384 pixels or an expression such "
        "as "
        "'$WIDTH/2'\n"
        "look.json:5: error: each side of 'size' must be 1 to 16384 pixels or an expression such "
        "as "
        "'$WIDTH/2'\n"
        "look.json:6: error: 'size' must be a list [width, height]\n"
        "look.json:7: error: a pass with 'size' can't have 'scale' or 'scale_of'\n"
        "look.json:8: error: 'repeat' must be a whole number between 1 and 1024, got 0\n"
        "look.json:8: error: 'converge' needs 'accumulate': true\n"
        "look.json:9: error: 'frame_modulo' must be a whole number between 0 and 16777216, got -1\n"
        "look.json:10: error: 'a' must be a number or a list of numbers, got 'text'\n"
        "look.json:10: error: '9' can't be the name of a parameter. Use 1 to 64 letters, digits, _ "
        "and -, start with a letter or _, and don't use 'source'.\n"
        "look.json:11: error: a target with an integer format can't be blended\n"
        "look.json:12: error: 'one_channel' must be an expression such as '$mono'\n"
        "look.json:12: error: pass 'j' has an integer format; use 'filter': 'nearest'\n"
        "look.json:12: error: pass 'j' has an integer format, which can't have mipmaps\n"
        "look.json:13: error: unknown value 'rgba61f' for 'format' (did you mean 'rgba16f'?); use "
        "one of: r8, "
        "rg8, rgba8, srgb8_alpha8, rgb10_a2, r11f_g11f_b10f, r16f, rg16f, rgba16f, r32f, rg32f, "
        "rgba32f, "
        "r32ui, r8ui, rg8ui, rgba8ui, rgb10_a2ui, r16ui, rg16ui, rgba16ui, rg32ui, rgba32ui, "
        "r32i, r8i, rg8i, rgba8i, r16i, rg16i, rgba16i, rg32i, rgba32i\n");
    const auto whole =
        disk.load(look_with("", R"({"name": "j", "fragment": "blur.frag", "format": "r32ui"},
{"name": "k", "fragment": "blur.frag", "inputs": {"a": "j"}})"));
    REQUIRE(whole.has_value());
    CHECK(whole->passes[1].inputs[0].sampler.filter == Filter::nearest);
}

TEST_CASE("the driver of a look is validated") {
    LookOnDisk disk;
    const std::string pass = R"({"name": "a", "fragment": "blur.frag"})";
    CHECK(disk.errors_of(look_with("\"driven_by\": \"picture\", ", pass)) ==
          "look.json:1: error: 'driven_by': 'picture' needs a 'default_source' such as "
          "'pattern:smpte'\n");
    CHECK(disk.errors_of(look_with("\"default_source\": \"pattern:smpte\", ", pass)) ==
          "look.json:1: error: 'default_source' needs 'driven_by': 'picture'\n");
    CHECK(disk
              .errors_of(look_with(
                  "\"driven_by\": \"picture\", \"default_source\": \"pattern:smtpe\", ", pass))
              .starts_with("look.json:1: error: unknown pattern 'smtpe'"));
    CHECK(disk.errors_of(
                  look_with("\"driven_by\": \"picture\", \"default_source\": \"../a.png\", ", pass))
              .starts_with("look.json:1: error: '../a.png' is outside the look's folder"));
    CHECK(disk.errors_of(look_with("\"default_signal\": {\"kind\": \"lissajous\"}, ", pass)) ==
          "look.json:1: error: 'default_signal' needs 'driven_by': 'signal'\n");
    CHECK(disk
              .errors_of(look_with(
                  "\"driven_by\": \"signal\", \"default_signal\": {\"kind\": \"x\"}, ", pass))
              .starts_with("look.json:1: error: "));
    for (const char* key : {"path", ""})
        CHECK(disk.errors_of(look_with(std::string("\"driven_by\": \"signal\", \"default_signal\": "
                                                   "{\"kind\": \"socket\", \"") +
                                           key + "\": \"/any/where\"}, ",
                                       pass)) ==
              "look.json:1: error: a look can't set the path of a socket; remove 'path'\n");
    const auto own =
        disk.load(look_with("\"driven_by\": \"picture\", \"default_source\": \"lut.png\", ", pass));
    REQUIRE(own.has_value());
    CHECK(own->default_source == disk.folder / "phosphor/lut.png");
}

TEST_CASE("a look without passes or with too many is rejected") {
    LookOnDisk disk;
    CHECK(disk.errors_of(look_with("", "")) ==
          "look.json:1: error: a look must have 1 to 256 passes, got 0\n");
    std::string many = R"({"name": "p0", "fragment": "blur.frag"})";
    for (int i = 1; i < 257; ++i)
        many += ",{\"name\": \"p" + std::to_string(i) + "\", \"fragment\": \"blur.frag\"}";
    CHECK(disk.errors_of(look_with("", many)) ==
          "look.json:1: error: a look must have 1 to 256 passes, got 257\n");
    CHECK(disk.errors_of(R"({"format": "afterglow-look", "version": 1})") ==
          "look.json:1: error: 'passes' is missing\n");
}

TEST_CASE("an invalid manifest is rejected with its file, and a line if possible") {
    LookOnDisk disk;
    CHECK(disk.errors_of("") == "look.json:1: error: the file is empty\n");
    CHECK(disk.errors_of(std::string("{\n\0", 3)) ==
          "look.json:2: error: this is not a text file: it contains a NUL byte\n");
    CHECK(disk.errors_of("[]") == "look.json:1: error: expected an object {...}, got []\n");
    CHECK(disk.errors_of("{\"format\": \"afterglow-look\",\n\"version\": 9, \"new\": 1}") ==
          "look.json:2: error: format version 9 is too new; this version of Afterglow reads up to "
          "1. Update "
          "Afterglow to open it.\n");
    std::vector<fs::path> files;
    const auto missing = load_manifest(disk.folder / "none/look.json", files);
    REQUIRE_FALSE(missing.has_value());
    CHECK(missing.error().front().message == "file not found");
    CHECK(files == std::vector<fs::path>{disk.folder / "none/look.json"});
}

TEST_CASE("a truncated or randomly changed manifest is read or rejected with a line") {
    LookOnDisk disk;
    for (std::size_t size = 0; size + 2 < phosphor.size(); size += 3)
        CHECK(disk.errors_of(phosphor.substr(0, size)).starts_with("look.json:"));
    std::mt19937 random(31);
    for (int trial = 0; trial < 2000; ++trial) {
        std::string changed = phosphor;
        for (int change = 0; change < 1 + trial % 4; ++change)
            changed[random() % changed.size()] = static_cast<char>(random() % 96 + 32);
        const auto look = disk.load(changed);
        if (!look)
            for (const Diagnostic& reason : look.error())
                CHECK(reason.line >= 1);
    }
}

namespace {
std::string with_onto(const std::string& onto, const std::string& more = {},
                      const std::string& host = {}) {
    return look_with("", R"({"name": "light", "fragment": "blur.frag", )" + more + R"("onto": )" +
                             onto + R"(},
{"name": "glow", "fragment": "blur.frag", )" +
                             host +
                             R"("inputs": {"now": "light", "then": "glow@1"}},
{"name": "show", "fragment": "blur.frag", "inputs": {"image": "glow"}})");
}
}  // namespace

TEST_CASE("a pass may be drawn onto another one, under a condition") {
    LookOnDisk disk;
    const std::string onto = R"({"pass": "glow", "where": "1 - $apart"})";
    const std::string adds = R"("blend": "add", )";
    const auto look = disk.load(with_onto(onto, adds));
    REQUIRE(look.has_value());
    CHECK(look->passes[0].onto == Onto{"glow", "1 - $apart"});
    CHECK_FALSE(look->passes[1].onto.has_value());

    const std::string once =
        "look.json:2: error: 'onto' needs 'blend': 'add' and no 'accumulate' or 'repeat'\n";
    CHECK(disk.errors_of(with_onto(onto)) == once);
    CHECK(disk.errors_of(with_onto(onto, adds + R"("repeat": 2, )")) == once);
    CHECK(disk.errors_of(with_onto(onto, adds, R"("accumulate": true, )")) ==
          "look.json:2: error: can't draw onto 'glow' because it has 'accumulate', 'blend' or "
          "'onto'\n");
    CHECK(disk.errors_of(with_onto(R"({"pass": "show", "where": "1"})", adds)) ==
          "look.json:2: error: can't draw onto 'show' because it doesn't read 'light'\n");
    CHECK(disk.errors_of(with_onto(R"({"pass": "glos", "where": "1"})", adds)) ==
          "look.json:2: error: unknown pass 'glos' (did you mean 'glow'?)\n");
    CHECK(disk.errors_of(with_onto(R"({"pass": "glow", "where": " ", "wher": 1})", adds)) ==
          "look.json:2: error: 'where' must be an expression such as '1 - $is_squared'\n"
          "look.json:2: error: unknown key 'wher' (did you mean 'where'?)\n");
}

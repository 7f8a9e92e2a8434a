#include "formats/look_format.h"

#include "formats/preset/preset_format.h"
#include "formats/stack/stack_format.h"
#include "glsl/cache/check_cache.h"
#include "io/temporary_folder.h"
#include "problems_of.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace {
const fs::path source_tree = AFTERGLOW_SOURCE_DIR;

constexpr std::string_view small_manifest = R"({
  "format": "afterglow-look", "version": 1, "name": "Small",
  "passes": [
    { "name": "first", "fragment": "fill.frag", "rename": { "gain": "first_gain" } },
    { "name": "last", "fragment": "fill.frag", "size": ["$WIDTH", "$HEIGHT / $lines"],
      "set": { "tint": [1, 0, 0] } }
  ]
}
)";

constexpr std::string_view fragment =
    "#version 410 core\n"
    "#include \"light.glsl\"\n"
    "uniform float gain = 1.5;  // @range 0 4\n"
    "uniform int lines = 2;\n"
    "uniform vec3 tint = vec3(1);\n"
    "in vec2 uv;\n"
    "out vec4 color;\n"
    "void main() { color = vec4(light(tint) * gain * float(lines), uv); }\n";

class SmallLook {
public:
    SmallLook() {
        folder.write("small/look.json", small_manifest);
        folder.write("small/fill.frag", fragment);
        folder.write("shared/light.glsl", "vec3 light(vec3 value) { return value; }\n");
    }

    LoadedLook load(const fs::path& name = "small") {
        return load_look(folder / name, folder / "shared");
    }

    // All errors, with paths relative to the folder.
    std::string errors() {
        const LoadedLook loaded = load();
        REQUIRE_FALSE(loaded.look.has_value());
        std::string all;
        for (Diagnostic reason : loaded.look.error()) {
            reason.file = fs::relative(reason.file, folder.path());
            all += to_string(reason) + '\n';
        }
        return all;
    }

    TemporaryFolder folder;
};

bool contains(const std::vector<fs::path>& files, const fs::path& file) {
    return std::find(files.begin(), files.end(), file) != files.end();
}
}  // namespace

TEST_CASE("a look is loaded with passes, complete shaders and parameters") {
    SmallLook small;
    const LoadedLook loaded = small.load();
    REQUIRE(loaded.look.has_value());
    const Look& look = *loaded.look;
    CHECK(look.id == "small");
    CHECK(look.name == "Small");
    CHECK(parameter_names(look) == std::vector<std::string>{"first_gain", "lines", "tint", "gain"});
    CHECK(find_parameter(look, "gain")->range == Range{0.0, 4.0, 0.0});
    CHECK(find_parameter(look, "gain")->initial == Value(1.5));
    CHECK(find_parameter(look, "lines")->bindings ==
          std::vector<Binding>{{0, "lines"}, {1, "lines"}});
    CHECK(find_parameter(look, "tint")->bindings == std::vector<Binding>{{0, "tint"}});
    CHECK(look.passes[0].fragment.text->find("vec3 light(") != std::string::npos);
    CHECK(look.passes[0].fragment == look.passes[1].fragment);
    CHECK(look.passes[0].vertex.file.empty());
    CHECK_FALSE(look.passes[0].vertex.text->empty());
    for (const char* name : {"small/look.json", "small/fill.frag", "shared/light.glsl"})
        CHECK(contains(loaded.files, small.folder / name));
    CHECK(look.files == loaded.files);
    CHECK(loaded.warnings.empty());
}

TEST_CASE("a look is found by its folder or its manifest, also with a cache") {
    SmallLook small;
    const LoadedLook by_folder = small.load();
    CHECK(small.load("small/look.json").look == by_folder.look);
    CheckCache cache;
    for (int round = 0; round < 2; ++round)
        CHECK(load_look(small.folder / "small", small.folder / "shared", {&cache}).look ==
              by_folder.look);
}

TEST_CASE("a missing file is watched, and reported where it is used") {
    SmallLook small;
    fs::remove(small.folder / "shared/light.glsl");
    const LoadedLook loaded = small.load();
    REQUIRE_FALSE(loaded.look.has_value());
    CHECK(loaded.look.error().size() == 1);  // once, although two passes use the file
    CHECK(loaded.look.error().front().file == small.folder / "small/fill.frag");
    CHECK(loaded.look.error().front().line == 2);
    CHECK(contains(loaded.files, small.folder / "shared/light.glsl"));

    fs::remove(small.folder / "small/fill.frag");
    CHECK(small.errors() ==
          "small/look.json:4: error: can't find 'fill.frag' in the look's folder\n"
          "small/look.json:5: error: can't find 'fill.frag' in the look's folder\n");
    const LoadedLook none = small.load("none");
    REQUIRE_FALSE(none.look.has_value());
    CHECK(none.files == std::vector<fs::path>{small.folder / "none"});
}

TEST_CASE("shader errors are reported in their own file and line") {
    SmallLook small;
    std::string broken(fragment);
    broken.replace(broken.find("void main"), 9, "void mian");
    small.folder.write("small/fill.frag", broken);
    CHECK(small.errors().starts_with("small/fill.frag"));
    broken = fragment;
    broken.replace(broken.find("@range"), 6, "@rnage");
    small.folder.write("small/fill.frag", broken);
    CHECK(small.errors().starts_with("small/fill.frag:3: error: "));
}

TEST_CASE("unknown parameters in sizes and repeats are errors at their pass") {
    SmallLook small;
    std::string text(small_manifest);
    text.replace(text.find("$lines"), 6, "$linse");
    small.folder.write("small/look.json", text);
    CHECK(small.errors() ==
          "small/look.json:5: error: size of pass 'last': unknown name '$linse'\n");
    text = small_manifest;
    text.replace(text.find("\"set\""), 5, "\"repeat\": \"lins\", \"set\"");
    small.folder.write("small/look.json", text);
    CHECK(small.errors().starts_with("small/look.json:5: error: "));
}

TEST_CASE("parameters are in the order of the look's groups, and an empty group gives a warning") {
    SmallLook small;
    small.folder.write("small/fill.frag",
                       "#version 410 core\n"
                       "uniform float a = 1.0;  // @group \"One\"\n"
                       "uniform float b = 1.0;  // @group \"Two\"\n"
                       "uniform float c = 1.0;  // @group \"One\"\n"
                       "uniform float d = 1.0;\n"
                       "out vec4 color;\n"
                       "void main() { color = vec4(a, b, c, d); }\n");
    const std::string before = R"({ "format": "afterglow-look", "version": 1,)";
    const std::string after = R"("passes": [{ "name": "last", "fragment": "fill.frag" }] })";
    const auto names = [&](const std::string& groups) {
        small.folder.write("small/look.json", before + groups + after);
        return parameter_names(small.load().look.value());
    };
    CHECK(names("") == std::vector<std::string>{"a", "b", "c", "d"});
    CHECK(names(R"("groups": ["Two"],)") == std::vector<std::string>{"b", "a", "c", "d"});
    CHECK(names(R"("groups": ["Last", "Two", "One"],)") ==
          std::vector<std::string>{"d", "b", "a", "c"});
    small.folder.write("small/look.json", before + "\n\"groups\": [\"Too\"]," + after);
    const LoadedLook loaded = small.load();
    REQUIRE(loaded.warnings.size() == 1);
    CHECK(loaded.warnings[0].line == 2);
    CHECK(loaded.warnings[0].message == "the group 'Too' has no parameters");
}

TEST_CASE("every built-in look loads without errors or warnings") {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(source_tree / "shaders")) {
        if (!fs::exists(entry.path() / "look.json"))
            continue;
        ++count;
        const LoadedLook loaded = load_look(entry.path(), source_tree / "shaders/include");
        CHECK_MESSAGE(loaded.look.has_value(), problems_of(loaded.look));
        CHECK_MESSAGE(loaded.warnings.empty(), to_string(loaded.warnings));
    }
    CHECK(count > 0);
}

TEST_CASE("every built-in preset fits its look and is written as it is read") {
    for (const auto& folder : fs::directory_iterator(source_tree / "presets")) {
        Stack stack;
        for (const std::string& id : look_ids(folder.path().filename().string()))
            stack.push_back({id, source_tree / "shaders" / id, {}, false});
        const LoadedLook loaded = load_stack(stack, source_tree / "shaders/include");
        REQUIRE(loaded.look.has_value());
        for (const auto& entry : fs::directory_iterator(folder)) {
            if (entry.is_directory() || entry.path().filename() == "look.png")
                continue;  // content that the presets use, and the picture of the look
            const auto preset = load_preset(entry.path());
            REQUIRE_MESSAGE(preset.has_value(), problems_of(preset));
            const auto values = fitted_values(*loaded.look, *preset, entry.path());
            CHECK_MESSAGE(values.has_value(), problems_of(values));
            CHECK(orphans(*loaded.look, preset->values).empty());
            const auto written = parse_preset(preset_to_json(*preset, &*loaded.look), "a.json");
            REQUIRE(written.has_value());
            CHECK(fitted_values(*loaded.look, *written, "a.json") == values);
        }
    }
}

TEST_CASE("a foreign look is named after its file, with the separators of stacks escaped") {
    CHECK(foreign_look_id("aa/fxaa+linear.slangp") == "fxaa%2Blinear.slangp");
    CHECK(foreign_file_name("fxaa%2Blinear.slangp") == "fxaa+linear.slangp");
    CHECK(look_id_at("crt/a#1.slang") == "a%231.slang");
    CHECK(foreign_file_name("a%231.slang") == "a#1.slang");
    CHECK(look_id_at("shaders/phosphor/look.json") == "phosphor");
}

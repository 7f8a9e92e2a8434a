#include "lab/golden/golden_item.h"

#include "io/temporary_folder.h"
#include "problems_of.h"

#include <doctest/doctest.h>

namespace fs = std::filesystem;

namespace {
constexpr const char* plain_shader = "void main() { gl_FragColor = vec4(1.0); }";

std::string preset_for(const std::string& look) {
    return "{ \"format\": \"afterglow-preset\", \"version\": 1, \"look\": \"" + look + "\" }";
}

/// "NAME: FILE" of each item, with files relative to the folder.
std::vector<std::string> items_in(const TemporaryFolder& folder) {
    const auto found = read_golden_folder(folder.path());
    REQUIRE_MESSAGE(found.has_value(), problems_of(found));
    std::vector<std::string> items;
    for (const GoldenItem& item : found->items)
        items.push_back(item.name + ": " + item.file.lexically_relative(folder.path()).string());
    return items;
}
}  // namespace

TEST_CASE("looks, looks of other programs and presets are found in all subfolders") {
    const TemporaryFolder folder;
    folder.write("shaders/glow/look.json", "{}");
    folder.write("shaders/glow/show.frag", plain_shader);
    folder.write("presets/glow/Warm.json", preset_for("glow"));
    folder.write("presets/a.fs/full.json", preset_for("a.fs"));
    folder.write("more/deep/a.fs", plain_shader);
    folder.write("more/blue.json", preset_for("phosphor"));
    folder.write("package.json", "{ \"name\": \"not a look\" }");
    folder.write(".hidden/b.fs", plain_shader);
    folder.write("exported/portable.json", "{}");
    folder.write("exported/shaders/1-show.frag", plain_shader);
    CHECK(items_in(folder) ==
          std::vector<std::string>{"a.fs: more/deep/a.fs", "a.fs--full: presets/a.fs/full.json",
                                   "glow: shaders/glow", "glow--warm: presets/glow/Warm.json",
                                   "phosphor--blue: more/blue.json"});
}

TEST_CASE("a broken preset keeps the name of its picture") {
    const TemporaryFolder folder;
    folder.write("presets/glow/a.json", "{ oops");
    folder.write("b.json", "{ \"format\": \"afterglow-preset\", \"look\": \"tube\", oops");
    folder.write("c.json", "{ oops");
    CHECK(items_in(folder) ==
          std::vector<std::string>{"glow--a: presets/glow/a.json", "tube--b: b.json"});
}

TEST_CASE("equal names get the subfolder, then a digest of the path") {
    const TemporaryFolder folder;
    folder.write("film/crt/look.json", "{}");
    folder.write("tv/crt/look.json", "{}");
    folder.write("tube/look.json", "{}");
    folder.write("one two.json", preset_for("tube"));
    folder.write("one_two.json", preset_for("tube"));
    folder.write("one-two.json", preset_for("tube"));
    const std::vector<std::string> items = items_in(folder);
    REQUIRE(items.size() == 6);
    CHECK(items[0] == "film-crt: film/crt");
    CHECK(items[1] == "tube: tube");
    CHECK(items[2].starts_with("tube--one-two-"));
    CHECK(items[3].starts_with("tube--one-two-"));
    CHECK(items[2].substr(0, 22) != items[3].substr(0, 22));
    CHECK(items[4] == "tube--one_two: one_two.json");
    CHECK(items[5] == "tv-crt: tv/crt");
}

TEST_CASE("a folder without looks and presets is refused") {
    const TemporaryFolder folder;
    CHECK_FALSE(read_golden_folder(folder.path()).has_value());
    CHECK_FALSE(read_golden_folder(folder / "gone").has_value());
    const fs::path file = folder.write("a.fs", plain_shader);
    CHECK_FALSE(read_golden_folder(file).has_value());
}

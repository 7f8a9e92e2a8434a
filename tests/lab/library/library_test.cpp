#include "lab/library/library.h"

#include "base/file.h"
#include "base/text.h"
#include "formats/look/look_manifest.h"
#include "formats/preset/preset_format.h"
#include "lab/library/library_view.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>

namespace fs = std::filesystem;

namespace {
/// Two empty roots in their own folder, deleted at the end.
class TemporaryRoots {
public:
    TemporaryRoots() {
        std::string name = (fs::temp_directory_path() / "afterglow-library-XXXXXX").string();
        m_folder = mkdtemp(name.data());
        fs::create_directories(m_folder / "program" / "shaders" / "phosphor");
        std::ofstream(m_folder / "program" / "shaders" / "phosphor" / "look.json") << "{}";
    }
    ~TemporaryRoots() { fs::remove_all(m_folder); }
    /// Writes a file in the program's root.
    fs::path write_program(const std::string& name, const std::string& text) const {
        fs::path file = m_folder / "program" / name;
        fs::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << text;
        return file;
    }
    Roots roots() const { return {m_folder / "program", m_folder / "user", m_folder / "state"}; }

private:
    fs::path m_folder;
};

Preset night() {
    Preset preset;
    preset.look = "phosphor";
    preset.values = {{"decay", Value(0.9)}};
    return preset;
}
}  // namespace

TEST_CASE("a preset is saved under its look, listed, renamed and duplicated") {
    const TemporaryRoots folder;
    const Library library(folder.roots());
    const auto file = library.save_preset(night(), "Night sky");
    REQUIRE(file.has_value());
    CHECK(*file == folder.roots().user / "presets" / "phosphor" / "Night sky.json");
    REQUIRE(library.presets("phosphor").size() == 1);

    const auto copy = library.duplicate_preset(*file);
    REQUIRE(copy.has_value());
    CHECK(copy->filename() == "Night sky 2.json");
    const auto renamed = library.rename_preset(*file, "Dawn");
    REQUIRE(renamed.has_value());
    CHECK_FALSE(fs::exists(*file));
    CHECK(load_preset(*renamed)->name == "Dawn");
    CHECK(load_preset(*renamed)->values == night().values);

    CHECK_FALSE(library.rename_preset(*copy, "Dawn").has_value());  // would overwrite
    CHECK(library.presets("phosphor").size() == 2);
}

TEST_CASE("a preset of the user is overwritten only on request") {
    const TemporaryRoots folder;
    const Library library(folder.roots());
    const auto file = library.save_preset(night(), "Night");
    REQUIRE(file.has_value());
    const auto again = library.save_preset(night(), "Night");
    REQUIRE_FALSE(again.has_value());
    CHECK(again.error().front().message.find("'Night' already exists") != std::string::npos);
    CHECK_FALSE(library.new_preset_path("phosphor", "Night").has_value());
    CHECK(library.preset_path("phosphor", "Night") == *file);
}

TEST_CASE("a preset in the program folder is shipped if it matches the shipped digest") {
    const TemporaryRoots folder;
    const fs::path shipped = folder.write_program("presets/phosphor/amber.json", "{}");
    const fs::path added = folder.write_program("presets/phosphor/mine.json", "{}");
    const Library library(folder.roots(), {{"presets/phosphor/amber.json", digest_of("{}")}});
    CHECK(library.is_shipped(shipped));
    CHECK_FALSE(library.is_shipped(added));
    CHECK_FALSE(library.rename_preset(shipped, "Other").has_value());
    folder.write_program("presets/phosphor/amber.json", "{ }");
    CHECK_FALSE(library.is_shipped(shipped));  // modified, so it belongs to the user
}

TEST_CASE("a preset of the user and a shipped preset may have the same name") {
    const TemporaryRoots folder;
    folder.write_program("presets/phosphor/Night.json", "{}");
    const Library library(folder.roots(), {{"presets/phosphor/Night.json", digest_of("{}")}});
    const auto mine = library.save_preset(night(), "Night");
    REQUIRE(mine.has_value());
    REQUIRE(library.save_preset(night(), "Dawn").has_value());
    std::vector<std::string> ids;
    for (const PresetEntry& preset : library.presets("phosphor"))
        ids.push_back(preset.id);
    CHECK(ids == std::vector<std::string>{"Dawn", "user:Night", "Night"});
    CHECK(library.find_preset("phosphor", "Night")->is_shipped);
    CHECK(library.find_preset("phosphor", "shipped:Night")->is_shipped);
    CHECK(library.find_preset("phosphor", "user:Night")->file == *mine);
    CHECK_FALSE(library.find_preset("phosphor", "Dawn")->is_shipped);
    CHECK_FALSE(library.find_preset("phosphor", "shipped:Dawn").has_value());
}

TEST_CASE("the user's presets in the program folder can be moved to the user folder") {
    const TemporaryRoots folder;
    folder.write_program("presets/phosphor/amber.json", "{}");
    const fs::path mine = folder.write_program("presets/phosphor/Mine.json", "{\"a\": 1}");
    const Library library(folder.roots(), {{"presets/phosphor/amber.json", digest_of("{}")}});
    REQUIRE(library.save_preset(night(), "Mine").has_value());
    const auto found = library.presets_in_program_folder();
    REQUIRE(found.size() == 1);
    CHECK(found.front().file == mine);
    const auto moved = library.move_to_user_folder(found.front());
    REQUIRE(moved.has_value());
    CHECK(moved->filename() == "Mine 2.json");
    CHECK(read_text(*moved) == "{\"a\": 1}");
    CHECK_FALSE(fs::exists(mine));
    CHECK(library.presets_in_program_folder().empty());
}

TEST_CASE("presets with equal names are listed with their file names") {
    const TemporaryRoots folder;
    const Library library(folder.roots());
    Preset preset = night();
    preset.name = "Night";
    for (const char* file : {"one", "two"})
        REQUIRE(library.save_preset(preset, file).has_value());
    preset.name = "Day";
    REQUIRE(library.save_preset(preset, "three").has_value());
    LibraryView library_view;
    library_view.update(library, nullptr, 1.0);
    REQUIRE(library_view.looks().size() == 1);
    std::vector<std::string> names;
    for (const ListedLookPreset& shown : library_view.looks().front().presets)
        names.push_back(shown.name);
    CHECK(names == std::vector<std::string>{"Day", "Night (one)", "Night (two)"});
}

TEST_CASE("a look keeps its listed name while its look.json is broken") {
    const TemporaryRoots folder;
    const Library library(folder.roots());
    const std::string good =
        R"({"format": "afterglow-look", "version": 1, "name": "Heat wave", "driven_by": "nothing",
            "passes": [{"name": "picture", "fragment": "picture.frag"}]})";
    const fs::path manifest = folder.write_program("shaders/heatwave/look.json", good);
    folder.write_program("shaders/heatwave/picture.frag", "void main() {}\n");
    LibraryView library_view;
    const auto listed_name = [&] {
        library_view.update(library, nullptr, 2.0);
        const auto look = std::ranges::find_if(library_view.looks(), [](const ListedLook& listed) {
            return listed.entry.id == "heatwave";
        });
        REQUIRE(look != library_view.looks().end());
        return look->name;
    };
    CHECK(listed_name() == "Heat wave");
    folder.write_program("shaders/heatwave/look.json", good.substr(0, 60));
    fs::last_write_time(manifest, fs::last_write_time(manifest) + std::chrono::seconds(2));
    CHECK(listed_name() == "Heat wave");
}

TEST_CASE("a name that is not a file name is refused") {
    const TemporaryRoots folder;
    const Library library(folder.roots());
    for (const char* name : {"", ".", "..", "../evil", "a/b", " a", "a\nb", ".hidden", "a\\b"})
        CHECK_FALSE(library.save_preset(night(), name).has_value());
    CHECK(library.save_preset(night(), "Grün 31 (soft)").has_value());
}

TEST_CASE("a preset with a path as its look is not saved") {
    const TemporaryRoots folder;
    const Library library(folder.roots());
    for (const char* look : {"../../elsewhere", "..", "/tmp", "phosphor/.."}) {
        Preset preset = night();
        preset.look = look;
        CHECK_FALSE(library.save_preset(preset, "Night").has_value());
    }
    CHECK(library.save_preset(night(), "Night").has_value());
}

TEST_CASE("a look is duplicated with all its files and never over another") {
    const TemporaryRoots folder;
    const Library library(folder.roots());
    const auto look = library.find_look("phosphor");
    REQUIRE(look.has_value());
    const auto copy = library.duplicate_look(look->folder, "mine");
    REQUIRE(copy.has_value());
    CHECK(fs::exists(*copy / "look.json"));
    CHECK_FALSE(library.duplicate_look(look->folder, "mine").has_value());
    CHECK(library.looks().size() == 2);
}

TEST_CASE("a new look has the files of its template, another name, and no picture") {
    const TemporaryRoots folder;
    Roots roots = folder.roots();
    roots.program = AFTERGLOW_SOURCE_DIR;
    const Library library(roots);
    const auto created = library.new_look("night-scope", "beam");
    REQUIRE(created.has_value());
    const fs::path original = roots.program / "shaders/templates/beam";
    CHECK(read_text(*created / "beam.vert") == read_text(original / "beam.vert"));
    CHECK(fs::exists(original / "look.png"));
    CHECK_FALSE(fs::exists(*created / "look.png"));
    std::vector<fs::path> files;
    const auto look = load_manifest(*created / "look.json", files);
    REQUIRE(look.has_value());
    CHECK(look->name == "Night scope");
    CHECK_FALSE(library.new_look("night-scope", "filter").has_value());
    CHECK_FALSE(library.new_look("other", "none").has_value());
    CHECK_FALSE(fs::exists(roots.user / "shaders/other"));
}

TEST_CASE("presets are listed as the user's, the shipped ones, then those of the article") {
    const auto shipped = [](const char* name) {
        return PresetEntry{"look", name, std::string(name) + ".json", true};
    };
    const PresetEntry mine{"look", "article-of-mine", "article-of-mine.json", false};
    CHECK(is_listed_before(mine, "Zebra", shipped("amber"), "Amber"));
    CHECK(is_listed_before(shipped("amber"), "amber", shipped("blue"), "Blue"));
    CHECK(is_listed_before(shipped("white"), "White", shipped("article"), "Original article"));
    CHECK(is_listed_before(shipped("article"), "Original article", shipped("article-mono"),
                           "Original article, monochrome"));
}

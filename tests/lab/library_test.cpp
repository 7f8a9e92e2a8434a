#include "lab/library.h"

#include "formats/preset_format.h"
#include "lab/shelf.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>

namespace fs = std::filesystem;

namespace {
/// Two empty roots in a folder of their own, gone at the end.
class TemporaryRoots {
public:
    TemporaryRoots() {
        std::string name = (fs::temp_directory_path() / "afterglow-library-XXXXXX").string();
        m_folder = mkdtemp(name.data());
        fs::create_directories(m_folder / "program" / "shaders" / "phosphor");
        std::ofstream(m_folder / "program" / "shaders" / "phosphor" / "look.json") << "{}";
    }
    ~TemporaryRoots() { fs::remove_all(m_folder); }
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

TEST_CASE("a preset is saved under its look, listed, renamed, duplicated and deleted") {
    const TemporaryRoots folder;
    const Library library(folder.roots());
    const auto file = library.save_preset(night(), "Night sky");
    REQUIRE(file.has_value());
    CHECK(*file == folder.roots().program / "presets" / "phosphor" / "Night sky.json");
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
    CHECK(library.delete_preset(*copy).has_value());
    CHECK_FALSE(library.delete_preset(*copy).has_value());
    CHECK(library.presets("phosphor").size() == 1);
}

TEST_CASE("no preset is saved over another, nor hides one of the program's, unless that is asked") {
    const TemporaryRoots folder;
    const Library library(folder.roots());
    const auto file = library.save_preset(night(), "Night");
    REQUIRE(file.has_value());
    const auto again = library.save_preset(night(), "Night");
    REQUIRE_FALSE(again.has_value());
    CHECK(again.error().front().message.find("'Night' already") != std::string::npos);
    CHECK_FALSE(library.new_preset_path("phosphor", "Night").has_value());
    CHECK(library.preset_path("phosphor", "Night") == *file);

    Roots roots = folder.roots();
    roots.user = roots.program;
    roots.program = roots.user / "shaders";  // what was saved now belongs to the person
    CHECK_FALSE(Library(roots).save_preset(night(), "Night").has_value());
}

TEST_CASE("presets that say the same name of themselves are told apart by their files") {
    const TemporaryRoots folder;
    const Library library(folder.roots());
    Preset preset = night();
    preset.name = "Night";
    for (const char* file : {"one", "two"})
        REQUIRE(library.save_preset(preset, file).has_value());
    preset.name = "Day";
    REQUIRE(library.save_preset(preset, "three").has_value());
    Shelf shelf;
    shelf.update(library, nullptr, 1.0);
    REQUIRE(shelf.looks().size() == 1);
    std::vector<std::string> names;
    for (const ShelfPreset& shown : shelf.looks().front().presets)
        names.push_back(shown.name);
    CHECK(names == std::vector<std::string>{"Night (one)", "Day", "Night (two)"});
}

TEST_CASE("a name that is no file's name is refused") {
    const TemporaryRoots folder;
    const Library library(folder.roots());
    for (const char* name : {"", ".", "..", "../evil", "a/b", " a", "a\nb", ".hidden", "a\\b"})
        CHECK_FALSE(library.save_preset(night(), name).has_value());
    CHECK(library.save_preset(night(), "Grün 31 (soft)").has_value());
}

TEST_CASE("a preset's file does not say where to write") {
    const TemporaryRoots folder;
    const Library library(folder.roots());
    for (const char* look : {"../../elsewhere", "..", "/tmp", "phosphor/.."}) {
        Preset preset = night();
        preset.look = look;
        CHECK_FALSE(library.save_preset(preset, "Night").has_value());
    }
    CHECK(library.save_preset(night(), "Night").has_value());
}

TEST_CASE("where the program's folder cannot be written, presets go to the person's own") {
    const TemporaryRoots folder;
    Roots roots = folder.roots();
    roots.program /= "shaders/phosphor/look.json";  // a file, so nothing can be written below it
    const Library library(roots);
    const auto file = library.save_preset(night(), "Night");
    REQUIRE(file.has_value());
    CHECK(*file == roots.user / "presets" / "phosphor" / "Night.json");
    CHECK(library.presets("phosphor").front().is_own);
}

TEST_CASE("a look is duplicated with all its files, and not over another") {
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

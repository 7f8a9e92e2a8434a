#include "formats/stack/former_readings.h"

#include "formats/stack/stack_format.h"
#include "glsl/text/shader_files.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>

namespace fs = std::filesystem;

namespace {
constexpr const char* manifest = R"({ "format": "afterglow-look", "version": 1, "name": "Look",
  "driven_by": "nothing", "passes": [ { "name": "picture", "fragment": "a.frag" } ] })";

std::string frag_with(const std::string& number) {
    return "#version 410 core\n"
           "#include \"light.glsl\"\n"
           "uniform float gain = 1.0;\n"
           "in vec2 uv;\n"
           "out vec4 color;\n"
           "void main() { color = vec4(gain * light() * " +
           number + "); }\n";
}

/// A look on disk that is loaded repeatedly, as by a reloader.
struct Disk {
    Disk() {
        folder.write("look/look.json", manifest);
        folder.write("look/a.frag", frag_with("0.1"));
        folder.write("include/light.glsl", "float light() { return 1.0; }\n");
    }
    FormerReadings::Question question(const Values& values = {}) const {
        return {{{"", folder / "look", ""}}, values};
    }
    /// Starts reading; returns the cached look if no file has changed since.
    std::optional<LoadedLook> find(const Values& values = {}) {
        files.begin_reading();
        return readings.find(question(values), files);
    }
    LoadedLook read(const Values& values = {}) {
        LoadedLook loaded = load_stack(question(values).stack, folder / "include",
                                       {nullptr, nullptr, &values, &files});
        readings.keep(question(values), loaded, files);
        return loaded;
    }

    TemporaryFolder folder;
    ShaderFiles files;
    FormerReadings readings;
};
}  // namespace

TEST_CASE("a text that returns to an earlier state gives the cached look, and no other text does") {
    Disk disk;
    CHECK_FALSE(disk.find());
    const LoadedLook first = disk.read();
    REQUIRE(first.look);
    const auto again = disk.find();
    REQUIRE(again);
    CHECK(*again->look == *first.look);
    CHECK(again->files == first.files);

    disk.folder.write("look/a.frag", frag_with("0.2"));  // as long as the first
    CHECK_FALSE(disk.find());
    const LoadedLook second = disk.read();
    REQUIRE(second.look);
    CHECK(*second.look != *first.look);

    disk.folder.write("look/a.frag", frag_with("0.1"));
    const auto undone = disk.find();
    REQUIRE(undone);
    CHECK(*undone->look == *first.look);
}

TEST_CASE("a change to any file of a look invalidates the cache") {
    Disk disk;
    CHECK_FALSE(disk.find());
    REQUIRE(disk.read().look);
    SUBCASE("an include") {
        disk.folder.write("include/light.glsl", "float light() { return 2.0; }\n");
    }
    SUBCASE("the manifest") {
        std::string text = manifest;
        disk.folder.write("look/look.json", text.replace(text.find("Look"), 4, "Sight"));
    }
    SUBCASE("a missing file earlier in the include path appears") {
        disk.folder.write("look/light.glsl", "float light() { return 1.0; }\n");
    }
    SUBCASE("a removed file") {
        fs::remove(disk.folder / "look/a.frag");
    }
    SUBCASE("a file replaced by a link to the same text") {
        fs::rename(disk.folder / "look/a.frag", disk.folder / "b.frag");
        fs::create_symlink(disk.folder / "b.frag", disk.folder / "look/a.frag");
    }
    CHECK_FALSE(disk.find());
}

TEST_CASE("other values of constants are another cache entry") {
    Disk disk;
    CHECK_FALSE(disk.find());
    REQUIRE(disk.read().look);
    CHECK_FALSE(disk.find({{"STEPS", Value(2.0)}}));
}

TEST_CASE("a file that changes while the look is loaded is not cached with the new text") {
    Disk disk;
    CHECK_FALSE(disk.find());
    const Values none;
    LoadedLook loaded = load_stack(disk.question().stack, disk.folder / "include",
                                   {nullptr, nullptr, &none, &disk.files});
    REQUIRE(loaded.look);
    disk.folder.write("look/a.frag", frag_with("0.2"));
    disk.readings.keep(disk.question(), loaded, disk.files);
    CHECK_FALSE(disk.find());
    disk.folder.write("look/a.frag", frag_with("0.1"));
    CHECK(disk.find());
}

TEST_CASE("failed loads and looks with unknown files are loaded again") {
    Disk disk;
    SUBCASE("an error") {
        disk.folder.write("look/a.frag", "#version 410 core\nvoid main() { nothing(); }\n");
        CHECK_FALSE(disk.find());
        CHECK_FALSE(disk.read().look);
    }
    SUBCASE("a foreign look that was read without the compared files") {
        const fs::path file = disk.folder.write(
            "a.fs", "/*{}*/\nvoid main() { gl_FragColor = vec4(isf_FragNormCoord, 0.0, 1.0); }\n");
        const FormerReadings::Question question{{{"", file, ""}}, {}};
        disk.files.begin_reading();
        const LoadedLook loaded = load_stack(question.stack, disk.folder / "include",
                                             {nullptr, nullptr, nullptr, &disk.files});
        REQUIRE(loaded.look);
        disk.readings.keep(question, loaded, disk.files);
        CHECK_FALSE(disk.readings.find(question, disk.files));
    }
    CHECK_FALSE(disk.find());
}

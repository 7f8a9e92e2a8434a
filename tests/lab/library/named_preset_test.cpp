#include "lab/library/named_preset.h"

#include "io/temporary_folder.h"

#include <doctest/doctest.h>

namespace fs = std::filesystem;

namespace {
/// A library with two looks; files have other names than they display.
class Presets {
public:
    Presets() {
        m_folder.write("shaders/phosphor/look.json", "{}");
        m_folder.write("shaders/crt/look.json", "{}");
        amber = add("presets/phosphor/amber-p3.json", "phosphor", "Warm amber");
        mine = add("user/presets/phosphor/My glow.json", "phosphor", "My glow");
        arcade = add("presets/crt/arcade.json", "crt", "Arcade cabinet");
        outside = add("secret/arcade.json", "crt", "Secret");
    }
    fs::path add(const std::string& file, const std::string& look, const std::string& name) {
        return m_folder.write(file, R"({ "format": "afterglow-preset", "version": 1, "look": ")" +
                                        look + R"(", "name": ")" + name + "\" }");
    }
    Result<fs::path> find(const std::string& name) const {
        const Library library({m_folder.path(), m_folder / "user", m_folder / "state"}, {});
        return find_named_preset(library, "phosphor", name);
    }

    fs::path amber;
    fs::path mine;
    fs::path arcade;
    fs::path outside;

private:
    TemporaryFolder m_folder;
};
}  // namespace

TEST_CASE("a preset is found by file name or displayed name, in any case and with any separators") {
    const Presets presets;
    for (const char* name : {"amber-p3", "Amber P3", "amber_p3", "Warm amber", "WARM-AMBER"}) {
        CAPTURE(name);
        CHECK(presets.find(name) == presets.amber);
    }
    CHECK(presets.find("My glow") == presets.mine);
    CHECK(presets.find("my-glow") == presets.mine);
    CHECK(normalized_name(" Amber  P3 (mine)") == "amber-p3-mine");
    CHECK(normalized_name("Blå") == "blå");
    CHECK(normalized_name("--").empty());
}

TEST_CASE("a preset of another look is found by look and name") {
    const Presets presets;
    CHECK(presets.find("crt/arcade") == presets.arcade);
    CHECK(presets.find("crt/Arcade cabinet") == presets.arcade);
    CHECK(presets.find("phosphor/amber-p3") == presets.amber);
    CHECK_FALSE(presets.find("arcade"));
    CHECK(presets.find("default") == fs::path());
}

TEST_CASE("a name cannot lead out of the library, and an unknown one has a suggestion") {
    const Presets presets;
    for (const char* name : {"../../secret/arcade", "../secret/arcade", "/etc/passwd", "", "/",
                             "..", "crt/../../secret/arcade"}) {
        CAPTURE(name);
        CHECK_FALSE(presets.find(name));
    }
    CHECK_FALSE(presets.find("../secret/arcade"));
    CHECK(presets.find("ambre-p3").error().front().message ==
          "'phosphor' has no preset 'ambre-p3' (did you mean 'amber-p3'?)");
}

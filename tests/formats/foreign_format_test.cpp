#include "formats/foreign_format.h"

#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>

namespace {
/// The label of the format that a file with this text has; "none" if it has none.
std::string label_of(const TemporaryFolder& folder, const char* name, const char* text) {
    const std::filesystem::path file = folder.path() / name;
    std::ofstream(file) << text;
    const ForeignFormat* format = find_foreign_format(file);
    return format ? std::string(format->label) : "none";
}
}  // namespace

TEST_CASE("the format of a file is recognised by its extension and content") {
    const TemporaryFolder folder;
    CHECK(label_of(folder, "a.slangp", "shaders = 0\n") == "RetroArch .slangp and .slang");
    CHECK(label_of(folder, "a.fs", "/*{ \"ISFVSN\": \"2\" }*/\nvoid main() {}\n") == "ISF");
    CHECK(label_of(folder, "a.frag",
                   "void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }\n") == "Shadertoy");
    CHECK(label_of(folder, "b.frag", "void main() { gl_FragColor = vec4(1.0); }\n") ==
          "plain fragment shaders");
    CHECK(label_of(folder, "look.json", "{ \"name\": \"Look\", \"passes\": [] }\n") == "none");
    CHECK(label_of(folder, "a.png", "") == "none");
}

TEST_CASE("a file with the extension of ISF that is no shader opens with an error") {
    const TemporaryFolder folder;
    CHECK(label_of(folder, "a.fs", "no shader\n") != "none");
    const ForeignFormat* format = find_foreign_format(folder.path() / "a.fs");
    REQUIRE(format);
    CHECK_FALSE(format->load(folder.path() / "a.fs", {}, {}).look.has_value());
}

TEST_CASE("extensions are listed once, and labels in the order of the rows") {
    const std::vector<std::string> all = foreign_extensions();
    for (const char* extension : {".slangp", ".slang", ".fs", ".json", ".glsl", ".frag", ".txt"}) {
        CAPTURE(extension);
        CHECK(std::ranges::count(all, extension) == 1);
    }
    CHECK(foreign_labels() ==
          "RetroArch .slangp and .slang, ISF, Shadertoy, plain fragment shaders");
}

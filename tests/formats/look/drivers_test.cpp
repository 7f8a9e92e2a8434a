// Looks that a signal or a source picture can drive.
#include "formats/look/look_manifest.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>

namespace fs = std::filesystem;

namespace {
class TubeOnDisk {
public:
    TubeOnDisk() {
        for (const char* name : {"beam.vert", "beam.frag", "sum.frag", "wide.frag"})
            m_folder.write(fs::path("tube") / name, "text");
    }

    Result<Look> load(std::string_view text, bool is_picture_driven = false) {
        std::vector<fs::path> files;
        return load_manifest(m_folder.write("tube/look.json", text), files, nullptr,
                             is_picture_driven);
    }

    // All diagnostics, with the manifest's path shortened to "look.json".
    std::string errors_of(std::string_view text) {
        const auto look = load(text);
        REQUIRE_FALSE(look.has_value());
        std::string all;
        for (Diagnostic reason : look.error()) {
            reason.file = reason.file.filename();
            all += to_string(reason) + '\n';
        }
        return all;
    }

private:
    TemporaryFolder m_folder;
};

// A look with its head on line 1 and `passes` from line 2.
std::string tube_with(std::string_view head, std::string_view passes) {
    return "{ \"format\": \"afterglow-look\", \"version\": 1, " + std::string(head) +
           "\"passes\": [\n" + std::string(passes) + "\n] }";
}

const std::string only_picture_head =
    "\"driven_by\": \"picture\", \"default_source\": \"pattern:smpte\", ";
const std::string either_head =
    "\"driven_by\": \"signal-or-picture\", \"default_signal\": { \"kind\": \"lissajous\" }, "
    "\"default_source\": \"pattern:smpte\", ";

const std::string either_passes = R"(
    {"name": "beam", "driven_by": "signal", "draw": "points", "vertex": "beam.vert", "fragment": "beam.frag"},
    {"name": "wide", "driven_by": "picture", "fragment": "wide.frag", "inputs": {"image": "source"}},
    {"name": "sum", "fragment": "sum.frag", "inputs": {
        "current": {"from": "beam", "driven_by": "signal"},
        "picture": {"from": "wide", "driven_by": "picture"}, "previous": "sum@1"}})";

std::vector<std::string> inputs_of(const Pass& pass) {
    std::vector<std::string> references;
    for (const Input& input : pass.inputs)
        references.push_back(input.uniform + '=' + input.reference());
    return references;
}
}  // namespace

TEST_CASE("a look that a signal or a picture can drive has the passes and inputs of one driver") {
    TubeOnDisk disk;
    const auto beam = disk.load(tube_with(either_head, either_passes));
    REQUIRE(beam.has_value());
    CHECK(beam->has_other_driver);
    CHECK(beam->driven_by == Driver::signal);
    CHECK(pass_names(*beam) == std::vector<std::string>{"beam", "sum"});
    CHECK(inputs_of(beam->passes[1]) == std::vector<std::string>{"current=beam", "previous=sum@1"});
    const auto picture = disk.load(tube_with(either_head, either_passes), true);
    REQUIRE(picture.has_value());
    CHECK(picture->driven_by == Driver::picture);
    CHECK(pass_names(*picture) == std::vector<std::string>{"wide", "sum"});
    CHECK(inputs_of(picture->passes[1]) ==
          std::vector<std::string>{"picture=wide", "previous=sum@1"});
    CHECK(picture->default_signal == beam->default_signal);
    CHECK(picture->default_source == "pattern:smpte");
    CHECK(beam->default_source == "pattern:smpte");
}

TEST_CASE("a look with one driver is read for it, whatever is requested") {
    TubeOnDisk disk;
    const auto beam = disk.load(
        tube_with("\"driven_by\": \"signal\", ", R"({"name": "a", "fragment": "sum.frag"})"), true);
    REQUIRE(beam.has_value());
    CHECK_FALSE(beam->has_other_driver);
    CHECK(beam->driven_by == Driver::signal);
}

TEST_CASE("mistakes with two drivers are reported at their lines") {
    TubeOnDisk disk;
    const auto without_source = R"("driven_by": "signal-or-picture", )";
    CHECK(disk.errors_of(tube_with(without_source, R"({"name": "a", "fragment": "wide.frag"})")) ==
          "look.json:1: error: 'driven_by': 'signal-or-picture' needs a 'default_source' such as "
          "'pattern:smpte'\n");
    CHECK(disk.errors_of(
              tube_with(only_picture_head,
                        R"({"name": "a", "driven_by": "picture", "fragment": "wide.frag"})")) ==
          "look.json:2: error: 'driven_by' needs a look with 'driven_by': 'signal-or-picture'\n");
    CHECK(disk.errors_of(tube_with(
              either_head, R"({"name": "a", "driven_by": "picture", "fragment": "wide.frag"})")) ==
          "look.json:1: error: no pass is left with 'driven_by': 'signal'\n");
    CHECK(disk.errors_of(tube_with(either_head,
                                   "{\"name\": \"a\", \"driven_by\": \"picture\", "
                                   "\"fragment\": \"wide.frag\"},\n"
                                   "{\"name\": \"a\", \"fragment\": \"wide.frag\"}")) ==
          "look.json:3: error: the name 'a' is already used by the pass on line 2\n");
}

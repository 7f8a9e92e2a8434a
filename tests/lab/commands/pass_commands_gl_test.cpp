// Adding, removing and moving passes in the files of the open look.
#include "base/file.h"
#include "base/text.h"
#include "lab/document/opened_preset.h"
#include "lab/small_lab.h"

#include <cstdlib>

namespace fs = std::filesystem;

namespace {
class PassLab : public SmallLab {
public:
    PassLab() { setenv("XDG_DATA_HOME", (folder() / "data").c_str(), 1); }

    fs::path file(const char* name) { return folder() / "shaders/small" / name; }
    std::string text(const char* name) { return read_bytes(file(name)).value_or("missing"); }
    PassCommands& passes() { return lab().looks().passes(); }
    std::vector<std::string> names() {
        std::vector<std::string> all;
        for (const Pass& pass : document().look().passes)
            all.push_back(pass.name);
        return all;
    }
    bool has_passes(const std::vector<std::string>& wanted) {
        return update_until([&] { return names() == wanted && !lab().loader().is_loading(); });
    }
    void undo() {
        lab().edit([](Document& document) { document.undo(); });
    }
    void redo() {
        lab().edit([](Document& document) { document.redo(); });
    }
    std::string notice() {
        return lab().messages().notice() ? lab().messages().notice()->text : std::string();
    }
};
}  // namespace

TEST_CASE("an added pass leaves the picture unchanged, and undo and redo restore both files") {
    PassLab small;
    const std::string manifest = small.text("look.json");
    small.passes().add("show", "tint");
    REQUIRE_MESSAGE(small.has_passes({"sum", "show", "tint"}), small.notice());
    CHECK(small.lab().messages().problems().empty());
    const std::string with_pass = small.text("look.json");
    const std::string shader = small.text("tint.frag");
    CHECK(shader.find("tint_gain") != std::string::npos);
    CHECK(small.document().history().undo_name() == "Add pass tint");

    small.undo();
    REQUIRE(small.has_passes({"sum", "show"}));
    CHECK(small.text("look.json") == manifest);
    CHECK_FALSE(fs::exists(small.file("tint.frag")));
    small.redo();
    REQUIRE(small.has_passes({"sum", "show", "tint"}));
    CHECK(small.text("look.json") == with_pass);
    CHECK(small.text("tint.frag") == shader);
}

TEST_CASE("undo does not replace a shader that was edited after its pass was added") {
    PassLab small;
    small.passes().add("show", "tint");
    REQUIRE(small.has_passes({"sum", "show", "tint"}));
    const std::string edited = small.text("tint.frag") + "// mine\n";
    small.write("tint.frag", edited);
    const std::string manifest = small.text("look.json");
    small.undo();
    small.update(3);
    CHECK(small.text("tint.frag") == edited);
    CHECK(small.text("look.json") == manifest);
    CHECK(small.notice() ==
          "Can't undo or redo \"Add pass tint\": tint.frag was changed "
          "by another program and was not replaced");
}

TEST_CASE("a removed pass takes its shader with it, and undo brings both back") {
    PassLab small;
    const std::string manifest = small.text("look.json");
    const std::string shader = small.text("show.frag");
    small.lab().edit([](Document& document) { document.set_value("gain", Value(3.0)); });
    small.passes().remove("show");
    REQUIRE_MESSAGE(small.has_passes({"sum"}), small.notice());
    CHECK_FALSE(fs::exists(small.file("show.frag")));
    CHECK(fs::exists(small.file("gain.glsl")));
    small.undo();
    REQUIRE(small.has_passes({"sum", "show"}));
    CHECK(small.text("look.json") == manifest);
    CHECK(small.text("show.frag") == shader);
    CHECK(small.document().values() == Values{{"gain", Value(3.0)}});
}

TEST_CASE("edits of files and of values are undone in order, and a new edit ends the redo") {
    PassLab small;
    const std::string manifest = small.text("look.json");
    const auto turn = [&](double gain) {
        small.lab().edit([gain](Document& document) { document.set_value("gain", Value(gain)); });
    };
    turn(2.0);
    small.passes().add("show", "one");
    REQUIRE(small.has_passes({"sum", "show", "one"}));
    turn(4.0);
    small.passes().add("one", "two");
    REQUIRE(small.has_passes({"sum", "show", "one", "two"}));
    small.undo();
    small.undo();
    small.undo();
    REQUIRE(small.has_passes({"sum", "show"}));
    CHECK(small.text("look.json") == manifest);
    CHECK(small.document().values() == Values{{"gain", Value(2.0)}});
    small.passes().add("sum", "three");
    REQUIRE(small.has_passes({"sum", "three", "show"}));
    CHECK_FALSE(small.document().history().can_redo());
    small.undo();
    REQUIRE(small.has_passes({"sum", "show"}));
    CHECK(small.text("look.json") == manifest);
}

TEST_CASE("a preset that opens after an added pass keeps the pass") {
    PassLab small;
    small.passes().add("show", "tint");
    REQUIRE(small.has_passes({"sum", "show", "tint"}));
    CHECK_FALSE(is_modified(small.document()));
    Preset preset;
    preset.look = "small";
    preset.name = "Bright";
    small.lab().edit([&](Document& document) { open_preset(document, preset, "bright.json"); });
    small.update(3);
    CHECK(fs::exists(small.file("tint.frag")));
    CHECK(small.text("look.json").find("tint") != std::string::npos);
}

TEST_CASE("passes of a shipped look are not changed, and a copy is offered") {
    PassLab small;
    const std::string manifest = small.text("look.json");
    small.start(machine_midi_inputs(), {{"shaders/small/look.json", digest_of(manifest)}});
    small.lab().looks().open("small");
    small.wait_for_frames();
    small.passes().remove("show");
    CHECK(small.text("look.json") == manifest);
    REQUIRE(small.lab().messages().notice());
    REQUIRE(small.lab().messages().notice()->buttons.size() == 1);
    CHECK(small.lab().messages().notice()->buttons[0].name == "Duplicate look");
}

TEST_CASE("a broken look.json and a bad name are reported, and nothing is written") {
    PassLab small;
    small.passes().add("show", "a b");
    CHECK(small.notice().starts_with("Use 1 to 64 letters"));
    small.passes().add("show", "show");
    CHECK(small.notice() == "\"show\" is already used.");
    small.write("look.json", "{");
    small.passes().move("show", PassMove::earlier);
    CHECK(small.text("look.json") == "{");
    CHECK(small.notice().find("look.json:1: ") != std::string::npos);
    CHECK_FALSE(small.document().history().can_undo());
}

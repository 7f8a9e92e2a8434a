// Presets as files: their owners and the commands for them.
#include "base/file.h"
#include "base/text.h"
#include "formats/preset/preset_format.h"
#include "lab/document/opened_preset.h"
#include "lab/document/stack_edits.h"
#include "lab/small_lab.h"

#include <cstdlib>
#include <unistd.h>

namespace fs = std::filesystem;

namespace {
// A lab with a shipped preset "Amber" and the user's preset "Old" in the program folder.
class PresetLab : public SmallLab {
public:
    PresetLab() {
        setenv("XDG_DATA_HOME", (folder() / "data").c_str(), 1);
        fs::create_directories(shipped_file().parent_path());
        REQUIRE(write_atomically(shipped_file(), text("Amber")).has_value());
        REQUIRE(write_atomically(old_file(), text("Old")).has_value());
        start(machine_midi_inputs(), {{"presets/small/amber.json", digest_of(text("Amber"))}});
        open_and_wait(shipped_file().string());
    }
    fs::path shipped_file() { return folder() / "presets/small/amber.json"; }
    fs::path old_file() { return folder() / "presets/small/old.json"; }
    fs::path users_file(const std::string& name) {
        return roots().user / "presets/small" / (name + ".json");
    }
    PresetCommands& presets() { return lab().presets(); }
    void open_and_wait(const std::string& argument) {
        lab().looks().open(argument);
        REQUIRE(update_until([&] { return !lab().loader().is_loading() && lab().document(); }));
        update(2);
    }
    void turn_gain(double gain) {
        lab().edit([gain](Document& document) { document.set_value("gain", Value(gain)); });
    }
    static std::string text(const std::string& name) {
        return R"({ "format": "afterglow-preset", "version": 1, "look": "small", "name": ")" +
               name + "\",\n  \"values\": { \"gain\": 2.0 } }\n";
    }
};
}  // namespace

TEST_CASE("a shipped preset is not overwritten, and a new name is proposed") {
    PresetLab small;
    small.turn_gain(3.0);
    CHECK_FALSE(small.presets().can_save_over());
    CHECK(small.presets().proposed_name() == "Amber (mine)");
    small.presets().save();
    CHECK(read_text(small.shipped_file()) == PresetLab::text("Amber"));
    CHECK(is_modified(small.document()));

    small.presets().save_as("Amber (mine)");
    CHECK(preset_file(small.document()) == small.users_file("Amber (mine)"));
    CHECK(load_preset(small.users_file("Amber (mine)"))->values == Values{{"gain", Value(3.0)}});
    CHECK(small.presets().can_save_over());
    small.open_and_wait(small.shipped_file().string());
    CHECK(small.presets().proposed_name() == "Amber (mine 2)");
}

TEST_CASE("a shipped preset is neither renamed nor deleted") {
    PresetLab small;
    small.presets().rename(small.shipped_file(), "Other");
    CHECK(small.lab().messages().notice()->is_problem);
    small.presets().remove(small.shipped_file());
    CHECK(small.lab().messages().notice()->is_problem);
    CHECK(read_text(small.shipped_file()) == PresetLab::text("Amber"));
}

TEST_CASE("saving a user's preset in the program folder keeps the rest of its text") {
    PresetLab small;
    small.open_and_wait(small.old_file().string());
    CHECK(small.presets().can_save_over());
    small.turn_gain(4.0);
    small.presets().save();
    std::string expected = PresetLab::text("Old");
    expected.replace(expected.find("2.0"), 3, "4");
    expected.replace(expected.find(" \"name\""), 0,
                     "\n  \"look_digest\": \"" + look_digest(small.document().look()) + "\",");
    CHECK(read_text(small.old_file()).value() == expected);
}

TEST_CASE("a preset from a picture or a line of text can only be saved with a new name") {
    PresetLab small;
    const std::string line = small.lab().presets().sharing().line();
    const fs::path file = small.folder() / "line.txt";
    REQUIRE(write_atomically(file, line).has_value());
    small.open_and_wait(line);
    CHECK_FALSE(small.presets().can_save_over());
}

TEST_CASE("a deleted preset goes to the trash, and undo restores and opens it") {
    PresetLab small;
    small.presets().save_as("Mine");
    const fs::path file = small.users_file("Mine");
    const std::string text = read_text(file).value();
    small.presets().navigation().star("Mine", true);
    small.presets().remove(file);
    CHECK_FALSE(fs::exists(file));
    CHECK(fs::exists(small.folder() / "data/Trash/files/Mine.json"));
    CHECK(preset_file(small.document()).empty());
    CHECK(small.presets().navigation().stars().empty());
    CHECK(small.presets().undo_name() == "Delete \"Mine\"");
    REQUIRE(small.lab().messages().notice()->buttons.size() == 1);
    CHECK(small.lab().messages().notice()->buttons.front().name == "Undo");

    small.lab().presets().undo();
    CHECK(read_text(file) == text);
    CHECK(preset_file(small.document()) == file);
    CHECK_FALSE(is_modified(small.document()));
    CHECK(small.presets().navigation().stars() == FavouritePresets{"small/Mine"});
    CHECK(small.presets().undo_name().empty());
}

TEST_CASE("a preset that is deleted while it opens does not open") {
    PresetLab small;
    small.presets().save_as("Mine");
    const fs::path file = small.users_file("Mine");
    small.open_and_wait(small.shipped_file().string());
    small.lab().looks().open(file.string());
    REQUIRE(small.lab().loader().is_opening_preset(file));
    small.presets().remove(file);
    CHECK_FALSE(small.lab().loader().is_opening_preset(file));
    CHECK(small.lab().messages().notice()->text == "Deleted \"Mine\"");
    CHECK(preset_file(small.document()) == small.shipped_file());
    small.lab().presets().undo();
    CHECK(fs::exists(file));
}

TEST_CASE("newer steps are undone before a deletion") {
    PresetLab small;
    small.presets().save_as("Mine");
    small.presets().remove(small.users_file("Mine"));
    small.turn_gain(5.0);
    CHECK(small.presets().undo_name().empty());
    small.lab().presets().undo();
    CHECK(small.document().values() == Values{{"gain", Value(2.0)}});
    CHECK_FALSE(fs::exists(small.users_file("Mine")));
    small.lab().presets().undo();
    CHECK(fs::exists(small.users_file("Mine")));
}

TEST_CASE("a preset is renamed, duplicated and deleted without being opened") {
    PresetLab small;
    small.presets().save_as("Mine");
    small.open_and_wait(small.shipped_file().string());
    small.presets().rename(small.users_file("Mine"), "Ours");
    CHECK(load_preset(small.users_file("Ours"))->name == "Ours");
    small.presets().duplicate(small.users_file("Ours"));
    CHECK(fs::exists(small.users_file("Ours 2")));
    small.presets().remove(small.users_file("Ours"));
    CHECK(preset_file(small.document()) == small.shipped_file());
    CHECK_FALSE(fs::exists(small.users_file("Ours")));
}

TEST_CASE("a move is offered for the user's presets in the program folder") {
    PresetLab small;
    small.open_and_wait(small.old_file().string());
    small.presets().offer_move();
    REQUIRE(small.lab().messages().notice().has_value());
    CHECK(small.lab().messages().notice()->text == "1 of your presets is in the program folder");
    small.presets().move_to_user_folder();
    CHECK_FALSE(fs::exists(small.old_file()));
    CHECK(read_text(small.users_file("old")) == PresetLab::text("Old"));
    CHECK(preset_file(small.document()) == small.users_file("old"));
    CHECK(fs::exists(small.shipped_file()));
}

TEST_CASE("a shipped look is not modified, and a copy of it is offered") {
    SmallLab small;
    const std::string manifest = read_text(small.look_folder() / "look.json").value();
    small.start(machine_midi_inputs(), {{"shaders/small/look.json", digest_of(manifest)}});
    small.lab().looks().open("small");
    small.wait_for_frames();
    PassOverride half;
    half.scale = 0.5;
    small.lab().edit([&half](Document& document) { set_override(document, "sum", half); });
    small.lab().looks().write_overrides();
    CHECK(read_text(small.look_folder() / "look.json") == manifest);
    REQUIRE(small.lab().messages().notice()->buttons.size() == 1);
    CHECK(small.lab().messages().notice()->buttons.front().name == "Duplicate look");
    CHECK_FALSE(small.document().state().overrides.empty());
}

TEST_CASE("F4 on a read-only shipped look offers a copy") {
    SmallLab small;
    const fs::path file = small.look_folder() / "show.frag";
    const std::string text = read_text(file).value();
    small.start(machine_midi_inputs(), {{"shaders/small/show.frag", digest_of(text)}});
    small.lab().looks().open("small");
    small.wait_for_frames();
    fs::permissions(small.folder(), fs::perms::group_all | fs::perms::others_all,
                    fs::perm_options::add);
    fs::permissions(file, fs::perms::owner_read | fs::perms::group_read | fs::perms::others_read);
    const bool is_root = geteuid() == 0;
    constexpr uid_t nobody = 65534;
    if (is_root)  // permissions do not apply to root
        REQUIRE(seteuid(nobody) == 0);
    small.lab().looks().open_in_editor({file, 1});
    if (is_root)
        REQUIRE(seteuid(0) == 0);
    REQUIRE(small.lab().messages().notice().has_value());
    INFO(small.lab().messages().notice()->text);
    REQUIRE(small.lab().messages().notice()->buttons.size() == 1);
    CHECK(small.lab().messages().notice()->buttons.front().name == "Duplicate look");
}

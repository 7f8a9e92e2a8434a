#include "lab/window/file_dialog_kind.h"

#include "io/system/environment.h"
#include "io/temporary_folder.h"
#include "lab/document/document.h"

#include <doctest/doctest.h>

#include <set>
#include <string>

namespace fs = std::filesystem;

namespace {
using Kind = Dialog::Kind;

Document document_of(const fs::path& manifest) {
    Look look;
    look.id = "glow";
    look.name = "CRT/Glow";
    look.manifest = manifest;
    return Document(look);
}
}  // namespace

TEST_CASE("each dialog for files has rules, and a saved file has an extension") {
    std::set<std::string> titles;
    for (int i = 0; i <= static_cast<int>(Kind::quit_exporting); ++i) {
        const FileDialogKind* kind = file_dialog_kind(static_cast<Kind>(i));
        if (!kind)
            continue;
        CAPTURE(kind->title);
        CHECK(titles.insert(kind->title).second);
        CHECK(rules_of(*kind).is_saving == kind->is_saving);
        if (kind->is_saving)
            CHECK(check_file_name("a", rules_of(*kind).names()).is_valid);
    }
    CHECK(titles.size() == 13);
    CHECK(file_dialog_kind(Kind::none) == nullptr);
    CHECK(file_dialog_kind(Kind::keys) == nullptr);
}

TEST_CASE("a dialog starts in the last folder of its kind") {
    const TemporaryFolder home;
    set_environment("HOME", home.path().c_str());
    unset_environment("XDG_CONFIG_HOME");
    fs::create_directories(home / "Pictures");
    fs::create_directories(home / "films");
    FileDialogChoices choices;
    CHECK(first_browser({.kind = Kind::save_pass}, choices, nullptr).folder == home / "Pictures");
    CHECK(last_folder(choices, "video", UserFolder::videos) == home.path());
    choices.folders = {{"video", home / "films"}, {"picture", home / "gone"}};
    CHECK(last_folder(choices, "video", UserFolder::videos) == home / "films");
    CHECK(first_browser({.kind = Kind::save_pass}, choices, nullptr).folder == home / "Pictures");
    CHECK(first_browser({.kind = Kind::open_file}, choices, nullptr).folder == fs::current_path());
}

TEST_CASE("a .slangp is saved next to the open one, under a free and valid name") {
    const TemporaryFolder folder;
    const Document document = document_of(folder.write("shaders/glow.slangp", ""));
    FileDialogChoices choices;
    choices.folders["slangp"] = folder.path();
    const FileBrowser first = first_browser({.kind = Kind::save_slangp}, choices, &document);
    CHECK(first.folder == folder / "shaders");
    CHECK(first.text == "CRT-Glow-mine.slangp");
    folder.write("shaders/CRT-Glow-mine.slangp", "");
    CHECK(first_browser({.kind = Kind::save_slangp}, choices, &document).text ==
          "CRT-Glow-mine-2.slangp");
}

TEST_CASE("a drawing is saved next to its file, a pass under its name") {
    const TemporaryFolder folder;
    Document document = document_of(folder / "look.json");
    DocumentState state = document.state();
    state.signal = Spec{"drawing", {{"file", (folder.write("svg/a.svg", "")).string()}}};
    document.change(state, "Load drawing");
    const FileBrowser drawing = first_browser({.kind = Kind::save_drawing}, {}, &document);
    CHECK(drawing.folder == folder / "svg");
    CHECK(drawing.text == "drawing.svg");
    CHECK(first_browser({.kind = Kind::save_pass, .subject = "crt/mask"}, {}, &document).text ==
          "crt-mask.exr");
}

TEST_CASE("only the program's own file dialog reads folders") {
    Dialog dialog{.kind = Kind::open_file, .browser = {.folder = "/tmp", .text = "/usr/li"}};
    CHECK_FALSE(folder_request(dialog, {}).has_value());  // whose dialog opens is not decided yet
    dialog.host = Dialog::Host::own;
    dialog.is_new = false;
    const auto request = folder_request(dialog, {.shows_hidden = true});
    REQUIRE(request.has_value());
    CHECK(request->folder == "/usr");
    CHECK(request->filter == FileFilter{.typed = "li", .shows_hidden = true});
    dialog.host = Dialog::Host::desktop;
    CHECK_FALSE(folder_request(dialog, {}).has_value());
    CHECK_FALSE(folder_request({.kind = Kind::keys, .host = Dialog::Host::own, .is_new = false}, {})
                    .has_value());
}

#include "lab/window/desktop_request.h"

#include "io/temporary_folder.h"

#include <doctest/doctest.h>

namespace {
using Kind = Dialog::Kind;

FileReply chosen(const std::filesystem::path& file) {
    return {.kind = FileReply::Kind::chosen, .files = {file}};
}
}  // namespace

TEST_CASE("the desktop is asked with the folder, the name and the files of the dialog") {
    const TemporaryFolder folder;
    FileDialogChoices choices;
    choices.folders["picture"] = folder.path();
    const FileRequest save =
        desktop_request({.kind = Kind::save_pass, .subject = "mask"}, choices, nullptr);
    CHECK(save.kind == FileRequest::Kind::save);
    CHECK(save.title == "Save pass (EXR: exact values, PNG: as shown)");
    CHECK(save.folder == folder.path());
    CHECK(save.name == "mask.exr");
    CHECK(save.groups == std::vector<FileGroup>{{"Passes", {".exr", ".png"}}});
    const FileRequest open = desktop_request({.kind = Kind::load_drawing}, choices, nullptr);
    CHECK(open.kind == FileRequest::Kind::open);
    CHECK(open.name.empty());
    CHECK(open.groups ==
          std::vector<FileGroup>{{"Drawings", {".svg", ".svgz"}}, {"All files", {}}});
}

TEST_CASE("a chosen file is the answer, and a cancelled dialog closes") {
    Dialog dialog{.kind = Kind::open_file, .host = Dialog::Host::desktop};
    CHECK(take_reply(dialog, chosen("/music/a.wav")).empty());
    CHECK(dialog.answer == "/music/a.wav");
    CHECK(take_reply(dialog, {.kind = FileReply::Kind::cancelled}).empty());
    CHECK(dialog == Dialog{});
}

TEST_CASE("the program's own dialog takes over when the desktop's fails") {
    Dialog dialog{.kind = Kind::save_drawing, .host = Dialog::Host::desktop, .is_new = false};
    CHECK(take_reply(dialog, {.kind = FileReply::Kind::failed, .problem = "it has ended"}) ==
          "The desktop's file dialog failed: it has ended. Using Afterglow's.");
    CHECK(dialog.kind == Kind::save_drawing);
    CHECK(dialog.host == Dialog::Host::own);
    CHECK(dialog.is_new);
    CHECK_FALSE(dialog.answer.has_value());
}

TEST_CASE("a name that the desktop accepted is still checked") {
    const TemporaryFolder folder;
    folder.write("taken.svg", "");
    folder.write("asked.svg", "");
    struct Case {
        std::string name;
        std::string answer;  // "": the own dialog opens
        std::string replaced;
    };
    for (const auto& [name, answer, replaced] :
         {Case{"new", "new.svg", ""}, Case{"asked.svg", "asked.svg", ""},  // the desktop has asked
          Case{"taken", "", "taken.svg"}, Case{"new.jpg", "", ""}}) {
        CAPTURE(name);
        Dialog dialog{.kind = Kind::save_drawing, .host = Dialog::Host::desktop};
        CHECK(take_reply(dialog, chosen(folder / name)).empty());
        CHECK(dialog.answer.has_value() == !answer.empty());
        if (dialog.answer)
            CHECK(*dialog.answer == folder / answer);
        CHECK(dialog.browser.replaced.filename() == (dialog.answer ? name : replaced));
        CHECK(dialog.browser.text == name);
    }
}

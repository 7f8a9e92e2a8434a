#include "lab/files/file_browser.h"

#include "io/temporary_folder.h"

#include <doctest/doctest.h>

namespace fs = std::filesystem;

namespace {
using Kind = FileChoice::Kind;

/// A folder with some files, and a dialog in it.
struct Files {
    Files() {
        folder.write("osci.wav", "");
        folder.write("other.wav", "");
        folder.write("films/one.mp4", "");
        folder.write("look/look.json", "{}");
        browser.folder = folder.path();
    }

    std::vector<FolderEntry> rows() const {
        return file_rows(list_folder(shown_path(browser).folder, rules.extensions),
                         filter_of(browser, rules, {}, false));
    }
    FileChoice enter() const { return accepted(browser, rules, rows()); }
    FileChoice enter(const std::string& text) {
        type_text(browser, text);
        return enter();
    }
    std::string highlighted_name() const { return highlighted(browser, rules, rows()); }

    TemporaryFolder folder;
    FileRules rules;
    FileBrowser browser;
};

}  // namespace

TEST_CASE("Enter takes a typed name, a path, or the first match") {
    Files files;
    files.rules.opens_looks = true;
    const fs::path folder = files.folder.path();
    struct Case {
        std::string typed;
        FileChoice choice;
    };
    for (const auto& [typed, choice] :
         {Case{"osci.wav", {Kind::choose, folder / "osci.wav"}},
          Case{"osci", {Kind::choose, folder / "osci.wav"}}, Case{"ONE", {Kind::fail, {}, {}}},
          Case{"films", {Kind::enter_folder, folder / "films"}},
          Case{"fil", {Kind::enter_folder, folder / "films"}},
          Case{"films/", {Kind::enter_folder, folder / "films"}},
          Case{"films/one.mp4", {Kind::choose, folder / "films/one.mp4"}},
          Case{"films/on", {Kind::choose, folder / "films/one.mp4"}},
          Case{(folder / "other.wav").string(), {Kind::choose, folder / "other.wav"}},
          Case{"look", {Kind::choose, folder / "look"}},  // a look is opened, not entered
          Case{"", {}}}) {
        CAPTURE(typed);
        FileChoice found = files.enter(typed);
        CHECK(found.kind == choice.kind);
        CHECK(found.path == choice.path);
        CHECK(found.problem.empty() == (choice.kind != Kind::fail));
    }
    files.rules.opens_looks = false;
    CHECK(files.enter("look").kind == Kind::enter_folder);
}

TEST_CASE("a miss is explained and keeps the text") {
    Files files;
    const FileChoice choice = files.enter("nothing");
    CHECK(choice.problem == "\"nothing\" was not found in " + files.folder.path().string() + ".");
    apply_choice(files.browser, files.rules, choice);
    CHECK(files.browser.text == "nothing");
    CHECK(files.browser.problem == choice.problem);
    type_text(files.browser, "nothin");
    CHECK(files.browser.problem.empty());
    CHECK(files.enter("gone/x").problem ==
          "The folder " + (files.folder / "gone").string() + " was not found.");
}

TEST_CASE("typing highlights the first match, arrow keys move on") {
    Files files;
    CHECK(files.highlighted_name().empty());
    type_text(files.browser, "o");
    CHECK(files.highlighted_name() == "osci.wav");
    move_selection(files.browser, files.rules, files.rows(), 1);
    CHECK(files.highlighted_name() == "other.wav");
    CHECK(files.browser.text == "o");
    CHECK(files.enter() == FileChoice{Kind::choose, files.folder / "other.wav"});
    move_selection(files.browser, files.rules, files.rows(), 100);  // "look" also contains an o
    CHECK(files.highlighted_name() == files.rows().back().name);
    type_text(files.browser, "");
    move_selection(files.browser, files.rules, files.rows(), -1);
    CHECK(files.highlighted_name() == "other.wav");  // the last one
    move_selection(files.browser, files.rules, files.rows(), -100);
    CHECK(files.highlighted_name() == "films");
}

TEST_CASE("one click selects a file or a folder, a double click opens it") {
    Files files;
    const FolderEntry folder{"films", true};
    select_row(files.browser, files.rules, folder);
    CHECK(files.browser.folder == files.folder.path());
    CHECK(files.highlighted_name() == "films");
    CHECK(accepted_row(files.browser, files.rules, folder) ==
          FileChoice{Kind::enter_folder, files.folder / "films"});
    apply_choice(files.browser, files.rules, files.enter());
    CHECK(files.browser.folder == files.folder / "films");
    CHECK(files.browser.text.empty());
    CHECK(accepted_row(files.browser, files.rules, {"one.mp4"}) ==
          FileChoice{Kind::choose, files.folder / "films/one.mp4"});
    CHECK(accepted_row(files.browser, files.rules, {"deleted"}).kind == Kind::fail);
}

TEST_CASE("saving asks before it replaces a file") {
    Files files;
    files.rules = {.is_saving = true, .extensions = {".wav"}, .content = "Sounds"};
    CHECK(files.enter("new") == FileChoice{Kind::choose, files.folder / "new.wav"});
    const FileChoice asked = files.enter("osci");  // the extension is added
    CHECK(asked == FileChoice{Kind::ask_to_replace, files.folder / "osci.wav",
                              "\"osci.wav\" already exists. Replace it?"});
    apply_choice(files.browser, files.rules, asked);
    CHECK(files.enter() == FileChoice{Kind::choose, files.folder / "osci.wav"});
    type_text(files.browser, "other.wav");  // another file is another question
    CHECK(files.enter().kind == Kind::ask_to_replace);
}

TEST_CASE("a name to save is checked while it is typed") {
    Files files;
    files.rules = {.is_saving = true, .extensions = {".png", ".exr"}, .content = "Pictures"};
    type_text(files.browser, "films/x.jpg");
    const NameCheck check = check_typed_name(files.browser, files.rules);
    CHECK_FALSE(check.is_valid);
    CHECK(check.suggestion == "films/x.png");
    CHECK(files.enter().kind == Kind::fail);
    type_text(files.browser, check.suggestion);
    CHECK(files.enter() == FileChoice{Kind::choose, files.folder / "films/x.png"});
    type_text(files.browser, "");
    CHECK_FALSE(check_typed_name(files.browser, files.rules).is_valid);
}

TEST_CASE("the name to save stays while folders are entered") {
    Files files;
    files.rules = {.is_saving = true, .extensions = {".mp4"}, .content = "Videos"};
    type_text(files.browser, "mine.mp4");
    CHECK(files.rows().front().name == "films");  // not filtered
    select_row(files.browser, files.rules, {"films", true});
    apply_choice(files.browser, files.rules, files.enter());
    CHECK(files.browser.folder == files.folder / "films");
    CHECK(files.browser.text == "mine.mp4");
    select_row(files.browser, files.rules, {"one.mp4"});
    CHECK(files.browser.text == "one.mp4");
    enter_folder(files.browser, files.rules, files.folder.path());
    CHECK(files.browser.text == "one.mp4");
    apply_choice(files.browser, files.rules, files.enter("films"));
    CHECK(files.browser.folder == files.folder / "films");
    CHECK(files.browser.text.empty());
}

TEST_CASE("a typed path lists its folder at once") {
    Files files;
    type_text(files.browser, "films/");
    CHECK(shown_path(files.browser).folder == files.folder / "films");
    REQUIRE(files.rows().size() == 1);
    CHECK(files.rows()[0].name == "one.mp4");
    move_selection(files.browser, files.rules, files.rows(), 1);
    CHECK(files.enter() == FileChoice{Kind::choose, files.folder / "films/one.mp4"});
}

TEST_CASE("only an Enter that depends on the rows waits for them") {
    Files files;
    type_text(files.browser, "osci");
    CHECK(needs_rows(files.browser, files.rules));
    type_text(files.browser, "osci.wav");
    CHECK_FALSE(needs_rows(files.browser, files.rules));
    files.rules.is_saving = true;
    type_text(files.browser, "new");
    CHECK_FALSE(needs_rows(files.browser, files.rules));
}

#include "lab/editor/editor.h"

#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace {
using Words = std::vector<std::string>;

Words command_with(const char* visual, const char* editor, const Location& place) {
    visual ? setenv("VISUAL", visual, 1) : unsetenv("VISUAL");
    editor ? setenv("EDITOR", editor, 1) : unsetenv("EDITOR");
    const auto command = editor_command(place);
    REQUIRE(command.has_value());
    return *command;
}

const Location place{"/looks/a b.frag", 12};
}  // namespace

TEST_CASE("an editor is started at the line with its own syntax") {
    CHECK(command_with("gvim", nullptr, place) == Words{"gvim", "+12", "/looks/a b.frag"});
    CHECK(command_with("/usr/bin/code --wait", nullptr, place) ==
          Words{"/usr/bin/code", "--wait", "--goto", "/looks/a b.frag:12"});
    CHECK(command_with("subl", nullptr, place) == Words{"subl", "/looks/a b.frag:12"});
}

TEST_CASE("a terminal editor is started in a terminal") {
    CHECK(command_with("vim", nullptr, place) ==
          Words{"x-terminal-emulator", "-e", "vim", "+12", "/looks/a b.frag"});
    CHECK(command_with("hx", nullptr, place) ==
          Words{"x-terminal-emulator", "-e", "hx", "/looks/a b.frag:12"});
}

TEST_CASE("a pass inside a JSON file opens that file") {
    const TemporaryFolder folder;
    const auto file = folder.write("waves.json", "{}");
    CHECK(command_with("gvim", nullptr, {file / "Buffer A", 12}) ==
          Words{"gvim", "+1", file.string()});
}

TEST_CASE("$VISUAL precedes $EDITOR, and the default of the desktop is last") {
    CHECK(command_with("kate", "gvim", place).front() == "kate");
    CHECK(command_with(nullptr, "gvim", place).front() == "gvim");
    CHECK(command_with("  ", "gvim", place).front() == "gvim");
    CHECK(command_with(nullptr, nullptr, place) == Words{"xdg-open", "/looks/a b.frag"});
}

TEST_CASE("a file name never becomes an editor command or option") {
    const std::string here = std::filesystem::current_path().string();
    for (const char* name : {"+!touch X .glsl", "-c !touch X.glsl", "--cmd=x.glsl", ":q.glsl"}) {
        CHECK(command_with("vim", nullptr, {name, 3}).back() == here + "/" + name);
        CHECK(command_with("code", nullptr, {name, 3}).back() == here + "/" + name + ":3");
        CHECK(command_with(nullptr, nullptr, {name, 3}).back() == here + "/" + name);
    }
}

TEST_CASE("an editor command is quoted as in a shell") {
    CHECK(command_with("\"/opt/My Editor/ed\" -w", nullptr, place) ==
          Words{"/opt/My Editor/ed", "-w", "+12", "/looks/a b.frag"});
    CHECK(command_with("'/opt/My Editor/code' --wait", nullptr, place) ==
          Words{"/opt/My Editor/code", "--wait", "--goto", "/looks/a b.frag:12"});
    CHECK(command_with("/opt/My\\ Editor/ed", nullptr, place).front() == "/opt/My Editor/ed");
    const TemporaryFolder folder;
    const auto editor = folder.write("My Editor", "");
    CHECK(command_with(editor.c_str(), nullptr, place).front() == editor.string());
}

TEST_CASE("an editor command with an unclosed quote is reported") {
    for (const char* wrong : {"\"ed -w", "'ed", "ed \\", "\"\""}) {
        setenv("VISUAL", wrong, 1);
        const auto command = editor_command(place);
        REQUIRE_FALSE(command.has_value());
        CHECK(command.error().front().message.find("$VISUAL is not a valid command") == 0);
    }
}

TEST_CASE("without a file there is no command, and without a line it is line 1") {
    CHECK_FALSE(editor_command({{}, 3}).has_value());
    CHECK(command_with("gvim", nullptr, {"/looks/look.json", 0}) ==
          Words{"gvim", "+1", "/looks/look.json"});
}

TEST_CASE("a chosen command comes first, with {file} and {line} anywhere") {
    setenv("VISUAL", "gvim", 1);
    CHECK(editor_command(place, "ed --at={line} --open {file}").value() ==
          Words{"ed", "--at=12", "--open", "/looks/a b.frag"});
    CHECK(editor_command(place, "ed {file}:{line}").value() == Words{"ed", "/looks/a b.frag:12"});
    CHECK(editor_command(place, "kate -b").value() ==
          Words{"kate", "-b", "+12", "/looks/a b.frag"});  // as in $VISUAL
    CHECK(editor_command({"/looks/{line}.frag", 3}, "ed {file} {line}").value() ==
          Words{"ed", "/looks/{line}.frag", "3"});
}

TEST_CASE("installed editors are suggested, terminal editors only with a terminal") {
    const TemporaryFolder folder;
    const auto install = [&](const char* name) {
        const auto file = folder.write(name, "");
        std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    };
    const char* const path = getenv("PATH");
    const std::string before = path ? path : "";
    setenv("PATH", folder.path().c_str(), 1);
    CHECK(installed_editors().empty());
    install("vim");
    install("code");
    REQUIRE(installed_editors().size() == 1);
    CHECK(installed_editors()[0].name == "Visual Studio Code");
    install("x-terminal-emulator");
    CHECK(installed_editors().size() == 2);
    setenv("PATH", before.c_str(), 1);
}

TEST_CASE("the chosen command is stored") {
    const TemporaryFolder folder;
    Roots roots;
    roots.state = folder.path();
    CHECK(load_editor(roots).empty());
    REQUIRE(save_editor(roots, "ed {file}").has_value());
    CHECK(load_editor(roots) == "ed {file}");
}

#include "lab/editor/external_programs.h"

#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <thread>

namespace {
/// Programs that fail or succeed, started as the user's editor.
class Started {
public:
    Started() { m_roots.state = m_folder.path(); }
    // Opens a file with this command, and waits for a notice.
    void open(const std::string& command, int most_tries = 400) {
        ExternalPrograms programs(m_messages, m_roots);
        programs.choose_editor(command);
        m_messages.dismiss();
        programs.open_in_editor({m_folder / "tube.frag", 3});
        for (int i = 0; i < most_tries && !m_messages.notice(); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            programs.update();
        }
    }
    const std::optional<Notice>& notice() const { return m_messages.notice(); }

private:
    TemporaryFolder m_folder;
    Roots m_roots;
    Messages m_messages;
};
}  // namespace

TEST_CASE("an editor that ends with an error is reported, with other ways to open the file") {
    Started started;
    started.open("sh -c 'exit 3' {file}");
    REQUIRE(started.notice().has_value());
    CHECK(started.notice()->text ==
          "sh could not open tube.frag: exited with status 3. Choose an editor.");
    REQUIRE(started.notice()->buttons.size() == 3);
    CHECK(started.notice()->buttons[0].name == "Choose editor");
    CHECK(started.notice()->buttons[1].name == "Open folder");
    CHECK(started.notice()->buttons[2].name == "Copy path");
}

TEST_CASE("an editor that does not exist is reported") {
    Started started;
    started.open("/no/such/editor {file}");
    REQUIRE(started.notice().has_value());
    CHECK(started.notice()->text ==
          "/no/such/editor was not found, so tube.frag can't be opened. Choose an editor.");
}

TEST_CASE("a command with an unclosed quote is reported") {
    Started started;
    started.open("'ed {file}");
    REQUIRE(started.notice().has_value());
    CHECK(started.notice()->buttons[0].name == "Choose editor");
}

TEST_CASE("an editor that opens the file gives no notice") {
    Started started;
    started.open("true {file}", 40);
    CHECK_FALSE(started.notice().has_value());
}

#include "io/desktop/file_chooser.h"

#include "io/desktop/fake_portal.h"
#include "io/desktop/private_bus.h"

#include <doctest/doctest.h>

#include <chrono>
#include <thread>

namespace {
using Reaction = FakePortal::Reaction;
using Kind = Reaction::Kind;

template <class Condition>
bool becomes(Condition condition) {
    constexpr auto timeout = std::chrono::seconds(20);
    const auto start = std::chrono::steady_clock::now();
    while (!condition()) {
        if (std::chrono::steady_clock::now() - start > timeout)
            return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
}

/// A bus, a portal with one reaction, and a chooser that has found it.
struct Desktop {
    explicit Desktop(const Reaction& reaction)
        : portal(std::in_place, [this, reaction](const std::string& text) {
              const std::lock_guard lock(mutex);
              calls.push_back(text);
              return reaction;
          }) {
        REQUIRE(bus.is_running());
        REQUIRE(portal->is_running());
        chooser.emplace([this] { ++wakes; });
        REQUIRE(becomes([this] { return chooser->is_available(); }));
    }

    FileReply reply_to(const FileRequest& sent) {
        chooser->ask(sent);
        return reply();
    }
    FileReply reply() {
        std::optional<FileReply> reply;
        CHECK(becomes([&] { return (reply = chooser->take_reply()).has_value(); }));
        return reply.value_or(FileReply());
    }
    std::string call() {
        const std::lock_guard lock(mutex);
        return calls.empty() ? std::string() : calls.back();
    }

    PrivateBus bus;
    std::mutex mutex;
    std::vector<std::string> calls;
    std::atomic<int> wakes = 0;
    std::optional<FakePortal> portal;
    std::optional<FileChooser> chooser;
};
}  // namespace

TEST_CASE("without a session bus, or without a portal on it, there is no desktop dialog") {
    set_environment("DBUS_SESSION_BUS_ADDRESS", "disabled:");
    FileChooser lonely([] {});
    lonely.ask({.title = "Open"});
    std::optional<FileReply> reply;
    REQUIRE(becomes([&] { return (reply = lonely.take_reply()).has_value(); }));
    CHECK(reply->kind == FileReply::Kind::failed);
    CHECK_FALSE(lonely.is_available());

    const PrivateBus bus;
    REQUIRE(bus.is_running());
    std::atomic<int> wakes = 0;
    const FileChooser chooser([&] { ++wakes; });
    REQUIRE(becomes([&] { return wakes > 0; }));  // the bus has answered
    CHECK_FALSE(chooser.is_available());
}

TEST_CASE("a portal that starts later is found") {
    const PrivateBus bus;
    REQUIRE(bus.is_running());
    const FileChooser chooser([] {});
    const FakePortal portal([](const std::string&) { return Reaction(); });
    CHECK(becomes([&] { return chooser.is_available(); }));
}

TEST_CASE("a request to open a file has title, parent window, filters and folder") {
    Desktop desktop({.uris = {"file:///music/a%20b%C3%A4.wav"}});
    const FileReply reply = desktop.reply_to({.title = "Open a sound",
                                              .groups = {{"Sounds", {".wav"}}, {"All files", {}}},
                                              .folder = "/music",
                                              .parent_window = 0x2a00007});
    CHECK(reply.kind == FileReply::Kind::chosen);
    CHECK(reply.files == std::vector<std::filesystem::path>{"/music/a bä.wav"});
    // The order and the types of the portal's documentation.
    CHECK(desktop.call() ==
          R"(OpenFile "x11:0x2a00007" "Open a sound" ["handle_token"="afterglow1" "modal"=1 )"
          R"("filters"=[["Sounds" [[0 "*.wav"] [0 "*.WAV"]]] ["All files" [[0 "*"]]]] )"
          R"("current_filter"=["Sounds" [[0 "*.wav"] [0 "*.WAV"]]] "current_folder"=</music>])");
}

TEST_CASE("a request to save proposes a name, and a folder need not be UTF-8") {
    Desktop desktop({.uris = {"file:///films/x.mp4"}});
    const FileReply reply = desktop.reply_to({.kind = FileRequest::Kind::save,
                                              .title = "Save",
                                              .folder = "/films/\xff",
                                              .name = "x.mp4"});
    CHECK(reply.files == std::vector<std::filesystem::path>{"/films/x.mp4"});
    CHECK(desktop.call() ==
          "SaveFile \"\" \"Save\" [\"handle_token\"=\"afterglow1\" \"modal\"=1 "
          "\"current_name\"=\"x.mp4\" \"current_folder\"=</films/\xff>]");
}

TEST_CASE("a dialog that the user cancels or closes gives no file and no problem") {
    for (const auto& [code, delay] : {std::pair{1U, 0}, {2U, 1000}}) {
        Desktop desktop({.code = code, .uris = {"file:///a"}, .delay_milliseconds = delay});
        CHECK(desktop.reply_to({.title = "Open"}) == FileReply{});
        CHECK(desktop.wakes > 1);
    }
}

TEST_CASE("a dialog that fails says why") {
    struct Case {
        Reaction reaction;
        std::string problem;
    };
    for (const auto& [reaction, problem] : {
             Case{{.kind = Kind::refuse}, "luck"},
             Case{{.code = 2}, "closed without a choice"},
             Case{{.code = 0}, "no file"},
             Case{{.code = 0, .uris = {"https://a/b"}}, "is not a file on this machine"},
             Case{{.code = 0, .uris = {"file:///a%00b"}}, "is not a file on this machine"},
             Case{{.is_malformed = true}, "invalid"},
             Case{{.kind = Kind::leave}, "exited"},
         }) {
        CAPTURE(problem);
        Desktop desktop(reaction);
        const FileReply reply = desktop.reply_to({.title = "Open"});
        CHECK(reply.kind == FileReply::Kind::failed);
        CHECK(reply.files.empty());
        CHECK(reply.problem.find(problem) != std::string::npos);
        CHECK(reply.problem.find('\x01') == std::string::npos);
    }
}

TEST_CASE("a portal or a bus that crashes ends the request, and a new portal is found") {
    Desktop desktop({.kind = Kind::crash});
    CHECK(desktop.reply_to({.title = "Open"}).kind == FileReply::Kind::failed);
    REQUIRE(becomes([&] { return !desktop.chooser->is_available(); }));
    desktop.portal.emplace([](const std::string&) { return Reaction{.kind = Kind::hang}; });
    REQUIRE(becomes([&] { return desktop.chooser->is_available(); }));
    desktop.chooser->ask({.title = "Open"});
    desktop.bus.end();
    CHECK(desktop.reply().kind == FileReply::Kind::failed);
    CHECK_FALSE(desktop.chooser->is_available());
    CHECK(desktop.reply_to({.title = "Open"}).kind == FileReply::Kind::failed);
}

TEST_CASE("a cancelled dialog is closed, and its reply is ignored") {
    Desktop desktop({.kind = Kind::hang});
    desktop.chooser->ask({.title = "One"});
    REQUIRE(becomes([&] { return !desktop.call().empty(); }));
    desktop.chooser->cancel();
    REQUIRE(becomes([&] { return !desktop.portal->closed().empty(); }));
    const std::string path = desktop.portal->closed().front();
    CHECK(path.starts_with("/org/freedesktop/portal/desktop/request/1_"));
    CHECK(path.ends_with("/afterglow1"));
    CHECK_FALSE(desktop.chooser->take_reply().has_value());
    desktop.chooser->ask({.title = "Two"});
    REQUIRE(becomes([&] { return desktop.call().find("Two") != std::string::npos; }));
    desktop.chooser.reset();  // as when the window closes
    REQUIRE(becomes([&] { return desktop.portal->closed().size() == 2; }));
}

TEST_CASE("a portal before version 0.9 chooses the path of a request itself") {
    Desktop desktop({.uris = {"file:///a"},
                     .delay_milliseconds = 50,
                     .own_handle = "/org/freedesktop/portal/desktop/request/7"});
    CHECK(desktop.reply_to({.title = "Open"}).files == std::vector<std::filesystem::path>{"/a"});
}

TEST_CASE("asking never waits for the desktop") {
    Desktop desktop({.kind = Kind::hang});
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < 100; ++i) {
        desktop.chooser->ask({.title = "Open"});
        CHECK_FALSE(desktop.chooser->take_reply().has_value());
    }
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::milliseconds(500));
}

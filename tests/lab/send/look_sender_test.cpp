#include "lab/send/look_sender.h"

#include "formats/look_format.h"
#include "io/control/udp_port.h"
#include "io/files/scratch_folder.h"
#include "lab/document/document.h"

#include <doctest/doctest.h>

#include <string>
#include <thread>

namespace fs = std::filesystem;

namespace {
constexpr Extent size{64, 48};

Document open_crt() {
    const fs::path shaders = fs::path(AFTERGLOW_SOURCE_DIR) / "shaders";
    LoadedLook loaded = load_look(shaders / "crt", shaders / "include");
    REQUIRE(loaded.look);
    loaded.look->stack = {{"crt", shaders / "crt", "crt"}};
    return Document(std::move(*loaded.look));
}

/// Answers VERSION as RetroArch does, and counts the presets that it is told to load.
struct RetroArch {
    UdpPort port = *UdpPort::open(0);
    int loaded = 0;

    void answer() {
        while (const auto packet = port.take()) {
            const std::string text(packet->bytes.begin(), packet->bytes.end());
            if (text == "VERSION\n")
                (void)port.send(packet->bytes, packet->sender);
            loaded += text.starts_with("SET_SHADER ") ? 1 : 0;
        }
    }
    SendSettings settings() const { return {0, std::to_string(port.number()), true}; }
};

/// A sender whose updates take as long as a test says.
struct Sending {
    ScratchFolder folder = *ScratchFolder::create();
    LookSender sender{folder.path()};
    Messages messages;
    Document document = open_crt();

    void update(double wall_seconds) { sender.update(&document, {}, size, messages, wall_seconds); }
    void wait(RetroArch& program) {
        while (sender.work().is_running()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            program.answer();
            update(0.0);
        }
        program.answer();
    }
};
}  // namespace

TEST_CASE("edits are sent at most four times a second") {
    RetroArch program;
    Sending it;
    it.sender.send(it.document, {}, size, program.settings());
    it.wait(program);
    CHECK(program.loaded == 1);
    CHECK(it.sender.is_following());
    CHECK_FALSE(it.sender.is_busy());

    it.document.set_value("exposure", Value(2.0));
    it.update(0.24);
    CHECK(it.sender.is_busy());
    CHECK_FALSE(it.sender.work().is_running());
    it.update(0.02);
    CHECK(it.sender.work().is_running());
    it.wait(program);
    CHECK(program.loaded == 2);

    it.sender.stop_following();
    it.document.set_value("exposure", Value(3.0));
    it.update(1.0);
    CHECK_FALSE(it.sender.is_busy());
}

TEST_CASE("sending after edits ends with a message when the program does not answer") {
    const auto silent = UdpPort::open(0);
    REQUIRE(silent);
    RetroArch other;
    Sending it;
    it.sender.send(it.document, {}, size, {0, std::to_string(silent->number()), true});
    it.wait(other);
    CHECK_FALSE(it.sender.is_following());
    REQUIRE(it.messages.notice());
    CHECK(it.messages.notice()->text == "RetroArch does not answer on port " +
                                            std::to_string(silent->number()) +
                                            ". Enable network commands.");
}

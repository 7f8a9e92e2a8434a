#include "io/temporary_folder.h"
#include "lab/no_sound_devices.h"
#include "lab/playback/player.h"

#include <doctest/doctest.h>

#include <chrono>
#include <cstring>
#include <sys/socket.h>
#include <sys/un.h>
#include <thread>

namespace {
constexpr double feed_frame = 1.0 / 60.0;

/// Another program, connected to a socket.
class Sender {
public:
    explicit Sender(const std::filesystem::path& place)
        : m_socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        sockaddr_un address = {};
        address.sun_family = AF_UNIX;
        const std::string name = place.string();
        std::memcpy(address.sun_path, name.c_str(), name.size());
        REQUIRE(::connect(m_socket.get(), reinterpret_cast<const sockaddr*>(&address),
                          sizeof address) == 0);
    }

    void send(const std::string& text) const {
        REQUIRE(::send(m_socket.get(), text.data(), text.size(), MSG_NOSIGNAL) ==
                static_cast<ssize_t>(text.size()));
    }

private:
    Descriptor m_socket;
};

// Like the window, where time continues without a sender.
Player live_player() {
    return Player(std::make_unique<NoSoundDevices>());
}

Spec socket_at(const std::filesystem::path& place) {
    return {"socket", {{"path", place.string()}}};
}

/// Plays until a frame satisfies `is_wished`, and returns its beam.
template <class Wished>
Beam play_until(Player& player, const Wished& is_wished) {
    const auto start = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - start < std::chrono::seconds(20)) {
        Beam beam = player.signal().trace(player.advance(feed_frame)->span);
        if (is_wished(beam))
            return beam;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    FAIL("it never came");
    return {};
}

bool is_lit(const Beam& beam) {
    return !beam.empty() && beam.back().intensity > 0.0f;
}
}  // namespace

TEST_CASE("programs draw over a socket one after another, and their state is reported") {
    const TemporaryFolder folder;
    const auto place = folder.path() / "beam";
    Player player = live_player();
    REQUIRE(player.set_signal(socket_at(place)).has_value());
    CHECK(player.signal().feed()->state() == "Waiting for a program at " + place.string());
    CHECK(player.error().empty());
    {
        const Sender first(place);
        first.send("0.5 0 1 0.01\nnothing\n");
        CHECK(play_until(player, is_lit).back().x == 0.5f);
        play_until(player, [&](const Beam&) { return !player.error().empty(); });
        CHECK(player.error().find("beam:2: error: expected x y intensity") != std::string::npos);
    }
    const Sender second(place);
    second.send("-0.25 0 1 0.01\n");
    play_until(player, [](const Beam& beam) { return is_lit(beam) && beam.back().x == -0.25f; });
    CHECK(player.error().empty());
    CHECK(player.signal().feed()->state() == "Receiving from " + place.string());
}

TEST_CASE("after the last program disconnects the beam stops, and this is reported") {
    const TemporaryFolder folder;
    Player player = live_player();
    REQUIRE(player.set_signal(socket_at(folder.path() / "beam")).has_value());
    { const Sender silent(folder.path() / "beam"); }  // sends nothing, so it is not a sender
    Sender(folder.path() / "beam").send("0 0 1 0.01\n");
    play_until(player, [&](const Beam&) { return !player.error().empty(); });
    CHECK(player.error() == "\"" + (folder.path() / "beam").string() + "\" stopped sending");
}

TEST_CASE("an unusable path leaves the open socket in place") {
    const TemporaryFolder folder;
    const auto place = folder.path() / "beam";
    Player player = live_player();
    REQUIRE(player.set_signal(socket_at(place)).has_value());
    const Sender sender(place);
    const auto moved = player.set_signal(socket_at(folder.path() / "nowhere" / "beam"));
    REQUIRE_FALSE(moved.has_value());
    CHECK(moved.error().front().message.find("No such file or directory") != std::string::npos);
    sender.send("0.5 0 1 0.01\n");
    play_until(player, is_lit);
    REQUIRE(player.set_signal({}).has_value());
    CHECK_FALSE(std::filesystem::exists(place));
}

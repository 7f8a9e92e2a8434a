// The commands of the table, sent as UDP packets to a lab with a window state.
#include "lab/document/opened_preset.h"
#include "lab/remote/remote_peer.h"
#include "lab/small_lab.h"
#include "lab/window/window_state.h"

namespace {
class RemoteLab : public SmallLab {
public:
    RemoteLab() {
        for (const auto& [name, gain] : {std::pair{"amber", "2"}, std::pair{"blue", "4"}})
            REQUIRE(write_atomically(folder() / "presets/small" / (std::string(name) + ".json"),
                                     std::string(R"({ "format": "afterglow-preset", "version": 1,
                     "look": "small", "name": "The )") +
                                         name + R"(", "values": { "gain": )" + gain + " } }")
                        .has_value());
        start();
        lab().looks().open("small");
        wait_for_frames();
        RemoteSettings settings;
        settings.listens_to_osc = true;
        settings.osc_port = m_port = free_port();
        lab().remote().set_settings(settings);
    }
    void send(const std::string& address, std::vector<OscMessage::Argument> arguments = {}) {
        peer.send(m_port, "/afterglow/" + address, std::move(arguments));
        step();
    }
    void step(double seconds = 1.0 / 60.0) { lab().update(seconds, &window); }
    OscMessage asked(const std::string& address) {
        (void)peer.received();
        send(address);
        const auto replies = peer.received();
        REQUIRE(replies.size() == 1);
        CHECK(replies.front().address == "/afterglow/" + address);
        return replies.front();
    }
    OscMessage::Argument answer(const std::string& address) {
        const OscMessage reply = asked(address);
        REQUIRE(reply.arguments.size() == 1);
        return reply.arguments.front();
    }
    std::string reason() { return lab().remote().log().messages().front().reason; }
    double gain() { return document().value(*find_parameter(document().look(), "gain")).number(); }
    bool opens(const std::string& name) {
        return update_until([&] { return preset_name(document()) == name; });
    }

    WindowState window;
    RemotePeer peer;

private:
    int m_port = 0;
};

using Text = std::string;
}  // namespace

TEST_CASE("presets are opened by name and order, with buttons and with text") {
    RemoteLab small;
    small.send("command/preset", {Text("The blue")});
    REQUIRE(small.opens("The blue"));
    CHECK(small.gain() == 4.0);
    CHECK(small.answer("query/preset") == OscMessage::Argument(Text("The blue")));
    small.send("command/preset/amber", {0.0});  // a released button
    small.send("command/preset/amber", {1.0});
    REQUIRE(small.opens("The amber"));
    small.send("command/next", {1.0});
    REQUIRE(small.opens("The blue"));
    small.send("command/previous");
    REQUIRE(small.opens("The amber"));
    small.send("command/preset", {Text("ambre")});
    CHECK(small.reason() == "'small' has no preset 'ambre' (did you mean 'amber'?)");
    small.send("command/preset", {1.0});
    CHECK(small.reason() == "expected NAME and optional SECONDS");
    small.send("command/preset", {Text("amber"), Text("soon")});
    CHECK(small.reason() == "expected SECONDS");
    (void)small.peer.received();
    small.send("query/presets");
    CHECK(small.peer.received() ==
          std::vector<OscMessage>{{"/afterglow/query/presets", {Text("amber")}},
                                  {"/afterglow/query/presets", {Text("blue")}}});
}

TEST_CASE("a preset with seconds is morphed to, and the next one in the browser's time") {
    RemoteLab small;
    small.send("command/preset", {Text("blue"), 1.0});
    REQUIRE(small.lab().presets().navigation().morphing());
    small.step(0.5);
    CHECK(small.gain() > 1.0);
    CHECK(small.gain() < 4.0);
    REQUIRE(small.update_until([&] { return !small.lab().presets().navigation().morphing(); }));
    CHECK(small.gain() == 4.0);
    small.window.presets.morph_seconds = 10.0;
    small.send("command/morph", {1.0});
    REQUIRE(small.lab().presets().navigation().morphing());
    small.step(5.0);
    CHECK(small.lab().presets().navigation().morphing()->share() > 0.4);
    CHECK(small.lab().presets().navigation().morphing()->share() < 0.7);
}

TEST_CASE("playback is controlled and queried") {
    RemoteLab small;
    small.send("command/pause", {1.0});
    CHECK_FALSE(small.player().transport().is_playing());
    CHECK(small.answer("query/playing") == OscMessage::Argument(0.0));
    small.send("command/seek", {12.5});
    CHECK(small.player().transport().time() == doctest::Approx(12.5));
    CHECK(small.answer("query/time") == OscMessage::Argument(12.5));
    small.send("command/seek", {Text("3")});
    CHECK(small.player().transport().time() == doctest::Approx(3.0));
    for (const double wrong : {-1.0, 1e9}) {
        small.send("command/seek", {wrong});
        CHECK(small.reason() == "SECONDS must be from 0 to 86400");
    }
    small.send("command/seek");
    CHECK(small.reason() == "expected SECONDS");
    small.send("command/restart", {1.0});
    CHECK(small.player().transport().time() < 0.02);  // paused: at most its first frame
    small.send("command/play", {0.0});
    CHECK_FALSE(small.player().transport().is_playing());
    small.send("command/play", {1.0});
    CHECK(small.player().transport().is_playing());
}

TEST_CASE("slots are stored and recalled in the order of the messages") {
    RemoteLab small;
    small.send("command/slot/b/recall", {1.0});
    CHECK(small.reason() == "slot B is empty");
    small.send("gain", {3.0});
    small.send("command/slot/b/store", {1.0});
    small.send("command/slot/b/store", {0.0});
    small.send("gain", {5.0});
    small.send("command/slot/b/recall", {1.0});
    CHECK(small.gain() == 3.0);
    small.send("command/slot/d/store", {1.0});
    CHECK(small.reason() == "the slots are a, b and c, got 'd'");
}

TEST_CASE("blackout is immediate, and is rejected without an output window") {
    RemoteLab small;
    small.send("command/blackout", {1.0});
    CHECK(small.reason() ==
          "the output window and the virtual camera are off. Send "
          "/afterglow/command/action/output_window or /afterglow/command/action/virtual_camera "
          "first.");
    CHECK_FALSE(small.window.output.is_black);
    small.window.output.is_open = true;
    small.send("command/blackout", {1.0});
    CHECK(small.window.output.is_black);
    CHECK(small.answer("query/blackout") == OscMessage::Argument(1.0));
    small.send("command/blackout", {0.0});
    CHECK_FALSE(small.window.output.is_black);
    small.send("command/blackout");
    CHECK(small.reason() == "expected 1 (black) or 0 (picture)");
}

TEST_CASE("actions are handed to the window, and are rejected without one") {
    RemoteLab small;
    small.send("command/action/wipe", {1.0});
    CHECK(small.lab().remote().requested_action() == RequestedAction{"wipe", true});
    small.lab().remote().finish_action({});
    small.peer.send(small.lab().remote().osc().port(), "/afterglow/command/action/wipe");
    small.lab().update(1.0 / 60.0);
    CHECK(small.reason() == "actions need the window");
}

TEST_CASE("the look and all parameters are queried") {
    RemoteLab small;
    CHECK(small.answer("query/look") == OscMessage::Argument(Text("small")));
    (void)small.peer.received();
    small.send("query/parameters");
    CHECK(small.peer.received() ==
          std::vector<OscMessage>{{"/afterglow/parameter/step_size", {1.0}},
                                  {"/afterglow/parameter/gain", {1.0}}});
}

#include "lab/remote/osc_control.h"

#include "formats/preset/sample_preset.h"
#include "formats/settings/remote_settings_format.h"
#include "io/temporary_folder.h"
#include "lab/document/parameter_edits.h"
#include "lab/remote/fake_midi.h"
#include "lab/remote/osc_parameters.h"
#include "lab/remote/remote_control.h"
#include "lab/remote/remote_peer.h"
#include "lab/storage/event_waker.h"

#include <doctest/doctest.h>

#include <chrono>
#include <thread>

namespace {
OscMessage message(const std::string& name, std::vector<OscMessage::Argument> arguments) {
    return {"/afterglow/" + name, std::move(arguments)};
}

Value asked(const std::string& name, std::vector<OscMessage::Argument> arguments) {
    const auto change = change_of(message(name, std::move(arguments)), sample_look());
    REQUIRE(change.has_value());
    return change->value;
}

std::string refusal_of(const OscMessage& message) {
    const auto change = change_of(message, sample_look());
    REQUIRE_FALSE(change.has_value());
    return change.error().front().message;
}

/// A bundle of `count` messages with one float, with values rising to 1.
std::vector<std::uint8_t> bundle_of(const std::string& name, int count) {
    std::vector<std::uint8_t> bundle{'#', 'b', 'u', 'n', 'd', 'l', 'e', 0, 0, 0, 0, 0, 0, 0, 0, 1};
    for (int i = 1; i <= count; ++i) {
        const auto packet = osc_packet(message(name, {static_cast<double>(i) / count}));
        bundle.insert(bundle.end(), {0, 0, 0, static_cast<std::uint8_t>(packet.size())});
        bundle.insert(bundle.end(), packet.begin(), packet.end());
    }
    return bundle;
}

/// The presses and arguments that the test's commands received.
std::vector<std::string> calls;

Result<OscMessages> note(const RemoteCall& call) {
    const auto is_pressed = press_of(call.arguments);
    if (!is_pressed)
        return fail(is_pressed.error());
    if (*is_pressed)
        calls.push_back(call.name.empty() ? call.address : call.name);
    return OscMessages{};
}

Result<OscMessages> ask_window(const RemoteCall& call) {
    std::get<RemoteControl*>(call.parts)->request_action({call.name, *press_of(call.arguments)});
    return OscMessages{};
}

Result<OscMessages> reply_twice(const RemoteCall& call) {
    return OscMessages{{call.address, {1.0}}, {call.address, {std::string("two")}}};
}

constexpr RemoteCommand table[]{{"command/next", "[1 or 0]", "", note},
                                {"command/preset/NAME", "[1 or 0]", "", note},
                                {"command/slot/NAME/store", "[1 or 0]", "", note},
                                {"command/action/NAME", "[1 or 0]", "", ask_window},
                                {"query/twice", "", "", reply_twice}};

/// Remote control of a sample document, with a peer that sends to its port.
class Controlled {
public:
    Controlled() {
        calls.clear();
        document.emplace(sample_look());
        start();
        RemoteSettings settings;
        settings.listens_to_osc = true;
        settings.osc_port = port;
        remote->set_settings(settings);
        REQUIRE(remote->osc().port() == port);
    }
    void start() {
        remote = std::make_unique<RemoteControl>(document, roots, messages,
                                                 std::make_unique<FakeMidi>(device), table);
    }
    void update(double seconds = 0.1) {
        MutableParts parts{};
        std::get<RemoteControl*>(parts) = remote.get();
        remote->update(seconds, parts);
    }
    void send(const std::string& name, std::vector<OscMessage::Argument> arguments = {}) {
        peer.send(port, "/afterglow/" + name, std::move(arguments));
        update();
    }
    Value value(const std::string& name) const { return document->values().at(name); }
    const RejectedMessage& rejected() const {
        REQUIRE_FALSE(remote->log().messages().empty());
        return remote->log().messages().front();
    }

    TemporaryFolder folder;
    Roots roots{folder.path(), folder / "user", folder / "state"};
    OpenDocument document;
    Messages messages;
    FakeDevice device;
    std::unique_ptr<RemoteControl> remote;
    RemotePeer peer;
    int port = free_port();
};
}  // namespace

TEST_CASE("an address names a parameter, and its arguments are the clamped value") {
    CHECK(asked("decay", {0.5}) == Value(0.5));
    CHECK(asked("parameter/decay", {0.5}) == Value(0.5));
    CHECK(asked("decay", {7.0}) == Value(1.0));
    CHECK(asked("points", {5.4}) == Value(5.0));
    CHECK(asked("points", {std::string("5")}) == Value(5.0));
    CHECK(asked("as_written", {1.0}) == Value(1.0));
    CHECK(asked("as_written", {std::string("true")}) == Value(1.0));
    CHECK(asked("beam_color", {0.1, 0.2, 0.3}) == Value({0.1, 0.2, 0.3}));
    CHECK(asked("tone_map", {std::string("ACES")}) == Value(2.0));
    CHECK(refusal_of({"/decay", {0.5}}) == "expected /afterglow/NAME, got '/decay'");
    CHECK(refusal_of(message("decai", {0.5})) ==
          "'phosphor' has no parameter 'decai' (did you mean 'decay'?)");
    CHECK(refusal_of(message("parameter/decai", {0.5})) ==
          "'phosphor' has no parameter 'decai' (did you mean 'decay'?)");
    CHECK(refusal_of(message("beam_color", {0.5})) ==
          "'/afterglow/beam_color' must have 3 numbers, got 1");
    CHECK(refusal_of(message("noise", {0.5})) == "'/afterglow/noise' must be a text");
}

TEST_CASE("half a second without a change ends a step, and simultaneous changes share one") {
    RemoteGesture gesture;
    CHECK_FALSE(gesture.continues_step("decay", 10.0));
    CHECK(gesture.continues_step("decay", 10.49));
    CHECK_FALSE(gesture.has_ended(10.9));
    CHECK_FALSE(gesture.continues_step("exposure", 10.9));
    CHECK(gesture.continues_step("decay", 10.95));
    CHECK_FALSE(gesture.has_ended(11.44));
    CHECK(gesture.has_ended(11.45));
    CHECK_FALSE(gesture.has_ended(11.46));
    CHECK_FALSE(gesture.continues_step("decay", 11.47));
}

TEST_CASE("a remote drag is one undo step, and invalid messages are counted") {
    Controlled open;
    for (int i = 1; i <= 5; ++i)
        open.send("decay", {i * 0.125});
    CHECK(open.value("decay") == Value(0.625));
    CHECK(open.document->history().past().size() == 1);
    CHECK(open.remote->is_busy());
    open.update(0.6);
    CHECK_FALSE(open.remote->is_busy());
    CHECK_FALSE(open.document->history().is_in_gesture());
    open.send("decay", {0.25});
    CHECK(open.document->history().past().size() == 2);
    open.document->undo();
    CHECK(open.value("decay") == Value(0.625));
    open.send("gone", {0.25});
    CHECK(open.remote->log().accepted() == 6);
    CHECK(open.remote->log().rejected() == 1);
    set_parameter_setting(*open.document, "decay", {.is_locked = true});
    open.send("decay", {0.75});
    CHECK(open.value("decay") == Value(0.625));
    CHECK(open.rejected().reason == "'decay' is locked");
    OscControl other;
    CHECK_FALSE(other.listen(open.port).has_value());
    open.document.reset();
    open.send("decay", {0.5});
    CHECK(open.rejected().reason == "no look is open");
}

TEST_CASE("at most a thousand messages are processed per update, in order") {
    Controlled open;
    open.peer.send_bytes(open.port, bundle_of("decay", 1600));
    open.peer.send_bytes(open.port, bundle_of("gone", 800));
    open.update();
    CHECK(open.remote->log().accepted() == 1000);
    CHECK(open.value("decay") == Value(0.625));  // 1000 of 1600
    CHECK(open.remote->is_busy());
    open.update();
    CHECK(open.remote->log().accepted() == 1600);
    CHECK(open.remote->log().rejected() == 40);  // each costs ten
    CHECK(open.value("decay") == Value(1.0));
    for (int i = 0; i < 8; ++i)
        open.update();
    CHECK(open.remote->log().rejected() == 800);
    CHECK(open.remote->log().messages().size() == 1);  // equal ones are one entry
    CHECK(open.rejected().count == 800);
    CHECK_FALSE(open.remote->osc().has_more());
    open.peer.send_bytes(open.port, bundle_of("decay", 1600));
    open.update();
    RemoteSettings settings = open.remote->settings();
    settings.osc_reach = NetworkReach::local_network;
    open.remote->set_settings(settings);  // reopened, which drops the rest of a packet
    CHECK_FALSE(open.remote->osc().has_more());
}

TEST_CASE("a query is answered to the sender, or to the port that the user set") {
    Controlled open;
    open.send("decay", {0.5});
    CHECK(open.peer.received().empty());
    open.send("decay");
    open.send("parameter/beam_color");
    open.send("query/twice");
    const auto replies = open.peer.received();
    REQUIRE(replies.size() == 4);
    CHECK(replies[0] == OscMessage{"/afterglow/decay", {0.5}});
    CHECK(replies[1].address == "/afterglow/parameter/beam_color");
    CHECK(replies[1].arguments.size() == 3);
    CHECK(replies[2] == OscMessage{"/afterglow/query/twice", {1.0}});
    CHECK(replies[3] == OscMessage{"/afterglow/query/twice", {std::string("two")}});

    RemotePeer screen;
    RemoteSettings settings = open.remote->settings();
    settings.osc_reply_port = screen.port();
    open.remote->set_settings(settings);
    open.send("decay");
    CHECK(open.peer.received().empty());
    CHECK(screen.received() == std::vector<OscMessage>{{"/afterglow/decay", {0.5}}});
}

TEST_CASE("a button that sends 1 and then 0 runs a command once") {
    Controlled open;
    open.send("command/next", {1.0});
    open.send("command/next", {0.0});
    CHECK(calls == std::vector<std::string>{"/afterglow/command/next"});
    open.send("command/next");
    open.send("command/next", {std::string("true")});
    open.send("command/next", {std::string("0")});
    open.send("command/slot/b/store", {0.3});
    open.send("command/preset/Amber P3");
    CHECK(calls == std::vector<std::string>{"/afterglow/command/next", "/afterglow/command/next",
                                            "/afterglow/command/next", "b", "Amber P3"});
    CHECK(open.remote->log().accepted() == 7);
    CHECK(open.remote->log().rejected() == 0);
    open.send("command/next", {std::string("later")});
    CHECK(open.rejected().reason == "expected 1 or 0");
}

TEST_CASE("an unknown command is rejected with the most similar one") {
    Controlled open;
    open.send("command/nxet", {1.0});
    CHECK(open.rejected().reason ==
          "unknown command 'command/nxet' (did you mean 'command/next'?)");
    open.send("next", {1.0});
    CHECK(open.rejected().reason ==
          "no parameter 'next' (did you mean '/afterglow/command/next'?)");
    open.send("query/");
    CHECK(open.rejected().reason.starts_with("unknown command 'query/'"));
    open.send("command/slot//store", {1.0});
    CHECK(open.rejected().reason.starts_with("unknown command"));
    open.peer.send(open.port, "/decay", {0.5});
    open.update();
    CHECK(open.rejected().reason == "the address must start with /afterglow/");
    CHECK(calls.empty());
}

TEST_CASE("a parameter has precedence over a command of the same address") {
    Controlled open;
    Look look = sample_look();
    for (Parameter& parameter : look.parameters)
        if (parameter.name == "decay")
            parameter.name = "command/next";
    open.document.emplace(look);
    open.send("command/next", {0.25});
    CHECK(open.value("command/next") == Value(0.25));
    CHECK(calls.empty());
    open.send("parameter/command/next", {0.5});
    CHECK(open.value("command/next") == Value(0.5));
}

TEST_CASE("messages after an action wait until the window ran it") {
    Controlled open;
    open.peer.send(open.port, "/afterglow/command/action/wipe", {1.0});
    open.peer.send(open.port, "/afterglow/decay", {0.5});
    open.update();
    CHECK(open.remote->requested_action() == RequestedAction{"wipe", true});
    CHECK(open.document->values().empty());
    CHECK(open.remote->is_busy());
    open.remote->finish_action({});
    CHECK_FALSE(open.remote->requested_action());
    CHECK(open.remote->log().accepted() == 1);
    open.update();
    CHECK(open.value("decay") == Value(0.5));

    open.send("command/action/wipe", {0.0});
    CHECK(open.remote->requested_action() == RequestedAction{"wipe", false});
    open.remote->finish_action(fail(Diagnostic{{}, 0, "no look is open"}));
    CHECK(open.rejected().address == "/afterglow/command/action/wipe");
    CHECK(open.rejected().reason == "no look is open");
    open.send("command/action/wipe");
    open.update(60.0);  // one slow frame
    CHECK(open.remote->requested_action());
    for (int i = 0; i < 21; ++i)  // the window does not answer
        open.update(0.1);
    CHECK(open.rejected().reason == "the window is hidden");
    CHECK_FALSE(open.remote->requested_action());
}

TEST_CASE(
    "rejected messages are listed with value, sender and reason, without control characters") {
    Controlled open;
    open.send("gone", {0.25, std::string("Amber \x1b[31m\n")});
    const RejectedMessage& rejected = open.rejected();
    CHECK(rejected.address == "/afterglow/gone");
    CHECK(rejected.value == R"(0.25 "Amber \x1b[31m\x0a")");
    CHECK(rejected.sender == "127.0.0.1");
    CHECK(rejected.count == 1);
    CHECK(open.messages.notice()->text == "OSC: 'phosphor' has no parameter 'gone'");
    open.peer.send_bytes(open.port, {'/', 'n', 'o'});
    open.update();
    CHECK(open.rejected().address.empty());
    CHECK(open.rejected().reason == "an OSC packet must have a multiple of 4 bytes, got 3");
    open.send(std::string(3000, 'x'), {std::string(3000, 'y')});
    CHECK(open.rejected().reason == "an address or text is too long");
    CHECK(open.rejected().address.size() <= 210);
    CHECK(open.rejected().value.size() <= 210);
    for (int i = 0; i < 200; ++i)
        open.send("gone" + std::to_string(i), {1.0});
    CHECK(open.remote->log().messages().size() == 100);
    CHECK(open.remote->log().rejected() == 203);
    open.remote->clear_log();
    CHECK(open.remote->log().messages().empty());
}

TEST_CASE("the copied list of rejected messages has one line for each, the oldest first") {
    RemoteLog log;
    log.reject({3661.0, "/afterglow/a", "1", "192.168.1.9", "no parameter 'a'"});
    log.reject({50000.0, "/afterglow/b", "", "MIDI", "locked"});
    log.reject({50001.5, "/afterglow/b", "2", "MIDI", "locked"});
    CHECK(log.text() ==
          "Time\tAddress\tValue\tSender\tReason\tCount\n"
          "01:01:01\t/afterglow/a\t1\t192.168.1.9\tno parameter 'a'\t1\n"
          "13:53:21\t/afterglow/b\t2\tMIDI\tlocked\t2\n");
}

TEST_CASE("only the user's choice opens OSC to the network, and it is stored") {
    Controlled open;
    CHECK(open.remote->osc().reach() == NetworkReach::this_machine);
    CHECK(open.remote->osc().networks().empty());
    RemoteSettings settings = open.remote->settings();
    settings.osc_reach = NetworkReach::local_network;
    open.remote->set_settings(settings);
    CHECK(open.remote->osc().reach() == NetworkReach::local_network);
    CHECK(open.remote->osc().port() == open.port);
    open.send("decay", {0.5});  // this machine is still accepted
    CHECK(open.value("decay") == Value(0.5));
    open.remote.reset();
    open.start();
    CHECK(open.remote->osc().reach() == NetworkReach::local_network);
    settings.listens_to_osc = false;
    open.remote->set_settings(settings);
    CHECK_FALSE(open.remote->osc().is_listening());
}

TEST_CASE("a learnt note runs an action on each press, and other notes do nothing") {
    Controlled open;
    open.remote->learn_midi_command("action/wipe", "Wipe");
    CHECK(open.remote->learning_name() == "Wipe");
    open.device.messages = {{0x80, 36, 0}, {0xf8}, {0x99, 36}, {}, {0x99, 36, 90}};
    open.update();
    CHECK(open.remote->learning_name().empty());
    CHECK(open.messages.notice()->text == "Note 36, channel 10 now controls \"Wipe\"");
    CHECK_FALSE(open.remote->requested_action());  // learning does not run it
    open.device.messages = {{0x99, 37, 90}, {0x90, 36, 90}, {0xc9, 36}};
    open.update();
    CHECK_FALSE(open.remote->requested_action());
    open.device.messages = {{0x99, 36, 90}, {0x89, 36, 0}};
    open.update();
    CHECK(open.remote->requested_action() == RequestedAction{"wipe", true});
    open.remote->finish_action({});
    open.update();
    CHECK(open.remote->requested_action() == RequestedAction{"wipe", false});
    open.remote->finish_action({});

    open.remote.reset();
    open.start();  // stored
    CHECK(open.remote->settings().midi_commands ==
          std::vector<MidiCommand>{{"action/wipe", {MidiTrigger::Kind::note, 10, 36}}});
    CHECK(open.remote->midi().is_listening());
}

TEST_CASE("a program change and a button can be learnt, and Escape ends learning") {
    Controlled open;
    open.remote->learn_midi_command("next", "Next preset");
    open.device.messages = {{0xc2, 7}};
    open.update();
    open.device.messages = {{0xc2, 7}, {0xc2, 7}, {0xc2, 8}};
    open.update();
    CHECK(calls.size() == 2);
    open.remote->learn_midi_command("slot/a/store", "Store in slot A");
    open.device.messages = {{0xb0, 20, 20}, {0xb0, 20, 127}, {0xb0, 20, 126}, {0xb0, 20, 0}};
    open.update();
    CHECK(calls.size() == 2);
    open.device.messages = {{0xb0, 20, 127}, {0xb0, 20, 0}};
    open.update();
    CHECK(calls.back() == "a");
    open.remote->learn_midi_command("next", "Next preset");
    open.remote->end_midi_learning();
    open.device.messages = {{0x90, 1, 1}};
    open.update();
    CHECK(open.remote->settings().midi_commands.size() == 2);
    open.remote->learn_midi_command("gone", "Gone");
    open.device.messages = {{0x90, 1, 1}};
    open.update();
    open.device.messages = {{0x90, 1, 1}};
    open.update();
    CHECK(open.rejected().sender == "MIDI");
    CHECK(open.rejected().reason.starts_with("unknown command 'command/gone'"));
}

TEST_CASE("remote settings are restored, and an invalid port is reported at its line") {
    const RemoteSettings settings{
        .listens_to_osc = true,
        .osc_port = 57120,
        .osc_reach = NetworkReach::local_network,
        .osc_reply_port = 9001,
        .listens_to_midi = true,
        .has_soft_takeover = false,
        .midi = {{{"decay"}, 1, 21}, {{"centre", 1}, 16, 7, true}},
        .midi_commands = {{"action/wipe", {MidiTrigger::Kind::note, 10, 36}},
                          {"preset/amber-p3", {MidiTrigger::Kind::program, 1, 0}},
                          {"next", {MidiTrigger::Kind::control, 16, 127}}}};
    CHECK(parse_remote_settings(remote_settings_to_json(settings), "a.json") == settings);
    const auto bad = parse_remote_settings(
        "{\"format\": \"afterglow-remote\", \"version\": 1,\n\"osc_port\": 70000}", "a.json");
    REQUIRE_FALSE(bad.has_value());
    CHECK(bad.error().front().line == 2);
    const auto no_channel = parse_remote_settings(
        "{\"format\": \"afterglow-remote\", \"version\": 1, \"midi_bindings\": [\n"
        "{\"parameter\": \"decay\",\n\"channel\": 17}]}",
        "a.json");
    REQUIRE_FALSE(no_channel.has_value());
    CHECK(no_channel.error().front().line == 3);
    const auto no_reach = parse_remote_settings(
        "{\"format\": \"afterglow-remote\", \"version\": 1,\n\"osc_from\": \"everywhere\"}",
        "a.json");
    REQUIRE_FALSE(no_reach.has_value());
    CHECK(no_reach.error().front().line == 2);
}

TEST_CASE("settings of older versions stay on this machine") {
    const auto settings = parse_remote_settings(
        R"({"format": "afterglow-remote", "version": 1, "osc": true, "osc_port": 9000,
            "midi": false, "midi_picks_up": true, "midi_bindings": []})",
        "a.json");
    REQUIRE(settings.has_value());
    CHECK(settings->osc_reach == NetworkReach::this_machine);
    CHECK(settings->osc_reply_port == 0);
}

TEST_CASE("a port opens again with another reach while a thread waits for its messages") {
    OscControl control;
    std::optional<EventWaker> waker;
    control.set_watch([&](int descriptor) {
        waker.reset();
        if (descriptor >= 0)
            waker.emplace(descriptor, [] {});
    });
    const int port = UdpPort::open(0).value().number();  // free again
    for (int i = 0; i < 10; ++i) {
        const auto reach = i % 2 == 0 ? NetworkReach::this_machine : NetworkReach::local_network;
        const auto opened = control.listen(port, reach);
        REQUIRE_MESSAGE(opened.has_value(), to_string(opened.error()));
        CHECK(control.reach() == reach);
        std::this_thread::sleep_for(std::chrono::milliseconds(5));  // the thread waits now
    }
}

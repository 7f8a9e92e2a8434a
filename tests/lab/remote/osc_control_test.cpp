#include "lab/remote/osc_control.h"

#include "formats/preset/sample_preset.h"
#include "formats/settings/remote_settings_format.h"
#include "lab/document/parameter_edits.h"

#include <doctest/doctest.h>

#include <arpa/inet.h>
#include <bit>
#include <sys/socket.h>

namespace {
OscMessage message(const std::string& name, std::vector<OscMessage::Argument> arguments) {
    return {"/afterglow/" + name, std::move(arguments)};
}

Value asked(const std::string& name, std::vector<OscMessage::Argument> arguments) {
    const auto change = change_of(message(name, std::move(arguments)), sample_look());
    REQUIRE(change.has_value());
    CHECK(change->parameter == name);
    return change->value;
}

std::string refusal_of(const OscMessage& message) {
    const auto change = change_of(message, sample_look());
    REQUIRE_FALSE(change.has_value());
    return change.error().front().message;
}

std::string big_endian(std::uint32_t number) {
    const std::uint32_t bits = htonl(number);
    return {reinterpret_cast<const char*>(&bits), sizeof(bits)};
}

/// `/afterglow/NAME f` as bytes.
std::string packet_of(const std::string& name, float number) {
    std::string packet = "/afterglow/" + name;
    packet.resize((packet.size() / 4 + 1) * 4);
    return packet + std::string(",f\0\0", 4) + big_endian(std::bit_cast<std::uint32_t>(number));
}

/// A bundle of `count` such messages, with values rising to 1.
std::string bundle_of(const std::string& name, int count) {
    std::string bundle = std::string("#bundle\0", 8) + big_endian(0) + big_endian(1);
    for (int i = 1; i <= count; ++i) {
        const std::string packet =
            packet_of(name, static_cast<float>(i) / static_cast<float>(count));
        bundle += big_endian(static_cast<std::uint32_t>(packet.size())) + packet;
    }
    return bundle;
}

/// Sends bytes to a local port.
void send_packet(int port, const std::string& packet) {
    const int sender = ::socket(AF_INET, SOCK_DGRAM, 0);
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(static_cast<std::uint16_t>(port));
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    ::sendto(sender, packet.data(), packet.size(), 0, reinterpret_cast<sockaddr*>(&to), sizeof(to));
    ::close(sender);
}

void send(int port, const std::string& name, float number) {
    send_packet(port, packet_of(name, number));
}

int free_port() {
    const auto port = UdpPort::open(0);
    REQUIRE(port.has_value());
    return port->number();
}
}  // namespace

TEST_CASE("an address names a parameter, and its arguments are the clamped value") {
    CHECK(asked("decay", {0.5}) == Value(0.5));
    CHECK(asked("decay", {7.0}) == Value(1.0));
    CHECK(asked("points", {5.4}) == Value(5.0));
    CHECK(asked("as_written", {1.0}) == Value(1.0));
    CHECK(asked("beam_color", {0.1, 0.2, 0.3}) == Value({0.1, 0.2, 0.3}));
    CHECK(asked("tone_map", {std::string("ACES")}) == Value(2.0));
    CHECK(refusal_of({"/decay", {0.5}}) == "expected /afterglow/NAME, got '/decay'");
    CHECK(refusal_of(message("decai", {0.5})) ==
          "'phosphor' has no parameter 'decai' (did you mean 'decay'?)");
    CHECK(refusal_of(message("decay", {})) ==
          "'/afterglow/decay' must be a single number, got 0 numbers");
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
    OscControl osc;
    RemoteEdits edits;
    Document document(sample_look());
    const auto update = [&](Document* edited, double now_seconds) {
        osc.update(edited, edits, now_seconds);
        edits.update(edited, now_seconds);
    };
    REQUIRE(osc.listen(0).has_value());
    CHECK_FALSE(osc.is_listening());
    const int port = free_port();
    REQUIRE(osc.listen(port).has_value());
    for (int i = 1; i <= 5; ++i) {
        send(port, "decay", static_cast<float>(i) * 0.125f);
        update(&document, i * 0.1);
    }
    CHECK(document.values().at("decay") == Value(0.625));
    CHECK(document.history().past().size() == 1);
    CHECK(edits.is_in_gesture());
    update(&document, 1.0);
    CHECK_FALSE(edits.is_in_gesture());
    CHECK_FALSE(document.history().is_in_gesture());
    send(port, "decay", 0.25f);
    update(&document, 1.1);
    CHECK(document.history().past().size() == 2);
    document.undo();
    CHECK(document.values().at("decay") == Value(0.625));
    send(port, "gone", 0.25f);
    update(&document, 1.2);
    update(nullptr, 1.3);
    CHECK(osc.applied() == 6);
    CHECK(osc.refused() == 1);
    CHECK(osc.problem().find("'gone'") != std::string::npos);
    set_parameter_setting(document, "decay", {.is_locked = true});
    send(port, "decay", 0.75f);
    update(&document, 1.4);
    CHECK(document.values().at("decay") == Value(0.625));
    CHECK(osc.problem() == "'decay' is locked");
    OscControl other;
    CHECK_FALSE(other.listen(port).has_value());
}

TEST_CASE("at most a thousand messages are processed per update, in order") {
    OscControl osc;
    RemoteEdits edits;
    Document document(sample_look());
    const int port = free_port();
    REQUIRE(osc.listen(port).has_value());
    send_packet(port, bundle_of("decay", 1600));
    send_packet(port, bundle_of("gone", 800));
    osc.update(&document, edits, 0.1);
    CHECK(osc.applied() == 1000);
    CHECK(document.values().at("decay") == Value(0.625));  // 1000 of 1600
    CHECK(osc.has_more());
    osc.update(&document, edits, 0.2);
    CHECK(osc.applied() == 1600);
    CHECK(osc.refused() == 400);
    CHECK(document.values().at("decay") == Value(1.0));
    osc.update(&document, edits, 0.3);
    CHECK(osc.refused() == 800);
    CHECK_FALSE(osc.has_more());
    send_packet(port, bundle_of("decay", 1600));
    osc.update(&document, edits, 0.4);
    REQUIRE(osc.listen(port).has_value());  // reopened, which drops the rest of a packet
    CHECK_FALSE(osc.has_more());
}

TEST_CASE("remote settings are restored, and an invalid port is reported at its line") {
    const RemoteSettings settings{true, 57120, true, false, {{{"decay", 2}, 16, 31, true}}};
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
}

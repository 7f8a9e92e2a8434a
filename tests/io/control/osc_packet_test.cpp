#include "io/control/osc_packet.h"

#include <doctest/doctest.h>

namespace {
using Packet = std::vector<std::uint8_t>;

// The two examples of the OSC specification.
const Packet frequency{0x2f, 0x6f, 0x73, 0x63, 0x69, 0x6c, 0x6c, 0x61, 0x74, 0x6f, 0x72,
                       0x2f, 0x34, 0x2f, 0x66, 0x72, 0x65, 0x71, 0x75, 0x65, 0x6e, 0x63,
                       0x79, 0x00, 0x2c, 0x66, 0x00, 0x00, 0x43, 0xdc, 0x00, 0x00};
const Packet foo{0x2f, 0x66, 0x6f, 0x6f, 0x00, 0x00, 0x00, 0x00, 0x2c, 0x69, 0x69, 0x73, 0x66, 0x66,
                 0x00, 0x00, 0x00, 0x00, 0x03, 0xe8, 0xff, 0xff, 0xff, 0xff, 0x68, 0x65, 0x6c, 0x6c,
                 0x6f, 0x00, 0x00, 0x00, 0x3f, 0x9d, 0xf3, 0xb6, 0x40, 0xb5, 0xb2, 0x2d};

Packet bundle_of(const std::vector<Packet>& elements) {
    Packet packet{'#', 'b', 'u', 'n', 'd', 'l', 'e', 0, 0, 0, 0, 0, 0, 0, 0, 1};
    for (const Packet& element : elements) {
        packet.insert(packet.end(), {0, 0, static_cast<std::uint8_t>(element.size() >> 8),
                                     static_cast<std::uint8_t>(element.size())});
        packet.insert(packet.end(), element.begin(), element.end());
    }
    return packet;
}

std::string refusal_of(const Packet& packet) {
    const auto messages = parse_osc(packet);
    REQUIRE_FALSE(messages.has_value());
    return messages.error().front().message;
}
}  // namespace

TEST_CASE("the examples of the OSC specification are parsed correctly") {
    CHECK(parse_osc(frequency) == std::vector<OscMessage>{{"/oscillator/4/frequency", {440.0}}});
    CHECK(parse_osc(foo) ==
          std::vector<OscMessage>{{"/foo",
                                   {1000.0, -1.0, std::string("hello"), static_cast<double>(1.234f),
                                    static_cast<double>(5.678f)}}});
}

TEST_CASE("OSC bundles contain messages and nested bundles in order") {
    const Packet inner = bundle_of({foo});
    const auto messages = parse_osc(bundle_of({frequency, inner, frequency}));
    REQUIRE(messages.has_value());
    REQUIRE(messages->size() == 3);
    CHECK((*messages)[0].address == "/oscillator/4/frequency");
    CHECK((*messages)[1].address == "/foo");
    CHECK(parse_osc(bundle_of({}))->empty());
}

TEST_CASE("OSC booleans, doubles and 64-bit integers are parsed") {
    const Packet packet{'/',  'a',  0,    0,    ',',  'T',  'F',  'd', 'h', 0,
                        0,    0,    0x3f, 0xf8, 0,    0,    0,    0,   0,   0,  // 1.5
                        0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xfe};        // -2
    CHECK(parse_osc(packet) == std::vector<OscMessage>{{"/a", {1.0, 0.0, 1.5, -2.0}}});
}

TEST_CASE("OSC symbols and impulses are parsed as text and 1") {
    CHECK(parse_osc(Packet{'/', 'a', 0, 0, ',', 'S', 'I', 0, 'o', 'n', 0, 0}) ==
          std::vector<OscMessage>{{"/a", {std::string("on"), 1.0}}});
}

TEST_CASE("a written OSC packet has the bytes of the specification's example") {
    CHECK(osc_packet({"/oscillator/4/frequency", {440.0}}) == frequency);
    CHECK(osc_packet({"/a", {}}) == Packet{'/', 'a', 0, 0, ',', 0, 0, 0});
    // Text is padded to four bytes, also if it already has four.
    CHECK(osc_packet({"/abc", {std::string("amber")}}) ==
          Packet{'/', 'a', 'b', 'c', 0, 0, 0, 0, ',', 's', 0, 0, 'a', 'm', 'b', 'e', 'r', 0, 0, 0});
    const std::string cut("ab\0cd", 5);
    CHECK(parse_osc(osc_packet({"/a", {cut}})) ==
          std::vector<OscMessage>{{"/a", {std::string("ab")}}});
}

TEST_CASE("malformed OSC packets are rejected with a specific error") {
    CHECK(refusal_of({}) == "an OSC packet must have a multiple of 4 bytes, got 0");
    CHECK(refusal_of({'/', 'a', 0}) == "an OSC packet must have a multiple of 4 bytes, got 3");
    CHECK(refusal_of({'/', 'a', 'b', 'c'}) == "an OSC address isn't terminated");
    CHECK(refusal_of({'/', 'a', 0, 'x'}) ==
          "an OSC address isn't terminated");  // no padding to 4 bytes
    CHECK(refusal_of({'a', 0, 0, 0}).starts_with("an OSC packet must start with"));
    CHECK(refusal_of({'/', 'a', 0, 0}) == "'/a' has no type tags");
    CHECK(refusal_of({'/', 'a', 0, 0, 'f', 0, 0, 0}) == "the type tags of '/a' are invalid");
    CHECK(refusal_of({'/', 'a', 0, 0, ',', 'f', 0, 0})
              .starts_with("argument 1 of '/a' is truncated"));
    CHECK(refusal_of({'/', 'a', 0, 0, ',', 'b', 0, 0}).find("type 'b'") != std::string::npos);
    CHECK(refusal_of({'/', 'a', 0, 0, ',', 0, 0, 0, 0, 0, 0, 0}) ==
          "'/a' has data after its last argument");
    CHECK(refusal_of({'/', 'a', 0, 0, ',', 'f', 0, 0, 0x7f, 0xc0, 0, 0})  // NaN
              .find("not finite") != std::string::npos);
    Packet long_element = bundle_of({foo});
    long_element[19] = 0xff;
    CHECK(refusal_of(long_element) == "an element of an OSC bundle is truncated");
    CHECK(refusal_of({'#', 'b', 'u', 'n', 'd', 'l', 'e', 0}) == "an OSC bundle has no time tag");
    Packet deep = foo;
    for (int i = 0; i < 20; ++i)
        deep = bundle_of({deep});
    CHECK(refusal_of(deep).find("nested") != std::string::npos);
}

TEST_CASE("truncated and damaged OSC packets are never read beyond their end") {
    const Packet whole = bundle_of({frequency, foo});
    for (std::size_t size = 0; size < whole.size(); ++size)
        (void)parse_osc(Packet(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)));
    for (std::size_t i = 0; i < whole.size(); ++i)
        for (const int flip : {1, 0x80, 0xff}) {
            Packet damaged = whole;
            damaged[i] = static_cast<std::uint8_t>(damaged[i] ^ flip);
            (void)parse_osc(damaged);
        }
}

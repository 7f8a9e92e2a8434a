#include "io/control/osc_packet.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

namespace {
using Bytes = std::span<const std::uint8_t>;
using Messages = std::vector<OscMessage>;

constexpr std::size_t part_size = 4;  // bytes; all sizes are a multiple of it
constexpr int deepest = 8;            // nesting of bundles

/// Reads parts from the front of a packet; nullopt if the packet is too short.
class OscReader {
public:
    explicit OscReader(Bytes bytes) : m_rest(bytes) {}

    bool is_at_end() const { return m_rest.empty(); }
    Bytes rest() const { return m_rest; }

    std::optional<Bytes> take(std::size_t size) {
        if (size > m_rest.size())
            return std::nullopt;
        const Bytes taken = m_rest.first(size);
        m_rest = m_rest.subspan(size);
        return taken;
    }

    template <class T>
    std::optional<T> number() {
        const auto bytes = take(sizeof(T));
        if (!bytes)
            return std::nullopt;
        T value = 0;
        for (const std::uint8_t byte : *bytes)
            value = static_cast<T>((value << 8) | byte);
        return value;
    }

    // Terminated by a zero byte and padded with zero bytes to a multiple of part_size.
    std::optional<std::string> text() {
        const auto end = std::ranges::find(m_rest, std::uint8_t{0});
        if (end == m_rest.end())
            return std::nullopt;
        const auto length = static_cast<std::size_t>(end - m_rest.begin());
        const auto bytes = take((length / part_size + 1) * part_size);
        if (!bytes || std::ranges::any_of(bytes->subspan(length), [](auto b) { return b != 0; }))
            return std::nullopt;
        return std::string(bytes->begin(), bytes->begin() + static_cast<std::ptrdiff_t>(length));
    }

private:
    Bytes m_rest;
};

template <class T>
std::optional<OscMessage::Argument> as_argument(std::optional<T> number) {
    if (!number || !std::isfinite(static_cast<double>(*number)))
        return std::nullopt;
    return static_cast<double>(*number);
}

template <class Float, class Bits>
std::optional<Float> as_float(std::optional<Bits> bits) {
    return bits ? std::optional(std::bit_cast<Float>(*bits)) : std::nullopt;
}

template <class Signed, class Bits>
std::optional<Signed> as_signed(std::optional<Bits> bits) {
    return bits ? std::optional(static_cast<Signed>(*bits)) : std::nullopt;
}

std::optional<OscMessage::Argument> read_argument(char tag, OscReader& reader) {
    switch (tag) {
        case 'i':
            return as_argument(as_signed<std::int32_t>(reader.number<std::uint32_t>()));
        case 'f':
            return as_argument(as_float<float>(reader.number<std::uint32_t>()));
        case 'h':
            return as_argument(as_signed<std::int64_t>(reader.number<std::uint64_t>()));
        case 'd':
            return as_argument(as_float<double>(reader.number<std::uint64_t>()));
        case 's':
        case 'S':
            if (auto text = reader.text())
                return std::move(*text);
            return std::nullopt;
        default:
            return tag == 'F' ? 0.0 : 1.0;
    }
}

Result<void> read_message(OscReader reader, Messages& messages) {
    OscMessage message;
    const auto address = reader.text();
    if (!address)
        return fail({{}, 0, "an OSC address isn't terminated"});
    message.address = *address;
    if (reader.is_at_end())
        return fail({{}, 0, fmt::format("'{}' has no type tags", message.address)});
    const auto tags = reader.text();
    if (!tags || !tags->starts_with(','))
        return fail({{}, 0, fmt::format("the type tags of '{}' are invalid", message.address)});
    for (const char tag : tags->substr(1)) {
        if (std::string_view("ifshdSTFI").find(tag) == std::string_view::npos)
            return fail({{},
                         0,
                         fmt::format("'{}' has an argument of unsupported type '{}'",
                                     message.address, tag)});
        auto argument = read_argument(tag, reader);
        if (!argument)
            return fail({{},
                         0,
                         fmt::format("argument {} of '{}' is truncated or not finite",
                                     message.arguments.size() + 1, message.address)});
        message.arguments.push_back(std::move(*argument));
    }
    if (!reader.is_at_end())
        return fail({{}, 0, fmt::format("'{}' has data after its last argument", message.address)});
    messages.push_back(std::move(message));
    return {};
}

Result<void> read_packet(Bytes packet, int depth, Messages& messages);

Result<void> read_bundle(OscReader reader, int depth, Messages& messages) {
    constexpr std::size_t time_tag = 8;
    if (!reader.take(time_tag))
        return fail({{}, 0, "an OSC bundle has no time tag"});
    while (!reader.is_at_end()) {
        const auto size = reader.number<std::uint32_t>();
        const auto element = size ? reader.take(*size) : std::nullopt;
        if (!element)
            return fail({{}, 0, "an element of an OSC bundle is truncated"});
        if (auto read = read_packet(*element, depth + 1, messages); !read)
            return read;
    }
    return {};
}

Result<void> read_packet(Bytes packet, int depth, Messages& messages) {
    if (packet.empty() || packet.size() % part_size != 0)
        return fail({{},
                     0,
                     fmt::format("an OSC packet must have a multiple of {} bytes, got {}",
                                 part_size, packet.size())});
    if (depth > deepest)
        return fail(
            {{}, 0, fmt::format("OSC bundles are nested more than {} levels deep", deepest)});
    OscReader reader(packet);
    if (packet.front() == '/')
        return read_message(reader, messages);
    if (reader.text() == "#bundle")
        return read_bundle(reader, depth, messages);
    return fail({{}, 0, "an OSC packet must start with '/' or '#bundle'"});
}
}  // namespace

Result<std::vector<OscMessage>> parse_osc(std::span<const std::uint8_t> packet) {
    Messages messages;
    if (auto read = read_packet(packet, 0, messages); !read)
        return fail(std::move(read.error()));
    return messages;
}

namespace {
void append_text(std::string_view text, std::vector<std::uint8_t>& packet) {
    text = text.substr(0, text.find('\0'));
    packet.insert(packet.end(), text.begin(), text.end());
    packet.insert(packet.end(), part_size - text.size() % part_size, 0);
}

void append_float(float number, std::vector<std::uint8_t>& packet) {
    const auto bits = std::bit_cast<std::uint32_t>(number);
    for (const int shift : {24, 16, 8, 0})
        packet.push_back(static_cast<std::uint8_t>(bits >> shift));
}
}  // namespace

std::vector<std::uint8_t> osc_packet(const OscMessage& message) {
    std::vector<std::uint8_t> packet;
    append_text(message.address, packet);
    std::string tags = ",";
    for (const OscMessage::Argument& argument : message.arguments)
        tags += std::holds_alternative<std::string>(argument) ? 's' : 'f';
    append_text(tags, packet);
    for (const OscMessage::Argument& argument : message.arguments)
        if (const auto* text = std::get_if<std::string>(&argument))
            append_text(*text, packet);
        else
            append_float(static_cast<float>(std::get<double>(argument)), packet);
    return packet;
}

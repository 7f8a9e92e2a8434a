#include "base/packed.h"

namespace {
constexpr int number_bytes = 8;
constexpr int byte_bits = 8;
}  // namespace

void Packer::add(std::uint64_t number) {
    for (int i = 0; i < number_bytes; ++i)
        m_bytes += static_cast<char>(number >> (byte_bits * i) & 0xff);
}

void Packer::add(std::string_view text) {
    add(std::uint64_t{text.size()});
    m_bytes += text;
}

void Unpacker::fault() {
    m_is_good = false;
    m_rest = {};
}

std::uint64_t Unpacker::number() {
    if (m_rest.size() < number_bytes) {
        fault();
        return 0;
    }
    std::uint64_t number = 0;
    for (int i = 0; i < number_bytes; ++i)
        number |= std::uint64_t{static_cast<unsigned char>(m_rest[static_cast<std::size_t>(i)])}
                  << (byte_bits * i);
    m_rest.remove_prefix(number_bytes);
    return number;
}

std::uint64_t Unpacker::number(std::uint64_t maximum) {
    const std::uint64_t read = number();
    if (read <= maximum)
        return read;
    fault();
    return 0;
}

std::string_view Unpacker::text() {
    const std::size_t size = count();
    const std::string_view read = m_rest.substr(0, size);
    m_rest.remove_prefix(size);
    return read;
}

std::size_t Unpacker::count() {
    const std::uint64_t read = number();
    if (read <= m_rest.size())
        return static_cast<std::size_t>(read);
    fault();
    return 0;
}

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

/// Numbers and texts one after the other as bytes, the same on every machine.
class Packer {
public:
    void add(std::uint64_t number);
    void add(std::string_view text);
    const std::string& bytes() const { return m_bytes; }

private:
    std::string m_bytes;
};

/// Reads what a Packer wrote. From the first fault on nothing is good any more, and all that is
/// read is 0 or empty.
class Unpacker {
public:
    explicit Unpacker(std::string_view bytes) : m_rest(bytes) {}

    std::uint64_t number();
    /// A number up to `most`; a larger one is a fault.
    std::uint64_t number(std::uint64_t most);
    std::string_view text();
    /// How many things follow; more than there are bytes left is a fault.
    std::size_t count();
    bool is_good() const { return m_is_good; }
    /// Good, and all has been read.
    bool is_at_end() const { return m_is_good && m_rest.empty(); }

private:
    void fault();

    std::string_view m_rest;
    bool m_is_good = true;
};

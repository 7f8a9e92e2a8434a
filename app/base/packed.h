#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

/// Serialises numbers and texts to bytes, independent of the machine.
class Packer {
public:
    void add(std::uint64_t number);
    void add(std::string_view text);
    const std::string& bytes() const { return m_bytes; }

private:
    std::string m_bytes;
};

/// Reads the bytes of a Packer. After the first error all values read are 0 or empty.
class Unpacker {
public:
    explicit Unpacker(std::string_view bytes) : m_rest(bytes) {}

    std::uint64_t number();
    /// A number up to `maximum`; a larger one is an error.
    std::uint64_t number(std::uint64_t maximum);
    std::string_view text();
    /// The number of elements that follow; more than the bytes left is an error.
    std::size_t count();
    bool is_good() const { return m_is_good; }
    /// No error, and all bytes are read.
    bool is_at_end() const { return m_is_good && m_rest.empty(); }

private:
    void fault();

    std::string_view m_rest;
    bool m_is_good = true;
};

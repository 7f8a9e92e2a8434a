#pragma once

#include <optional>
#include <string>
#include <string_view>

/// A cache of results that are slow to compute, by key, possibly across runs of the program. May
/// drop any entry at any time. Thread-safe.
class ByteStore {
public:
    ByteStore() = default;
    virtual ~ByteStore() = default;
    ByteStore(const ByteStore&) = delete;
    ByteStore& operator=(const ByteStore&) = delete;

    virtual std::optional<std::string> find(std::string_view key) = 0;
    virtual void keep(std::string_view key, std::string_view value) = 0;
};

#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Answers that took long to find, kept by their questions, perhaps from one run of the program to
/// the next. May forget any of them at any time. Thread-safe.
class ByteStore {
public:
    ByteStore() = default;
    virtual ~ByteStore() = default;
    ByteStore(const ByteStore&) = delete;
    ByteStore& operator=(const ByteStore&) = delete;

    virtual std::optional<std::string> find(std::string_view question) = 0;
    virtual void keep(std::string_view question, std::string_view answer) = 0;
};

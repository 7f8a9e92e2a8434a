#pragma once

#include "base/byte_store.h"

#include <map>
#include <string>

/// A ByteStore in memory, whose answers a test may read and spoil.
struct ByteMap : ByteStore {
    std::optional<std::string> find(std::string_view key) override {
        const auto found = answers.find(std::string(key));
        return found == answers.end() ? std::nullopt : std::optional(found->second);
    }
    void keep(std::string_view key, std::string_view value) override {
        answers[std::string(key)] = value;
    }

    std::map<std::string, std::string> answers;
};

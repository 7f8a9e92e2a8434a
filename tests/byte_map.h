#pragma once

#include "base/byte_store.h"

#include <map>
#include <string>

/// A ByteStore in memory, whose answers a test may read and spoil.
struct ByteMap : ByteStore {
    std::optional<std::string> find(std::string_view question) override {
        const auto found = answers.find(std::string(question));
        return found == answers.end() ? std::nullopt : std::optional(found->second);
    }
    void keep(std::string_view question, std::string_view answer) override {
        answers[std::string(question)] = answer;
    }

    std::map<std::string, std::string> answers;
};

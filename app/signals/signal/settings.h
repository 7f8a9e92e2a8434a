#pragma once

#include "model/look/spec.h"

#include <cassert>
#include <string>
#include <string_view>

/// The settings of a completed spec, read by key.
class Settings {
public:
    explicit Settings(const Spec& completed_spec) : m_spec(completed_spec) {}

    double number(const std::string& key) const { return std::get<double>(at(key)); }
    int whole(const std::string& key) const { return static_cast<int>(number(key)); }
    std::string_view word(const std::string& key) const { return std::get<std::string>(at(key)); }
    bool is(const std::string& key, std::string_view expected) const {
        return word(key) == expected;
    }

private:
    const Spec::Setting& at(const std::string& key) const {
        const auto found = m_spec.settings.find(key);
        assert(found != m_spec.settings.end());
        return found->second;
    }

    const Spec& m_spec;
};

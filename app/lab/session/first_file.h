#pragma once

#include "lab/lab.h"

#include <filesystem>

/// A sound or picture that a person started the program with, in the place of a look: it is opened
/// as soon as a look is open that can show it.
class FirstFile {
public:
    FirstFile() = default;
    explicit FirstFile(std::filesystem::path file) : m_file(std::move(file)) {}

    /// Whether what the program was started with is a file that a look can show.
    static bool is_one(const std::string& argument, const Lab& lab);
    /// To be called once a frame; opens another look where the open one is driven otherwise.
    void update(Lab& lab);

private:
    std::filesystem::path m_file;  // "": none, or opened
    bool m_has_asked = false;      // for another look
};

#pragma once

#include "lab/lab.h"

#include <filesystem>

/// A sound or picture that the program was started with instead of a look. It is opened as soon as
/// a suitable look is open.
class FirstFile {
public:
    FirstFile() = default;
    explicit FirstFile(std::filesystem::path file) : m_file(std::move(file)) {}

    /// Whether the argument of the program is a sound or picture file.
    static bool is_one(const std::string& argument);
    /// Call it once per frame. Opens another look if the open one cannot use the file.
    void update(Lab& lab);

private:
    std::filesystem::path m_file;  // "": no file, or already opened
    bool m_has_asked = false;      // has opened another look
};

#pragma once

#include <filesystem>

/// The result of make_private_folder().
enum class PrivateFolder {
    ready,
    not_created,
    not_private,  // it belongs to another user, or others can write to it
};

/// Creates a folder that other users can't access, or checks the existing one. Its parent folder
/// must exist.
PrivateFolder make_private_folder(const std::filesystem::path& folder);

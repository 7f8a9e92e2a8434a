#include "io/files/atomic_folder.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <utility>

namespace fs = std::filesystem;

namespace {
tl::unexpected<Diagnostics> refused(const fs::path& target, const std::error_code& error) {
    return fail({target, 0, fmt::format("can't write the folder: {}", error.message())});
}
}  // namespace

Result<AtomicFolder> AtomicFolder::create(const fs::path& target) {
    std::error_code error;
    fs::path absolute = fs::absolute(target, error).lexically_normal();
    if (!absolute.has_filename())  // "out/"
        absolute = absolute.parent_path();
    fs::create_directories(absolute.parent_path(), error);
    if (error)
        return refused(target, error);
    std::string workspace = (absolute.parent_path() / ".afterglow-XXXXXX").string();
    if (!::mkdtemp(workspace.data()))
        return refused(target, std::error_code(errno, std::generic_category()));
    AtomicFolder made(std::move(absolute), std::move(workspace));
    if (!fs::create_directory(made.path(), error))  // with the usual permissions
        return refused(target, error);
    return made;
}

AtomicFolder::AtomicFolder(fs::path target, fs::path workspace)
    : m_target(std::move(target)), m_workspace(std::move(workspace)) {}

AtomicFolder::AtomicFolder(AtomicFolder&& other) noexcept
    : m_target(std::move(other.m_target)), m_workspace(std::exchange(other.m_workspace, {})) {}

AtomicFolder::~AtomicFolder() {
    std::error_code ignored;
    if (!m_workspace.empty())
        fs::remove_all(m_workspace, ignored);
}

fs::path AtomicFolder::path() const {
    return m_workspace / "new";
}

Result<void> AtomicFolder::finish() {
    std::error_code error;
    const fs::path old = m_workspace / "old";
    const bool replaces = fs::exists(fs::symlink_status(m_target, error));
    if (replaces)
        fs::rename(m_target, old, error);
    else
        error.clear();
    if (error)
        return refused(m_target, error);
    fs::rename(path(), m_target, error);
    if (!error)
        return {};
    std::error_code ignored;
    if (replaces)
        fs::rename(old, m_target, ignored);
    return refused(m_target, error);
}

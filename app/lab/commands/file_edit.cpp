#include "lab/commands/file_edit.h"

#include "base/file.h"
#include "io/files/atomic_file.h"
#include "io/files/trash.h"

#include <algorithm>

namespace fs = std::filesystem;

namespace {
Result<void> check_unchanged(const FileChange& change) {
    std::error_code error;
    const bool exists = fs::exists(fs::symlink_status(change.file, error));
    if (!change.before)
        return exists ? fail({change.file, 0, "already exists and was not replaced"})
                      : Result<void>();
    if (!exists)
        return fail({change.file, 0, "was deleted by another program"});
    const auto bytes = read_bytes(change.file);
    if (!bytes)
        return fail(bytes.error());
    if (*bytes != *change.before)
        return fail({change.file, 0, "was changed by another program and was not replaced"});
    return {};
}

Result<void> write(const FileChange& change) {
    if (change.after)
        return write_atomically(change.file, *change.after);
    const auto trashed = move_to_trash(change.file);
    return trashed ? Result<void>() : fail(trashed.error());
}

FileChange reversed(const FileChange& change) {
    return {change.file, change.after, change.before};
}
}  // namespace

FileEdit reversed(const FileEdit& edit) {
    FileEdit back;
    for (auto change = edit.rbegin(); change != edit.rend(); ++change)
        back.push_back(reversed(*change));
    return back;
}

Result<void> apply(const FileEdit& edit) {
    for (const FileChange& change : edit)
        if (auto unchanged = check_unchanged(change); !unchanged)
            return unchanged;
    for (std::size_t i = 0; i < edit.size(); ++i) {
        auto written = write(edit[i]);
        if (written)
            continue;
        // The files written so far are restored; a failure here leaves the first one to report.
        for (std::size_t back = i; back > 0; --back)
            (void)write(reversed(edit[back - 1]));
        return written;
    }
    return {};
}

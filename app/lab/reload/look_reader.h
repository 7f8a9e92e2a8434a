#pragma once

#include "formats/look_format.h"
#include "glsl/cache/check_cache.h"
#include "glsl/text/shader_files.h"
#include "io/system/file_status.h"
#include "lab/reload/job_queue.h"

#include <mutex>

/// Reads looks on the worker thread, without GL. Unchanged stages are not checked again.
class LookReader {
public:
    /// `store` keeps results of checks between runs; null: in memory only.
    LookReader(const Roots& roots, ByteStore* store)
        : m_includes(roots.include_folders()), m_checks(store, roots.shader_limits) {}

    /// From the next reading on. On any thread.
    void set_include_folders(IncludeFolders folders);
    LoadedLook read(const Job& job);

private:
    std::mutex m_mutex;
    IncludeFolders m_includes;
    CheckCache m_checks;
    ShaderFiles m_shader_files{read_file_stamp};
};

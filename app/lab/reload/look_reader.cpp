#include "lab/reload/look_reader.h"

#include "formats/stack/stack_format.h"

void LookReader::set_include_folders(IncludeFolders folders) {
    const std::lock_guard lock(m_mutex);
    m_includes = std::move(folders);
}

LoadedLook LookReader::read(const Job& job) {
    m_checks.set_keeping(job.kind == JobKind::look);
    m_shader_files.begin_reading();
    std::unique_lock lock(m_mutex);
    const IncludeFolders includes = m_includes;
    lock.unlock();
    const Values values = values_of(job.request);
    return load_stack(stack_of(job.request), includes,
                      {&m_checks, job.progress.get(), &values, &m_shader_files});
}

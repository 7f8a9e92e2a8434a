#include "lab/files/folder_reader.h"

void FolderReader::start(const FolderRequest& wanted) {
    m_request = wanted;
    m_work.start([folder = wanted.folder,
                  extensions = wanted.extensions](JobProgress& work) -> Result<FolderListing> {
        return list_folder(folder, extensions, &work);
    });
}

void FolderReader::select_rows(const FileFilter& filter) {
    m_filter = filter;
    m_rows = file_rows(m_listing, filter);
}

void FolderReader::update(const std::optional<FolderRequest>& wanted) {
    if (!wanted) {
        m_work.cancel();
        m_work.update();
        m_request.reset();
        m_listing = {};
        m_rows.clear();
        return;
    }
    const bool is_other = !m_request || m_request->folder != wanted->folder ||
                          m_request->extensions != wanted->extensions;
    if (is_other)
        start(*wanted);
    const bool was_reading = is_reading();
    m_work.update();
    const bool has_read = was_reading && !is_reading() && m_work.outcome();
    if (has_read)
        m_listing = **m_work.outcome();
    if (has_read || (!is_reading() && m_filter != wanted->filter))
        select_rows(wanted->filter);
}

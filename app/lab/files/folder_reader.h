#pragma once

#include "lab/files/file_rows.h"
#include "lab/storage/background_work.h"

#include <optional>

/// The folder that a dialog shows.
struct FolderRequest {
    std::filesystem::path folder;
    std::vector<std::string> extensions = {};  // as for list_folder()
    FileFilter filter = {};
};

/// Reads the folder of the file dialog on another thread, so that large folders and slow drives do
/// not stop the picture.
class FolderReader {
public:
    /// Call it in every update. nullopt: no dialog needs a folder.
    void update(const std::optional<FolderRequest>& wanted);

    /// Whether the wanted folder has not been read yet. rows() then belong to the previous one.
    bool is_reading() const { return m_work.is_running(); }
    const FolderListing& listing() const { return m_listing; }
    /// The listed entries, filtered and sorted.
    const std::vector<FolderEntry>& rows() const { return m_rows; }

private:
    void start(const FolderRequest& wanted);
    void select_rows(const FileFilter& filter);

    BackgroundWork<FolderListing> m_work;
    std::optional<FolderRequest> m_request;  // that is being read or was read
    FolderListing m_listing;
    FileFilter m_filter;
    std::vector<FolderEntry> m_rows;
};

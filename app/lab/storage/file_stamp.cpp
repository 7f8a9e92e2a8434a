#include "lab/storage/file_stamp.h"

#include "io/pictures/picture_sequence.h"

namespace fs = std::filesystem;

std::string stamp_text(const fs::path& file) {
    std::error_code error;
    const bool is_sequence = is_sequence_name(file);
    const auto size = is_sequence ? 0 : fs::file_size(file, error);
    const fs::path written = is_sequence ? fs::absolute(file, error).parent_path() : file;
    const auto time = fs::last_write_time(written, error).time_since_epoch().count();
    return error ? std::string() : std::to_string(size) + " " + std::to_string(time);
}

std::string stamp_text(const std::vector<fs::path>& files) {
    std::string all;
    for (const fs::path& file : files)
        all += file.string() + ' ' + stamp_text(file) + '\n';
    return all;
}

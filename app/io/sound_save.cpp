#include "io/sound_save.h"

#include "base/text.h"
#include "io/atomic_file.h"

#include <fmt/format.h>
#include <sndfile.h>

#include <algorithm>
#include <cstring>
#include <string>

namespace {
/// A file in memory, as libsndfile writes one.
struct MemoryFile {
    std::string bytes;
    std::size_t place = 0;
};

MemoryFile& file_of(void* user) {
    return *static_cast<MemoryFile*>(user);
}

sf_count_t length(void* user) {
    return static_cast<sf_count_t>(file_of(user).bytes.size());
}

sf_count_t seek(sf_count_t offset, int whence, void* user) {
    MemoryFile& file = file_of(user);
    const sf_count_t from = whence == SEEK_SET   ? 0
                            : whence == SEEK_CUR ? static_cast<sf_count_t>(file.place)
                                                 : length(user);
    file.place = static_cast<std::size_t>(std::max<sf_count_t>(from + offset, 0));
    return static_cast<sf_count_t>(file.place);
}

sf_count_t read(void* to, sf_count_t count, void* user) {
    MemoryFile& file = file_of(user);
    const std::size_t there = file.bytes.size() - std::min(file.place, file.bytes.size());
    const std::size_t got = std::min(static_cast<std::size_t>(count), there);
    std::memcpy(to, file.bytes.data() + std::min(file.place, file.bytes.size()), got);
    file.place += got;
    return static_cast<sf_count_t>(got);
}

sf_count_t write(const void* from, sf_count_t count, void* user) {
    MemoryFile& file = file_of(user);
    const auto size = static_cast<std::size_t>(count);
    file.bytes.resize(std::max(file.bytes.size(), file.place + size));
    std::memcpy(file.bytes.data() + file.place, from, size);
    file.place += size;
    return count;
}

sf_count_t tell(void* user) {
    return static_cast<sf_count_t>(file_of(user).place);
}

int format_of(const std::filesystem::path& file) {
    const std::string extension = to_lower(file.extension().string());
    if (extension == ".wav")
        return SF_FORMAT_WAV | SF_FORMAT_FLOAT;
    return extension == ".flac" ? SF_FORMAT_FLAC | SF_FORMAT_PCM_24 : 0;
}
}  // namespace

Result<void> save_sound(const Sound& sound, const std::filesystem::path& file) {
    SF_INFO info{};
    info.samplerate = sound.rate;
    info.channels = sound.channels;
    info.format = format_of(file);
    if (info.format == 0)
        return fail({file, 0, "a sound is written as .wav or .flac"});
    SF_VIRTUAL_IO memory{length, seek, read, write, tell};
    MemoryFile bytes;
    SNDFILE* const target = sf_open_virtual(&memory, SFM_WRITE, &info, &bytes);
    if (!target)
        return fail({file, 0, fmt::format("cannot be written: {}", sf_strerror(nullptr))});
    // Without the chunk of peaks, which holds the time of writing.
    sf_command(target, SFC_SET_ADD_PEAK_CHUNK, nullptr, SF_FALSE);
    sf_command(target, SFC_SET_CLIPPING, nullptr, SF_TRUE);
    const auto frames = static_cast<sf_count_t>(sound.frame_count());
    const sf_count_t written = sf_writef_float(target, sound.samples.data(), frames);
    const bool is_closed = sf_close(target) == 0;
    if (written != frames || !is_closed)
        return fail({file, 0, "cannot be written as a sound of this rate and these channels"});
    return write_atomically(file, bytes.bytes);
}

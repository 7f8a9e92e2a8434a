#include "io/sound/sound_save.h"

#include "base/text.h"
#include "io/files/atomic_file.h"
#include "io/files/memory_file.h"

#include <fmt/format.h>
#include <sndfile.h>

namespace {
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
        return fail({file, 0, "can't save the sound: the file name must end in .wav or .flac"});
    SF_VIRTUAL_IO memory = memory_file_calls();
    MemoryFile bytes;
    SNDFILE* const target = sf_open_virtual(&memory, SFM_WRITE, &info, &bytes);
    if (!target)
        return fail({file, 0, fmt::format("can't write the sound: {}", sf_strerror(nullptr))});
    // Without the peak chunk, which contains the time of writing.
    sf_command(target, SFC_SET_ADD_PEAK_CHUNK, nullptr, SF_FALSE);
    sf_command(target, SFC_SET_CLIPPING, nullptr, SF_TRUE);
    const auto frames = static_cast<sf_count_t>(sound.frame_count());
    const sf_count_t written = sf_writef_float(target, sound.samples.data(), frames);
    const bool is_closed = sf_close(target) == 0;
    if (written != frames || !is_closed)
        return fail({file, 0, "can't write a sound with this sample rate and number of channels"});
    return write_atomically(file, bytes.bytes);
}

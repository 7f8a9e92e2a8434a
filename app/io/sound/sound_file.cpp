#include "io/sound/sound_file.h"

#include "base/file.h"
#include "base/text.h"
#include "io/files/memory_file.h"
#include "io/system/descriptor.h"

#include <fmt/format.h>
#include <sndfile.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <new>

namespace {
constexpr int max_channels = 32;
constexpr int max_rate = 768000;

struct CloseFile {
    void operator()(SNDFILE* file) const { sf_close(file); }
};
using SoundFile = std::unique_ptr<SNDFILE, CloseFile>;

Result<void> check(const std::filesystem::path& file, const SF_INFO& info) {
    if (info.samplerate <= 0 || info.samplerate > max_rate)
        return fail({file, 0,
                     fmt::format("the sample rate must be between 1 and {} Hz, got {} Hz", max_rate,
                                 info.samplerate)});
    if (info.channels <= 0 || info.channels > max_channels)
        return fail({file, 0,
                     fmt::format("the number of channels must be between 1 and {}, got {}",
                                 max_channels, info.channels)});
    return {};
}

// A float file may contain any value. Values far beyond full scale can't be heard or seen.
float sane(float sample) {
    constexpr float maximum = 1000.0f;
    if (std::isnan(sample))
        return 0.0f;
    return std::min(std::max(sample, -maximum), maximum);
}

// Reads block by block to the end, because the length in a header is not reliable. `claimed` is
// only used for progress.
Result<void> read_samples(const std::filesystem::path& file, SNDFILE* source, double claimed,
                          Sound& sound, JobProgress* work) {
    std::array<float, 8192> block;
    const auto channels = static_cast<std::size_t>(sound.channels);
    const auto frames = static_cast<sf_count_t>(block.size() / channels);
    const std::size_t longest =
        std::size_t{max_sound_seconds} * static_cast<std::size_t>(sound.rate) * channels;
    for (;;) {
        const sf_count_t got = sf_readf_float(source, block.data(), frames);
        if (got <= 0)
            return {};
        const auto count = static_cast<std::size_t>(got) * channels;
        if (sound.samples.size() + count > longest)
            return fail({file, 0, "the sound is too long; the limit is 1 hour"});
        if (sound.samples.size() + count > max_sound_samples)
            return fail({file, 0, "the sound needs too much memory; the limit is 2 GiB"});
        for (std::size_t i = 0; i < count; ++i)
            sound.samples.push_back(sane(block[i]));
        if (!work)
            continue;
        if (work->is_cancelled)
            return fail({file, 0, "reading was cancelled"});
        const auto done = static_cast<double>(sound.frame_count());
        work->share = claimed > 0.0 ? std::min(done / claimed, 1.0) : 0.0;
    }
}
// libsndfile reduces the announced length of a WAV or AIFF file to the actual length. It reports
// this only in its log: "data : 320000 (should be 99956)". A header that was written before the
// length was known has no length, or the largest number.
double announced_share(std::string_view log) {
    constexpr double unknown = 2147483647.0;
    for (const std::string_view line : split_lines(log)) {
        const bool is_data = line.starts_with("data :") || line.starts_with(" SSND :");
        const auto mark = line.find("(should be ");
        if (!is_data || mark == std::string_view::npos)
            continue;
        const auto start = line.find(':') + 1;
        const auto announced = parse_number(trim(line.substr(start, mark - start)));
        const std::string_view rest = line.substr(mark + std::strlen("(should be "));
        const auto there = parse_number(rest.substr(0, rest.find(')')));
        if (announced && there && *there > 0.0 && *announced > *there && *announced < unknown)
            return *announced / *there;
    }
    return 1.0;
}

// A warning with the announced and actual length of a truncated file; nullopt if complete.
std::optional<Diagnostic> find_break(const std::filesystem::path& file, SNDFILE* source,
                                     sf_count_t announced, const Sound& sound) {
    std::array<char, 16384> text{};
    sf_command(source, SFC_GET_LOG_INFO, text.data(), static_cast<int>(text.size()) - 1);
    const std::string_view log(text.data());
    const auto read = static_cast<double>(sound.frame_count());
    const auto note = [&file](std::string message) {
        return Diagnostic{file, 0, std::move(message), Severity::warning};
    };
    constexpr double slack = 1.01;  // encoders pad
    if (announced == SF_COUNT_MAX)  // an OGG file, whose length is in its last page
        return note(fmt::format("the file ends early: only {:.2f} s were read", sound.seconds()));
    const double whole =
        std::max(static_cast<double>(announced), read * announced_share(log)) / sound.rate;
    if (whole > slack * sound.seconds())
        return note(fmt::format("the file ends early: only {:.2f} of {:.2f} s were read",
                                sound.seconds(), whole));
    return std::nullopt;
}
// The data offset of a WAV without a length in its header, as left by programs that crash while
// recording. Its data length is 0, and sound without further chunks follows. nullopt for other
// files.
std::optional<std::size_t> unfinished_data(std::string_view wav) {
    constexpr std::size_t head = 8;  // of a chunk: its name and length
    if (!wav.starts_with("RIFF") || wav.substr(head, 4) != "WAVE")
        return std::nullopt;
    const auto length_at = [&](std::size_t at) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i)
            length |= std::size_t{static_cast<unsigned char>(wav[at + 4 + i])} << (8 * i);
        return length;
    };
    std::optional<std::size_t> data;
    std::size_t at = 12;
    while (at + head <= wav.size()) {
        const std::size_t length = length_at(at);
        if (!data && wav.substr(at, 4) == "data" && length == 0)
            data = at + head;
        at += head + length + length % 2;
    }
    const bool has_chunks_behind = at == wav.size() && data != wav.size();
    return data && *data < wav.size() && !has_chunks_behind ? data : std::nullopt;
}

std::string with_length(std::string wav, std::size_t data) {
    const auto write = [&](std::size_t at, std::size_t length) {
        for (std::size_t i = 0; i < 4; ++i)
            wav[at + i] = static_cast<char>(length >> (8 * i) & 0xffu);
    };
    write(4, wav.size() - 8);
    write(data - 4, wav.size() - data);
    return wav;
}

// The sound of such a WAV; nullopt for other files or on an error.
std::optional<Sound> load_unfinished_wav(const std::filesystem::path& file, JobProgress* work) {
    const auto bytes = read_bytes(file);
    const auto data = bytes ? unfinished_data(*bytes) : std::nullopt;
    if (!data)
        return std::nullopt;
    MemoryFile memory{with_length(*bytes, *data)};
    SF_VIRTUAL_IO reader = memory_file_calls();
    SF_INFO info{};
    const SoundFile source(sf_open_virtual(&reader, SFM_READ, &info, &memory));
    if (!source || !check(file, info))
        return std::nullopt;
    Sound sound{.rate = info.samplerate, .channels = info.channels, .samples = {}};
    if (!read_samples(file, source.get(), static_cast<double>(info.frames), sound, work) ||
        sound.samples.empty())
        return std::nullopt;
    return sound;
}
}  // namespace

Result<Sound> load_sound(const std::filesystem::path& file, JobProgress* work, Diagnostics* notes) {
    // Also checks that it is a regular file; opening a pipe would block forever.
    const auto start = read_start(file, 1);
    if (!start)
        return fail(start.error());
    if (start->empty())
        return fail({file, 0, "the file is empty"});

    // By content only: with a name, libsndfile takes any file called .mp3 for MPEG frames, and its
    // decoder prints errors to stderr.
    const Descriptor descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
    SF_INFO info{};
    const SoundFile source(sf_open_fd(descriptor.get(), SFM_READ, &info, SF_FALSE));
    if (!source)
        return fail({file, 0, fmt::format("can't read the sound: {}", sf_strerror(nullptr))});
    if (const auto good = check(file, info); !good)
        return fail(good.error());

    Sound sound{.rate = info.samplerate, .channels = info.channels, .samples = {}};
    try {
        const auto claimed = static_cast<double>(info.frames);
        if (const auto read = read_samples(file, source.get(), claimed, sound, work); !read)
            return fail(read.error());
    } catch (const std::bad_alloc&) {
        return fail({file, 0, "not enough memory for this sound"});
    }
    if (sound.samples.empty()) {
        auto unfinished = load_unfinished_wav(file, work);
        if (!unfinished)
            return fail({file, 0, "the file has a header but no sound data"});
        if (notes)
            notes->push_back({file, 0,
                              fmt::format("the recording is unfinished: its header has no length. "
                                          "{:.2f} s were read.",
                                          unfinished->seconds()),
                              Severity::warning});
        return std::move(*unfinished);
    }
    if (const auto broken = find_break(file, source.get(), info.frames, sound); broken && notes)
        notes->push_back(*broken);
    return sound;
}

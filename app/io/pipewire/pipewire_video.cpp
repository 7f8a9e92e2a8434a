#include "io/pipewire/pipewire_video.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fcntl.h>
#include <mutex>
#include <pipewire/pipewire.h>
#include <spa/param/video/format-utils.h>
#include <system_error>
#include <utility>

namespace {
constexpr std::size_t channels = 4;

// A parameter of the stream, built in memory of its own.
class Pod {
public:
    template <typename Build>
    explicit Pod(Build build) {
        spa_pod_builder builder{};
        builder.data = m_memory.data();
        builder.size = static_cast<std::uint32_t>(m_memory.size());
        m_pod = build(builder);
    }

    const spa_pod* get() const { return m_pod; }

private:
    std::array<std::uint8_t, 1024> m_memory{};
    const spa_pod* m_pod = nullptr;
};

// Adds the properties of a format that both directions state.
void begin_format(spa_pod_builder& builder, spa_pod_frame& frame) {
    spa_pod_builder_push_object(&builder, &frame, SPA_TYPE_OBJECT_Format, SPA_PARAM_EnumFormat);
    spa_pod_builder_prop(&builder, SPA_FORMAT_mediaType, 0);
    spa_pod_builder_id(&builder, SPA_MEDIA_TYPE_video);
    spa_pod_builder_prop(&builder, SPA_FORMAT_mediaSubtype, 0);
    spa_pod_builder_id(&builder, SPA_MEDIA_SUBTYPE_raw);
    spa_pod_builder_prop(&builder, SPA_FORMAT_VIDEO_format, 0);
}

const spa_pod* end(spa_pod_builder& builder, spa_pod_frame& frame) {
    return static_cast<const spa_pod*>(spa_pod_builder_pop(&builder, &frame));
}

std::uint32_t size_of(int pixels) {
    return static_cast<std::uint32_t>(pixels);
}

// One size and rate.
Pod offered_format(Extent extent, FrameRateFraction rate) {
    return Pod([&](spa_pod_builder& builder) {
        spa_pod_frame frame{};
        begin_format(builder, frame);
        spa_pod_builder_id(&builder, SPA_VIDEO_FORMAT_BGRx);
        spa_pod_builder_prop(&builder, SPA_FORMAT_VIDEO_size, 0);
        spa_pod_builder_rectangle(&builder, size_of(extent.width), size_of(extent.height));
        spa_pod_builder_prop(&builder, SPA_FORMAT_VIDEO_framerate, 0);
        spa_pod_builder_fraction(&builder, static_cast<std::uint32_t>(rate.above),
                                 static_cast<std::uint32_t>(rate.below));
        return end(builder, frame);
    });
}

// Every size and rate, in the first of these formats that the sender has.
Pod accepted_formats() {
    return Pod([](spa_pod_builder& builder) {
        constexpr std::array formats{SPA_VIDEO_FORMAT_BGRx, SPA_VIDEO_FORMAT_BGRx,
                                     SPA_VIDEO_FORMAT_BGRA, SPA_VIDEO_FORMAT_RGBx,
                                     SPA_VIDEO_FORMAT_RGBA};
        constexpr std::uint32_t longest_side = 16384;
        constexpr std::uint32_t highest_rate = 1000;
        spa_pod_frame frame{};
        spa_pod_frame choice{};
        begin_format(builder, frame);
        spa_pod_builder_push_choice(&builder, &choice, SPA_CHOICE_Enum, 0);
        for (const auto format : formats)  // the first one is the default
            spa_pod_builder_id(&builder, format);
        spa_pod_builder_pop(&builder, &choice);
        spa_pod_builder_prop(&builder, SPA_FORMAT_VIDEO_size, 0);
        spa_pod_builder_push_choice(&builder, &choice, SPA_CHOICE_Range, 0);
        spa_pod_builder_rectangle(&builder, 1920, 1080);  // the default, then the limits
        spa_pod_builder_rectangle(&builder, 1, 1);
        spa_pod_builder_rectangle(&builder, longest_side, longest_side);
        spa_pod_builder_pop(&builder, &choice);
        spa_pod_builder_prop(&builder, SPA_FORMAT_VIDEO_framerate, 0);
        spa_pod_builder_push_choice(&builder, &choice, SPA_CHOICE_Range, 0);
        spa_pod_builder_fraction(&builder, 60, 1);
        spa_pod_builder_fraction(&builder, 0, 1);  // no constant rate
        spa_pod_builder_fraction(&builder, highest_rate, 1);
        spa_pod_builder_pop(&builder, &choice);
        return end(builder, frame);
    });
}

// Memory that both programs can map. A sender decides about its size.
Pod buffers_for(Extent extent, bool is_offered) {
    return Pod([&](spa_pod_builder& builder) {
        spa_pod_frame frame{};
        spa_pod_frame choice{};
        spa_pod_builder_push_object(&builder, &frame, SPA_TYPE_OBJECT_ParamBuffers,
                                    SPA_PARAM_Buffers);
        if (is_offered) {
            const int stride = extent.width * static_cast<int>(channels);
            spa_pod_builder_prop(&builder, SPA_PARAM_BUFFERS_blocks, 0);
            spa_pod_builder_int(&builder, 1);
            spa_pod_builder_prop(&builder, SPA_PARAM_BUFFERS_size, 0);
            spa_pod_builder_int(&builder, stride * extent.height);
            spa_pod_builder_prop(&builder, SPA_PARAM_BUFFERS_stride, 0);
            spa_pod_builder_int(&builder, stride);
        }
        spa_pod_builder_prop(&builder, SPA_PARAM_BUFFERS_dataType, 0);
        spa_pod_builder_push_choice(&builder, &choice, SPA_CHOICE_Flags, 0);
        spa_pod_builder_int(&builder, is_offered ? (1 << SPA_DATA_MemFd)
                                                 : (1 << SPA_DATA_MemFd) | (1 << SPA_DATA_MemPtr));
        spa_pod_builder_pop(&builder, &choice);
        return end(builder, frame);
    });
}

// Asks for the part of the picture that a captured window covers.
Pod crop_request() {
    return Pod([](spa_pod_builder& builder) {
        spa_pod_frame frame{};
        spa_pod_builder_push_object(&builder, &frame, SPA_TYPE_OBJECT_ParamMeta, SPA_PARAM_Meta);
        spa_pod_builder_prop(&builder, SPA_PARAM_META_type, 0);
        spa_pod_builder_id(&builder, SPA_META_VideoCrop);
        spa_pod_builder_prop(&builder, SPA_PARAM_META_size, 0);
        spa_pod_builder_int(&builder, sizeof(spa_meta_region));
        return end(builder, frame);
    });
}

struct Part {
    std::size_t x = 0;
    std::size_t y = 0;
    Extent extent;
};

// Of the whole picture; an invalid part counts as none.
Part cropped_part(const spa_buffer& buffer, Extent extent) {
    const auto* const meta = static_cast<const spa_meta_region*>(
        spa_buffer_find_meta_data(&buffer, SPA_META_VideoCrop, sizeof(spa_meta_region)));
    const Part all{0, 0, extent};
    if (!meta || !spa_meta_region_is_valid(meta))
        return all;
    const spa_region& region = meta->region;
    const bool fits = region.position.x >= 0 && region.position.y >= 0 &&
                      std::int64_t{region.position.x} + region.size.width <= extent.width &&
                      std::int64_t{region.position.y} + region.size.height <= extent.height;
    if (!fits)
        return all;
    return {static_cast<std::size_t>(region.position.x),
            static_cast<std::size_t>(region.position.y),
            {static_cast<int>(region.size.width), static_cast<int>(region.size.height)}};
}

tl::unexpected<Diagnostics> no_server() {
    return fail({{},
                 0,
                 fmt::format("no PipeWire server answers ({}). Install the packages pipewire and "
                             "wireplumber, and log in again.",
                             std::generic_category().message(errno))});
}
}  // namespace

/// Owns the connection and the stream. PipeWire keeps its address.
class PipeWireVideo::Stream {
public:
    Stream(Process process, bool is_offered)
        : m_process(std::move(process)), m_is_offered(is_offered) {
        static std::once_flag once;
        std::call_once(once, [] { pw_init(nullptr, nullptr); });
    }

    ~Stream() {
        if (m_loop)
            pw_thread_loop_stop(m_loop);
        if (m_stream)
            pw_stream_destroy(m_stream);
        if (m_core)
            pw_core_disconnect(m_core);
        if (m_context)
            pw_context_destroy(m_context);
        if (m_loop)
            pw_thread_loop_destroy(m_loop);
    }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;

    Result<void> connect(const Descriptor& socket) {
        m_loop = pw_thread_loop_new("pipewire", nullptr);
        if (!m_loop)
            return no_server();
        m_context = pw_context_new(pw_thread_loop_get_loop(m_loop), nullptr, 0);
        if (!m_context || pw_thread_loop_start(m_loop) != 0)
            return no_server();
        const Lock lock(m_loop);
        // PipeWire closes its own copy of the socket.
        m_core = socket.is_open()
                     ? pw_context_connect_fd(m_context, fcntl(socket.get(), F_DUPFD_CLOEXEC, 0),
                                             nullptr, 0)
                     : pw_context_connect(m_context, nullptr, 0);
        return m_core ? Result<void>{} : no_server();
    }

    Result<void> open(const std::string& name, pw_properties* properties, std::uint32_t node,
                      const Pod& format) {
        const Lock lock(m_loop);
        m_stream = pw_stream_new(m_core, name.c_str(), properties);
        if (!m_stream)
            return no_server();
        pw_stream_add_listener(m_stream, &m_hook, &events(), this);
        const spa_pod* parameter = format.get();
        const unsigned flags = PW_STREAM_FLAG_MAP_BUFFERS |
                               (m_is_offered ? PW_STREAM_FLAG_DRIVER : PW_STREAM_FLAG_AUTOCONNECT);
        const int result =
            pw_stream_connect(m_stream, m_is_offered ? PW_DIRECTION_OUTPUT : PW_DIRECTION_INPUT,
                              node, static_cast<pw_stream_flags>(flags), &parameter, 1);
        if (result < 0) {
            errno = -result;
            return no_server();
        }
        return {};
    }

    bool is_streaming() const {
        const Lock lock(m_loop);
        return m_state == PW_STREAM_STATE_STREAMING;
    }

    std::string problem() const {
        const Lock lock(m_loop);
        return m_problem;
    }

    void send() {
        const Lock lock(m_loop);
        if (m_state == PW_STREAM_STATE_STREAMING)
            pw_stream_trigger_process(m_stream);
    }

private:
    class Lock {
    public:
        explicit Lock(pw_thread_loop* loop) : m_loop(loop) { pw_thread_loop_lock(m_loop); }
        ~Lock() { pw_thread_loop_unlock(m_loop); }
        Lock(const Lock&) = delete;
        Lock& operator=(const Lock&) = delete;

    private:
        pw_thread_loop* m_loop;
    };

    static const pw_stream_events& events() {
        static const pw_stream_events table = [] {
            pw_stream_events made{};
            made.version = PW_VERSION_STREAM_EVENTS;
            made.state_changed = [](void* stream, pw_stream_state, pw_stream_state state,
                                    const char* error) {
                static_cast<Stream*>(stream)->change_state(state, error);
            };
            made.param_changed = [](void* stream, std::uint32_t id, const spa_pod* parameter) {
                if (parameter && id == SPA_PARAM_Format)
                    static_cast<Stream*>(stream)->take_format(*parameter);
            };
            made.process = [](void* stream) { static_cast<Stream*>(stream)->process(); };
            return made;
        }();
        return table;
    }

    void change_state(pw_stream_state state, const char* error) {
        const auto before = std::exchange(m_state, state);
        if (state == PW_STREAM_STATE_ERROR)
            m_problem = fmt::format("PipeWire has ended the video: {}. Open it again.",
                                    error ? error : "no reason given");
        else if (state == PW_STREAM_STATE_UNCONNECTED && before != PW_STREAM_STATE_UNCONNECTED)
            m_problem = "the PipeWire server has ended. Open the video again.";
        else if (before == PW_STREAM_STATE_STREAMING && m_is_offered)
            pw_stream_flush(m_stream, false);  // the next reader must not see an old picture
        else if (state == PW_STREAM_STATE_STREAMING && m_is_offered)
            pw_stream_trigger_process(m_stream);  // a new reader sees the present picture
    }

    void take_format(const spa_pod& parameter) {
        spa_video_info_raw format{};
        if (spa_format_video_raw_parse(&parameter, &format) < 0)
            return;
        m_extent = {static_cast<int>(format.size.width), static_cast<int>(format.size.height)};
        m_is_rgb = format.format == SPA_VIDEO_FORMAT_RGBx || format.format == SPA_VIDEO_FORMAT_RGBA;
        const Pod buffers = buffers_for(m_extent, m_is_offered);
        const Pod crop = crop_request();
        std::array parameters{buffers.get(), crop.get()};
        pw_stream_update_params(m_stream, parameters.data(), m_is_offered ? 1 : 2);
    }

    void process() {
        pw_buffer* newest = nullptr;
        while (pw_buffer* const buffer = pw_stream_dequeue_buffer(m_stream)) {
            if (newest)
                pw_stream_queue_buffer(m_stream, newest);
            newest = buffer;
            if (m_is_offered)
                break;
        }
        if (!newest)
            return;
        m_is_offered ? fill(*newest->buffer) : read(*newest->buffer);
        pw_stream_queue_buffer(m_stream, newest);
    }

    void fill(spa_buffer& buffer) {
        spa_data& data = buffer.datas[0];
        const std::size_t stride = static_cast<std::size_t>(m_extent.width) * channels;
        const std::size_t size = stride * static_cast<std::size_t>(m_extent.height);
        if (!data.data || data.maxsize < size)
            return;
        m_process({{static_cast<std::uint8_t*>(data.data), size}, stride, m_extent, m_is_rgb});
        data.chunk->offset = 0;
        data.chunk->size = static_cast<std::uint32_t>(size);
        data.chunk->stride = static_cast<std::int32_t>(stride);
    }

    // A buffer without a picture only moves the pointer.
    void read(const spa_buffer& buffer) {
        const spa_data& data = buffer.datas[0];
        const bool is_corrupted = (data.chunk->flags & SPA_CHUNK_FLAG_CORRUPTED) != 0;
        if (!data.data || data.chunk->size == 0 || data.chunk->stride < 0 || is_corrupted)
            return;
        const Part part = cropped_part(buffer, m_extent);
        const std::size_t stride = data.chunk->stride > 0
                                       ? static_cast<std::size_t>(data.chunk->stride)
                                       : static_cast<std::size_t>(m_extent.width) * channels;
        const std::size_t first = data.chunk->offset + part.y * stride + part.x * channels;
        const std::size_t size = stride * static_cast<std::size_t>(part.extent.height - 1) +
                                 static_cast<std::size_t>(part.extent.width) * channels;
        if (part.extent.is_empty() || first + size > data.maxsize)
            return;
        m_process(
            {{static_cast<std::uint8_t*>(data.data) + first, size}, stride, part.extent, m_is_rgb});
    }

    Process m_process;
    bool m_is_offered;
    pw_thread_loop* m_loop = nullptr;
    pw_context* m_context = nullptr;
    pw_core* m_core = nullptr;
    pw_stream* m_stream = nullptr;
    spa_hook m_hook{};
    pw_stream_state m_state = PW_STREAM_STATE_UNCONNECTED;
    std::string m_problem;
    Extent m_extent;  // as negotiated
    bool m_is_rgb = false;
};

PipeWireVideo::PipeWireVideo(std::unique_ptr<Stream> stream) : m_stream(std::move(stream)) {}
PipeWireVideo::~PipeWireVideo() = default;

Result<std::unique_ptr<PipeWireVideo>> PipeWireVideo::offer(const std::string& name, Extent extent,
                                                            FrameRateFraction rate,
                                                            Process process) {
    auto stream = std::make_unique<Stream>(std::move(process), true);
    if (auto connected = stream->connect(Descriptor()); !connected)
        return fail(connected.error());
    pw_properties* const properties = pw_properties_new(
        PW_KEY_MEDIA_TYPE, "Video", PW_KEY_MEDIA_CATEGORY, "Playback", PW_KEY_MEDIA_ROLE, "Camera",
        PW_KEY_MEDIA_CLASS, "Video/Source", PW_KEY_NODE_NAME, name.c_str(), PW_KEY_NODE_DESCRIPTION,
        name.c_str(), nullptr);
    if (auto opened = stream->open(name, properties, PW_ID_ANY, offered_format(extent, rate));
        !opened)
        return fail(opened.error());
    return std::unique_ptr<PipeWireVideo>(new PipeWireVideo(std::move(stream)));
}

Result<std::unique_ptr<PipeWireVideo>> PipeWireVideo::read(const Descriptor& socket,
                                                           std::uint32_t node, Process process) {
    auto stream = std::make_unique<Stream>(std::move(process), false);
    if (auto connected = stream->connect(socket); !connected)
        return fail(connected.error());
    pw_properties* const properties =
        pw_properties_new(PW_KEY_MEDIA_TYPE, "Video", PW_KEY_MEDIA_CATEGORY, "Capture",
                          PW_KEY_MEDIA_ROLE, "Screen", PW_KEY_NODE_NAME, "Afterglow", nullptr);
    if (auto opened = stream->open("Afterglow", properties, node, accepted_formats()); !opened)
        return fail(opened.error());
    return std::unique_ptr<PipeWireVideo>(new PipeWireVideo(std::move(stream)));
}

bool PipeWireVideo::is_streaming() const {
    return m_stream->is_streaming();
}

std::string PipeWireVideo::problem() const {
    return m_stream->problem();
}

void PipeWireVideo::send() {
    m_stream->send();
}

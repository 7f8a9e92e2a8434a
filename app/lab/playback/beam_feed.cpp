#include "lab/playback/beam_feed.h"

#include "base/user_folders.h"
#include "io/system/private_folder.h"
#include "signals/beam/beam_input_format.h"
#include "signals/signal/settings.h"

#include <fmt/format.h>

namespace fs = std::filesystem;

namespace {
// Creates the user's private folder for sockets, without access for other users.
Result<void> make_runtime_folder(const fs::path& socket) {
    const fs::path folder = runtime_folder();
    if (socket.parent_path() != folder)
        return {};
    std::error_code error;
    fs::create_directories(folder.parent_path(), error);
    const PrivateFolder made = make_private_folder(folder);
    if (made == PrivateFolder::not_created)
        return fail(
            {folder, 0, "can't create the socket folder. Choose another path with socket:PATH."});
    if (made == PrivateFolder::not_private)
        return fail({folder, 0,
                     "other users can write to this folder, so no socket is created in it. Run "
                     "chmod 700 on it, or choose another path with socket:PATH."});
    return {};
}
}  // namespace

BeamFeed::BeamFeed(const Spec& complete, BeamInput::Pace pace, double start)
    : m_spec(complete),
      m_name(complete.kind == "stdin" ? std::string("stdin")
                                      : std::string(Settings(complete).word("path"))),
      m_pace(pace),
      m_beam(std::make_shared<BeamInput>(pace, start)) {}

Result<std::unique_ptr<BeamFeed>> BeamFeed::open(const Spec& complete, BeamInput::Pace pace,
                                                 double start) {
    std::unique_ptr<BeamFeed> feed(new BeamFeed(complete, pace, start));
    if (auto made = make_runtime_folder(feed->m_name); !made)
        return fail(made.error());
    // A rendered picture has exactly one sender. In the window, another one can follow.
    const auto senders = pace == BeamInput::Pace::waiting
                             ? ByteReader::Senders::one
                             : ByteReader::Senders::one_after_the_other;
    auto bytes = complete.kind == "stdin" ? ByteReader::read_stdin(*feed)
                                          : ByteReader::listen(feed->m_name, senders, *feed);
    if (!bytes)
        return fail(bytes.error());
    feed->m_bytes = std::move(*bytes);
    return feed;
}

BeamFeed::~BeamFeed() {
    m_beam->close();  // otherwise its thread may wait for the drawing
    m_bytes.reset();
}

void BeamFeed::begin() {
    m_reader.emplace(beam_input_format(Settings(m_spec)), m_name);
    m_has_drawn = false;
    const std::lock_guard lock(m_mutex);
    m_state = State::sending;
    m_problem.reset();
    m_bad_count = 0;
}

void BeamFeed::take(std::string_view bytes) {
    m_points.clear();
    m_reader->take(bytes, m_points);
    note();
    send();
}

void BeamFeed::send() {
    m_has_drawn = m_has_drawn || !m_points.empty();
    m_beam->append(m_points);
}

void BeamFeed::end() {
    m_points.clear();
    if (m_reader)
        m_reader->finish(m_points);
    note();
    send();
    {
        const std::lock_guard lock(m_mutex);
        m_state = State::ended;
        if (!m_has_drawn && !m_problem)
            m_problem = Diagnostic{m_name, 0, "ended without sending a point", Severity::warning};
    }
    if (m_pace == BeamInput::Pace::waiting)
        m_beam->end();
}

void BeamFeed::fail_with(const std::string& why) {
    const std::lock_guard lock(m_mutex);
    m_problem = Diagnostic{m_name, 0, fmt::format("can't read the beam: {}", why)};
}

void BeamFeed::note() {
    if (!m_reader || !m_reader->problem())
        return;
    const std::lock_guard lock(m_mutex);
    if (!m_problem)
        m_problem = m_reader->problem();
    m_bad_count = m_reader->bad_count();
}

Diagnostics BeamFeed::problems() const {
    const std::lock_guard lock(m_mutex);
    Diagnostics problems;
    if (m_problem)
        problems.push_back(*m_problem);
    if (m_beam->has_timed_out())
        problems.push_back({m_name, 0,
                            "sent no point before the timeout. Start the sender first, or raise "
                            "--timeout."});
    if (m_bad_count > 1)
        problems.push_back({m_name, 0,
                            beam_input_format(Settings(m_spec)).is_raw
                                ? fmt::format("skipped {} invalid points", m_bad_count)
                                : fmt::format("skipped {} invalid lines", m_bad_count),
                            Severity::warning});
    return problems;
}

std::string BeamFeed::complaint() const {
    if (const Diagnostics all = problems(); !all.empty())
        return to_string(all.front());
    const std::lock_guard lock(m_mutex);
    return m_state == State::ended ? fmt::format("\"{}\" stopped sending", m_name) : std::string();
}

std::string BeamFeed::state() const {
    const std::lock_guard lock(m_mutex);
    if (m_state == State::waiting)
        return m_spec.kind == "socket" ? fmt::format("Waiting for a program at {}", m_name)
                                       : std::string("Waiting for input");
    return m_state == State::sending ? fmt::format("Receiving from {}", m_name) : std::string();
}

#pragma once

#include "io/control/byte_reader.h"
#include "model/look/spec.h"
#include "signals/beam/sent_beam.h"

#include <memory>
#include <mutex>

/// The beam that another program sends through standard input or a socket, for as long as this
/// lives.
class BeamFeed : private ByteSink {
public:
    /// Of a completed spec; its first point comes after `start` seconds.
    static Result<std::unique_ptr<BeamFeed>> open(const Spec& complete, SentBeam::Pace pace,
                                                  double start);
    ~BeamFeed() override;

    const Spec& spec() const { return m_spec; }
    std::shared_ptr<SentBeam> beam() const { return m_beam; }
    /// What could not be read so far: the first of it, and how much in all.
    Diagnostics problems() const;
    /// The first problem in a line, or that the sender is gone; "" when all is well.
    std::string complaint() const;
    /// Whether it draws or waits, in words; "" where complaint() says more.
    std::string state() const;

private:
    BeamFeed(const Spec& complete, SentBeam::Pace pace, double start);

    void begin() override;
    void take(std::string_view bytes) override;
    void end() override;
    void fail_with(const std::string& why) override;
    void note();
    void send();

    enum class State { waiting, sending, ended };

    Spec m_spec;
    std::string m_name;  // as a person knows it
    SentBeam::Pace m_pace;
    std::shared_ptr<SentBeam> m_beam;  // shared with the signal that draws it
    std::optional<SentReader> m_reader;
    std::vector<SentPoint> m_points;
    bool m_has_drawn = false;    // the present sender
    mutable std::mutex m_mutex;  // for what follows
    std::optional<Diagnostic> m_problem;
    std::int64_t m_bad_count = 0;
    State m_state = State::waiting;
    std::unique_ptr<ByteReader> m_bytes;  // last: its thread uses the rest
};

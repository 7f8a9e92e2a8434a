#pragma once

#include "io/control/byte_reader.h"
#include "model/look/spec.h"
#include "signals/beam/beam_input.h"

#include <memory>
#include <mutex>

/// The beam from another program through standard input or a socket, during its lifetime.
class BeamFeed : private ByteSink {
public:
    /// From a completed spec; the first point is after `start` seconds.
    static Result<std::unique_ptr<BeamFeed>> open(const Spec& complete, BeamInput::Pace pace,
                                                  double start);
    ~BeamFeed() override;

    const Spec& spec() const { return m_spec; }
    std::shared_ptr<BeamInput> beam() const { return m_beam; }
    /// The first problem so far, and the number of invalid lines or points.
    Diagnostics problems() const;
    /// The first problem as one line, or that the sender has stopped; "": no problem.
    std::string complaint() const;
    /// A text for receiving or waiting; "": complaint() has the state.
    std::string state() const;

private:
    BeamFeed(const Spec& complete, BeamInput::Pace pace, double start);

    void begin() override;
    void take(std::string_view bytes) override;
    void end() override;
    void fail_with(const std::string& why) override;
    void note();
    void send();

    enum class State { waiting, sending, ended };

    Spec m_spec;
    std::string m_name;  // for display
    BeamInput::Pace m_pace;
    std::shared_ptr<BeamInput> m_beam;  // shared with the signal
    std::optional<BeamInputReader> m_reader;
    std::vector<BeamInputPoint> m_points;
    bool m_has_drawn = false;    // the current sender
    mutable std::mutex m_mutex;  // for the members below
    std::optional<Diagnostic> m_problem;
    std::int64_t m_bad_count = 0;
    State m_state = State::waiting;
    std::unique_ptr<ByteReader> m_bytes;  // last, because its thread uses the others
};

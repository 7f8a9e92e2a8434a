#pragma once

#include "base/diagnostic.h"
#include "lab/media/frame_stream.h"
#include "lab/media/live_stream.h"
#include "model/look/picture.h"
#include "model/picture/source_spec.h"

#include <memory>
#include <string>

class Executors;

/// How a live source is read.
enum class LiveReading {
    /// Its first picture must come. All pictures of a pipe are drawn; those of others at the time
    /// of
    /// the frame, which waits for it.
    complete,
    /// Its newest picture is drawn. If it is missing, a black picture, until it comes.
    newest,
};

/// The source picture of a look: a pattern, a file, a numbered sequence, a video or a live source.
class Source {
public:
    /// Opens the source of a text and reads its first picture.
    static Result<Source> open(const std::string& text, LiveReading live = LiveReading::complete);

    const SourceSpec& spec() const { return m_spec; }
    /// Changes the settings for the same picture.
    void set_spec(const SourceSpec& spec);
    /// Sets the encoding of the pictures; a film is converted on its reading thread.
    void expect(Encoding encoding);
    /// Whether it depends on time.
    bool moves() const { return is_film() || is_live() || m_is_moving_pattern; }
    /// Whether it is a window, screen, camera or pipe, so that past pictures are lost.
    bool is_live() const { return m_live != nullptr; }
    /// Whether it is a sequence or video, which has a rate and is read in the background.
    bool is_film() const { return m_stream != nullptr; }
    double rate() const;      // of a film, pictures/s
    double own_rate() const;  // without the user's setting
    /// The picture size as the look reads it, without prescale.
    Extent extent() const;
    /// Pixels per original pixel in each direction, as set or detected.
    int prescale() const;

    /// Takes the newest picture of a live source; true if its size has changed.
    bool refresh();
    /// Waits for the picture at the end time of a frame. Pictures, like frames, cover the time up
    /// to their end. At equal rates frame N therefore shows picture N.
    SharedPicture wait_for(double seconds);
    /// The same without waiting; the previous picture until it is ready.
    SharedPicture picture_at(double seconds);
    /// Whether picture_at() returned an outdated picture.
    bool is_late() const { return m_is_late; }
    /// The new errors and warnings since the last call.
    Diagnostics take_problems();
    /// Whether the problem of a live source has ended since the last call.
    bool take_solved() { return m_live && m_live->take_solved(); }

private:
    std::int64_t number_at(double seconds) const;
    void draw_pattern(double seconds);
    void find_prescale();
    Result<void> open_live(LiveReading reading);
    Result<void> open_whole_pipe(const LiveSpec& live);
    void follow_live();
    SharedPicture original();

    SourceSpec m_spec;
    SharedPicture m_picture;   // as read
    SharedPicture m_original;  // m_original_of without prescale
    SharedPicture m_original_of;
    int m_original_times = 1;
    int m_found_prescale = 1;
    bool m_has_looked_for_prescale = false;
    std::unique_ptr<FrameStream> m_stream;  // null: not a film
    std::unique_ptr<LiveStream> m_live;     // null: not live
    bool m_is_moving_pattern = false;
    double m_pattern_seconds = 0.0;  // time of m_picture
    double m_own_rate = 0.0;
    bool m_is_late = false;
    Diagnostics m_problems;
};

/// Sets a picture as the source, fitted into `viewport` as the spec requests.
Result<void> show_placed(const Picture& picture, const SourceSpec& spec, Extent viewport,
                         Executors& executors);

/// Whether a file can be a source: a picture, a video or a numbered sequence.
bool is_source_file(const std::filesystem::path& file);

#pragma once

#include "base/diagnostic.h"
#include "lab/media/frame_stream.h"
#include "model/look/picture.h"
#include "model/picture/source_spec.h"

#include <memory>
#include <string>

class Executors;

/// The source picture of a look: a pattern, a file, a numbered sequence or a video.
class Source {
public:
    /// Opens the source of a text and reads its first picture.
    static Result<Source> open(const std::string& text);

    const SourceSpec& spec() const { return m_spec; }
    /// Changes the settings for the same picture.
    void set_spec(const SourceSpec& spec);
    /// Sets the encoding of the pictures; a film is converted on its reading thread.
    void expect(Encoding encoding);
    /// Whether it depends on time.
    bool moves() const { return is_film() || m_is_moving_pattern; }
    /// Whether it is a sequence or video, which has a rate and is read in the background.
    bool is_film() const { return m_stream != nullptr; }
    double rate() const;      // of a film, pictures/s
    double own_rate() const;  // without the user's setting
    /// The picture size as the look reads it, without prescale.
    Extent extent() const;
    /// Pixels per original pixel in each direction, as set or detected.
    int prescale() const;

    /// Waits for the picture at the end time of a frame. Pictures, like frames, cover the time up
    /// to their end. At equal rates frame N therefore shows picture N.
    SharedPicture wait_for(double seconds);
    /// The same without waiting; the previous picture until it is ready.
    SharedPicture picture_at(double seconds);
    /// Whether picture_at() returned an outdated picture.
    bool is_late() const { return m_is_late; }
    /// The new errors and warnings since the last call.
    Diagnostics take_problems();

private:
    std::int64_t number_at(double seconds) const;
    void draw_pattern(double seconds);
    void find_prescale();
    SharedPicture original();

    SourceSpec m_spec;
    SharedPicture m_picture;   // as read
    SharedPicture m_original;  // m_original_of without prescale
    SharedPicture m_original_of;
    int m_original_times = 1;
    int m_found_prescale = 1;
    bool m_has_looked_for_prescale = false;
    std::unique_ptr<FrameStream> m_stream;  // null: a still picture or a pattern
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

#pragma once

#include "base/diagnostic.h"
#include "lab/media/frame_stream.h"
#include "model/look/picture.h"
#include "model/picture/source_spec.h"

#include <memory>
#include <string>

class Renderer;

/// The picture that a CRT look works on: a pattern, a file, a numbered sequence or a video.
class Source {
public:
    /// Opens what a source's text names and reads its first picture.
    static Result<Source> open(const std::string& text);

    const SourceSpec& spec() const { return m_spec; }
    /// Other settings for the same picture.
    void set_spec(const SourceSpec& spec);
    /// What its pictures are taken to before they are drawn, a film's on the thread that reads it.
    void expect(Encoding encoding);
    /// Whether it looks different at other times.
    bool moves() const { return is_film() || m_is_moving_pattern; }
    /// A sequence or video: pictures at a rate, which takes time to read.
    bool is_film() const { return m_stream != nullptr; }
    double rate() const;      // of a film, pictures a second
    double own_rate() const;  // without the person's
    /// Of its pictures as a look gets them: without what they were enlarged by.
    Extent extent() const;
    /// How many pixels along a side show one of the original, as set or as found.
    int prescale() const;

    /// The picture at a frame's end: its pictures, like frames, cover the time up to their end, so
    /// that at equal rates frame N shows the N-th. Waits for it.
    SharedPicture wait_for(double seconds);
    /// The same without waiting: the last one until it is there.
    SharedPicture picture_at(double seconds);
    /// Whether picture_at() gave another one than it should.
    bool is_late() const { return m_is_late; }
    /// What could not be read, or not as it is, since last asked.
    Diagnostics take_problems();

private:
    std::int64_t number_at(double seconds) const;
    void draw_pattern(double seconds);
    void find_prescale();
    SharedPicture original();

    SourceSpec m_spec;
    SharedPicture m_picture;   // as it was read
    SharedPicture m_original;  // of m_original_of, without its enlargement
    SharedPicture m_original_of;
    int m_original_times = 1;
    int m_found_prescale = 1;
    bool m_has_looked_for_prescale = false;
    std::unique_ptr<FrameStream> m_stream;  // null: a still picture or a pattern
    bool m_is_moving_pattern = false;
    double m_pattern_seconds = 0.0;  // that m_picture shows
    double m_own_rate = 0.0;
    bool m_is_late = false;
    Diagnostics m_problems;
};

/// Gives a renderer one of its pictures, as the spec places it in a picture of `viewport` pixels.
Result<void> show_placed(const Picture& picture, const SourceSpec& spec, Extent viewport,
                         Renderer& renderer);

/// Whether a file can be a source: a picture, a video, or the name of a numbered sequence.
bool is_source_file(const std::filesystem::path& file);

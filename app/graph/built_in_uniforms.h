#pragma once

#include "gpu/program.h"
#include "graph/frame.h"
#include "graph/pass_report.h"
#include "model/extent.h"

#include <array>
#include <vector>

/// Sizes that a pass is told.
struct PassExtents {
    Extent target;
    Extent output;
    Extent source;
};

/// The uniforms that the program itself drives, where a pass has them; each in whatever number type
/// it was declared.
class BuiltInUniforms {
public:
    explicit BuiltInUniforms(const gpu::Program& program);

    /// `number` is the frame's, after the pass's modulo.
    void write(const gpu::Program& program, const Frame& frame, double number,
               const PassExtents& extents) const;
    void write_samples(const gpu::Program& program, int samples) const;
    /// Those that the pass has, with what write() and write_samples() give them.
    std::vector<BuiltInReport> report(const Frame& frame, double number, const PassExtents& extents,
                                      int samples) const;
    /// Whether it draws another picture when only time goes on.
    bool tell_time() const { return m_time || m_time_delta || m_frame; }
    bool tell_mouse() const { return m_mouse; }

private:
    struct Told {
        const gpu::Uniform* uniform;  // null: the pass has none
        std::array<double, 2> numbers;
        std::size_t count;
    };
    std::array<Told, 7> tell(const Frame& frame, double number, const PassExtents& extents) const;

    const gpu::Uniform* m_time;
    const gpu::Uniform* m_time_delta;
    const gpu::Uniform* m_frame;
    const gpu::Uniform* m_resolution;
    const gpu::Uniform* m_output_resolution;
    const gpu::Uniform* m_source_resolution;
    const gpu::Uniform* m_mouse;
    const gpu::Uniform* m_samples;
};

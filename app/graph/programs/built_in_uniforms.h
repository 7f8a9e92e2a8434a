#pragma once

#include "gpu/program.h"
#include "graph/programs/bound_input.h"
#include "graph/programs/frame.h"
#include "graph/programs/pass_report.h"

#include <array>
#include <functional>
#include <vector>

/// What a pass is told besides the frame.
struct PassFacts {
    double number = 0;         // the frame's, after the pass's modulo, from 1
    double number_before = 0;  // the same from 0
    Extent target;
    Extent output;
    Extent source;
    SourceRaster raster;
    RowOrder rows = RowOrder::bottom_first;  // of the target
    bool meets_drawn_onto = false;           // as the plan has it
    std::function<Extent(const BoundInput&)> extent_of;
};

/// The uniforms that the program itself drives, where a pass has them; each in whatever number type
/// it was declared.
class BuiltInUniforms {
public:
    BuiltInUniforms(const Look& look, int pass, const gpu::Program& program);

    void write(const gpu::Program& program, const Frame& frame, const PassFacts& facts) const;
    void write_samples(const gpu::Program& program, int samples) const;
    /// Those that the pass has, with what write() and write_samples() give them.
    std::vector<BuiltInReport> report(const Frame& frame, const PassFacts& facts,
                                      int samples) const;
    /// Whether it draws another picture when only time goes on.
    bool tell_time() const;
    bool tell_mouse() const;

private:
    struct Place {
        const gpu::Uniform* uniform;
        BuiltIn says;
        BoundInput of;
    };
    struct Numbers {
        std::array<double, 16> numbers;
        std::size_t count;
    };
    static Numbers numbers_of(const Place& place, const Frame& frame, const PassFacts& facts);

    std::vector<Place> m_places;  // of one that is written here
    const gpu::Uniform* m_samples = nullptr;
};

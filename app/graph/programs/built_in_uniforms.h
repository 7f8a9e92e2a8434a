#pragma once

#include "gpu/program.h"
#include "graph/programs/bound_input.h"
#include "graph/programs/frame.h"
#include "graph/programs/pass_report.h"

#include <array>
#include <functional>
#include <vector>

/// The values of built-in uniforms that depend on the pass.
struct PassInfo {
    double number = 0;          // of the frame, after the pass's modulo, from 1
    double index_of_frame = 0;  // the same, from 0
    double source_index = 0;    // of the source frame, after the pass's modulo, from 0
    Extent target;
    Extent output;
    Extent source;
    SourceRaster raster;
    RowOrder rows = RowOrder::bottom_first;  // of the target
    bool is_drawn_onto = false;              // see is_drawn_onto()
    std::function<Extent(const BoundInput&)> extent_of;
};

/// The built-in uniforms of a pass, which the program sets. Each is written in its declared number
/// type.
class BuiltInUniforms {
public:
    BuiltInUniforms(const Look& look, int pass, const gpu::Program& program);

    void write(const gpu::Program& program, const Frame& frame, const PassInfo& info) const;
    void write_samples(const gpu::Program& program, int samples) const;
    /// The built-in uniforms of the pass with the values of write() and write_samples().
    std::vector<BuiltInReport> report(const Frame& frame, const PassInfo& info, int samples) const;
    /// Whether the picture changes if only time advances.
    bool uses_time() const;
    bool uses_mouse() const;

private:
    struct BoundBuiltIn {
        const gpu::Uniform* uniform;
        BuiltIn kind;
        BoundInput of;
    };
    struct Numbers {
        std::array<double, 16> numbers;
        std::size_t count;
    };
    static Numbers time_numbers(BuiltIn kind, const Frame& frame, const PassInfo& info);
    static Numbers numbers_of(const BoundBuiltIn& bound, const Frame& frame, const PassInfo& info);

    std::vector<BoundBuiltIn> m_uniforms;  // of the uniforms that write() sets
    const gpu::Uniform* m_samples = nullptr;
};

#include "graph/view/view_programs.h"

#include "graph/inspect/light_cells.h"

#include <utility>

Result<ViewPrograms> ViewPrograms::make() {
    auto viewer = ViewerPrograms::make();
    if (!viewer)
        return fail(viewer.error());
    auto meter = MeterPrograms::make();
    if (!meter)
        return fail(meter.error());
    auto cells = LightCells::make_program();
    if (!cells)
        return fail(cells.error());
    auto pass_through = build_pass_through();
    if (!pass_through)
        return fail(pass_through.error());
    return ViewPrograms{std::move(*viewer), std::move(*meter), std::move(*cells),
                        std::move(*pass_through)};
}

#include "lab/inspect/context_views.h"

#include "graph/view/view_programs.h"

ContextViews::ContextViews(const Programs& drawn)
    : programs(drawn.views),
      context(drawn.context),
      scope(std::make_unique<gpu::ContextScope>(context.get())),
      viewer(part_of(programs, &ViewPrograms::viewer)),
      inspection(part_of(programs, &ViewPrograms::meter)),
      gains(part_of(programs, &ViewPrograms::meter)),
      flash_meter(LightCells(part_of(programs, &ViewPrograms::cells))) {
    scope.reset();
}

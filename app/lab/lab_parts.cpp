#include "lab/lab_parts.h"

#include "lab/lab.h"

LabParts parts_of(const Lab& lab) {
    return {.document = lab.document(),
            .renderer = lab.renderer(),
            .player = lab.player(),
            .audio = lab.audio(),
            .messages = lab.messages(),
            .media = lab.work().media,
            .live = lab.work().live,
            .size = lab.work().size,
            .sender = lab.work().sender,
            .display = lab.work().display,
            .frames = lab.frames(),
            .loader = lab.loader(),
            .programs = lab.work().programs,
            .looks = lab.looks(),
            .presets = lab.presets(),
            .remote = lab.remote(),
            .drawing = lab.drawing(),
            .automation = lab.automation(),
            .jobs = lab.jobs(),
            .sequencer = lab.sequencer()};
}

MutableParts mutable_parts(Lab& lab, WindowState* window) {
    Workspace& work = lab.work();
    return {&lab.audio(),
            &lab.automation(),
            &lab.jobs(),
            &lab.frames().comparison(),
            &lab.content(),
            work.document ? &*work.document : nullptr,
            &lab.drawing(),
            &work.programs,
            &lab.frames(),
            &lab,
            &work.live,
            &lab.looks(),
            &work.sender,
            &work.media,
            &work.messages,
            &lab.parameters(),
            &lab.frames().passes(),
            &work.player,
            &lab.presets(),
            &lab.frames().previews(),
            &lab.remote(),
            &work.size,
            work.renderer.get(),
            &lab.sequencer(),
            window};
}

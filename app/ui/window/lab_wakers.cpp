#include "ui/window/lab_wakers.h"

#include "gpu/window_events.h"
#include "lab/lab.h"

LabWakers::LabWakers(Lab& lab)
    : m_lab(lab),
      m_files(lab.loader().files().descriptor(), gpu::WindowEvents::wake),
      m_midi(lab.remote().midi().descriptor(), gpu::WindowEvents::wake) {
    lab.remote().watch_osc([this](int descriptor) {
        m_osc.reset();
        if (descriptor >= 0)
            m_osc.emplace(descriptor, gpu::WindowEvents::wake);
    });
}

LabWakers::~LabWakers() {
    m_lab.remote().watch_osc([](int) {});
}

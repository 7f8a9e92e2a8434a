#include "ui/window/lab_wakers.h"

#include "gpu/window_events.h"
#include "lab/lab.h"

LabWakers::LabWakers(Lab& lab)
    : m_files(lab.loader().files().descriptor(), gpu::WindowEvents::wake),
      m_midi(lab.remote().midi().descriptor(), gpu::WindowEvents::wake) {}

void LabWakers::update(const OscControl& osc) {
    if (osc.opening() == m_osc_opening)
        return;
    m_osc_opening = osc.opening();
    m_osc.emplace(osc.descriptor(), gpu::WindowEvents::wake);
}

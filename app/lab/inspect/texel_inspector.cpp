#include "lab/inspect/texel_inspector.h"

namespace {
template <class Part, class Subject>
void follow(Part& part, TexelReader& reader, const Subject* subject, double seconds) {
    if (subject)
        part.update(reader, *subject, seconds);
    else
        part.stop();
}
}  // namespace

Result<TexelInspector> TexelInspector::make() {
    auto level = LevelCopy::make();
    if (!level)
        return fail(level.error());
    auto reader = TexelReader::make();
    if (!reader)
        return fail(reader.error());
    return TexelInspector(std::move(*level), std::move(*reader));
}

const gpu::Texture& TexelInspector::level_of(const InspectedTexture& inspected) {
    const int level = inspected.choice.level;
    const gpu::Texture* smaller = level > 0 ? m_level.draw(*inspected.texture, level) : nullptr;
    return smaller ? *smaller : *inspected.texture;
}

void TexelInspector::update_picture(const TexelValues::Subject* subject, double seconds) {
    follow(m_picture, m_reader, subject, seconds);
}

void TexelInspector::update_inspected(const TexelValues::Subject* subject, double seconds) {
    follow(m_inspected, m_reader, subject, seconds);
}

void TexelInspector::update_waveform(const Waveform::Subject* subject, double seconds) {
    follow(m_waveform, m_reader, subject, seconds);
}

void TexelInspector::stop() {
    m_picture.stop();
    m_inspected.stop();
    m_waveform.stop();
}

bool TexelInspector::is_pending() const {
    return m_picture.is_pending() || m_inspected.is_pending() || m_waveform.is_pending();
}

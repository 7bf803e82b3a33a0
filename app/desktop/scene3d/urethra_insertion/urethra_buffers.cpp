// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/urethra_insertion/urethra_buffers.h"

#include <Qt3DCore/QAttribute>
#include <Qt3DCore/QGeometry>
#include <algorithm>
#include <vector>

namespace chiron::scene3d {

using Qt3DCore::QAttribute;

namespace {

constexpr std::array<const char*, UrethraBuffers::kPlanes> kNames{
    "wallX", "wallY", "wallZ", "wallNormalX", "wallNormalY", "wallNormalZ", "wallArc"};

template <class Value> QByteArray bytesOf(std::span<const Value> values) {
    return {reinterpret_cast<const char*>(values.data()), qsizetype(values.size_bytes())};
}

std::span<const float> planeOf(const simulation::UrethraSurface& surface, int component) {
    return component < 6 ? surface.plane(component) : surface.arcLength_m();
}

std::vector<float> placesOf(const simulation::UrethraSurface& surface) {
    std::vector<float> places;
    for (std::size_t i = 0; i < surface.vertexCount(); ++i)
        for (int k = 0; k < 3; ++k)
            places.push_back(surface.plane(k)[i]);
    return places;
}

/// Turns round the canal: j/N, but on the seam's triangles the first point of a ring is a whole turn.
std::vector<float> turnsOf(const simulation::UrethraSurface& surface, bool seam) {
    const std::size_t ring = surface.ringSize();
    std::vector<float> turns(surface.vertexCount());
    for (std::size_t i = 0; i < turns.size(); ++i)
        turns[i] = seam && i % ring == 0 ? 1.0F : float(i % ring) / float(ring);
    return turns;
}

std::vector<std::uint32_t> trianglesOf(const simulation::UrethraSurface& surface, bool seam) {
    const std::uint32_t ring = std::uint32_t(surface.ringSize());
    const std::span<const std::uint32_t> all = surface.triangles();
    std::vector<std::uint32_t> chosen;
    for (std::size_t t = 0; t + 2 < all.size(); t += 3) {
        bool first = false;
        bool last = false;
        for (std::size_t k = t; k < t + 3; ++k) {
            first = first || all[k] % ring == 0;
            last = last || all[k] % ring == ring - 1;
        }
        if ((first && last) == seam)
            chosen.insert(chosen.end(), {all[t], all[t + 1], all[t + 2]});
    }
    return chosen;
}

} // namespace

UrethraBuffers::UrethraBuffers(const simulation::UrethraSurface& surface, Qt3DCore::QNode* owner) {
    for (int i = 0; i < kPlanes; ++i) {
        m_planes[std::size_t(i)] = new Qt3DCore::QBuffer(owner);
        m_planes[std::size_t(i)]->setUsage(Qt3DCore::QBuffer::DynamicDraw);
        m_planes[std::size_t(i)]->setData(bytesOf(planeOf(surface, i)));
    }
    m_body = renderer(surface, false, owner);
    m_seam = renderer(surface, true, owner);
}

Qt3DRender::QGeometryRenderer* UrethraBuffers::renderer(const simulation::UrethraSurface& surface, bool seam,
                                                        Qt3DCore::QNode* owner) {
    auto* made = new Qt3DRender::QGeometryRenderer(owner);
    auto* geometry = new Qt3DCore::QGeometry(made);
    const uint count = uint(surface.vertexCount());
    const auto add = [&](Qt3DCore::QBuffer* buffer, const char* name) {
        geometry->addAttribute(
            new QAttribute(buffer, QLatin1String(name), QAttribute::Float, 1, count, 0, sizeof(float), geometry));
    };
    for (std::size_t i = 0; i < kNames.size(); ++i)
        add(m_planes[i], kNames[i]);
    // The engine measures every shape by its positions, and complains of one without: it gets those at rest.
    auto* rest = new Qt3DCore::QBuffer(geometry);
    rest->setData(bytesOf(std::span<const float>(placesOf(surface))));
    auto* places = new QAttribute(rest, QAttribute::defaultPositionAttributeName(), QAttribute::Float, 3, count, 0,
                                  3 * sizeof(float), geometry);
    geometry->addAttribute(places);
    geometry->setBoundingVolumePositionAttribute(places);
    auto* turns = new Qt3DCore::QBuffer(geometry);
    turns->setData(bytesOf(std::span<const float>(turnsOf(surface, seam))));
    add(turns, "wallTurn");
    const std::vector<std::uint32_t> triangles = trianglesOf(surface, seam);
    auto* order = new Qt3DCore::QBuffer(geometry);
    order->setData(bytesOf(std::span<const std::uint32_t>(triangles)));
    auto* indices = new QAttribute(order, QAttribute::UnsignedInt, 1, uint(triangles.size()), 0, 0, geometry);
    indices->setAttributeType(QAttribute::IndexAttribute);
    geometry->addAttribute(indices);
    made->setGeometry(geometry);
    made->setVertexCount(int(triangles.size()));
    return made;
}

void UrethraBuffers::update(const simulation::UrethraSurface& surface,
                            std::span<const simulation::VertexRange> changed) {
    if (changed.empty())
        return;
    // One range a picture: a buffer keeps only the newest of several updates, and the rings that change lie together.
    const std::size_t first = changed.front().first;
    const std::size_t count = changed.back().first + changed.back().count - first;
    for (int i = 0; i < kPlanes; ++i)
        m_planes[std::size_t(i)]->updateData(int(first * sizeof(float)),
                                             bytesOf(planeOf(surface, i).subspan(first, count)));
}

} // namespace chiron::scene3d

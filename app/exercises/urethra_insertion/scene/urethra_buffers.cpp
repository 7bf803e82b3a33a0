// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/scene/urethra_buffers.h"

#include <Qt3DCore/QAttribute>
#include <Qt3DCore/QGeometry>
#include <algorithm>
#include <utility>
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

/// The texture coordinate round the canal: j/N, except that on the seam's triangles the first point of a ring
/// is a whole turn.
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
    const auto ringOf = [&](std::size_t t) {
        return std::min({chosen[t], chosen[t + 1], chosen[t + 2]}) / ring;
    };
    std::vector<std::size_t> order;
    for (std::size_t t = 0; t < chosen.size(); t += 3)
        order.push_back(t);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return ringOf(a) < ringOf(b); });
    std::vector<std::uint32_t> sorted;
    for (std::size_t t : order)
        sorted.insert(sorted.end(), {chosen[t], chosen[t + 1], chosen[t + 2]});
    return sorted;
}

/// For each ring, the number of these indices (sorted by ring) before it; with one more entry at the end.
std::vector<std::uint32_t> startsOf(const std::vector<std::uint32_t>& triangles, std::size_t ringSize,
                                    std::size_t rings) {
    std::vector<std::uint32_t> starts;
    std::size_t t = 0;
    for (std::size_t ring = 0; ring <= rings; ++ring) {
        while (t < triangles.size() &&
               std::min({triangles[t], triangles[t + 1], triangles[t + 2]}) / ringSize < ring)
            t += 3;
        starts.push_back(std::uint32_t(t));
    }
    return starts;
}

/// Triangles of every second ring and every second point of it (the README.md of the surface describes the
/// layout of rings and points); the last ring is always included.
std::vector<std::uint32_t> coarseTriangles(const simulation::UrethraSurface& surface) {
    const std::uint32_t ring = std::uint32_t(surface.ringSize());
    const std::uint32_t last = std::uint32_t(surface.vertexCount()) / ring - 1;
    const std::uint32_t step = ring % 2 == 0 ? 2 : 1;
    std::vector<std::uint32_t> chosen;
    for (std::uint32_t r = 0; r < last; r += 2)
        for (std::uint32_t j = 0; j < ring; j += step) {
            const std::uint32_t here = r * ring, next = std::min(r + 2, last) * ring, k = (j + step) % ring;
            chosen.insert(chosen.end(), {here + j, next + j, here + k, here + k, next + j, next + k});
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
    const std::vector<std::uint32_t> body = trianglesOf(surface, false);
    const std::vector<std::uint32_t> seam = trianglesOf(surface, true);
    const std::size_t rings = surface.vertexCount() / surface.ringSize();
    m_bodyStarts = startsOf(body, surface.ringSize(), rings);
    m_seamStarts = startsOf(seam, surface.ringSize(), rings);
    m_body = renderer(surface, body, false, owner);
    m_seam = renderer(surface, seam, true, owner);
    m_coarse = renderer(surface, coarseTriangles(surface), false, owner);
}

Qt3DRender::QGeometryRenderer* UrethraBuffers::renderer(const simulation::UrethraSurface& surface,
                                                        const std::vector<std::uint32_t>& triangles,
                                                        bool seam, Qt3DCore::QNode* owner) {
    auto* made = new Qt3DRender::QGeometryRenderer(owner);
    auto* geometry = new Qt3DCore::QGeometry(made);
    const uint count = uint(surface.vertexCount());
    const auto add = [&](Qt3DCore::QBuffer* buffer, const char* name) {
        geometry->addAttribute(new QAttribute(buffer, QLatin1String(name), QAttribute::Float, 1, count, 0,
                                              sizeof(float), geometry));
    };
    for (std::size_t i = 0; i < kNames.size(); ++i)
        add(m_planes[i], kNames[i]);
    // The engine measures every shape by its positions and reports an error for a shape without them, so it
    // gets those at rest.
    auto* rest = new Qt3DCore::QBuffer(geometry);
    rest->setData(bytesOf(std::span<const float>(placesOf(surface))));
    auto* places = new QAttribute(rest, QAttribute::defaultPositionAttributeName(), QAttribute::Float, 3,
                                  count, 0, 3 * sizeof(float), geometry);
    geometry->addAttribute(places);
    geometry->setBoundingVolumePositionAttribute(places);
    auto* turns = new Qt3DCore::QBuffer(geometry);
    turns->setData(bytesOf(std::span<const float>(turnsOf(surface, seam))));
    add(turns, "wallTurn");
    auto* order = new Qt3DCore::QBuffer(geometry);
    order->setData(bytesOf(std::span<const std::uint32_t>(triangles)));
    auto* indices = new QAttribute(order, QAttribute::UnsignedInt, 1, uint(triangles.size()), 0, 0, geometry);
    indices->setAttributeType(QAttribute::IndexAttribute);
    geometry->addAttribute(indices);
    made->setGeometry(geometry);
    made->setVertexCount(int(triangles.size()));
    return made;
}

void UrethraBuffers::cut(Qt3DRender::QGeometryRenderer* part, const std::vector<std::uint32_t>& starts,
                         std::size_t ring) {
    part->setIndexBufferByteOffset(int(starts[ring] * sizeof(std::uint32_t)));
    part->setVertexCount(int(starts.back() - starts[ring]));
}

void UrethraBuffers::showFrom(const simulation::UrethraSurface& surface, double from_s_m) {
    const std::span<const float> arc = surface.arcLength_m();
    const std::size_t ring = surface.ringSize();
    // At least one strip is kept, because an empty range would be drawn whole.
    const std::size_t last = surface.vertexCount() / ring - 2;
    std::size_t from = 0;
    while (from < last && double(arc[(from + 1) * ring]) < from_s_m)
        ++from;
    if (std::exchange(m_from, from) == from)
        return;
    cut(m_body, m_bodyStarts, from);
    cut(m_seam, m_seamStarts, from);
}

void UrethraBuffers::update(const simulation::UrethraSurface& surface,
                            std::span<const simulation::VertexRange> changed) {
    if (changed.empty())
        return;
    // One range per picture: a buffer keeps only the newest of several updates, and the rings that change are
    // adjacent.
    const std::size_t first = changed.front().first;
    const std::size_t count = changed.back().first + changed.back().count - first;
    for (int i = 0; i < kPlanes; ++i)
        m_planes[std::size_t(i)]->updateData(int(first * sizeof(float)),
                                             bytesOf(planeOf(surface, i).subspan(first, count)));
}

} // namespace chiron::scene3d

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/geometry/urethra/urethra_surface.h"

#include "simulation/geometry/urethra/urethra_curve_net.h"
#include "simulation/geometry/urethra/urethra_patch_kernel.h"

#include <algorithm>

namespace chiron::simulation {

namespace {

constexpr std::size_t kPlanes = 6;

/// Names the ring of the curves that lies in a slot of the vertex buffer. If the spans have not changed,
/// equal specs mean equal rings.
struct RingSpec {
    bool deformed = false;
    int span = -1;
    double u = 0.0;

    bool operator==(const RingSpec&) const = default;
};

std::vector<std::uint32_t> ringTriangles(std::size_t rings, std::size_t ringSize) {
    std::vector<std::uint32_t> triangles;
    triangles.reserve((rings - 1) * ringSize * 6);
    for (std::size_t ring = 0; ring + 1 < rings; ++ring)
        for (std::size_t i = 0; i < ringSize; ++i) {
            const auto a = static_cast<std::uint32_t>(ring * ringSize + i);
            const auto b = static_cast<std::uint32_t>(ring * ringSize + (i + 1) % ringSize);
            const auto further = static_cast<std::uint32_t>(ringSize);
            triangles.insert(triangles.end(), {a, a + further, b, a + further, b + further, b});
        }
    return triangles;
}

} // namespace

struct UrethraSurface::State {
    State(const UrethraAnatomy& anatomy, const Endoscope& endoscope, const UrethraMeshSettings& meshSettings)
        : settings(meshSettings), ringSize(static_cast<std::size_t>((settings.n - 1) * settings.perPatch)),
          rings(static_cast<std::size_t>((settings.w - 1 + settings.movingSections) * settings.perPatch + 1)),
          net(anatomy, endoscope, settings), kernel(settings.n - 1, settings.perPatch),
          values(kPlanes * rings * ringSize), arc_m(rings * ringSize),
          triangles(ringTriangles(rings, ringSize)), specs(rings), wanted(rings) {
        ranges.reserve(rings);
    }

    void lay();
    void layRest(std::size_t firstSlot, int firstRing);
    void layEnd(std::size_t firstSlot);
    void write(int firstChanged, bool all);
    void writeRing(std::size_t slot);
    RingPlanes planesOf(std::size_t slot);
    void copyRing(std::size_t from, std::size_t to);

    UrethraMeshSettings settings;
    std::size_t ringSize;
    std::size_t rings;
    UrethraCurveNet net;
    UrethraPatchKernel kernel;
    std::vector<float> values;
    std::vector<float> arc_m;
    std::vector<std::uint32_t> triangles;
    std::vector<RingSpec> specs;  ///< the present content of the buffer
    std::vector<RingSpec> wanted; ///< the content that the buffer is to have
    std::vector<VertexRange> ranges;
};

// Lays the resting rings from `firstRing` (counted along the basic spans) to C at the end of the buffer.
void UrethraSurface::State::layRest(std::size_t firstSlot, int firstRing) {
    const int k = settings.perPatch;
    for (std::size_t slot = firstSlot; slot < rings; ++slot, ++firstRing)
        wanted[slot] = {false, firstRing / k, static_cast<double>(firstRing % k) / k};
    wanted.back() = {false, settings.w - 2, 1.0};
}

// After the deformed spans, puts all rings on the deformation's end, up to the first resting ring beyond it.
void UrethraSurface::State::layEnd(std::size_t firstSlot) {
    const int k = settings.perPatch;
    const UrethraSection& end = net.plan().sections().back();
    int ring = end.restSpan * k;
    while (ring < (end.restSpan + 1) * k && static_cast<double>(ring % k) / k <= end.restParameter)
        ++ring;
    const auto beyond = static_cast<std::size_t>(ring + settings.movingSections * k);
    for (std::size_t slot = firstSlot; slot < beyond; ++slot)
        wanted[slot] = {false, end.restSpan, end.restParameter};
    layRest(beyond, ring);
}

void UrethraSurface::State::lay() {
    const int k = settings.perPatch;
    const int spans = net.deformed().spans();
    if (spans < 1) { // at rest the spare rings lie on A
        const auto spare = static_cast<std::size_t>(settings.movingSections * k);
        std::fill_n(wanted.begin(), spare, RingSpec{false, 0, 0.0});
        layRest(spare, 0);
        return;
    }
    const auto firstAfter = static_cast<std::size_t>(spans * k);
    for (std::size_t slot = 0; slot < firstAfter; ++slot) {
        const int ring = static_cast<int>(slot);
        wanted[slot] = {true, ring / k, static_cast<double>(ring % k) / k};
    }
    if (net.plan().endsOnRest())
        layEnd(firstAfter);
    else
        std::fill(wanted.begin() + static_cast<std::ptrdiff_t>(firstAfter), wanted.end(),
                  RingSpec{true, spans - 1, 1.0});
}

void UrethraSurface::State::write(int firstChanged, bool all) {
    ranges.clear();
    lay();
    kernel.forget();
    for (std::size_t slot = 0; slot < rings; ++slot) {
        const RingSpec& ring = wanted[slot];
        const bool same = !all && ring == specs[slot] && (!ring.deformed || ring.span < firstChanged);
        if (same)
            continue;
        if (slot > 0 && ring == wanted[slot - 1])
            copyRing(slot - 1, slot);
        else
            writeRing(slot);
        const std::size_t first = slot * ringSize;
        if (!ranges.empty() && ranges.back().first + ranges.back().count == first)
            ranges.back().count += ringSize;
        else
            ranges.push_back({first, ringSize});
    }
    specs.swap(wanted);
}

RingPlanes UrethraSurface::State::planesOf(std::size_t slot) {
    RingPlanes planes{};
    for (std::size_t i = 0; i < kPlanes; ++i)
        planes[i] = values.data() + (i * rings + slot) * ringSize;
    return planes;
}

void UrethraSurface::State::copyRing(std::size_t from, std::size_t to) {
    const RingPlanes source = planesOf(from);
    const RingPlanes target = planesOf(to);
    for (std::size_t i = 0; i < kPlanes; ++i)
        std::copy_n(source[i], ringSize, target[i]);
    std::fill_n(arc_m.begin() + static_cast<std::ptrdiff_t>(to * ringSize), ringSize, arc_m[from * ringSize]);
}

void UrethraSurface::State::writeRing(std::size_t slot) {
    const RingSpec& ring = wanted[slot];
    const UrethraCurves& curves = ring.deformed ? net.deformed() : net.rest();
    const RingPlanes planes = planesOf(slot);
    if (ring.u <= 0.0 && ring.span > 0) {
        kernel.load(curves, ring.span - 1);
        kernel.keepEnd();
    }
    kernel.load(curves, ring.span);
    if (ring.u <= 0.0)
        kernel.firstRing(ring.span > 0, planes);
    else if (ring.u >= 1.0)
        kernel.lastRing(planes);
    else
        kernel.innerRing(ring.u, planes);
    const double s = curves.s_m(ring.span) + ring.u * (curves.s_m(ring.span + 1) - curves.s_m(ring.span));
    std::fill_n(arc_m.begin() + static_cast<std::ptrdiff_t>(slot * ringSize), ringSize,
                static_cast<float>(s));
}

UrethraSurface::UrethraSurface(const UrethraAnatomy& anatomy, const Endoscope& endoscope,
                               const UrethraMeshSettings& settings)
    : m_state(std::make_unique<State>(anatomy, endoscope, settings)) {
    rebuild({});
}

UrethraSurface::~UrethraSurface() = default;

std::span<const VertexRange> UrethraSurface::update(const UrethraDeformation& deformation) {
    m_state->write(m_state->net.deform(deformation), false);
    return m_state->ranges;
}

void UrethraSurface::rebuild(const UrethraDeformation& deformation) {
    m_state->write(m_state->net.deformAnew(deformation), true);
}

std::size_t UrethraSurface::vertexCount() const noexcept {
    return m_state->rings * m_state->ringSize;
}

std::size_t UrethraSurface::ringSize() const noexcept {
    return m_state->ringSize;
}

std::span<const float> UrethraSurface::plane(int component) const noexcept {
    return std::span<const float>(m_state->values)
        .subspan(static_cast<std::size_t>(component) * vertexCount(), vertexCount());
}

std::span<const float> UrethraSurface::arcLength_m() const noexcept {
    return m_state->arc_m;
}

std::span<const std::uint32_t> UrethraSurface::triangles() const noexcept {
    return m_state->triangles;
}

const UrethraMeshSettings& UrethraSurface::settings() const noexcept {
    return m_state->settings;
}

} // namespace chiron::simulation

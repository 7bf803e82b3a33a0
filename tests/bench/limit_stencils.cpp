// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/limit_stencils.h"

#ifdef CHIRON_HAS_OPENSUBDIV
#include <cmath>
#include <opensubdiv/far/stencilTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/osd/bufferDescriptor.h>
#include <opensubdiv/osd/cpuEvaluator.h>
#endif

namespace chiron::bench {

#ifdef CHIRON_HAS_OPENSUBDIV

namespace {

using namespace OpenSubdiv;
constexpr int kAdaptiveLevel = 4;

struct Places {
    std::vector<std::vector<float>> s, t;
    Far::LimitStencilTableFactory::LocationArrayVec arrays;
};

// A face's first parameter runs along the tube, its second around it, as the tube's spans and columns do.
Places placesOf(int sections, int columns, int perPatch) {
    Places places;
    const int faces = (sections - 1) * columns;
    places.s.resize(static_cast<std::size_t>(faces + columns));
    places.t.resize(places.s.size());
    for (int i = 0; i < faces + columns; ++i) {
        const bool lastSection = i >= faces;
        auto& s = places.s[static_cast<std::size_t>(i)];
        auto& t = places.t[static_cast<std::size_t>(i)];
        for (int a = 0; a < (lastSection ? 1 : perPatch); ++a)
            for (int b = 0; b < perPatch; ++b) {
                s.push_back(lastSection ? 1.0F : static_cast<float>(a) / static_cast<float>(perPatch));
                t.push_back(static_cast<float>(b) / static_cast<float>(perPatch));
            }
        Far::LimitStencilTableFactory::LocationArray array;
        array.ptexIdx = lastSection ? i - columns : i;
        array.numLocations = static_cast<int>(s.size());
        array.s = s.data();
        array.t = t.data();
        places.arrays.push_back(array);
    }
    return places;
}

std::unique_ptr<Far::TopologyRefiner> tube(int sections, int columns) {
    std::vector<int> sizes;
    std::vector<int> corners;
    for (int i = 0; i + 1 < sections; ++i)
        for (int j = 0; j < columns; ++j) {
            const int next = (j + 1) % columns;
            sizes.push_back(4);
            for (const int corner :
                 {i * columns + j, (i + 1) * columns + j, (i + 1) * columns + next, i * columns + next})
                corners.push_back(corner);
        }
    Far::TopologyDescriptor descriptor;
    descriptor.numVertices = sections * columns;
    descriptor.numFaces = static_cast<int>(sizes.size());
    descriptor.numVertsPerFace = sizes.data();
    descriptor.vertIndicesPerFace = corners.data();
    Sdc::Options options;
    options.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    std::unique_ptr<Far::TopologyRefiner> refiner(
        Factory::Create(descriptor, Factory::Options(Sdc::SCHEME_CATMARK, options)));
    refiner->RefineAdaptive(Far::TopologyRefiner::AdaptiveOptions(kAdaptiveLevel));
    return refiner;
}

} // namespace

struct LimitStencils::Tables {
    std::unique_ptr<const Far::LimitStencilTable> stencils;
};

LimitStencils::LimitStencils(int sections, int columns, int perPatch) : m_tables(std::make_unique<Tables>()) {
    const auto refiner = tube(sections, columns);
    const Places places = placesOf(sections, columns, perPatch);
    Far::LimitStencilTableFactory::Options options;
    options.generate1stDerivatives = true;
    m_tables->stencils.reset(
        Far::LimitStencilTableFactory::Create(*refiner, places.arrays, nullptr, nullptr, options));
    const auto numbers = static_cast<std::size_t>(m_tables->stencils->GetNumStencils()) * 3;
    for (std::vector<float>* of : {&m_points, &m_du, &m_dv, &m_normals})
        of->resize(numbers);
}

bool LimitStencils::available() {
    return true;
}

void LimitStencils::evaluate(std::span<const float> control) {
    const Osd::BufferDescriptor xyz(0, 3, 3);
    const Far::LimitStencilTable& table = *m_tables->stencils;
    Osd::CpuEvaluator::EvalStencils(
        control.data(), xyz, m_points.data(), xyz, m_du.data(), xyz, m_dv.data(), xyz, &table.GetSizes()[0],
        &table.GetOffsets()[0], &table.GetControlIndices()[0], &table.GetWeights()[0],
        &table.GetDuWeights()[0], &table.GetDvWeights()[0], 0, table.GetNumStencils());
    for (std::size_t i = 0; i < m_normals.size(); i += 3) {
        const float* const u = &m_du[i];
        const float* const v = &m_dv[i];
        const float x = u[1] * v[2] - u[2] * v[1];
        const float y = u[2] * v[0] - u[0] * v[2];
        const float z = u[0] * v[1] - u[1] * v[0];
        const float scale = 1.0F / std::sqrt(x * x + y * y + z * z);
        m_normals[i] = x * scale;
        m_normals[i + 1] = y * scale;
        m_normals[i + 2] = z * scale;
    }
}

#else

struct LimitStencils::Tables {};

LimitStencils::LimitStencils(int, int, int) {}

bool LimitStencils::available() {
    return false;
}

void LimitStencils::evaluate(std::span<const float>) {}

#endif

LimitStencils::~LimitStencils() = default;

} // namespace chiron::bench

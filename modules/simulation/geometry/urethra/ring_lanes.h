// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace chiron::simulation {

/// The inner loops of UrethraPatchKernel over plain arrays of float in vector code; compiled once for every
/// x86-64 and once more for those with AVX2, chosen when the program starts; the same bits either way.
///
/// A ring is cut into blocks of kLaneWidth vertices: patch after patch, the last block of a patch filled up.
/// Row arrays hold 6 lanes a block, β(v) in x, y, z and dβ/dv in x, y, z; slope arrays 3 lanes a block.
/// Column arrays hold 4 numbers (x, y, z and nothing) a curve along the canal, the first curve's again at the
/// end.
inline constexpr int kLaneWidth = 8;
inline constexpr int kRowLanes = 6;
inline constexpr int kSlopeLanes = 3;
inline constexpr int kFour = 4;

struct RingSize {
    int columns = 0;
    int perPatch = 0;

    constexpr int blocksAPatch() const noexcept { return (perPatch + kLaneWidth - 1) / kLaneWidth; }
    constexpr int lanes(int perBlock) const noexcept {
        return columns * blocksAPatch() * perBlock * kLaneWidth;
    }
    constexpr int vertices() const noexcept { return columns * perPatch; }
};

/// Numbers for each vertex of a patch's side, whole blocks of them: its place v, 1 for its first vertex (else
/// 0), and the weights of hOut, hIn and chord in β(v) and dβ/dv.
struct SideTables {
    const float *v, *first;
    const float *out, *in, *chord, *outTurn, *inTurn, *chordTurn;
};

/// The lanes of one component (0 x, 1 y, 2 z) of a section's row, from its points and handles.
void bulgeLanes(const double* point, const double* handleOut, const double* handleIn,
                const SideTables& tables, RingSize size, int component, float* row) noexcept;

/// Points, chords to the next and the curves' control points less the points, at one span.
struct SpanColumns {
    const float *point, *chord, *q1, *q2, *q3;
};
/// The curves at one u, 5 × 4 numbers each: c(u), c⁺(u) − c(u), what the mean of both sides' such steps is
/// more, c′(u), c⁺′(u) − c′(u).
inline constexpr int kCurveFours = 5;
void curveColumns(const SpanColumns& in, const std::array<float, 3>& weights,
                  const std::array<float, 3>& slopeWeights, int columns, float* curves) noexcept;

/// Positions and normals, out: x, y, z, nx, ny, nz of columns · perPatch vertices without gaps. `spread` is
/// the row of the span's end less that of its beginning, `row`.
void innerRingLanes(const float* row, const float* spread, const float* curves, float u,
                    const SideTables& tables, RingSize size, const std::array<float*, 6>& out) noexcept;
void sectionRingLanes(const float* row, const float* slope, const float* point, const float* chord,
                      const SideTables& tables, RingSize size, const std::array<float*, 6>& out) noexcept;

/// ∂p/∂s at a section: (spread + c′ + v (c⁺′ − c′))/length
void slopeLanes(const float* spread, const float* curves, float perLength, const SideTables& tables,
                RingSize size, float* slope) noexcept;
void subtractLanes(const float* a, const float* b, float* difference, int count) noexcept;
void addLanes(const float* a, float* sum, int count) noexcept; ///< sum += a

} // namespace chiron::simulation

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace chiron::simulation {

/// The inner loops of UrethraPatchKernel over plain arrays of float, in vector code. They are compiled once
/// for every x86-64 processor and once more for those with AVX2; the version is chosen when the program
/// starts, and both give the same bits.
///
/// A ring is divided into blocks of kLaneWidth vertices, patch after patch; the last block of a patch is
/// padded. Row arrays hold 6 lanes per block, β(v) in x, y, z and dβ/dv in x, y, z; slope arrays hold 3 lanes
/// per block. Column arrays hold 4 numbers (x, y, z and one unused) for each curve along the canal, and
/// repeat the first curve's numbers at the end.
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

/// Numbers for each vertex of a patch's side, in whole blocks: its parameter v, 1 for the first vertex
/// (otherwise 0), and the weights of hOut, hIn and chord in β(v) and dβ/dv.
struct SideTables {
    const float *v, *first;
    const float *out, *in, *chord, *outTurn, *inTurn, *chordTurn;
};

/// Computes the lanes of one component (0 x, 1 y, 2 z) of a section's row from its points and handles.
void bulgeLanes(const double* point, const double* handleOut, const double* handleIn,
                const SideTables& tables, RingSize size, int component, float* row) noexcept;

/// The points of one span, the chords to the next points, and the control points of the curves relative to
/// the points.
struct SpanColumns {
    const float *point, *chord, *q1, *q2, *q3;
};
/// Computes the curves at one u, as 5 × 4 numbers each: c(u), c⁺(u) − c(u), the difference between the mean
/// of such steps on both sides and this step, c′(u), c⁺′(u) − c′(u).
inline constexpr int kCurveFours = 5;
void curveColumns(const SpanColumns& in, const std::array<float, 3>& weights,
                  const std::array<float, 3>& slopeWeights, int columns, float* curves) noexcept;

/// Computes positions and normals: `out` receives x, y, z, nx, ny, nz of columns · perPatch vertices without
/// gaps. `spread` is the row at the span's end minus `row`, the row at its beginning.
void innerRingLanes(const float* row, const float* spread, const float* curves, float u,
                    const SideTables& tables, RingSize size, const std::array<float*, 6>& out) noexcept;
void sectionRingLanes(const float* row, const float* slope, const float* point, const float* chord,
                      const SideTables& tables, RingSize size, const std::array<float*, 6>& out) noexcept;

/// Computes ∂p/∂s at a section: (spread + c′ + v (c⁺′ − c′))/length.
void slopeLanes(const float* spread, const float* curves, float perLength, const SideTables& tables,
                RingSize size, float* slope) noexcept;
void subtractLanes(const float* a, const float* b, float* difference, int count) noexcept;
void addLanes(const float* a, float* sum, int count) noexcept; ///< sum += a

} // namespace chiron::simulation

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "recording/trial_sink.h"

#include <span>
#include <string>

namespace chiron::recording {

/// BLAKE2b-256 over the little-endian sequence, firstTick, frames, then forceHash and payload of a chunk:
/// guards against accidents (data.md, Proof). `payloadDigest` itself is not read.
Digest payloadDigestOf(const Chunk& chunk);

/// BLAKE2b-256 over the unrounded doubles of tissue and commanded of every used tool, frame after frame: what
/// a replay of the same ticks must reproduce. Equal hashes <=> equal bits. Hashed form of a tool: u16 mask,
/// bit i (0..5) set where tissue[i] is not +0.0, bit 6 + i where commanded[i] has other bits than tissue[i];
/// then those doubles (bits, little-endian) in that order. One to one, and a quarter of the bytes where force
/// is passed on unchanged. After a frame's tools its recorded quantities (TickHeader::quantities), where any is not +0.0:
/// u16 1 << 15, u32 mask, those doubles. Scores come from them too, and a squeeze, say, is in no wrench.
Digest forceHashOf(std::span<const core::HapticFrame> frames);

/// Lower-case hexadecimal, for messages.
std::string toHex(const Digest& digest);

} // namespace chiron::recording
